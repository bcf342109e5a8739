//! Intensity over the distance.

/// An attenuation over the distance, without a light's intensity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Attenuation {
    /// The same at every distance.
    None,
    /// The law of a small source.
    InverseSquare,
    /// `1 / (a0 + a1 d + a2 d^2)`, capped at 1: OpenGL, Direct3D.
    Polynomial([f64; 3]),
    /// `min(d^-k, most)` with `[k, most]`: three.js, Godot.
    Decay([f64; 2]),
    /// GLSL's smoothstep with its edges in rising order, from the range back to 0.
    SmoothRange(f64),
    /// The inverse square to a range: KHR_lights_punctual of glTF.
    GltfRange(f64),
    /// The inverse square to a range: Filament, Bevy, three.js.
    FilamentRange(f64),
    /// `(1 - (d/r)^2)^n` within the range, with `[r, n]`: TGX (2), embedded-3dgfx (1).
    SquareWindow([f64; 2]),
}

impl Attenuation {
    /// The factor at a distance.
    pub fn at(self, d: f64) -> f64 {
        match self {
            Self::None => 1.0,
            Self::InverseSquare => 1.0 / (d * d),
            Self::Polynomial([a0, a1, a2]) => (1.0 / (a0 + a1 * d + a2 * d * d)).min(1.0),
            Self::Decay([exponent, most]) => libm::pow(d, -exponent).min(most),
            Self::SmoothRange(range) => crate::smooth((1.0 - d / range).clamp(0.0, 1.0)),
            Self::GltfRange(range) => window(d / range) / (d * d),
            Self::SquareWindow([range, power]) => libm::pow((1.0 - d * d / (range * range)).max(0.0), power),
            Self::FilamentRange(range) => window(d / range) * window(d / range) / (d * d),
        }
    }
}

/// `1 - x^4`, and nothing beyond 1.
fn window(x: f64) -> f64 {
    (1.0 - crate::power_4(x)).clamp(0.0, 1.0)
}
