//! Lights of files and of other tools, through every command.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use luminaire::display::encode_srgb;
use luminaire::{Angle, Cone};

fn luminaire(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_luminaire"));
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("../exchange/tests");
    command.current_dir(tests).args(arguments).output().expect("the program runs")
}

fn text(arguments: &str) -> String {
    let output = luminaire(&arguments.split(' ').collect::<Vec<_>>());
    assert!(output.status.success(), "{arguments}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

fn temporary(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}-{name}", std::process::id()))
}

/// A light of a file as C in one command, with the bits of the light that `import` writes as JSON.
#[test]
fn file_becomes_source_and_json_becomes_the_same() {
    let document = temporary("spot.json");
    let path = document.to_str().expect("a path");
    std::fs::write(&document, text("import files/spot.ies --json")).expect("a file");
    for language in ["c-fx16", "c-f32", "glsl", "wgsl", "rust-f32"] {
        let direct = text(&format!("export --from files/spot.ies --to {language} --name key"));
        assert_eq!(direct, text(&format!("export --from {path} --to {language} --name key")), "{language}");
        assert!(direct.contains("key"), "{language}");
    }
    std::fs::remove_file(document).expect("removed");
}

/// The soft end of two angles has them beside a flux, a peak or an illuminance, by every command.
#[test]
fn falloff_beside_flux_or_peak_is_that_of_the_angles_alone() {
    let cone = |words: &str| -> serde_json::Value {
        let text = text(&format!("export --to json --beam 15 --field 26{words}"));
        serde_json::from_str::<serde_json::Value>(&text).expect("JSON")["lights"][0]["cone"].take()
    };
    let [soft, fitted] = [" --falloff soft", ""].map(cone);
    assert_ne!(soft, fitted);
    for words in [" --lumens 8700", " --candela 60000", " --lux 600 --throw 10"] {
        assert_eq!(cone(&format!(" --falloff soft{words}")), soft, "{words}");
        assert_eq!(cone(words), fitted, "{words}");
    }
    let told = text("import --beam 15 --falloff linear --lumens 8700");
    assert!(told.contains("linear") && told.contains("exact\n"), "{told}");
    let request = "pick --chip cortex-m0 --display rgb565 --steps 99 --beam 15 --falloff linear";
    for words in ["", " --lumens 8700"] {
        assert!(text(&format!("{request}{words}")).contains("linear edge"), "{words}");
    }
}

#[test]
fn tools_ies_and_pick_take_the_same_light() {
    for (tool, told) in [
        ("blender", "spot_size="),
        ("three", "penumbra="),
        ("godot", "spot_angle_attenuation="),
        ("unreal", "OuterConeAngle="),
        ("unity", "innerSpotAngle="),
        ("bevy", "outer_angle="),
        ("gltf", "outerConeAngle="),
        ("usd", "shaping:cone:softness="),
        ("opengl", "spot_exponent="),
        ("direct3d", "phi="),
        ("ies", "IESNA:LM-63-2002"),
    ] {
        let written = text(&format!("export --beam 15 --field 26 --lumens 8700 --to {tool}"));
        assert!(written.contains(told) && (tool == "ies" || written.contains("of 255 codes")), "{written}");
    }
    let answer =
        text("pick --chip cortex-m0 --display rgb565 --from three angle=0.6 penumbra=0.5 intensity=16");
    assert!(answer.contains("evaluation"), "{answer}");
    let one = text("export --from files/lights.tscn --light Spot --position -1,2,3 --to json");
    assert!(one.contains("\"position\": [-1.0, 2.0, 3.0]"), "{one}");
    let two = text("export --from files/fixture.json --to c-fx16");
    assert!(two.contains("one_lens_irradiance") && two.contains("one_lens_bright_irradiance"), "{two}");
}

/// A scene with its profiles is written, and read from where it lies; without them it says what is left out. Nothing else
/// is written over.
#[test]
fn scenes_have_their_profiles_beside_them() {
    let folder = temporary("scenes");
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = |name: &str| folder.join(name).to_str().expect("a path").to_owned();
    let two = "export files/spot.ies files/three.gltf --light 1 --to";
    for (tool, name, named, left_out) in [
        (
            "usd",
            "stage.usda",
            "@./stage-spot_12.ies@",
            "note: its IES profile is left out: file = ./stage-spot",
        ),
        (
            "gltf",
            "stage.gltf",
            "\"uri\": \"stage-spot_12.ies\"",
            "note: its IES profile is left out: file = stage-spot",
        ),
    ] {
        let (scene, profile) = (path(name), path("stage-spot_12.ies"));
        // Again over its own files.
        for _ in 0..2 {
            assert_eq!(text(&format!("{two} {tool} --output {scene}")), "");
        }
        let written = std::fs::read_to_string(&scene).expect("a scene");
        assert!(written.contains(named) && written.contains("within"), "{written}");
        let read = text(&format!("import {scene}"));
        for told in
            ["Spot 12: spot, intensity 2000", "measured: 2000 cd at 0 degrees", "spot: spot, intensity "]
        {
            assert!(read.contains(told), "{read}: expected {told}");
        }
        assert!(!read.contains("left out: file"), "{read}");
        std::fs::write(&profile, "of another").expect("a file");
        let refused = luminaire(&["export", "files/spot.ies", "--to", tool, "--output", &scene]);
        let told = String::from_utf8(refused.stderr).expect("a text");
        assert!(
            told.contains("expected no file, or one that luminaire wrote: give --output another name"),
            "{told}"
        );
        assert_eq!(std::fs::read_to_string(&profile).expect("a file"), "of another");
        std::fs::remove_file(&profile).expect("removed");
        let read = luminaire(&["import", &scene]).stdout;
        assert!(String::from_utf8_lossy(&read).contains(left_out), "{}", String::from_utf8_lossy(&read));
    }
    let outside = "#usda 1.0\ndef SphereLight \"a\" { asset inputs:shaping:ies:file = @../a.ies@ }";
    std::fs::write(path("a.usda"), outside).expect("a file");
    let read = text(&format!("import {}", path("a.usda")));
    assert!(
        read.contains("expected a file beside this one: it is not in the folder of this file, or below"),
        "{read}"
    );
    let uneven = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 2 1 2 0 0 0\n1 1 0\n0 90\n0 180\n1000 0 1000 500\n";
    std::fs::write(path("b.ies"), uneven).expect("a file");
    std::fs::write(path("a.usda"), outside.replace("../a", "b")).expect("a file");
    let read = text(&format!("import {}", path("a.usda")));
    assert!(read.contains("left out: symmetry") && read.contains("--round that of any"), "{read}");
    let round = luminaire(&["import", "--round", &path("a.usda")]);
    assert!(
        round.stderr.is_empty() && String::from_utf8_lossy(&round.stdout).contains("measured: 785.4 cd"),
        "{round:?}"
    );
    // Of all else, the text itself.
    let source = text("export --outer 40 --to glsl");
    assert_eq!(text(&format!("export --outer 40 --to glsl --output {}", path("a.glsl"))), "");
    assert_eq!(std::fs::read_to_string(path("a.glsl")).expect("a file"), source);
    std::fs::remove_dir_all(folder).expect("removed");
}

/// Where a tool's numbers do not hold a light, its text says how it has the intensities.
#[test]
fn tools_that_read_photometry_say_so() {
    for (tool, told) in [
        ("blender", "# note: Cycles reads the intensities themselves, from the file of `--to ies`"),
        ("three", "# note: IESLoader reads"),
        ("unreal", "# note: Unreal reads"),
        ("usd", "`--output FILE.usda` writes both"),
        ("gltf", "`--output FILE.gltf` writes both"),
    ] {
        assert!(text(&format!("export files/spot.ies --to {tool}")).contains(told), "{tool}");
        let exact = text(&format!("export --from {tool} kind=point --to {tool}"));
        assert!(!exact.contains(told), "{exact}");
    }
}

/// A bad file does not stop the others; the exit code and the JSON tell it.
#[test]
fn import_goes_on_after_a_bad_file() {
    let bad = temporary("bad.ies");
    std::fs::write(&bad, "IESNA91\nTILT=NONE\n1 -1 1 9").expect("a file");
    let path = bad.to_str().expect("a path");
    let output = luminaire(&["import", "files/three.gltf", path, "files/spot.ldt", "none.glb"]);
    let told = String::from_utf8(output.stdout).expect("a text");
    assert_eq!(output.status.code(), Some(1));
    for part in [
        "files/three.gltf (gltf): 3 lights",
        "bad.ies: refused",
        "files/spot.ldt (eulumdat): 1 light",
        "2 files with 4 lights, 2 refused",
    ] {
        assert!(told.contains(part), "{told}: expected {part}");
    }
    let output = luminaire(&["import", "--json", "files/three.gltf", path]);
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(
        (json["lights"].as_array().map(Vec::len), json["refused"].as_array().map(Vec::len)),
        (Some(3), Some(1))
    );
    std::fs::remove_file(bad).expect("removed");
    assert_eq!(luminaire(&["import", "--jso"]).status.code(), Some(2));
}

#[test]
fn errors_name_the_parameter_and_stay_short() {
    let long = "x".repeat(100_000);
    for (arguments, told) in [
        (vec!["import"], "files = none: expected a file"),
        (vec!["import", "--from", "blender", "spot_siz=1"], "key = spot_siz: expected a key of blender: "),
        (vec!["import", "--from", "direct3d", "phi=1"], "give attenuation0=1"),
        (
            vec!["import", "--from", "godot", "spot_angle=120"],
            "spot_angle = 120: expected over 0 and at most 90 degrees (half angle)",
        ),
        (
            vec!["export", "--to", "glsl", "--from", "nowhere.gltf"],
            "file = nowhere.gltf: expected a file that can be read",
        ),
        (
            vec!["export", "--to", "glsl", "--from", "files/three.gltf", "--light", "rim"],
            "light = rim: expected a number from 1 to 3, or one of spot, point, sun",
        ),
        (
            vec!["pick", "--chip", "cortex-m0", "--display", "rgb565", "--from", "direct3d", "phi=1"],
            "attenuation0, attenuation1, attenuation2 = 0, 0, 0: expected one that is not 0",
        ),
        (vec!["import", "--fixture", "nothing like it"], "fixture = nothing like it"),
        (
            vec!["still", "--output", "x.png", "--from", "files/three.gltf", "--light", "sun"],
            "light = directional: expected a spotlight or a point light: a wall in the sun is one colour",
        ),
        (vec!["import", "--from", "blender", &long], "a file that can be read"),
        (vec!["import", "--from", "three", "angle=30"], "30 degrees are 0.523599 radians"),
        (vec!["import", "--lumens", "-5", "--beam", "9"], "lumens = -5: expected a number from 0"),
        (vec!["import", "files/spot.ies", "--fit", "600"], "fit = 600: expected a number from 0 to 255"),
        (vec!["export", "--to", "json", "--beam", "9", "--field", "8"], "the beam angle (50 %) is below"),
        (
            vec!["export", "--to", "godot", "--throw", "4", "--from", "gltf", "range=2"],
            "throw = 4: expected a distance below",
        ),
        (vec!["export", "--to", "json", "--lumens", "9", "--outer", "8"], "cannot be used with"),
        (
            vec!["export", "--to", "usd", "--outer", "8", "--output", "a.usd"],
            "output = a.usd: expected a name that ends with .usda, printable and without @@@",
        ),
        (vec!["export", "--to", "glsl", "--outer", "8", "--output", "."], "a file that can be written"),
        (vec!["still", "--lumens", "9", "--beam", "9", "--output", "."], "a file that can be written"),
    ] {
        let output = luminaire(&arguments);
        let found = String::from_utf8(output.stderr).expect("a text")
            + &String::from_utf8(output.stdout).expect("a text");
        assert!(!output.status.success() && found.contains(told), "{found}: expected {told}");
        assert!(found.chars().count() <= 2_000, "{} characters", found.chars().count());
    }
}

#[test]
fn planes_that_differ_are_a_table_or_taken_by_fit_or_as_round() {
    let file = temporary("uneven.ies");
    let uneven =
        "IESNA:LM-63-1995\nTILT=NONE\n1 -1 1 3 2 1 2 0 0 0\n1 1 1\n0 10 20\n0 180\n1000 500 0\n1000 700 0\n";
    std::fs::write(&file, uneven).expect("a file");
    let told = text(&format!("import {}", file.display()));
    assert!(
        told.contains(": measured, intensity 1000 cd") && told.contains("a table of 65 x 33 samples"),
        "{told}"
    );
    let sized = text(&format!("import {} --size 17", file.display()));
    assert!(sized.contains("a table of 17 x 9 samples"), "{sized}");
    let json = temporary("uneven.json");
    text(&format!("export --from {} --to json --output {}", file.display(), json.display()));
    let [own, again] = [&file, &json]
        .map(|file| text(&format!("export --from {} --to rust-fx16 --name key", file.display())));
    assert!(
        own == again && own.contains("LIGHT: CompiledMeasuredLight<'static, Fx16, InverseSquare>"),
        "{own}"
    );
    let integers = text(&format!("export --from {} --to c-fx16 --name key", file.display()));
    assert!(integers.contains("luminaire_key_Distribution = { luminaire_key_Table, 5, 1 };"), "{integers}");
    let wall = temporary("uneven.png");
    text(&format!("still --from {} --output {}", json.display(), wall.display()));
    let from = file.display().to_string();
    for (tool, told) in [
        ("blender", "`--round` takes the mean of the planes"),
        ("ies", "a spotlight"),
        ("rust-program", "rust-build takes it"),
    ] {
        let output = luminaire(&["export", "--from", &from, "--to", tool]);
        let found = String::from_utf8(output.stderr).expect("a text");
        assert!(
            !output.status.success() && found.contains("measured: expected") && found.contains(told),
            "{found}"
        );
    }
    let differs = "the horizontal plane 180 differs from the mean of the planes by 25.5 of 255 codes (10.0 % of the peak) at \
                   the vertical angle 10";
    for option in ["--fit 26", "--round"] {
        let told = text(&format!("import {} {option}", file.display()));
        assert!(told.contains(&format!("The light is taken as round: {differs}.")), "{told}");
        let off = told
            .split("differs by up to ")
            .nth(1)
            .and_then(|rest| rest.split(' ').next()?.parse::<f64>().ok());
        assert!(off.is_some_and(|codes| (25.5..52.0).contains(&codes)), "{told}");
    }
}

/// Candela stay, in what is printed and in `ies`; the strongest channel is 1.77 times as strong.
#[test]
fn a_white_of_a_temperature_has_the_candela_of_its_source() {
    let told = text("import files/spot.ldt --kelvin 3000 --full-scale 2000");
    assert!(told.contains("intensity 2000 cd, 3000 K, beam"), "{told}");
    let json = text("export --from files/spot.ldt --kelvin 3000 --full-scale 2000 --to json");
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let light = &json["lights"][0];
    let near = |found: &serde_json::Value, expected: f64| (found.as_f64().unwrap() - expected).abs() < 1e-3;
    assert!(near(&light["intensity"], 1.7698) && near(&light["color"][1], 0.4773), "{light}");
    assert_eq!(light["about"]["kelvin"], 3000.0);
    let ies = |options: &str| text(&format!("export {options}--lumens 100 --field 20 --to ies"));
    assert!(["", "--kelvin 3000 "].into_iter().all(|options| ies(options).contains("\n2148.972 2148.906 ")));
    let torch = text("import --lumens 1000 --candela 20000");
    let words = "beam 13.56, field 20.73, ends at";
    assert!(torch.contains("exact, with an assumed edge") && torch.contains(words), "{torch}");
}

/// The bytes of a PNG, and its width.
fn picture(file: &std::path::Path) -> (Vec<u8>, u32) {
    let file = std::io::BufReader::new(std::fs::File::open(file).expect("a picture"));
    let mut reader = png::Decoder::new(file).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut pixels).expect("a frame");
    (pixels, info.width)
}

/// All lights of a file shine on one wall, which shows each of their pools, and ambient light everywhere.
#[test]
fn still_shows_all_lights_of_a_file() {
    let (file, wall) = (temporary("two.json"), temporary("two.png"));
    let spot = |x: i32, color: &str| {
        let cone = r#""cone":{"outer_degrees":20}"#;
        format!(r#"{{"position":[{x},4,0],"intensity":16,"color":{color},{cone}}}"#)
    };
    let sky = r#"{"kind":"ambient","color":[0,1,0],"intensity":0.25}"#;
    let sun = r#"{"kind":"directional","axis":[0,-1,0],"color":[0,0,1],"intensity":0.5}"#;
    let lights = [spot(1, "[1,0,0]"), spot(-1, "[0,0,1]"), sky.to_owned(), sun.to_owned()].join(",");
    let document = format!(r#"{{"format":"luminaire-lights-1","lights":[{lights}]}}"#);
    std::fs::write(&file, document).expect("a file");
    text(&format!("still {} --throw 4 --output {}", file.display(), wall.display()));
    let (pixels, width) = picture(&wall);
    // The pools are one unit from the middle, and the picture ends a quarter beyond them.
    let side = width as f32 / 2.0;
    let away = (side / (1.0 + 4.0 * 12.5_f32.to_radians().tan())) as u32;
    let middle = width / 2;
    for (x, y, light) in [
        (middle + away, middle, [1.0, 0.25, 0.5]),
        (middle - away, middle, [0.0, 0.25, 1.0]),
        (3, 3, [0.0, 0.25, 0.5]),
    ] {
        let at = 3 * (y * width + x) as usize;
        for (found, light) in pixels[at..at + 3].iter().zip(light) {
            assert!(found.abs_diff(encode_srgb(light)) <= 1, "{x}, {y}: {found}, expected {light}");
        }
    }
    for file in [file, wall] {
        std::fs::remove_file(file).expect("removed");
    }
}

#[test]
fn chart_has_both_marks_and_still_is_a_lit_wall() {
    let (chart, wall) = (temporary("chart.svg"), temporary("wall.png"));
    text(&format!("import files/spot.ies --svg {}", chart.display()));
    let svg = std::fs::read_to_string(&chart).expect("a chart");
    assert!(svg.contains("50 %") && svg.contains("10 %") && svg.matches("<polyline").count() == 2, "{svg}");
    text(&format!("still --lumens 1000 --field 20 --output {}", wall.display()));
    let (pixels, width) = picture(&wall);
    let at = |x: u32, y: u32| pixels[3 * (y * width + x) as usize];
    let middle = width / 2;
    // Full scale on the axis at the throw; half of the light at the beam angle, where the wall is farther
    // away and tilted; and none beyond the cone.
    let cone = Cone::soft(Angle::degrees(20.0)).expect("a cone");
    let [beam, outer] = [cone.beam(), cone.outer()].map(|full| full.to_radians() / 2.0);
    let half = encode_srgb(0.5 * beam.cos().powi(3));
    let column = middle as f32 * (1.0 + beam.tan() / (1.25 * outer).tan());
    let found = at(column as u32, middle);
    assert!(at(middle, middle) >= 254 && at(2, 2) == 0, "{} and {}", at(middle, middle), at(2, 2));
    assert!(found.abs_diff(half) <= 3, "{found}, expected {half}");
    for file in [chart, wall] {
        std::fs::remove_file(file).expect("removed");
    }
}
