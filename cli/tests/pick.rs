//! The command line.

use std::process::{Command, Output};

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
    for stated in ["soft edge, ends at 43.62 degrees", "inverse-square", "distances 1 to 7", "searched"] {
        assert!(text.contains(stated), "{text}");
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

#[test]
fn pick_refusal_is_named_and_fails() {
    let output = pick(&["--outer", "400"]);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success() && told.contains("outer angle = 400: expected"), "{told}");
    assert_eq!(json(&["--outer", "400", "--json"])["refused"]["parameter"], "outer angle");
    assert!(!pick(&["--steps", "x"]).status.success());
}

#[test]
fn pick_show_is_answered_light_by_light() {
    let answers = json(&["--scene", "show", "--each", "--json"]);
    assert_eq!(answers.as_array().unwrap().len(), 11);
    let output = pick(&["--scene", "no-such-file.json"]);
    assert!(String::from_utf8(output.stderr).unwrap().contains("no-such-file.json"));
}
