//! The profile of an imported light.

use super::{
    Cubic, Curve, CutOff, Hard, IntegerPower, IntegerRim, Linear, MixedPower, MixedRim, Profile, Smooth,
    Soft,
    cubic::CompiledCubic,
    mixed::{CompiledMixedPower, CompiledMixedRim},
};
use crate::scalar::Scalar;

/// The profile that matches a light of another system: see [`import`](crate::import).
///
/// Like [`Edge`](crate::Edge) it branches per point; a renderer matches on it once per light, and calls
/// [`with_profile`](crate::CompiledSpot::with_profile) with what it holds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Matched {
    /// A step.
    CutOff(CutOff),
    /// The straight ramp.
    Linear(Linear),
    /// The square.
    Soft(Soft),
    /// The mirror image of the square.
    Hard(Hard),
    /// Smoothstep.
    Smooth(Smooth),
    /// A monotone cubic.
    Cubic(Cubic),
    /// An integer power.
    Power(IntegerPower),
    /// An integer rim power.
    Rim(IntegerRim),
    /// A mixture of two powers.
    MixedPower(MixedPower),
    /// A mixture of two rim powers.
    MixedRim(MixedRim),
}

/// A [`Matched`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CompiledMatched<S: Scalar> {
    /// A step.
    CutOff(CutOff),
    /// The straight ramp.
    Linear(Linear),
    /// The square.
    Soft(Soft),
    /// The mirror image of the square.
    Hard(Hard),
    /// Smoothstep.
    Smooth(Smooth),
    /// A monotone cubic.
    Cubic(CompiledCubic<S>),
    /// An integer power.
    Power(IntegerPower),
    /// An integer rim power.
    Rim(IntegerRim),
    /// A mixture of two powers.
    MixedPower(CompiledMixedPower<S>),
    /// A mixture of two rim powers.
    MixedRim(CompiledMixedRim<S>),
}

/// What the profile in the enum answers.
macro_rules! matched {
    ($choice:ident, $profile:ident => $answer:expr) => {
        match $choice {
            Self::CutOff($profile) => $answer,
            Self::Linear($profile) => $answer,
            Self::Soft($profile) => $answer,
            Self::Hard($profile) => $answer,
            Self::Smooth($profile) => $answer,
            Self::Cubic($profile) => $answer,
            Self::Power($profile) => $answer,
            Self::Rim($profile) => $answer,
            Self::MixedPower($profile) => $answer,
            Self::MixedRim($profile) => $answer,
        }
    };
}

impl Matched {
    /// `t^n` by the cheapest profile that has it, for `n` from 0 to 128: to the power of 0 it is a step.
    pub(crate) fn power(exponent: u32) -> Self {
        match exponent {
            0 => Self::CutOff(CutOff),
            1 => Self::Linear(Linear),
            2 => Self::Soft(Soft),
            _ => Self::Power(IntegerPower::of(exponent)),
        }
    }

    /// `1 - u^n` by the cheapest profile that has it, for `n` from 1 to 128.
    pub(crate) fn rim(exponent: u32) -> Self {
        match exponent {
            1 => Self::Linear(Linear),
            2 => Self::Hard(Hard),
            _ => Self::Rim(IntegerRim::of(exponent)),
        }
    }
}

impl Profile for Matched {
    type Compiled<S: Scalar> = CompiledMatched<S>;

    fn compile<S: Scalar>(self) -> CompiledMatched<S> {
        match self {
            Self::CutOff(step) => CompiledMatched::CutOff(step),
            Self::Linear(linear) => CompiledMatched::Linear(linear),
            Self::Soft(soft) => CompiledMatched::Soft(soft),
            Self::Hard(hard) => CompiledMatched::Hard(hard),
            Self::Smooth(smooth) => CompiledMatched::Smooth(smooth),
            Self::Cubic(cubic) => CompiledMatched::Cubic(cubic.compile()),
            Self::Power(power) => CompiledMatched::Power(power),
            Self::Rim(rim) => CompiledMatched::Rim(rim),
            Self::MixedPower(mixed) => CompiledMatched::MixedPower(mixed.compile()),
            Self::MixedRim(mixed) => CompiledMatched::MixedRim(mixed.compile()),
        }
    }

    fn beam_versine(self) -> f32 {
        matched!(self, profile => profile.beam_versine())
    }

    fn field_versine(self) -> f32 {
        matched!(self, profile => profile.field_versine())
    }

    fn steepness(self, hotspot: f32) -> f32 {
        matched!(self, profile => profile.steepness(hotspot))
    }

    fn integral(self, u: f32) -> f32 {
        matched!(self, profile => profile.integral(u))
    }
}

impl<S: Scalar> Curve<S> for CompiledMatched<S> {
    #[inline(always)]
    fn intensity(self, t: S::Fraction) -> S {
        matched!(self, profile => profile.intensity(t))
    }
}
