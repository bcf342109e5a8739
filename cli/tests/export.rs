//! `luminaire export`.

use std::process::{Command, Output};

fn export(arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_luminaire"));
    command.arg("export").args(arguments.split_whitespace()).output().expect("the program runs")
}

fn text(arguments: &str) -> String {
    let output = export(arguments);
    assert!(output.status.success(), "{arguments}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

fn refusal(arguments: &str) -> String {
    let output = export(arguments);
    assert!(!output.status.success(), "{arguments}");
    String::from_utf8(output.stderr).expect("a text")
}

#[test]
fn export_options_reach_the_light() {
    let json: serde_json::Value = serde_json::from_str(&text(
        "--to json --name key --falloff cubic=1.25,3.5 --outer 40 --inner 4 --cutoff 30 --attenuation polynomial=1,0.5,0.25 \
         --range 9 --window square --intensity 3 --position 1,-2,3 --axis 0,0,1 --color 1,0.5,0.25",
    ))
    .expect("JSON");
    let json = &json["lights"][0];
    assert_eq!(json["name"], "key");
    assert_eq!(json["cone"]["falloff"]["name"], "cubic");
    assert_eq!(json["cone"]["falloff"]["coefficients"], serde_json::json!([1.25, -3.0, 2.75]));
    assert_eq!(json["cone"]["inner_degrees"], 4.0);
    assert!(json["cone"]["cutoff_versine"].as_f64().expect("a number") < 0.035);
    let attenuation = serde_json::json!({
        "law": "polynomial", "constant": 1.0, "linear": 0.5, "quadratic": 0.25, "window": "square", "range": 9.0
    });
    assert_eq!(json["attenuation"], attenuation);
    assert_eq!(
        (&json["intensity"], &json["position"][1], &json["color"][1]),
        (&3.0.into(), &(-2.0).into(), &0.5.into())
    );
}

#[test]
fn export_writes_every_language_and_falloff() {
    for language in
        "json glsl wgsl c-f32 c-fx16 rust-build rust-program rust-f32 rust-fx32 rust-fx16".split(' ')
    {
        assert!(text(&format!("--to {language} --beam 12 --field 20")).contains("light"), "{language}");
    }
    for falloff in "soft hard linear smooth step soft-pair=0.4,5 quadratic=0.5 power=15 inverted-power=4 \
                    real-power=2.25 inverted-real-power=2.5 table=65535,40000,0"
        .split_whitespace()
    {
        let name = falloff.split('=').next().expect("a name");
        assert!(text(&format!("--to json --falloff {falloff}")).contains(&format!("\"name\": \"{name}\"")));
    }
}

#[test]
fn export_refusals_name_the_parameter() {
    for (arguments, told) in [
        ("--to pascal", "expected one of json, glsl"),
        ("--to glsl --outer 400", "error: outer angle = 400: expected more than 0 and at most 180"),
        ("--to glsl --outer 40 --field 20", "error: outer angle = 40: expected no beam or field angle"),
        (
            "--to glsl --beam 20 --field 30 --falloff hard",
            "error: falloff = given: expected soft or no falloff",
        ),
        ("--to glsl --beam 20 --field 179 --falloff soft", "error: field angle = 179: expected 20 to 127.7"),
        (
            "--to glsl --falloff soft-pair=1.5,5",
            "share of the narrow falloff = 1.5: expected a finite number from 0 to 1",
        ),
        ("--to glsl --falloff soft-pair=0.5", "soft-pair = 1 number: expected the share, the ratio"),
        ("--to glsl --falloff bowl", "expected one of soft, hard"),
        ("--to glsl --falloff quadratic", "quadratic = 0 numbers: expected the edge slope"),
        ("--to glsl --falloff table=70000,0", "sample = 70000: expected a whole number from 0 to 65535"),
        ("--to glsl --falloff table=9,-5", "sample = -5: expected"),
        ("--to glsl --falloff table=9,nan", "sample = NaN: expected"),
        ("--to glsl --falloff table=9,,0", "expected numbers after `table=`"),
        ("--to glsl --falloff power=2.7", "exponent = 2.7: expected a whole number from 1 to 1024"),
        ("--to glsl --falloff power=-3", "exponent = -3: expected"),
        ("--to glsl --falloff inverted-power=5e9", "exponent = 5000000000: expected"),
        ("--to glsl --falloff quadratic=9", "edge slope = 9: expected a finite number from 0 to 2"),
        ("--to glsl --falloff soft=1", "soft = 1 number: expected no numbers"),
        ("--to glsl --attenuation smooth-range", "error: range = none: expected a distance"),
        (
            "--to glsl --attenuation none --range 3 --window gltf",
            "error: window = gltf: expected cut or square",
        ),
        ("--to c-fx16 --outer 0.1", "error: outer angle = 0.1: expected at least"),
        ("--to glsl --name 1st", "error: name = 1st: expected lower-case letters"),
    ] {
        let found = refusal(arguments);
        assert!(found.contains(told), "{arguments}: {found}");
    }
}
