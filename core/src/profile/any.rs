//! A falloff chosen at run time.

use super::{
    Blend, Cubic, Curve, CutOff, Edge, Fitted, Hard, IntegerPower, IntegerRim, Linear, MixedPower, MixedRim,
    Power, Profile, RealPower, RealRim, Rim, Smooth, Soft, Table, choice::choice, power::sound,
};
use crate::{effect::Effect, error::Error};

/// The list of the falloffs that can be chosen at run time: hands its rows, each with a sample, to a
/// macro after the macro's own arguments.
macro_rules! falloffs {
    ($consumer:ident! $($arguments:tt)*) => {
        $consumer! {
            $($arguments)*
            /// A step.
            CutOff(CutOff) = "cut-off", Ok(CutOff);
            /// The straight ramp.
            Linear(Linear) = "linear", Ok(Linear);
            /// The square.
            Soft(Soft) = "soft", Ok(Soft);
            /// The mirror image of the square.
            Hard(Hard) = "hard", Ok(Hard);
            /// Smoothstep.
            Smooth(Smooth) = "smooth", Ok(Smooth);
            /// A quadratic between soft and hard.
            Blend(Blend) = "blend", Blend::new(0.5);
            /// A monotone cubic.
            Cubic(Cubic) = "cubic", Cubic::with_slopes(1.25, 3.5);
            /// An integer power.
            Power(IntegerPower) = "power", IntegerPower::new(15);
            /// An inverted integer power.
            Rim(IntegerRim) = "rim", IntegerRim::new(4);
            /// A mixture of two powers.
            MixedPower(MixedPower) = "mixed-power", MixedPower::new([1, 16], 0.375);
            /// A mixture of two inverted powers.
            MixedRim(MixedRim) = "mixed-rim", MixedRim::new([2, 3], 0.5625);
            /// A power of a real exponent.
            RealPower(RealPower) = "real-power", RealPower::new(2.2);
            /// An inverted power of a real exponent.
            RealRim(RealRim) = "real-rim", RealRim::new(0.75);
            /// Samples.
            Table(Table<'static>) = "table", Ok(Table::of(&[
                65_535, 65_000, 63_211, 60_007, 51_234, 39_876, 24_321, 11_111, 3_210, 0,
            ]));
        }
    };
}

/// The enums of the list.
macro_rules! any_falloff {
    ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr;)*) => {
        choice! {
            /// Any falloff, chosen at run time: that of a light of [another system](crate::import), or of a
            /// [`Lamp`](crate::Lamp).
            ///
            /// It branches per point; [`CompiledLamp::arrive_each`](crate::CompiledLamp::arrive_each)
            /// branches once per light.
            #[non_exhaustive]
            Matched, CompiledMatched { $($(#[$doc])* $variant($type),)* }
        }

        impl Matched {
            /// One of each falloff, for galleries and tests.
            pub fn samples() -> impl Iterator<Item = Self> {
                let samples: [Result<Self, Error>; _] = [$($sample.map(Self::$variant),)*];
                samples.into_iter().flatten()
            }

            /// The effect that the falloff is.
            pub fn effect(&self) -> Effect {
                match self {
                    $(Self::$variant(_) => Effect::$variant,)*
                }
            }
        }
    };
}

/// Evaluates an expression with the falloff and the curve of a compiled cone by their own types. A
/// falloff and a curve of two kinds, which only `from_parts` can bring together, stay enums.
macro_rules! with_profile {
    ([$cone:expr, $profile:ident, $curve:ident, $answer:expr]
     $($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr;)*) => {
        match ($cone.profile, $cone.curve) {
            $(($crate::profile::Matched::$variant($profile),
               $crate::profile::CompiledMatched::$variant($curve)) => $answer,)*
            ($profile, $curve) => $answer,
        }
    };
    ($cone:expr, $profile:ident, $curve:ident => $answer:expr) => {
        $crate::profile::falloffs!(with_profile! [$cone, $profile, $curve, $answer])
    };
}

pub(crate) use {falloffs, with_profile};

falloffs!(any_falloff!);

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
