//! Importers refuse bad parameters of other systems by the names that these systems use. For
//! parameters of any bits, an importer never panics, and returns a sound light or an error.

use fastrand::Rng;
use luminaire::{
    Angle, Error, Fx16,
    import::{Difference, Direct3d, Gltf, Godot, Imported, OpenGl, OpenGlLight, Penumbra, Ramp, Three},
};
use support::{
    arbitrary::bits,
    assert_that,
    imports::{DOWN, ORIGIN},
    sweep,
};

use crate::refusals::assert_refused;

const DIRECT3D: Direct3d = Direct3d {
    theta: 0.3,
    phi: 0.6,
    falloff: 1.0,
    attenuation0: 1.0,
    attenuation1: 0.0,
    attenuation2: 0.0,
    range: 10.0,
    intensity: 1.0,
};

#[test]
fn opengl_is_refused_by_its_names() {
    let refused = |light: OpenGl, message: &str| assert_refused(light.import(ORIGIN, DOWN), message);
    for (spot_cutoff, shown) in
        [(0.0, "0"), (-1.0, "-1"), (90.5, "90.5"), (179.0, "179"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")]
    {
        let message = format!(
            "spot cutoff = {shown}: expected more than 0 and at most 90, or 180 degrees (half angle)"
        );
        refused(OpenGl { spot_cutoff, ..Default::default() }, &message);
    }
    let message = "spot exponent = 1024.5: expected a finite number from 0 to 1024";
    refused(OpenGl { spot_exponent: 1024.5, ..Default::default() }, message);
    let message = "attenuation coefficient = -1: expected a finite number from 0 to 1000000000";
    refused(OpenGl { linear_attenuation: -1.0, ..Default::default() }, message);
    // If all three coefficients were zero, the attenuation would divide by zero.
    let message = "attenuation coefficient = 0: expected a finite number from 0.000001 to 1000000000";
    refused(OpenGl { constant_attenuation: 0.0, ..Default::default() }, message);
    let message = "intensity = NaN: expected a finite number from 0 to 1000000000";
    refused(OpenGl { intensity: f32::NAN, ..Default::default() }, message);
    let message = "axis = 0: expected finite components and a length between 1e-18 and 1e18";
    assert_refused(OpenGl { spot_cutoff: 20.0, ..Default::default() }.import(ORIGIN, ORIGIN), message);
}

#[test]
fn direct3d_is_refused_by_its_names() {
    let refused = |light: Direct3d, message: &str| assert_refused(light.import(ORIGIN, DOWN), message);
    refused(
        Direct3d { phi: 3.2, ..DIRECT3D },
        "phi = 3.2: expected more than 0 and at most 3.1415927 radians (full angle)",
    );
    refused(
        Direct3d { phi: 0.0, ..DIRECT3D },
        "phi = 0: expected more than 0 and at most 3.1415927 radians (full angle)",
    );
    refused(
        Direct3d { theta: 0.7, ..DIRECT3D },
        "theta = 0.7: expected a finite number from 0 to 0.6 radians (full angle)",
    );
    refused(Direct3d { falloff: -1.0, ..DIRECT3D }, "falloff = -1: expected a finite number from 0 to 1024");
    let message =
        "range = 0: expected a distance from 0.001 to 1000000000, or an attenuation without a range";
    refused(Direct3d { range: 0.0, ..DIRECT3D }, message);
    refused(Direct3d { range: f32::NAN, ..DIRECT3D }, &message.replace("range = 0", "range = NaN"));
}

#[test]
fn gltf_three_and_godot_are_refused_by_their_names() {
    let refused = |light: Gltf, message: &str| assert_refused(light.import(ORIGIN, DOWN), message);
    let message = "outer cone angle = 1.6: expected more than 0 and at most 1.5707964 radians (half angle)";
    refused(Gltf { outer_cone_angle: 1.6, ..Default::default() }, message);
    let message = "inner cone angle = 0.8: expected a finite number from 0 to 0.7853982 radians (half angle)";
    refused(Gltf { inner_cone_angle: 0.8, ..Default::default() }, message);
    let message =
        "range = 0: expected a distance from 0.001 to 1000000000, or an attenuation without a range";
    refused(Gltf { range: Some(0.0), ..Default::default() }, message);
    let steep = Gltf { inner_cone_angle: 0.8, ..Default::default() };
    let message = "inner cone angle = 0.8: expected a finite number from 0 to 0.7853982 radians (half angle)";
    assert_refused(steep.import_as_recommended(ORIGIN, DOWN), message);

    let refused = |light: Three, message: &str| assert_refused(light.import(ORIGIN, DOWN), message);
    let message = "spot angle = NaN: expected more than 0 and at most 1.5707964 radians (half angle)";
    refused(Three { angle: f32::NAN, ..Default::default() }, message);
    let message = "penumbra = 1.5: expected a finite number from 0 to 1";
    refused(Three { penumbra: 1.5, ..Default::default() }, message);
    let message = "decay = -1: expected a finite number from 0 to 16";
    refused(Three { decay: -1.0, ..Default::default() }, message);
    let message =
        "range = -3: expected a distance from 0.001 to 1000000000, or an attenuation without a range";
    refused(Three { distance: -3.0, ..Default::default() }, message);

    let refused = |light: Godot, message: &str| assert_refused(light.import(ORIGIN, DOWN), message);
    let message = "spot angle = 120: expected more than 0 and at most 90 degrees (half angle)";
    refused(Godot { spot_angle: 120.0, ..Default::default() }, message);
    let message = "spot angle attenuation = 0: expected a finite number from 0.0078125 to 128";
    refused(Godot { spot_angle_attenuation: 0.0, ..Default::default() }, message);
    let message = "intensity = -1: expected a finite number from 0 to 1000000000";
    refused(Godot { light_energy: -1.0, ..Default::default() }, message);
}

#[test]
fn penumbras_are_refused_by_their_names() {
    let light = |umbra, penumbra| {
        let [umbra, penumbra] = [umbra, penumbra].map(Angle::degrees);
        Penumbra { umbra, penumbra, ramp: Ramp::Linear, intensity: 1.0 }.import(ORIGIN, DOWN)
    };
    let message = "penumbra = 181: expected more than 0 and at most 180 degrees (full angle)";
    assert_refused(light(10.0, 181.0), message);
    assert_refused(light(0.0, 0.0), &message.replace("181", "0"));
    assert_refused(light(20.0, 10.0), "umbra = 20: expected 0 to 10 degrees (full angle)");
    assert_refused(light(f32::NAN, 10.0), "umbra = NaN: expected 0 to 10 degrees (full angle)");
}

/// A random parameter: any bits, a special value, or a sound value, so that many of the lights are
/// accepted.
fn parameter(rng: &mut Rng) -> f32 {
    const SEAMS: [f32; 14] = [
        0.0,
        1e-30,
        1e-6,
        1e-3,
        0.01,
        1.0,
        1.5,
        2.0,
        std::f32::consts::FRAC_PI_2,
        std::f32::consts::PI,
        90.0,
        128.0,
        180.0,
        1e9,
    ];
    match rng.u8(..8) {
        0 => f32::from_bits(bits(rng) as u32),
        1..=3 => SEAMS[rng.usize(..SEAMS.len())],
        _ => rng.f32() * [1.0, 2.0, 90.0][rng.usize(..3)],
    }
}

#[test]
fn every_parameter_has_an_answer() {
    let mut rng = Rng::with_seed(0x6c_7466);
    let rng = &mut rng;
    let mut accepted = [0; 7];
    for _ in 0..200 * sweep::effort() {
        let [a, b, c, d, e, f, g, h] = core::array::from_fn(|_| parameter(rng));
        let (position, direction) = (sweep::direction(rng), sweep::direction(rng));
        let (position, direction) = (sweep::single(position), sweep::single(direction));
        let opengl = OpenGl {
            spot_cutoff: a,
            spot_exponent: b,
            constant_attenuation: c,
            linear_attenuation: d,
            quadratic_attenuation: e,
            intensity: f,
        };
        let direct3d = Direct3d {
            theta: a.min(b),
            phi: b,
            falloff: c,
            attenuation0: d,
            attenuation1: e,
            attenuation2: f,
            range: g,
            intensity: h,
        };
        let gltf = Gltf {
            inner_cone_angle: a.min(b),
            outer_cone_angle: b,
            range: rng.bool().then_some(c),
            intensity: d,
        };
        let three = Three { angle: a, penumbra: b, distance: c, decay: d, intensity: e };
        let godot = Godot {
            spot_angle: a,
            spot_angle_attenuation: b,
            spot_range: c,
            spot_attenuation: d,
            light_energy: e,
        };
        let penumbra = Penumbra {
            umbra: Angle::degrees(a.min(b)),
            penumbra: Angle::degrees(b),
            ramp: if rng.bool() { Ramp::Linear } else { Ramp::Smooth },
            intensity: c,
        };
        let into_light =
            |Imported { light, difference }| Imported { light: OpenGlLight::Spot(light), difference };
        let imports: [Result<Imported<OpenGlLight>, Error>; 7] = [
            opengl.import(position, direction),
            direct3d.import(position, direction).map(into_light),
            gltf.import(position, direction).map(into_light),
            gltf.import_as_recommended(position, direction).map(into_light),
            three.import(position, direction).map(into_light),
            godot.import(position, direction).map(into_light),
            penumbra.import(position, direction).map(into_light),
        ];
        for (imported, accepted) in imports.into_iter().zip(&mut accepted) {
            let Ok(Imported { light, difference }) = imported else { continue };
            let Difference { angle, place, distance } = difference;
            assert_that!((0.0..=1.0 / 510.0).contains(&place), light, difference);
            assert!(
                (0.0..=1.0).contains(&angle) && (0.0..=1.0).contains(&distance),
                "{light:?} {difference:?}, expected angle in 0.0..=1.0 and distance in 0.0..=1.0"
            );
            assert!((angle.max(distance)..=1.0).contains(&difference.most()));
            *accepted += 1;
            // A format may refuse a light, and one of fewer bits refuses it then, too.
            let [held, fewer] = match light {
                OpenGlLight::Spot(spot) => [spot.compile::<f32>().is_ok(), spot.compile::<Fx16>().is_ok()],
                OpenGlLight::Point(point) => {
                    [point.compile::<f32>().is_ok(), point.compile::<Fx16>().is_ok()]
                }
            };
            assert!(held || !fewer, "{light:?}: refused by f32, expected refused by Fx16");
        }
    }
    println!("accepted: {accepted:?}");
    assert!(accepted.iter().all(|&accepted| accepted > 10), "{accepted:?} accepted, expected over 10 each");
}
