//! The attenuation of an imported light.

use super::AnyAttenuation;
use crate::{
    attenuation::{CutAt, FilamentRange, InverseSquare, NoAttenuation, Polynomial, Windowed},
    error::{Error, Parameter, check_between},
    falloff::exponent::real_power,
    search::{least_at, maximum},
};

/// The largest coefficient and intensity.
const MOST: f32 = 1e9;

/// The interval of distances in which an imported decay is compared with the original. The last
/// distance is the largest coordinate of the fixed-point formats.
const NEAREST: f64 = 0.1;
const FARTHEST: f64 = 32_767.0;

/// The largest factor on an intensity. The largest coefficient of the polynomial is 16 times this
/// factor, and must be at most 1e9.
const MOST_CAP: f32 = 6e7;

/// An attenuation of this crate that replaces an attenuation of another system.
pub(super) struct Fall {
    pub(super) distance: AnyAttenuation,
    /// The intensity, including the factor by which the attenuation was scaled.
    pub(super) intensity: f32,
    /// An upper bound of the difference from the original.
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
    let original = Decay::new(decay, stop, range);
    let cap = original.cap(stop, intensity);
    let (divisor, difference) = original.nearest(cap.into());
    let [constant, linear, quadratic] = divisor.coefficients().map(|value| value * cap);
    let polynomial = Polynomial::new(constant, linear, quadratic)?;
    let distance = AnyAttenuation::WindowedPolynomial(Windowed::new(polynomial, range)?);
    Ok(Fall { distance, intensity: (intensity * cap).min(MOST), difference })
}

/// An attenuation by a power of the distance, with Filament's window for a range.
struct Decay {
    exponent: f64,
    /// The ends of the interval of distances in which the imported attenuation is compared with the original.
    nearest: f64,
    farthest: f64,
    range: Option<f64>,
}

/// A polynomial that approximates the power of the distance.
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
    fn coefficients(self) -> [f32; 3] {
        let [low, high] = [1.0 - self.share, self.share].map(|part| (self.scale * part) as f32);
        if self.is_steep { [0.0, low, high] } else { [low, high, 0.0] }
    }

    fn value(self, distance: f64) -> f64 {
        let [constant, linear, quadratic] = self.coefficients().map(f64::from);
        constant + distance * (linear + distance * quadratic)
    }
}

/// The original attenuation at one distance.
#[derive(Clone, Copy)]
struct Sample {
    distance: f64,
    light: f64,
    window: f64,
}

impl Sample {
    /// Returns the difference between `1 / divisor`, capped, and the original at this distance.
    fn difference(self, divisor: Divisor, cap: f64) -> f64 {
        let light = (1.0 / divisor.value(self.distance)).min(cap);
        self.window * (light - self.light).abs() / (self.window * self.light.max(light)).max(1.0)
    }
}

impl Decay {
    fn new(exponent: f32, stop: f64, range: Option<f32>) -> Self {
        let nearest = stop.max(NEAREST);
        let range = range.map(f64::from);
        Self {
            exponent: exponent.into(),
            nearest,
            farthest: range.unwrap_or(FARTHEST).max(2.0 * nearest),
            range,
        }
    }

    /// Returns the cap of the attenuation factor.
    ///
    /// The cap is that of the original, or less if the scaled intensity would exceed 1e9.
    fn cap(&self, stop: f64, intensity: f32) -> f32 {
        let original = 1.0 / real_power(stop, self.exponent);
        (original as f32).min(MOST / intensity.max(MOST / MOST_CAP))
    }

    /// Returns the sample at a position in [0, 1] of the interval, on a logarithmic scale of the
    /// distance.
    fn at(&self, place: f64) -> Sample {
        let distance = self.nearest * real_power(self.farthest / self.nearest, place);
        let fraction = self.range.map_or(0.0, |range| distance / range);
        let window = (1.0 - fraction * fraction * fraction * fraction).max(0.0);
        Sample { distance, light: 1.0 / real_power(distance, self.exponent), window: window * window }
    }

    /// Returns the divisor with the smallest maximum difference, and that difference.
    ///
    /// For a given bound of the difference, the coefficients satisfy linear inequalities. So two
    /// nested one-dimensional searches find the optimum.
    fn nearest(&self, cap: f64) -> (Divisor, f64) {
        const SAMPLES: usize = 129;
        let samples: [Sample; SAMPLES] = core::array::from_fn(|i| self.at(i as f64 / (SAMPLES - 1) as f64));
        let worst = |divisor| samples.iter().map(|s| s.difference(divisor, cap)).fold(0.0, f64::max);
        let with = |share: f64, octaves: f64| {
            let scale = real_power(2.0, octaves.abs());
            let scale = if octaves < 0.0 { 1.0 / scale } else { scale };
            Divisor { is_steep: self.exponent >= 1.0, scale, share }
        };
        let scaled = |share: f64| with(share, least_at(-4.0, 4.0, |octaves| worst(with(share, octaves))));
        let divisor = if self.exponent == 1.0 {
            with(0.0, 0.0)
        } else {
            scaled(least_at(0.0, 1.0, |share| worst(scaled(share))))
        };
        let difference = maximum(0.0, 1.0, |place| self.at(place).difference(divisor, cap));
        (divisor, difference)
    }
}
