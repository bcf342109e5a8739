//! The quick evaluation, which has fewer instructions and a larger error.

use super::{Offset, Scalar, Slopes};
use crate::vec3::Vec3;

/// A number format with a quick evaluation: `f32` or [`Fx16`](crate::Fx16).
///
/// Points, normals and light have the same types as in the standard evaluation, so one scene can
/// have lights of both evaluations. [`SpotLight::compile_quick`](crate::SpotLight::compile_quick)
/// compiles a light for the quick evaluation.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no quick evaluation",
    note = "`f32` and `Fx16` have a quick evaluation; for `Fx32` use `compile`"
)]
pub trait Quick: Scalar {
    /// An offset with fewer bits than the standard one, or with a less accurate square root.
    #[doc(hidden)]
    type QuickOffset: Offset<Self, Facing = <Self::Offset as Offset<Self>>::Facing>;

    /// Returns the offset from a light to a point.
    #[doc(hidden)]
    fn quick_offset(light: Vec3<Self::Length>, point: Vec3<Self::Length>) -> Self::QuickOffset;
    /// Converts an axis to the form that rays of the quick evaluation take.
    #[doc(hidden)]
    fn quick_axis(axis: Vec3<Self::Unit>) -> Vec3<Self::Unit>;
    /// Compiles a ramp for versines of the quick evaluation: see `Arithmetic::ramp`.
    #[doc(hidden)]
    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp;
    /// Returns the ramp of the cone between the cones of two ramps: see `Arithmetic::zoomed`.
    #[doc(hidden)]
    fn quick_zoomed(from: Self::Ramp, to: Self::Ramp, part: Self) -> Self::Ramp;
    /// Returns an upper bound of the error of the falloff times Lambert's cosine.
    ///
    /// The bound holds for a cone that spans versines from 0 to `outer`, without attenuation.
    #[doc(hidden)]
    fn quick_error(edge: &Slopes, outer: f32) -> f32;
}
