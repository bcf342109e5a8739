//! A stretch of a view ray, for light that does not fall with the square of the distance.

use super::arc::Arc;
use crate::trig;

/// A stretch of a view ray, run through by a parameter from 0 to 1.
///
/// Neither equal ways nor equal angles suit what varies with the distance in part and with the direction in
/// part: along a beam the ones lose what is near the light and the others what is far. Here the parameter
/// gives both ends the weight of the root of the other's distance, which is halfway between the two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    from: f32,
    to: f32,
    weights: [f32; 2],
}

impl Stretch {
    /// The stretch between two places.
    #[inline]
    pub(super) fn new(arc: &Arc, from: f32, to: f32) -> Self {
        let [near, far] = [arc.distance(from), arc.distance(to)].map(trig::sqrt);
        Self { from, to, weights: [far, near] }
    }

    /// The place at a parameter, and the way that a unit of it makes there; none if the ends are not in
    /// their order.
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
