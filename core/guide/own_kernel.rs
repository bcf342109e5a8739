//! A spotlight of a shader, tested against the oracle.
//!
//! `cargo run -p luminaire-oracle --example own_kernel`

use luminaire_oracle::{Cone, SpotLight, kernel, kernel::Errors, smooth, versine};

/// HLSL, operation by operation in f32, with the light at the origin:
///
/// ```hlsl
/// float3 toLight = -point / length(point);
/// float edge = smoothstep(cosOuter, cosInner, dot(-toLight, axis));
/// return edge * saturate(dot(normal, toLight)) / dot(point, point);
/// ```
fn shader(cosines: [f32; 2], point: [f32; 3], normal: [f32; 3]) -> f32 {
    let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let squared = dot(point, point);
    let to_light = point.map(|c| -c / squared.sqrt());
    let cosine = -dot(to_light, AXIS.map(|c| c as f32));
    let t = ((cosine - cosines[0]) / (cosines[1] - cosines[0])).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t) * dot(normal, to_light).clamp(0.0, 1.0) / squared
}

const AXIS: [f64; 3] = [0.0, -1.0, 0.0];

/// The errors of the shader, by the half angles of the cone in degrees.
fn errors(inner: f32, outer: f32) -> Errors {
    let cone = Cone::new(smooth, versine(outer.into()));
    let cone = Cone { inner: versine(inner.into()), ..cone };
    let light = SpotLight::new([0.0; 3], AXIS, cone);
    let cosines = [outer, inner].map(|degrees| degrees.to_radians().cos());
    kernel::errors(&light, |point, normal| shader(cosines, point, normal).into())
}

fn main() {
    for (inner, outer) in [(20.0, 30.0), (2.0, 3.0), (0.5, 0.75)] {
        println!("{inner} to {outer} degrees: {}", errors(inner, outer));
    }
}

#[test]
fn a_narrow_beam_by_cosines_loses_its_digits() {
    let [wide, narrow] = [errors(20.0, 30.0), errors(0.5, 0.75)].map(|e| e.climbed.error);
    assert!((1e-3..0.01).contains(&wide), "{wide} linear codes");
    assert!((3.0..10.0).contains(&narrow), "{narrow} linear codes");
}
