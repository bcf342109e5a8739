//! Where to look: inputs for the formats of the kernel.

use super::format::Format;
use fastrand::Rng;
use luminaire::{Cone, HalfAngle, SpotLight, Vec3, attenuation::Attenuation, falloff::Falloff};
use luminaire_oracle::{self as oracle, DVec3};
pub use luminaire_oracle::{
    on_grid,
    sweep::{direction, direction_off, distance, versines},
};

/// The half angles, in degrees, that every accuracy row is measured at.
pub const HALF_ANGLES: [f32; 11] = [0.01, 0.1, 0.5, 1.0, 2.0, 3.5, 7.5, 15.0, 30.0, 60.0, 89.0];

/// How much longer to look: 1, or 16 where `LUMINAIRE_FULL` is set.
pub fn effort() -> usize {
    if std::env::var_os("LUMINAIRE_FULL").is_some() { 16 } else { 1 }
}

pub fn half(degrees: f32) -> HalfAngle {
    HalfAngle::degrees(degrees)
}

/// The vector with its components rounded to f32.
pub fn single(v: impl Into<DVec3>) -> Vec3<f32> {
    v.into().as_vec3().into()
}

/// A random position within 8 units of the origin along each coordinate, on the grid of 2^-16.
pub fn position(rng: &mut Rng) -> DVec3 {
    on_grid([0; 3].map(|_| rng.f64() * 16.0 - 8.0))
}

/// A spotlight somewhere within 8 units of the origin, aimed at random.
pub fn spot<P: Falloff>(rng: &mut Rng, cone: Cone<P>) -> SpotLight<P> {
    SpotLight::new(single(position(rng)), single(direction(rng)), cone).expect("a sweep makes sound lights")
}

/// The axis of a spotlight, as the format of a compiled one stores it.
pub fn axis<S: Format, P: Falloff, A: Attenuation>(spot: &SpotLight<P, A>) -> Vec3<S::Unit> {
    S::aim(spot.given_axis(), spot.axis())
}

/// What a format has stored of a spotlight, with the inverse square.
pub fn stored<S: Format, P: Falloff, A: Attenuation>(
    spot: &SpotLight<P, A>,
    cone: oracle::Cone,
) -> oracle::SpotLight {
    let position = S::exact_point(spot.position().map(S::length));
    let axis = S::exact_direction(axis::<S, _, _>(spot)).normalize();
    oracle::SpotLight { intensity: spot.intensity().into(), ..oracle::SpotLight::new(position, axis, cone) }
}

/// A point of the world and the normal of the surface there, as a format stores them.
pub struct Site<S: Format> {
    pub point: Vec3<S::Length>,
    pub normal: Vec3<S>,
}

/// A site near the cone of a spotlight: at 0 to 1.3 times its outer half angle, some `distance`
/// away.
pub fn site<S: Format>(
    rng: &mut Rng,
    position: DVec3,
    axis: DVec3,
    outer_degrees: f64,
    distance: f64,
) -> Site<S> {
    let off_axis = rng.f64() * 1.3 * outer_degrees.to_radians();
    let way = direction_off(rng, axis, off_axis);
    let point = on_grid(position + distance * way);
    Site { point: single(point).map(S::length), normal: single(direction(rng)).map(S::from_f32) }
}
