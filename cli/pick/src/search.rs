//! The two ends of the error of a light: the derived bound, and the largest error that a search finds.

use fastrand::Rng;
use luminaire_oracle::climb::{self, Worst};
use luminaire_oracle::sweep::{SurfacePoint, Surfaces, direction_off};
use luminaire_oracle::{DVec3, SpotLight, half_degrees};
use serde::Serialize;

use crate::evaluation::Kernel;
use crate::light::{Light, Shaped};
use crate::target::{Display, Tolerance};

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
    /// The position and the orientation of the surface at which the largest error was found.
    pub at: Place,
}

/// The position and the orientation of a surface, relative to the light.
#[derive(Clone, Copy, PartialEq, Default, Debug, Serialize)]
pub struct Place {
    /// The angle off axis in degrees.
    pub degrees_off_axis: f64,
    /// The distance from the light.
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
    truth: SpotLight,
    surfaces: Surfaces,
    seed: u64,
    effort: usize,
}

impl Search {
    /// Prepares a search. `effort` multiplies the number of points and of climbs.
    pub(crate) fn new(light: &Light, cone: &Shaped, seed: u64, effort: usize) -> Self {
        let truth = light.truth(cone);
        let surfaces = Surfaces {
            position: truth.position,
            axis: truth.axis.normalize(),
            half_angle: half_degrees(truth.cone.limit).to_radians(),
            distances: [light.near, light.far].map(f64::from),
        };
        Self { truth, surfaces, seed, effort }
    }

    /// Returns the largest error of an evaluation that is found, and where.
    pub(crate) fn largest(
        &self,
        kernel: &dyn Kernel,
        tolerance: Tolerance,
        display: Display,
    ) -> (f64, Place) {
        let mut rng = Rng::with_seed(self.seed);
        let [near, far] = self.surfaces.distances;
        let error = |at: SurfacePoint| {
            let (point, normal) = (exact(at.point), kernel.normal(at.normal));
            if !(near..=far).contains(&point.distance(self.truth.position)) {
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
        let to_light = self.truth.position - exact(at.point);
        let distance = to_light.length();
        Place {
            degrees_off_axis: half_degrees(self.truth.versine(exact(at.point))),
            distance,
            cosine: (to_light.dot(kernel.normal(at.normal)) / distance).max(0.0),
        }
    }

    /// Returns the share of the points that take the fine evaluation and keep its result. The points
    /// are those of facing surfaces, evenly spread over the cone and the distances.
    pub(crate) fn fine_share(&self, kernel: &dyn Kernel) -> f64 {
        /// Irradiance from which on `Fx16` keeps the coarse result instead of the fine evaluation.
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
            kernel.is_fine(point.as_vec3().to_array()) && self.truth.arriving(point) * cosine < CLIPPED
        });
        fine.count() as f64 / COUNT as f64
    }
}

fn exact(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}
