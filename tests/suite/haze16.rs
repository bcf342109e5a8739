//! In-scattering in 32-bit products: near to the exact one, and at the light's body.

use fastrand::Rng;
use luminaire::{
    Cone, Fx16, Fx32, HalfAngle, Length, Scalar, SpotLight, Vec3,
    codegen::Gain16,
    falloff::Soft,
    haze::{BeamScattering16, Haze},
    number::Light16,
};
use support::assert_that;

fn haze(density: f32) -> Haze {
    Haze::new(density).expect("a sound density")
}

/// A light at the origin that shines along the negative y axis, with a body of this radius.
fn beam(degrees: f32, intensity: f32, radius: f32) -> BeamScattering16<Soft> {
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(degrees)).expect("a sound angle");
    let spot =
        SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone).and_then(|spot| spot.with_intensity(intensity));
    let haze = haze(1.0).with_source_radius(radius).expect("a sound radius");
    spot.and_then(|spot| spot.compile::<Fx16>()).expect("a sound light").in_haze(&haze)
}

/// The light of a line of sight, in linear codes.
fn seen(beam: &BeamScattering16<Soft>, eye: [f32; 3], surface: [f32; 3]) -> f32 {
    255.0 * Fx16::light_to_f32(beam.in_scattering(Fx16::point(eye), Fx16::point(surface)))
}

/// Far away, a light as many times as bright looks the same: the light of a line of sight is
/// inverse to its distance. The largest distance is beyond the points whose units are finest.
#[test]
fn a_scene_of_any_size_looks_the_same() {
    for (eye, surface) in [
        ([0.5, -0.5, 1.0], [-0.25, -1.0, -1.0]),
        ([1.0, -1.5, 1.0], [1.0, -1.5, -1.0]),
        ([0.25, -1.0, 0.25], [0.25, 1.0, 0.5]),
        ([1.5, -1.0, 1.0], [1.25, -1.5, -1.75]),
    ] {
        let at = |scale: f32| {
            let [eye, surface] = [eye, surface].map(|point| point.map(|c| c * scale));
            seen(&beam(80.0, 3.0 * scale, 0.125 * scale), eye, surface)
        };
        let here = at(1.0);
        assert_that!(here > 8.0, here);
        for scale in [16.0, 256.0, 4_096.0, 16_384.0] {
            let there = at(scale);
            assert!((there - here).abs() < 0.6, "{scale}: {there}, not {here}");
        }
    }
}

/// A body hides what is behind it, and no light comes from within.
#[test]
fn the_body_of_the_light_hides_and_is_dark() {
    for radius in [0.25, 1.0, 4.0] {
        let beam = beam(85.0, 3.0 * radius, radius);
        let seen = |eye: [f32; 3], surface: [f32; 3]| {
            seen(&beam, eye.map(|c| c * radius), surface.map(|c| c * radius))
        };
        let same = |one: f32, other: f32| assert_that!((one - other).abs() < 1.0, one, other);
        for height in [0.6, 0.9] {
            // A line of sight across the body, at this height below its centre.
            let edge = f32::sqrt(1.0 - height * height);
            let at = |x: f32| [x, -height, 0.0];
            let before = seen(at(3.0), at(edge));
            let after = seen(at(-edge), at(-3.0));
            assert_that!(before > 10.0, before);
            same(before, after);
            same(seen(at(3.0), at(0.1)), before);
            same(seen(at(3.0), at(-0.1)), before);
            same(seen(at(3.0), at(-3.0)), before);
            same(seen(at(0.1), at(-3.0)), after);
            same(seen(at(-0.1), at(-3.0)), after);
            assert_eq!(seen(at(0.2), at(0.1)), 0.0);
            assert_eq!(seen(at(0.2), at(-0.4)), 0.0);
            // Before and beyond the body nothing is hidden.
            let farther = seen(at(3.0), at(2.0));
            same(farther, seen(at(-2.0), at(-3.0)));
            assert_that!(farther < before - 10.0, farther, before);
        }
        // Straight up from below, at the axis.
        let below = |y: f32| [0.0, -y, 0.0];
        same(seen(below(3.0), below(1.0)), seen(below(3.0), below(-1.0)));
        same(seen(below(3.0), below(1.0)), seen(below(3.0), below(0.2)));
        same(seen(below(0.5), below(3.0)), seen(below(1.0), below(3.0)));
    }
}

/// A line of sight that passes near to the light, and whose ends are outside of the beam, looks the
/// same however far away its ends are.
#[test]
fn lines_past_the_light_may_be_long() {
    let height = 1.0 / 64.0;
    let beam = beam(80.0, height, height / 4.0);
    let at = |x: f32| seen(&beam, [-x, -height, 0.0], [x, -height, 0.0]);
    let near = at(1.0);
    assert_that!(near > 50.0, near);
    for x in [64.0, 1_024.0, 8_192.0, 32_000.0] {
        assert!((at(x) - near).abs() < 0.6, "{x}: {}, not {near}", at(x));
    }
}

/// A line of sight through the light, or one whose end is exactly on the axis, looks like one
/// beside it.
#[test]
fn exact_directions_look_like_those_beside_them() {
    let beam = beam(60.0, 6.0, 0.125);
    let beside = |point: [f32; 3]| [point[0] + 0.004, point[1], point[2] - 0.004];
    for (eye, surface) in [
        ([0.5, -1.5, 0.25], [0.25, -0.75, 0.125]),
        ([0.25, -0.75, 0.125], [0.5, -1.5, 0.25]),
        ([0.75, -2.25, 0.375], [0.25, -0.75, 0.125]),
        ([0.0, -3.0, 0.0], [0.0, -0.5, 0.0]),
        ([0.0, 1.0, 0.0], [1.0, -1.0, 0.0]),
        ([1.0, -1.0, 0.5], [0.0, 1.0, 0.0]),
        ([0.0, 1.0, 0.0], [0.5, -1.0, -1.0]),
    ] {
        let (exactly, nearly) = (seen(&beam, eye, surface), seen(&beam, beside(eye), beside(surface)));
        assert_that!(exactly > 4.0, eye, surface, exactly);
        assert_that!((exactly / nearly - 1.0).abs() < 0.06, eye, surface, exactly, nearly);
    }
}

/// Points of any bits, in the beams of wide and of narrow cones, and beams of any bits.
#[test]
fn in_16_bits_every_point_has_in_scattering() {
    let mut rng = Rng::with_seed(16);
    for i in 0..20_000 {
        let half = HalfAngle::degrees([0.8, 3.0, 20.0, 60.0, 90.0][i % 5]);
        let cone = Cone::from_outer(Soft, half).expect("a sound angle");
        let spot = SpotLight::new([0.1, -3.0, 2.0], [0.36, -0.8, 0.48], cone).expect("a sound light");
        let beam = spot.compile::<Fx16>().expect("held").in_haze(&haze(0.02));
        let mut word = || rng.i32(..) >> rng.u32(..32);
        let [eye, surface] = [(); 2].map(|()| Vec3::new(word(), word(), word()).map(Length::from_bits));
        let _: Light16 = beam.in_scattering(eye, surface);
        let clear = spot.compile::<Fx16>().expect("held").in_haze(&haze(0.0));
        assert_eq!(clear.in_scattering(eye, surface), Light16::default());
        let light = Fx16::point([0.1, -3.0, 2.0]);
        let _: [Light16; 2] = [beam.in_scattering(light, surface), beam.in_scattering(eye, light)];
        let any = BeamScattering16::from_parts(
            eye,
            Vec3::new(word(), word(), word()).map(Fx32::from_bits),
            cone.compile::<Fx16>().expect("held"),
            Gain16::from_bits([word(), word()]),
            [word(), word()].map(i32::cast_unsigned),
            Length::from_bits(word()),
            Gain16::from_bits([word(), word()]),
        );
        let _: Light16 = any.in_scattering(surface, light);
    }
}
