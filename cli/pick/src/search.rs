//! The two ends of the error of a light: the derived bound, and the largest error that a search finds.

use fastrand::Rng;
use luminaire::bound::ErrorBound;
use luminaire_oracle::DVec3;
use luminaire_oracle::climb::{self, Worst};
use luminaire_oracle::sweep::{SurfacePoint, Surfaces, direction_off};
use serde::Serialize;

use crate::evaluation::Kernel;
use crate::target::{Display, Tolerance};
use crate::truth::Truth;

/// A bound of an error, and the largest error that a search finds.
///
/// The bound is derived from the errors of the stages of the evaluation: see
/// [`luminaire::bound`]. It holds for every surface within the distances of the light, whatever its
/// coordinates and its normal; the exact light is that of the coordinates and the normal as the format
/// stores them. The position of the light is rounded to multiples of 2^-16 before.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Bound {
    /// The bound, in the unit of the tolerance.
    pub value: f64,
    /// The largest error that was found, in the unit of the tolerance.
    pub found: f64,
    /// How the bound was found: `derived`.
    pub label: &'static str,
    /// The angle in degrees by which the edge of a cone may move where the light jumps or has an infinite derivative:
    /// the bound holds for directions farther from it. 0 if it holds for all.
    pub edge_degrees: f32,
    /// The distance by which the range may move where the light is cut off: the bound holds for distances farther
    /// from it. 0 if it holds for all.
    pub range: f32,
    /// The position and the orientation of the surface at which the largest error was found.
    pub at: Place,
}

/// The position and the orientation of a surface, relative to the light.
#[derive(Clone, Copy, PartialEq, Default, Debug, Serialize)]
pub struct Place {
    /// The angle off axis in degrees; 0 for a light without a cone.
    pub degrees_off_axis: f64,
    /// The distance from the light; 0 for a directional light.
    pub distance: f64,
    /// The cosine of the angle of incidence.
    pub cosine: f64,
}

/// Number of random points of a search.
const POINTS: usize = 12_000;
/// Number of climbs. Each begins at one of the points with the largest errors.
const CLIMBS: usize = 48;
/// Number of steps of each climb.
const STEPS: usize = 400;

/// A search for the largest error of a light.
pub(crate) struct Search {
    truth: Truth,
    surfaces: Surfaces,
    seed: u64,
    effort: usize,
}

impl Search {
    /// Prepares a search. `effort` multiplies the number of points and of climbs.
    pub(crate) fn new(truth: Truth, distances: [f32; 2], seed: u64, effort: usize) -> Self {
        let surfaces = Surfaces {
            position: truth.position,
            axis: truth.axis,
            half_angle: truth.half_angle(),
            distances: distances.map(f64::from),
        };
        Self { truth, surfaces, seed, effort }
    }

    /// Returns the largest error of an evaluation that is found where its bound holds, and where.
    pub(crate) fn largest(
        &self,
        kernel: &dyn Kernel,
        bound: &ErrorBound,
        tolerance: Tolerance,
        display: Display,
    ) -> (f64, Place) {
        let mut rng = Rng::with_seed(self.seed);
        let [near, far] = self.surfaces.distances;
        let error = |at: SurfacePoint| {
            let (point, normal) = (exact(at.point), kernel.normal(at.normal));
            let is_within = || (near..=far).contains(&point.distance(self.truth.position));
            if (self.truth.is_placed() && !is_within()) || self.truth.jumps_near(point, bound) {
                return 0.0;
            }
            tolerance.error(display, kernel.light(&at), self.truth.irradiance(point, normal))
        };
        let start = |input| Worst { input, error: error(input) };
        let random = |rng: &mut Rng| start(self.surfaces.point(rng, |normal| kernel.normal(normal)));
        let mut starts: Vec<_> = (0..POINTS * self.effort).map(|_| random(&mut rng)).collect();
        starts.sort_by(|a, b| b.error.total_cmp(&a.error));
        let climbed = starts.into_iter().take(CLIMBS * self.effort);
        let climbed = climbed.map(|start| climb::climb(&mut rng, start, STEPS, Surfaces::moved, error));
        let worst = climbed.max_by(|a, b| a.error.total_cmp(&b.error)).expect("a search has points");
        (worst.error, self.place(kernel, worst.input))
    }

    fn place(&self, kernel: &dyn Kernel, at: SurfacePoint) -> Place {
        let point = exact(at.point);
        let (distance, cosine) = self.truth.incidence(point, kernel.normal(at.normal));
        Place { degrees_off_axis: self.truth.degrees_off_axis(point), distance, cosine }
    }

    /// Returns the share of the points that take the fine evaluation and keep its result. The points
    /// are those of facing surfaces, evenly spread over the cone and the distances.
    pub(crate) fn fine_share(&self, kernel: &dyn Kernel) -> f64 {
        /// Irradiance from which on `Fx16` keeps the coarse result instead of the fine evaluation, if it has both.
        const CLIPPED: f64 = 1.125;
        const COUNT: usize = 512;
        let mut rng = Rng::with_seed(1953);
        let Surfaces { position, axis, half_angle, distances: [near, far] } = self.surfaces;
        let fine = (0..COUNT).filter(|_| {
            let off = rng.f64().sqrt() * half_angle;
            let way = direction_off(&mut rng, axis, off);
            let distance = near + (far - near) * rng.f64();
            let cosine = (std::f64::consts::FRAC_PI_2 * rng.f64()).cos();
            let point = position + distance * way;
            let is_kept = !kernel.is_always_fine() && self.truth.arriving(point) * cosine >= CLIPPED;
            kernel.is_fine(point.as_vec3().to_array()) && !is_kept
        });
        fine.count() as f64 / COUNT as f64
    }
}

fn exact(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}
