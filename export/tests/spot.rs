//! A `luminaire_spot` of C has the bits of the kernel, whatever its words are.

#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;

use std::fs;

use fastrand::Rng;
use luminaire::codegen::{ConeParts, FixedRamp, Gain16};
use luminaire::falloff::{CompiledCubic, Cubic};
use luminaire::light::{CompiledCone, CompiledSpotLight};
use luminaire::number::Weight16;
use luminaire::{Angle, Cone, Fx16, Fx32, Length, Rgb, SpotLight, Vec3};
use luminaire_export::c_header;

use compiler::run;

type Light = CompiledSpotLight<Fx16, Cubic>;
/// The words of a `luminaire_spot`.
type Words = [u32; 22];

/// The compilers and their options. The builds by parts are those of a Cortex-M0, and of an AVR whose tables
/// are in flash; the last of the builds of C ends at undefined behaviour.
const BUILDS: [(&str, &str); 7] = [
    ("cc", "-std=c99 -O0"),
    ("cc", "-std=c99 -O2"),
    ("cc", "-std=c99 -Os"),
    ("cc", "-std=c99 -O1 -DLUMINAIRE_BY_PARTS"),
    ("cc", "-std=c99 -O1 -D__AVR__ -fsanitize=undefined,address -fno-sanitize-recover=all"),
    ("c++", "-std=c++11 -O2"),
    ("clang", "-std=c99 -O2"),
];
const WARNINGS: &str = "-Wconversion -Wshadow -Wundef";
/// What stands for the header of an AVR's C library.
const FLASH: &str = "#define PROGMEM\n#define pgm_read_byte(a) (*(a))\n#define pgm_read_word(a) (*(a))\n\
                     #define pgm_read_dword(a) (*(a))\n";

/// What one call of the program gets.
#[derive(Clone, Copy, Debug)]
struct Place {
    spot: Words,
    other: Words,
    point: [i32; 3],
    radius: i32,
    normal: [i16; 3],
    part: i16,
}

fn scalars(words: [u32; 2]) -> [i16; 4] {
    let [[a, b], [c, d]] = words.map(|word| [word as i16, (word >> 16) as i16]);
    [a, b, c, d]
}

fn of_scalars([a, b, c, d]: [i16; 4]) -> [u32; 2] {
    [[a, b], [c, d]].map(|[low, high]| u32::from(low as u16) | u32::from(high as u16) << 16)
}

fn lengths(words: [i32; 3]) -> Vec3<Length> {
    Vec3::from(words).map(Length::from_bits)
}

/// The light with these words.
fn light(words: &Words) -> Light {
    let [x, y, z, along_x, along_y, along_z, ramp @ .., g, h, mantissa, shift, near, red_green, blue_outside] =
        *words;
    let [red, green, blue, outside] = scalars([red_green, blue_outside]).map(Fx16::from_bits);
    let [g, h] = [g, h].map(|word| Weight16::from_bits(word as i32));
    // No function reads the falloff of which the edge was compiled.
    let cone = CompiledCone::from_parts(
        FixedRamp::from_bits(ramp),
        Cubic::from_bits([0; 2]),
        CompiledCubic::from_parts(g, h),
    );
    Light::from_parts(
        lengths([x, y, z].map(|word| word as i32)),
        Vec3::new(along_x, along_y, along_z).map(|word| Fx32::from_bits(word as i32)),
        cone,
        outside,
        (),
        Gain16::from_bits([mantissa, shift].map(|word| word as i32)),
        near,
        [Rgb::new(red, green, blue); 2],
    )
}

/// The words of a light with the cubic that was compiled of it.
fn words(light: &Light) -> Words {
    let parts = light.parts();
    let ConeParts { axis, ramp, outside } = parts.cone.expect("a cone");
    let Rgb { red, green, blue } = light.color();
    let [a, b, c] = light.falloff().coefficients();
    let edge =
        [a - 1.0, -c].map(|weight| (weight.clamp(-4.0, 4.0) * 16_384.0).round_ties_even() as i32 as u32);
    debug_assert!((a + b + c - 1.0).abs() < 1e-3);
    let color = of_scalars([red, green, blue, outside].map(Fx16::to_bits));
    let position = <[Length; 3]>::from(parts.position).map(|c| c.to_bits() as u32);
    let axis = <[Fx32; 3]>::from(axis).map(|c| c.to_bits() as u32);
    let gain = parts.intensity.to_bits().map(|bits| bits as u32);
    let all = [&position[..], &axis, &ramp.to_bits(), &edge, &gain, &[parts.fine_below], &color].concat();
    all.try_into().expect("all words")
}

/// Returns two lights that zoom into each other, and the reach of the first.
fn lights(rng: &mut Rng) -> Option<([Light; 2], f32)> {
    let falloff = Cubic::with_slopes(3.0 * rng.f32(), 3.0 * rng.f32()).ok()?;
    let cone = |rng: &mut Rng| {
        let outer = 180.0 * rng.f32() * rng.f32();
        let cone = Cone::from_outer(falloff, Angle::degrees(outer)).ok()?;
        let inner = if rng.bool() { 0.0 } else { outer * rng.f32() };
        let cone = cone.with_inner(Angle::degrees(inner)).ok()?;
        let cutoff = outer * (0.3 + 0.7 * rng.f32());
        if rng.u8(..4) == 0 { cone.with_cutoff(Angle::degrees(cutoff)).ok() } else { Some(cone) }
    };
    let spot = |rng: &mut Rng, intensity: f32| {
        let position = [0; 3].map(|_| (rng.f32() - 0.5) * if rng.u8(..8) == 0 { 3e4 } else { 20.0 });
        let axis = [0; 3].map(|_| rng.f32() - 0.5);
        let spot = SpotLight::new(position, axis, cone(rng)?).ok()?.with_intensity(intensity).ok()?;
        spot.with_color(Rgb::new(rng.f32(), rng.f32(), rng.f32())).ok()
    };
    let intensity = 0.01 * 2_f32.powi(rng.i32(0..20));
    let (from, to) = (spot(rng, intensity)?, spot(rng, intensity)?);
    let both = if rng.bool() {
        [from.compile().ok()?, to.compile().ok()?]
    } else {
        from.compile_zoom::<Fx16>(&to.cone()).ok()?
    };
    Some((both, (8.0 * intensity).sqrt()))
}

/// Returns any word, more often one at a limit.
fn word(rng: &mut Rng) -> u32 {
    const HARD: [u32; 10] =
        [0, 1, 1 << 14, 1 << 15, 1 << 16, 1 << 30, 1 << 31, i32::MAX as u32, u32::MAX, 4096];
    match rng.u8(..4) {
        0 => HARD[rng.usize(..HARD.len())],
        1 => rng.u32(..64),
        2 => (rng.i32(..) >> rng.u8(..32)) as u32,
        _ => rng.u32(..),
    }
}

/// Replaces some words by any. Those of the axis keep 30 bits and a sign, as the upper half of a product by
/// parts expects.
fn spoil(rng: &mut Rng, words: &mut Words) {
    let share = rng.u8(1..16);
    for (index, place) in words.iter_mut().enumerate() {
        if rng.u8(..16) < share {
            *place = if (3..6).contains(&index) { (word(rng) as i32 >> 1) as u32 } else { word(rng) };
        }
    }
}

/// Returns a place on the lit side of a light, next to it, or anywhere.
fn place(rng: &mut Rng, [spot, other]: [Words; 2], reach: f32) -> Place {
    let any = |rng: &mut Rng| [0; 3].map(|_| word(rng) as i32);
    let position = [0, 1, 2].map(|i| spot[i] as i32);
    let axis = [3, 4, 5].map(|i| spot[i] as i32 as f32 / 1_073_741_824.0);
    let point = match rng.u8(..8) {
        0 => any(rng),
        1 => position.map(|c| c.wrapping_add(word(rng) as i32 >> rng.u8(8..31))),
        _ => {
            let (distance, width) = (reach * rng.f32(), 2.0 * rng.f32() * rng.f32());
            let way = axis.map(|c| distance * (c + width * (rng.f32() - 0.5)));
            [0, 1, 2].map(|i| position[i].wrapping_add(Length::from_f32(way[i]).to_bits()))
        }
    };
    let normal = match rng.u8(..8) {
        0 => any(rng).map(|c| c as i16),
        _ => axis.map(|c| Fx16::from_f32(rng.f32() - 0.5 - c).to_bits()),
    };
    let radius =
        if rng.bool() { Length::from_f32(reach * rng.f32() / 4.0).to_bits() } else { word(rng) as i32 };
    let part = if rng.bool() { rng.i16(0..=1 << 14) } else { word(rng) as i16 };
    Place { spot, other, point, radius, normal, part }
}

/// What the program gets of a place.
fn input(place: &Place) -> Vec<u32> {
    let Place { spot, other, point, radius, normal: [x, y, z], part } = *place;
    let point = point.map(|c| c as u32);
    [&spot[..], &other, &point, &[radius as u32], &of_scalars([x, y, z, part])].concat()
}

/// What the kernel answers, in the words of the program.
fn expected(place: &Place) -> Vec<u32> {
    let light = light(&place.spot);
    let (point, normal) = (lengths(place.point), Vec3::from(place.normal).map(Fx16::from_bits));
    let irradiance = light.irradiance(point, normal);
    let Rgb { red, green, blue } = Rgb::lit(irradiance, light.color()).map(|light| light.to_bits());
    vec![irradiance.to_bits(), red, green, blue, light.falloff_at(point).to_bits() as u32]
}

#[test]
fn a_spot_of_any_words_has_the_bits_of_the_kernel() {
    const BATCH: usize = 20_000;
    let count = if std::env::var_os("LUMINAIRE_FULL").is_some() { 1_000_000 } else { BATCH };
    let folder = tempfile::tempdir().expect("a folder");
    let main = folder.path().join("main.c");
    fs::create_dir(folder.path().join("avr")).expect("a folder");
    fs::write(folder.path().join("avr/pgmspace.h"), FLASH).expect("a folder");
    fs::write(folder.path().join("luminaire.h"), c_header()).expect("a folder");
    fs::write(&main, include_str!("spot.c")).expect("a folder");
    let mut rng = Rng::with_seed(2011);
    let (mut lit, mut fine, mut done) = (0, 0, 0);
    while done < count {
        let mut places = Vec::new();
        while places.len() < BATCH {
            let Some((lights, reach)) = lights(&mut rng) else { continue };
            let sound = lights.map(|light| words(&light));
            for turn in 0..8 {
                let mut words = sound;
                if turn > 4 {
                    words.iter_mut().for_each(|words| spoil(&mut rng, words));
                }
                let place = place(&mut rng, words, reach);
                let irradiance =
                    light(&words[0]).irradiance(lengths(place.point), Fx16::normal([0.0, 1.0, 0.0]));
                if turn <= 4 {
                    let compiled = lights[0].irradiance(lengths(place.point), Fx16::normal([0.0, 1.0, 0.0]));
                    assert_eq!(compiled, irradiance, "the words of a light");
                    fine += usize::from(lights[0].is_fine(lengths(place.point)));
                }
                places.push(place);
            }
        }
        done += places.len();
        let words: Vec<u32> = places.iter().flat_map(input).collect();
        let answers: Vec<_> = places.iter().map(expected).collect();
        lit += answers.iter().filter(|answer| answer[0] > 0).count();
        for (compiler, flags) in BUILDS {
            let flags = format!("{flags} {WARNINGS} -I{}", folder.path().display());
            let Some(found) = run(compiler, &flags, &main, &words) else { continue };
            let mut rest = &found[..];
            for (place, expected) in places.iter().zip(&answers) {
                let (found, left) = rest.split_at_checked(expected.len()).expect("an answer to each place");
                assert_eq!(found, expected, "{compiler} {flags}: {place:?}");
                rest = left;
            }
            assert!(rest.is_empty());
        }
    }
    println!("{done} places, {lit} of them lit and {fine} evaluated finely");
    assert!(lit > done / 4 && fine > done / 20);
}
