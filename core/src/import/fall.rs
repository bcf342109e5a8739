//! The attenuation of an imported light.

use super::AnyAttenuation;
use crate::{
    attenuation::{
        CutAt, Decay, FilamentRange, InverseSquare, NoAttenuation, Polynomial, STEEPEST, Windowed,
    },
    error::{Error, Parameter, check_between},
    number::BRIGHTEST,
    trig::real_power,
};

/// The ratio of the distances between which an imported decay is compared with the original. The
/// farthest is the range, or without a range this distance itself.
const REACH: f64 = 16.0;

/// The largest coefficient and intensity.
const MOST: f32 = 1e9;

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

/// Returns the attenuation `max(d, stop)^-decay` with Filament's window for a range.
///
/// The inverse square, at a decay of 2, has no `stop`. A factor over 2^64 is 2^64.
pub(super) fn decay(decay: f32, stop: f64, range: Option<f32>, intensity: f32) -> Result<Fall, Error> {
    check_between(Parameter::Decay, decay, 0.0, STEEPEST)?;
    check_between(Parameter::Intensity, intensity, 0.0, MOST)?;
    let plain = |distance| Ok(Fall { distance, intensity, difference: 0.0 });
    if decay == 0.0 {
        return plain(AnyAttenuation::WindowedConstant(Windowed::new(NoAttenuation, range)?));
    }
    if decay == 2.0 {
        return plain(AnyAttenuation::FilamentRange(FilamentRange::new(InverseSquare, range)?));
    }
    let factor = |distance: f64| 1.0 / real_power(distance, decay.into());
    let most = factor(stop).min(BRIGHTEST.into());
    let distance = AnyAttenuation::WindowedDecay(Windowed::new(Decay::new(decay, most as f32)?, range)?);
    let near = stop.max(range.map_or(REACH, f64::from) / REACH);
    Ok(Fall { distance, intensity, difference: 1.0 - most / factor(near).max(most) })
}
