//! The attenuations of the list: the choice at run time, and a visit of each.

use core::fmt::{self, Formatter};

#[allow(clippy::wildcard_imports, reason = "the types of the list")]
use super::*;
use crate::{
    effect::Effects,
    models::attenuations,
    number::{Offset, Ray, Scalar},
    source::{Source, call, named},
};
#[cfg(feature = "arithmetic")]
use crate::{
    error::Error,
    model::{Model, Number, each, given},
    models::{Listed, listed},
};

/// Takes the constants of an attenuation with its type.
pub(crate) trait WithConstants<S: Scalar> {
    /// Takes the constants.
    fn constants<A: Attenuation>(self, constants: &A::Constants<S>);
}

/// A visitor of the attenuations of the list.
#[cfg(feature = "arithmetic")]
pub trait AttenuationVisitor {
    /// Visits an attenuation.
    fn attenuation<A: Listed + Attenuation>(&mut self);
}

/// What the list knows of an attenuation: a law of the distance, and how it ends.
#[cfg(feature = "arithmetic")]
#[derive(Clone, Copy, Debug)]
pub struct AttenuationRow {
    /// The name of the law in data and in words of a command. An attenuation of the same law with another window
    /// has it, too.
    pub law: &'static str,
    /// The type of the law, as Rust writes it.
    pub law_type: &'static str,
    /// The type of the attenuation, as Rust writes it.
    pub type_name: &'static str,
    /// The numbers that the law is made from, in their order.
    pub numbers: &'static [Number],
    /// The name of the window that ends the law at a range, or leaves it without an end; `None` for a law that ends
    /// by itself.
    pub window: Option<&'static str>,
    of: fn(&[f32], Option<f32>) -> Result<AnyAttenuation, Error>,
}

#[cfg(feature = "arithmetic")]
impl AttenuationRow {
    /// Returns the numbers of the law that are not its range.
    pub fn beside_range(&self) -> impl Iterator<Item = &'static Number> {
        self.numbers.iter().filter(|number| !number.is_range())
    }

    /// Creates the attenuation from the numbers of its law without the range, and the range. Numbers that may be left
    /// out have their default where they are.
    ///
    /// # Errors
    /// Numbers that the constructor refuses. One that is missing is NaN.
    pub fn of(&self, numbers: &[f32], range: Option<f32>) -> Result<AnyAttenuation, Error> {
        let mut given = numbers.iter().copied();
        let value = |number: &Number| {
            let value = if number.is_range() { range } else { given.next().or(number.default) };
            value.unwrap_or(f32::NAN)
        };
        (self.of)(&each(self.numbers, value), range)
    }

    /// Creates the attenuation without a window from all numbers of its law, of which one may be a range.
    ///
    /// # Errors
    /// Numbers that the constructor refuses. One that is missing is NaN.
    pub fn of_law(&self, numbers: &[f32]) -> Result<AnyAttenuation, Error> {
        (self.of)(&given(self.numbers, numbers), None)
    }

    /// Creates a random attenuation, whose numbers are drawn by a function.
    fn random(
        &self,
        drawn: impl Fn(&Number, f32) -> f32,
        mut random: impl FnMut() -> f32,
    ) -> Result<AnyAttenuation, Error> {
        let numbers = each(self.numbers, |own| drawn(own, random()));
        let has_range = self.window.is_some() && random() >= 0.1;
        (self.of)(&numbers, has_range.then(|| drawn(&Number::range(), random())))
    }
}

/// An attenuation of the list in its parts: a law of the distance, and the window that ends it.
#[cfg(feature = "arithmetic")]
trait InParts: Attenuation {
    /// The law.
    type Law: Model;
    /// The name of the window.
    const WINDOW: Option<&'static str>;

    /// Creates the attenuation from the numbers of its law, and the range of its window.
    fn of(numbers: &[f32], range: Option<f32>) -> Result<Self, Error>;

    /// Returns the law.
    fn law(&self) -> Self::Law;
}

#[cfg(feature = "arithmetic")]
impl<W: Window, A: Attenuation + Model> InParts for Ranged<W, A> {
    type Law = A;
    const WINDOW: Option<&'static str> = Some(W::KEY);

    fn of(numbers: &[f32], range: Option<f32>) -> Result<Self, Error> {
        Self::new(A::of(numbers)?, range)
    }

    fn law(&self) -> A {
        self.attenuation()
    }
}

#[cfg(feature = "arithmetic")]
impl<A: Attenuation + Model> InParts for A {
    type Law = A;
    const WINDOW: Option<&'static str> = None;

    fn of(numbers: &[f32], _: Option<f32>) -> Result<Self, Error> {
        <A as Model>::of(numbers)
    }

    fn law(&self) -> A {
        *self
    }
}

/// Returns the value of an attenuation whose numbers and range are those of its sample.
#[cfg(feature = "arithmetic")]
fn sample<A: InParts>() -> Result<A, Error> {
    A::of(&each(A::Law::NUMBERS, Number::in_sample), Some(Number::range().sample))
}

/// Declares the enums of all listed attenuations, and their methods with one match arm per row.
macro_rules! any_attenuation {
    ($(#[doc = $doc:literal] $variant:ident($type:ty) $(from $law:ty)? = $name:literal
       $(, effect #[doc = $effect_doc:literal] $effect:ident = $effect_name:literal)?
       $(, #[doc = $its_doc:literal] $constant:ty = $its_name:literal)*;)*) => {
        /// Any attenuation, chosen at run time: for a light of another system or
        /// an [`AnyLight`](crate::dynamic::AnyLight).
        ///
        /// The enum branches per point. In `f32`,
        /// [`LightModel::evaluate_each`](crate::light::LightModel::evaluate_each)
        /// of an [`AnyLight`](crate::dynamic::AnyLight) branches once for many points; in fixed
        /// point it does so for the inverse square.
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[derive(Clone, Copy, PartialEq, Debug)]
        #[non_exhaustive]
        pub enum AnyAttenuation {
            $(#[doc = $doc] $variant($type),)*
        }

        /// The constants of an [`AnyAttenuation`].
        #[derive(Clone, Copy, PartialEq, Debug)]
        #[non_exhaustive]
        pub enum CompiledAnyAttenuation<S: Scalar> {
            $(#[doc = $doc] $variant(<$type as Attenuation>::Constants<S>),)*
        }

        $(impl From<$type> for AnyAttenuation {
            fn from(attenuation: $type) -> Self {
                Self::$variant(attenuation)
            }
        })*

        $($(impl From<$law> for AnyAttenuation {
            fn from(law: $law) -> Self {
                Self::$variant(CutAt::unlimited(law))
            }
        })?)*

        impl AnyAttenuation {
            /// The list: a row for each attenuation.
            #[cfg(feature = "arithmetic")]
            pub const LIST: &'static [AttenuationRow] = &[$(AttenuationRow {
                law: $name,
                law_type: <<$type as InParts>::Law as Model>::TYPE,
                type_name: stringify!($type),
                numbers: <<$type as InParts>::Law as Model>::NUMBERS,
                window: <$type as InParts>::WINDOW,
                of: |numbers, range| <$type as InParts>::of(numbers, range).map(Self::$variant),
            },)*];

            /// The number of attenuations.
            #[cfg(feature = "arithmetic")]
            pub const COUNT: usize = Self::LIST.len();

            /// Builds the attenuation with index `index % COUNT` from random numbers in [0, 1). One in ten
            /// with a window has no range.
            ///
            /// # Errors
            /// Numbers that the constructor refuses.
            #[cfg(feature = "arithmetic")]
            pub fn drawn(index: usize, number: impl FnMut() -> f32) -> Result<Self, Error> {
                Self::LIST[index % Self::COUNT].random(Number::drawn, number)
            }

            /// Builds the attenuation like [`drawn`](Self::drawn), from numbers in all that is accepted.
            ///
            /// # Errors
            /// Numbers that the constructor refuses.
            #[cfg(feature = "arithmetic")]
            pub fn anywhere(index: usize, number: impl FnMut() -> f32) -> Result<Self, Error> {
                Self::LIST[index % Self::COUNT].random(Number::anywhere, number)
            }

            /// Returns the row of the attenuation.
            #[cfg(feature = "arithmetic")]
            pub fn row(&self) -> &'static AttenuationRow {
                enum Place {
                    $($variant,)*
                }
                match self {
                    $(Self::$variant(_) => const { &Self::LIST[Place::$variant as usize] },)*
                }
            }

            /// Returns the numbers that the law is made from.
            #[cfg(feature = "arithmetic")]
            pub fn numbers(&self) -> impl Iterator<Item = f32> {
                (0..).map_while(move |place| match self {
                    $(Self::$variant(attenuation) => attenuation.law().number(place),)*
                })
            }

            /// Returns the range of the light; `None` for a light without a range.
            pub fn range(&self) -> Option<f32> {
                match self {
                    $(Self::$variant(attenuation) => Attenuation::range(attenuation),)*
                }
            }
        }

        impl<S: Scalar> CompiledAnyAttenuation<S> {
            /// Passes the constants with the type of their attenuation.
            #[inline]
            pub(crate) fn typed<V: WithConstants<S>>(&self, visitor: V) {
                match self {
                    $(Self::$variant(constants) => visitor.constants::<$type>(constants),)*
                }
            }
        }

        #[cfg(feature = "arithmetic")]
        listed! { $($(#[doc = $its_doc] $constant = $its_name, sample();)*)* }

        /// Visits the attenuations of programs that know the attenuation at compile time.
        #[cfg(feature = "arithmetic")]
        pub fn attenuations(visitor: &mut impl AttenuationVisitor) {
            $($(visitor.attenuation::<$constant>();)*)*
        }

        impl<S: Scalar> Source for CompiledAnyAttenuation<S> {
            fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
                match self {
                    $(Self::$variant(constants) => {
                        call(out, concat!("CompiledAnyAttenuation::", stringify!($variant)), &[constants])
                    })*
                }
            }
        }

        impl Attenuation for AnyAttenuation {
            type Constants<S: Scalar> = CompiledAnyAttenuation<S>;

            fn constants<S: Scalar>(self) -> CompiledAnyAttenuation<S> {
                match self {
                    $(Self::$variant(attenuation) => CompiledAnyAttenuation::$variant(attenuation.constants::<S>()),)*
                }
            }

            fn range(&self) -> Option<f32> {
                self.range()
            }

            fn effects(&self) -> Effects {
                match self {
                    $(Self::$variant(attenuation) => attenuation.effects(),)*
                }
            }

            fn exact(&self, distance: f64) -> f64 {
                match self {
                    $(Self::$variant(attenuation) => attenuation.exact(distance),)*
                }
            }

            fn growth(&self) -> f32 {
                match self {
                    $(Self::$variant(attenuation) => attenuation.growth(),)*
                }
            }

            #[cfg(feature = "arithmetic")]
            fn with<V: WithAttenuation>(self, visitor: V) -> V::Output {
                match self {
                    $(Self::$variant(attenuation) => attenuation.with(visitor),)*
                }
            }

            #[inline]
            fn is_inverse_square<S: Scalar>(constants: &CompiledAnyAttenuation<S>) -> bool {
                match constants {
                    $(CompiledAnyAttenuation::$variant(inner) => <$type>::is_inverse_square::<S>(inner),)*
                }
            }

            #[inline]
            fn is_beyond<S: Scalar, O: Offset<S>>(constants: &CompiledAnyAttenuation<S>, offset: &O) -> bool {
                match constants {
                    $(CompiledAnyAttenuation::$variant(inner) => <$type>::is_beyond::<S, O>(inner, offset),)*
                }
            }

            #[inline]
            fn windowed<S: Scalar, O: Offset<S>, R: Ray<S>>(
                constants: &CompiledAnyAttenuation<S>,
                offset: &O,
                ray: &R,
                share: R::Share,
            ) -> R::Share {
                match constants {
                    $(CompiledAnyAttenuation::$variant(inner) => <$type>::windowed::<S, O, R>(inner, offset, ray, share),)*
                }
            }

            #[inline]
            fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
                constants: &CompiledAnyAttenuation<S>,
                offset: &O,
                ray: &R,
                share: R::Share,
                intensity: S::Gain,
            ) -> S::Irradiance {
                match constants {
                    $(CompiledAnyAttenuation::$variant(inner) => {
                        <$type>::light::<S, O, R>(inner, offset, ray, share, intensity)
                    })*
                }
            }
        }
    };
}

attenuations!(any_attenuation);
named!(AnyAttenuation);
