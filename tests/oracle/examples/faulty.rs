//! A spotlight in plain f32, as it is often written, and what the oracle finds.
//!
//! `cargo run -p luminaire-oracle --example faulty`

use luminaire_oracle::{
    Attenuation, Cone, SpotLight, half_degrees, kernel, kernel::Errors, soft, sweep::SurfacePoint, versine,
};

const POSITION: [f32; 3] = [1.5, 4.0, -0.75];
/// The axis of the light, of unit length up to the rounding of f32.
const AXIS: [f32; 3] = [0.36, -0.8, 0.48];

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The recommended code of glTF's `KHR_lights_punctual`: cosines are subtracted, and divided by
/// their difference or 0.001.
fn faulty(half: f32, point: [f32; 3], normal: [f32; 3]) -> f32 {
    let (cos_inner, cos_outer) = (1.0, half.cos());
    let scale = 1.0 / 0.001_f32.max(cos_inner - cos_outer);
    let offset = -cos_outer * scale;
    let way = minus(point, POSITION);
    let direction = way.map(|c| c / dot(way, way).sqrt());
    let attenuation = (dot(direction, AXIS) * scale + offset).clamp(0.0, 1.0);
    attenuation * attenuation * -dot(direction, normal).min(0.0)
}

/// The same cone by versines, which do not cancel.
fn correct(half: f32, point: [f32; 3], normal: [f32; 3]) -> f32 {
    let outer = 2.0 * (half / 2.0).sin().powi(2);
    let way = minus(point, POSITION);
    let direction = way.map(|c| c / dot(way, way).sqrt());
    let axis = AXIS.map(|c| c / dot(AXIS, AXIS).sqrt());
    let difference = minus(direction, axis);
    let t = (1.0 - dot(difference, difference) / 2.0 / outer).max(0.0);
    t * t * -dot(direction, normal).min(0.0)
}

/// The errors of a kernel, and how many degrees off axis the worst place is.
fn errors(degrees: f32, kernel: fn(f32, [f32; 3], [f32; 3]) -> f32) -> (Errors, f64) {
    let cone = Cone::new(soft, versine(degrees.into()));
    let light = SpotLight::new(POSITION.map(f64::from), AXIS.map(f64::from), cone);
    // The cone alone: no attenuation.
    let light = SpotLight { attenuation: Attenuation::None, ..light };
    let errors = kernel::errors(&light, |point, normal| kernel(degrees.to_radians(), point, normal).into());
    let SurfacePoint { point, .. } = errors.climbed.input;
    (errors, half_degrees(light.versine(point.map(f64::from).into())))
}

fn main() {
    println!("errors in linear codes, 1/255 of full scale");
    println!("           cosines and max(0.001, ..)                      versines");
    println!("half angle     mean     swept   climbed  degrees off axis     mean    swept  climbed");
    for degrees in [45.0, 5.0, 1.0, 0.5] {
        let (wrong, place) = errors(degrees, faulty);
        let (right, _) = errors(degrees, correct);
        let [wrong_row, right_row] = [&wrong, &right].map(|Errors { mean, swept, climbed }| {
            format!("{mean:8.4} {:9.4} {:9.4}", swept.error, climbed.error)
        });
        println!("{degrees:6} deg {wrong_row} {place:13.3}      {right_row}");
        assert!(right.climbed.error < 0.01, "{right}");
        // In narrow beams, 0.001 is more than the difference of the cosines.
        assert_eq!(wrong.climbed.error > 200.0, degrees <= 1.0, "{wrong}");
        assert!(wrong.climbed.error > 3.0 * right.climbed.error, "{wrong}");
    }
}

#[test]
fn the_fault_is_found_and_the_correct_light_is_exact() {
    main();
}
