//! A falloff chosen at run time.

#[allow(clippy::wildcard_imports, reason = "the types of the list")]
use super::*;
use super::{choice::choice, power::sound};
use crate::{
    effect::Effect,
    error::Error,
    models::{SAMPLES, falloffs},
};

/// The enums of the list.
macro_rules! any_falloff {
    ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr
       $(, any $any:expr)? $(, constant $constant:ty = $its_name:literal, $value:expr, $its_truth:expr)?;)*) => {
        choice! {
            /// Any falloff, chosen at run time: that of a light of [another system](crate::import), or of a
            /// [`AnyLight`](crate::dynamic::AnyLight).
            ///
            /// It branches per point; [`CompiledAnyLight::evaluate_each`](crate::dynamic::CompiledAnyLight::evaluate_each)
            /// branches once per light.
            #[non_exhaustive]
            AnyFalloff, CompiledAnyFalloff { $($(#[$doc])* $variant($type),)* }
        }

        impl AnyFalloff {
            /// One of each falloff, for galleries and tests.
            pub fn samples() -> impl Iterator<Item = Self> {
                let samples = [$($sample.map(Self::$variant),)*];
                samples.into_iter().filter_map(|sample: Result<Self, Error>| sample.ok())
            }

            /// How many there are.
            #[cfg(feature = "arithmetic")]
            pub const COUNT: usize = [$($name),*].len();

            /// The falloff with this index, modulo their count, of numbers in [0, 1); the sample where it has no
            /// parameters.
            ///
            /// # Errors
            /// Parameters that do not go together.
            #[cfg(feature = "arithmetic")]
            pub fn drawn(index: usize, mut number: impl FnMut() -> f32) -> Result<Self, Error> {
                use crate::models::{draw, exponent};
                let (index, mut rows) = (index % Self::COUNT, 0..);
                $(
                    if rows.next() == Some(index) {
                        let drawn: Option<Result<$type, Error>> = None;
                        $(let drawn = drawn.or_else(|| Some(draw(&mut number, $any)));)?
                        return drawn.unwrap_or_else(|| $sample).map(Self::$variant);
                    }
                )*
                Ok(Self::Soft(Soft))
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
     $($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr
       $(, any $any:expr)? $(, constant $constant:ty = $its_name:literal, $value:expr, $its_truth:expr)?;)*) => {
        match ($cone.profile, $cone.curve) {
            $(($crate::falloff::AnyFalloff::$variant($profile),
               $crate::falloff::CompiledAnyFalloff::$variant($curve)) => $answer,)*
            ($profile, $curve) => $answer,
        }
    };
    ($cone:expr, $profile:ident, $curve:ident => $answer:expr) => {
        $crate::models::falloffs!(with_profile; [$cone, $profile, $curve, $answer])
    };
}

pub(crate) use with_profile;

falloffs!(any_falloff);

impl AnyFalloff {
    /// `t^n` by the cheapest profile that has it, for `n` from 0 to 1,024: to the power of 0 it is a step.
    pub(crate) fn power(exponent: u32) -> Self {
        match exponent {
            0 => Self::Step(Step),
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
    pub(crate) fn inverted_power(exponent: u32) -> Self {
        match exponent {
            1 => Self::Linear(Linear),
            2 => Self::Hard(Hard),
            _ => Self::InvertedPower(InvertedIntegerPower::of(exponent)),
        }
    }
}

impl<const N: u32> From<Power<N>> for AnyFalloff {
    fn from(_: Power<N>) -> Self {
        Self::power(sound::<N>())
    }
}

impl<const N: u32> From<InvertedPower<N>> for AnyFalloff {
    fn from(_: InvertedPower<N>) -> Self {
        Self::inverted_power(sound::<N>())
    }
}

impl From<SoftOrHard> for AnyFalloff {
    fn from(edge: SoftOrHard) -> Self {
        match edge {
            SoftOrHard::Soft => Self::Soft(Soft),
            SoftOrHard::Hard => Self::Hard(Hard),
        }
    }
}

impl From<FittedFalloff> for AnyFalloff {
    fn from(fitted: FittedFalloff) -> Self {
        match fitted {
            FittedFalloff::Quadratic(quadratic) => Self::Quadratic(quadratic),
            FittedFalloff::Cubic(cubic) => Self::Cubic(cubic),
        }
    }
}
