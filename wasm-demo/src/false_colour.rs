//! False colours for errors: a palette ordered by lightness, and a scale for it.

use crate::display::srgb_code;

/// The colours of the palette.
pub(crate) const COLOURS: usize = 256;

/// The possible ends of a scale, in displayed codes: 1, 2 and 5 times every power of ten, up to the
/// range of a display.
pub(crate) const ENDS: [f64; 17] =
    [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 255.0];

/// Lightness of the colours for zero error and for the end of the scale.
const LIGHTNESS: [f64; 2] = [0.16, 0.96];
/// Hue of the colours for zero error and for the end of the scale, in degrees: from blue through
/// magenta and orange to yellow.
const HUE: [f64; 2] = [255.0, 470.0];
/// Chroma at both ends, and its increase in the middle.
const CHROMA: [f64; 2] = [0.02, 0.18];

/// A palette from nearly black (no error) to nearly white (end of the scale). Lightness rises
/// uniformly, so that the order is visible without hue and equal steps look equal.
#[derive(Clone, Debug)]
pub(crate) struct Palette([[u8; 3]; COLOURS]);

/// A scale of errors, from zero to the end of the palette.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Scale {
    /// This value and all larger ones have the last colour.
    pub(crate) end: f64,
}

impl Palette {
    /// The palette, computed in Oklch (B. Ottosson, *A perceptual color space for image
    /// processing*, 2020).
    pub(crate) fn new() -> Self {
        Self(std::array::from_fn(|i| linear(i as f64 / (COLOURS - 1) as f64).map(code)))
    }

    /// The colours in order: red, green, blue in sRGB.
    pub(crate) fn colours(&self) -> &[[u8; 3]] {
        &self.0
    }

    /// Returns the colour of an error. Errors beyond the end of the scale have the last colour.
    pub(crate) fn colour(&self, scale: Scale, error: f32) -> [u8; 3] {
        let place = f64::from(error) / scale.end * (COLOURS - 1) as f64;
        self.0[(place.round() as usize).min(COLOURS - 1)]
    }
}

impl Scale {
    /// Returns the narrowest scale of [`ENDS`] that holds an error.
    pub(crate) fn holding(largest: f64) -> Self {
        let last = ENDS[ENDS.len() - 1];
        Self { end: ENDS.into_iter().find(|&end| end >= largest).unwrap_or(last) }
    }

    /// A scale that ends at `end`, in any unit.
    pub(crate) fn to(end: f64) -> Self {
        Self { end }
    }

    /// Returns the scale that ends at `codes`, if it is one of [`ENDS`].
    pub(crate) fn ending_at(codes: f64) -> Option<Self> {
        ENDS.contains(&codes).then_some(Self { end: codes })
    }

    /// Returns the magnification of the errors: the range of the display divided by the range of
    /// the scale.
    pub(crate) fn gain(self) -> f64 {
        255.0 / self.end
    }
}

/// Returns colours as the bytes of a picture: RGBA.
pub(crate) fn rgba(colours: impl Iterator<Item = [u8; 3]>) -> Vec<u8> {
    let pixels: Vec<_> = colours.map(|[red, green, blue]| [red, green, blue, u8::MAX]).collect();
    pixels.into_flattened()
}

/// Returns the linear red, green and blue at a position in [0, 1] on the palette.
fn linear(place: f64) -> [f64; 3] {
    let between = |[from, to]: [f64; 2]| from + (to - from) * place;
    let lightness = between(LIGHTNESS);
    let chroma = CHROMA[0] + CHROMA[1] * 4.0 * place * (1.0 - place);
    let (sine, cosine) = libm::sincosf(between(HUE).to_radians() as f32);
    let (a, b) = (chroma * f64::from(cosine), chroma * f64::from(sine));
    let l = lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b;
    let m = lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b;
    let s = lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b;
    let [l, m, s] = [l, m, s].map(|root| root.powi(3));
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ]
}

fn code(linear: f64) -> u8 {
    srgb_code(linear).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire::display::decode_srgb;

    /// Returns the lightness of a colour: L* of CIE 1976, from 0 to 100.
    fn lightness([red, green, blue]: [f64; 3]) -> f64 {
        let luminance = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
        if luminance > 0.008_856 { 116.0 * luminance.cbrt() - 16.0 } else { 903.3 * luminance }
    }

    /// Matrices that simulate how an eye without the cones for red, green or blue sees a linear
    /// colour: F. Viénot, H. Brettel and J. Mollon, *Digital Video Colourmaps for Checking the
    /// Legibility of Displays by Dichromats*, 1999; for blue the same construction.
    const BLINDNESS: [[[f64; 3]; 3]; 3] = [
        [[0.112_38, 0.887_62, 0.0], [0.112_38, 0.887_62, 0.0], [0.004_01, -0.004_01, 1.0]],
        [[0.292_75, 0.707_25, 0.0], [0.292_75, 0.707_25, 0.0], [-0.022_34, 0.022_34, 1.0]],
        [[1.0, 0.144_61, -0.144_61], [0.0, 0.859_24, 0.140_76], [0.0, 0.859_24, 0.140_76]],
    ];

    #[test]
    fn every_colour_can_be_displayed() {
        for i in 0..=1000 {
            let colour = linear(f64::from(i) / 1000.0);
            assert!(colour.iter().all(|c| (0.0..=1.0).contains(c)), "{i}: {colour:?}");
        }
    }

    #[test]
    fn the_order_is_seen_by_everybody() {
        let palette = Palette::new();
        let colours: Vec<[f64; 3]> =
            palette.colours().iter().map(|colour| colour.map(|c| f64::from(decode_srgb::<f32>(c)))).collect();
        let seen = |kind: Option<&[[f64; 3]; 3]>, colour: &[f64; 3]| match kind {
            None => *colour,
            Some(rows) => {
                rows.map(|row| row.iter().zip(colour).map(|(a, b)| a * b).sum::<f64>().clamp(0.0, 1.0))
            }
        };
        for kind in [None].into_iter().chain(BLINDNESS.iter().map(Some)) {
            let levels: Vec<f64> = colours.iter().map(|colour| lightness(seen(kind, colour))).collect();
            // An eighth of the scale is 12 units of lightness to normal sight. To every simulated
            // eye it is more than half and less than twice as many.
            let steps: Vec<f64> =
                levels.windows(33).step_by(16).map(|window| window[32] - window[0]).collect();
            let least = steps.iter().copied().fold(f64::INFINITY, f64::min);
            let most = steps.iter().copied().fold(0.0, f64::max);
            assert!(least > 6.5 && most < 18.0, "{kind:?}: from {least} to {most}");
        }
    }

    #[test]
    fn no_error_has_the_first_colour_and_the_end_the_last() {
        let palette = Palette::new();
        let scale = Scale::ending_at(5.0).unwrap();
        let [first, .., last] = palette.colours() else { panic!("no colours") };
        assert_eq!([0.0, f32::NAN].map(|error| palette.colour(scale, error)), [*first; 2]);
        assert_eq!([5.0, 6.0, f32::INFINITY].map(|error| palette.colour(scale, error)), [*last; 3]);
        let middle = palette.colour(scale, 2.5);
        assert!(middle != *first && middle != *last);
    }

    #[test]
    fn a_scale_is_as_narrow_as_its_error_lets_it() {
        for (largest, end) in [
            (0.0, 0.001),
            (0.001, 0.001),
            (0.24, 0.5),
            (1.0, 1.0),
            (44.5, 50.0),
            (101.0, 255.0),
            (255.0, 255.0),
        ] {
            assert_eq!(Scale::holding(largest).end, end, "{largest}");
        }
        assert_eq!(Scale::ending_at(50.0).unwrap().gain(), 5.1);
        assert_eq!([0.0, 3.0, -1.0, f64::NAN, 1e9].map(Scale::ending_at), [None; 5]);
    }
}
