//! Bounds of the surface points and normals at some pixels of a block.

use crate::{
    buffer::LANES,
    space::{bounds::Bounds, directions::Directions},
};
use glam::Vec3;

/// Bounds of the surface at some pixels of a block: one sphere around the points, one around the
/// normals.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part {
    pub(crate) bounds: Bounds,
    pub(crate) normals: Directions,
}

/// The rays through the pixels of a block.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fan {
    pub(crate) eye: Vec3,
    /// Vectors to depth 1 along the first ray and along the last ray.
    pub(crate) edges: [Vec3; 2],
}

/// Reciprocal of the depth at each pixel; 0 for a pixel that is not included.
type Nearness = [f32; LANES];

impl Part {
    /// Computes the bounds of the included pixels; `None` if no pixel is included.
    pub(crate) fn new(
        fan: &Fan,
        nearness: &Nearness,
        normals: &luminaire::Vec3<[f32; LANES]>,
    ) -> Option<Self> {
        let (farthest, nearest) = extent(nearness, nearness)?;
        let (near, far) = (1.0 / nearest, 1.0 / farthest);
        let [first, last] = fan.edges;
        // The rays of a row lie in a plane, so that all points are inside a trapezium with these
        // corners.
        let corners = [first * near, first * far, last * near, last * far];
        let bounds = Bounds::around(corners.map(|corner| fan.eye + corner));
        let [x, y, z] = [&normals.x, &normals.y, &normals.z].map(|plane| extent(plane, nearness));
        let ((x0, x1), (y0, y1), (z0, z1)) = (x?, y?, z?);
        Some(Self { bounds, normals: Directions::between(Vec3::new(x0, y0, z0), Vec3::new(x1, y1, z1)) })
    }
}

/// Returns the smallest and the largest value of the included pixels; `None` if no pixel is
/// included.
fn extent(values: &[f32; LANES], nearness: &Nearness) -> Option<(f32, f32)> {
    let (mut least, mut most) = ([f32::INFINITY; LANES], [-f32::INFINITY; LANES]);
    for lane in 0..LANES {
        let is_covered = nearness[lane] > 0.0;
        least[lane] = if is_covered { values[lane] } else { f32::INFINITY };
        most[lane] = if is_covered { values[lane] } else { -f32::INFINITY };
    }
    // Combines the two halves of the lanes repeatedly: compilers vectorise this loop.
    let mut half = LANES / 2;
    while half > 0 {
        for lane in 0..half {
            let (low, high) = (least[lane + half], most[lane + half]);
            least[lane] = if low < least[lane] { low } else { least[lane] };
            most[lane] = if high > most[lane] { high } else { most[lane] };
        }
        half /= 2;
    }
    (least[0] <= most[0]).then_some((least[0], most[0]))
}
