//! The C of the 16-bit format has the bits of the kernel.

mod support;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use fastrand::Rng;
use luminaire::attenuation::SmoothRange;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{Cubic, Falloff, Formula};
use luminaire::{Angle, Cone, Fx16, Length, SpotLight, Vec3};
use luminaire_export::{Language, export};

use support::compiler::{bytes, compile, compile_in_integers, run, write_headers};
use support::{avr, measured, points_of_light, spots, suns, vectors};

/// The words of a point and of a normal.
type Place = [i32; 6];

/// The irradiance and the falloff in words; no falloff where none is expected.
type Answer = (u32, Option<u32>);

/// The compilers of this machine, and their options. The second computes the upper halves of
/// products from parts, and ends at undefined behaviour.
const BUILDS: [(&str, &str); 3] = [
    ("cc", "-std=c99 -O2"),
    ("cc", "-std=c99 -O1 -DLUMINAIRE_BY_PARTS -fsanitize=undefined -fno-sanitize-recover=all"),
    ("c++", "-std=c++11 -Os"),
];

/// Writes a program that evaluates each light at as many places.
///
/// It reads the words of the places and writes irradiance and falloff in words.
fn program(folder: &Path, lights: &[AnyLight], places: usize) {
    let mut main = "#include <stdio.h>\n".to_owned();
    write_headers(folder);
    for (index, light) in lights.iter().enumerate() {
        let text = export(*light, &format!("light{index}"), Language::CFixed).expect("a light");
        fs::write(folder.join(format!("light{index}.h")), text).expect("a folder");
        let _ = writeln!(main, "#include \"light{index}.h\"");
    }
    main += "int main(void) {\n    int32_t w[6];\n    int16_t n[3];\n    uint32_t out[2];\n    long i;\n";
    for (index, light) in lights.iter().enumerate() {
        let falloff = match light {
            AnyLight::Spot(_) => format!("(uint32_t)light{index}_falloff(w)"),
            _ => "0".to_owned(),
        };
        let place = if matches!(light, AnyLight::Directional(_)) { "n" } else { "w, n" };
        let _ = writeln!(
            main,
            "    for (i = 0; i < {places}; ++i) {{\n        \
             if (fread(w, 4, 6, stdin) != 6) {{ return 1; }}\n        \
             n[0] = (int16_t)w[3]; n[1] = (int16_t)w[4]; n[2] = (int16_t)w[5];\n        \
             out[0] = light{index}_irradiance({place});\n        out[1] = {falloff};\n        \
             if (light{index}_color[0] < 0 || fwrite(out, 4, 2, stdout) != 2) {{ return 1; }}\n    }}"
        );
    }
    main += "    return 0;\n}\n";
    fs::write(folder.join("main.c"), main).expect("a folder");
}

/// Returns what the kernel answers, and at how many places it takes the fine evaluation.
fn by_the_kernel(light: &AnyLight, places: &[Place]) -> (Vec<Answer>, usize) {
    let words = |place: &Place| {
        let [x, y, z, nx, ny, nz] = *place;
        (Vec3::new(x, y, z).map(Length::from_bits), Vec3::new(nx, ny, nz).map(|n| Fx16::from_bits(n as i16)))
    };
    match light {
        AnyLight::Spot(spot) => {
            let light = spot.compile::<Fx16>().expect("a light");
            let at = |place| {
                let (point, normal) = words(place);
                (light.irradiance(point, normal).to_bits(), Some(light.falloff_at(point).to_bits() as u32))
            };
            let fine = places.iter().filter(|place| light.is_fine(words(place).0)).count();
            (places.iter().map(at).collect(), fine)
        }
        AnyLight::Point(point) => {
            let light = point.compile::<Fx16>().expect("a light");
            let at = |place| {
                let (point, normal) = words(place);
                (light.irradiance(point, normal).to_bits(), None)
            };
            (places.iter().map(at).collect(), 0)
        }
        AnyLight::Directional(sun) => {
            let light = sun.compile::<Fx16>();
            let at = |place| (light.irradiance(words(place).1).to_bits(), None);
            (places.iter().map(at).collect(), 0)
        }
        AnyLight::Measured(light) => {
            let light = light.compile::<Fx16>().expect("a light");
            let at = |place| {
                let (point, normal) = words(place);
                (light.irradiance(point, normal).to_bits(), None)
            };
            let fine = places.iter().filter(|place| light.is_fine(words(place).0)).count();
            (places.iter().map(at).collect(), fine)
        }
    }
}

/// Returns places in reach of a light, places next to its position and places of any bits.
fn places(rng: &mut Rng, light: &AnyLight, count: usize) -> Vec<Place> {
    const HARD: [i32; 9] = [0, 1, -1, i32::MIN, i32::MAX, 1 << 16, (1 << 17) - 1, 1 << 24, -(1 << 30)];
    let position = match light {
        AnyLight::Spot(spot) => spot.position(),
        AnyLight::Point(point) => point.position(),
        AnyLight::Directional(_) => Vec3::default(),
        AnyLight::Measured(light) => light.position(),
    };
    let position: [i32; 3] = position.map(|c| Length::from_f32(c).to_bits()).into();
    let place = |index| {
        let mut bits =
            || if rng.bool() { rng.i32(..) >> rng.u8(..32) } else { HARD[usize::from(rng.u8(..9))] };
        if index % 8 < 2 {
            let [x, y, z, nx, ny, nz] = [0; 6].map(|_| bits());
            let [a, b, c] = if index % 8 == 0 { [0; 3] } else { position };
            return [x.wrapping_add(a), y.wrapping_add(b), z.wrapping_add(c), nx, ny, nz];
        }
        let (point, normal) = support::place(rng, light);
        let [x, y, z] = point.map(|c| Length::from_f32(c).to_bits());
        let [nx, ny, nz] = normal.map(|c| i32::from(Fx16::from_f32(c).to_bits()));
        [x, y, z, nx, ny, nz]
    };
    (0..count).map(place).collect()
}

/// Compares lights with expected answers, by several compilers. Each light has as many places.
fn compare(lights: &[AnyLight], places: &[Place], expected: &[Answer], builds: &[(&str, &str)]) {
    let folder = tempfile::tempdir().expect("a folder");
    let each = places.len() / lights.len();
    program(folder.path(), lights, each);
    let words: Vec<u32> = places.iter().flatten().map(|&word| word as u32).collect();
    for (compiler, flags) in builds {
        let Some(found) = run(compiler, flags, &folder.path().join("main.c"), &words) else { continue };
        let found: Vec<_> = found.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
        assert_eq!(found.len(), expected.len());
        let differs = |(found, expected): (&(u32, u32), &Answer)| {
            found.0 != expected.0 || expected.1.is_some_and(|falloff| found.1 != falloff)
        };
        if let Some(at) = found.iter().zip(expected).position(differs) {
            let (found, expected, place, light) = (found[at], expected[at], places[at], lights[at / each]);
            panic!("{compiler} {flags}: {found:?}, expected {expected:?} at {place:?} of {light:?}");
        }
    }
}

#[test]
fn random_lights_have_the_bits_of_the_kernel() {
    let mut rng = Rng::with_seed(1999);
    let full = std::env::var_os("LUMINAIRE_FULL").is_some();
    let (variants, each) = if full { (12, 40_000) } else { (2, 5_000) };
    let mut lights: Vec<AnyLight> =
        spots::<Fx16>(&mut rng, variants).into_iter().map(AnyLight::from).collect();
    lights.extend(points_of_light::<Fx16>(&mut rng).into_iter().map(AnyLight::from));
    lights.extend(suns(&mut rng, 4 * variants).into_iter().map(AnyLight::from));
    lights.extend(measured::<Fx16>(&mut rng, 8 * variants).into_iter().map(AnyLight::from));
    let (mut input, mut expected, mut fine) = (Vec::new(), Vec::new(), 0);
    for light in &lights {
        let places = places(&mut rng, light, each);
        let (answers, finely) = by_the_kernel(light, &places);
        fine += finely;
        input.extend(places);
        expected.extend(answers);
    }
    let lit = expected.iter().filter(|answer| answer.0 > 0).count();
    println!(
        "{} lights, {} points, {lit} of them lit and {fine} evaluated finely",
        lights.len(),
        input.len()
    );
    assert!(lit > input.len() / 3 && fine > input.len() / 10);
    compare(&lights, &input, &expected, &BUILDS);
    on_avr(&lights, &input, &expected);
}

/// Compares lights at some of their places on an AVR, where an `int` has 16 bits, and tables are in flash.
fn on_avr(lights: &[AnyLight], places: &[Place], expected: &[Answer]) {
    const PLACES: usize = 40;
    /// As many lights as have room.
    const LIGHTS: usize = 12;
    let folder = tempfile::tempdir().expect("a folder");
    let each = places.len() / lights.len();
    for (index, lights) in lights.chunks(LIGHTS).enumerate() {
        program(folder.path(), lights, PLACES);
        let chosen: Vec<_> =
            (0..lights.len() * PLACES).map(|i| (LIGHTS * index + i / PLACES) * each + i % PLACES).collect();
        let input: Vec<_> = chosen.iter().flat_map(|at| places[*at]).map(|word| word as u32).collect();
        let answer = |at: &usize| [expected[*at].0, expected[*at].1.unwrap_or(0)];
        let expected: Vec<_> = chosen.iter().flat_map(answer).collect();
        avr::writes(&folder.path().join("main.c"), &bytes(&input), &bytes(&expected));
    }
}

/// The conformance vectors are independent of the kernel that runs the test.
#[test]
fn conformance_vectors_have_their_bits() {
    let vectors = vectors::fixed16();
    let lights: Vec<_> = vectors.iter().map(|vector| vector.light).collect();
    let places: Vec<_> = vectors.iter().map(|vector| vector.place).collect();
    let expected: Vec<_> = vectors.iter().map(|vector| vector.answer).collect();
    println!("{} vectors", vectors.len());
    assert!(vectors.len() > 500, "{} vectors", vectors.len());
    // Each vector is a light of its own: an optimising compiler would take a minute.
    compare(&lights, &places, &expected, &[("cc", "-std=c99 -O0")]);
}

/// Names that begin with another's, or that are words of the code: all in one file, as integers and as
/// floats.
#[test]
fn lights_of_any_names_share_a_file() {
    const NAMES: [&str; 13] = [
        "key",
        "key_near",
        "key_fine",
        "key_squared",
        "key_color",
        "key_irradiance",
        "key_spot",
        "key_is",
        "is",
        "coarse",
        "coarse_smooth",
        "spot",
        "light",
    ];
    let folder = tempfile::tempdir().expect("a folder");
    write_headers(folder.path());
    let cone = Cone::soft(Angle::degrees(40.0)).expect("a cone");
    let light = SpotLight::new([0.0, 3.0, 0.0], [0.0, -1.0, 0.0], cone).expect("a light");
    let light = light.with_attenuation(SmoothRange::new(9.0).expect("a range"));
    let file = folder.path().join("all.c");
    for turn in 0..2 {
        let mut text = String::new();
        for (index, name) in NAMES.iter().enumerate() {
            let language = [Language::CFixed, Language::CFloat][(index + turn) % 2];
            text += &export(light, name, language).expect("a light");
        }
        fs::write(&file, text).expect("a folder");
        for (compiler, standard) in [("cc", "c99"), ("c++", "c++11")] {
            let flags = format!("-std={standard} -Wno-unused-variable -c");
            compile(compiler, &flags, &file, &folder.path().join("all.o"));
        }
    }
}

/// A light of a cubic with the inverse square is also one that moves, with the bits of the cubic.
#[test]
fn constant_lights_move() {
    let cone = Cone::from_beam_and_field(Angle::degrees(20.0), Angle::degrees(33.0)).expect("a cone");
    let falloff = cone.falloff();
    let Formula::Polynomial([a, b, c]) = falloff.formula() else { panic!("{falloff:?}") };
    let cone = cone.with_falloff(Cubic::new(a, b, c).expect("a cubic"));
    let light = SpotLight::new([1.0, 3.0, 0.5], [0.1, -1.0, 0.0], cone).expect("a light");
    let light = light.with_intensity(5.0).expect("a light");
    let folder = tempfile::tempdir().expect("a folder");
    write_headers(folder.path());
    let text = export(light, "key", Language::CFixed).expect("a light");
    let main = folder.path().join("main.c");
    fs::write(folder.path().join("key.h"), text).expect("a folder");
    let program = "#include <stdio.h>\n#include \"key.h\"\nint main(void) {
    uint32_t words[3], out;
    luminaire_spot spot = key_spot();
    luminaire_spot_dim(&spot, 16384);
    while (fread(words, 4, 3, stdin) == 3) {
        int32_t point[3] = { (int32_t)words[0], (int32_t)words[1], (int32_t)words[2] };
        int16_t up[3] = { 0, 16384, 0 };
        out = luminaire_spot_irradiance(&spot, point, up);
        if (fwrite(&out, 4, 1, stdout) != 1) { return 1; }
    }
    return 0;
}\n";
    fs::write(&main, program).expect("a folder");
    let kernel = light.compile::<Fx16>().expect("a light");
    let points: Vec<_> = (0..400).map(|i| [i * 600 - 60_000, 0, i * 300 - 20_000]).collect();
    let up = Fx16::normal([0.0, 1.0, 0.0]);
    let expected =
        points.iter().map(|point| kernel.irradiance(Vec3::from(*point).map(Length::from_bits), up).to_bits());
    let expected: Vec<_> = expected.collect();
    assert!(expected.iter().filter(|light| **light > 0).count() > 100);
    let words: Vec<_> = points.iter().flatten().map(|word| *word as u32).collect();
    for (compiler, flags) in [("cc", "-std=c99 -O1"), ("c++", "-std=c++11 -O1")] {
        if let Some(found) = run(compiler, flags, &main, &words) {
            assert_eq!(found, expected, "{compiler}");
        }
    }
}

/// The smallest processors that are supported compile all models without a warning, without floats
/// and without a division.
#[test]
fn small_processors_compile_all_models_in_integers() {
    let mut rng = Rng::with_seed(2001);
    let mut lights: Vec<AnyLight> = spots::<Fx16>(&mut rng, 1).into_iter().map(AnyLight::from).collect();
    lights.extend(measured::<Fx16>(&mut rng, 3).into_iter().map(AnyLight::from));
    let folder = tempfile::tempdir().expect("a folder");
    program(folder.path(), &lights, 1);
    let main = folder.path().join("main.c");
    // Neither of the two has the headers of a C library other than `stdint.h`.
    let text = fs::read_to_string(&main).expect("the program");
    let mut text = text[..text.find("int main").expect("a function")].replace("#include <stdio.h>\n", "");
    for (index, light) in lights.iter().enumerate() {
        let falloff = match light {
            AnyLight::Spot(_) => format!("(uint32_t)light{index}_falloff(p)"),
            _ => "0".to_owned(),
        };
        let _ = writeln!(
            text,
            "uint32_t evaluate{index}(const int32_t p[3], const int16_t n[3]);\n\
             uint32_t evaluate{index}(const int32_t p[3], const int16_t n[3]) {{\n    \
             return light{index}_color[0] < 0 ? 0 : light{index}_irradiance(p, n) + {falloff};\n}}"
        );
    }
    fs::write(&main, text).expect("a folder");
    compile_in_integers(&main);
}
