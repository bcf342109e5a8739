//! View rays where the arc that a light sees of them is nearly degenerate: along the axis of the
//! beam, against it, in a plane tangent to the cone, and through the light.

use super::{
    oracle::{DVec3, turned},
    sweep,
    views::{exact, place},
};
use fastrand::Rng;
use luminaire::{
    Vec3,
    haze::{ViewRay, ViewRays},
};
use std::f64::consts::{FRAC_PI_2, TAU};

/// The largest angle between a critical direction and one that counts as near to it, in radians.
pub const NEAR: f64 = 0.01;

/// A cone, with one of the planes tangent to it: by the generator that both share, and the
/// direction across that.
pub struct Frame {
    position: DVec3,
    axis: DVec3,
    generator: DVec3,
    tangent: DVec3,
}

impl Frame {
    pub fn new(rng: &mut Rng, position: Vec3<f32>, axis: Vec3<f32>, half: f64) -> Self {
        let axis = exact(axis).normalize();
        let across = sweep::direction_off(rng, axis, FRAC_PI_2);
        let generator = turned(axis, across, half);
        let tangent = axis.cross(across);
        Self { position: exact(position), axis, generator, tangent }
    }

    /// An eye 0.01 to 1000 from the light. Half of them are seen from the light near a critical
    /// direction.
    pub fn eye(&self, rng: &mut Rng) -> Vec3<f32> {
        let way = match rng.u8(..8) {
            0 => near(rng, self.axis),
            1 => near(rng, -self.axis),
            2 => near(rng, self.generator),
            3 => self.near_tangent(rng),
            _ => sweep::direction(rng),
        };
        sweep::single(place(self.position, way, distance(rng)))
    }

    /// A ray from an eye, near a critical direction or not. It ends before the light, beyond it,
    /// anywhere or nowhere.
    pub fn ray(&self, rng: &mut Rng, eye: Vec3<f32>, is_critical: bool) -> ViewRay {
        let way = self.position - exact(eye);
        let to_light = way.normalize();
        let to_cone = |rng: &mut Rng| (way + near(rng, self.generator) * distance(rng)).normalize();
        let direction = match (is_critical, rng.u8(..4)) {
            (true, 0) => near(rng, self.axis),
            (true, 1) => near(rng, -self.axis),
            (true, 2) => self.near_tangent(rng),
            (true, _) => near(rng, to_light),
            (false, 0) => to_cone(rng),
            (false, _) => sweep::direction(rng),
        };
        let sign = if is_critical || rng.bool() { 1.0 } else { -1.0 };
        let to_light = way.length();
        let length = match rng.u8(..4) {
            0 => f64::INFINITY,
            1 => to_light * rng.f64(),
            2 => to_light * (1.0 + 2.0 * rng.f64() * rng.f64()),
            _ => distance(rng),
        };
        ViewRay { eye, direction: sweep::single(sign * direction), length: length as f32 }
    }

    /// Rays from one eye, every other near a critical direction.
    pub fn rays<const N: usize>(&self, rng: &mut Rng) -> ViewRays<N> {
        let eye = self.eye(rng);
        let rays: [_; N] = std::array::from_fn(|i| self.ray(rng, eye, i % 2 == 0));
        let direction = Vec3::new(
            rays.map(|ray| ray.direction.x),
            rays.map(|ray| ray.direction.y),
            rays.map(|ray| ray.direction.z),
        );
        ViewRays { eye, direction, length: rays.map(|ray| ray.length) }
    }

    fn near_tangent(&self, rng: &mut Rng) -> DVec3 {
        let (sine, cosine) = (TAU * rng.f64()).sin_cos();
        near(rng, cosine * self.generator + sine * self.tangent)
    }
}

/// A distance from 0.01 to 1000, evenly spread over its logarithm.
fn distance(rng: &mut Rng) -> f64 {
    0.01 * 1e5_f64.powf(rng.f64())
}

/// A direction up to [`NEAR`] off another, evenly spread over the logarithm of the angle from a
/// rounding of f32 on.
fn near(rng: &mut Rng, direction: DVec3) -> DVec3 {
    let off = sweep::direction(rng);
    (direction + NEAR * 1e-6_f64.powf(rng.f64()) * off).normalize()
}
