//! Cones that an epsilon, a singular angle or a rounded angle takes the light from.

use super::case::{ALL, Case, assert_fault};
use luminaire::{
    Angle, Cone, HalfAngle,
    error::Parameter,
    falloff::{InvertedPower, Soft, Step},
};
use std::f32::consts::FRAC_PI_2;
use support::oracle;

/// The intensity at a cosine when the span of the cone is divided by as no less than `least`: scale
/// and offset, clamp and square.
fn clamped_span(least: f32, inner: f32, outer: f32, cosine: f32) -> f32 {
    let scale = 1.0 / least.max(inner.cos() - outer.cos());
    let offset = -outer.cos() * scale;
    let attenuation = (cosine * scale + offset).clamp(0.0, 1.0);
    attenuation * attenuation
}

/// glTF, extensions/2.0/Khronos/KHR_lights_punctual/README.md, reference code:
/// `max(0.001, cos(inner) - cos(outer))`. A cone of one degree keeps 2.3 % of its light on the
/// axis.
#[test]
fn gltf_divides_by_no_less_than_a_thousandth() {
    assert_fault(clamped_span(0.001, 0.0, 1.0_f32.to_radians(), 1.0), 0.023_1..=0.023_3);
    assert_eq!(Case::open("soft", Soft, oracle::soft, 1.0).held_by(), ALL);
}

/// Filament, filament/src/components/LightManager.cpp: `max(1.0f / 1024.0f, cosInner - cosOuter)`;
/// the square is in shaders/src/light_punctual.fs. At half a degree, the narrowest that it lets
/// through, 0.15 % is left on the axis.
#[test]
fn filament_divides_by_no_less_than_1_in_1024() {
    assert_fault(clamped_span(1.0 / 1024.0, 0.0, 0.5_f32.to_radians(), 1.0), 0.001_50..=0.001_54);
    assert_eq!(Case::open("soft", Soft, oracle::soft, 0.5).held_by(), ["f32", "fx32"]);
}

/// Bevy, crates/bevy_pbr/src/render/light.rs: `1.0 / f32::max(inner.cos() - cos_outer, 1e-4)`.
/// Below 0.81 degrees the axis is dimmed; at half a degree 15 % is left.
#[test]
fn bevy_divides_by_no_less_than_a_ten_thousandth() {
    assert_fault(clamped_span(1e-4, 0.0, 0.5_f32.to_radians(), 1.0), 0.144..=0.146);
    assert_fault(clamped_span(1e-4, 0.0, 0.80_f32.to_radians(), 1.0), 0.93..=0.97);
    assert_fault(clamped_span(1e-4, 0.0, 0.82_f32.to_radians(), 1.0), 1.0..=1.0);
    assert_eq!(Case::open("soft", Soft, oracle::soft, 0.8).held_by(), ALL);
}

/// Bevy, crates/bevy_pbr/src/render/shadows.wgsl, issue 25360: an outer angle of 0 is accepted, its
/// tangent scales the shadow map, and a point on the axis is divided by it. What is left without a
/// shadow is no light at all.
#[test]
fn bevy_divides_by_the_tangent_of_an_angle_of_zero() {
    let (off_axis, depth, outer) = (0.0_f32, 5.0_f32, 0.0_f32);
    let f_div_minus_z = 1.0 / (outer.tan() * depth);
    assert!((off_axis * f_div_minus_z).is_nan());
    assert_fault(clamped_span(1e-4, 0.0, outer, 1.0), 0.0..=0.0);

    let refused = Cone::from_outer(Soft, HalfAngle::radians(outer)).expect_err("no cone");
    assert_eq!(refused.parameter, Parameter::OuterAngle);
    assert_eq!(
        refused.to_string(),
        "outer angle = 0: expected more than 0 and at most 180 degrees (full angle)"
    );
}

/// Bevy, pull request 25368: the f32 next to a right angle lies beyond it, so that its tangent and
/// its cosine have changed sign.
#[test]
fn bevy_takes_the_tangent_of_more_than_a_right_angle() {
    assert_fault(FRAC_PI_2.tan(), -2.288e7..=-2.287e7);
    assert_fault(FRAC_PI_2.cos(), -4.38e-8..=-4.37e-8);

    let cone = Cone::from_outer(Soft, HalfAngle::radians(FRAC_PI_2)).expect("a half space");
    assert_eq!((cone.outer_versine(), cone.outer()), (1.0_f32.next_down(), Angle::degrees(180.0)));
    assert_eq!(Case::open("soft", Soft, oracle::soft, 90.0).held_by(), ALL);
}

/// GLSL's power where its arguments leave it undefined, as processors compute it:
/// `exp2(y log2(x))`.
fn glsl_pow(x: f32, y: f32) -> f32 {
    (y * x.log2()).exp2()
}

/// Godot's spotlight, servers/rendering/renderer_rd/shaders/scene_forward_lights_inc.glsl, with the
/// least rim that its power is given.
fn godot(least_rim: f32, exponent: f32, cosine: f32, edge: f32) -> f32 {
    let rim = least_rim.max((1.0 - cosine.max(edge)) / (1.0 - edge));
    1.0 - glsl_pow(rim, exponent)
}

/// Godot, modules/gltf/extensions/gltf_light.cpp, pull request 120391: the exponent comes from
/// `0.2 / (1 - inner / outer) - 0.1`, and the renderer takes its reciprocal. Two angles that
/// rounding made equal give an exponent of zero, and a light that is dark everywhere.
#[test]
fn godot_loses_a_light_whose_angles_round_to_one() {
    let (inner, outer) = (0.089_f64 - 1e-9, 0.089_f64);
    let attenuation = |ratio: f64| 0.2 / (1.0 - ratio) - 0.1;
    assert_fault(attenuation(inner / outer), 1.7e7..=1.8e7);
    let ratio = inner as f32 / outer as f32;
    let attenuation = attenuation(ratio.into());
    assert_eq!(attenuation, f64::INFINITY);
    let exponent = (1.0 / attenuation) as f32;
    for cosine in [1.0, 0.999, 0.997] {
        assert_eq!(godot(1e-4, exponent, cosine, (outer as f32).cos()), 0.0);
    }
    let half = (outer as f32).to_degrees();
    let step = Case { inner: half, ..Case::open("step", Step, oracle::step, half) };
    assert_eq!(step.held_by(), ALL);
    let soft = Case { inner: half, ..Case::open("soft", Soft, oracle::soft, half) };
    assert_eq!(soft.held_by(), ALL);
}

/// Godot, pull request 69985: `pow(0, 0)` is undefined, and only the minimum rim of the formula
/// above prevents it. Without the minimum the axis is NaN; with it and an exponent of 0.1 the axis
/// has lost two fifths of its light.
#[test]
fn godot_raises_zero_to_the_power_of_zero() {
    assert!(godot(0.0, 0.0, 1.0, 0.9).is_nan());
    assert_fault(godot(1e-4, 0.1, 1.0, 0.9), 0.60..=0.61);
    assert_eq!(
        Case::open("inverted-power-4", InvertedPower::<4>, oracle::inverted_power_4, 30.0).held_by(),
        ALL
    );
}
