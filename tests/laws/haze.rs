//! A view ray that cannot meet the beam has no in-scattered light.

use super::scene::{self};
use super::words::Words;
use luminaire::{
    SpotLight, Vec3,
    attenuation::Attenuation,
    falloff::Falloff,
    haze::{Haze, RayBundle, ViewRay},
};

/// If `can_meet` returns false, the in-scattered light of the ray is exactly zero. The tested rays
/// run nearly along the axis, against it, towards the light or away from it, in a plane tangent to
/// the cone, or anywhere. The directions from the light to the eye are chosen in the same ways.
pub fn beams_that_are_not_met_are_dark(words: &[u32]) {
    let _: Option<()> = not_met(&mut Words::new(words));
}

fn not_met(words: &mut Words<'_>) -> Option<()> {
    let falloff = scene::falloff(words)?;
    let cone = scene::cone::<f32, _>(words, falloff)?;
    let [position, _] = scene::places::<f32>(words);
    let spot = SpotLight::new(position, words.direction(), cone).ok()?;
    let model = scene::attenuation(words)?;
    assert_not_met(words, spot.with_attenuation(model))
}

fn assert_not_met<P: Falloff, A: Attenuation>(words: &mut Words<'_>, spot: SpotLight<P, A>) -> Option<()> {
    let haze = Haze::new(words.number(0.0, 1.0)).ok()?.with_source_radius(words.number(0.001, 0.1)).ok()?;
    let beam = spot.compile::<f32>().ok()?.in_haze(&haze);
    let half = spot.cone().outer().to_radians() / 2.0;
    let (axis, distance) = (spot.axis(), words.between(-7.0, 10.0).exp2());
    let across = unit(cross(axis, words.direction()));
    let tangent = unit(sum(axis, half.cos(), across, half.sin()));
    let seen = |words: &mut Words<'_>, to_light: Vec3<f32>| {
        let exact = match words.choice(6) {
            0 => axis,
            1 => axis.map(|c| -c),
            2 => to_light,
            3 => to_light.map(|c| -c),
            4 => unit(sum(tangent, 1.0, cross(axis, across), words.between(-4.0, 4.0))),
            _ => words.direction(),
        };
        unit(sum(exact, 1.0, words.direction(), words.between(-23.0, -7.0).exp2()))
    };
    let to_eye = seen(words, axis);
    let eye = sum(spot.position(), 1.0, to_eye, distance);
    let eye = eye.map(|c| words.number(c, c));
    let direction = seen(words, to_eye.map(|c| -c));
    let length = words.number(0.0, 2.0 * distance);
    let view = ViewRay { eye, direction, length };
    if !beam.can_meet(&RayBundle { eye, direction, versine: 0.0, length }) {
        let lights = [beam.in_scattering(&view), beam.in_scattering_through(&view, 4, |_| 1.0)];
        assert_eq!(lights, [0.0; 2], "{spot:?} {haze:?} along {view:?}");
    }
    Some(())
}

/// The weighted sum of two vectors.
fn sum(a: Vec3<f32>, by: f32, b: Vec3<f32>, with: f32) -> Vec3<f32> {
    a.zip(b, |a, b| by * a + with * b)
}

fn unit(v: Vec3<f32>) -> Vec3<f32> {
    let length = v.dot(v).sqrt();
    v.map(|c| c / length)
}

fn cross(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
    Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}
