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
    models::{Listed, Parameters, Random, draw, listed},
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

/// Declares the enums of all listed attenuations, and their methods with one match arm per row.
macro_rules! any_attenuation {
    ($(#[doc = $doc:literal] $variant:ident($type:ty) $(from $law:ty)? = $make:expr
       $(, effect #[doc = $effect_doc:literal] $effect:ident = $effect_name:literal)?
       $(, #[doc = $its_doc:literal] $constant:ty = $its_name:literal, $value:expr)*;)*) => {
        /// Any attenuation, chosen at run time: for a light of [another system](crate::import) or
        /// an [`AnyLight`](crate::dynamic::AnyLight).
        ///
        /// The enum branches per point.
        /// [`CompiledAnyLight::evaluate_each`](crate::dynamic::CompiledAnyLight::evaluate_each)
        /// branches once per light.
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
            /// The number of attenuations.
            #[cfg(feature = "arithmetic")]
            pub const COUNT: usize = [$(stringify!($variant)),*].len();

            /// Builds the attenuation with index `index % COUNT` from random numbers in [0, 1).
            ///
            /// # Errors
            /// Invalid parameters.
            #[cfg(feature = "arithmetic")]
            pub fn drawn(index: usize, number: impl FnMut() -> f32) -> Result<Self, Error> {
                Self::built(index, &mut Random(number))
            }

            /// Builds the attenuation with index `index % COUNT` from parameters.
            ///
            /// # Errors
            /// Invalid parameters.
            #[cfg(feature = "arithmetic")]
            pub fn built(index: usize, parameters: &mut impl Parameters) -> Result<Self, Error> {
                let (index, mut rows) = (index % Self::COUNT, 0..);
                $(
                    if rows.next() == Some(index) {
                        return draw(parameters, $make).map(Self::$variant);
                    }
                )*
                Ok(NoAttenuation.into())
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
        listed! { $($(#[doc = $its_doc] $constant = $its_name, $value;)*)* }

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

            fn describe(&self, to: &mut dyn Describe) {
                match self {
                    $(Self::$variant(attenuation) => attenuation.describe(to),)*
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
