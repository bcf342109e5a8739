//! The falloffs of the list: the choice at run time, and a visit of each.

#[allow(clippy::wildcard_imports, reason = "the types of the list")]
use super::*;
use super::{choice::choice, integer::MOST, power::sound};
#[cfg(feature = "arithmetic")]
use crate::models::{Listed, interpolated, listed, power, squared};
use crate::{
    effect::Effect,
    error::{Error, Parameter, check_between},
    model::{Model, Number, each, given},
    models::falloffs,
};

/// Takes a falloff and its coefficients as their own types.
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
pub trait WithFalloff<S: Scalar> {
    /// The result.
    type Output;

    /// Takes the falloff.
    fn falloff<P: Falloff>(self, falloff: P, curve: P::Compiled<S>) -> Self::Output;
}

/// A falloff of the list, and its exact function.
#[cfg(feature = "arithmetic")]
pub trait ListedFalloff: Listed + Falloff + Into<AnyFalloff> + Send + Sync + 'static {
    /// Returns the intensity of the [sample](Listed::sample) at `t` in f64, with few operations.
    fn truth(t: f64) -> f64;
}

/// A visitor of the falloffs of the list.
#[cfg(feature = "arithmetic")]
pub trait FalloffVisitor {
    /// Visits a falloff.
    fn falloff<P: ListedFalloff>(&mut self);
}

/// What the list knows of a falloff.
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
#[derive(Clone, Copy, Debug)]
pub struct FalloffRow {
    /// The name in data and in words of a command.
    pub name: &'static str,
    /// The numbers that the falloff is made from, in their order.
    pub numbers: &'static [Number],
    of: fn(&[f32]) -> Result<AnyFalloff, Error>,
}

impl FalloffRow {
    /// Creates the falloff from its numbers. Those that may be left out have their default where they are.
    ///
    /// # Errors
    /// Numbers that the constructor refuses. One that is missing is NaN.
    #[allow(unreachable_pub, reason = "public with the feature arithmetic")]
    pub fn of(&self, numbers: &[f32]) -> Result<AnyFalloff, Error> {
        (self.of)(&given(self.numbers, numbers))
    }

    /// Creates a random falloff, whose numbers are drawn by a function but for those that may be left out.
    #[cfg(feature = "arithmetic")]
    fn random(
        &self,
        drawn: impl Fn(&Number, f32) -> f32,
        mut random: impl FnMut() -> f32,
    ) -> Result<AnyFalloff, Error> {
        (self.of)(&each(self.numbers, |own| own.default.unwrap_or_else(|| drawn(own, random()))))
    }
}

/// Declares the enums over all falloffs of the list in `models`, and the visits of the list.
macro_rules! any_falloff {
    ($(#[doc = $doc:literal] $variant:ident($type:ty) = $name:literal, $truth:expr
       $(, constant $constant:ty = $its_name:literal, $value:expr, $its_truth:expr)?;)*) => {
        choice! {
            /// Any falloff, chosen at run time: for a light of another system or
            /// an [`AnyLight`](crate::dynamic::AnyLight).
            ///
            /// The evaluation branches per point. In `f32`,
            /// [`LightModel::evaluate_each`](crate::light::LightModel::evaluate_each)
            /// of an [`AnyLight`](crate::dynamic::AnyLight) branches once for many points.
            #[non_exhaustive]
            AnyFalloff, CompiledAnyFalloff { $(#[doc = $doc] $variant($type),)* }
        }

        impl AnyFalloff {
            /// The list: a row for each falloff.
            #[allow(unreachable_pub, reason = "public with the feature arithmetic")]
            pub const LIST: &'static [FalloffRow] = &[$(FalloffRow {
                name: $name,
                numbers: <$type as Model>::NUMBERS,
                of: |numbers| <$type as Model>::of(numbers).map(Self::$variant),
            },)*];

            /// Returns one sample value of each falloff, for galleries and tests.
            pub fn samples() -> impl Iterator<Item = Self> {
                Self::LIST.iter().filter_map(|row| (row.of)(&each(row.numbers, Number::in_sample)).ok())
            }

            /// The number of falloffs.
            #[cfg(feature = "arithmetic")]
            pub const COUNT: usize = Self::LIST.len();

            /// Builds the falloff with index `index % COUNT` from random numbers in [0, 1). For a
            /// falloff without numbers, the result is the sample value.
            ///
            /// # Errors
            /// An invalid combination of numbers.
            #[cfg(feature = "arithmetic")]
            pub fn drawn(index: usize, number: impl FnMut() -> f32) -> Result<Self, Error> {
                Self::LIST[index % Self::COUNT].random(Number::drawn, number)
            }

            /// Builds the falloff like [`drawn`](Self::drawn), from numbers in all that is accepted.
            ///
            /// # Errors
            /// An invalid combination of numbers.
            #[cfg(feature = "arithmetic")]
            pub fn anywhere(index: usize, number: impl FnMut() -> f32) -> Result<Self, Error> {
                Self::LIST[index % Self::COUNT].random(Number::anywhere, number)
            }

            /// Returns the row of the falloff.
            #[cfg(feature = "arithmetic")]
            pub fn row(&self) -> &'static FalloffRow {
                enum Place {
                    $($variant,)*
                }
                match self {
                    $(Self::$variant(_) => const { &Self::LIST[Place::$variant as usize] },)*
                }
            }

            /// Returns the numbers that the falloff is made from.
            #[cfg(feature = "arithmetic")]
            pub fn numbers(&self) -> impl Iterator<Item = f32> {
                (0..).map_while(move |place| match self {
                    $(Self::$variant(falloff) => falloff.number(place),)*
                })
            }

            /// Returns the effect of the falloff.
            pub fn effect(&self) -> Effect {
                match self {
                    $(Self::$variant(_) => Effect::$variant,)*
                }
            }

            /// Returns the name of the falloff's type.
            #[cfg(feature = "arithmetic")]
            pub fn type_name(&self) -> &'static str {
                match self {
                    $(Self::$variant(_) => <$type as Listed>::TYPE,)*
                }
            }
        }

        /// Passes a falloff and its coefficients as their own types. If their variants differ, which
        /// is only possible through `from_parts`, the enums are passed.
        #[inline]
        #[allow(unreachable_pub, reason = "public with the feature arithmetic")]
        pub fn with_falloff<S: Scalar, V: WithFalloff<S>>(
            falloff: AnyFalloff,
            curve: CompiledAnyFalloff<S>,
            visitor: V,
        ) -> V::Output {
            match (falloff, curve) {
                $((AnyFalloff::$variant(falloff), CompiledAnyFalloff::$variant(curve)) => {
                    visitor.falloff(falloff, curve)
                })*
                (falloff, curve) => visitor.falloff(falloff, curve),
            }
        }

        $(any_falloff! { @listed #[doc = $doc] $type = $name, crate::model::sample(), $truth; }
          $(any_falloff! { @listed #[doc = $doc] $constant = $its_name, Ok($value), $its_truth; })?)*

        /// Visits the falloffs that can be chosen at run time.
        #[cfg(feature = "arithmetic")]
        pub fn falloffs(visitor: &mut impl FalloffVisitor) {
            $(visitor.falloff::<$type>();)*
        }

        /// Visits the falloffs of programs that know the falloff at compile time.
        #[cfg(feature = "arithmetic")]
        pub fn constant_falloffs(visitor: &mut impl FalloffVisitor) {
            $(visitor.falloff::<any_falloff!(@last $type $(, $constant)?)>();)*
        }
    };
    (@listed #[doc = $doc:literal] $type:ty = $name:literal, $sample:expr, $truth:expr;) => {
        #[cfg(feature = "arithmetic")]
        listed! { #[doc = $doc] $type = $name, $sample; }

        #[cfg(feature = "arithmetic")]
        impl ListedFalloff for $type {
            #[inline(always)]
            fn truth(t: f64) -> f64 {
                let truth: fn(f64) -> f64 = $truth;
                truth(t)
            }
        }
    };
    (@last $type:ty) => { $type };
    (@last $type:ty, $constant:ty) => { $constant };
}

falloffs!(any_falloff);

// A power so high that rounding shows: for the price list alone.
any_falloff! { @listed
    /// The sixteenth power.
    Power<16> = "power-16", Ok(Power), |t| squared(squared(squared(squared(t))));
}

impl AnyFalloff {
    /// Returns the cheapest falloff of the list whose intensity is `t^p`; `p = 0` gives a step. In a cone with an
    /// outer angle of 180 degrees, `t` is the cosine of the angle off axis.
    ///
    /// # Errors
    /// An exponent outside [0, 1024].
    pub fn power(exponent: f32) -> Result<Self, Error> {
        check_between(Parameter::Exponent, exponent, 0.0, MOST as f32)?;
        let whole = exponent as u32;
        let is_whole = whole as f32 == exponent;
        if is_whole { Ok(Self::integer_power(whole)) } else { RealPower::new(exponent).map(Self::RealPower) }
    }

    /// Returns the cheapest falloff whose intensity is `t^n`, for `n` in [0, 1024]. `n = 0` gives a step.
    fn integer_power(exponent: u32) -> Self {
        match exponent {
            0 => Self::Step(Step),
            1 => Self::Linear(Linear),
            2 => Self::Soft(Soft),
            _ => Self::Power(IntegerPower::of(exponent)),
        }
    }

    /// Returns `1 - u^n` as the cheapest falloff, for `n` in [1, 1024].
    fn inverted_power(exponent: u32) -> Self {
        match exponent {
            1 => Self::Linear(Linear),
            2 => Self::Hard(Hard),
            _ => Self::InvertedPower(InvertedIntegerPower::of(exponent)),
        }
    }
}

impl<const N: u32> From<Power<N>> for AnyFalloff {
    fn from(_: Power<N>) -> Self {
        Self::integer_power(sound::<N>())
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

impl From<SoftEdged> for AnyFalloff {
    fn from(edge: SoftEdged) -> Self {
        match edge {
            SoftEdged::Cubic(cubic) => Self::Cubic(cubic),
            SoftEdged::SoftPair(pair) => Self::SoftPair(pair),
        }
    }
}
