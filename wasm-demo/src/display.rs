//! Conversion of linear light to displayed codes, exactly in f64.

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_clipped_to_the_display() {
        let ends = [f64::NEG_INFINITY, f64::NAN, -1.0, 0.0, 1.0, 7.0, f64::INFINITY].map(srgb_code);
        assert_eq!(ends, [0.0, 0.0, 0.0, 0.0, 255.0, 255.0, 255.0]);
    }
}
