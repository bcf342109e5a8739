//! View rays that meet a beam, or nearly do.

use super::{
    format::Format,
    in_scattering::{Beam, Ray},
    oracle::{self, DVec3},
    sweep,
};
use fastrand::Rng;
use luminaire::{Vec3, haze::ViewRay};

pub fn exact(v: Vec3<f32>) -> DVec3 {
    f32::exact_point(v)
}

pub fn place(from: DVec3, way: DVec3, distance: f64) -> DVec3 {
    from + distance * way
}

/// A position in the cone of a beam or near it, 0.2 to 10 from the light.
pub fn near_beam(rng: &mut Rng, spot: &oracle::SpotLight, most: f64) -> DVec3 {
    let outer = oracle::half_degrees(spot.cone.limit).to_radians();
    let angle = rng.f64() * most * outer;
    place(spot.position, sweep::direction_off(rng, spot.axis, angle), 0.2 * 50.0_f64.powf(rng.f64()))
}

/// A view ray towards a place at the beam, from beside it or from within, that ends before it,
/// behind it or nowhere. Its line does not pass the light so near that the ray's own roundings
/// decide where.
pub fn view(rng: &mut Rng, oracle: &Beam) -> ViewRay {
    loop {
        let view = any_view(rng, &oracle.spot);
        let way = exact(view.eye) - oracle.spot.position;
        let (_, height) = distances(oracle, &exactly(&view));
        if height * height > 1e-4 * way.length_squared() {
            return view;
        }
    }
}

fn any_view(rng: &mut Rng, spot: &oracle::SpotLight) -> ViewRay {
    let target = near_beam(rng, spot, 1.1);
    let eye = match rng.u8(..3) {
        0 => near_beam(rng, spot, 0.9),
        _ => place(target, sweep::direction(rng), 0.3 * 30.0_f64.powf(rng.f64())),
    };
    let eye = sweep::single(eye);
    let way = target - exact(eye);
    let distance = way.length();
    let length = match rng.u8(..4) {
        0 => f64::INFINITY,
        1 => distance * rng.f64(),
        _ => distance * (1.0 + rng.f64()),
    };
    ViewRay { eye, direction: sweep::single(way.normalize()), length: length as f32 }
}

pub fn exactly(view: &ViewRay) -> Ray {
    let length = f64::from(view.length).min(1e12);
    Ray { eye: exact(view.eye), direction: exact(view.direction).normalize(), length }
}

/// The distance of a ray from the light, and how near its line passes it.
pub fn distances(oracle: &Beam, ray: &Ray) -> (f64, f64) {
    let distance = |s: f64| ray.at(s).distance(oracle.spot.position);
    let foot = (oracle.spot.position - ray.eye).dot(ray.direction);
    (distance(foot.clamp(0.0, ray.length)).max(oracle.source_radius), distance(foot))
}
