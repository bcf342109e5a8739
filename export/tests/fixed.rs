//! The C of the 16-bit format has the bits of the kernel.

mod support;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use fastrand::Rng;
use luminaire::dynamic::AnyLight;
use luminaire::{Fx16, Length, Vec3};
use luminaire_export::{Language, c_header, export};

use support::compiler::run;
use support::{points_of_light, spots};

/// Words of a place in the input of the program: a point and a normal.
const WORDS: usize = 6;

type Place = [i32; WORDS];

/// Returns a program that evaluates each light at as many places.
///
/// It reads the words of the places and writes irradiance and falloff in words.
fn program(folder: &Path, lights: &[AnyLight], places: usize) {
    let mut main = "#include <stdio.h>\n".to_owned();
    fs::write(folder.join("luminaire_fx16.h"), c_header()).expect("a folder");
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
        let _ = writeln!(
            main,
            "    for (i = 0; i < {places}; ++i) {{\n        \
             if (fread(w, 4, 6, stdin) != 6) {{ return 1; }}\n        \
             n[0] = (int16_t)w[3]; n[1] = (int16_t)w[4]; n[2] = (int16_t)w[5];\n        \
             out[0] = light{index}_irradiance(w, n);\n        out[1] = {falloff};\n        \
             if (light{index}_color[0] < 0 || fwrite(out, 4, 2, stdout) != 2) {{ return 1; }}\n    }}"
        );
    }
    main += "    return 0;\n}\n";
    fs::write(folder.join("main.c"), main).expect("a folder");
}

fn words(place: &Place) -> (Vec3<Length>, Vec3<Fx16>) {
    let [x, y, z, nx, ny, nz] = *place;
    (Vec3::new(x, y, z).map(Length::from_bits), Vec3::new(nx, ny, nz).map(|n| Fx16::from_bits(n as i16)))
}

/// Returns the irradiance and the falloff by the kernel.
fn by_the_kernel(light: &AnyLight, places: &[Place]) -> Vec<[u32; 2]> {
    match light {
        AnyLight::Spot(spot) => {
            let light = spot.compile::<Fx16>().expect("a light");
            let at = |place| {
                let (point, normal) = words(place);
                [light.irradiance(point, normal).to_bits(), light.falloff(point).to_bits() as u32]
            };
            places.iter().map(at).collect()
        }
        AnyLight::Point(point) => {
            let light = point.compile::<Fx16>().expect("a light");
            let at = |place| {
                let (point, normal) = words(place);
                [light.irradiance(point, normal).to_bits(), 0]
            };
            places.iter().map(at).collect()
        }
        AnyLight::Directional(_) => unreachable!("not exported"),
    }
}

/// Returns places in reach of a light, places near its position and places of any bits.
fn places(rng: &mut Rng, light: &AnyLight, count: usize) -> Vec<Place> {
    const HARD: [i32; 9] = [0, 1, -1, i32::MIN, i32::MAX, 1 << 16, (1 << 17) - 1, 1 << 24, -(1 << 30)];
    let position = match light {
        AnyLight::Spot(spot) => spot.position(),
        AnyLight::Point(point) => point.position(),
        AnyLight::Directional(_) => unreachable!("not exported"),
    };
    let position: [i32; 3] = position.map(|c| Length::from_f32(c).to_bits()).into();
    let place = |index| {
        let mut bits =
            || if rng.bool() { rng.i32(..) >> rng.u8(..32) } else { HARD[usize::from(rng.u8(..9))] };
        match index % 8 {
            0 => [0; WORDS].map(|_| bits()),
            1 => {
                let [x, y, z, nx, ny, nz] = [0; WORDS].map(|_| bits());
                let [x, y, z] = [0, 1, 2].map(|i| position[i].wrapping_add([x, y, z][i]));
                [x, y, z, nx, ny, nz]
            }
            _ => {
                let (point, normal) = support::place(rng, light);
                let ([x, y, z], [nx, ny, nz]) = (
                    point.map(|c| Length::from_f32(c).to_bits()),
                    normal.map(|c| i32::from(Fx16::from_f32(c).to_bits())),
                );
                [x, y, z, nx, ny, nz]
            }
        }
    };
    (0..count).map(place).collect()
}

/// Compares lights at places, as many for each light, by several compilers.
fn compare(lights: &[AnyLight], input: &[Place]) {
    let folder = tempfile::tempdir().expect("a folder");
    let each = input.len() / lights.len();
    program(folder.path(), lights, each);
    let expected: Vec<_> =
        lights.iter().zip(input.chunks(each)).flat_map(|(l, p)| by_the_kernel(l, p)).collect();
    let words: Vec<u32> = input.iter().flatten().map(|&word| word as u32).collect();
    let lit = expected.iter().filter(|answer| answer[0] > 0).count();
    for (compiler, flags) in [
        ("cc", "-std=c99 -O2"),
        ("cc", "-std=c99 -O1 -DLUMINAIRE_BY_PARTS -fsanitize=undefined -fno-sanitize-recover=all"),
        ("c++", "-std=c++11 -Os"),
    ] {
        let Some(found) = run(compiler, flags, &folder.path().join("main.c"), &words) else { continue };
        let found: Vec<_> = found.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
        assert_eq!(found.len(), expected.len());
        let differs = found.iter().zip(&expected).position(|(found, expected)| found != expected);
        if let Some(at) = differs {
            let light = &lights[at / each];
            panic!(
                "{compiler} {flags}: {:?}, expected {:?}, at {:?} of {light:?}",
                found[at], expected[at], input[at]
            );
        }
    }
    println!("{} lights, {} points, {lit} of them lit: the same bits", lights.len(), input.len());
}

#[test]
fn random_lights_have_the_bits_of_the_kernel() {
    let mut rng = Rng::with_seed(1999);
    let (variants, each) =
        if std::env::var_os("LUMINAIRE_FULL").is_some() { (12, 40_000) } else { (2, 5_000) };
    let mut lights: Vec<AnyLight> =
        spots::<Fx16>(&mut rng, variants).into_iter().map(AnyLight::from).collect();
    lights.extend(points_of_light(&mut rng).into_iter().map(AnyLight::from));
    let input: Vec<_> = lights.iter().flat_map(|light| places(&mut rng, light, each)).collect();
    compare(&lights, &input);
}
