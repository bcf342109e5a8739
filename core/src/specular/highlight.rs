//! What highlights differ by.

use crate::{number::Scalar, vec3::Vec3};

/// The two directions whose nearness makes a highlight.
pub trait Highlight: Copy + PartialEq + core::fmt::Debug {
    /// The two unit directions: `incoming` goes from the light to the surface, `view` from the surface to the eye.
    fn directions<S: Scalar>(
        incoming: Vec3<S::Unit>,
        normal: Vec3<S>,
        view: Vec3<S::Unit>,
    ) -> [Vec3<S::Unit>; 2];
}
