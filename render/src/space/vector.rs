//! Length and direction of a vector, by the kernel's square root.

use glam::Vec3;

/// Returns the length; zero for a vector so short that its square is subnormal or zero.
#[inline(always)]
pub(crate) fn length(way: Vec3) -> f32 {
    luminaire::Vec3::from(way).length()
}

/// Returns the correctly rounded square root, by the processor's instruction if the feature `std` is
/// on.
#[inline(always)]
pub(crate) fn sqrt(square: f32) -> f32 {
    #[cfg(feature = "std")]
    return square.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrtf(square);
}

/// Returns the direction; zero for a vector so short that its square is subnormal or zero.
#[inline(always)]
pub(crate) fn direction(way: Vec3) -> Vec3 {
    luminaire::Vec3::from(way).unit().into()
}

/// Returns the direction and the reciprocal of the length.
///
/// Both are zero for a vector so short that its square is subnormal or zero.
#[inline(always)]
pub(crate) fn direction_and_reciprocal(way: Vec3) -> (Vec3, f32) {
    (direction(way), luminaire::Vec3::from(way).reciprocal_length())
}
