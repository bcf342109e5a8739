//! The private interface of the quick evaluation: fewer instructions, and a larger error.

use super::{Arithmetic, Offset, Ray, Slopes};
use crate::vec3::Vec3;

/// The quick evaluation of a number format.
///
/// Points, normals and light are those of the format itself, so one scene can have lights of both
/// evaluations. A light chooses the quick evaluation with
/// [`SpotLight::compile_quick`](crate::SpotLight::compile_quick).
pub trait Quick: Arithmetic {
    /// [`Arithmetic::Offset`] with fewer bits, or a less accurate root.
    type QuickOffset: Offset<
            Self,
            Ray: Ray<Self, Ramp = Self::QuickRamp>,
            Facing = <<Self as Arithmetic>::Offset as Offset<Self>>::Facing,
        >;
    /// [`Arithmetic::Ramp`] for versines of quick rays.
    type QuickRamp: Copy + PartialEq + core::fmt::Debug;

    /// Returns the offset from a light to a point.
    fn quick_offset(light: Vec3<Self::Position>, point: Vec3<Self::Position>) -> Self::QuickOffset;
    /// Converts an axis to the form that the rays of a quick offset take.
    fn quick_axis(axis: Vec3<Self::Direction>) -> Vec3<Self::Direction>;
    /// Compiles a ramp for versines of quick rays: see [`Arithmetic::ramp`].
    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> Self::QuickRamp;
    /// Upper bound of the error of the intensity, without attenuation, for a cone that spans
    /// versines from 0 to `outer`: of the falloff times Lambert's cosine.
    fn quick_error(edge: &Slopes, outer: f32) -> f32;
}
