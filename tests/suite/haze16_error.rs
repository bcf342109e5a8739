//! The error of in-scattering in 32-bit products, searched over rays of which half are near
//! critical directions, with climbs by bits from the worst.
//!
//! `LUMINAIRE_FULL=1 cargo test --release --test suite haze16_error:: -- --nocapture` evaluates
//! 60,000 rays a cone and falloff, a third of them in climbs.

use fastrand::Rng;
use luminaire::{
    Cone, Fx16, HalfAngle, Length, Scalar, SpotLight, Vec3,
    falloff::{AnyFalloff, Hard, Smooth, Soft},
    haze::{Haze, ViewRays},
};
use support::{
    bounds,
    critical::Frame,
    every::is_full,
    in_scattering::{Beam, Ray},
    oracle::{
        self, DVec3,
        climb::{self, Search},
    },
    sweep,
    views::distances,
};

/// The half angles of the cones, in degrees.
const HALF_ANGLES: [f32; 5] = [3.0, 7.5, 22.0, 45.0, 80.0];

/// Rays that are drawn at once, of which one is evaluated.
const RAYS: usize = 16;

/// The longest ray, in units.
const FARTHEST: f32 = 1_000.0;

/// A ray through the beam of a random light.
#[derive(Clone, Copy)]
struct View {
    /// The seed of the light.
    seed: u64,
    eye: Vec3<f32>,
    surface: Vec3<f32>,
}

/// Random lights that have one cone.
struct Lights {
    cone: Cone<AnyFalloff>,
    truth: oracle::Falloff,
    /// The half angle of the cone, in radians.
    half: f64,
}

impl Lights {
    fn new(falloff: AnyFalloff, truth: oracle::Falloff, degrees: f32) -> Self {
        let cone = Cone::from_outer(falloff, HalfAngle::degrees(degrees)).expect("a sound angle");
        Self { cone, truth, half: f64::from(degrees).to_radians() }
    }

    /// The light of a seed, in haze.
    fn light(&self, seed: u64) -> (SpotLight<AnyFalloff>, Haze) {
        let mut rng = Rng::with_seed(seed);
        let spot = sweep::spot(&mut rng, self.cone);
        let body = Fx16::length(0.001 * 1_000.0_f32.powf(rng.f32()));
        let haze = Haze::new(0.5).and_then(|haze| haze.with_source_radius(body.to_f32()));
        (spot, haze.expect("sound haze"))
    }

    /// The exact beam of a light in haze.
    fn beam(&self, spot: &SpotLight<AnyFalloff>, haze: &Haze) -> Beam {
        let cone = oracle::Cone::new(self.truth, self.cone.outer_versine().into());
        Beam {
            spot: oracle::SpotLight {
                attenuation: oracle::Attenuation::InverseSquare,
                ..sweep::stored::<Fx16, _, _>(spot, cone)
            },
            range: f64::INFINITY,
            density: haze.density().into(),
            source_radius: haze.source_radius().into(),
        }
    }

    fn somewhere(&self, rng: &mut Rng) -> View {
        let seed = rng.u64(..);
        let (spot, _) = self.light(seed);
        let rays: ViewRays<RAYS> = Frame::new(rng, spot.position(), spot.axis(), self.half).rays(rng);
        let view = rays.at(rng.usize(..RAYS));
        let length = view.length.min(FARTHEST);
        let surface = view.eye.zip(view.direction, |e, d| e + length * d);
        View { seed, eye: view.eye, surface }
    }

    /// The error of a ray, in linear codes.
    ///
    /// The light has the intensity at which the ray, or a line that crosses the axis at the angle
    /// of the ray and as near to the light, is at full scale. The error is zero unless both ends of
    /// the ray are at least a radius away from the light's body. It is also zero at the rim of the
    /// body, where the light jumps.
    fn error(&self, View { seed, eye, surface }: View) -> f64 {
        let (spot, haze) = self.light(seed);
        let of_intensity = |intensity: f32| {
            let spot = spot.with_intensity(intensity).expect("a sound intensity");
            (spot, self.beam(&spot, &haze))
        };
        let (_, unit) = of_intensity(1.0);
        let [eye, surface] = [eye, surface].map(|point| Fx16::point(point.into()));
        let way = exact(surface) - exact(eye);
        let ray = Ray { eye: exact(eye), direction: way.normalize(), length: way.length() };
        let body = unit.source_radius;
        let is_apart = |point| (exact(point) - unit.spot.position).length() > 2.0 * body;
        let (nearest, height) = distances(&unit, &ray);
        if !(is_apart(eye) && is_apart(surface)) || (height - body).abs() < 0.1 * body {
            return 0.0;
        }
        let along = ray.direction.dot(unit.spot.axis);
        let sine = (1.0 - along * along).max(0.0).sqrt().max(self.half.sin());
        let seen = unit.across() * nearest * unit.spot.attenuation.at(nearest) / sine;
        let (spot, beam) = of_intensity((1.0 / unit.in_scattering(&ray).max(seen)).min(1e8) as f32);
        let Ok(compiled) = spot.compile::<Fx16>() else { return 0.0 };
        let found = Fx16::light_to_f32(compiled.in_haze(&haze).in_scattering(eye, surface));
        255.0 * (f64::from(found).min(1.0) - beam.in_scattering(&ray).min(1.0)).abs()
    }

    /// The largest error of a search, in linear codes.
    fn largest(&self, search: Search) -> f64 {
        let worst = search.worst(|rng| self.somewhere(rng), moved, |view| self.error(view));
        worst.map_or(0.0, |worst| worst.error)
    }
}

/// A ray of which one coordinate of an end differs, by up to its size or down to its last bits.
fn moved(rng: &mut Rng, view: View) -> View {
    let size = climb::size(rng);
    let mut other = view;
    let end = if rng.bool() { &mut other.eye } else { &mut other.surface };
    *end = climb::one_of(rng, *end, |c| (c * (1.0 + size)).clamp(-2.0 * FARTHEST, 2.0 * FARTHEST));
    other
}

fn exact(point: Vec3<Length>) -> DVec3 {
    DVec3::from([point.x, point.y, point.z].map(|c| f64::from(c.to_bits()) / 65_536.0))
}

/// The bounds of the errors by falloff, in linear codes, in cones of all [`HALF_ANGLES`].
#[test]
fn in_scattering_keeps_its_bound() {
    let search = match is_full() {
        true => Search { starts: 40_000, climbs: 10, steps: 2_000, seed: 1 },
        false => Search { starts: 300, climbs: 2, steps: 50, seed: 16 },
    };
    let falloffs: [(AnyFalloff, oracle::Falloff, f64); 3] = [
        (Soft.into(), oracle::soft, 0.6),
        (Hard.into(), oracle::hard, 0.8),
        (Smooth.into(), oracle::smooth, 0.5),
    ];
    for (falloff, truth, bound) in falloffs {
        let measured = HALF_ANGLES.map(|half| Lights::new(falloff, truth, half).largest(search));
        println!("{falloff:?} {}", bounds::shown(&measured));
        let largest = measured.into_iter().fold(0.0, f64::max);
        let kept = if is_full() { bounds::check("haze16", largest, bound) } else { Ok(()) };
        assert!(largest <= bound && kept.is_ok(), "{falloff:?}: {largest:.3}, expected {bound}: {kept:?}");
    }
}

/// A ray with the largest error that is known, by the bits of its coordinates.
struct Known {
    falloff: AnyFalloff,
    truth: oracle::Falloff,
    half_angle: f32,
    light: [i32; 3],
    axis: [f32; 3],
    eye: [i32; 3],
    surface: [i32; 3],
    body: f32,
    density: f32,
    intensity: f32,
    codes: f64,
}

/// The rays pass the light at a thousandth of a unit, from hundreds of units away, and graze a cone of 3 degrees.
#[test]
fn the_largest_errors_that_are_known_are_those_of_the_documentation() {
    let (hard, soft): (AnyFalloff, AnyFalloff) = (Hard.into(), Soft.into());
    for known in [
        Known {
            falloff: hard,
            truth: oracle::hard,
            half_angle: 3.000_416_8,
            light: [-1_482_942, -11_713, -622_971],
            axis: [-0.004_49, 0.999_915_6, 0.012_190_3],
            eye: [-3_606_289, 43_833_806, -1_509_716],
            surface: [-1_478_268, -108_188, -621_021],
            body: 0.001_026_762,
            density: 0.5,
            intensity: 0.005_322_573,
            codes: 4.3,
        },
        Known {
            falloff: soft,
            truth: oracle::soft,
            half_angle: 3.000_124_2,
            light: [392_776, -105_374, 1_211_060],
            axis: [0.270_905, 0.891_447, -0.363_225_5],
            eye: [20_055_370, 56_102_319, -23_007_216],
            surface: [9_914, -1_199_819, 1_682_624],
            body: 0.001_452_382_2,
            density: 0.071_568_9,
            intensity: 0.076_122,
            codes: 2.8,
        },
    ] {
        let lights = Lights::new(known.falloff, known.truth, known.half_angle);
        let [light, eye, surface] =
            [known.light, known.eye, known.surface].map(|bits| Vec3::from(bits.map(Length::from_bits)));
        let position = light.map(|c| c.to_f32());
        let spot = SpotLight::new(position, Vec3::from(known.axis), lights.cone).expect("a sound light");
        let haze = Haze::new(known.density).and_then(|haze| haze.with_source_radius(known.body));
        let (spot, haze) = (spot.with_intensity(known.intensity).expect("sound"), haze.expect("sound haze"));
        let way = exact(surface) - exact(eye);
        let ray = Ray { eye: exact(eye), direction: way.normalize(), length: way.length() };
        let compiled = spot.compile::<Fx16>().expect("a light of the format").in_haze(&haze);
        let found = f64::from(Fx16::light_to_f32(compiled.in_scattering(eye, surface)));
        let truth = lights.beam(&spot, &haze).in_scattering(&ray);
        assert_eq!((2550.0 * (found - truth).abs()).round() / 10.0, known.codes, "{found}, exact {truth}");
    }
}
