//! The private interface of the quick evaluation: fewer instructions, and a larger error.

use super::{Arithmetic, Offset, Scalar, Slopes};
use crate::vec3::Vec3;

/// A number format that also has a quick evaluation: `f32` and [`Fx16`](super::Fx16).
///
/// Points, normals and light are those of the format itself, so one scene can have lights of both
/// evaluations. A light chooses the quick evaluation with
/// [`SpotLight::compile_quick`](crate::SpotLight::compile_quick).
pub trait Quick: Scalar {
    /// [`Arithmetic::Offset`] with fewer bits, or a less accurate root.
    type QuickOffset: Offset<Self, Facing = <<Self as Arithmetic>::Offset as Offset<Self>>::Facing>;

    /// Returns the offset from a light to a point.
    fn quick_offset(light: Vec3<Self::Length>, point: Vec3<Self::Length>) -> Self::QuickOffset;
    /// Converts an axis to the form that the rays of a quick offset take.
    fn quick_axis(axis: Vec3<Self::Unit>) -> Vec3<Self::Unit>;
    /// Compiles a ramp for versines of quick rays: see [`Arithmetic::ramp`].
    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp;
    /// Upper bound of the error of the intensity, without attenuation, for a cone that spans
    /// versines from 0 to `outer`: of the falloff times Lambert's cosine.
    fn quick_error(edge: &Slopes, outer: f32) -> f32;
}
