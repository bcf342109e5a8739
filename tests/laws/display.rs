//! From light to the display: codes rise with the light, and fitting to full scale changes no light
//! that fits.

use super::format::Format;
use super::words::Words;
use luminaire::{
    Rgb,
    display::{Exposure, Rgb565, clip, compress_keep_hue, encode_srgb, encode_srgb_dithered},
};

/// For scalars of any bits, the larger of two never has the smaller code.
pub fn codes_never_fall<S: Format>(words: &[u32]) {
    let words = &mut Words::tame(words);
    let (a, b) = (S::scalar_from_bits(words.wide()), S::scalar_from_bits(words.wide()));
    let (less, more) = if a < b { (a, b) } else { (b, a) };
    // Comparisons with NaN are false.
    if less <= more {
        assert!(
            encode_srgb(less) <= encode_srgb(more),
            "{less:?} {more:?}, expected encode_srgb(less) <= encode_srgb(more)"
        );
        let gray = |value: S| Rgb565::from_linear(Rgb::new(value, value, value)).to_codes();
        let (low, high) = (gray(less), gray(more));
        assert!(low.red <= high.red && low.green <= high.green && low.blue == low.red, "{less:?} {more:?}");
        let (x, y) = (words.wide() as u32, words.wide() as u32);
        let dithered = |value: S| {
            let gray = Rgb::new(value, value, value);
            let pixel = Rgb565::from_linear_dithered(gray, x, y);
            assert_eq!(pixel, Rgb565::from_linear_dithered_fast(gray, x, y), "{value:?} at {x} {y}");
            let pixel = pixel.to_codes();
            [encode_srgb_dithered(value, x, y), pixel.red, pixel.green]
        };
        let (low, high) = (dithered(less), dithered(more));
        assert!(
            (0..3).all(|which| low[which] <= high[which]),
            "{less:?} gives {low:?} and {more:?} gives {high:?} at {x} {y}, expected no less"
        );
    }
}

/// Light within full scale is changed neither by clipping, nor by compressing, nor by an exposure
/// of 1. Beyond full scale, clipping limits each channel to 1, and compressing divides all channels
/// by the brightest.
pub fn fitting_keeps_what_fits<S: Format>(words: &[u32]) {
    let words = &mut Words::new(words);
    let [red, green, blue] =
        [(); 3].map(|()| S::from_f32(words.number(0.0, 1.0)).expose(S::gain(words.number(0.0, 3.0))));
    let light = Rgb::new(red, green, blue);
    let exposure = Exposure::factor(1.0).expect("one is accepted").compile::<S>();
    assert_eq!(exposure.expose(light), light);
    let (clipped, kept) = (clip::<S>(light), compress_keep_hue::<S>(light));
    let all = |color: Rgb<S>| [color.red, color.green, color.blue].map(S::exact);
    let lights = [red, green, blue].map(S::exact_light);
    let brightest = lights.into_iter().fold(0.0, f64::max);
    if brightest <= 1.0 {
        assert_eq!(all(clipped), lights);
        assert_eq!(kept, clipped);
        return;
    }
    for (index, light) in lights.into_iter().enumerate() {
        assert_eq!(all(clipped)[index], light.min(1.0));
        let off = (all(kept)[index] - light / brightest).abs() / f64::from(S::STEP);
        let steps = match S::NAME {
            "f32" => 1.0,
            "fx32" => 8.0,
            _ => 2.0,
        };
        assert!(off <= steps, "{light:?} of {lights:?} is off by {off} steps");
    }
}
