//! The search for the largest error of a light.

use std::f64::consts::{FRAC_PI_2, TAU};

use luminaire::Error;
use luminaire_oracle::{DVec3, SplitMix64, SpotLight, half_degrees, on_grid, turned};
use serde::Serialize;

use crate::evaluation::{Evaluation, Kernel};
use crate::light::{Light, Shaped};
use crate::target::{Display, Tolerance};

/// The factor from the largest error that a search finds to the stated bound.
///
/// For 200 random lights and every evaluation, a search with 30 times as many points and other
/// random numbers finds at most 1.5 times the error
/// (`cargo run --release -p luminaire-pick --example margin -- 200`). The errors of 1,000 answers,
/// searched with 4 times as many points, are at most 1.72 times the errors found by the answers'
/// own searches (`LUMINAIRE_FULL=1 cargo test -p luminaire-pick --test requests -- --nocapture`).
pub const MARGIN: f64 = 2.0;

/// A bound of an error, and how the bound was found.
///
/// The bound holds for every axis of the light, and for every surface within the distances of the
/// light. The coordinates of points are multiples of 2^-16 that `f32` represents, as every format does.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Bound {
    /// The bound, in the unit of the tolerance.
    pub value: f64,
    /// The largest error that was found; `value` is [`MARGIN`] times this error.
    pub found: f64,
    /// How the bound was found: `searched`.
    pub label: &'static str,
    /// The position and the orientation of the surface at which the error is largest.
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
/// Number of hill climbs of a search. Each climb starts at one of the points with the largest
/// errors.
const CLIMBS: usize = 48;
/// Number of steps of each hill climb.
const STEPS: usize = 400;
/// Number of axes: the light's own axis, and random axes.
const AXES: usize = 6;
/// Largest angle off axis of a point, in outer half angles.
const REACH: f64 = 1.02;

/// Random points in the domain of a light, with the exact light at each point. All evaluations are
/// searched at the same points.
pub(crate) struct Search<'a> {
    light: &'a Light,
    cone: &'a Shaped,
    aims: Vec<Aim>,
    samples: Vec<(Sample, Site)>,
    random: SplitMix64,
    effort: usize,
}

/// An axis, and the exact light with this axis.
struct Aim {
    axis: [f32; 3],
    truth: SpotLight,
    half_angle: f64,
}

/// A surface point, described by the quantities on which the error depends.
#[derive(Clone, Copy)]
struct Sample {
    aim: usize,
    /// The angle off axis, in outer half angles.
    off: f64,
    /// The angle about the axis, in radians.
    turn: f64,
    /// The distance on a logarithmic scale: 0 at the nearest distance, 1 at the farthest.
    depth: f64,
    /// The angle of incidence, and the rotation of the normal about the ray, in radians.
    incidence: f64,
    spin: f64,
}

/// A surface point in the form that kernels take, and the exact light at this point.
struct Site {
    point: [f32; 3],
    normal: [f32; 3],
    exact: f64,
    place: Place,
}

impl<'a> Search<'a> {
    /// Prepares a search. `effort` multiplies the number of points and of climbs.
    pub(crate) fn new(light: &'a Light, cone: &'a Shaped, seed: u64, effort: usize) -> Self {
        let mut random = SplitMix64(seed);
        let mut aims = Vec::new();
        while aims.len() < AXES {
            let any = random.vector(-1.0, 1.0);
            let axis = if aims.is_empty() {
                light.axis
            } else if (0.01..1.0).contains(&any.length_squared()) {
                any.normalize().as_vec3().to_array()
            } else {
                continue;
            };
            let truth = light.truth(cone, axis);
            let half_angle = half_degrees(truth.cone.limit).to_radians();
            aims.push(Aim { axis, truth, half_angle });
        }
        let mut search = Self { light, cone, aims, samples: Vec::new(), random, effort };
        for _ in 0..POINTS * effort {
            let sample = search.sample();
            search.samples.push((sample, search.site(&sample)));
        }
        search
    }

    /// Returns a random sample. At least half of the values are near the limits of their domain.
    fn sample(&mut self) -> Sample {
        let random = &mut self.random;
        let near = |random: &mut SplitMix64| (-9.0 * random.between(0.0, 1.0)).exp();
        let off = match random.below(4) {
            0 => 1.0 - near(random),
            1 => near(random),
            _ => REACH * random.between(0.0, 1.0),
        };
        let depth = match random.below(4) {
            0 => 0.0,
            1 => near(random),
            2 => 1.0,
            _ => random.between(0.0, 1.0),
        };
        let incidence = match random.below(4) {
            0 => FRAC_PI_2 * (1.0 - near(random)),
            1 => FRAC_PI_2 * near(random),
            _ => FRAC_PI_2 * random.between(0.0, 1.0),
        };
        let aim = random.below(AXES as u64) as usize;
        Sample { aim, off, turn: random.between(0.0, TAU), depth, incidence, spin: random.between(0.0, TAU) }
    }

    fn site(&self, sample: &Sample) -> Site {
        let Aim { truth, half_angle, .. } = &self.aims[sample.aim];
        let axis = truth.axis.normalize();
        let [near, far] = [self.light.near, self.light.far].map(f64::from);
        let off = (sample.off * half_angle).min(std::f64::consts::PI);
        let across = turned(across(axis), axis.cross(across(axis)), sample.turn);
        let way = turned(axis, across, off);
        let distance = near * (far / near).powf(sample.depth);
        let point = on_grid(truth.position + distance * way).as_vec3();
        let to_light = (truth.position - point.as_dvec3()).normalize();
        let tilt = self::across(to_light);
        let tilt = turned(tilt, to_light.cross(tilt), sample.spin);
        let normal = turned(to_light, tilt, sample.incidence).as_vec3();
        let exact = truth.irradiance(point.as_dvec3(), normal.as_dvec3());
        let place = Place {
            degrees_off_axis: off.to_degrees(),
            distance,
            cosine: to_light.dot(normal.as_dvec3()).max(0.0),
        };
        Site { point: point.to_array(), normal: normal.to_array(), exact, place }
    }

    /// Returns the bound of the error of an evaluation.
    ///
    /// If the bound from the random points already exceeds `enough`, the search does only one hill
    /// climb.
    pub(crate) fn bound(
        &self,
        evaluation: Evaluation,
        tolerance: Tolerance,
        display: Display,
        enough: f64,
    ) -> Result<Bound, Error> {
        let kernels = self.kernels(evaluation)?;
        let error = |sample: &Sample, site: &Site| {
            let found = kernels[sample.aim].light(site.point, site.normal);
            (tolerance.error(display, found, site.exact), site.place)
        };
        let swept = self.samples.iter().map(|(sample, site)| (error(sample, site), *sample));
        let mut worst: Vec<_> = swept.collect();
        worst.sort_by(|a, b| b.0.0.total_cmp(&a.0.0));
        let mut random = SplitMix64(self.random.0);
        let exceeds = worst.first().is_some_and(|((error, _), _)| MARGIN * error > enough);
        let climbs = if exceeds { 1 } else { CLIMBS * self.effort };
        let climbed = worst.into_iter().take(climbs).map(|(mut most, mut sample)| {
            for _ in 0..STEPS {
                let moved = moved(&mut random, sample);
                let now = error(&moved, &self.site(&moved));
                if now.0 >= most.0 {
                    (most, sample) = (now, moved);
                }
            }
            most
        });
        let (found, at) =
            climbed.fold((0.0, Place::default()), |most, now| if now.0 > most.0 { now } else { most });
        Ok(Bound { value: MARGIN * found, found, label: "searched", at })
    }

    fn kernels(&self, evaluation: Evaluation) -> Result<Vec<Box<dyn Kernel>>, Error> {
        self.aims.iter().map(|aim| evaluation.compile(self.light, self.cone, aim.axis)).collect()
    }

    /// Returns the share of the points that take the fine evaluation and keep its result. The
    /// points are evenly spread over the cone and the distances.
    pub(crate) fn fine_share(&self, kernel: &dyn Kernel) -> f64 {
        /// Irradiance from which on `Fx16` keeps the coarse result instead of the fine evaluation.
        const CLIPPED: f64 = 1.125;
        const COUNT: usize = 512;
        let mut random = SplitMix64(1953);
        let [near, far] = [self.light.near, self.light.far].map(f64::from);
        let fine = (0..COUNT).filter(|_| {
            let distance = random.between(near, far);
            let sample = Sample {
                aim: 0,
                off: random.between(0.0, 1.0).sqrt(),
                turn: random.between(0.0, TAU),
                depth: if far > near { (distance / near).ln() / (far / near).ln() } else { 0.0 },
                incidence: random.between(0.0, 1.0),
                spin: 0.0,
            };
            let site = self.site(&sample);
            kernel.is_fine(site.point) && site.exact < CLIPPED
        });
        fine.count() as f64 / COUNT as f64
    }
}

/// Moves one of the quantities of a sample by a random power of two.
fn moved(random: &mut SplitMix64, mut sample: Sample) -> Sample {
    let step = random.between(-1.0, 1.0) * (-12.0 * random.between(0.0, 1.0)).exp();
    match random.below(5) {
        0 => sample.off = (sample.off + step).clamp(0.0, REACH),
        1 => sample.turn += TAU * step,
        2 => sample.depth = (sample.depth + step).clamp(0.0, 1.0),
        3 => sample.incidence = (sample.incidence + FRAC_PI_2 * step).clamp(0.0, FRAC_PI_2),
        _ => sample.spin += TAU * step,
    }
    sample
}

/// Returns a unit vector orthogonal to a unit vector.
fn across(unit: DVec3) -> DVec3 {
    unit.any_orthonormal_vector()
}
