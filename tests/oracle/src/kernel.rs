//! The errors of any kernel from a point and a normal to the irradiance of a spotlight.

use core::fmt;

use fastrand::Rng;
use glam::DVec3;

use crate::{
    SpotLight,
    climb::{Search, Worst, one_of, size, ulp_step},
    half_degrees, linear_codes,
    sweep::{SurfacePoint, distance, single, surface_point},
};

/// Surface points of a sweep.
const POINTS: usize = 1 << 14;

/// The errors of a kernel in [linear codes](linear_codes).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Errors {
    /// The mean over a sweep of random surface points.
    pub mean: f64,
    /// The largest of the sweep.
    pub swept: Worst<SurfacePoint>,
    /// The largest that climbing finds: never less than that of the sweep.
    pub climbed: Worst<SurfacePoint>,
}

/// Measures a kernel against a light, at points 0.5 to 50 units from it. The kernel must have the
/// same light: numbers of the light that the kernel has in f32 are to be f32 that are widened.
pub fn errors(light: &SpotLight, kernel: impl Fn([f32; 3], [f32; 3]) -> f64) -> Errors {
    errors_by(&Search::default(), light, kernel)
}

/// [`errors`] by a search of another length or seed.
pub fn errors_by(search: &Search, light: &SpotLight, kernel: impl Fn([f32; 3], [f32; 3]) -> f64) -> Errors {
    let jump = half_degrees(light.cone.limit).to_radians() / 510.0;
    let error = |surface: SurfacePoint| {
        let SurfacePoint { point, normal } = surface;
        let [exact_point, exact_normal] = [point, normal].map(widened);
        let is_near = (0.499..50.1).contains(&exact_point.distance(light.position));
        if !is_near || light.cone.jumps_near(light.versine(exact_point), jump) {
            return 0.0;
        }
        linear_codes(kernel(point, normal), light.irradiance(exact_point, exact_normal))
    };
    let mut rng = Rng::with_seed(search.seed);
    let first = surface_point(&mut rng, light);
    let (mut sum, mut swept) = (0.0, Worst { input: first, error: error(first) });
    for _ in 0..POINTS {
        let input = surface_point(&mut rng, light);
        let error = error(input);
        sum += error;
        swept = if error > swept.error { Worst { input, error } } else { swept };
    }
    let climbed =
        search.worst(|rng| surface_point(rng, light), |rng, surface| moved(rng, light, surface), error);
    let climbed = climbed.filter(|climbed| climbed.error > swept.error).unwrap_or(swept);
    Errors { mean: sum / POINTS as f64, swept, climbed }
}

/// The point along a coordinate or along the way from the light, or the normal turned.
fn moved(rng: &mut Rng, light: &SpotLight, surface: SurfacePoint) -> SurfacePoint {
    let SurfacePoint { point, normal } = surface;
    match rng.u8(..8) {
        0 => {
            let way = (widened(point) - light.position).normalize();
            SurfacePoint { point: single(light.position + distance(rng) * way), normal }
        }
        1..5 => {
            let step = ulp_step(rng);
            SurfacePoint { point: one_of(rng, point, step), normal }
        }
        _ => {
            let size = size(rng);
            let turned = widened(one_of(rng, normal, |c| c + size));
            SurfacePoint { point, normal: single(turned.try_normalize().unwrap_or(DVec3::Y)) }
        }
    }
}

fn widened(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

impl fmt::Display for Errors {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mean, swept, climbed } = self;
        write!(out, "{mean:.2e} in the mean, {:.2e} swept, ", swept.error)?;
        write!(out, "{:.2e} linear codes climbed, at {:?}", climbed.error, climbed.input)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cone, soft, step, versine};

    #[test]
    fn a_fault_of_a_few_points_is_found() {
        let light = SpotLight::new([0.0; 3], [0.0, 0.0, 1.0], Cone::new(soft, versine(30.0)));
        let exact = |point, normal| light.irradiance(widened(point), widened(normal));
        // One code is missing within a degree of incidence of 40 degrees, 20 units away or more.
        let faulty = |point: [f32; 3], normal| {
            let way = widened(point).normalize();
            let incidence = libm::acos(-way.dot(widened(normal))).to_degrees();
            let fault = if (incidence - 40.0).abs() < 1.0 && point[2] > 20.0 { 1.0 } else { 0.0 };
            exact(point, normal) - fault / 255.0
        };
        let errors = errors(&light, faulty);
        assert!((errors.climbed.error - 1.0).abs() < 1e-9 && errors.mean < 0.02, "{errors}");
        let [point, normal] = [errors.climbed.input.point, errors.climbed.input.normal];
        assert_eq!(linear_codes(faulty(point, normal), exact(point, normal)), errors.climbed.error);
    }

    #[test]
    fn the_truth_has_no_error_and_a_jump_is_not_measured() {
        let cone = Cone::new(step, versine(5.0));
        let light = SpotLight::new([1.0, 2.0, 3.0], [1.0, 1.0, 1.0], cone);
        let exact = errors(&light, |point, normal| light.irradiance(widened(point), widened(normal)));
        assert_eq!((exact.mean, exact.climbed.error), (0.0, 0.0));
        // The edge off by a thousandth of the half angle, which is within the jump.
        let off = SpotLight { cone: Cone::new(step, versine(5.005)), ..light };
        let off = errors(&light, |point, normal| off.irradiance(widened(point), widened(normal)));
        assert_eq!(off.climbed.error, 0.0);
        let nan = errors(&light, |_, _| f64::NAN);
        assert_eq!(nan.swept.error, f64::INFINITY);
    }
}
