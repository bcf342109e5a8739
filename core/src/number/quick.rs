//! The private interface of the quick evaluation, which has fewer instructions and a larger error.

use super::{Arithmetic, Offset, Ray, Slopes};
use crate::vec3::Vec3;

/// The quick evaluation of a number format.
///
/// Points, normals and light have the same types as in the standard evaluation, so one scene can
/// have lights of both evaluations. [`SpotLight::compile_quick`](crate::SpotLight::compile_quick)
/// compiles a light for the quick evaluation.
pub trait Quick: Arithmetic {
    /// An offset with fewer bits than [`Arithmetic::Offset`], or with a less accurate square root.
    type QuickOffset: Offset<
            Self,
            Ray: Ray<Self, Ramp = Self::QuickRamp>,
            Facing = <<Self as Arithmetic>::Offset as Offset<Self>>::Facing,
        >;
    /// A ramp like [`Arithmetic::Ramp`], for versines of the quick evaluation.
    type QuickRamp: Copy + PartialEq + core::fmt::Debug;

    /// Returns the offset from a light to a point.
    fn quick_offset(light: Vec3<Self::Position>, point: Vec3<Self::Position>) -> Self::QuickOffset;
    /// Converts an axis to the form that rays of the quick evaluation take.
    fn quick_axis(axis: Vec3<Self::Direction>) -> Vec3<Self::Direction>;
    /// Compiles a ramp for versines of the quick evaluation: see [`Arithmetic::ramp`].
    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> Self::QuickRamp;
    /// Returns the ramp of the cone between the cones of two ramps: see [`Arithmetic::zoomed`].
    fn quick_zoomed(from: Self::QuickRamp, to: Self::QuickRamp, part: Self) -> Self::QuickRamp;
    /// Returns an upper bound of the error of the falloff times Lambert's cosine.
    ///
    /// The bound holds for a cone that spans versines from 0 to `outer`, without attenuation.
    fn quick_error(edge: &Slopes, outer: f32) -> f32;
}
