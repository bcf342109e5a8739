//! Imported lights against the complete formulas of their systems in f64: which imports are exact,
//! how large the differences of the others are, and that an importer states these differences
//! correctly.
//!
//! `cargo test --test suite import:: -- --nocapture --test-threads 1` prints the differences and
//! the errors.

use luminaire::{
    SpotLight, Vec3,
    attenuation::{AnyAttenuation, Attenuation},
    falloff::{AnyFalloff, Falloff},
    import::{self, Difference, Imported, OpenGlLight},
};
use support::{
    assert_that,
    imports::{self, ORIGIN},
    originals::Original,
    sweep,
};

/// Numbers from 0 to 1, denser at both ends.
fn places(count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| {
        let place = f64::from(i) / f64::from(count);
        let (near, far) = (place.powi(4), (1.0 - place).powi(4));
        near / (near + far)
    })
}

/// The light at a distance, on the axis.
pub(crate) fn fall(light: &SpotLight<AnyFalloff, AnyAttenuation>, distance: f64) -> f64 {
    f64::from(light.intensity()) * light.attenuation().exact(distance)
}

/// The factor by which the importer scaled the intensity: Godot's value on the axis, if the import
/// is a real power.
pub(crate) fn on_axis(light: &SpotLight<AnyFalloff, AnyAttenuation>, original: &Original) -> f64 {
    if matches!(light.cone().falloff(), AnyFalloff::InvertedRealPower(_)) {
        (original.angle)(1.0)
    } else {
        1.0
    }
}

/// The largest difference over the angle between an original and the falloff that replaces it,
/// relative to the original on the axis. `t` goes from 1 in the middle of the ramp to 2^-24 at its
/// edge, and with OpenGL only as far as the cutoff.
fn angle_difference(light: &SpotLight<AnyFalloff, AnyAttenuation>, original: &Original) -> f64 {
    let is_opengl = original.name.starts_with("OpenGL");
    let (inner, edge) = (1.0 - original.inner, 1.0 - original.outer);
    let outer = if is_opengl { 1.0 } else { edge };
    let on_axis = on_axis(light, original);
    let least = ((outer - edge) / (outer - inner)).max(0.5_f64.powi(24));
    places(20_000 * sweep::effort() as u32)
        .map(|place| {
            let t = least + (1.0 - least) * place;
            // Slightly inside the jumps, because f64 cannot decide on which side of a jump an angle
            // is.
            let cosine = 1.0 - (outer - t * (outer - inner)) + if place == 0.0 { 1e-15 } else { 0.0 };
            (light.cone().falloff().formula().exact(t) - (original.angle)(cosine) / on_axis).abs()
        })
        .fold(0.0, f64::max)
}

/// The distances between which a light is compared with its original, as [`Difference`] defines
/// them.
fn compared(original: &Original) -> [f64; 2] {
    let end = original.range.unwrap_or(16.0);
    [original.stop.max(end / 16.0), end]
}

/// The largest relative difference between two distances.
pub(crate) fn distance_difference(
    light: &SpotLight<AnyFalloff, AnyAttenuation>,
    original: &Original,
    [start, end]: [f64; 2],
) -> f64 {
    let count = 20_000 * sweep::effort() as u32;
    (0..count)
        .map(|i| {
            let d = start * (end / start).powf(f64::from(i) / f64::from(count));
            let (found, exact) = (fall(light, d) / on_axis(light, original), (original.distance)(d));
            (found - exact).abs() / exact.max(found)
        })
        .fold(0.0, f64::max)
}

#[test]
fn what_the_kernel_has_is_exact() {
    for (Imported { light, difference }, original) in imports::exact() {
        assert_eq!((difference.angle, difference.distance), (0.0, 0.0), "{}", original.name);
        let is_step =
            original.inner == original.outer || matches!(light.cone().falloff(), AnyFalloff::Step(_));
        if !is_step {
            let angle = angle_difference(&light, &original);
            // Where a root is steep, the original formula itself loses digits by cancellation.
            let is_real =
                matches!(light.cone().falloff(), AnyFalloff::RealPower(_) | AnyFalloff::InvertedRealPower(_));
            let most = if is_real { 1e-8 } else { 1e-12 };
            assert!(angle < most, "{}: {angle:.1e} over the angle", original.name);
        }
        let ends = [original.stop.max(1e-4), original.range.unwrap_or(32_767.0)];
        let distance = distance_difference(&light, &original, ends);
        // Coefficients are rounded to f32 when they are scaled.
        assert!(distance < 2e-7, "{}: {distance:.1e} over the distance", original.name);
    }
}

#[test]
fn defaults_are_those_of_the_specifications() {
    let import::OpenGl { spot_exponent, constant_attenuation, intensity, .. } = Default::default();
    let import::OpenGl { linear_attenuation, quadratic_attenuation, spot_cutoff, .. } = Default::default();
    assert_eq!([spot_exponent, constant_attenuation, intensity, spot_cutoff], [0.0, 1.0, 1.0, 180.0]);
    assert_eq!([linear_attenuation, quadratic_attenuation], [0.0; 2]);
    let import::Gltf { inner_cone_angle, outer_cone_angle, range, intensity } = Default::default();
    assert_eq!([inner_cone_angle, outer_cone_angle, intensity], [0.0, std::f32::consts::FRAC_PI_4, 1.0]);
    assert_eq!(range, None);
    let import::Three { angle, penumbra, distance, decay, intensity } = Default::default();
    assert_eq!([penumbra, distance, decay, intensity], [0.0, 0.0, 2.0, 1.0]);
    assert_eq!(angle, std::f32::consts::FRAC_PI_3);
    let import::Godot { spot_angle, spot_angle_attenuation, spot_range, .. } = Default::default();
    let import::Godot { spot_attenuation, light_energy, .. } = Default::default();
    assert_eq!([spot_angle, spot_angle_attenuation, spot_range], [45.0, 1.0, 5.0]);
    assert_eq!([spot_attenuation, light_energy], [1.0; 2]);
}

/// The stated difference is not smaller than the largest difference, and at most 2 % larger.
#[test]
fn a_difference_is_what_a_dense_search_finds() {
    for (Imported { light, difference }, original) in imports::near() {
        let distance = distance_difference(&light, &original, compared(&original));
        let found = [angle_difference(&light, &original), distance];
        println!(
            "{}: {:.3e} {:.3e} {:?}",
            original.name,
            difference.angle,
            difference.distance,
            light.cone().falloff()
        );
        // Differences under 1e-7 over the distance are only the rounding of coefficients.
        let stated = [(difference.angle, 1e-8), (difference.distance, 1e-7)];
        for (found, (stated, rounding)) in found.into_iter().zip(stated) {
            let stated = f64::from(stated);
            assert_that!(difference.most() <= 1.0, original.name);
            let holds = stated >= found - rounding && stated <= 1.02 * found + rounding;
            assert!(holds, "{}: {found:.5e} is stated as {stated:.5e}", original.name);
        }
    }
}

/// The largest stated differences of each system, over all lights of this file: at most 1/510 over
/// the angle, or 1/510 of the half angle in position where the slope is infinite.
#[test]
fn no_import_is_off_by_half_a_step_over_the_angle() {
    let mut systems: Vec<(String, u32, Difference)> = Vec::new();
    for (Imported { difference, .. }, original) in imports::exact().into_iter().chain(imports::near()) {
        let name = original.name.split(',').next().unwrap_or_default().split(' ').next().unwrap_or_default();
        let Some((_, lights, worst)) = systems.iter_mut().find(|(system, ..)| system == name) else {
            systems.push((name.to_string(), 1, difference));
            continue;
        };
        *lights += 1;
        worst.angle = worst.angle.max(difference.angle);
        worst.place = worst.place.max(difference.place);
        worst.distance = worst.distance.max(difference.distance);
    }
    for (system, lights, Difference { angle, place, distance }) in systems {
        println!(
            "{system:10} {lights:3} lights: angle {angle:.2e}, place {place:.2e}, distance {distance:.2e}"
        );
        assert_that!(angle.max(place) <= 1.0 / 510.0, system, angle, place);
        assert_that!(distance <= 1.0, system, distance);
    }
}

/// The slope is infinite exactly where the import states it. The slope counts as infinite if more
/// than 1.1 % of the original's rise over the last ten-thousandth of the angle is in the last
/// hundredth of that strip.
#[test]
fn a_difference_of_the_place_is_a_boundless_slope() {
    let mut boundless = 0;
    for (Imported { light, difference }, original) in imports::exact() {
        let is_step =
            original.inner == original.outer || matches!(light.cone().falloff(), AnyFalloff::Step(_));
        let at = |within: f64| (original.angle)((original.outer.acos() * (1.0 - within)).cos());
        let [edge, near, far] = [1e-10, 1e-6, 1e-4].map(at);
        let is_boundless = !is_step && near - edge > 0.011 * (far - edge);
        assert_eq!(difference.place > 0.0, is_boundless, "{}: {edge:e} {near:e} {far:e}", original.name);
        boundless += u32::from(is_boundless);
    }
    assert!(boundless >= 16, "only {boundless} lights have a boundless slope");
}

/// Compares the reference code of the extension, including its `max(0.001, ...)`, with the light
/// imported by that code, also on the axis.
#[test]
fn gltf_as_recommended_is_the_reference_code() {
    const BINDING: [[f32; 2]; 7] =
        [[0.0, 0.005], [0.0, 0.02], [0.01, 0.044], [0.05, 0.06], [0.3, 0.3], [0.785, 0.785], [1.55, 1.56]];
    const LOOSE: [[f32; 2]; 4] =
        [[0.0, 0.0448], [0.0, 0.785], [0.3, 0.5], [1.2, std::f32::consts::FRAC_PI_2]];
    for [inner, outer] in BINDING.into_iter().chain(LOOSE) {
        let gltf = import::Gltf {
            inner_cone_angle: inner,
            outer_cone_angle: outer,
            intensity: 3.0,
            ..Default::default()
        };
        let Imported { light, difference } =
            gltf.import_as_recommended(ORIGIN, imports::DOWN).expect("sound");
        assert_eq!(difference, Difference::default());
        if LOOSE.contains(&[inner, outer]) {
            assert_eq!(light, gltf.import(ORIGIN, imports::DOWN).expect("sound").light, "{inner} {outer}");
        }
        let versine = |half: f32| 2.0 * (f64::from(half) / 2.0).sin().powi(2);
        let scale = 1.0 / (versine(outer) - versine(inner)).max(0.001);
        let [from, to] = [light.cone().inner(), light.cone().outer()].map(|angle| f64::from(angle.versine()));
        let worst = (0..=1_000_u32)
            .map(|i| versine(outer) * f64::from(i) / 900.0)
            .map(|v| {
                let exact = 3.0 * ((versine(outer) - v) * scale).clamp(0.0, 1.0).powi(2);
                let found = f64::from(light.intensity()) * ((to - v) / (to - from)).clamp(0.0, 1.0).powi(2);
                (found - exact).abs()
            })
            .fold(0.0, f64::max);
        // The error of f32 versines, magnified by the ramp.
        assert_that!(worst <= 3.0 * 2.0 * 8e-7 * versine(outer) * scale, inner, outer, worst);
    }
}

/// A light with a cutoff of 180 degrees shines in all directions, whatever its exponent.
#[test]
fn a_cutoff_of_half_a_turn_is_a_point_light() {
    let light = import::OpenGl { spot_exponent: 7.0, linear_attenuation: 0.5, ..Default::default() };
    let imported = light.import(ORIGIN, Vec3::default()).expect("a point light has no direction");
    let OpenGlLight::Point(point) = imported.light else { panic!("{imported:?}") };
    assert_eq!(imported.difference, Difference::default());
    let lit = point.compile::<f32>().expect("held");
    for (x, expected) in [(2.0, 0.5), (-8.0, 0.2)] {
        let normal = Vec3::new(-x / f32::abs(x), 0.0, 0.0);
        let light = lit.irradiance(Vec3::new(x, 0.0, 0.0), normal);
        assert_that!((light - expected).abs() < 1e-6, light);
    }
}
