//! The number formats as constant expressions.

#[cfg(feature = "fixed")]
use crate::number::{
    Fx16, Fx32, Length, Light16, Light32, Weight16, Weight32,
    fixed16::{Frame16, Gain16},
    fixed32::{Frame32, Gain32},
    ramp::FixedRamp,
};
use crate::{
    number::{
        Scalar,
        float::{FloatFrame, FloatRamp},
    },
    source::{Named, Source, named, written_by_bits},
};

/// A number format whose values can be written as constant expressions. All formats implement it.
pub trait SourceScalar:
    Scalar<
        Length: Source,
        Unit: Source,
        Weight: Source,
        Ramp: Source,
        Frame: Source,
        Gain: Source,
        Irradiance: Source,
    > + Source
    + Named
{
}

impl SourceScalar for f32 {}
named!(f32);
written_by_bits!(f32 FloatFrame FloatRamp);

#[cfg(feature = "fixed")]
impl SourceScalar for Fx16 {}
#[cfg(feature = "fixed")]
impl SourceScalar for Fx32 {}
#[cfg(feature = "fixed")]
named!(Fx16 Fx32);
#[cfg(feature = "fixed")]
written_by_bits!(Fx16 Fx32 Length Weight16 Weight32 Light16 Light32);
#[cfg(feature = "fixed")]
written_by_bits!(Frame16 Frame32 Gain16 Gain32 FixedRamp);
