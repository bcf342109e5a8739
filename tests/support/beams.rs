//! The error of the intensity with each of the two forms of a versine, `1 - l.s` and
//! `|l - s|^2 / 2`, over the half angle of a soft cone.

use super::format::Format;
use super::{bounds, oracle, sweep};
use fastrand::Rng;
use luminaire::{
    Cone, Scalar, Vec3,
    falloff::Soft,
    light::CompiledCone,
    number::{Offset, Ray, Share},
};

/// The largest errors at a half angle.
#[derive(Clone, Copy)]
pub struct Errors {
    pub half_degrees: f64,
    /// Error of the form `1 - l.s`, with the cosine rounded to a scalar of the format.
    pub cosine_form: f64,
    /// Error of the kernel; `None` if the format refuses the cone.
    pub versine_form: Option<f64>,
}

/// Returns the intensity that the cosine form gives for a direction and an axis of the format; only
/// the cosine is rounded.
fn cosine_form<S: Format>(direction: Vec3<S::Unit>, axis: Vec3<S::Unit>, outer: f64) -> f64 {
    let cosine = S::exact_direction(direction).dot(S::exact_direction(axis));
    let steps = f64::from(S::STEP) / if S::NAME == "f32" && cosine < 1.0 { 2.0 } else { 1.0 };
    let stored = (cosine / steps).round() * steps;
    oracle::falloff(oracle::soft, (1.0 - stored).max(0.0), outer)
}

/// Returns the largest errors over this many points within the cone, on the grid that every format
/// represents exactly.
pub fn errors<S: Format>(half_degrees: f64, count: usize) -> Errors {
    let cone = Cone::from_outer(Soft, sweep::half(half_degrees as f32)).expect("a sound angle");
    let falloff: Option<CompiledCone<S, Soft>> = cone.compile().ok();
    let outer = oracle::versine((half_degrees as f32).into());
    let mut rng = Rng::with_seed(1_993);
    let mut found = Errors { half_degrees, cosine_form: 0.0, versine_form: falloff.map(|_| 0.0) };
    for _ in 0..count {
        let light = sweep::position(&mut rng);
        let axis = S::axis(sweep::single(sweep::direction(&mut rng)));
        let exact_axis = S::exact_direction(axis).normalize();
        let off_axis = half_degrees.to_radians() * rng.f64();
        let (way, distance) = (sweep::direction_off(&mut rng, exact_axis, off_axis), 10.0 + 40.0 * rng.f64());
        let point = sweep::on_grid(light + distance * way);
        let exact = oracle::versine_between(point - light, exact_axis);
        let exact = oracle::falloff(oracle::soft, exact, outer);
        let [from, to] = [light, point].map(|v| sweep::single(v).map(S::length));
        let ray = S::Offset::between(from, to).ray();
        let cosine_form = (cosine_form::<S>(ray.direction(), axis, outer) - exact).abs();
        found.cosine_form = found.cosine_form.max(oracle::counted(cosine_form));
        if let (Some(falloff), Some(worst)) = (&falloff, &mut found.versine_form) {
            *worst = worst.max(oracle::counted((falloff.at_ray(&ray, axis).scalar().exact() - exact).abs()));
        }
    }
    found
}

/// The bound of the versine form: `k delta / theta` for the direction, with the steepness `k` of
/// the soft edge; the relative errors of the lengths of direction and axis and of the outer
/// versine, where `2 t u` is largest; and the rounding from a versine to an intensity.
pub fn versine_bound<S: Scalar>(half_degrees: f64) -> f64 {
    let steepness = 8.0 / (3.0 * 3.0_f64.sqrt());
    // On a common grid the difference of light and point is exact in f32.
    let direction = if S::NAME == "f32" { 5.3e-8 } else { f64::from(S::DIRECTION_ERROR) };
    let direction = steepness * direction / half_degrees.to_radians();
    let own =
        bounds::of("falloff", "soft", S::NAME).expect("the soft edge has a row")[0] * f64::from(S::STEP);
    let lengths = ["length of an axis", "outer versine from the outer angle"].map(figure).iter().sum::<f64>();
    direction + 0.5 * (operation::<S>("ray direction its length") + lengths) + own
}

fn figure(name: &str) -> f64 {
    bounds::of("set-up", name, "f32").expect("a figure of that name")[0]
}

/// The bound of an operation in a format.
pub fn operation<S: Scalar>(name: &str) -> f64 {
    bounds::of("operation", name, S::NAME).expect("a row of that name")[0]
}

/// The narrowest half angle in degrees of a soft cone that a format holds.
pub fn narrowest<S: Scalar>() -> f64 {
    f64::from(Cone::narrowest::<S>(Soft).to_degrees()) / 2.0
}
