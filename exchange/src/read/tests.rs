use glam::DVec3;

use super::{Found, godot, pbrt, unity, unreal, usd, x3d};
use crate::refusal::Refusal;

type Reader = fn(&str) -> Result<Found, Refusal>;
const READERS: [(&str, Reader); 7] = [
    ("tscn", godot::read),
    ("pbrt", pbrt::read),
    ("prefab", unity::read),
    ("t3d", unreal::read),
    ("usda", usd::read),
    ("x3d", x3d::read),
    ("wrl", x3d::read),
];

fn file(name: &str) -> String {
    std::fs::read_to_string(format!("{}/tests/files/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// Returns what was read: each light with its values and notes, then what was refused, then all notes.
fn shown(found: Result<Found, Refusal>) -> String {
    let found = found.unwrap_or_else(|refusal| Found { refused: vec![refusal], ..Found::default() });
    let mut lines = String::new();
    for record in found.records {
        let round = |vector: DVec3| vector.to_array().map(|x| (1e3 * x).round() / 1e3 + 0.0);
        let (position, axis) = (round(record.position), round(record.axis.normalize()));
        lines += &format!("{}: {:?} {:?} {position:?} {axis:?}\n", record.place, record.kind, record.name);
        let text = format!("{record:?}");
        let values = text.split_once("values: [").and_then(|(_, values)| values.split_once("], used:"));
        values.into_iter().for_each(|(values, _)| lines += &format!("  {values}\n"));
        record.notes.iter().for_each(|note| lines += &format!("  {note}\n"));
    }
    found.refused.iter().for_each(|refusal| lines += &format!("refused: {refusal}\n"));
    found.notes.iter().for_each(|note| lines += &format!("note: {note}\n"));
    lines
}

#[test]
fn files_are_read_as_expected() {
    for (name, read) in READERS {
        let found = shown(read(&file(&format!("lights.{name}"))));
        assert_eq!(found, file(&format!("expected.{name}.txt")), "{name}:\n{found}");
    }
}

#[test]
fn what_cannot_be_read_is_stated() {
    for row in file("refused.txt").lines() {
        let [name, text, expected] = row.split(" | ").collect::<Vec<_>>().try_into().unwrap();
        let (_, read) = READERS.into_iter().find(|(own, _)| *own == name).unwrap();
        let found = shown(read(&text.replace("\\n", "\n")));
        assert!(found.contains(expected), "{row}\nfound:\n{found}");
    }
    let double = |i| format!("DEF A{} Group {{ USE A{i} USE A{i} }} ", i + 1);
    let doubled = (0..40).fold("#X3D V3.0\nDEF A0 PointLight { } ".to_owned(), |text, i| text + &double(i));
    assert!(shown(x3d::read(&doubled)).contains("parents = of lights"));
}
