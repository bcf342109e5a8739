//! Falloffs chosen at run time, with a branch per point. To branch once per light instead, a
//! renderer matches on the variant and calls `with_falloff`.

use core::fmt::{self, Formatter};

use super::{CompiledFalloff, Cubic, Falloff, Formula, Hard, Quadratic, Soft, compiled::Square};
use crate::{
    number::{Fraction, Scalar},
    source::Source,
};

/// [`Soft`] or [`Hard`], chosen at run time: the two falloffs that cost one multiply.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SoftOrHard {
    /// The falloff [`Soft`].
    Soft,
    /// The falloff [`Hard`].
    Hard,
}

/// Declares an enum of falloffs and the enum of their compiled forms. Both enums delegate to the
/// falloff of the variant.
macro_rules! choice {
    ($(#[$meta:meta])* $choice:ident, $compiled:ident { $($(#[$doc:meta])* $variant:ident($type:ty),)* }) => {
        $(#[$meta])*
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub enum $choice {
            $($(#[$doc])* $variant($type),)*
        }

        #[doc = concat!("[`", stringify!($choice), "`] in the format `S`.")]
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub enum $compiled<S: $crate::number::Scalar> {
            $($(#[$doc])* $variant(<$type as Falloff>::Compiled<S>),)*
        }

        $(impl From<$type> for $choice {
            fn from(falloff: $type) -> Self {
                Self::$variant(falloff)
            }
        })*

        impl<S: $crate::number::Scalar> From<$choice> for $compiled<S> {
            fn from(choice: $choice) -> Self {
                match choice {
                    $($choice::$variant(falloff) => Self::$variant(Falloff::compile::<S>(falloff)),)*
                }
            }
        }

        impl Falloff for $choice {
            type Compiled<S: $crate::number::Scalar> = $compiled<S>;

            fn formula(&self) -> $crate::falloff::Formula<'_> {
                match self {
                    $(Self::$variant(falloff) => falloff.formula(),)*
                }
            }

            fn beam_versine(self) -> f32 {
                match self {
                    $(Self::$variant(falloff) => falloff.beam_versine(),)*
                }
            }

            fn field_versine(self) -> f32 {
                match self {
                    $(Self::$variant(falloff) => falloff.field_versine(),)*
                }
            }

            fn steepness(self, hotspot: f32) -> f32 {
                match self {
                    $(Self::$variant(falloff) => falloff.steepness(hotspot),)*
                }
            }

            fn integral(self, u: f32) -> f32 {
                match self {
                    $(Self::$variant(falloff) => falloff.integral(u),)*
                }
            }
        }

        impl $crate::source::Source for $choice {
            fn write(&self, out: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {
                    $(Self::$variant(falloff) => {
                        $crate::source::call(out, concat!(stringify!($choice), "::", stringify!($variant)), &[falloff])
                    })*
                }
            }
        }

        impl<S: $crate::number::Scalar> $crate::source::Source for $compiled<S> {
            fn write(&self, out: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {
                    $(Self::$variant(curve) => {
                        $crate::source::call(out, concat!(stringify!($compiled), "::", stringify!($variant)), &[curve])
                    })*
                }
            }
        }

        impl<S: $crate::number::Scalar> CompiledFalloff<S> for $compiled<S> {
            #[inline]
            fn intensity<F: $crate::number::Fraction<S>>(self, t: F) -> F::Value {
                match self {
                    $(Self::$variant(curve) => curve.intensity(t),)*
                }
            }

            #[inline]
            fn as_cubic(self) -> Option<[S::Weight; 2]> {
                match self {
                    $(Self::$variant(curve) => CompiledFalloff::<S>::as_cubic(curve),)*
                }
            }

            #[inline]
            fn as_square(self) -> Option<$crate::falloff::compiled::Square> {
                match self {
                    $(Self::$variant(curve) => CompiledFalloff::<S>::as_square(curve),)*
                }
            }
        }
    };
}
pub(super) use choice;

choice! {
    /// The falloff fitted to a beam and a field angle: see
    /// [`Cone::from_beam_and_field`](crate::Cone::from_beam_and_field).
    FittedFalloff, CompiledFittedFalloff {
        /// A quadratic.
        Quadratic(Quadratic),
        /// A cubic, for pairs of angles that no quadratic has.
        Cubic(Cubic),
    }
}

/// Evaluates an expression with the type of the chosen falloff.
macro_rules! edge {
    ($choice:ident, $falloff:ident => $answer:expr) => {
        match $choice {
            Self::Soft => {
                let $falloff = Soft;
                $answer
            }
            Self::Hard => {
                let $falloff = Hard;
                $answer
            }
        }
    };
}

impl Source for SoftOrHard {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "SoftOrHard::{self:?}")
    }
}

impl Falloff for SoftOrHard {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        match self {
            Self::Soft => Formula::Polynomial([0.0, 1.0, 0.0]),
            Self::Hard => Formula::Polynomial([2.0, -1.0, 0.0]),
        }
    }

    fn beam_versine(self) -> f32 {
        edge!(self, falloff => falloff.beam_versine())
    }

    fn field_versine(self) -> f32 {
        edge!(self, falloff => falloff.field_versine())
    }

    fn steepness(self, hotspot: f32) -> f32 {
        edge!(self, falloff => falloff.steepness(hotspot))
    }

    fn integral(self, u: f32) -> f32 {
        edge!(self, falloff => falloff.integral(u))
    }
}

impl<S: Scalar> CompiledFalloff<S> for SoftOrHard {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        edge!(self, falloff => falloff.intensity(t))
    }

    #[inline]
    fn as_cubic(self) -> Option<[S::Weight; 2]> {
        edge!(self, falloff => CompiledFalloff::<S>::as_cubic(falloff))
    }

    #[inline]
    fn as_square(self) -> Option<Square> {
        edge!(self, falloff => CompiledFalloff::<S>::as_square(falloff))
    }
}
