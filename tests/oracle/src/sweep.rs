//! Where to look: random inputs, each with the seams of its domain.

use core::f64::consts::{FRAC_PI_2, PI};

use fastrand::Rng;
use glam::DVec3;

use crate::{SpotLight, climb, half_degrees, turned};

/// A surface point as a kernel gets it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfacePoint {
    /// Its position.
    pub point: [f32; 3],
    /// The normal, of unit length within the rounding of f32.
    pub normal: [f32; 3],
}

/// A random direction, evenly spread over the sphere.
pub fn direction(rng: &mut Rng) -> DVec3 {
    loop {
        let v = DVec3::from_array([0; 3].map(|_| rng.f64() * 2.0 - 1.0));
        let squared = v.length_squared();
        if squared > 1e-4 && squared < 1.0 {
            return v.normalize();
        }
    }
}

/// A random direction at an angle off a unit axis.
pub fn direction_off(rng: &mut Rng, axis: DVec3, radians: f64) -> DVec3 {
    let across = loop {
        let v = direction(rng);
        let along = v.dot(axis);
        if along.abs() < 0.9 {
            break (v - along * axis).normalize();
        }
    };
    turned(axis, across, radians)
}

/// A distance from 0.5 to 50 units, evenly spread over its logarithm.
pub fn distance(rng: &mut Rng) -> f64 {
    0.5 * libm::pow(100.0, rng.f64())
}

/// The vector with its components rounded to f32.
pub fn single(v: DVec3) -> [f32; 3] {
    v.as_vec3().to_array()
}

/// The versines of a cone: both ends and their neighbourhoods, then `count` evenly spread ones to
/// 1.1 of the edge.
pub fn versines(outer: f64, count: usize) -> impl Iterator<Item = f32> {
    let seams = [0.0, outer, outer * (1.0 - 1e-6), outer * (1.0 + 1e-6), outer * 1e-6];
    let even = (0..count).map(move |i| outer * 1.1 * (i as f64 + 0.5) / count as f64);
    seams.into_iter().chain(even).map(|versine| versine as f32)
}

/// A surface point about a light, at a [`distance`]. Every other one is at a seam: on the axis, at
/// the edge, at that of the hotspot or outside the cone. So is every other normal: towards the
/// light, at a right angle to it or away from it.
pub fn surface_point(rng: &mut Rng, light: &SpotLight) -> SurfacePoint {
    let radians = |versine: f64| half_degrees(versine).to_radians();
    let near = 1.0 + (rng.f64() - 0.5) * libm::pow(10.0, -7.0 * rng.f64());
    let (inner, edge) = (radians(light.cone.inner), radians(light.cone.limit));
    let off_axis = match rng.u8(..8) {
        0 => 0.0,
        1 => inner * near,
        2 => edge * near,
        3 => edge + (PI - edge) * rng.f64(),
        _ => edge * 1.1 * rng.f64(),
    };
    let way = direction_off(rng, light.axis.normalize(), off_axis.min(PI));
    let incidence = match rng.u8(..8) {
        0 | 1 => 0.0,
        2 => FRAC_PI_2 * near,
        3 => FRAC_PI_2 * (1.0 + rng.f64()),
        _ => FRAC_PI_2 * rng.f64(),
    };
    let normal = direction_off(rng, -way, incidence);
    SurfacePoint { point: single(light.position + distance(rng) * way), normal: single(normal) }
}

/// The surfaces within two distances of a light, in its cone or just outside it.
#[derive(Clone, Copy, Debug)]
pub struct Surfaces {
    /// The position of the light.
    pub position: DVec3,
    /// The axis of the light, of unit length.
    pub axis: DVec3,
    /// The half angle at which the cone ends, in radians.
    pub half_angle: f64,
    /// The nearest and the farthest distance.
    pub distances: [f64; 2],
}

impl Surfaces {
    /// A random surface point: often at an end of the distances, on the axis or at the edge, and at
    /// grazing or perpendicular incidence; often an offset whose lower bits are all set, and whose
    /// largest component is just past a power of two, where truncation loses the most. `stored` is the
    /// normal as a format stores it, which has the cosine that was drawn.
    pub fn point(&self, rng: &mut Rng, stored: impl Fn([f32; 3]) -> DVec3) -> SurfacePoint {
        let end = |rng: &mut Rng| libm::pow(10.0, -5.0 * rng.f64());
        let part = |rng: &mut Rng| match rng.u8(..3) {
            0 => end(rng),
            1 => 1.0 - end(rng),
            _ => rng.f64(),
        };
        let off = if rng.u8(..8) == 0 { 1.02 } else { part(rng) };
        let way = direction_off(rng, self.axis, off * self.half_angle);
        let incidence = FRAC_PI_2 * part(rng);
        let normal = single(direction_off(rng, -way, incidence));
        let stored = stored(normal);
        let way = (way - (way.dot(stored) + libm::cos(incidence)) * stored).normalize();
        let [near, far] = self.distances;
        let mut distance = near * libm::pow(far / near, part(rng));
        if rng.bool() {
            let largest = way.abs().max_element();
            let past = libm::exp2(libm::floor(libm::log2(distance * largest)));
            distance = (past * (1.0 + 0.02 * rng.f64()) / largest).clamp(near, far);
        }
        let set = if rng.bool() { (1_i64 << rng.u8(..10)) - 1 } else { 0 };
        let offset = (distance * way).to_array().map(|c| ((c * 65_536.0) as i64 | set) as f64 / 65_536.0);
        SurfacePoint { point: single(self.position + DVec3::from_array(offset)), normal }
    }

    /// The surface point with some bits changed: those of a coordinate or of a component of the normal.
    pub fn moved(rng: &mut Rng, SurfacePoint { point, normal }: SurfacePoint) -> SurfacePoint {
        let size = climb::size(rng);
        if rng.u8(..3) == 0 {
            let normal = climb::one_of(rng, normal, |c| c + size).map(f64::from);
            return SurfacePoint { point, normal: single(DVec3::from_array(normal).normalize_or_zero()) };
        }
        let step = climb::grid_step(rng, size);
        SurfacePoint { point: climb::one_of(rng, point, step), normal }
    }
}
