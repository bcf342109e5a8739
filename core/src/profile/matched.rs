//! Any profile, chosen at run time.

use super::{
    Blend, Cubic, Curve, CutOff, Edge, Fitted, Hard, IntegerPower, IntegerRim, Linear, MixedPower, MixedRim,
    Power, Profile, RealPower, RealRim, Rim, Smooth, Soft, Table,
    cubic::CompiledCubic,
    mixed::{CompiledMixedPower, CompiledMixedRim},
    power::sound,
    quadratic::CompiledBlend,
    real::{CompiledRealPower, CompiledRealRim},
};
use crate::scalar::{Fraction, Scalar};

/// Any profile, chosen at run time: the one that matches a light of [another system](crate::import), or that a
/// [`Lamp`](crate::Lamp) was given.
///
/// Like [`Edge`](crate::Edge) it branches per point; [`CompiledLamp::arrive_each`](crate::CompiledLamp::arrive_each)
/// branches once per light instead, and goes on with the profile's own type.
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
    /// A quadratic between soft and hard.
    Blend(Blend),
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
    /// A power of a real exponent.
    RealPower(RealPower),
    /// A rim power of a real exponent.
    RealRim(RealRim),
    /// Samples.
    Table(Table<'static>),
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
    /// A quadratic between soft and hard.
    Blend(CompiledBlend<S>),
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
    /// A power of a real exponent.
    RealPower(CompiledRealPower),
    /// A rim power of a real exponent.
    RealRim(CompiledRealRim),
    /// Samples.
    Table(Table<'static>),
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
            Self::Blend($profile) => $answer,
            Self::Cubic($profile) => $answer,
            Self::Power($profile) => $answer,
            Self::Rim($profile) => $answer,
            Self::MixedPower($profile) => $answer,
            Self::MixedRim($profile) => $answer,
            Self::RealPower($profile) => $answer,
            Self::RealRim($profile) => $answer,
            Self::Table($profile) => $answer,
        }
    };
}

impl Matched {
    /// `t^n` by the cheapest profile that has it, for `n` from 0 to 1,024: to the power of 0 it is a step.
    pub(crate) fn power(exponent: u32) -> Self {
        match exponent {
            0 => Self::CutOff(CutOff),
            1 => Self::Linear(Linear),
            2 => Self::Soft(Soft),
            _ => Self::Power(IntegerPower::of(exponent)),
        }
    }

    /// `t^p` by the cheapest profile that has it, for any `p` from 0 to 1,024.
    pub(crate) fn real_power(exponent: f32) -> Self {
        let whole = exponent as u32;
        if whole as f32 == exponent { Self::power(whole) } else { Self::RealPower(RealPower::of(exponent)) }
    }

    /// `1 - u^n` by the cheapest profile that has it, for `n` from 1 to 1,024.
    pub(crate) fn rim(exponent: u32) -> Self {
        match exponent {
            1 => Self::Linear(Linear),
            2 => Self::Hard(Hard),
            _ => Self::Rim(IntegerRim::of(exponent)),
        }
    }
}

/// A profile of one type as one of any.
macro_rules! from {
    ($($profile:ty => $variant:ident,)*) => {$(
        impl From<$profile> for Matched {
            fn from(profile: $profile) -> Self {
                Self::$variant(profile)
            }
        }
    )*};
}

from! {
    CutOff => CutOff,
    Linear => Linear,
    Soft => Soft,
    Hard => Hard,
    Smooth => Smooth,
    Blend => Blend,
    Cubic => Cubic,
    IntegerPower => Power,
    IntegerRim => Rim,
    MixedPower => MixedPower,
    MixedRim => MixedRim,
    RealPower => RealPower,
    RealRim => RealRim,
    Table<'static> => Table,
}

impl<const N: u32> From<Power<N>> for Matched {
    fn from(_: Power<N>) -> Self {
        Self::power(sound::<N>())
    }
}

impl<const N: u32> From<Rim<N>> for Matched {
    fn from(_: Rim<N>) -> Self {
        Self::rim(sound::<N>())
    }
}

impl From<Edge> for Matched {
    fn from(edge: Edge) -> Self {
        match edge {
            Edge::Soft => Self::Soft(Soft),
            Edge::Hard => Self::Hard(Hard),
        }
    }
}

impl From<Fitted> for Matched {
    fn from(fitted: Fitted) -> Self {
        match fitted {
            Fitted::Blend(blend) => Self::Blend(blend),
            Fitted::Cubic(cubic) => Self::Cubic(cubic),
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
            Self::Blend(blend) => CompiledMatched::Blend(blend.compile()),
            Self::Cubic(cubic) => CompiledMatched::Cubic(cubic.compile()),
            Self::Power(power) => CompiledMatched::Power(power),
            Self::Rim(rim) => CompiledMatched::Rim(rim),
            Self::MixedPower(mixed) => CompiledMatched::MixedPower(mixed.compile()),
            Self::MixedRim(mixed) => CompiledMatched::MixedRim(mixed.compile()),
            Self::RealPower(real) => CompiledMatched::RealPower(real.compile::<S>()),
            Self::RealRim(real) => CompiledMatched::RealRim(real.compile::<S>()),
            Self::Table(table) => CompiledMatched::Table(table),
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
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        matched!(self, profile => profile.intensity(t))
    }
}
