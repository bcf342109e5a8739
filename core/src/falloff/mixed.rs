//! Weighted sums of two integer powers.

use core::fmt::{self, Formatter};

use super::{
    Curve, Falloff, Formula,
    integer::{IntegerPower, InvertedIntegerPower, MOST, checked, clamped, power, raised},
    polynomial::clamped_bits,
};
use crate::{
    error::{Error, Parameter, check_between},
    number::{Fraction, Scalar},
    search::{bisect, maximum},
    source::{Named, Source, call, name, written_by_bits},
    trig,
};

/// The mixture `(1 - s) t^n + s t^m` of two integer powers, with a weight `s` of the larger
/// exponent `m`. The mixture takes two multiplies more than the two powers.
///
/// A linear falloff mixed with a high power has a sharp peak on the axis. The smaller exponent `n`
/// may be 0: `t^0` is 1 for `t > 0`, so such a mixture jumps at its edge.
///
/// The mixture rises monotonically towards the axis, except for decreases of at most one step of
/// the format.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MixedPower(Mixture);

/// The mixture `1 - (1 - s) u^n - s u^m` of two inverted powers: the mirror image of
/// [`MixedPower`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct InvertedMixedPower(Mixture);

/// Two exponents in ascending order, and the weight of the larger one.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Mixture {
    low: u32,
    high: u32,
    share: f32,
}

impl Mixture {
    fn checked(least: u32, exponents: [u32; 2], share: f32) -> Result<Self, Error> {
        let low = checked(exponents[0], least, MOST - 1)?;
        let high = checked(exponents[1], low + 1, MOST)?;
        check_between(Parameter::Share, share, 0.0, 1.0)?;
        Ok(Self { low, high, share })
    }

    /// Creates the mixture with both exponents clamped to their valid ranges. The share is clamped
    /// to [0, 1]; NaN becomes 0.
    const fn from_bits(least: u32, [low, high, share]: [u32; 3]) -> Self {
        let low = clamped(low, least, MOST - 1);
        Self { low, high: clamped(high, low + 1, MOST), share: clamped_bits(share, 1.0) }
    }

    /// Returns the weighted sum of two numbers.
    fn of(self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.share
    }

    /// Returns the mixture of the powers of `x` in [0, 1].
    fn value(self, x: f64) -> f64 {
        let (low, high) = (raised(x, self.low), raised(x, self.high));
        low + (high - low) * f64::from(self.share)
    }

    /// Returns the derivative of the mixture with respect to `x`.
    fn slope(self, x: f64) -> f64 {
        let slope = |n: u32| if n == 0 { 0.0 } else { f64::from(n) * raised(x, n - 1) };
        let (low, high) = (slope(self.low), slope(self.high));
        low + (high - low) * f64::from(self.share)
    }

    /// Returns `1 - x` for the `x` at which the mixture has this value; 1 if the mixture exceeds
    /// the value everywhere.
    fn lack_at(self, value: f64) -> f32 {
        bisect(0.0, 1.0, |lack| self.value(1.0 - f64::from(lack)) > value)
    }
}

impl MixedPower {
    /// Creates the mixture of the powers with these two exponents and this share of the larger
    /// exponent.
    ///
    /// The exponents are in ascending order.
    ///
    /// # Errors
    /// A first exponent outside 0 to 1,023, a second exponent that is not larger or exceeds 1,024,
    /// or a share outside [0, 1].
    pub fn new(exponents: [u32; 2], share: f32) -> Result<Self, Error> {
        Mixture::checked(0, exponents, share).map(Self)
    }

    /// Creates the mixture from two exponents and the bits of a share, as
    /// [`codegen`](crate::codegen) writes them. Each value is clamped to the range that
    /// [`new`](Self::new) accepts; a share of NaN becomes 0.
    pub const fn from_bits(bits: [u32; 3]) -> Self {
        Self(Mixture::from_bits(0, bits))
    }

    /// Returns the two exponents and the bits of the share.
    pub const fn to_bits(self) -> [u32; 3] {
        [self.0.low, self.0.high, self.0.share.to_bits()]
    }

    /// Returns the two exponents.
    pub fn exponents(self) -> [u32; 2] {
        [self.0.low, self.0.high]
    }

    /// Returns the share of the larger exponent, in [0, 1].
    pub fn share(self) -> f32 {
        self.0.share
    }
}

impl InvertedMixedPower {
    /// Creates the mixture of the inverted powers with these two exponents and this share of the
    /// larger exponent.
    ///
    /// The exponents are in ascending order.
    ///
    /// # Errors
    /// A first exponent outside 1 to 1,023, a second exponent that is not larger or exceeds 1,024,
    /// or a share outside [0, 1].
    pub fn new(exponents: [u32; 2], share: f32) -> Result<Self, Error> {
        Mixture::checked(1, exponents, share).map(Self)
    }

    /// Creates the mixture from two exponents and the bits of a share, as
    /// [`codegen`](crate::codegen) writes them. Each value is clamped to the range that
    /// [`new`](Self::new) accepts; a share of NaN becomes 0.
    pub const fn from_bits(bits: [u32; 3]) -> Self {
        Self(Mixture::from_bits(1, bits))
    }

    /// Returns the two exponents and the bits of the share.
    pub const fn to_bits(self) -> [u32; 3] {
        [self.0.low, self.0.high, self.0.share.to_bits()]
    }

    /// Returns the two exponents.
    pub fn exponents(self) -> [u32; 2] {
        [self.0.low, self.0.high]
    }

    /// Returns the share of the larger exponent, in [0, 1].
    pub fn share(self) -> f32 {
        self.0.share
    }
}

/// A [`Mixture`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
struct CompiledMixture<S> {
    low: u32,
    /// The difference of the two exponents.
    rise: u32,
    share: S,
}

impl<S: Scalar> CompiledMixture<S> {
    fn new(mixture: Mixture) -> Self {
        Self { low: mixture.low, rise: mixture.high - mixture.low, share: S::from_f32(mixture.share) }
    }

    /// Returns the mixture of the powers of a fraction: exactly 0 at 0 and exactly 1 at 1.
    #[inline]
    fn of<F: Fraction<S>>(self, x: F) -> F::Value {
        let rise = power(x, self.rise);
        let (low, high) = if self.low == 0 {
            (x.step(), rise.scalar())
        } else {
            let low = power(x, self.low);
            (low.scalar(), low.product(rise))
        };
        F::mixed(low, high, self.share)
    }
}

/// A [`MixedPower`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledMixedPower<S>(CompiledMixture<S>);

/// An [`InvertedMixedPower`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledInvertedMixedPower<S>(CompiledMixture<S>);

written_by_bits!(MixedPower InvertedMixedPower);

impl<S: Scalar> CompiledMixedPower<S> {
    /// Creates the mixture from its parts, as [`codegen`](crate::codegen) writes them.
    ///
    /// The parts are the smaller exponent, the difference of the exponents, and the share of the
    /// larger exponent.
    pub const fn from_parts(low: u32, rise: u32, share: S) -> Self {
        Self(CompiledMixture { low, rise, share })
    }
}

impl<S: Scalar + Source + Named> Source for CompiledMixedPower<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledMixedPower::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.0.low, &self.0.rise, &self.0.share])
    }
}

impl<S: Scalar> CompiledInvertedMixedPower<S> {
    /// Creates the mixture from its parts, as [`codegen`](crate::codegen) writes them.
    ///
    /// The parts are the smaller exponent, the difference of the exponents, and the share of the
    /// larger exponent.
    pub const fn from_parts(low: u32, rise: u32, share: S) -> Self {
        Self(CompiledMixture { low, rise, share })
    }
}

impl<S: Scalar + Source + Named> Source for CompiledInvertedMixedPower<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledInvertedMixedPower::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.0.low, &self.0.rise, &self.0.share])
    }
}

impl<S: Scalar> From<MixedPower> for CompiledMixedPower<S> {
    fn from(falloff: MixedPower) -> Self {
        Self(CompiledMixture::new(falloff.0))
    }
}

impl Falloff for MixedPower {
    type Compiled<S: Scalar> = CompiledMixedPower<S>;

    fn formula(&self) -> Formula<'_> {
        Formula::MixedPower(self.exponents(), self.share())
    }

    fn beam_versine(self) -> f32 {
        self.0.lack_at(0.5)
    }

    fn field_versine(self) -> f32 {
        self.0.lack_at(0.1)
    }

    /// Returns the maximum of `2 f'(t) sqrt(v) / (1 - h)` over the versine `v`.
    ///
    /// Here `h` is the hotspot and `t = (1 - v) / (1 - h)`. The maximum is searched, because a
    /// mixture may have two local maxima. If the mixture jumps at its edge, the result is at least
    /// the steepness of a step.
    fn steepness(self, hotspot: f32) -> f32 {
        let (hotspot, jump) = (f64::from(hotspot), if self.0.low == 0 { 1.0 } else { 0.0 });
        let span = 1.0 - hotspot;
        // The search samples evenly in the square root of the versine, which is nearly proportional
        // to the angle.
        let steepest = maximum(0.0, 1.0, |x| {
            let versine = hotspot + span * x * x;
            2.0 * self.0.slope(1.0 - x * x) * f64::from(trig::sqrt(versine as f32)) / span
        });
        (steepest as f32).max(jump)
    }

    fn integral(self, u: f32) -> f32 {
        let of = |n: u32| if n == 0 { u } else { IntegerPower::of(n).integral(u) };
        self.0.of(of(self.0.low), of(self.0.high))
    }
}

impl<S: Scalar> Curve<S> for CompiledMixedPower<S> {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        self.0.of(t)
    }
}

impl<S: Scalar> From<InvertedMixedPower> for CompiledInvertedMixedPower<S> {
    fn from(falloff: InvertedMixedPower) -> Self {
        Self(CompiledMixture::new(falloff.0))
    }
}

impl Falloff for InvertedMixedPower {
    type Compiled<S: Scalar> = CompiledInvertedMixedPower<S>;

    fn formula(&self) -> Formula<'_> {
        Formula::InvertedMixedPower(self.exponents(), self.share())
    }

    fn beam_versine(self) -> f32 {
        1.0 - self.0.lack_at(0.5)
    }

    fn field_versine(self) -> f32 {
        1.0 - self.0.lack_at(0.9)
    }

    /// Returns the derivative at the edge, where both powers have their largest derivative.
    fn steepness(self, hotspot: f32) -> f32 {
        let of = |n: u32| InvertedIntegerPower::of(n).steepness(hotspot);
        self.0.of(of(self.0.low), of(self.0.high))
    }

    fn integral(self, u: f32) -> f32 {
        let of = |n: u32| InvertedIntegerPower::of(n).integral(u);
        self.0.of(of(self.0.low), of(self.0.high))
    }
}

impl<S: Scalar> Curve<S> for CompiledInvertedMixedPower<S> {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        F::lack(self.0.of(t.complement()))
    }
}
