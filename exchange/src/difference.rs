//! The difference between a light and that of its source.

use serde::{Deserialize, Serialize};

/// The largest difference between a light of [`luminaire`] and the light of another tool; 0 where the kernel has
/// the tool's formulas.
///
/// Both lights are computed in exact arithmetic, without the errors of a number format. The differences are upper
/// bounds.
#[derive(Clone, Copy, PartialEq, Default, Debug, Serialize, Deserialize)]
#[serde(default)]
pub struct Difference {
    /// Difference in intensity over the angle, relative to the intensity on the axis, in [0, 1].
    pub angle: f32,
    /// Difference in position, in outer half angles, where the intensity has an infinite derivative with respect to
    /// the angle: 2^-25 or 0. At the edge of such a light, f32 cannot distinguish angles within 2^-25 of the edge, so
    /// no format can represent the intensity there.
    pub place: f32,
    /// Relative difference in attenuation, in [0, 1]: the difference of the two attenuations divided by the larger of
    /// them.
    ///
    /// Compared are the distances from a sixteenth of the range to the range, and without a range those from 1 to 16;
    /// none below the distance at which the original stops growing. Nearer to the light and farther from it the
    /// difference may be larger.
    pub distance: f32,
}

impl Difference {
    /// The difference of a falloff with an infinite slope at its edge.
    pub(crate) const AT_THE_EDGE: Self = Self { angle: 0.0, place: 1.0 / 33_554_432.0, distance: 0.0 };

    /// Returns an upper bound of the difference in irradiance, relative to the larger of the two irradiances on the
    /// axis at the same distance.
    ///
    /// The bound is the sum of `angle` and `distance`, at most 1. It holds at the distances of
    /// [`distance`](Self::distance), except where the position differs.
    pub fn most(self) -> f32 {
        (self.angle + self.distance).min(1.0)
    }
}
