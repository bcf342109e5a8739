//! The number formats as constant expressions.

#[cfg(feature = "fixed")]
use crate::number::{
    Fx16, Fx32, Length, Light16, Light32, Weight16, Weight32,
    fx16::{Frame16, Gain16},
    fx32::{Frame32, Gain32},
    ramp::FixedRamp,
};
use crate::{
    number::{
        InversePower,
        float::{FloatFrame, FloatRamp},
    },
    source::{named, written_by_bits},
};

named!(f32);
written_by_bits!(f32 FloatFrame FloatRamp InversePower);

#[cfg(feature = "fixed")]
named!(Fx16 Fx32);
#[cfg(feature = "fixed")]
written_by_bits!(Fx16 Fx32 Length Weight16 Weight32 Light16 Light32);
#[cfg(feature = "fixed")]
written_by_bits!(Frame16 Frame32 Gain16 Gain32 FixedRamp);
