//! The command line.

use std::fs::File;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn pick(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_luminaire"));
    command.arg("pick").args(["--chip", "cortex-m0", "--display", "rgb565"]).args(arguments);
    command.output().expect("the program runs")
}

fn json(arguments: &[&str]) -> serde_json::Value {
    serde_json::from_slice(&pick(arguments).stdout).expect("JSON")
}

#[test]
fn pick_without_a_light_answers_for_the_default_and_states_it() {
    let answer = json(&["--steps", "1", "--json"]);
    assert!(answer["bound"]["value"].as_f64().unwrap() <= 1.0);
    assert!(answer["code"].as_str().unwrap().contains("pub const LIGHT"));
    let text = String::from_utf8(pick(&["--steps", "1"]).stdout).unwrap();
    for stated in ["soft edge, ends at 43.62 degrees", "inverse-square", "distances 4 to 8", "derived"] {
        assert!(text.contains(stated), "{text}");
    }
}

/// In `fx16` a point near the light takes two evaluations, in `fx32` one.
#[test]
fn pick_for_the_worst_case_takes_another_evaluation() {
    let light = ["--steps", "3", "--edge", "hard", "--field", "20", "--near", "1", "--json"];
    let [mean, worst] = [&light[..], &[&light[..], &["--worst"]].concat()].map(json);
    assert_ne!(mean["evaluation"], worst["evaluation"]);
    assert!(worst["worst"].as_f64() < mean["worst"].as_f64(), "{mean} {worst}");
}

/// The nearest surface is where a light is full scale, unless a light has none or the user says otherwise.
#[test]
fn pick_begins_where_the_light_is_full_scale() {
    for (options, near, far) in [
        ("--intensity 100", 10.0, 20.0),
        ("--intensity 1", 1.0, 7.0),
        ("--intensity 0", 1.0, 7.0),
        ("--attenuation none", 1.0, 7.0),
        ("--intensity 16 --far 3", 3.0, 3.0),
        ("--near 9", 9.0, 18.0),
        ("--from three kind=point intensity=25", 5.0, 10.0),
    ] {
        let answer =
            json(&["--json", "--steps", "1e9"].into_iter().chain(options.split(' ')).collect::<Vec<_>>());
        let light = &answer["light"];
        assert_eq!((&light["near"], &light["far"]), (&near.into(), &far.into()), "{options}: {light}");
    }
}

/// An evaluation that costs less is good enough from the distance on that is stated, and not a thousandth before it.
#[test]
fn pick_says_from_which_distance_less_is_enough() {
    let answer = json(&["--near", "1", "--far", "7", "--json"]);
    let farther = answer["farther"].as_array().expect("a list");
    assert!(farther.len() == 2 && answer["evaluation"] == "fx32", "{farther:?}");
    let mut instructions = answer["instructions"].as_f64().expect("a number");
    for own in farther {
        let [from, fewer] = ["from", "instructions"].map(|key| own[key].as_f64().expect("a number"));
        assert!(fewer < instructions);
        instructions = fewer;
        let at = |near: f64| {
            let answer = json(&["--near", &near.to_string(), "--far", "7", "--json"]);
            answer["instructions"].as_f64().expect("a number")
        };
        assert!(at(from) <= fewer && at(from - 0.003) > fewer, "{own}");
    }
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../exchange/tests/files/three.gltf");
    let told = String::from_utf8(pick(&["--from", scene, "--near", "2", "--steps", "2"]).stdout).unwrap();
    assert!(told.contains("\nsum ") && told.contains("instructions, with surfaces from "), "{told}");
}

/// A chip is named by its processor or by its part; of one that is not counted it is said what is known.
#[test]
fn pick_knows_chips_by_their_parts() {
    let told = |chip: &str| {
        let mut pick = Command::new(env!("CARGO_BIN_EXE_luminaire"));
        let output =
            pick.args(["pick", "--display", "rgb565", "--steps", "9", "--chip", chip]).output().unwrap();
        String::from_utf8([output.stdout, output.stderr].concat()).unwrap()
    };
    for (part, chip) in [
        ("rp2040", "cortex-m0"),
        ("RP2350", "cortex-m33"),
        ("STM32F411CEU6", "cortex-m4f"),
        ("esp32-c3", "rv32imc"),
        ("hazard3", "hazard3"),
    ] {
        assert!(told(part).contains(&format!("target       {chip}, rgb565")), "{part}: {}", told(part));
    }
    for (part, known) in [
        ("esp32", "the Xtensa of an ESP32, ESP32-S2 and -S3 is not counted"),
        ("esp32-s3", "rv32imc is an ESP32-C3"),
        ("atmega328p", "of an AVR the cycles of C alone are counted"),
        (
            "z80",
            "expected cortex-m0, cortex-m3, cortex-m4f, rv32imc, cortex-m7, cortex-m33, hazard3, or a part such as",
        ),
    ] {
        assert!(told(part).contains(known), "{part}: {}", told(part));
    }
}

#[test]
fn pick_options_reach_the_light() {
    let options = "--json --edge hard --beam 20 --field 31 --inner 4 --attenuation none --near 2 --far 3 --position -1,2,3";
    let answer = json(&options.split(' ').collect::<Vec<_>>());
    let light = &answer["light"];
    assert_eq!((&light["edge"], &light["attenuation"]), (&"hard".into(), &"none".into()));
    assert_eq!((&light["beam"], &light["inner"], &light["far"]), (&20.0.into(), &4.0.into(), &3.0.into()));
    assert_eq!(light["position"][0], -1.0);
}

/// Options that describe a light describe the same one to every command that takes them.
#[test]
fn pick_takes_the_light_that_export_takes() {
    for options in [
        "--beam 15 --field 40 --falloff soft",
        "--beam 15 --field 26 --attenuation none",
        "--outer 40 --falloff cubic=0.5,1.5 --inner 9 --intensity 3",
        "--field 20 --edge hard --cutoff 15 --position -1,2,3",
        "--falloff power=3 --outer 90 --attenuation decay=1,2 --range 9 --window square --kelvin 3000",
    ] {
        let run = |command: &[&str], words: &str| {
            let mut run = Command::new(env!("CARGO_BIN_EXE_luminaire"));
            let output = run.args(command).args(words.split(' ')).output().expect("the program runs");
            assert!(output.status.success(), "{words}: {}", String::from_utf8_lossy(&output.stderr));
            serde_json::from_slice::<serde_json::Value>(&output.stdout).expect("JSON")
        };
        let picked = ["pick", "--chip", "cortex-m0", "--display", "rgb565", "--json", "--steps", "1e9"];
        let picked: luminaire_pick::Light =
            serde_json::from_value(run(&picked, options)["light"].take()).unwrap();
        let exported = run(&["export", "--to", "json"], &options.replace("--edge", "--falloff")).to_string();
        let exported = luminaire_export::json::read(&exported).unwrap().lights[0].light;
        assert_eq!(picked.any().unwrap(), exported, "{options}");
    }
}

#[test]
fn a_bright_light_is_refused_with_a_larger_full_scale_as_remedy() {
    let told = String::from_utf8(pick(&["--from", "bevy", "--near", "1"]).stderr).unwrap();
    assert!(told.contains("or a larger illuminance as full scale: the nearest surface has 79"), "{told}");
    assert!(pick(&["--from", "bevy", "--near", "1", "--full-scale", "5000"]).status.success());
}

#[test]
fn pick_refusal_is_named_and_fails() {
    let output = pick(&["--outer", "400"]);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success() && told.contains("outer angle = 400: expected"), "{told}");
    assert_eq!(json(&["--outer", "400", "--json"])["refused"]["parameter"], "outer angle");
    assert!(!pick(&["--steps", "x"]).status.success());
}

#[test]
fn version_and_help_say_what_the_program_is() {
    let told = |option| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_luminaire"));
        String::from_utf8(command.arg(option).output().expect("the program runs").stdout).unwrap()
    };
    assert_eq!(told("--version"), concat!("luminaire ", env!("CARGO_PKG_VERSION"), "\n"));
    assert!(told("--help").starts_with("Spotlights from the angles of a data sheet"));
}

#[test]
fn closed_output_ends_quietly_and_a_full_one_with_a_reason() {
    let to = |output: Stdio| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_luminaire"));
        command.args(["export", "--to", "json"]).stdout(output).output().expect("the program runs")
    };
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let closed = to(writer.into());
    assert!(closed.status.success() && closed.stderr.is_empty(), "{closed:?}");
    if let Ok(full) = File::options().write(true).open("/dev/full") {
        let full = to(full.into());
        assert_eq!(full.status.code(), Some(1));
        assert!(String::from_utf8(full.stderr).unwrap().starts_with("error: output: "));
    }
}

#[test]
fn pick_scene_of_a_file_steers_no_terminal() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("scene-{}.json", std::process::id()));
    let answer = |scene: &str| {
        std::fs::write(&file, scene).unwrap();
        pick(&["--scene", file.to_str().unwrap()])
    };
    for light in [r#"{"\u001b[2J\u202e":1}"#, r#"{"name":"\u001b[2J\u202e"}"#] {
        let scene = format!(r#"{{"format":"luminaire-lights-1","lights":[{light}]}}"#);
        let told = String::from_utf8(answer(&scene).stderr).unwrap();
        assert!(told.starts_with("error: ") && !told.contains(['\u{1b}', '\u{202e}']), "{told:?}");
    }
    std::fs::remove_file(file).unwrap();
}

/// The lights of files of every kind that is read, and the light that the numbers of each tool are without a word.
#[test]
fn pick_answers_for_lights_of_files_and_for_the_default_light_of_each_tool() {
    let tests = concat!(env!("CARGO_MANIFEST_DIR"), "/../exchange/tests");
    for folder in ["files", "real"] {
        let folder = format!("{tests}/{folder}");
        let words = ["--steps", "1e9", "--each", "--json", "--scene", &folder];
        let answers = json(&words);
        let answers = answers.as_array().unwrap_or_else(|| panic!("{folder}: {answers}"));
        let import = Command::new(env!("CARGO_BIN_EXE_luminaire"))
            .args(["import", "--json", &folder])
            .output()
            .expect("the program runs");
        let lights: serde_json::Value = serde_json::from_slice(&import.stdout).expect("JSON");
        let lights = lights["lights"].as_array().expect("lights");
        // Ambient light is a constant, of which there is nothing to pick.
        let evaluated = lights.iter().filter(|light| light["kind"] != "ambient");
        assert_eq!(answers.len(), evaluated.count(), "{folder}");
        assert!(answers.len() > 20, "{folder}: {}", answers.len());
    }
    use luminaire_exchange::System::{self, Eulumdat, Gdtf, Ies, Luminaire, Mvr, Ofl};
    let files = [Ies, Eulumdat, Gdtf, Mvr, Ofl, Luminaire];
    for &system in System::ALL.iter().filter(|own| !files.contains(own)) {
        let lamps =
            luminaire_exchange::numbers(system, []).unwrap_or_else(|error| panic!("{system}: {error}"));
        let usage = lamps.usage(4.0);
        for lamp in &lamps.lamps {
            let named = lamp.named(usage).unwrap();
            let request =
                luminaire_pick::Request::new(luminaire_pick::Chip::CortexM0, luminaire_pick::Display::Rgb565);
            let light = luminaire_pick::Light::of("light", &named.light);
            let answer = request.steps(1e9).pick(&light);
            assert!(answer.is_ok(), "{system}: {answer:?}");
        }
    }
}

/// The text says what a light of a file is, how its price was counted and where its bound does not hold.
#[test]
fn pick_says_what_a_light_of_a_file_is() {
    let text = |words: &[&str]| String::from_utf8(pick(words).stdout).unwrap();
    let spot = concat!(env!("CARGO_MANIFEST_DIR"), "/../exchange/tests/files/spot.ies");
    let told = text(&["--steps", "1e9", "--fit", "0.001", "--from", spot]);
    assert!(told.contains("table edge, ends at") && told.contains("counted as a whole"), "{told}");
    let told = text(&["--steps", "1e9", "--from", "godot", "spot_angle=25", "spot_attenuation=1.4"]);
    assert!(told.contains("the sum of counted parts") && told.contains("attenuation decay to"), "{told}");
    let told = text(&["--steps", "1e9", "--from", "godot", "kind=directional"]);
    assert!(told.contains("directional light; intensity"), "{told}");
}

#[test]
fn pick_show_is_answered_light_by_light() {
    let answers = json(&["--scene", "show", "--each", "--json"]);
    assert_eq!(answers.as_array().unwrap().len(), 11);
    let output = pick(&["--scene", "no-such-file.json"]);
    assert!(String::from_utf8(output.stderr).unwrap().contains("no-such-file.json"));
}
