use glam::DVec3;

use super::{Found, godot, pbrt, unity, unreal, usd, x3d};
use crate::refusal::Refusal;

type Reader = fn(&str) -> Result<Found, Refusal>;

macro_rules! files {
    ($($read:path = $file:literal,)*) => {
        [$(($read, include_str!(concat!("../../tests/files/lights.", $file)),
            include_str!(concat!("../../tests/files/expected.", $file, ".txt")))),*]
    };
}
/// Readers, files, and what is read of them.
const FILES: [(Reader, &str, &str); 7] = files!(
    godot::read = "tscn",
    pbrt::read = "pbrt",
    unity::read = "prefab",
    unreal::read = "t3d",
    usd::read = "usda",
    x3d::read = "x3d",
    x3d::read = "wrl",
);

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
    for (read, text, expected) in FILES {
        let found = shown(read(text));
        assert!(found == expected, "found:\n{found}\nexpected:\n{expected}");
    }
}

#[test]
fn what_cannot_be_read_is_stated() {
    let sun = "DirectionalLight { }";
    let double = |i| format!("DEF A{} Group {{ USE A{i} USE A{i} }} ", i + 1);
    let doubled = format!("#X3D V3.0 utf8\nDEF A0 {sun} {}", (0..40).map(double).collect::<String>());
    let cycle = "--- !u!4 &1\n  m_GameObject: {fileID: 2}\n  m_Father: {fileID: 1}\n  m_LocalPosition: {x: 0, y: 0, z: 0}\n\
        --- !u!1 &2\n  m_Name: a\n--- !u!108 &3\n  m_GameObject: {fileID: 2}\n  m_Type: 2\n";
    let light = "def SphereLight \"a\" { float inputs:intensity";
    for (read, text, expected) in [
        (
            godot::read as Reader,
            "[node name=\"a\" type=\"OmniLight3D\"]\nrotation = Vector3(0, 1, 0)",
            "rotation",
        ),
        (godot::read, "[node name=\"a\" type=\"OmniLight3D\"]\ntransform = Transform3D(1, 2)", "12 numbers"),
        (
            godot::read,
            "[node name=\"a\" instance=E(\"1\")]\n[node name=\"b\" type=\"OmniLight3D\" parent=\".\"]",
            "instance",
        ),
        (pbrt::read, "ActiveTransform EndTime LightSource \"point\"", "ActiveTransform = EndTime"),
        (pbrt::read, "Transform [ 1 2 3 ]\nLightSource \"point\"", "line 2: Transform"),
        (pbrt::read, "LightSource \"point\" WorldEnd", "(\"version\", Numbers([3.0]))"),
        (pbrt::read, "AttributeEnd", "line 1: brackets"),
        (unity::read, "binary", "Force Text"),
        (unity::read, cycle, "or in a cycle"),
        (x3d::read, &doubled, "parents = of lights"),
        (unreal::read, "text", "Begin Object"),
        (unreal::read, "Begin Object Class=PointLightComponent\nBrightness=2", "Unreal Engine 4 or 5"),
        (usd::read, "PXR-USDC", "usdcat -o file.usda"),
        (usd::read, &format!("#usda 1.0\n{light} = 5"), "line 2: brackets"),
        (usd::read, &format!("#usda 1.0\n{light}.timeSamples = {{ 1: 2 }} }}"), "line 2: intensity"),
        (
            usd::read,
            "#usda 1.0\ndef SphereLight \"a\" { token[] xformOpOrder = [\"xformOp:bend\"] }",
            "xformOp:bend",
        ),
        (
            usd::read,
            "#usda 1.0\ndef \"a\" ( references = @b@ ) { def SphereLight \"c\" { } }",
            "in a reference",
        ),
        (x3d::read, "#VRML V1.0 ascii", "V2.0"),
        (x3d::read, "#X3D V3.0 utf8\nGroup {", "line 2: brackets"),
        (x3d::read, "<html/>", "the element X3D"),
        (x3d::read, "<X3D>\n<Scene>", "never closed"),
        (x3d::read, "<!DOCTYPE X3D [<!ENTITY a 'b'>]><X3D/>", "no entities"),
        (x3d::read, &format!("#X3D V3.0 utf8\nBillboard {{ children {sun} }}"), "line 2: parent = Billboard"),
        (x3d::read, &format!("#X3D V3.0 utf8\nDEF A Group {{ USE A {sun} }} {sun}"), "`USE` adds"),
        (x3d::read, &format!("#X3D V3.0 utf8\nPROTO A [ ] {{ {sun} }} A {{ }}"), "`PROTO` adds"),
    ] {
        let found = shown(read(text));
        assert!(found.contains(expected), "{text}:\nfound:\n{found}\nexpected: {expected}");
    }
}

#[test]
fn broken_files_never_panic() {
    for (read, text, _) in FILES {
        (0..text.len()).filter_map(|end| text.get(..end)).for_each(|text| drop(read(text)));
        (0..text.len()).filter_map(|start| text.get(start..)).for_each(|text| drop(read(text)));
        drop(read(&text.replace(|c: char| c.is_ascii_digit(), "9e300")));
        for part in
            ["{", "}", "[", "A {", "AttributeBegin ", "Scale 1 1 1 ", "<A>", "Begin Object\n", "def \"a\" {"]
        {
            let deep = part.repeat(100_000);
            drop(read(&format!("{text}\n{deep}{text}")));
        }
    }
}
