//! The part of a specular lobe that differs from lobe to lobe: the two directions.

use crate::{number::Scalar, vec3::Vec3};

/// A specular lobe that is a power of the cosine between two directions.
pub trait Highlight: Copy + PartialEq + core::fmt::Debug {
    /// Returns the two unit directions. `incoming` points from the light to the surface, `view`
    /// from the surface to the eye.
    fn directions<S: Scalar>(
        incoming: Vec3<S::Unit>,
        normal: Vec3<S>,
        view: Vec3<S::Unit>,
    ) -> [Vec3<S::Unit>; 2];
}
