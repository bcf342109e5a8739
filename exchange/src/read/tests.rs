use std::fs;

use glam::DVec3;

use super::Found;
use crate::curve::Curve;
use crate::input::{self, recognised, scene};
use crate::refusal::Refusal;

const FILES: [&str; 10] = [
    "lights.tscn",
    "lights.pbrt",
    "lights.prefab",
    "lights.t3d",
    "lights.usda",
    "lights.x3d",
    "lights.wrl",
    "three.gltf",
    "three.json",
    "babylon.babylon",
];

fn file(name: &str) -> Vec<u8> {
    fs::read(format!("{}/tests/files/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn read(name: &str, bytes: &[u8]) -> Result<Found, Refusal> {
    scene(recognised(name, bytes)?, bytes)
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
        let values = text.split_once("values: [").and_then(|(_, values)| values.split_once("], asked:"));
        values.into_iter().for_each(|(values, _)| lines += &format!("  {values}\n"));
        record.notes.iter().for_each(|note| lines += &format!("  {note}\n"));
    }
    found.refused.iter().for_each(|refusal| lines += &format!("refused: {refusal}\n"));
    found.notes.iter().for_each(|note| lines += &format!("note: {note}\n"));
    lines
}

#[test]
fn files_are_read_as_expected() {
    for name in FILES {
        let found = shown(read(name, &file(name)));
        let expected = format!("expected.{}.txt", name.trim_start_matches("lights."));
        assert_eq!(found, String::from_utf8_lossy(&file(&expected)), "{name}:\n{found}");
    }
    let [binary, json] = ["three.glb", "three.gltf"].map(|name| shown(read(name, &file(name))));
    assert_eq!(binary, json);
}

/// Returns the light of a photometric file, with its measured intensities, or its refusal.
fn measured(name: &str, text: &str) -> String {
    let lamps = match input::read(name, text.as_bytes(), None, 1.0) {
        Err(refusal) => return refusal.to_string(),
        Ok(lamps) => lamps,
    };
    let points = lamps.lamps[0].measured.as_ref().map(Curve::points);
    format!("{}: {:?}\nnotes: {}", lamps.lamps[0].name, points.unwrap_or_default(), lamps.notes.join("\n"))
}

/// Each row is an extension, a text and a part of what is read, or a file, changes `from => to` with ` ; `
/// between them, and the part.
#[test]
fn what_cannot_be_read_is_stated() {
    for row in String::from_utf8_lossy(&file("refused.txt")).lines() {
        let [extension, text, expected] = row.split(" | ").collect::<Vec<_>>().try_into().unwrap();
        let text = text.replace("\\n", "\n");
        let found = if extension.contains('.') {
            let changed = |own: String, change: &str| {
                let (from, to) = change.split_once(" => ").unwrap();
                assert!(own.contains(from), "{row}");
                own.replacen(from, to, 1)
            };
            measured(extension, &text.split(" ; ").fold(String::from_utf8(file(extension)).unwrap(), changed))
        } else {
            shown(read(&format!("file.{extension}"), text.as_bytes()))
        };
        assert!(found.contains(&expected.replace("\\n", "\n")), "{row}\nfound:\n{found}");
    }
    let double = |i| format!("DEF A{} Group {{ USE A{i} USE A{i} }} ", i + 1);
    let doubled = (0..40).fold("#X3D V3.0\nDEF A0 PointLight { } ".to_owned(), |text, i| text + &double(i));
    let babylon = format!("{{\"lights\":[{}{{\"type\":0}}]}}", "{\"type\":0},".repeat(10_000));
    let chain: Vec<_> = (1..1_000).map(|child| format!("{{\"children\":[{child}]}}")).collect();
    let light = r#"{"KHR_lights_punctual":{"light":0,"lights":[{"type":"point"}]}}"#;
    let (head, chain) = (r#"{"asset":{"version":"2.0"},"extensions":"#, chain.join(","));
    let chained = format!("{head}{light},\"nodes\":[{chain},{{\"extensions\":{light}}}]}}");
    let deep = r#"{"children":["#.repeat(200);
    let deep = format!(r#"{{"metadata":{{"type":"Object"}},"object":{deep}"#);
    let depths = [("json", deep), ("gltf", "[]".repeat(250_001)), ("gltf", chained)];
    let expected =
        ["recursion limit exceeded", "objects and arrays = 250001", "nodes[999]: parents = no end"];
    for ((extension, text), expected) in depths.iter().zip(expected).chain([
        (&("wrl", doubled), "lights = more: expected at most 10000"),
        (&("babylon", babylon), "lights = more: expected at most 10000"),
    ]) {
        let found = shown(read(&format!("file.{extension}"), text.as_bytes()));
        assert!(found.contains(expected), "{expected}, found:\n{found:.2000}");
    }
}
