//! Profiles up to the second degree: the paper's two, the straight line between them, and all quadratics of their family.

use core::fmt::{self, Formatter};

use super::{
    Curve, Falloff, Formula,
    polynomial::{Polynomial, clamped_bits},
};
use crate::{
    error::{Error, Expected, Parameter},
    number::{Fraction, Scalar},
    source::{Named, Source, call, name, written_by_bits, written_by_debug},
    trig,
};

/// The soft edge `t^2` (Hast 2004, section 2): one multiply. It fades into the dark without a visible rim.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Soft;

/// The hard edge `1 - u^2` with `u = 1 - t` (Hast 2004, section 3): one multiply. Flat in the middle, a crisp rim.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Hard;

/// The straight ramp `t`: no multiply. The penumbra between an umbra and a full shadow, and Direct3D 9 with a
/// falloff of 1. A kink at the edge and, with a hotspot, another at its rim.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Linear;

/// The quadratic `t (a + (1 - a) t)` of edge slope `a`: two multiplies. Soft at 0, linear at 1, hard at 2.
///
/// Evaluated as `t (1 + (a - 1) u)`, so that it is one on the axis whatever rounding `a` has.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Quadratic {
    edge_slope: f32,
}

impl Quadratic {
    /// The quadratic that leaves the edge with this slope over `t`.
    ///
    /// # Errors
    /// An edge slope outside [0, 2], which would not be monotone.
    pub fn new(edge_slope: f32) -> Result<Self, Error> {
        if (0.0..=2.0).contains(&edge_slope) {
            Ok(Self { edge_slope })
        } else {
            let accepted = Expected::Between(0.0, 2.0);
            Err(Error { parameter: Parameter::EdgeSlope, value: edge_slope, accepted })
        }
    }

    /// The quadratic of an edge slope of these bits, as [`codegen`](crate::codegen) writes it; clamped to [0, 2], NaN to 0.
    pub const fn from_bits(edge_slope: u32) -> Self {
        Self { edge_slope: clamped_bits(edge_slope, 2.0) }
    }

    /// The bits of the edge slope.
    pub const fn to_bits(self) -> u32 {
        self.edge_slope.to_bits()
    }

    /// The hard edge, as a quadratic.
    pub(crate) const HARD: Self = Self { edge_slope: 2.0 };

    /// The quadratic of the nearest edge slope.
    pub(crate) fn nearest(edge_slope: f32) -> Self {
        Self { edge_slope: edge_slope.clamp(0.0, 2.0) }
    }

    /// The slope over `t` at the edge.
    pub fn edge_slope(self) -> f32 {
        self.edge_slope
    }

    fn polynomial(self) -> Polynomial {
        Polynomial { a: self.edge_slope, b: 1.0 - self.edge_slope, c: 0.0 }
    }

    /// The `u` with this intensity: `g u^2 + (1 - g) u = 1 - intensity`, solved without cancellation.
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

    /// `1 - 1/sqrt(2)`.
    fn beam_versine(self) -> f32 {
        1.0 - core::f32::consts::FRAC_1_SQRT_2
    }

    /// `1 - 1/sqrt(10)`.
    fn field_versine(self) -> f32 {
        0.683_772_2
    }

    /// `8 / (3 sqrt(3))` without a hotspot: the largest slope of `(1 - x^2)^2`.
    fn steepness(self, hotspot: f32) -> f32 {
        Polynomial { a: 0.0, b: 1.0, c: 0.0 }.steepness(hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u * (1.0 - u * (1.0 - u / 3.0))
    }
}

impl<S: Scalar> Curve<S> for Soft {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.product(t)
    }
}

impl Falloff for Hard {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Polynomial([2.0, -1.0, 0.0])
    }

    /// `1/sqrt(2)`.
    fn beam_versine(self) -> f32 {
        core::f32::consts::FRAC_1_SQRT_2
    }

    /// `3/sqrt(10)`.
    fn field_versine(self) -> f32 {
        0.948_683_3
    }

    /// The slope at the edge: 4 without a hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        4.0 / (1.0 - hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u * (1.0 - u * u / 3.0)
    }
}

impl<S: Scalar> Curve<S> for Hard {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        let u = t.complement();
        F::lack(u.product(u))
    }
}

impl Falloff for Linear {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Polynomial([1.0, 0.0, 0.0])
    }

    /// `1/2`.
    fn beam_versine(self) -> f32 {
        0.5
    }

    /// `9/10`.
    fn field_versine(self) -> f32 {
        0.9
    }

    /// The slope at the edge: 2 without a hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        2.0 / (1.0 - hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u * (1.0 - u / 2.0)
    }
}

impl<S: Scalar> Curve<S> for Linear {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.scalar()
    }
}

/// A [`Quadratic`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledQuadratic<S: Scalar> {
    pub(crate) g: S::Weight,
}

impl<S: Scalar> CompiledQuadratic<S> {
    /// The quadratic `t (1 + g u)`, as [`codegen`](crate::codegen) writes it.
    pub const fn from_parts(g: S::Weight) -> Self {
        Self { g }
    }
}

written_by_debug!(Soft Hard Linear);
written_by_bits!(Quadratic);

impl<S: Scalar<Weight: Source> + Named> Source for CompiledQuadratic<S> {
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

impl<S: Scalar> Curve<S> for CompiledQuadratic<S> {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.quadratic(self.g)
    }
}
