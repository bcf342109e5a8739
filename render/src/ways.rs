//! The length and the direction of a way, by the kernel's root: the processor's own where there is one.

use glam::Vec3;
use luminaire::{
    Scalar,
    number::{Offset, Ray},
};

/// The length; zero for a way so short that its square is no normal number.
#[inline(always)]
pub(crate) fn length(way: Vec3) -> f32 {
    offset(way).ray().distance()
}

/// The direction; zero for a way so short that its square is no normal number.
#[inline(always)]
pub(crate) fn direction(way: Vec3) -> Vec3 {
    offset(way).ray().direction().into()
}

/// The direction and the reciprocal of the length; zero for a way so short that its square is no normal number.
#[inline(always)]
pub(crate) fn direction_and_reciprocal(way: Vec3) -> (Vec3, f32) {
    let offset = offset(way);
    (offset.ray().direction().into(), offset.reciprocal())
}

#[inline(always)]
fn offset(way: Vec3) -> <f32 as Scalar>::Offset {
    f32::offset(luminaire::Vec3::default(), way.into())
}
