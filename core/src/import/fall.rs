//! The attenuation of an imported light.

use super::AnyAttenuation;
use crate::{
    attenuation::{CutAt, FilamentRange, InverseSquare, NoAttenuation, Polynomial, Windowed},
    error::{Error, Parameter, check_between},
    search::maximum,
    trig::real_power,
};

/// The largest coefficient and intensity.
const MOST: f32 = 1e9;

/// The ratio of the distances between which an imported decay is close to the original. The farthest
/// is the range, or without a range this distance itself.
const REACH: f64 = 16.0;

/// An attenuation of this crate that replaces an attenuation of another system.
pub(super) struct Fall {
    pub(super) distance: AnyAttenuation,
    /// The intensity, including the factor by which the attenuation was scaled.
    pub(super) intensity: f32,
    /// The largest relative difference from the original.
    pub(super) difference: f64,
}

/// Returns the attenuation `1 / (a0 + a1 d + a2 d^2)`, uncapped.
///
/// If the constant `a0` is small or 0, points at a distance below 0.001 get the light of a point at
/// distance 0.001.
pub(super) fn polynomial(coefficients: [f32; 3], range: Option<f32>, intensity: f32) -> Result<Fall, Error> {
    for value in coefficients {
        check_between(Parameter::Attenuation, value, 0.0, MOST)?;
    }
    check_between(Parameter::Intensity, intensity, 0.0, MOST)?;
    let [constant, linear, quadratic] = coefficients;
    check_between(Parameter::Attenuation, constant.max(linear).max(quadratic), 1e-6, MOST)?;
    let (distance, scale) = if linear == 0.0 && quadratic == 0.0 {
        (AnyAttenuation::Constant(CutAt::new(NoAttenuation, range)?), 1.0 / constant)
    } else if constant == 0.0 && linear == 0.0 {
        (AnyAttenuation::InverseSquare(CutAt::new(InverseSquare, range)?), 1.0 / quadratic)
    } else {
        // [`Polynomial`] is capped at 1. The coefficients and the intensity are scaled so that the
        // cap never applies.
        const NEAREST: f32 = 1e-3;
        let has_constant = linear.max(quadratic) <= MOST * constant;
        let least = if has_constant { constant } else { constant + NEAREST * (linear + NEAREST * quadratic) };
        let polynomial = Polynomial::new(constant / least, linear / least, quadratic / least)?;
        (AnyAttenuation::Polynomial(CutAt::new(polynomial, range)?), 1.0 / least)
    };
    Ok(Fall { distance, intensity: intensity * scale, difference: 0.0 })
}

/// Returns the attenuation `d^-decay` with Filament's window for a range.
///
/// `stop` is the distance below which the original attenuation stops growing.
pub(super) fn decay(decay: f32, stop: f64, range: Option<f32>, intensity: f32) -> Result<Fall, Error> {
    check_between(Parameter::Decay, decay, 0.0, 16.0)?;
    check_between(Parameter::Intensity, intensity, 0.0, MOST)?;
    if decay == 0.0 {
        let distance = AnyAttenuation::WindowedConstant(Windowed::new(NoAttenuation, range)?);
        return Ok(Fall { distance, intensity, difference: 0.0 });
    }
    if decay == 2.0 {
        let distance = AnyAttenuation::FilamentRange(FilamentRange::new(InverseSquare, range)?);
        return Ok(Fall { distance, intensity, difference: 0.0 });
    }
    let exponent = f64::from(decay);
    let far = range.map_or(REACH, f64::from);
    let near = stop.max(far / REACH);
    let far = far.max(2.0 * near);
    let divisor = Divisor::nearest(exponent, near, far);
    // The cap is that of the original, or less if the intensity or a coefficient would exceed 1e9.
    let original_cap = (1.0 / real_power(stop, exponent)) as f32;
    let coefficients = divisor.coefficients();
    let largest = coefficients.into_iter().fold(0.0, f32::max);
    let cap = original_cap.min(MOST / intensity).min(MOST / largest);
    let difference = maximum(0.0, 1.0, |place| {
        let distance = near * real_power(far / near, place);
        let exact = 1.0 / real_power(distance, exponent);
        let found = (1.0 / divisor.value(distance)).min(cap.into());
        (found - exact).abs() / found.max(exact)
    });
    let [constant, linear, quadratic] = coefficients.map(|value| (value * cap).min(MOST));
    let polynomial = Polynomial::new(constant, linear, quadratic)?;
    let distance = AnyAttenuation::WindowedPolynomial(Windowed::new(polynomial, range)?);
    Ok(Fall { distance, intensity: (intensity * cap).min(MOST), difference })
}

/// A polynomial that approximates a power of the distance.
///
/// The polynomial is `scale ((1 - share) d^n + share d^(n + 1))`, with `n` of 0 or 1.
#[derive(Clone, Copy)]
struct Divisor {
    /// Whether `n` is 1; otherwise it is 0.
    is_steep: bool,
    scale: f64,
    share: f64,
}

impl Divisor {
    /// Returns the polynomial whose ratio to the power is closest to 1 between two distances.
    ///
    /// Above 2 no polynomial is close to the power: the result is the square, which is equal to the
    /// power at distance 1.
    fn nearest(exponent: f64, near: f64, far: f64) -> Self {
        let is_steep = exponent >= 1.0;
        let part = if is_steep { exponent - 1.0 } else { exponent };
        if part == 0.0 || part > 1.0 {
            return Self { is_steep, scale: 1.0, share: if part > 1.0 { 1.0 } else { 0.0 } };
        }
        // The ratio is largest at both ends and smallest between them. The share makes it equal at
        // both ends, and the scale makes its extremes reciprocal.
        let rest = 1.0 - part;
        let fall = 1.0 / real_power(near, part) - 1.0 / real_power(far, part);
        let rise = real_power(far, rest) - real_power(near, rest);
        let share = fall / (fall + rise);
        let ratio = |d: f64| (1.0 - share + share * d) / real_power(d, part);
        let lowest = part * (1.0 - share) / (rest * share);
        let scale = 1.0 / real_power(ratio(near) * ratio(lowest.max(near).min(far)), 0.5);
        Self { is_steep, scale, share }
    }

    fn coefficients(self) -> [f32; 3] {
        let [low, high] = [1.0 - self.share, self.share].map(|part| (self.scale * part) as f32);
        if self.is_steep { [0.0, low, high] } else { [low, high, 0.0] }
    }

    fn value(self, distance: f64) -> f64 {
        let [constant, linear, quadratic] = self.coefficients().map(f64::from);
        constant + distance * (linear + distance * quadratic)
    }
}
