//! The length and the direction of a way, by the kernel's root: the processor's own where there is one.

use glam::Vec3;

/// The length; zero for a way so short that its square is no normal number.
#[inline(always)]
pub(crate) fn length(way: Vec3) -> f32 {
    luminaire::Vec3::from(way).length()
}

/// The direction; zero for a way so short that its square is no normal number.
#[inline(always)]
pub(crate) fn direction(way: Vec3) -> Vec3 {
    luminaire::Vec3::from(way).unit().into()
}

/// The direction and the reciprocal of the length; zero for a way so short that its square is no normal number.
#[inline(always)]
pub(crate) fn direction_and_reciprocal(way: Vec3) -> (Vec3, f32) {
    (direction(way), luminaire::Vec3::from(way).reciprocal_length())
}
