//! A falloff chosen at run time.

#[allow(clippy::wildcard_imports, reason = "the types of the list")]
use super::*;
use super::{choice::choice, power::sound};
use crate::{
    effect::Effect,
    error::Error,
    models::{SAMPLES, falloffs},
};

/// Declares the enums over all falloffs of the list in `models`.
macro_rules! any_falloff {
    ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr
       $(, any $any:expr)? $(, constant $constant:ty = $its_name:literal, $value:expr, $its_truth:expr)?;)*) => {
        choice! {
            /// Any falloff, chosen at run time: for a light of [another system](crate::import) or
            /// an [`AnyLight`](crate::dynamic::AnyLight).
            ///
            /// The evaluation branches per point;
            /// [`CompiledAnyLight::evaluate_each`](crate::dynamic::CompiledAnyLight::evaluate_each)
            /// branches once per light.
            #[non_exhaustive]
            AnyFalloff, CompiledAnyFalloff { $($(#[$doc])* $variant($type),)* }
        }

        impl AnyFalloff {
            /// Returns one sample value of each falloff, for galleries and tests.
            pub fn samples() -> impl Iterator<Item = Self> {
                let samples = [$($sample.map(Self::$variant),)*];
                samples.into_iter().filter_map(|sample: Result<Self, Error>| sample.ok())
            }

            /// The number of falloffs.
            #[cfg(feature = "arithmetic")]
            pub const COUNT: usize = [$($name),*].len();

            /// Builds the falloff with index `index % COUNT` from random numbers in [0, 1). For a
            /// falloff without parameters, the result is the sample value.
            ///
            /// # Errors
            /// An invalid combination of parameters.
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

            /// Returns the effect of the falloff.
            pub fn effect(&self) -> Effect {
                match self {
                    $(Self::$variant(_) => Effect::$variant,)*
                }
            }
        }
    };
}

/// Evaluates an expression with the concrete types of a compiled cone's falloff and curve. If the
/// variants of falloff and curve differ, which is only possible through `from_parts`, the
/// expression is evaluated with the enums.
macro_rules! with_falloff {
    ([$cone:expr, $falloff:ident, $curve:ident, $answer:expr]
     $($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr
       $(, any $any:expr)? $(, constant $constant:ty = $its_name:literal, $value:expr, $its_truth:expr)?;)*) => {
        match ($cone.falloff, $cone.curve) {
            $(($crate::falloff::AnyFalloff::$variant($falloff),
               $crate::falloff::CompiledAnyFalloff::$variant($curve)) => $answer,)*
            ($falloff, $curve) => $answer,
        }
    };
    ($cone:expr, $falloff:ident, $curve:ident => $answer:expr) => {
        $crate::models::falloffs!(with_falloff; [$cone, $falloff, $curve, $answer])
    };
}

pub(crate) use with_falloff;

falloffs!(any_falloff);

impl AnyFalloff {
    /// Returns the cheapest falloff whose intensity is `t^n`, for `n` in [0, 1024]. `n = 0` gives a step.
    pub(crate) fn power(exponent: u32) -> Self {
        match exponent {
            0 => Self::Step(Step),
            1 => Self::Linear(Linear),
            2 => Self::Soft(Soft),
            _ => Self::Power(IntegerPower::of(exponent)),
        }
    }

    /// Returns `t^p` as the cheapest falloff, for real `p` in [0, 1024].
    pub(crate) fn real_power(exponent: f32) -> Self {
        let whole = exponent as u32;
        if whole as f32 == exponent { Self::power(whole) } else { Self::RealPower(RealPower::of(exponent)) }
    }

    /// Returns `1 - u^n` as the cheapest falloff, for `n` in [1, 1024].
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
