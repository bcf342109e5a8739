//! Part of a view ray, for light that does not attenuate with the inverse square of the distance.

use super::arc::Arc;
use crate::trig;

/// Part of a view ray, with a parameter from 0 to 1 as its coordinate.
///
/// The integrand varies partly with the distance and partly with the direction. Uniform steps in
/// length undersample the part near the light; uniform steps in angle undersample the far part.
/// Here the coordinate at a parameter is a weighted mean of the coordinates of both ends. Each end
/// is weighted by the square root of the other end's distance from the light. The resulting steps
/// are a compromise between equal lengths and equal angles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    from: f32,
    to: f32,
    weights: [f32; 2],
}

impl Stretch {
    /// Builds the part between two coordinates of the ray.
    #[inline]
    pub(super) fn new(arc: &Arc, from: f32, to: f32) -> Self {
        let [near, far] = [arc.distance(from), arc.distance(to)].map(trig::sqrt);
        Self { from, to, weights: [far, near] }
    }

    /// Returns the coordinate on the ray at a parameter, and the derivative of the coordinate with
    /// respect to the parameter.
    ///
    /// The derivative is zero unless `from < to`.
    #[inline]
    pub(super) fn at(&self, parameter: f32) -> (f32, f32) {
        let [far, near] = self.weights;
        let (first, second) = ((1.0 - parameter) * far, parameter * near);
        let reciprocal = 1.0 / (first + second);
        let place = (first * self.from + second * self.to) * reciprocal;
        let way = far * near * (self.to - self.from) * (reciprocal * reciprocal);
        (place, if way > 0.0 { way } else { 0.0 })
    }
}
