//! The falloffs of the library's lights.

use core::fmt::{self, Formatter};

use luminaire::{
    Fx16,
    codegen::Source,
    falloff::{Curve, Falloff, FittedFalloff, Formula, SoftOrHard},
    number::{Fraction, Scalar, Weight16},
};

/// The falloff of a light: a given one, or the one with a given beam and field angle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Edge {
    Given(SoftOrHard),
    Fitted(FittedFalloff),
}

/// An [`Edge`] in the format `S`.
///
/// A quadratic is a cubic with `h = 0`, which has the same bits: a variant of its own would be faster and
/// take more flash.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum CompiledEdge<S: Scalar> {
    Given(SoftOrHard),
    /// `t (1 + u (g + h t))`.
    Cubic {
        g: S::Weight,
        h: S::Weight,
    },
}

/// Evaluates an expression with the falloff of an edge.
macro_rules! of {
    ($edge:ident, $falloff:ident => $answer:expr) => {
        match $edge {
            Self::Given($falloff) => $answer,
            Self::Fitted($falloff) => $answer,
        }
    };
}

impl Falloff for Edge {
    type Compiled<S: Scalar> = CompiledEdge<S>;

    fn formula(&self) -> Formula<'_> {
        of!(self, falloff => falloff.formula())
    }

    fn beam_versine(self) -> f32 {
        of!(self, falloff => falloff.beam_versine())
    }

    fn field_versine(self) -> f32 {
        of!(self, falloff => falloff.field_versine())
    }

    fn steepness(self, hotspot: f32) -> f32 {
        of!(self, falloff => falloff.steepness(hotspot))
    }

    fn integral(self, u: f32) -> f32 {
        of!(self, falloff => falloff.integral(u))
    }
}

/// Never written: the lights of C are words and not source.
impl Source for Edge {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "{self:?}")
    }
}

impl<S: Scalar> Source for CompiledEdge<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "{self:?}")
    }
}

impl<S: Scalar> From<Edge> for CompiledEdge<S> {
    fn from(edge: Edge) -> Self {
        match edge {
            Edge::Given(edge) => Self::Given(edge),
            Edge::Fitted(FittedFalloff::Quadratic(quadratic)) => {
                Self::Cubic { g: S::weight(quadratic.edge_slope() - 1.0), h: S::weight(0.0) }
            }
            Edge::Fitted(FittedFalloff::Cubic(cubic)) => {
                let (a, d) = (cubic.edge_slope(), cubic.middle_slope());
                Self::Cubic { g: S::weight(a - 1.0), h: S::weight(2.0 - a - d) }
            }
        }
    }
}

impl<S: Scalar> Curve<S> for CompiledEdge<S> {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        match self {
            Self::Given(edge) => edge.intensity(t),
            Self::Cubic { g, h } => t.cubic(g, h),
        }
    }
}

impl CompiledEdge<Fx16> {
    /// The edge with these words. They have a meaning whatever their bits are.
    #[inline]
    pub(crate) fn of_words([kind, g, h]: [u32; 3]) -> Self {
        let weight = |word: u32| Weight16::from_bits(word.cast_signed());
        match kind {
            0 => Self::Given(SoftOrHard::Soft),
            1 => Self::Given(SoftOrHard::Hard),
            _ => Self::Cubic { g: weight(g), h: weight(h) },
        }
    }

    pub(crate) fn words(self) -> [u32; 3] {
        match self {
            Self::Given(SoftOrHard::Soft) => [0; 3],
            Self::Given(SoftOrHard::Hard) => [1, 0, 0],
            Self::Cubic { g, h } => [2, g.to_bits().cast_unsigned(), h.to_bits().cast_unsigned()],
        }
    }
}
