//! Falloffs as data.

use crate::{model::MOST_NUMBERS, number::Knot};

/// The formula of a falloff as data, for reference values and generated code. The formula is a
/// function of `t` in [0, 1], and 0 at `t = 0`.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Formula<'a> {
    /// 1 for `t > 0`.
    Step,
    /// `t (a + t (b + t c))` with `[a, b, c]`.
    Polynomial([f32; 3]),
    /// `t^p` with `p`.
    Power(f32),
    /// `(1 - max(u, f)^p) / (1 - f^p)` with `u = 1 - t`, the exponent `p` and the floor `f`. `f` is
    /// 0 except for lights imported from Godot; for `p < 1` the floor keeps the derivative with
    /// respect to `t` finite at `t = 1`.
    InvertedPower(f32, f32),
    /// `(1 - k) t^2 + k max(0, 1 - g (1 - t))^2` with `[k, g]`.
    SoftPair([f32; 2]),
    /// Linear interpolation between evenly spaced samples over `1 - t`; 65,535 is full intensity.
    Samples(&'a [u16]),
    /// Linear interpolation between knots over `1 - t`.
    Knots(&'a [Knot]),
    /// Any other function of the falloff's numbers and `t`, in f64; and these numbers.
    Function(fn([f32; MOST_NUMBERS], f64) -> f64, [f32; MOST_NUMBERS]),
}

impl Formula<'_> {
    /// Returns the name of the variant in data.
    #[cfg(feature = "arithmetic")]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Polynomial(_) => "polynomial",
            Self::Power(_) => "power",
            Self::InvertedPower(..) => "inverted-power",
            Self::SoftPair(_) => "soft-pair",
            Self::Samples(_) => "samples",
            Self::Knots(_) => "knots",
            Self::Function(..) => "named",
        }
    }
}

#[cfg(feature = "libm")]
impl Formula<'_> {
    /// Evaluates the formula in f64 as the variant's description states it: the reference for error
    /// measurements.
    pub fn exact(&self, t: f64) -> f64 {
        let power = |x: f64, exponent: f32| libm::pow(x, exponent.into());
        if t <= 0.0 {
            return 0.0;
        }
        match *self {
            Self::Step => 1.0,
            Self::Polynomial(coefficients) => {
                let [a, b, c] = coefficients.map(f64::from);
                t * (a + t * (b + t * c))
            }
            Self::Power(exponent) => power(t, exponent),
            Self::InvertedPower(exponent, floor) => {
                let lack = power((1.0 - t).max(floor.into()), exponent);
                (1.0 - lack) / (1.0 - power(floor.into(), exponent))
            }
            Self::SoftPair(numbers) => {
                let [share, ratio] = numbers.map(f64::from);
                let narrow = (1.0 - ratio * (1.0 - t)).max(0.0);
                (1.0 - share) * t * t + share * narrow * narrow
            }
            Self::Samples(samples) => interpolated(samples, 1.0 - t),
            Self::Knots(knots) => sample_knots(knots, 1.0 - t),
            Self::Function(exact, numbers) => exact(numbers, t),
        }
    }
}

/// Interpolates linearly between evenly spaced samples.
#[cfg(feature = "libm")]
fn interpolated(samples: &[u16], u: f64) -> f64 {
    let place = u * samples.len().saturating_sub(1) as f64;
    let index = (place as usize).min(samples.len().saturating_sub(2));
    let [from, to] = [index, index + 1].map(|i| samples.get(i).copied().map_or(0.0, f64::from));
    (from + (to - from) * (place - index as f64)) / 65_535.0
}

/// Evaluates the line that starts at the last knot at or before `u`.
#[cfg(feature = "libm")]
fn sample_knots(knots: &[Knot], u: f64) -> f64 {
    let place = u * 65_536.0;
    let knot = knots.iter().rev().find(|knot| f64::from(knot.start()) <= place);
    let line = knot.map_or(0.0, |knot| {
        let (start, value, slope) = knot.to_bits();
        f64::from(value) + f64::from(slope) / 32_768.0 * (place - f64::from(start))
    });
    (line / 65_535.0).clamp(0.0, 1.0)
}
