//! Ordered dither against its definition in f64: a cell of 8 x 8 pixels has the mean light of the
//! colour that it shows.

use luminaire::{
    Fx16, Fx32, Rgb, Scalar,
    display::{Rgb565, decode_srgb, encode_srgb_dithered, encode_srgb_dithered_each},
};
use support::{assert_that, format::Format, oracle};

/// The last codes of eight, six and five bits.
const LASTS: [u16; 3] = [255, 63, 31];
/// The largest error of a threshold due to the 24 bits of the table, in steps from one code to the
/// next: half of 2^-24, relative to the shortest step, and the same again for the rounding of a
/// value.
const LEEWAY: f64 = 3e-4;

/// Bayer's matrix by his recursion: four copies of the next smaller one, four times as far apart.
fn bayer(x: u32, y: u32, size: u32) -> u32 {
    if size == 1 {
        return 0;
    }
    let half = size / 2;
    4 * bayer(x % half, y % half, half) + [[0, 2], [3, 1]][(y / half) as usize][(x / half) as usize]
}

/// The codes of a grey value at a place: of eight, six and five bits.
fn codes<S: Scalar>(value: S, x: u32, y: u32) -> [u16; 3] {
    let gray = Rgb::new(value, value, value);
    let Rgb565(pixel) = Rgb565::from_linear_dithered(gray, x, y);
    assert_eq!(Rgb565::from_linear_dithered_fast(gray, x, y), Rgb565(pixel), "{value:?} at {x} {y}");
    assert_eq!(pixel >> 11, pixel & 31, "red and blue of one value");
    [encode_srgb_dithered(value, x, y).into(), pixel >> 5 & 63, pixel & 31]
}

/// The light of each code.
fn lights(last: u16) -> Vec<f64> {
    (0..=last).map(|code| oracle::srgb_linear(f64::from(code) / f64::from(last) * 255.0)).collect()
}

/// The code below a light, and the position of the light between that code and the next.
fn place(lights: &[f64], light: f64) -> (u16, f64) {
    let code = lights.partition_point(|&of_code| of_code <= light).clamp(1, lights.len() - 1) - 1;
    (code as u16, (light - lights[code]) / (lights[code + 1] - lights[code]))
}

/// Exactly on a threshold a pixel shows the lower code, and just above it the upper one. Among the
/// first ten codes, where sRGB is linear, every threshold is a number of f32.
#[test]
fn a_value_on_a_threshold_shows_the_lower_code() {
    let light = |code: u32| (f64::from(code) / 255.0 / 12.92 * 16_777_216.0).round();
    for (code, x, y) in (0..9).flat_map(|code| (0..64).map(move |i| (code, i % 8, i / 8))) {
        let threshold = f64::from(2 * bayer(x, y, 8) + 1) / 128.0;
        let value = ((light(code) + (light(code + 1) - light(code)) * threshold) / 16_777_216.0) as f32;
        assert_eq!(u32::from(encode_srgb_dithered(value, x, y)), code, "{x} {y}");
        assert_eq!(u32::from(encode_srgb_dithered(value.next_up(), x, y)), code + 1, "{x} {y}");
    }
}

/// Encoding many values at once gives the code of each, on both sides of every threshold of every
/// pixel of a cell, and outside the range.
#[test]
fn encoding_many_dithered_is_encoding_each() {
    fn assert_each<S: Format>(values: impl IntoIterator<Item = S>, x: u32, y: u32) {
        let values: Vec<_> = values.into_iter().collect();
        for (block, at) in values.as_chunks::<32>().0.iter().zip((0..).map(|block| x.wrapping_add(5 * block)))
        {
            let mut place = at;
            let codes = block.map(|value| {
                place = place.wrapping_add(1);
                encode_srgb_dithered(value, place.wrapping_sub(1), y)
            });
            assert_eq!(encode_srgb_dithered_each(block, at, y), codes, "{block:?} at {at}, {y}");
        }
    }
    let lights = lights(255);
    for y in 0..8 {
        // The first pixel of a row of 8 has the threshold of each column once.
        for x in [0, 3, u32::MAX - 9] {
            let around = lights.windows(2).flat_map(|pair| {
                (0..8).flat_map(move |column| {
                    let part = f64::from(2 * bayer(column, y, 8) + 1) / 128.0;
                    let value = (pair[0] + part * (pair[1] - pair[0])) as f32;
                    (-8..8).map(move |ulps| f32::from_bits(value.to_bits().wrapping_add_signed(ulps)))
                })
            });
            assert_each(around.flat_map(|value| [value; 8]), x, y);
        }
        assert_each((0..1 << 18).map(|i| i as f32 / (1 << 18) as f32), y, y);
        assert_each((i16::MIN..=i16::MAX).map(Fx16::from_bits), 0, y);
        assert_each((0..1 << 12).map(|i| Fx32::from_bits(i << 19)), 0, y);
    }
    let special = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -0.0, 0.0, 1.0, 1e-30];
    assert_each(special.into_iter().chain(special.map(|value| -value)).cycle().take(64), 0, 0);
}

/// Comparison of a cell with the definition, for one value.
#[derive(Default, Debug)]
struct Seen {
    /// The largest difference between the mean light of a cell and the value, in steps from code to
    /// code, and the sum of all differences.
    off: f64,
    sum: f64,
    /// The largest distance of a pixel from the exact code.
    pixel: f64,
    values: u32,
    /// The number of pixels so near a threshold that either code is right.
    open: u32,
}

/// Shows each value in a cell. Every pixel must have the code of the definition, and no pixel's
/// code may fall when values rise.
fn show<S: Format>(values: impl Iterator<Item = S>) -> [Seen; 3] {
    let lights = LASTS.map(lights);
    let mut seen: [Seen; 3] = Default::default();
    for value in values {
        let light = value.exact().clamp(0.0, 1.0);
        let places = [0, 1, 2].map(|which| place(&lights[which], light));
        let mut mean = [0.0; 3];
        for (x, y) in (0..64).map(|i| (i % 8, i / 8)) {
            let threshold = (f64::from(bayer(x, y, 8)) + 0.5) / 64.0;
            for (which, code) in codes(value, x, y).into_iter().enumerate() {
                let (below, part) = places[which];
                let law = below + u16::from(part > threshold);
                let is_open = (part - threshold).abs() < LEEWAY;
                assert!(
                    code == law || is_open,
                    "{value:?} at {x} {y} of {}: {code}, expected code == law or is_open",
                    LASTS[which]
                );
                let seen = &mut seen[which];
                seen.open += u32::from(is_open);
                let exact = oracle::srgb_code(light) / 255.0 * f64::from(LASTS[which]);
                seen.pixel = seen.pixel.max((f64::from(code) - exact).abs());
                mean[which] += f64::from(code - below) / 64.0;
            }
        }
        for which in 0..3 {
            let (off, seen) = (mean[which] - places[which].1, &mut seen[which]);
            seen.off = seen.off.max(off.abs());
            seen.sum += off;
            seen.values += 1;
        }
    }
    seen
}

/// The light of a cell is off by at most 1/128 of a step, no pixel is off by a whole code, and the
/// mean error over all values is zero.
fn assert_keeps_the_light(name: &str, seen: &[Seen; 3], bias: f64) {
    for (last, seen) in LASTS.into_iter().zip(seen) {
        let mean = seen.sum / f64::from(seen.values);
        println!(
            "{name} to {last} codes: {:.6} of a step, bias {mean:.1e}, a pixel {:.4}",
            seen.off, seen.pixel
        );
        assert_that!((1.0 / 128.0 - 1e-4..=0.0081).contains(&seen.off), name, last, seen.off);
        assert!((0.98..=1.0).contains(&seen.pixel), "{name} {last}: a pixel is off by {}", seen.pixel);
        assert!(mean.abs() <= bias, "{name} {last}: a bias of {mean:.1e} of a step");
        assert!(seen.open < seen.values * 64 / 20, "{name} {last}: {} pixels are left open", seen.open);
    }
}

/// Values evenly spread over the codes, so that dark values are tested as often as bright ones.
fn spread(count: u32) -> impl Iterator<Item = f64> {
    let mut rng = fastrand::Rng::with_seed(64);
    (0..count).map(move |_| oracle::srgb_linear(255.0 * rng.f64()))
}

/// Exhaustive, clipped values included.
#[test]
fn sixteen_bits_keep_the_light_of_a_cell() {
    let seen = show((-3..=(1 << 14) + 3).map(Fx16::from_bits));
    assert_keeps_the_light("fx16", &seen, 2e-4);
}

/// Searched.
#[test]
fn thirty_two_bits_keep_the_light_of_a_cell() {
    let seen = show(spread(40_000).map(|light| Fx32::from_bits((light * f64::from(1 << 30)) as i32)));
    assert_keeps_the_light("fx32", &seen, 2e-4);
}

/// Searched.
#[test]
fn f32_keeps_the_light_of_a_cell() {
    assert_keeps_the_light("f32", &show(spread(40_000).map(|light| light as f32)), 2e-4);
}

/// The number of pixels of a cell that do not show a given code.
fn others<S: Scalar>(value: S, which: usize, code: u16) -> usize {
    (0..64).filter(|i| codes(value, i % 8, i / 8)[which] != code).count()
}

/// The exact light of a code shows this code in every pixel. In `Fx16` the light of a code is
/// rounded by up to half a step of the format. Where that is more than 1/128 of the distance to the
/// next code, some pixels show another code.
#[test]
fn a_code_stays_that_code() {
    for code in 0..=255_u8 {
        let light = decode_srgb(code);
        assert_eq!(others(light, 0, code.into()), 0, "{code} of f32");
        assert_eq!(others(Fx32::from_f32(light), 0, code.into()), 0, "{code} of fx32");
    }
    for (which, last) in [(1, 63), (2, 31)] {
        let mut uneven = 0;
        for (code, light) in (0..).zip(lights(last)) {
            let light = light as f32;
            assert_eq!(others(light, which, code), 0, "{code} of {last} in f32");
            assert_eq!(others(Fx32::from_f32(light), which, code), 0, "{code} of {last} in fx32");
            uneven += usize::from(others(Fx16::from_f32(light), which, code) > 0);
        }
        assert!(uneven <= 8, "{uneven} codes of {last} in fx16");
    }
    for (value, codes_of) in [(Fx16::ZERO, [0, 0, 0]), (Fx16::ONE, LASTS)] {
        assert_eq!([0, 1, 2].map(|which| others(value, which, codes_of[which])), [0; 3]);
    }
}

fn assert_never_falls<S: Scalar>(values: impl Iterator<Item = S> + Clone) {
    for (x, y) in (0..64).map(|i| (i % 8, i / 8)) {
        let mut before = [0; 3];
        for value in values.clone() {
            let now = codes(value, x, y);
            assert!(
                (0..3).all(|which| now[which] >= before[which]),
                "{value:?} at {x} {y}: codes {now:?}, expected at least {before:?}"
            );
            before = now;
        }
    }
}

/// Exhaustive in `Fx16` from 0 to 1. In the other formats it tests values next to the light of
/// every code and every threshold, where codes could fall.
#[test]
fn no_pixel_falls_where_the_light_rises() {
    assert_never_falls((-2..=(1 << 14) + 2).map(Fx16::from_bits));
    let mut edges = Vec::new();
    for lights in LASTS.map(lights) {
        for pair in lights.windows(2) {
            let parts = (0..=128).step_by(if lights.len() > 100 { 8 } else { 1 });
            edges.extend(parts.map(|part| pair[0] + (pair[1] - pair[0]) * f64::from(part) / 128.0));
        }
    }
    edges.sort_by(f64::total_cmp);
    let beside = |light: f64| {
        (-3..=3).map(move |ulp| f32::from_bits((light as f32).to_bits().saturating_add_signed(ulp)))
    };
    let mut floats: Vec<_> =
        edges.iter().copied().flat_map(beside).filter(|value| value.is_finite()).collect();
    floats.sort_by(f32::total_cmp);
    assert_never_falls(floats.iter().copied());
    let wide = |light: f64| (-70..=70).step_by(35).map(move |off| (light * f64::from(1 << 30)) as i32 + off);
    let mut fixed: Vec<_> = edges.iter().copied().flat_map(wide).collect();
    fixed.sort_unstable();
    assert_never_falls(fixed.iter().copied().map(Fx32::from_bits));
}

#[test]
fn values_beyond_the_display_are_clipped() {
    for (x, y) in (0..64).map(|i| (i % 8, i / 8)) {
        for dark in [-1.0, -0.0, f32::NAN, -f32::NAN, f32::NEG_INFINITY, 1e-40] {
            assert_eq!(codes(dark, x, y), [0; 3], "{dark}");
        }
        for bright in [1.0, 2.0, f32::MAX, f32::INFINITY] {
            assert_eq!(codes(bright, x, y), LASTS, "{bright}");
        }
        for (value, expected) in [(Fx32::MIN, [0; 3]), (Fx32::MAX, LASTS)] {
            assert_eq!(codes(value, x, y), expected);
        }
    }
}
