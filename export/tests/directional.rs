//! A `luminaire_directional` of C has the bits of the kernel, of any words.

#[path = "support/avr.rs"]
mod avr;
#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;

use std::fs;

use fastrand::Rng;
use luminaire::codegen::Gain16;
use luminaire::light::CompiledDirectionalLight;
use luminaire::number::Light16;
use luminaire::{Fx16, Fx32, Length, Rgb, Vec3};

use compiler::{bytes, compile_in_integers, run, write_headers};

const PROGRAM: &str = include_str!("directional.c");
const BUILDS: [(&str, &str); 4] = [
    ("cc", "-std=c99 -O2"),
    ("cc", "-std=c99 -O1 -DLUMINAIRE_BY_PARTS -fsanitize=undefined,address -fno-sanitize-recover=all"),
    ("c++", "-std=c++11 -Os"),
    ("clang", "-std=c99 -Os"),
];

/// The words of a light, a way, an intensity, a normal and a part.
type Place = [u32; 13];

fn place(rng: &mut Rng) -> Place {
    let mut place = [0; 13].map(|_| (rng.i32(..) >> rng.u8(..32)) as u32);
    // Most lights have a direction, and a shift of light that is seen.
    if rng.u8(..4) > 0 {
        place[..3].iter_mut().for_each(|word| *word = rng.i32(-(1 << 30)..=1 << 30) as u32);
        (place[3], place[4]) = (rng.u32(..) | 1 << 31, rng.u32(20..50));
        place[10] = rng.u32(..1 << 20);
    }
    place
}

fn scalars(words: [u32; 2]) -> [i16; 4] {
    let [[a, b], [c, d]] = words.map(|word| [word as i16, (word >> 16) as i16]);
    [a, b, c, d]
}

fn three(light: Rgb<Light16>) -> [u32; 3] {
    <[Light16; 3]>::from(light).map(Light16::to_bits)
}

/// The words of the answer: those of a point, of a light that was changed, of one that was set up, and ambient light.
fn expected(place: &Place) -> Vec<u32> {
    let [x, y, z, mantissa, shift, red_green, blue, way @ .., intensity, normal, other] = *place;
    let [red, green, blue, _] = scalars([red_green, blue]).map(Fx16::from_bits);
    let [a, b, c, part] = scalars([normal, other]).map(Fx16::from_bits);
    let (normal, own) = (Vec3::new(a, b, c), Rgb::new(a, b, c));
    let light = |direction: Vec3<Fx32>, gain, color| {
        CompiledDirectionalLight::<Fx16>::from_parts(direction, gain, [color; 2])
    };
    let direction = Vec3::new(x, y, z).map(|word| Fx32::from_bits(word as i32));
    let sun = light(
        direction,
        Gain16::from_bits([mantissa, shift].map(|word| word as i32)),
        Rgb::new(red, green, blue),
    );
    let irradiance = sun.irradiance(normal);
    let mut words = vec![irradiance.to_bits()];
    words.extend(three(Rgb::lit(irradiance, sun.color())));
    let mut tell = |code: u32, light: &CompiledDirectionalLight<Fx16>| {
        let (direction, gain) = light.parts();
        words.push(code);
        words.extend(<[Fx32; 3]>::from(direction).map(|word| word.to_bits() as u32));
        words.extend(gain.to_bits().map(|word| word as u32));
        words.extend(<[Fx16; 3]>::from(light.color()).map(|word| i32::from(word.to_bits()) as u32));
    };
    let way = Vec3::from(way).map(|word| Length::from_bits(word as i32));
    let aimed = sun.aimed_along(way);
    tell(aimed.is_some().into(), &aimed.unwrap_or(sun).with_color(own).dimmed(part));
    let gain = Gain16::from_bits([(intensity as i32).max(0), 16]);
    let (white, dark) = (Rgb::new(Fx16::ONE, Fx16::ONE, Fx16::ONE), Gain16::from_bits([0; 2]));
    let set_up = light(Vec3::default(), gain, white).aimed_along(way);
    tell(
        if set_up.is_some() { 0 } else { 5 },
        &set_up.unwrap_or(light(Vec3::default(), dark, Rgb::default())),
    );
    words.extend(three(Rgb::lit(Light16::from_bits(((intensity as i32).max(0) as u32 + 2) >> 2), own)));
    words
}

#[test]
fn a_directional_light_has_the_bits_of_the_kernel() {
    let mut rng = Rng::with_seed(2029);
    let places: Vec<_> = (0..if std::env::var_os("LUMINAIRE_FULL").is_some() { 1_000_000 } else { 20_000 })
        .map(|_| place(&mut rng))
        .collect();
    let answers: Vec<_> = places.iter().map(expected).collect();
    let lit = answers.iter().filter(|answer| answer[0] > 0 && answer[0] < 1 << 20).count();
    println!("{} places, {lit} of them lit", places.len());
    assert!(lit > places.len() / 10, "{lit}");
    let folder = tempfile::tempdir().expect("a folder");
    let main = folder.path().join("main.c");
    write_headers(folder.path());
    fs::write(&main, PROGRAM).expect("a folder");
    for (compiler, flags) in BUILDS {
        let flags = format!("{flags} -Wconversion -Wshadow -Wundef -I{}", folder.path().display());
        let Some(found) = run(compiler, &flags, &main, &places.concat()) else { continue };
        assert_eq!(found.len(), answers.concat().len());
        for ((found, expected), place) in found.chunks_exact(answers[0].len()).zip(&answers).zip(&places) {
            assert_eq!(found, expected, "{compiler} {flags}: {place:?}");
        }
    }
    avr::writes(&main, &bytes(&places[..300].concat()), &bytes(&answers[..300].concat()));
    fs::write(&main, PROGRAM.split_once("#include <stdio.h>").expect("a program").0).expect("a folder");
    compile_in_integers(&main);
}
