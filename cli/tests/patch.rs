//! The channels that `luminaire export --address` writes move the light as the kernel moves that of the file.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::AnyFalloff;
use luminaire::light::CompiledSpotLight;
use luminaire::number::Light16;
use luminaire::{Fx16, Length, Vec3};
use luminaire_exchange::{Lamp, Reading, read};

/// A moving head with a zoom, in a mode of 13 slots, and a second beam with a dimmer of its own.
const FIXTURE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/head.gdtf");
const LIBRARY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../export/c/src");
const ADDRESS: u16 = 101;

/// Prints the irradiance and the colour of each light at each point, for universes that it reads.
const PROGRAM: &str = r#"#include "head.h"
#include <stdio.h>
int main(void) {
    static const int32_t points[3][3] = { { 0, -131072, 0 }, { 0, 0, -131072 }, { 40000, -120000, 30000 } };
    uint8_t universe[512];
    while (fread(universe, 1, 512, stdin) == 512) {
        luminaire_spot spot;
        head_lens_patched(&spot, universe, 512);
        for (int light = 0; light < 2; ++light) {
            for (int i = 0; i < 3; ++i) {
                const int16_t normal[3] = { 0, 11585, 11585 };
                const uint32_t found = light == 0 ? head_lens_patched_irradiance(&spot, points[i], normal)
                    : head_halo_patched_irradiance(&spot, points[i], normal);
                printf("%lu\n", (unsigned long)found);
            }
            printf("%d\n%d\n%d\n", spot.color[0], spot.color[1], spot.color[2]);
            head_halo_patched(&spot, universe, 512);
        }
    }
    return 0;
}
"#;

fn luminaire(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_luminaire")).args(words).output().expect("a program")
}

fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}-patch", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn compiled(lamp: &Lamp) -> CompiledSpotLight<Fx16, AnyFalloff, AnyAttenuation> {
    let AnyLight::Spot(spot) = lamp.light else { panic!("expected a spotlight, found {:?}", lamp.light) };
    // The command has units of full scale: what the brightest light gives on its axis at 4 m.
    spot.compile().expect("a light that the command takes")
}

#[test]
fn the_source_of_a_fixture_moves_its_light() {
    let folder = folder();
    let header = folder.join("head.h");
    let header = header.to_str().expect("a path");
    let words = [
        "export",
        FIXTURE,
        "--to",
        "c-fx16",
        "--address",
        "101",
        "--full-scale",
        "1000000",
        "--output",
        header,
    ];
    let told = luminaire(&words);
    let notes = String::from_utf8_lossy(&told.stderr);
    assert!(told.status.success() && notes.contains("`ColorSub_M` at slot 10 is left out"), "{notes}");
    let main = folder.join("main.c");
    fs::write(&main, PROGRAM).expect("a file");
    let mut compile = Command::new("cc");
    compile
        .args(["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-I", LIBRARY, "-o"])
        .arg(folder.join("main"));
    let Ok(output) = compile.arg(&main).output() else {
        assert!(std::env::var_os("LUMINAIRE_TOOLS").is_none(), "cc is not installed");
        return;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    let bytes = fs::read(FIXTURE).expect("a file");
    let mut lamps = read("head.gdtf", &bytes, None, Reading::default()).expect("a fixture").lamps;
    for lamp in &mut lamps {
        lamp.light =
            lamp.light.with_intensity((lamp.light.intensity() as f64 / 1e6) as f32).expect("an intensity");
    }
    let [lens, widest, halo, wide_halo] = &lamps[..] else { panic!("expected four lights, found {lamps:?}") };
    let patch = |lamp: &Lamp| {
        let patched = lamp.patch.as_ref().expect("channels");
        patched.patch.at_address(ADDRESS).expect("slots up to 113")
    };
    let lights =
        [(patch(lens), [lens, widest].map(compiled)), (patch(halo), [halo, wide_halo].map(compiled))];
    let (mut universes, mut expected) = (Vec::new(), String::new());
    for slots in [
        [128, 0, 128, 0, 0, 255, 255, 0, 0, 0, 0, 255, 0],
        [128, 0, 213, 85, 0, 200, 0, 0, 0, 0, 0, 100, 0],
        [10, 20, 160, 40, 0, 255, 0, 255, 128, 0, 0, 7, 9],
        [0; 13],
    ] {
        let mut universe = [0; 512];
        universe[100..113].copy_from_slice(&slots);
        universes.extend(universe);
        for (patch, ends) in &lights {
            let light = patch.state(&universe).light(ends);
            for point in [[0, -131_072, 0], [0, 0, -131_072], [40_000, -120_000, 30_000]] {
                let normal = Vec3::new(0, 11_585, 11_585).map(Fx16::from_bits);
                let found: Light16 = light.irradiance(Vec3::from(point.map(Length::from_bits)), normal);
                expected += &format!("{}\n", found.to_bits());
            }
            expected += &<[Fx16; 3]>::from(light.color()).map(|c| format!("{}\n", c.to_bits())).concat();
        }
    }
    let input = folder.join("universes");
    fs::write(&input, universes).expect("a file");
    let mut program = Command::new(folder.join("main"));
    let output = program.stdin(fs::File::open(&input).expect("a file")).output().expect("a program");
    assert_eq!(String::from_utf8_lossy(&output.stdout), expected);
    assert!(expected.lines().filter(|line| *line != "0").count() > 20, "{expected}");
    fs::remove_dir_all(folder).expect("removed");
}

/// The axis is that of the fixture at rest: one that stands has another mount.
#[test]
fn a_fixture_that_stands_has_another_mount() {
    let told = luminaire(&["export", FIXTURE, "--to", "c-fx16", "--address", "1", "--axis", "0,1,0"]);
    let text = String::from_utf8_lossy(&told.stdout);
    assert!(text.contains("{ INT32_C(0), INT32_C(-1073741824), INT32_C(0) }"), "{text}");
    // No text of the file is in the source: it could end a comment.
    let notes = String::from_utf8_lossy(&told.stderr);
    assert!(!text.contains("Extended") && notes.contains("its mode Extended"), "{text}{notes}");
}

#[test]
fn addresses_are_refused_with_what_is_expected() {
    for (words, error) in [
        (
            vec![FIXTURE, "--to", "c-fx16", "--address", "505"],
            "error: Head: Lens at address 505: slot = 513: expected",
        ),
        (
            vec![FIXTURE, "--to", "c-fx16", "--address", "0"],
            "error: Head: Lens at address 0: slot = 0: expected",
        ),
        (vec![FIXTURE, "--to", "glsl", "--address", "1"], "error: address = 1: expected none in glsl"),
        (vec![FIXTURE, "--to", "json", "--address", "1"], "error: address = 1: expected none in json"),
        (
            vec!["--beam", "10", "--to", "c-fx16", "--address", "1"],
            "error: address = 1: expected a GDTF fixture",
        ),
    ] {
        let told = luminaire(&[vec!["export"], words].concat());
        let errors = String::from_utf8_lossy(&told.stderr);
        assert!(!told.status.success() && told.stdout.is_empty() && errors.contains(error), "{errors}");
    }
}
