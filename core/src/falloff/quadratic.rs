//! Linear and quadratic falloffs: soft and hard of Hast 2004, linear, and all quadratics between
//! soft and hard.

use core::fmt::{self, Formatter};

use super::{CompiledFalloff, Falloff, Formula, compiled::Square, polynomial::Polynomial};
use crate::{
    error::{Error, Parameter},
    model::{Model as _, Number, model, plain},
    number::{Fraction, Scalar, Share},
    source::{Source, call, name},
    trig,
};

/// The soft falloff `t^2` (Hast 2004, section 2): one multiply. The soft falloff fades out without
/// a visible edge.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Soft;

/// The hard falloff `1 - u^2` with `u = 1 - t` (Hast 2004, section 3): one multiply. The hard
/// falloff is flat at the centre and has a sharp edge.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Hard;

/// The linear falloff `t`: no multiply. It models the penumbra between an umbra and full shadow,
/// and Direct3D 9 with a falloff of 1. Its derivative jumps at the edge and, with a hotspot, at the
/// inner angle.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Linear;

model! {
    /// The quadratic `t (a + (1 - a) t)` with edge slope `a`: two multiplies. The quadratic is soft at
    /// `a = 0`, linear at `a = 1` and hard at `a = 2`.
    ///
    /// The quadratic is evaluated as `t (1 + (a - 1) u)`, so that the value on the axis is exactly 1,
    /// however `a` is rounded.
    Quadratic {
        /// Returns the edge slope: the derivative with respect to `t` at the edge, in [0, 2].
        edge_slope: f32 = Number::between(Parameter::EdgeSlope, 0.0, 2.0, 0.5);
    } by Self::new(edge_slope)
}

impl Quadratic {
    /// Creates the quadratic with this edge slope: the derivative with respect to `t` at the edge.
    ///
    /// # Errors
    /// An edge slope outside [0, 2]: the quadratic would not be monotone.
    pub fn new(edge_slope: f32) -> Result<Self, Error> {
        Ok(Self { edge_slope: Self::NUMBERS[0].checked(edge_slope)? })
    }

    /// The hard falloff as a quadratic.
    pub(crate) const HARD: Self = Self { edge_slope: 2.0 };

    /// Creates the quadratic with the edge slope clamped to [0, 2].
    pub(crate) fn nearest(edge_slope: f32) -> Self {
        Self { edge_slope: edge_slope.clamp(0.0, 2.0) }
    }

    fn polynomial(self) -> Polynomial {
        Polynomial { a: self.edge_slope, b: 1.0 - self.edge_slope, c: 0.0 }
    }

    /// Returns the `u` with this intensity, the solution of `g u^2 + (1 - g) u = 1 - intensity`,
    /// without cancellation.
    fn versine_of(self, intensity: f32) -> f32 {
        let (g, lost) = (self.edge_slope - 1.0, 1.0 - intensity);
        let b = 1.0 - g;
        2.0 * lost / (b + trig::sqrt(b * b + 4.0 * g * lost))
    }
}

impl Falloff for Soft {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Polynomial([0.0, 1.0, 0.0])
    }

    /// Returns `1 - 1/sqrt(2)`.
    fn beam_versine(self) -> f32 {
        1.0 - core::f32::consts::FRAC_1_SQRT_2
    }

    /// Returns `1 - 1/sqrt(10)`.
    fn field_versine(self) -> f32 {
        0.683_772_2
    }

    /// Returns the largest derivative of `(1 - x^2)^2` with respect to the angle `x`:
    /// `8 / (3 sqrt(3))` without a hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        Polynomial { a: 0.0, b: 1.0, c: 0.0 }.steepness(hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u * (1.0 - u * (1.0 - u / 3.0))
    }
}

impl<S: Scalar> CompiledFalloff<S> for Soft {
    const IN_VECTORS: bool = true;

    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.times_to_value(t)
    }

    #[inline]
    fn as_cubic(self) -> Option<[S::Weight; 2]> {
        Some([S::weight(-1.0), S::weight(0.0)])
    }

    #[inline]
    fn as_square(self) -> Option<Square> {
        Some(Square::Soft)
    }
}

impl Falloff for Hard {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Polynomial([2.0, -1.0, 0.0])
    }

    /// Returns `1/sqrt(2)`.
    fn beam_versine(self) -> f32 {
        core::f32::consts::FRAC_1_SQRT_2
    }

    /// Returns `3/sqrt(10)`.
    fn field_versine(self) -> f32 {
        0.948_683_3
    }

    /// Returns the derivative at the edge: 4 without a hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        4.0 / (1.0 - hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u * (1.0 - u * u / 3.0)
    }
}

impl<S: Scalar> CompiledFalloff<S> for Hard {
    const IN_VECTORS: bool = true;

    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        let u = t.complement();
        u.times_to_value(u).complement()
    }

    #[inline]
    fn as_cubic(self) -> Option<[S::Weight; 2]> {
        Some([S::weight(1.0), S::weight(0.0)])
    }

    #[inline]
    fn as_square(self) -> Option<Square> {
        Some(Square::Hard)
    }
}

impl Falloff for Linear {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Polynomial([1.0, 0.0, 0.0])
    }

    /// Returns `1/2`.
    fn beam_versine(self) -> f32 {
        0.5
    }

    /// Returns `9/10`.
    fn field_versine(self) -> f32 {
        0.9
    }

    /// Returns the derivative at the edge: 2 without a hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        2.0 / (1.0 - hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u * (1.0 - u / 2.0)
    }
}

impl<S: Scalar> CompiledFalloff<S> for Linear {
    const IN_VECTORS: bool = true;

    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.value()
    }

    #[inline]
    fn as_cubic(self) -> Option<[S::Weight; 2]> {
        Some([S::weight(0.0), S::weight(0.0)])
    }
}

/// A [`Quadratic`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledQuadratic<S: Scalar> {
    pub(crate) g: S::Weight,
}

impl<S: Scalar> CompiledQuadratic<S> {
    /// Creates the quadratic `t (1 + g u)`, as [`codegen`](crate::codegen) writes it.
    pub const fn from_parts(g: S::Weight) -> Self {
        Self { g }
    }
}

plain!(Soft Hard Linear);

impl<S: Scalar> Source for CompiledQuadratic<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledQuadratic::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.g])
    }
}

impl<S: Scalar> From<Quadratic> for CompiledQuadratic<S> {
    fn from(quadratic: Quadratic) -> Self {
        Self { g: S::weight(quadratic.edge_slope - 1.0) }
    }
}

impl Falloff for Quadratic {
    type Compiled<S: Scalar> = CompiledQuadratic<S>;

    fn formula(&self) -> Formula<'_> {
        Formula::Polynomial([self.edge_slope, 1.0 - self.edge_slope, 0.0])
    }

    fn beam_versine(self) -> f32 {
        self.versine_of(0.5)
    }

    fn field_versine(self) -> f32 {
        self.versine_of(0.1)
    }

    fn steepness(self, hotspot: f32) -> f32 {
        self.polynomial().steepness(hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        self.polynomial().integral(u)
    }
}

impl<S: Scalar> CompiledFalloff<S> for CompiledQuadratic<S> {
    const IN_VECTORS: bool = true;

    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.quadratic(self.g)
    }

    #[inline]
    fn as_cubic(self) -> Option<[S::Weight; 2]> {
        Some([self.g, S::weight(0.0)])
    }
}
