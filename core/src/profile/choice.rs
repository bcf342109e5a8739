//! Profiles chosen at run time, at the price of a branch per point. A renderer matches on them once per light and calls
//! `with_profile`.

use super::{Blend, Cubic, Curve, Formula, Hard, Profile, Soft, without_coefficients};
use crate::scalar::{Fraction, Scalar};

/// One of the two profiles of one multiply, chosen at run time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Edge {
    /// As [`Soft`].
    Soft,
    /// As [`Hard`].
    Hard,
}

/// Declares an enum of falloffs, the enum of them compiled, and both as the falloff that they hold.
macro_rules! choice {
    ($(#[$meta:meta])* $choice:ident, $compiled:ident { $($(#[$doc:meta])* $variant:ident($type:ty),)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub enum $choice {
            $($(#[$doc])* $variant($type),)*
        }

        #[doc = concat!("A [`", stringify!($choice), "`] in the format `S`.")]
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub enum $compiled<S: $crate::scalar::Scalar> {
            $($(#[$doc])* $variant(<$type as Profile>::Compiled<S>),)*
        }

        $(impl From<$type> for $choice {
            fn from(falloff: $type) -> Self {
                Self::$variant(falloff)
            }
        })*

        impl Profile for $choice {
            type Compiled<S: $crate::scalar::Scalar> = $compiled<S>;

            fn compile<S: $crate::scalar::Scalar>(self) -> $compiled<S> {
                match self {
                    $(Self::$variant(falloff) => $compiled::$variant(Profile::compile::<S>(falloff)),)*
                }
            }

            fn formula(&self) -> $crate::profile::Formula<'_> {
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

        impl<S: $crate::scalar::Scalar> Curve<S> for $compiled<S> {
            #[inline(always)]
            fn intensity<F: $crate::scalar::Fraction<S>>(self, t: F) -> F::Value {
                match self {
                    $(Self::$variant(curve) => curve.intensity(t),)*
                }
            }
        }
    };
}
pub(super) use choice;

choice! {
    /// The falloff that has a pair of angles: see [`Cone::from_beam_and_field`](crate::Cone::from_beam_and_field).
    Fitted, CompiledFitted {
        /// A quadratic.
        Blend(Blend),
        /// A cubic, where no quadratic has these angles.
        Cubic(Cubic),
    }
}

/// What the chosen edge answers.
macro_rules! edge {
    ($choice:ident, $profile:ident => $answer:expr) => {
        match $choice {
            Self::Soft => {
                let $profile = Soft;
                $answer
            }
            Self::Hard => {
                let $profile = Hard;
                $answer
            }
        }
    };
}

impl Profile for Edge {
    without_coefficients!();

    fn formula(&self) -> Formula<'_> {
        match self {
            Self::Soft => Formula::Polynomial([0.0, 1.0, 0.0]),
            Self::Hard => Formula::Polynomial([2.0, -1.0, 0.0]),
        }
    }

    fn beam_versine(self) -> f32 {
        edge!(self, profile => profile.beam_versine())
    }

    fn field_versine(self) -> f32 {
        edge!(self, profile => profile.field_versine())
    }

    fn steepness(self, hotspot: f32) -> f32 {
        edge!(self, profile => profile.steepness(hotspot))
    }

    fn integral(self, u: f32) -> f32 {
        edge!(self, profile => profile.integral(u))
    }
}

impl<S: Scalar> Curve<S> for Edge {
    #[inline(always)]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        edge!(self, profile => profile.intensity(t))
    }
}
