//! An attenuation chosen at run time.

use core::fmt::{self, Formatter};

use super::{
    Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
    Windowed,
};
use crate::{
    effect::Effects,
    models::attenuations,
    number::{Offset, Ray, Scalar},
    source::{Source, call, named},
};

/// Declares the enums of all listed attenuations, and their methods with one match arm per row.
macro_rules! any_attenuation {
    ($($(#[$doc:meta])* $variant:ident($type:ty) = any $any:expr
       $(, $(#[$its_doc:meta])* $constant:ty = $its_name:literal, $value:expr)*;)*) => {
        /// Any attenuation, chosen at run time: for a light of [another system](crate::import) or
        /// an [`AnyLight`](crate::dynamic::AnyLight).
        ///
        /// The enum branches per point.
        /// [`CompiledAnyLight::evaluate_each`](crate::dynamic::CompiledAnyLight::evaluate_each)
        /// branches once per light.
        #[derive(Clone, Copy, PartialEq, Debug)]
        #[non_exhaustive]
        pub enum AnyAttenuation {
            $($(#[$doc])* $variant($type),)*
        }

        /// The constants of an [`AnyAttenuation`].
        #[derive(Clone, Copy, PartialEq, Debug)]
        #[non_exhaustive]
        pub enum CompiledAnyAttenuation<S: Scalar> {
            $($(#[$doc])* $variant(<$type as Attenuation>::Constants<S>),)*
        }

        $(impl From<$type> for AnyAttenuation {
            fn from(attenuation: $type) -> Self {
                Self::$variant(attenuation)
            }
        })*

        impl AnyAttenuation {
            /// The number of attenuations.
            #[cfg(feature = "arithmetic")]
            pub const COUNT: usize = [$(stringify!($variant)),*].len();

            /// Builds the attenuation with index `index % COUNT` from random numbers in [0, 1).
            ///
            /// # Errors
            /// Invalid parameters.
            #[cfg(feature = "arithmetic")]
            pub fn drawn(index: usize, mut number: impl FnMut() -> f32) -> Result<Self, crate::error::Error> {
                use crate::models::{draw, range};
                let (index, mut rows) = (index % Self::COUNT, 0..);
                $(
                    if rows.next() == Some(index) {
                        return draw(&mut number, $any).map(Self::$variant);
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

        impl<S: Scalar<Gain: Source>> Source for CompiledAnyAttenuation<S> {
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

            fn grows(&self) -> bool {
                match self {
                    $(Self::$variant(attenuation) => attenuation.grows(),)*
                }
            }

            #[inline]
            fn is_inverse_square<S: Scalar>(constants: &CompiledAnyAttenuation<S>) -> bool {
                with_attenuation!(constants, inner: Inner => Inner::is_inverse_square::<S>(inner))
            }

            #[inline]
            fn is_beyond<S: Scalar, O: Offset<S>>(constants: &CompiledAnyAttenuation<S>, offset: &O) -> bool {
                with_attenuation!(constants, inner: Inner => Inner::is_beyond::<S, O>(inner, offset))
            }

            #[inline]
            fn windowed<S: Scalar, O: Offset<S>, R: Ray<S>>(
                constants: &CompiledAnyAttenuation<S>,
                offset: &O,
                ray: &R,
                share: R::Share,
            ) -> R::Share {
                with_attenuation!(constants, inner: Inner => Inner::windowed::<S, O, R>(inner, offset, ray, share))
            }

            #[inline]
            fn expose<S: Scalar, O: Offset<S>, R: Ray<S>>(
                constants: &CompiledAnyAttenuation<S>,
                offset: &O,
                ray: &R,
                share: R::Share,
                intensity: S::Gain,
            ) -> S::Irradiance {
                with_attenuation!(constants, inner: Inner => {
                    Inner::expose::<S, O, R>(inner, offset, ray, share, intensity)
                })
            }
        }
    };
}

/// Evaluates an expression with the constants of a [`CompiledAnyAttenuation`] and the concrete type
/// of the attenuation.
macro_rules! with_attenuation {
    ([$compiled:expr, $constants:ident, $type:ident, $answer:expr]
     $($(#[$doc:meta])* $variant:ident($attenuation:ty) = any $any:expr
       $(, $(#[$its_doc:meta])* $constant:ty = $its_name:literal, $value:expr)*;)*) => {
        match $compiled {
            $($crate::attenuation::CompiledAnyAttenuation::$variant($constants) => {
                #[allow(clippy::wildcard_imports, reason = "the types of the list, wherever it is used")]
                use $crate::attenuation::*;
                type $type = $attenuation;
                $answer
            })*
        }
    };
    ($compiled:expr, $constants:ident: $type:ident => $answer:expr) => {
        $crate::models::attenuations!(with_attenuation; [$compiled, $constants, $type, $answer])
    };
}

pub(crate) use with_attenuation;

attenuations!(any_attenuation);
named!(AnyAttenuation);

/// Implements the conversion of an attenuation without a range into the variant with `range: None`.
macro_rules! from_unlimited {
    ($($type:ty => $variant:ident)*) => {$(
        impl From<$type> for AnyAttenuation {
            fn from(attenuation: $type) -> Self {
                Self::$variant(CutAt::unlimited(attenuation))
            }
        }
    )*};
}

from_unlimited!(NoAttenuation => Constant InverseSquare => InverseSquare Polynomial => Polynomial);
