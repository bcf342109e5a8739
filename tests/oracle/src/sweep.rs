//! Where to look: random inputs, each with the seams of its domain.

use core::f64::consts::{FRAC_PI_2, PI};

use fastrand::Rng;
use glam::DVec3;

use crate::{SpotLight, half_degrees, turned};

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cone, linear, versine};

    #[test]
    fn directions_have_the_angle_off_their_axis() {
        let mut rng = Rng::with_seed(1);
        for radians in [0.0, 1e-6, 1.0, 2.0] {
            let axis = direction(&mut rng);
            let off = direction_off(&mut rng, axis, radians);
            let found = half_degrees(crate::versine_between(axis, off)).to_radians();
            assert!((found - radians).abs() < 1e-14, "{found} is not {radians}");
        }
    }

    #[test]
    fn surface_points_have_both_sides_of_every_seam() {
        let cone = Cone { inner: versine(10.0), ..Cone::new(linear, versine(20.0)) };
        let light = SpotLight::new([1.0, 2.0, 3.0], [0.0, 0.0, 2.0], cone);
        let mut rng = Rng::with_seed(2);
        let mut counts = [0; 6];
        for _ in 0..10_000 {
            let SurfacePoint { point, normal } = surface_point(&mut rng, &light);
            let [point, normal] = [point, normal].map(|v| DVec3::from_array(v.map(f64::from)));
            let (off, faces) = (half_degrees(light.versine(point)), light.position - point);
            let faces = faces.normalize().dot(normal);
            let kinds =
                [(0.0, 1e-3), (9.99, 10.0), (10.0, 10.01), (19.99, 20.0), (20.0, 20.01), (60.0, 180.0)];
            for (count, (from, to)) in counts.iter_mut().zip(kinds) {
                *count += usize::from(from <= off && off < to);
            }
            assert!((0.49..51.0).contains(&point.distance(light.position)) && faces.abs() < 1.0 + 1e-6);
        }
        assert!(counts.iter().all(|&count| count > 200), "{counts:?}");
    }
}
