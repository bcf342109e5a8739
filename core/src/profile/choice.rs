//! Profiles chosen at run time, at the price of a branch per point. A renderer matches on them once per light and calls
//! `with_profile`.

use super::{
    Blend, Cubic, Curve, Hard, Profile, Soft, cubic::CompiledCubic, quadratic::CompiledBlend,
    without_coefficients,
};
use crate::scalar::{Fraction, Scalar};

/// One of the two profiles of one multiply, chosen at run time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Edge {
    /// As [`Soft`].
    Soft,
    /// As [`Hard`].
    Hard,
}

/// The profile that a pair of angles calls for: see [`Cone::from_beam_and_field`](crate::Cone::from_beam_and_field).
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Fitted {
    /// A quadratic.
    Blend(Blend),
    /// A cubic, where no quadratic has these angles.
    Cubic(Cubic),
}

/// A [`Fitted`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CompiledFitted<S: Scalar> {
    /// A quadratic.
    Blend(CompiledBlend<S>),
    /// A cubic.
    Cubic(CompiledCubic<S>),
}

/// What the chosen edge answers.
macro_rules! edge {
    ($choice:ident, $profile:ident => $answer:expr) => {
        match $choice {
            Self::Soft => {
                let $profile = Soft;
                $answer
            }
            Self::Hard => {
                let $profile = Hard;
                $answer
            }
        }
    };
}

/// What the fitted profile answers.
macro_rules! fitted {
    ($choice:ident, $profile:ident => $answer:expr) => {
        match $choice {
            Self::Blend($profile) => $answer,
            Self::Cubic($profile) => $answer,
        }
    };
}

impl Profile for Edge {
    without_coefficients!();

    fn beam_versine(self) -> f32 {
        edge!(self, profile => profile.beam_versine())
    }

    fn field_versine(self) -> f32 {
        edge!(self, profile => profile.field_versine())
    }

    fn steepness(self, hotspot: f32) -> f32 {
        edge!(self, profile => profile.steepness(hotspot))
    }

    fn integral(self, u: f32) -> f32 {
        edge!(self, profile => profile.integral(u))
    }
}

impl<S: Scalar> Curve<S> for Edge {
    #[inline(always)]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        edge!(self, profile => profile.intensity(t))
    }
}

impl Profile for Fitted {
    type Compiled<S: Scalar> = CompiledFitted<S>;

    fn compile<S: Scalar>(self) -> CompiledFitted<S> {
        match self {
            Self::Blend(blend) => CompiledFitted::Blend(blend.compile()),
            Self::Cubic(cubic) => CompiledFitted::Cubic(cubic.compile()),
        }
    }

    fn beam_versine(self) -> f32 {
        fitted!(self, profile => profile.beam_versine())
    }

    fn field_versine(self) -> f32 {
        fitted!(self, profile => profile.field_versine())
    }

    fn steepness(self, hotspot: f32) -> f32 {
        fitted!(self, profile => profile.steepness(hotspot))
    }

    fn integral(self, u: f32) -> f32 {
        fitted!(self, profile => profile.integral(u))
    }
}

impl<S: Scalar> Curve<S> for CompiledFitted<S> {
    #[inline(always)]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        fitted!(self, profile => profile.intensity(t))
    }
}
