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
    for stated in ["soft edge, ends at 43.62 degrees", "inverse-square", "distances 1 to 7", "derived"] {
        assert!(text.contains(stated), "{text}");
    }
}

/// In `fx16` a point near the light takes two evaluations, in `fx32` one.
#[test]
fn pick_for_the_worst_case_takes_another_evaluation() {
    let light = ["--steps", "3", "--edge", "hard", "--field", "20", "--json"];
    let [mean, worst] = [&light[..], &[&light[..], &["--worst"]].concat()].map(json);
    assert_ne!(mean["evaluation"], worst["evaluation"]);
    assert!(worst["worst"].as_f64() < mean["worst"].as_f64(), "{mean} {worst}");
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
    let told = String::from_utf8(pick(&["--from", "bevy"]).stderr).unwrap();
    assert!(told.contains("or a larger illuminance as full scale: the nearest surface has 79"), "{told}");
    assert!(pick(&["--from", "bevy", "--full-scale", "5000"]).status.success());
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
    use luminaire_exchange::System::{self, Eulumdat, Gdtf, Ies, Luminaire, Ofl};
    for &system in System::ALL.iter().filter(|own| ![Ies, Eulumdat, Gdtf, Ofl, Luminaire].contains(own)) {
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
