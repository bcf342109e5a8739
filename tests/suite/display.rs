//! The encoding for the display: back from a code, of many values at once, and exactly on a threshold of
//! the dither.

use luminaire::{
    Fx16, Fx32, Rgb,
    display::{
        Rgb565, decode_srgb, encode_srgb, encode_srgb_dithered, encode_srgb_dithered_each, encode_srgb_each,
    },
};
use support::{format::Format, oracle};

use crate::outputs::bayer;

/// Every code decodes to a linear value that encodes to it again, within the stated error of the
/// standard.
#[test]
fn every_code_comes_back() {
    fn largest<S: Format>() -> f64 {
        let codes = (0..=255).map(|code| {
            let linear = decode_srgb::<S>(code);
            assert_eq!(encode_srgb(linear), code, "{}", S::NAME);
            (linear.exact() - oracle::srgb_linear(code.into())).abs()
        });
        codes.fold(0.0, f64::max)
    }
    let [single, fx32, fx16] = [largest::<f32>(), largest::<Fx32>(), largest::<Fx16>()];
    assert!((1e-6..=2e-6).contains(&single), "{single:.2e}");
    // Half a step of the table, and half a step of the format: the table rounds no code past a middle.
    assert!((1.5e-8..=2.0_f64.powi(-25)).contains(&fx32), "{fx32:.2e}");
    assert!((2.9e-5..=2.0_f64.powi(-15)).contains(&fx16), "{fx16:.2e}");
}

/// Encoding many values at once gives the code of each, on both sides of every threshold and
/// outside the range.
#[test]
fn encoding_many_is_encoding_each() {
    fn assert_each<S: Format>(values: impl IntoIterator<Item = S>) {
        let values: Vec<_> = values.into_iter().collect();
        for block in values.as_chunks::<16>().0 {
            assert_eq!(encode_srgb_each(block), block.map(encode_srgb), "{block:?}");
        }
    }
    let thresholds = (0..255).map(|code| oracle::srgb_linear(f64::from(code) + 0.5) as f32);
    let around = thresholds
        .flat_map(|t| (-8..8).map(move |ulps| f32::from_bits(t.to_bits().wrapping_add_signed(ulps))));
    assert_each(around);
    assert_each((0..1 << 20).map(|i| i as f32 / (1 << 20) as f32));
    let special = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -0.0, 0.0, 1.0, 1e-30];
    assert_each(special.into_iter().chain(special.map(|value| -value)));
    assert_each((i16::MIN..=i16::MAX).map(Fx16::from_bits));
    assert_each((0..1 << 16).map(|i| Fx32::from_bits(i << 15)));
    let steps = (0..255).map(|code| (oracle::srgb_linear(f64::from(code) + 0.5) * f64::from(1 << 30)) as i32);
    assert_each(steps.flat_map(|step| (-8..8).map(move |i| Fx32::from_bits(step + i))));
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

/// Encoding many values at once with dither gives the code of each, on both sides of every threshold of
/// every pixel of a cell, and outside the range; and so does the fast dither of RGB565.
#[test]
fn encoding_many_dithered_is_encoding_each() {
    fn assert_each<S: Format>(values: impl IntoIterator<Item = S>, x: u32, y: u32) {
        let values: Vec<_> = values.into_iter().collect();
        for (block, at) in values.as_chunks::<32>().0.iter().zip((0..).map(|block| x.wrapping_add(5 * block)))
        {
            let mut place = at;
            let codes = block.map(|value| {
                let gray = Rgb::new(value, value, value);
                let fast = Rgb565::from_linear_dithered_fast(gray, place, y);
                assert_eq!(fast, Rgb565::from_linear_dithered(gray, place, y), "{value:?} at {place}, {y}");
                place = place.wrapping_add(1);
                encode_srgb_dithered(value, place.wrapping_sub(1), y)
            });
            assert_eq!(encode_srgb_dithered_each(block, at, y), codes, "{block:?} at {at}, {y}");
        }
    }
    let lights: Vec<_> = (0..=255_u8).map(|code| oracle::srgb_linear(code.into())).collect();
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
        for x in 0..8 {
            assert_each((i16::MIN..=i16::MAX).map(Fx16::from_bits), x, y);
        }
        assert_each((0..1 << 15).map(|i| Fx32::from_bits(i << 16)), 0, y);
        // On both sides of every threshold of the codes of RGB565 and of eight bits. The tables have units of 2^-24: 64
        // steps of `Fx32`.
        for (last, column) in
            [31, 63, 255].into_iter().flat_map(|last| (0..8).map(move |column| (last, column)))
        {
            let light = |code| oracle::srgb_linear(f64::from(code) * 255.0 / f64::from(last));
            let part = f64::from(2 * bayer(column, y, 8) + 1) / 128.0;
            let past = (0..last).map(|code| light(code) + part * (light(code + 1) - light(code)));
            let near = |value: f64| (-4..4).map(move |unit| ((value * 16_777_216.0) as i32 + unit) << 6);
            assert_each(
                past.flat_map(near).flat_map(|bits| [[bits - 1; 8], [bits; 8]].concat()).map(Fx32::from_bits),
                column,
                y,
            );
        }
    }
    let special = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -0.0, 0.0, 1.0, 1e-30];
    assert_each(special.into_iter().chain(special.map(|value| -value)).cycle().take(64), 0, 0);
}

/// Every pixel is restored from its codes, and every code converts to the nearest pixel.
#[test]
fn pixels_are_the_nearest() {
    for pixel in (0..=u16::MAX).map(Rgb565) {
        assert_eq!(Rgb565::from_codes(pixel.to_codes()), pixel);
    }
    for code in 0..=255_u8 {
        let Rgb565(pixel) = Rgb565::from_codes(Rgb::new(code, code, code));
        for (found, last) in [(pixel >> 11, 31), (pixel >> 5 & 63, 63), (pixel & 31, 31)] {
            let off = |level: u16| (f64::from(level) / f64::from(last) - f64::from(code) / 255.0).abs();
            assert!((0..=last).all(|level| off(found) <= off(level)), "{code} as one of {last}");
        }
    }
}
