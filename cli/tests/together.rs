//! What goes out is used together and read again, and one bad light or file does not stop the
//! others.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const KINDS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../exchange/tests/files/three.gltf");

fn luminaire(words: impl IntoIterator<Item = impl AsRef<OsStr>>) -> Output {
    Command::new(env!("CARGO_BIN_EXE_luminaire")).args(words).output().expect("the program runs")
}

fn words(text: &str) -> Vec<&str> {
    text.split(' ').collect()
}

/// The exit code, the standard output and the standard error.
fn told(words: impl IntoIterator<Item = impl AsRef<OsStr>>) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = luminaire(words);
    let [stdout, stderr] = [stdout, stderr].map(|text| String::from_utf8(text).expect("a text"));
    (status.code(), stdout, stderr)
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Writes a document with a soft light of 40 degrees for each name.
fn document(file: &Path, names: &[&str]) {
    let light = |name: &&str| format!("{{\"name\":{name:?},\"cone\":{{\"outer_degrees\":40}}}}");
    let lights: Vec<_> = names.iter().map(light).collect();
    let text = format!("{{\"format\":\"luminaire-lights-1\",\"lights\":[{}]}}", lights.join(","));
    fs::write(file, text).expect("a file");
}

/// The names in a source are those of the lights, also of a chosen one, and keywords of other
/// languages are names.
#[test]
fn lights_have_their_own_names_in_each_language() {
    let folder = folder("names");
    let file = folder.join("lights.json");
    document(&file, &["Main", "Key light", "key_light", "Static"]);
    let file = file.to_str().expect("a path");
    for (to, names) in [
        ("glsl", ["main_irradiance", "key_light_irradiance", "key_light_2_irradiance", "static_irradiance"]),
        ("c-fx16", ["MAIN_LIGHT_H", "KEY_LIGHT_LIGHT_H", "KEY_LIGHT_2_LIGHT_H", "STATIC_LIGHT_LIGHT_H"]),
        ("rust-build", ["fn main_light()", "fn key_light()", "fn key_light_2()", "fn static_light()"]),
        ("rust-f32", ["mod main_light ", "mod key_light ", "mod key_light_2 ", "mod static_light "]),
        ("json", ["\"Main\"", "\"Key light\"", "\"key_light\"", "\"Static\""]),
        ("godot", ["# name: Main\n", "# name: Key light\n", "# name: key_light\n", "# name: Static\n"]),
    ] {
        let (code, text, errors) = told(words(&format!("export {file} --to {to}")));
        assert!(code == Some(0) && names.iter().all(|name| text.contains(name)), "{to}: {text}{errors}");
    }
    let (_, text, _) = told(words(&format!("export --from {file} --light 2 --to c-f32")));
    assert!(text.contains("#ifndef KEY_LIGHT_LIGHT_H\n") && !text.contains("_SCENE_H"), "{text}");
    // The function of all lights has the name of the file, or that of the user.
    for (options, function) in
        [("", "lights_light("), (" --scene room", "room_light("), (" --light 2 --scene a", "a_light(")]
    {
        for to in ["c-fx16", "c-f32", "glsl", "glsl-uniforms", "wgsl"] {
            let (code, text, errors) = told(words(&format!("export --from {file}{options} --to {to}")));
            assert!(code == Some(0) && text.contains(function), "{to}: {text}{errors}");
        }
    }
    // The lights of a fixture are the ends of its zoom.
    let fixture = concat!(env!("CARGO_MANIFEST_DIR"), "/../exchange/tests/files/fixture.gdtf");
    let (_, text, errors) = told(words(&format!("export {fixture} --to c-f32")));
    assert!(text.matches("_irradiance(const").count() > 1 && !text.contains("_SCENE_H"), "{text}{errors}");
    let (_, text, _) = told(words(&format!("export {file} {file} --to rust-fx16")));
    assert!(text.contains("pub mod scene {") && text.contains("pub key_light_3: "), "{text}");
    for (options, error) in [
        ("--scene a_ --to glsl", "error: name = a_: expected"),
        ("--scene a --to json", "error: scene = a: expected none in json, which has each light alone\n"),
        ("--scene a --to godot", "error: scene = a: expected none in godot"),
    ] {
        let (code, _, errors) = told(words(&format!("export {file} {options}")));
        assert!(code == Some(1) && errors.starts_with(error), "{errors}");
    }
    let (_, text, _) = told(words(&format!("export --from {file} --name rim --to json")));
    assert!(text.contains("\"rim_1\"") && text.contains("\"rim_4\""), "{text}");
    fs::remove_dir_all(folder).expect("removed");
}

/// Every command takes a rig: its lights are at their places, with names of their own, and what is left out is said.
#[test]
fn a_rig_is_a_scene_of_its_fixtures() {
    let rig = concat!(env!("CARGO_MANIFEST_DIR"), "/../exchange/tests/files/rig.mvr");
    let folder = folder("rig");
    let (code, json, errors) = told(words(&format!("export {rig} --to json")));
    let scene: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let lights = scene["lights"].as_array().expect("lights");
    let names: Vec<_> = lights.iter().map(|light| light["name"].as_str().expect("a name")).collect();
    let own = ["Main", "Ring 1: Dot", "Ring 2: Dot"];
    let expected: Vec<_> =
        ["Wash", "Wash 2", "Spot"].iter().flat_map(|of| own.map(|own| format!("{of}: {own}"))).collect();
    assert_eq!((code, &names), (Some(0), &expected.iter().map(String::as_str).collect()), "{errors}");
    assert_eq!(lights[6]["position"], serde_json::json!([0.0, 4.0, 0.0]));
    assert!(
        errors.lines().count() == 3
            && errors.contains("note: fixtures left out: 1 (Guest), because the zip has no file"),
        "{errors}"
    );
    let scene = folder.join("rig.json");
    fs::write(&scene, json).expect("a file");
    let scene = scene.to_str().expect("a path");
    for to in ["c-fx16", "c-f32", "glsl", "wgsl", "rust-fx16"] {
        let [direct, again] = [rig, scene].map(|file| told(words(&format!("export {file} --to {to}"))));
        assert!(direct.0 == Some(0) && direct.1.contains("wash_2_main"), "{to}: {}", direct.2);
        // The names of the document are those of the source.
        assert_eq!(direct.1.matches("wash_2_main").count(), again.1.matches("wash_2_main").count(), "{to}");
    }
    let picture = folder.join("rig.png");
    let picture = picture.to_str().expect("a path");
    for command in [
        format!("import {rig}"),
        format!("pick --chip cortex-m0 --display rgb565 --steps 99 --from {rig}"),
        format!("still {rig} --output {picture}"),
    ] {
        let (code, text, errors) = told(words(&command));
        assert_eq!(code, Some(0), "{command}: {text}{errors}");
    }
    fs::remove_dir_all(folder).expect("removed");
}

/// What a language or a file lacks is said, with the remedy, and the rest is written.
#[test]
fn a_refused_light_or_file_does_not_stop_the_others() {
    let (code, text, errors) = told(words(&format!("export {KINDS} --to rust-program")));
    let of_sun =
        "error: sun: light = directional: expected a spotlight in rust-program; rust-build takes it\n";
    assert!(code == Some(1) && errors.ends_with(of_sun), "{errors}");
    assert!(text.contains("The light spot,") && !text.contains("The light sun,"), "{text}");
    let (code, text, errors) = told(words(&format!("export {KINDS} none.gltf --to glsl")));
    assert!(
        code == Some(1) && errors.starts_with("error: none.gltf: file = none.gltf: expected"),
        "{errors}"
    );
    assert!(text.contains("sun_irradiance"), "{text}");
    let (code, text, errors) = told(words("export --to rust-fx16 --outer 41 --inner 40.6"));
    assert!(code == Some(1) && text.is_empty(), "{text}");
    assert!(
        errors.contains("inner angle = 40.6: expected")
            && errors.ends_with("in rust-fx16; rust-fx32 takes it\n"),
        "{errors}"
    );
}

/// Without any light, every command says so and fails.
#[test]
fn no_light_is_an_error_in_every_command() {
    let folder = folder("none");
    for (name, text) in [
        ("none.json", r#"{"format":"luminaire-lights-1","lights":[]}"#),
        ("none.gltf", r#"{"asset":{"version":"2.0"}}"#),
        ("none.tscn", "[gd_scene format=3]\n"),
    ] {
        let file = folder.join(name);
        fs::write(&file, text).expect("a file");
        let file = file.to_str().expect("a path");
        for command in [
            format!("export {file} --to glsl"),
            format!("export --from {file} --to json"),
            format!("export {file} --to godot"),
            format!("export {file} --to ies"),
            format!("import {file}"),
            format!("import {file} --json"),
            format!("pick --chip cortex-m0 --display rgb565 {file}"),
            format!("pick --chip cortex-m0 --display rgb565 --scene {file}"),
            format!("still {file} --output {}", folder.join("x.png").display()),
        ] {
            let (code, text, errors) = told(words(&command));
            let is_json = command.ends_with("--json") && text.contains("\"parameter\": \"lights\"");
            assert_eq!(code, Some(1), "{command}: {text}{errors}");
            assert!(
                is_json || (text.clone() + &errors).contains("lights = none: expected at least one light"),
                "{command}: {text}{errors}"
            );
            assert!(command.starts_with("import") || text.is_empty(), "{command}: {text}");
        }
    }
    fs::remove_dir_all(folder).expect("removed");
}

/// A scene of every kind of light comes back from the text of each tool and from JSON.
#[test]
fn lights_of_every_kind_come_back_through_the_commands() {
    let folder = folder("back");
    for to in words("blender three godot unreal unity bevy gltf usd opengl direct3d json") {
        let file = folder.join(if to == "json" { "lights.json" } else { "lights.txt" });
        let (code, text, errors) = told(words(&format!("export {KINDS} --to {to}")));
        assert!(code == Some(0) && errors.is_empty(), "{to}: {errors}");
        fs::write(&file, &text).expect("a file");
        let (code, back, _) = told([OsStr::new("import"), file.as_os_str()]);
        assert_eq!(code, Some(0), "{to}: {back}\n{text}");
        for line in ["3 lights\n", "  spot: spot, ", "  point: point, ", "  sun: directional, "] {
            assert!(back.contains(line), "{to}: {back}\n{text}");
        }
    }
    fs::remove_dir_all(folder).expect("removed");
}

/// Ambient light is shown, written and chosen like another light, and refused where a target has none.
#[test]
fn ambient_light_goes_through_the_commands() {
    let folder = folder("ambient");
    let file = folder.join("lights.json");
    let sky = r#"{"name":"sky","kind":"ambient","color":[0.25,0.5,1.0],"intensity":0.123456}"#;
    let key = r#"{"name":"key","cone":{"outer_degrees":40}}"#;
    fs::write(&file, format!(r#"{{"format":"luminaire-lights-1","lights":[{sky},{key}]}}"#)).expect("a file");
    let file = file.to_str().expect("a path");
    let (code, text, errors) = told(words(&format!("import {file}")));
    assert!(code == Some(0) && text.contains("2 lights") && errors.is_empty(), "{text}{errors}");
    assert!(text.contains("  sky: ambient, intensity 0.1235\n    exact\n"), "{text}");
    for (options, lights, intensity) in
        [("", 2, 0.123456), (" --light sky", 1, 0.123456), (" --full-scale 2", 2, 0.061728)]
    {
        let (code, text, errors) = told(words(&format!("export {file}{options} --to json")));
        let json: serde_json::Value = serde_json::from_str(&text).expect(&errors);
        let all = json["lights"].as_array().expect("lights");
        let own = all.last().expect("a light");
        assert!(code == Some(0) && all.len() == lights && own["intensity"] == intensity, "{text}");
        assert_eq!(
            (&own["name"], &own["kind"], &own["color"][1]),
            (&"sky".into(), &"ambient".into(), &0.5.into())
        );
    }
    let (code, text, errors) = told(words(&format!("export {file} --to c-fx16")));
    assert!(
        code == Some(0) && text.contains("    { UINT32_C(506), UINT32_C(1011), UINT32_C(2023) }\n"),
        "{text}{errors}"
    );
    let (code, text, errors) = told(words(&format!("export {file} --to godot")));
    assert!(code == Some(1) && text.contains("# name: key\n"), "{text}");
    assert_eq!(errors, "error: sky: light = ambient: expected a spot, point or directional light in godot\n");
    fs::remove_dir_all(folder).expect("removed");
}

/// A hotspot leaves the field angle, and an option without an effect is said or refused.
#[test]
fn options_have_their_effect_or_say_that_they_have_none() {
    for (angles, member, degrees) in [
        ("--field 20 --inner 12", "field_degrees", 20.0),
        ("--beam 20 --inner 12", "beam_degrees", 20.0),
        ("--beam 16 --field 20 --inner 12", "field_degrees", 20.0),
        ("--outer 20 --inner 12", "outer_degrees", 20.0),
    ] {
        let (_, text, errors) = told(words(&format!("export --to json {angles}")));
        let json: serde_json::Value = serde_json::from_str(&text).expect(&errors);
        let cone = &json["lights"][0]["cone"];
        for (member, degrees) in [(member, degrees), ("inner_degrees", 12.0)] {
            let found = cone[member].as_f64().expect("an angle");
            assert!((found - degrees).abs() < 1e-4, "{angles}: {member} {found}");
        }
    }
    let (_, text, _) = told(words("pick --chip cortex-m0 --display rgb565 --json --field 20 --inner 12"));
    let (_, other, _) = told(words("export --to json --field 20 --inner 12"));
    let [text, other]: [serde_json::Value; 2] =
        [text, other].map(|text| serde_json::from_str(&text).expect("JSON"));
    let outer = other["lights"][0]["cone"]["outer_degrees"].as_f64().expect("an angle");
    assert!((text["outer"].as_f64().expect("an angle") - outer).abs() < 1e-4);
    for (command, code, error) in [
        ("export --to glsl --field 20 --inner 25", 1, "inner angle = 25: expected less"),
        ("export --to glsl --field 400 --inner 25", 1, "field angle = 400: expected"),
        ("import KINDS --beam 20", 2, "cannot be used with"),
        ("import KINDS --lumens 5", 2, "cannot be used with"),
        ("export KINDS --to glsl --falloff soft", 2, "cannot be used with"),
        ("pick --chip cortex-m0 --display rgb565 --scene show --from KINDS", 2, "cannot be used with"),
        (
            "export --to glsl --attenuation smooth-range --range 5 --window gltf",
            1,
            "window = gltf: expected none",
        ),
        ("export --to glsl --light 2 --throw 3 --fit 2 --full-scale 9", 0, "note: --light has no effect"),
        ("export --to glsl --throw 3", 0, "note: --throw has no effect"),
        ("import KINDS --fit 2", 0, "note: --fit has no effect"),
        ("import KINDS --round", 0, "note: --round has no effect"),
        ("import KINDS --light sun --position 1,2,3", 0, "note: --position has no effect"),
        ("import KINDS --light point --axis 1,2,3", 0, "note: --axis has no effect"),
        (
            "pick --chip cortex-m0 --display rgb565 --edge hard --beam 20 --field 31",
            0,
            "note: --edge has no effect",
        ),
        ("export --to glsl --kelvin 3000 --color 1,1,1", 2, "cannot be used with"),
        (
            "export --to glsl --kelvin 999",
            1,
            "color temperature = 999: expected a finite number from 1000 to 25000 K",
        ),
        ("pick --chip cortex-m0 --display rgb565 --kelvin 999", 1, "color temperature = 999: expected"),
        ("export --to ies --color 1,0.5,0", 0, "note: ies has intensities over the angle alone"),
    ] {
        let (found, _, errors) = told(words(&command.replace("KINDS", KINDS)));
        assert!(found == Some(code) && errors.contains(error), "{command}: {found:?}: {errors}");
    }
    let (_, text, errors) = told(words("export --to godot --color 1,0.5,0 --throw 3"));
    assert!(text.contains("# color: 1.0,0.5,0.0\n") && errors.is_empty(), "{text}{errors}");
}

/// Text of a file, and its name, have no line, no escape and no element of their own in what is written.
#[test]
fn text_of_a_file_stays_text() {
    let folder = folder("hostile\u{9b}\u{202e}");
    let [json, pbrt] = ["lights.json", "lights.pbrt"].map(|name| folder.join(name));
    let (chart, light) = (folder.join("chart.svg"), r#""cone":{"outer_degrees":40}"#);
    let name = r"a]]>b<\u001b[2J\u009b\u202e\nspot_angle=99";
    fs::write(&json, format!(r#"{{"format":"luminaire-lights-1","lights":[{{"name":"{name}",{light}}}]}}"#))
        .expect("a file");
    let parameter = "LightSource \"spot\" \"float we\u{1b}\u{9b}\u{202e}\nspot_angle=99\n\" [1]\n";
    fs::write(&pbrt, parameter).expect("a file");
    fs::write(folder.join("README.md"), "no light").expect("a file");
    let mut commands = vec![format!("import {}", folder.display())];
    for file in [&json, &pbrt] {
        let file = file.to_str().expect("a path");
        let pick = "pick --chip cortex-m0 --display rgb565 --scene";
        commands
            .extend([format!("import {file} --svg {}", chart.display()), format!("import {file} --json")]);
        commands
            .extend(words("json glsl godot blender ies").iter().map(|to| format!("export {file} --to {to}")));
        commands.extend([format!("{pick} {file}"), format!("{pick} {file} --each --json")]);
    }
    commands.push("export --to a\u{1b}\u{9b}\u{202e}b".to_owned());
    commands.push("export --to glsl --falloff a\u{1b}\u{9b}\u{202e}b".to_owned());
    commands.push("import --from a\u{1b}\u{9b}\u{202e}b".to_owned());
    let mut charts = 0;
    for command in commands {
        let (_, text, errors) = told(words(&command));
        let svg = fs::read_to_string(&chart).unwrap_or_default();
        if !svg.is_empty() {
            fs::remove_file(&chart).expect("removed");
            charts += 1;
        }
        assert!(!svg.contains("]]>") && !svg.contains("b<"), "{svg}");
        for text in [text, errors, svg] {
            let steers = |c: char| c.is_control() && c != '\n' && c != '\r' || c == '\u{202e}';
            assert!(!text.contains(steers), "{command}: {text:?}");
            assert!(!text.lines().any(|line| line.starts_with("spot_angle=99")), "{command}: {text}");
        }
    }
    assert!(charts > 0, "no chart was drawn");
    fs::remove_dir_all(folder).expect("removed");
}

/// A folder is its files, a name that is no text is a name, and what is too large is not read.
#[cfg(unix)]
#[test]
fn files_of_every_name_and_size_are_told_apart() {
    use std::os::unix::ffi::OsStringExt;
    let folder = folder("files");
    document(&folder.join("b.json"), &["b"]);
    document(&folder.join("a.json"), &["a"]);
    fs::write(folder.join("light.txt"), "# system: godot\n# name: c\nspot_angle=30\n").expect("a file");
    fs::write(folder.join("README.md"), "no light").expect("a file");
    let odd = folder.join(OsString::from_vec(b"d\xff.json".to_vec()));
    document(&odd, &["d"]);
    let (code, text, errors) = told([OsStr::new("import"), folder.as_os_str()]);
    assert_eq!(code, Some(0), "{text}{errors}");
    let found: Vec<_> = text
        .lines()
        .filter_map(|line| line.strip_prefix("  ")?.split_once(": spot,"))
        .map(|line| line.0)
        .collect();
    assert_eq!(found, ["a", "b", "d", "c"], "{text}");
    assert!(text.contains("d\\xFF.json (luminaire): 1 light\n"), "{text}");
    assert!(
        errors.starts_with("note: ") && errors.ends_with(": left out 1 without an extension of any system\n"),
        "{errors}"
    );
    let (code, text, _) =
        told([OsStr::new("export"), folder.as_os_str(), OsStr::new("--to"), OsStr::new("glsl")]);
    assert!(
        code == Some(0) && "abcd".chars().all(|name| text.contains(&format!("{name}_irradiance"))),
        "{text}"
    );

    let large = folder.join("large.ies");
    fs::File::create(&large).and_then(|file| file.set_len(10 << 30)).expect("a sparse file");
    let (code, text, _) = told([OsStr::new("import"), large.as_os_str(), odd.as_os_str()]);
    assert!(
        code == Some(1) && text.contains("size = 10737418240: expected at most 67108864 bytes"),
        "{text}"
    );
    assert!(text.contains("d: spot"), "{text}");
    if Path::new("/dev/zero").exists() {
        let (code, text, _) = told(["import", "/dev/zero"]);
        assert!(code == Some(1) && text.contains("size = more than 67108864: expected at most"), "{text}");
    }
    fs::remove_dir_all(folder).expect("removed");
}
