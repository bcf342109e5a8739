//! Imported lights beside the originals: the lists that the tests iterate over.

use super::originals::{self, Original};
use luminaire::{
    Angle, SpotLight, Vec3,
    attenuation::AnyAttenuation,
    falloff::AnyFalloff,
    import::{self, Imported, OpenGlLight},
};

pub type Import = Imported<SpotLight<AnyFalloff, AnyAttenuation>>;

pub const ORIGIN: Vec3<f32> = Vec3::new(0.0, 0.0, 0.0);
pub const DOWN: Vec3<f32> = Vec3::new(0.0, -1.0, 0.0);

pub fn opengl(cutoff: f32, exponent: f32, [k0, k1, k2]: [f32; 3]) -> (Import, Original) {
    let light = import::OpenGl {
        spot_cutoff: cutoff,
        spot_exponent: exponent,
        constant_attenuation: k0,
        linear_attenuation: k1,
        quadratic_attenuation: k2,
        intensity: 1.0,
    };
    let Imported { light, difference } = light.import(ORIGIN, DOWN).expect("sound");
    let OpenGlLight::Spot(light) = light else { panic!("a spotlight is no point light") };
    (Imported { light, difference }, originals::opengl(cutoff, exponent, [k0, k1, k2]))
}

pub fn direct3d(
    theta: f32,
    phi: f32,
    falloff: f32,
    [a0, a1, a2]: [f32; 3],
    range: f32,
) -> (Import, Original) {
    let light = import::Direct3d {
        theta,
        phi,
        falloff,
        attenuation0: a0,
        attenuation1: a1,
        attenuation2: a2,
        range,
        intensity: 1.0,
    };
    let original = originals::direct3d(theta, phi, falloff, [a0, a1, a2], range);
    (light.import(ORIGIN, DOWN).expect("sound"), original)
}

pub fn gltf(inner: f32, outer: f32, range: Option<f32>) -> (Import, Original) {
    let light = import::Gltf { inner_cone_angle: inner, outer_cone_angle: outer, range, intensity: 1.0 };
    (light.import(ORIGIN, DOWN).expect("sound"), originals::gltf(inner, outer, range))
}

pub fn three(angle: f32, penumbra: f32, distance: f32, decay: f32) -> (Import, Original) {
    let light = import::Three { angle, penumbra, distance, decay, intensity: 1.0 };
    (light.import(ORIGIN, DOWN).expect("sound"), originals::three(angle, penumbra, distance, decay))
}

pub fn godot(angle: f32, angle_attenuation: f32, range: f32, attenuation: f32) -> (Import, Original) {
    let light = import::Godot {
        spot_angle: angle,
        spot_angle_attenuation: angle_attenuation,
        spot_range: range,
        spot_attenuation: attenuation,
        light_energy: 1.0,
    };
    let original = originals::godot(angle, angle_attenuation, range, attenuation);
    (light.import(ORIGIN, DOWN).expect("sound"), original)
}

pub fn penumbra(umbra: f32, penumbra: f32, ramp: import::Ramp) -> (Import, Original) {
    let [inner, outer] = [umbra, penumbra].map(Angle::degrees);
    let light = import::Penumbra { umbra: inner, penumbra: outer, ramp, intensity: 1.0 };
    let original = originals::penumbra(umbra, penumbra, ramp == import::Ramp::Smooth);
    (light.import(ORIGIN, DOWN).expect("sound"), original)
}

pub const PLAIN: [f32; 3] = [1.0, 0.0, 0.0];

/// Lights that the kernel imports exactly.
pub fn exact() -> Vec<(Import, Original)> {
    let mut lights: Vec<_> = (0..=128_u8).map(|e| opengl(35.0, e.into(), PLAIN)).collect();
    lights.extend([
        opengl(60.0, 3.0, [0.2, 0.3, 0.4]),
        opengl(20.0, 0.0, [0.0, 0.0, 2.0]),
        opengl(45.0, 2.0, [0.0, 0.5, 0.25]),
        opengl(45.0, 2.0, [0.0, 3.0, 0.0]),
        opengl(90.0, 0.0, [4.0, 0.0, 0.0]),
        direct3d(0.3, 0.9, 1.0, PLAIN, 20.0),
        direct3d(0.0, 3.1, 2.0, [1.0, 0.5, 0.1], 4.0),
        direct3d(0.3, 0.9, 5.0, [0.0, 0.0, 1.0], 1.8e19),
        direct3d(0.3, 0.9, 0.0, PLAIN, 6.0),
        direct3d(0.9, 0.9, 1.5, PLAIN, 6.0),
        direct3d(0.9, 0.9, 0.0, [0.0, 1.0, 0.0], 1e9),
        gltf(0.0, 0.785, None),
        gltf(0.3, 0.5, Some(7.0)),
        gltf(0.5, 0.5, None),
        gltf(1.2, std::f32::consts::FRAC_PI_2, Some(3.0)),
        three(1.0, 0.0, 0.0, 2.0),
        three(0.7, 0.4, 6.0, 2.0),
        three(0.7, 1.0, 6.0, 0.0),
        three(std::f32::consts::FRAC_PI_2, 0.5, 6.0, 1.0),
        three(0.4, 0.3, 0.0, 1.0),
        three(0.4, 0.3, 0.0, 0.0),
        penumbra(20.0, 30.0, import::Ramp::Linear),
        penumbra(20.0, 30.0, import::Ramp::Smooth),
        penumbra(0.0, 180.0, import::Ramp::Smooth),
        penumbra(40.0, 40.0, import::Ramp::Linear),
    ]);
    for exponent in EXPONENTS {
        lights.push(opengl(90.0, exponent, PLAIN));
        lights.push(opengl(30.0, exponent, PLAIN));
        lights.push(direct3d(0.3, 0.9, exponent, PLAIN, 20.0));
        lights.push(godot(30.0, 1.0 / exponent, 8.0, 2.0));
    }
    for attenuation in [0.125, 1.5, 2.0, 3.0, 4.0, 20.0, 128.0] {
        lights.push(godot(45.0, attenuation, 5.0, 2.0));
    }
    // Every combination of coefficients that are zero.
    for some in 1..8_u8 {
        let coefficients = [0, 1, 2].map(|i| if some >> i & 1 == 1 { [1.0, 0.25, 0.5][i] } else { 0.0 });
        lights.push(opengl(90.0, 1.0, coefficients));
        lights.push(direct3d(0.3, 0.9, 1.0, coefficients, 20.0));
    }
    lights
}

/// Lights that the kernel approximates, and decays.
pub fn near() -> Vec<(Import, Original)> {
    let mut lights = Vec::new();
    for attenuation in [0.25, 0.5, 1.0] {
        lights.push(godot(45.0, attenuation, 5.0, 2.0));
    }
    for decay in [0.1, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9, 2.2, 3.0, 8.0, 16.0] {
        lights.push(godot(45.0, 1.0, 8.0, decay));
        lights.push(three(0.6, 0.3, 8.0, decay));
        lights.push(three(0.6, 0.3, 0.0, decay));
        lights.push(three(0.6, 0.3, 200.0, decay));
    }
    lights
}

const EXPONENTS: [f32; 16] =
    [0.02, 0.1, 0.2, 0.25, 0.333_333_34, 0.5, 0.75, 0.9, 1.1, 1.5, 2.5, 3.5, 7.5, 12.5, 31.5, 127.5];
