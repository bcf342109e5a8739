//! Edges that are undefined, and an edge that should not be there.

use super::case::{ALL, Case, assert_fault, assert_ours};
use luminaire::{
    Angle, Cone, Fx16, Fx32, HalfAngle, SpotLight, Vec3,
    display::encode_srgb,
    error::Parameter,
    falloff::{Smooth, Soft},
};
use support::{format::Format, oracle};

/// GLSL's smoothstep by the equation of its specification, which leaves `edge0 >= edge1` undefined.
fn smoothstep(edge0: f32, edge1: f32, x: f32) -> f32 {
    let t = ((x - edge0) / (edge1 - edge0)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Smoothstep by the sentence above that equation, "0 if x <= edge0 and 1 if x >= edge1", in this
/// order: Open Shading Language, `class Smoothstep`.
pub(crate) fn smoothstep_by_comparison(edge0: f32, edge1: f32, x: f32) -> f32 {
    if x < edge0 {
        0.0
    } else if x >= edge1 {
        1.0
    } else {
        smoothstep(edge0, edge1, x)
    }
}

/// three.js, src/renderers/shaders/ShaderChunk/lights_pars_begin.glsl.js: with a penumbra of 0,
/// the default, both edges have the same cosine. A pixel with exactly that cosine is NaN.
#[test]
fn three_js_has_no_number_at_an_edge_without_a_penumbra() {
    let (angle, penumbra) = (20.0_f32.to_radians(), 0.0_f32);
    let (cone, inner) = (angle.cos(), (angle * (1.0 - penumbra)).cos());
    assert_eq!([cone.next_up(), cone.next_down()].map(|cosine| smoothstep(cone, inner, cosine)), [1.0, 0.0]);
    assert!(smoothstep(cone, inner, cone).is_nan());

    let step = Case { inner: 20.0, ..Case::open("step", Smooth, oracle::step, 20.0) };
    assert_eq!(step.held_by(), ALL);
}

/// GLSL, smoothstep: with the cone's two cosines swapped, and its edges so in falling order, two
/// readings of the specification differ by all of the light: one is a beam inside out, the other a
/// beam without a penumbra.
#[test]
fn glsl_leaves_smoothstep_of_swapped_angles_undefined() {
    let (narrow, wide) = (10.0_f32.to_radians().cos(), 12.0_f32.to_radians().cos());
    let [by_equation, by_comparison] = [smoothstep, smoothstep_by_comparison]
        .map(|f| [13.0_f32, 11.0, 5.0].map(|x| f(narrow, wide, x.to_radians().cos())));
    assert_eq!([by_equation[0], by_equation[2]], [1.0, 0.0]);
    assert_eq!(by_comparison, [0.0, 0.0, 1.0]);
    assert_fault(by_equation[1], 0.45..=0.55);

    let cone = Cone::from_outer(Smooth, HalfAngle::degrees(10.0)).expect("a sound cone");
    let refused = cone.with_inner(HalfAngle::degrees(12.0)).expect_err("swapped");
    assert_eq!(refused.parameter, Parameter::InnerAngle);
    assert_eq!(refused.to_string(), "inner angle = 24: expected 0 to 20 degrees (full angle)");
    let upright = Case { inner: 10.0, ..Case::open("smooth", Smooth, oracle::smooth, 12.0) };
    assert_eq!(upright.held_by(), ALL);
}

/// How bright the lights of Godot's thread were: 200 times what the display shows.
const ENERGY: f32 = 200.0;

/// The largest step of an 8-bit display from one of many points to the next, on the way out of a
/// soft beam that falls on a floor from a height of 4; and whether skipping changed any of them.
fn largest_step<S: Format>(early_exit: impl Fn(f32) -> f32) -> u8 {
    let cone = Cone::from_outer(Soft, Angle::degrees(45.0)).expect("a sound cone");
    let spot =
        SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone).expect("a sound light");
    let spot = spot.with_intensity(16.0).expect("sound").compile::<S>().expect("held");
    let up = Vec3::new(S::ZERO, S::ONE, S::ZERO);
    let gain = S::gain(ENERGY);
    // The beam ends at 1.657.
    let codes = (0..20_000_u16).map(|i| {
        let point = Vec3::new(1.5 + f32::from(i) * 1e-5, 0.0, 0.0).map(S::length);
        let light = spot.irradiance(point, up);
        assert_eq!(light, spot.irradiance_unskipped(point, up));
        encode_srgb(early_exit(S::light_to_f32(S::amplify(light, gain))))
    });
    let codes: Vec<_> = codes.collect();
    assert!(codes[0] > 100 && codes.last() == Some(&0));
    codes.windows(2).map(|pair| pair[0].abs_diff(pair[1])).max().expect("points")
}

/// Godot, scene_forward_lights_inc.glsl, issue 102241: lights whose attenuation is under a
/// thousandth are skipped. Two hundred times as bright as full scale, that is an edge of 124 codes
/// where the light should end in none.
///
/// Here only zero is skipped. What is left in 16 bits is the step of the format itself, 2^-14 of
/// such a light.
#[test]
fn godot_cuts_off_the_edge_of_a_bright_light() {
    const EPSILON: f32 = 1e-3;
    let early_exit = |light: f32| if light < EPSILON * ENERGY { 0.0 } else { light };
    assert_fault(largest_step::<f32>(early_exit), 123.0..=125.0);
    assert_ours("f32", largest_step::<f32>(|light| light).into(), 1.0);
    assert_ours("fx32", largest_step::<Fx32>(|light| light).into(), 1.0);
    assert_ours("fx16", largest_step::<Fx16>(|light| light).into(), 30.0);
}
