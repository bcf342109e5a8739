//! What a block of points and a beam of light are surely within, so that a block no light reaches is left out.

use crate::gbuffer::LANES;
use glam::{Vec2, Vec3};
use luminaire::Spot;

/// A box around points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    center: Vec3,
    /// From the centre to the farthest corner, at least.
    radius: f32,
}

/// What a spotlight's cone is within.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beam {
    position: Vec3,
    axis: Vec3,
    /// Cosine and sine of the outer half angle.
    edge: Vec2,
}

impl Bounds {
    /// The bounds of the points of those lanes that have a nearness.
    pub(crate) fn around(points: &[[f32; LANES]; 3], nearness: &[f32]) -> Option<Self> {
        let mut low = [f32::INFINITY; 3];
        let mut high = [f32::NEG_INFINITY; 3];
        for (lane, &nearness) in nearness.iter().enumerate().take(LANES) {
            for axis in 0..3 {
                let (below, above) = if nearness > 0.0 {
                    (points[axis][lane], points[axis][lane])
                } else {
                    (f32::INFINITY, f32::NEG_INFINITY)
                };
                low[axis] = if below < low[axis] { below } else { low[axis] };
                high[axis] = if above > high[axis] { above } else { high[axis] };
            }
        }
        let (low, high) = (Vec3::from(low), Vec3::from(high));
        let center = 0.5 * (low + high);
        (low.x <= high.x).then(|| Self { center, radius: 0.5 * (high - low).length() })
    }
}

impl Beam {
    pub(crate) fn new(spot: &Spot) -> Self {
        let outer = spot.cone().outer().to_radians();
        Self {
            position: spot.position().into(),
            axis: spot.axis().into(),
            edge: Vec2::from_angle(outer / 2.0),
        }
    }

    /// Whether the bounds are outside the cone for certain, in every number format: by a thousandth of the distance and a
    /// tenth of a millimetre more than touching. The formats' directions are off by 2.4e-5 at most, and their
    /// positions by 3e-5 metres.
    pub(crate) fn misses(&self, bounds: &Bounds) -> bool {
        let way = bounds.center - self.position;
        let reach = way.abs().element_sum() + bounds.center.abs().element_sum();
        let margin = 1e-3 * reach + 1e-4;
        // The distance to the cone is |way x axis| cos - (way . axis) sin: compared by squares.
        let inner = way.dot(self.axis) * self.edge.y + bounds.radius + margin;
        let across = way.cross(self.axis);
        inner < 0.0 || across.dot(across) * self.edge.x * self.edge.x > inner * inner
    }
}
