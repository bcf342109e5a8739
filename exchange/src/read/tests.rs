use std::fs;

use glam::DVec3;

use super::Found;
use crate::curve::Curve;
use crate::input::{self, recognised};
use crate::reading::Reading;
use crate::refusal::Refusal;

const FILES: [&str; 11] = [
    "lights.tscn",
    "lights.pbrt",
    "lights.prefab",
    "lights.t3d",
    "lights.usda",
    "lights.x3d",
    "lights.wrl",
    "three.gltf",
    "three.json",
    "app.json",
    "babylon.babylon",
];

fn file(name: &str) -> Vec<u8> {
    fs::read(format!("{}/tests/files/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn read(name: &str, bytes: &[u8]) -> Result<Found, Refusal> {
    let tool = recognised(name, bytes)?.tool().expect("a tool");
    tool.scene().expect("a tool with scenes")(bytes)
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
        let profile = record.profile.iter();
        profile.for_each(|own| lines += &format!("  profile {:?}, {}\n", own.file, own.is_normalized));
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
    let lamps = match input::read(name, text.as_bytes(), None, Reading::default()) {
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
        let text = text.replace("\\n", "\n").replace("\\0", "\0");
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

/// The lights of a text, or why not, without the lines.
fn lights(extension: &str, text: &str) -> String {
    let found = shown(read(&format!("file.{extension}"), text.as_bytes()));
    let own = |line: &str| match line.strip_prefix("line ").and_then(|rest| rest.split_once(": ")) {
        Some((_, rest)) => format!("{rest}\n"),
        None => format!("{line}\n"),
    };
    found.lines().map(own).collect()
}

/// What is in a text, an asset path or a value of several lines has no structure: the file is read as with an
/// empty text.
#[test]
fn texts_are_no_structure() {
    let usd = r#"#usda 1.0
def SphereLight "a" ( doc = {} ) { custom string note = {} float inputs:intensity = 2 }
def SphereLight "b" { float inputs:intensity = 3 ( doc = {} ) }"#;
    let godot = "[node name=\"a\" type=\"OmniLight3D\"]\neditor_description = {}\nlight_energy = 4.0\n";
    let unity = "--- !u!4 &1\n  m_GameObject: #fileID: 2$\n  m_LocalPosition: #x: 0, y: 0, z: 0$\n  m_Father: #fileID: 0$\n\
                 --- !u!1 &2\n  m_Name: a\n--- !u!108 &3\n  m_GameObject: #fileID: 2$\n  m_Type: 2\n  m_Text: {}\n  m_Range: 4\n";
    let unity = unity.replace('#', "{").replace('$', "}");
    let unreal = "Begin Object Class=PointLightComponent Name=\"a\"\nIntensity=3\nText={}\nEnd Object";
    let pbrt = "Film \"rgb\" \"string filename\" {}\nLightSource \"point\" \"rgb I\" [1 2 3]\n";
    let vrml = "#VRML V2.0 utf8\nWorldInfo { info [ {} ] }\nDEF a PointLight { }\n";
    let x3d = "<X3D><Scene><PointLight DEF='a'/><Script url='{}'/><PointLight/></Scene></X3D>";
    let of_usd = [
        "'6\" lens'",
        "'}'",
        r"'\'}'",
        "'''a \" ' {\n b'''",
        r##""""it's { " #\"""""##,
        r#""\"}""#,
        "@a\"b#{.ies@",
        r"@c:\@",
        r"@@@a@b{\@@@c@@@",
        "</a{b=c}/d>",
        "\"def SphereLight\" /* { */ // {\n",
    ];
    let of_godot = [
        "\"Key\n[b]do not move[/b]\"",
        "\"\nlight_energy = 9\nspot_angle = 9\n\"",
        "\"\n[node name=\\\"x\\\" type=\\\"SpotLight3D\\\"]\n\"",
        "[\n[1, 2],\n{ \"light_energy = 2\": \"]\" }]",
        "&\"[\" ; \"[\n",
    ];
    let of_unity = [
        "\"a\n\n  m_Range: 9\"",
        "'it''s\n  m_Range: 9'",
        "\"\\\"\n  m_Type: 1\n\"",
        "{a: 1,\n    m_Type: 1}",
        "\n    m_Type: 1",
    ];
    for (extension, file, texts) in [
        ("usda", usd, &of_usd[..]),
        ("tscn", godot, &of_godot),
        ("prefab", &unity, &of_unity),
        ("t3d", unreal, &["\"\nEnd Object\n\"", "INVTEXT(\"\nIntensity=9\\\"\n\")"]),
        ("pbrt", pbrt, &["\"[ AttributeBegin\"", "\"\\\" # [\" # [ \"\n"]),
        ("wrl", vrml, &["\"SpotLight { } } \\\" { 5 #\"", "\"]\n\""]),
        ("x3d", x3d, &["\"SpotLight { } }", "\\", "ROUTE"]),
    ] {
        let with = |text: &str| lights(extension, &file.replace("{}", text));
        let plain = with(if extension == "x3d" { "" } else { "\"\"" });
        assert!(plain.contains("Point \"") && !plain.contains("refused"), "{plain}");
        for text in texts {
            assert_eq!(with(text), plain, "{extension}: {text}");
        }
    }
}

#[test]
fn names_are_without_the_marks_of_their_language() {
    let route = "<ROUTE fromNode='a' fromField='b' toNode='c' toField='d'/>";
    let world = format!("<X3D><Scene>{route}<PointLight DEF='C:\\'/><PointLight/>{route}</Scene></X3D>");
    let unity = |name: &str| {
        let place =
            "m_GameObject: {fileID: 2}\n  m_LocalPosition: {x: 0, y: 0, z: 0}\n  m_Father: {fileID: 0}";
        let light = "m_GameObject: {fileID: 2}\n  m_Type: 2";
        format!("--- !u!4 &1\n  {place}\n--- !u!1 &2\n  m_Name: {name}\n--- !u!108 &3\n  {light}\n")
    };
    let godot = r#"[node groups=[" type="] name="a\" type=\"b" type="OmniLight3D"]"#;
    let unreal = "Begin Object Class=/Script/Engine.PointLightComponent Name=\"a Class=b\"\nEnd Object";
    for (extension, file, name) in [
        ("x3d", world, r"C:\"),
        ("wrl", "#X3D V3.0\nROUTE a.b TO c.d DEF f PointLight { }".to_owned(), "f"),
        ("tscn", godot.to_owned(), "a\" type=\"b"),
        ("t3d", unreal.to_owned(), "a Class=b"),
        ("prefab", unity("'it''s: a'"), "it's: a"),
        ("prefab", unity(r#""a\u00e9 \"b\"""#), "aé \"b\""),
        ("prefab", unity(r"C:\new"), r"C:\new"),
    ] {
        let found = lights(extension, &file);
        assert!(found.contains(&format!("Point {name:?}")), "expected {name}, found {found}");
    }
}

/// A member of the outermost object, or the first line, says what a file is; a word somewhere does not.
#[test]
fn formats_are_known_by_their_structure() {
    use crate::System;
    for (name, text, system) in [
        (
            "a.json",
            r#"{"asset":{"generator":"luminaire-lights-1 \"object\""},"extras":{"metadata":1}}"#,
            System::Gltf,
        ),
        ("a.json", r#"{"name":"asset","modes":[{"asset":1,"format":2}]}"#, System::Ofl),
        ("a.json", r#"{ "a\"b" : [{"format": 1}], "metadata" :{}, "object":{"asset":{}}}"#, System::Three),
        ("a.json", r#"{"lights":[],"format":"luminaire-lights-1"}"#, System::Luminaire),
        ("a.pbrt", "# a scene\n# system: usd\n", System::Pbrt),
        ("a.pbrt", "# system: usd\r", System::Usd),
    ] {
        assert_eq!(recognised(name, text.as_bytes()), Ok(system), "{text}");
    }
}

/// CR, CRLF and LF end the lines of every format.
#[test]
fn line_ends_do_not_matter() {
    for name in FILES.into_iter().chain(["spot.ies", "spot.ldt"]) {
        let text = String::from_utf8(file(name)).unwrap().replace("\r\n", "\n");
        let found = |text: &str| match name.starts_with("spot") {
            true => measured(name, text),
            false => shown(read(name, text.as_bytes())),
        };
        for end in ["\r", "\r\n"] {
            assert_eq!(found(&text.replace('\n', end)), found(&text), "{name}");
        }
    }
    let lamps =
        input::read("a.txt", b"# system: godot\r# kind: point\rlight_energy=2\r", None, Reading::default());
    assert!(lamps.is_ok_and(|lamps| lamps.lamps[0].light.intensity() == 2.0));
}

/// A file that is cut within something that its format ends is refused.
#[test]
fn files_that_are_cut_are_refused() {
    for (extension, text) in [
        ("pbrt", "AttributeBegin LightSource \"point\""),
        ("pbrt", "LightSource \"point\" \"rgb I\" [100 100 10"),
        ("pbrt", "LightSource \"point\" \"rgb I\""),
        ("pbrt", "LightSource \"point"),
        ("pbrt", "Translate [ 1 2 3"),
        ("t3d", "Begin Object Class=PointLightComponent\nIntensity=1"),
        ("t3d", "Begin Object Class=PointLightComponent\nText=\"a\nEnd Object"),
        ("t3d", "End Object"),
        ("tscn", "[node name=\"a\" type=\"OmniLight3D\"]\ntransform = Transform3D(1, 0"),
        ("tscn", "[node name=\"a\" type=\"OmniLight3D\"]\neditor_description = \"a"),
        ("prefab", "--- !u!1 &1\n  m_Name: \"a"),
        ("usda", "#usda 1.0\ndef SphereLight \"a\" { string a = 'b\n' }"),
        ("wrl", "#X3D V3.0\nPointLight { color [ 1 1 1"),
    ] {
        let found = lights(extension, text);
        assert!(found.contains("brackets = unmatched"), "{text}\nfound: {found}");
    }
}

/// Each limit of a count, at it and one over it.
#[test]
fn counts_are_accepted_up_to_their_limits() {
    let own = r#"{"KHR_lights_punctual":{"light":0,"lights":[{"type":"point"}]}}"#;
    let chain = |count: usize| {
        let nodes: String = (1..count).map(|child| format!("{{\"children\":[{child}]}},")).collect();
        let last = format!("{{\"extensions\":{own}}}");
        format!("{{\"asset\":{{\"version\":\"2.0\"}},\"extensions\":{own},\"nodes\":[{nodes}{last}]}}")
    };
    let lens = r#"{"physical":{"lens":{"degreesMinMax":[9,9]}},"modes":["#;
    let attributes = |count: usize| (0..count).map(|i| format!(" a{i}=''")).collect::<String>();
    let x3d = |content: String| format!("<X3D>{content}<PointLight/></X3D>");
    let vrml = |content: String| format!("#VRML V2.0 utf8\n{content}");
    let scaled = |scale| vrml(format!("Transform {{ scale {scale} 1 1 children PointLight {{ }} }}"));
    let blocks = |count: usize| vrml("A{}".repeat(count - 2) + "PointLight{}");
    let babylon =
        |count: usize| format!("{{\"lights\":[{}{{\"type\":0}}]}}", "{\"type\":0},".repeat(count - 1));
    let objects = |count: usize| format!("{{\"lights\":[],\"a\":[{}{{}}]}}", "{},".repeat(count - 4));
    let modes = |count: usize| lens.to_owned() + &"{},".repeat(count - 1) + "{}]}";
    let sized = |bytes: usize| lens.to_owned() + &" ".repeat(bytes - lens.len() - 4) + "{}]}";
    for (name, at, over, expected) in [
        ("a.gltf", chain(513), chain(514), "parents = no end"),
        ("a.json", modes(1_000), modes(1_001), "at most 1000"),
        ("a.json", sized(2 << 20), sized((2 << 20) + 1), "at most 2 MiB"),
        ("a.babylon", babylon(10_000), babylon(10_001), "lights = more"),
        ("a.babylon", objects(250_000), objects(250_001), "objects and arrays ="),
        ("a.wrl", blocks(1 << 18), blocks((1 << 18) + 1), "nodes = more"),
        (
            "a.x3d",
            x3d(format!("<A{}/>", attributes(256))),
            x3d(format!("<A{}/>", attributes(257))),
            "of one tag =",
        ),
        ("a.x3d", x3d("<A/>".repeat(199_997)), x3d("<A/>".repeat(199_998)), "tags and attributes ="),
        ("a.x3d", x3d("<A xmlns='b'/>".repeat(64)), x3d("<A xmlns='b'/>".repeat(65)), "namespaces ="),
        ("a.x3d", x3d("<![CDATA[a]]>".repeat(64)), x3d("<![CDATA[a]]>".repeat(65)), "sections ="),
        ("a.x3d", x3d("a".repeat((16 << 20) - 24)), x3d("a".repeat((16 << 20) - 23)), "bytes of XML ="),
        ("a.wrl", scaled("1.00004"), scaled("1.0001"), "its nodes scale"),
    ] {
        let found = [at, over].map(|text| match name {
            "a.json" => format!("{:?}", input::read(name, text.as_bytes(), None, Reading::default()).err()),
            _ => shown(read(name, text.as_bytes())),
        });
        assert!(!found[0].contains(expected), "{name}, {expected}, found at the limit:\n{:.500}", found[0]);
        assert!(found[1].contains(expected), "{name}, {expected}, found over the limit:\n{:.500}", found[1]);
    }
}
