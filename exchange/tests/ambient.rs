//! Ambient light of the tools whose files have it: the light that a white surface shows.

use luminaire_exchange::{Reading, Refusal, System, Use, numbers, read};
use luminaire_export::json::{self, NamedAmbient};

fn lights(name: &str, text: &str) -> Result<Vec<NamedAmbient>, Refusal> {
    read(name, text.as_bytes(), None, Reading::default()).map(|lamps| lamps.ambient)
}

/// The linear light of a byte in sRGB.
fn linear(byte: u8) -> f32 {
    let part = f32::from(byte) / 255.0;
    if part <= 0.040_45 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
}

fn assert_lit(found: &[NamedAmbient], name: &str, expected: [f32; 3]) {
    let [own] = found else { panic!("{found:?}: expected the light {name}") };
    let lit = <[f32; 3]>::from(own.light.color()).map(|channel| channel * own.light.intensity());
    let is_near = lit.iter().zip(expected).all(|(own, other)| (own - other).abs() <= 1e-5 * other.abs());
    assert!(own.name == name && is_near, "{own:?}: {lit:?}, expected {name} and {expected:?}");
}

#[test]
fn ambient_light_of_scenes_is_read_with_its_strength() {
    const GODOT: &str = "[gd_scene format=3]\n[sub_resource type=\"Environment\" id=\"E\"]\nbackground_mode = 1\n\
        background_color = Color(1, 0.2, 0, 1)\nbackground_energy_multiplier = 0.5\nMORE\n\
        [node name=\"World\" type=\"WorldEnvironment\"]\nenvironment = SubResource(\"E\")\n\
        [node name=\"Lamp\" type=\"OmniLight3D\" parent=\".\"]\n";
    const UNITY: &str = "--- !u!104 &2\nRenderSettings:\n  m_AmbientSkyColor: {r: 0.5, g: 2, b: 0, a: 1}\n  \
        m_AmbientIntensity: 7\n  m_AmbientMode: 3\n--- !u!4 &4\nTransform:\n  m_GameObject: {fileID: 5}\n  \
        m_LocalPosition: {x: 0, y: 0, z: 0}\n  m_Father: {fileID: 0}\n";
    let half = ((0.5_f32 + 0.055) / 1.055).powf(2.4);
    let two = ((2.0_f32 + 0.055) / 1.055).powf(2.4);
    let own =
        "ambient_light_source = 2\nambient_light_color = Color(0.5, 0, 0, 1)\nambient_light_energy = 3.0";
    let pi = std::f32::consts::PI;
    for (file, text, name, expected) in [
        (
            "a.json",
            r#"{"metadata":{"type":"Object"},"object":{"name":"sky","type":"AmbientLight","color":16711680,"intensity":3}}"#
                .to_owned(),
            "sky",
            [3.0, 0.0, 0.0],
        ),
        ("a.tscn", GODOT.replace("MORE", ""), "World", [0.5, 0.5 * linear(51), 0.0]),
        ("a.tscn", GODOT.replace("MORE", own), "World", [3.0 * half, 0.0, 0.0]),
        ("a.unity", UNITY.to_owned(), "ambient", [half, two, 0.0]),
        (
            "a.usda",
            "#usda 1.0\ndef DomeLight \"sky\"\n{\n    color3f inputs:color = (1, 0.5, 0)\n    \
             float inputs:intensity = 2\n    float inputs:exposure = 1\n}\n"
                .to_owned(),
            "sky",
            [4.0 * pi, 2.0 * pi, 0.0],
        ),
        (
            "a.pbrt",
            "LightSource \"infinite\" \"rgb L\" [0.5 1 0] \"float scale\" 2".to_owned(),
            "infinite",
            [pi, 2.0 * pi, 0.0],
        ),
        (
            "a.wrl",
            "#VRML V2.0 utf8\nDEF sun DirectionalLight { color 1 0.5 0 ambientIntensity 0.4 intensity 0 }\n".to_owned(),
            "sun ambient",
            [0.4, 0.2, 0.0],
        ),
    ] {
        assert_lit(&lights(file, &text).expect(file), name, expected);
    }
    // Other sources than one colour are no light of a scene, but said.
    for (file, text, told) in [
        ("a.tscn", GODOT.replace("MORE", "ambient_light_source = 3"), "ambient light of a sky,"),
        ("a.tscn", GODOT.replace("mode = 1", "mode = 2").replace("MORE", ""), "ambient light of a sky,"),
        ("a.unity", UNITY.replace("Mode: 3", "Mode: 1"), "ambient light of a sky or a gradient is left out"),
    ] {
        let told_of = match read(file, text.as_bytes(), None, Reading::default()) {
            Ok(lamps) => {
                assert!(lamps.ambient.is_empty(), "{lamps:?}");
                lamps.notes.join("\n")
            }
            Err(refusal) => refusal.to_string(),
        };
        assert!(told_of.contains(told), "{told_of}: expected {told}");
    }
    for (file, text, told) in [
        (
            "a.usda",
            "#usda 1.0\ndef DomeLight \"sky\"\n{\n    asset inputs:texture:file = @sky.exr@\n}\n",
            "expected a dome of one colour, without a texture",
        ),
        (
            "a.pbrt",
            "LightSource \"infinite\" \"string filename\" \"sky.exr\"",
            "expected light of one colour from everywhere, without an image",
        ),
    ] {
        let lamps = read(file, text.as_bytes(), None, Reading::default()).expect(file);
        assert!(lamps.ambient.is_empty() && lamps.refused[0].to_string().contains(told), "{lamps:?}");
    }
}

#[test]
fn ambient_light_is_given_by_numbers_and_in_documents() {
    let words = |system: System, text: &str| numbers(system, text.split(' '));
    let three = words(System::Three, "kind=ambient color=0.5,1,0 intensity=2").expect("a light");
    assert!(three.lamps.is_empty());
    assert_lit(&three.ambient, "light", [1.0, 2.0, 0.0]);
    for (system, told) in [
        (System::Gltf, "kind = ambient: expected spot, point or directional: ambient light of this tool"),
        (System::Three, "key = decay: expected a key of three"),
    ] {
        let refused = words(system, "kind=ambient decay=1").expect_err("a refusal").to_string();
        assert!(refused.starts_with(told), "{refused}");
    }
    let text = "# system: three\n# name: sky\n# kind: ambient\n# color: 1,0.5,0.25\nintensity=0.1\n";
    let lamps = read("a.txt", text.as_bytes(), None, Reading::default()).expect("a light");
    assert_lit(&lamps.ambient, "sky", [0.1, 0.05, 0.025]);
    // In lux, of which 10 are full scale.
    let usage = Use { throw: 4.0, full_scale: 10.0, is_photometric: true };
    assert_lit(&[usage.ambient(&lamps.ambient[0]).expect("a light")], "sky", [0.01, 0.005, 0.0025]);

    let document = r#"{"format":"luminaire-lights-1","lights":[{"kind":"ambient","name":"sky","color":[0.1,0.2,0.3],
        "intensity":0.123456789},{"kind":"point","about":{"notes":["kept"]}},{"kind":"ambient"}]}"#;
    let lamps = read("a.json", document.as_bytes(), None, Reading::default()).expect("lights");
    assert_eq!((lamps.lamps.len(), lamps.lamps[0].notes.join(" ").as_str()), (1, "kept"));
    assert_lit(&lamps.ambient[..1], "sky", [0.012_345_679, 0.024_691_358, 0.037_037_037]);
    assert_lit(&lamps.ambient[1..], "ambient", [1.0; 3]);
    let lights = json::read(document).expect("a document");
    assert_eq!(json::read(&json::write(&lights).expect("a text")).expect("a document"), lights);
    for (wrong, told) in [
        (document.replace("0.123456789", "-1"), "lights[0]: intensity = -1: expected"),
        (document.replace("[0.1,", "[1.1,"), "lights[0]: color = 1.1: expected"),
        (
            document.replace("\"ambient\"", "\"glow\""),
            "lights[0]: kind = glow: expected spot, measured, point, directional or ambient",
        ),
    ] {
        let refused = json::read(&wrong).expect_err(told).to_string();
        assert!(refused.starts_with(told), "{refused}: expected {told}");
    }
}
