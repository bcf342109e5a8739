//! A `luminaire_spot` of C has the bits of the kernel: as set-up made it, and restored from any words.

#[path = "support/avr.rs"]
mod avr;
#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;
#[path = "support/words.rs"]
mod words;

use std::fs;
use std::path::Path;

use fastrand::Rng;
use luminaire::codegen::{FixedRamp, Gain16};
use luminaire::draw::{normals_from_directx, normals_from_opengl};
use luminaire::falloff::{CompiledCubic, Cubic};
use luminaire::light::{CompiledCone, CompiledSpotLight, Row};
use luminaire::number::{Light16, Weight16};
use luminaire::{Angle, Cone, Fx16, Fx32, Length, Rgb, SpotLight, Vec3};

use compiler::{bytes, compile_in_integers, run, write_headers};
use tempfile::TempDir;
use words::{Words, of_scalars, words, words_with_edge};

type Light = CompiledSpotLight<Fx16, Cubic>;

/// The compilers and their options. Two builds end at undefined behaviour; one of these computes the upper
/// halves of products from parts, and takes its tables from flash.
const BUILDS: [(&str, &str); 7] = [
    ("cc", "-std=c99 -O0"),
    ("cc", "-std=c99 -O2"),
    ("cc", "-std=c99 -Os -DLUMINAIRE_BY_PARTS"),
    ("cc", "-std=c99 -O1 -fsanitize=undefined,address -fno-sanitize-recover=all"),
    ("cc", "-std=c99 -O1 -D__AVR__ -fsanitize=undefined,address -fno-sanitize-recover=all"),
    ("c++", "-std=c++11 -O2"),
    ("clang", "-std=c99 -Os"),
];
const WARNINGS: &str = "-Wconversion -Wshadow -Wundef";

/// What one call of the program gets.
#[derive(Clone, Copy, Debug)]
struct Place {
    spot: Words,
    other: Words,
    point: [i32; 3],
    radius: i32,
    normal: [i16; 3],
    part: i16,
    /// The first point and the step of a row.
    row: [[i32; 3]; 2],
    bytes: [i8; 4],
    count: u32,
    /// Whether set-up made the words of the lights.
    is_made: bool,
}

fn scalars(words: [u32; 2]) -> [i16; 4] {
    let [[a, b], [c, d]] = words.map(|word| [word as i16, (word >> 16) as i16]);
    [a, b, c, d]
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

/// Returns two lights that zoom into each other, and the reach of the first.
fn lights(rng: &mut Rng) -> Option<([Light; 2], f32)> {
    let falloff = Cubic::with_slopes(4.0 * rng.f32(), 4.0 * rng.f32()).ok()?;
    let cone = |rng: &mut Rng| {
        let outer = 180.0 * rng.f32() * rng.f32();
        let cone = Cone::from_outer(falloff, Angle::degrees(outer)).ok()?;
        let inner = if rng.bool() { 0.0 } else { outer * rng.f32() };
        let cone = cone.with_inner(Angle::degrees(inner)).ok()?;
        let cutoff = outer * (0.3 + 0.7 * rng.f32());
        if rng.u8(..4) == 0 { cone.with_cutoff(Angle::degrees(cutoff)).ok() } else { Some(cone) }
    };
    let spot = |rng: &mut Rng, intensity: f32| {
        let position = [0; 3].map(|_| (rng.f32() - 0.5) * if rng.u8(..8) == 0 { 32_766.0 } else { 20.0 });
        let axis = [0; 3].map(|_| rng.f32() - 0.5);
        let spot = SpotLight::new(position, axis, cone(rng)?).ok()?.with_intensity(intensity).ok()?;
        spot.with_color(Rgb::new(rng.f32(), rng.f32(), rng.f32())).ok()
    };
    let intensity =
        if rng.u8(..4) == 0 { 1e-9 * 1e18_f32.powf(rng.f32()) } else { 0.01 * 2_f32.powi(rng.i32(0..20)) };
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
/// parts expects. Some edges are soft but for one weight, because the soft edge has a path of its own.
fn spoil(rng: &mut Rng, words: &mut Words) {
    if rng.u8(..4) == 0 {
        [words[15], words[16]] = [-16_384_i32 as u32, rng.i32(-40_000..40_000) as u32];
    }
    let share = rng.u8(1..16);
    for (index, place) in words.iter_mut().enumerate() {
        if rng.u8(..16) < share {
            *place = if (3..6).contains(&index) { (word(rng) as i32 >> 1) as u32 } else { word(rng) };
        }
    }
}

/// Returns a place on the lit side of a light, next to it, or anywhere.
fn place(rng: &mut Rng, [spot, other]: [Words; 2], is_made: bool, reach: f32) -> Place {
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
        // Of a surface that light grazes.
        1 => {
            let [x, y, z] = [0, 1, 2].map(|i| (point[i].wrapping_sub(position[i])) as f32);
            let [a, b, c] = [0; 3].map(|_| rng.f32() - 0.5);
            let normal = [y * c - z * b, z * a - x * c, x * b - y * a];
            let length = normal.iter().map(|c| c * c).sum::<f32>().sqrt();
            normal.map(|c| Fx16::from_f32(c / length).to_bits())
        }
        _ => axis.map(|c| Fx16::from_f32(rng.f32() - 0.5 - c).to_bits()),
    };
    let radius = match rng.u8(..3) {
        0 => word(rng) as i32,
        1 => Length::from_f32(reach * rng.f32() / 4.0).to_bits(),
        // Of one of the two spheres next to the cone.
        _ => {
            let light = light(&spot);
            let reaches = |radius| light.can_reach(lengths(point), Length::from_bits(radius));
            let longer = |least, bit| if reaches(least | 1 << bit) { least } else { least | 1 << bit };
            (0..31).rev().fold(0_i32, longer).saturating_add(rng.i32(0..2))
        }
    };
    let part = if rng.bool() { rng.i16(0..=1 << 14) } else { word(rng) as i16 };
    // Half of the rows cross the beam.
    let scale = if rng.bool() { reach / 64.0 } else { reach };
    let step = [0; 3].map(|_| Length::from_f32(scale * (rng.f32() - 0.5)).to_bits());
    let step = if rng.u8(..16) == 0 { any(rng) } else { step };
    let most = if rng.u8(..4) == 0 { 150 } else { 5 };
    let (count, before) = (rng.u32(..most), -rng.i32(0..80));
    let first = [0, 1, 2].map(|k| point[k].wrapping_add(step[k].wrapping_mul(before)));
    let bytes = if rng.u8(..8) == 0 { [0, 0, 0, rng.i8(..)] } else { [0; 4].map(|_| rng.i8(..)) };
    Place { spot, other, point, radius, normal, part, row: [first, step], bytes, count, is_made }
}

/// What the program gets of a place.
fn input(place: &Place) -> Vec<u32> {
    let Place { spot, other, point, radius, normal: [x, y, z], part, row, bytes, count, is_made } = *place;
    let [first, step] = row;
    let [point, first, step] = [point, first, step].map(|words| words.map(|c| c as u32));
    let (bytes, zero) = (u32::from_le_bytes(bytes.map(|byte| byte as u8)), of_scalars([x, y, z, 0]));
    let normal = of_scalars([x, y, z, part]);
    [
        &spot[..],
        &other,
        &point,
        &[radius as u32],
        &normal,
        &first,
        &step,
        &zero,
        &[bytes, count, is_made.into()],
    ]
    .concat()
}

/// What the kernel answers.
fn expected(place: &Place) -> Vec<Vec<u32>> {
    let (spot, other) = (light(&place.spot), light(&place.other));
    let (point, normal) = (lengths(place.point), Vec3::from(place.normal).map(Fx16::from_bits));
    let irradiance = spot.irradiance(point, normal);
    let [x, y, z, _] = place.bytes;
    let normals = [Fx16::normal_from_bytes([x, y, z]), Fx16::normal_from_unit_bytes([x, y, z])];
    let [[a, b, c], [d, e, f]] = normals.map(|normal| <[Fx16; 3]>::from(normal).map(Fx16::to_bits));
    let edge = |words: &Words| [words[15], words[16]];
    let restored = [(&spot, &place.spot), (&other, &place.other)]
        .map(|(light, words)| words_with_edge(light, edge(words)).to_vec());
    let mut one = vec![irradiance.to_bits()];
    one.extend(bits(Rgb::lit(irradiance, spot.color())));
    one.extend([
        spot.falloff_at(point).to_bits() as u32,
        spot.can_reach(point, Length::from_bits(place.radius)).into(),
    ]);
    one.extend(of_scalars([a, b, c, d]).into_iter().chain([of_scalars([e, f, 0, 0])[0]]));
    // With a black pixel beside it, which has no normal.
    let map = [[x as u8, y as u8, z as u8], [0; 3]];
    let signed = [normals_from_opengl(&map), normals_from_directx(&map)];
    one.extend(
        signed
            .as_flattened()
            .as_flattened()
            .chunks(4)
            .map(|bytes| u32::from_ne_bytes([0, 1, 2, 3].map(|i| bytes[i] as u8))),
    );
    let mut answers = Vec::from(restored);
    answers.push(one);
    let mut changed = |succeeded: Option<bool>, light: Light| {
        answers.extend(succeeded.map(|is_done| vec![is_done.into()]));
        answers.push(words_with_edge(&light, edge(&place.spot)).to_vec());
    };
    let (part, aimed) = (Fx16::from_bits(place.part), spot.aimed_at(point));
    changed(Some(aimed.is_some()), aimed.unwrap_or(spot));
    let [red, green, blue] = normal.into();
    let moved = aimed.unwrap_or(spot).moved_to(point).with_color(Rgb::new(red, green, blue));
    // The program has one colour, and no light of it shines.
    let moved = moved.with_specular_color(moved.color());
    changed(None, moved);
    let along = moved.aimed_along(lengths(place.row[1]));
    let dimmed = along.unwrap_or(moved).dimmed(part);
    changed(Some(along.is_some()), dimmed);
    let zoomed = dimmed.zoomed(&other, part);
    changed(None, zoomed);
    changed(None, zoomed.zoomed(&zoomed, part));
    answers.push(many(place, &[spot, other]));
    answers
}

fn bits(light: Rgb<Light16>) -> [u32; 3] {
    <[Light16; 3]>::from(light).map(Light16::to_bits)
}

/// What the kernel answers of a row, of a row with normals, and of vertices.
fn many(place: &Place, spots: &[Light; 2]) -> Vec<u32> {
    let [first, step] = place.row;
    let count = place.count as usize;
    let normal = Vec3::from(place.normal).map(Fx16::from_bits);
    let at = |i: usize| lengths([0, 1, 2].map(|k| first[k].wrapping_add(step[k].wrapping_mul(i as i32))));
    let started = |i: usize| Rgb::new(i as u32, 0, 0xffff_ff00).map(Light16::from_bits);
    let row = Row::new(normal, at);
    let reach = row.reach(&spots[0], count);
    let added = |arrived: Vec<Light16>| {
        let lit = arrived.into_iter().enumerate();
        lit.map(|(i, light)| started(i) + Rgb::lit(light, spots[0].color())).collect::<Vec<_>>()
    };
    // Words from elsewhere may reject points that their cone lights, which a row that is evaluated in vectors does not.
    let each = |normal: &dyn Fn(usize) -> Vec3<Fx16>, arrived: &mut [Light16]| {
        for (i, arrived) in (reach.start..).zip(arrived) {
            *arrived = spots[0].irradiance(at(i), normal(i));
        }
    };
    let mut flat = vec![Light16::ZERO; count];
    if place.is_made {
        row.fill(&spots[0], reach.start, &mut flat[reach.clone()]);
    } else {
        each(&|_| normal, &mut flat[reach.clone()]);
    }
    let mut lit = added(flat);
    let facing = |i: usize| {
        let byte = |i: usize| (i32::from(place.bytes[i % 4]) + i as i32) as i8;
        Fx16::normal_from_unit_bytes([3 * i, 3 * i + 1, 3 * i + 2].map(byte))
    };
    let mut sprite = vec![Light16::ZERO; count];
    if place.is_made {
        row.fill_facing(&spots[0], facing, reach.start, &mut sprite[reach.clone()]);
    } else {
        each(&facing, &mut sprite[reach.clone()]);
    }
    lit.extend(added(sprite));
    lit.extend((0..count).map(|i| {
        let point = lengths([0, 1, 2].map(|k| place.point[k].wrapping_add(step[k] << (i & 15))));
        let normal = Vec3::from(place.normal).map(|c| Fx16::from_bits(c >> (i & 3)));
        let light = |spot: &Light| Rgb::lit(spot.irradiance(point, normal), spot.color());
        spots.iter().fold(started(i), |sum, spot| sum + light(spot))
    }));
    lit.into_iter().flat_map(bits).collect()
}

/// The program, and the line from which on it needs a C library.
const PROGRAM: &str = include_str!("spot.c");
const LIBRARY: &str = "#include <stdio.h>\n";

/// A folder with the header and a program.
fn folder(program: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    write_headers(folder.path());
    fs::write(folder.path().join("main.c"), program).expect("a folder");
    folder
}

/// The smallest processors need neither floats nor a division for any function.
#[test]
fn small_processors_compile_all_functions_in_integers() {
    let (functions, _) = PROGRAM.split_once(LIBRARY).expect("functions before the library");
    let folder = folder(functions);
    compile_in_integers(&folder.path().join("main.c"));
}

/// Compares an AVR, where an `int` has 16 bits, with this machine at some of the places.
fn on_avr(main: &Path, places: &[Place]) {
    let words: Vec<u32> = places.iter().step_by(places.len() / 60).flat_map(input).collect();
    let flags = format!("-std=c99 -O1 -I{}", avr::LIBRARY);
    let Some(expected) = run("cc", &flags, main, &words) else { return };
    // There a structure has no gaps: the one after the normal of a row has two bytes.
    let input = bytes(&words);
    let input = input.chunks(244).flat_map(|place| [&place[..230], &place[232..]].concat());
    avr::writes(main, &input.collect::<Vec<_>>(), &bytes(&expected));
}

#[test]
fn a_spot_has_the_bits_of_the_kernel() {
    let full = std::env::var_os("LUMINAIRE_FULL").is_some();
    let (count, batch) = if full { (1_000_000, 50_000) } else { (4_000, 4_000) };
    let folder = folder(PROGRAM);
    let main = folder.path().join("main.c");
    let mut rng = Rng::with_seed(2011);
    let (mut lit, mut fine, mut done) = (0, 0, 0);
    while done < count {
        let mut places = Vec::new();
        while places.len() < batch {
            let Some((lights, reach)) = lights(&mut rng) else { continue };
            let sound = lights.map(|light| words(&light));
            for turn in 0..8 {
                let mut words = sound;
                if turn > 4 {
                    words.iter_mut().for_each(|words| spoil(&mut rng, words));
                }
                let place = place(&mut rng, words, turn <= 4, reach);
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
        let is_lit = |answers: &&Vec<Vec<u32>>| answers[2][0] > 0;
        lit += answers.iter().filter(is_lit).count();
        for (compiler, flags) in BUILDS {
            let flags = format!("{flags} {WARNINGS} -I{}", folder.path().display());
            let Some(found) = run(compiler, &flags, &main, &words) else { continue };
            let mut rest = &found[..];
            for (place, answers) in places.iter().zip(&answers) {
                for expected in answers {
                    let (found, others) = rest.split_at_checked(expected.len()).expect("all answers");
                    assert_eq!(found, expected, "{compiler} {flags}: {place:?}");
                    rest = others;
                }
            }
            assert!(rest.is_empty());
        }
        if done == batch {
            on_avr(&main, &places);
        }
    }
    println!("{done} places, {lit} of them lit and {fine} evaluated finely");
    assert!(lit > done / 4 && fine > done / 20);
}
