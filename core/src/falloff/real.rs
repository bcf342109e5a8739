//! Powers with a non-integer exponent.

use super::{
    CompiledFalloff, Falloff, Formula,
    integer::{MOST, lost_after},
};
use crate::{
    error::{Error, Expected, Parameter},
    model::{Model as _, Number, model},
    number::{Fraction, HALF_A_CODE, RealExponent, Scalar},
    source::written_by_bits,
    trig::{self, real_power},
};

model! {
    /// The power `t^p` with a non-integer exponent `p` in (0, 1024].
    ///
    /// The power is evaluated in integers, by a logarithm and an exponential from tables. For integer
    /// exponents [`IntegerPower`](super::IntegerPower) costs less.
    ///
    /// For `p < 1` the derivative with respect to `t` at the edge is infinite. At this edge a format
    /// bounds the error of the position, and not of the intensity.
    RealPower {
        /// Returns the exponent.
        exponent: f32 = exponent(2.25);
    } by Self::new(exponent)
}

model! {
    /// The inverted power `1 - u^p` with a non-integer exponent `p` in (0, 1024], the mirror image of
    /// [`RealPower`]. For `p < 1` the inverted power has a sharp peak on the axis.
    ///
    /// Godot's cones have a floor of `u`: `(1 - max(u, floor)^p) / (1 - floor^p)`.
    InvertedRealPower {
        /// Returns the exponent.
        exponent: f32 = exponent(2.5);
        /// Returns the floor: the `u` up to which the intensity is 1. The floor is 0 except for
        /// lights of Godot.
        floor: f32 = Number::between(Parameter::Floor, 0.0, 1.0, 0.0).or(0.0);
    } by Self::with_floor(exponent, floor)
}

/// A real exponent.
const fn exponent(sample: f32) -> Number {
    Number::positive(Parameter::Exponent, 1.0 / MOST as f32, MOST as f32, sample)
}

/// Width of the strip next to an infinite derivative that [`Falloff::steepness`] ignores, in outer
/// half angles. Within this strip a format bounds the error of the position, and not of the
/// intensity, as at a step.
pub(crate) const STRIP: f64 = 1.0 / 510.0;

/// Returns the derivative with respect to `t` at the end of the [`STRIP`] beside the axis or the hotspot, of a falloff
/// whose derivative is infinite there; 0 for any other falloff.
///
/// Where the falloff rises by more than half a linear code within the strip, it is at least so large that an
/// error of `t` that reaches across the strip counts as half a linear code: the smaller the exponent, the more of the rise is
/// next to the axis, and the less the derivative says of it.
pub(crate) fn slope_beside_axis(formula: Formula<'_>, hotspot: f32) -> f32 {
    match formula {
        Formula::InvertedPower(exponent, floor) if exponent < 1.0 => {
            let power = InvertedRealPower { exponent, floor };
            let (from, slope) = power.beside_strip(hotspot);
            let rise = 1.0 - (1.0 - real_power(from, exponent.into())) / power.height();
            let half_a_code = f64::from(HALF_A_CODE);
            let across = if rise > half_a_code { half_a_code / from } else { 0.0 };
            slope.max(across) as f32
        }
        _ => 0.0,
    }
}

impl RealPower {
    /// Creates the power with this exponent.
    ///
    /// # Errors
    /// An exponent outside (0, 1024].
    pub fn new(exponent: f32) -> Result<Self, Error> {
        Ok(Self { exponent: Self::NUMBERS[0].checked(exponent)? })
    }

    /// Returns `1 - x^(1/p)`, with `lost = -ln x`.
    fn lost_at(self, x: f64, lost: f32) -> f32 {
        if self.exponent >= 1.0 {
            lost_after(lost / self.exponent)
        } else {
            (1.0 - real_power(x, 1.0 / f64::from(self.exponent))) as f32
        }
    }
}

impl InvertedRealPower {
    /// Creates the inverted power with this exponent.
    ///
    /// # Errors
    /// An exponent outside (0, 1024].
    pub fn new(exponent: f32) -> Result<Self, Error> {
        Ok(Self { exponent: Self::NUMBERS[0].checked(exponent)?, floor: 0.0 })
    }

    /// Creates the inverted power with an exponent and a floor, the `u` up to which the intensity is 1.
    ///
    /// # Errors
    /// An exponent outside (0, 1024]; a floor outside [0, 1), or above which the powers span less than
    /// 1/16.
    pub fn with_floor(exponent: f32, floor: f32) -> Result<Self, Error> {
        let power = Self { floor, ..Self::new(exponent)? };
        if (0.0..1.0).contains(&floor) && power.height() >= 1.0 / 16.0 {
            return Ok(power);
        }
        let most = real_power(15.0 / 16.0, 1.0 / f64::from(exponent)) as f32;
        Err(Error { parameter: Parameter::Floor, value: floor, accepted: Expected::Between(0.0, most) })
    }

    /// Returns `1 - floor^p`, by which the power with a floor is divided.
    pub(crate) fn height(self) -> f64 {
        if self.floor > 0.0 { 1.0 - real_power(self.floor.into(), self.exponent.into()) } else { 1.0 }
    }

    /// Returns the least `u` outside the [`STRIP`] of an exponent below 1, or of the floor, and the derivative there.
    fn beside_strip(self, hotspot: f32) -> (f64, f64) {
        let strip = f64::from(trig::sqrt(hotspot)) + STRIP;
        let (p, hotspot) = (f64::from(self.exponent), f64::from(hotspot));
        let outside = (strip * strip - hotspot) / (1.0 - hotspot);
        let from = outside.max(self.floor.into()).clamp(1e-12, 1.0);
        (from, p / real_power(from, 1.0 - p) / self.height())
    }

    /// Returns the largest `u` with this intensity.
    fn versine_of(self, intensity: f64) -> f32 {
        real_power(1.0 - intensity * self.height(), 1.0 / f64::from(self.exponent)) as f32
    }
}

written_by_bits!(CompiledRealPower CompiledInvertedRealPower);

impl CompiledRealPower {
    /// Creates the power from the bits of its exponent, as [`codegen`](crate::codegen) writes them.
    pub const fn from_bits(bits: [u32; 4]) -> Self {
        Self(RealExponent::from_bits(bits))
    }

    /// Returns the bits of the exponent.
    pub const fn to_bits(self) -> [u32; 4] {
        self.0.to_bits()
    }
}

impl CompiledInvertedRealPower {
    /// Creates the power from the bits of its exponent, as [`codegen`](crate::codegen) writes them.
    pub const fn from_bits(bits: [u32; 4]) -> Self {
        Self(RealExponent::from_bits(bits))
    }

    /// Returns the bits of the exponent.
    pub const fn to_bits(self) -> [u32; 4] {
        self.0.to_bits()
    }
}

impl From<RealPower> for CompiledRealPower {
    fn from(power: RealPower) -> Self {
        Self(RealExponent::new(power.exponent, 0.0))
    }
}

impl Falloff for RealPower {
    type Compiled<S: Scalar> = CompiledRealPower;

    fn formula(&self) -> Formula<'_> {
        Formula::Power(self.exponent())
    }

    fn beam_versine(self) -> f32 {
        self.lost_at(0.5, core::f32::consts::LN_2)
    }

    fn field_versine(self) -> f32 {
        self.lost_at(0.1, core::f32::consts::LN_10)
    }

    /// Returns the maximum of `2 p t^(p - 1) sqrt(v) / (1 - h)` over the versine `v`.
    ///
    /// Here `h` is the hotspot and `t = (1 - v) / (1 - h)`. For `p >= 1` the maximum is at the same
    /// `v` as for an integer exponent. For `p < 1` the result is the value at the inner end of the
    /// `STRIP`, and at least the steepness of a step.
    fn steepness(self, hotspot: f32) -> f32 {
        let (p, hotspot) = (f64::from(self.exponent), f64::from(hotspot));
        let edge = (1.0 - STRIP) * (1.0 - STRIP);
        let steepest = if p < 1.0 { edge } else { (1.0 / (2.0 * p - 1.0)).min(1.0) };
        let (versine, span) = (steepest.max(hotspot), 1.0 - hotspot);
        let t = (1.0 - versine) / span;
        let power = if p < 1.0 { 1.0 / real_power(t, 1.0 - p) } else { real_power(t, p - 1.0) };
        let slope = 2.0 * p * power / span;
        (slope as f32 * trig::sqrt(versine as f32)).max(if p < 1.0 { 1.0 } else { 0.0 })
    }

    /// Returns `(1 - t^(p + 1)) / (p + 1)`, for small `u` by a series.
    fn integral(self, u: f32) -> f32 {
        let (p, u) = (f64::from(self.exponent), f64::from(u));
        let integral = if (p + 1.0) * u < 1e-3 {
            u * (1.0 - p * u / 2.0 * (1.0 - (p - 1.0) * u / 3.0))
        } else {
            (1.0 - real_power(1.0 - u, p + 1.0)) / (p + 1.0)
        };
        integral as f32
    }
}

impl From<InvertedRealPower> for CompiledInvertedRealPower {
    fn from(power: InvertedRealPower) -> Self {
        Self(RealExponent::new(power.exponent, power.floor))
    }
}

impl Falloff for InvertedRealPower {
    type Compiled<S: Scalar> = CompiledInvertedRealPower;

    fn formula(&self) -> Formula<'_> {
        Formula::InvertedPower(self.exponent(), self.floor())
    }

    fn beam_versine(self) -> f32 {
        self.versine_of(0.5)
    }

    fn field_versine(self) -> f32 {
        self.versine_of(0.1)
    }

    /// Returns the larger of two values of `2 p u^(p - 1) sqrt(v) / (1 - h)`: at the edge and where
    /// the intensity begins to fall.
    ///
    /// Here `h` is the hotspot and `v = h + (1 - h) u`. There is no local maximum between the two
    /// points. For `p < 1` the inner point is the floor or the outer end of the `STRIP`, and the
    /// result is at least the steepness of a step.
    fn steepness(self, hotspot: f32) -> f32 {
        let span = 1.0 - f64::from(hotspot);
        let per_height = (2.0 * f64::from(self.exponent) / span / self.height()) as f32;
        if self.exponent >= 1.0 {
            return per_height;
        }
        let (from, slope) = self.beside_strip(hotspot);
        let versine = f64::from(hotspot) + span * from;
        let begin = trig::sqrt(versine as f32) * (2.0 * slope / span) as f32;
        begin.max(per_height).max(1.0)
    }

    fn integral(self, u: f32) -> f32 {
        let (p, u, floor) = (f64::from(self.exponent), f64::from(u), f64::from(self.floor));
        if u <= floor {
            return u as f32;
        }
        let power = |x: f64| x * real_power(x, p) / (p + 1.0);
        (floor + (u - floor - (power(u) - power(floor))) / self.height()) as f32
    }
}

/// A compiled [`RealPower`], which is the same in every format.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledRealPower(RealExponent);

/// A compiled [`InvertedRealPower`], which is the same in every format.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledInvertedRealPower(RealExponent);

impl<S: Scalar> CompiledFalloff<S> for CompiledRealPower {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.real_power(self.0).value()
    }
}

impl<S: Scalar> CompiledFalloff<S> for CompiledInvertedRealPower {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.complement().real_power(self.0).complement().value()
    }
}
