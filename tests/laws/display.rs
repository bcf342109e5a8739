//! From light to the display: fitting to full scale changes no light that fits.

use super::format::Format;
use super::words::Words;
use luminaire::{
    Rgb,
    display::{Exposure, clip, compress_keep_hue},
};

/// Light within full scale is changed neither by clipping, nor by compressing, nor by an exposure
/// of 1. Beyond full scale, clipping limits each channel to 1, and compressing divides all channels
/// by the brightest.
pub fn fitting_keeps_what_fits<S: Format>(words: &[u32]) {
    let words = &mut Words::new(words);
    let [red, green, blue] =
        [(); 3].map(|()| S::from_f32(words.number(0.0, 1.0)).light(S::gain(words.number(0.0, 3.0))));
    let light = Rgb::new(red, green, blue);
    let exposure = Exposure::factor(1.0).expect("one is accepted").compile::<S>();
    assert_eq!(exposure.expose(light), light);
    let (clipped, kept) = (clip(light), compress_keep_hue(light));
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
