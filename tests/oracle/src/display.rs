//! sRGB, and errors in linear codes.

/// The sRGB code of a linear value in [0, 1], before it is rounded (IEC 61966-2-1).
pub fn srgb_code(linear: f64) -> f64 {
    let value =
        if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 };
    255.0 * value
}

/// The linear value of an sRGB code.
pub fn srgb_linear(code: f64) -> f64 {
    let value = code / 255.0;
    if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
}

/// The error of a light in linear codes: 1 is 1/255 of full scale, or of the light itself where that
/// is more. NaN counts as an infinite error.
pub fn linear_codes(found: f64, exact: f64) -> f64 {
    counted(255.0 * (found - exact).abs() / exact.max(1.0))
}

/// Returns an error for a maximum, which would ignore NaN: NaN is an infinite error.
pub fn counted(error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { error }
}
