//! Conversion of linear light to displayed codes: by the encoder of a format, and exactly in f64.

use luminaire::number::{Light16, Light32};
use luminaire::{
    Fx16, Fx32, Rgb,
    display::{clip, encode_srgb},
};
use luminaire_kernels::Value;

/// Returns the sRGB code of a linear value, before rounding, clipped to [0, 255]. NaN is dark.
pub(crate) fn srgb_code(linear: f64) -> f64 {
    if linear >= 1.0 {
        255.0
    } else if linear > 0.0 {
        luminaire_oracle::srgb_code(linear)
    } else {
        0.0
    }
}

/// Light of a number format, with the display encoder of that format.
pub(crate) trait Shown: Value {
    /// The sRGB code, clipped at full scale.
    fn code(self) -> u8;
}

impl Shown for f32 {
    fn code(self) -> u8 {
        encode_srgb(self)
    }
}

impl Shown for f64 {
    fn code(self) -> u8 {
        srgb_code(self).round() as u8
    }
}

impl Shown for Light16 {
    fn code(self) -> u8 {
        encode_srgb(clip::<Fx16>(Rgb::new(self, self, self)).red)
    }
}

impl Shown for Light32 {
    fn code(self) -> u8 {
        encode_srgb(clip::<Fx32>(Rgb::new(self, self, self)).red)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_clipped_to_the_display() {
        let ends = [f64::NEG_INFINITY, f64::NAN, -1.0, 0.0, 1.0, 7.0, f64::INFINITY].map(srgb_code);
        assert_eq!(ends, [0.0, 0.0, 0.0, 0.0, 255.0, 255.0, 255.0]);
    }
}
