//! Where to look: generators of inputs, each with the seams of its domain named.

use super::format::Format;
use super::reference::{self, Vector};
use fastrand::Rng;
use luminaire::{Cone, HalfAngle, SpotLight, Vec3, falloff::Falloff};

/// The half angles, in degrees, that every accuracy row is measured at.
pub const HALF_ANGLES: [f32; 11] = [0.01, 0.1, 0.5, 1.0, 2.0, 3.5, 7.5, 15.0, 30.0, 60.0, 89.0];

/// How much longer to look: 1, or 16 where `LUMINAIRE_FULL` is set.
pub fn effort() -> usize {
    if std::env::var_os("LUMINAIRE_FULL").is_some() { 16 } else { 1 }
}

pub fn half(degrees: f32) -> HalfAngle {
    HalfAngle::degrees(degrees)
}

/// A random direction, evenly spread over the sphere.
pub fn direction(rng: &mut Rng) -> Vector {
    loop {
        let v = [0; 3].map(|_| rng.f64() * 2.0 - 1.0);
        let squared = reference::dot(v, v);
        if squared > 1e-4 && squared < 1.0 {
            return reference::unit(v);
        }
    }
}

/// A random direction at an angle off an axis.
pub fn direction_off(rng: &mut Rng, axis: Vector, radians: f64) -> Vector {
    let across = loop {
        let v = direction(rng);
        let along = reference::dot(v, axis);
        if along.abs() < 0.9 {
            break reference::unit(reference::minus(v, reference::scaled(axis, along)));
        }
    };
    let (sine, cosine) = radians.sin_cos();
    [0, 1, 2].map(|i| axis[i] * cosine + across[i] * sine)
}

/// The vector with its components rounded to f32.
pub fn single(v: Vector) -> Vec3<f32> {
    Vec3::new(v[0] as f32, v[1] as f32, v[2] as f32)
}

/// The nearest point of a grid of 2^-16, the quantum of the fixed-point lengths. Coordinates up to
/// 128 and their differences are exact there in every format, so that what is measured is the
/// kernel and not its input.
pub fn on_grid(v: Vector) -> Vector {
    v.map(|c| (c * 65_536.0).round() / 65_536.0)
}

/// A spotlight somewhere within 8 units of the origin, aimed at random.
pub fn spot<P: Falloff>(rng: &mut Rng, cone: Cone<P>) -> SpotLight<P> {
    let position = on_grid([0; 3].map(|_| rng.f64() * 16.0 - 8.0));
    SpotLight::new(single(position), single(direction(rng)), cone).expect("a sweep makes sound lights")
}

/// A point of the world and the normal of the surface there, as a format stores them.
pub struct Site<S: Format> {
    pub point: Vec3<S::Length>,
    pub normal: Vec3<S>,
}

/// A distance from 0.5 to 50 units, evenly spread over its logarithm.
pub fn distance(rng: &mut Rng) -> f64 {
    0.5 * 100.0_f64.powf(rng.f64())
}

/// A site near the cone of a spotlight: at 0 to 1.3 times its outer half angle, some `distance`
/// away.
pub fn site<S: Format>(
    rng: &mut Rng,
    position: Vector,
    axis: Vector,
    outer_degrees: f64,
    distance: f64,
) -> Site<S> {
    let off_axis = rng.f64() * 1.3 * outer_degrees.to_radians();
    let way = direction_off(rng, axis, off_axis);
    let point = on_grid([0, 1, 2].map(|i| position[i] + distance * way[i]));
    Site { point: single(point).map(S::length), normal: single(direction(rng)).map(S::from_f32) }
}

/// The versines of a cone: both ends and their neighbourhoods, then `count` evenly spread ones to
/// 1.1 of the edge.
pub fn versines(outer: f64, count: usize) -> impl Iterator<Item = f32> {
    let seams = [0.0, outer, outer * (1.0 - 1e-6), outer * (1.0 + 1e-6), outer * 1e-6];
    let even = (0..count).map(move |i| outer * 1.1 * (i as f64 + 0.5) / count as f64);
    seams.into_iter().chain(even).map(|versine| versine as f32)
}
