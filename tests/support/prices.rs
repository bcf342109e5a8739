//! The table of error bounds of attenuation, highlight and the complete lit point. Errors are
//! searched and compared as in [`bounds`](super::bounds), two-sided.

/// The bounds of one model in `f32`, `Fx32` and `Fx16`, in this order.
pub struct Row {
    pub model: &'static str,
    pub bounds: [f64; 3],
}

/// The error of a point light at 0.02 to 1.1 times its range; with an inverse square it has full
/// scale at half the range. The error is relative to full scale, or to the light that would arrive
/// without a window if that is more.
#[rustfmt::skip]
pub const DISTANCE: [Row; 6] = [
    Row { model: "unattenuated",      bounds: [2.9e-7, 4.2e-8, 1.1e-4] },
    Row { model: "inverse square",    bounds: [6.6e-7, 9.9e-8, 3.9e-4] },
    Row { model: "polynomial",        bounds: [4.4e-7, 4.1e-8, 1.5e-4] },
    Row { model: "smooth range",      bounds: [3.6e-7, 8.0e-8, 1.9e-4] },
    Row { model: "glTF range",        bounds: [6.6e-7, 9.5e-8, 3.5e-4] },
    Row { model: "Filament range",    bounds: [6.7e-7, 9.5e-8, 3.8e-4] },
];

/// The error of a highlight, from positions and a normal as the format stores them, at shininess 2,
/// 32 and 256.
#[rustfmt::skip]
pub const HIGHLIGHT: [Row; 12] = [
    Row { model: "phong 2",         bounds: [3.5e-7, 1.5e-7, 2.2e-4] },
    Row { model: "phong 32",        bounds: [2.0e-6, 4.1e-7, 5.7e-4] },
    Row { model: "phong 256",       bounds: [1.4e-5, 1.7e-6, 1.5e-3] },
    Row { model: "blinn-phong 2",   bounds: [2.3e-7, 3.1e-8, 1.7e-4] },
    Row { model: "blinn-phong 32",  bounds: [1.9e-6, 1.9e-7, 2.7e-4] },
    Row { model: "blinn-phong 256", bounds: [1.3e-5, 1.6e-6, 6.2e-4] },
    Row { model: "dual cone 2",     bounds: [3.1e-7, 7.4e-8, 1.8e-4] },
    Row { model: "dual cone 32",    bounds: [1.9e-6, 2.9e-7, 3.8e-4] },
    Row { model: "dual cone 256",   bounds: [1.3e-5, 1.5e-6, 6.8e-4] },
    Row { model: "difference-form 4",   bounds: [4.5e-7, 1.7e-7, 4.5e-4] },
    Row { model: "difference-form 32",  bounds: [1.0e-6, 4.0e-7, 6.7e-4] },
    Row { model: "difference-form 256", bounds: [2.7e-6, 1.1e-6, 1.6e-3] },
];

/// The complete lit point of the classic equation, with an ambient light, a spotlight and a shiny
/// material. The errors are that of the linear light, and that of the display code against the
/// exact code before rounding.
#[rustfmt::skip]
pub const LIT: [Row; 2] = [
    Row { model: "lit point, linear", bounds: [4.7e-7, 9.4e-8, 2.3e-4] },
    Row { model: "lit point, codes",  bounds: [5.4e-1, 5.3e-1, 6.2e-1] },
];

/// Largest difference between Lyon's form and the power that it approximates, by the number of
/// squarings, at shininess 16, 64 and 256: a property of the form, in exact arithmetic.
#[rustfmt::skip]
pub const LYON: [(u32, [f64; 3]); 3] = [
    (2, [5.7e-2, 7.0e-2, 7.3e-2]),
    (3, [1.9e-2, 3.2e-2, 3.5e-2]),
    (4, [1.0e-15, 1.4e-2, 1.7e-2]),
];
