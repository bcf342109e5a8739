//! The stated bound of the quick evaluation: random cones, lights and points, and from the worst of
//! them a climb by bits.
//!
//! `cargo test --test slow quick:: -- --nocapture` prints the worst that was found.

use fastrand::Rng;
use luminaire::{
    Cone, Fx16, HalfAngle, SpotLight, Vec3,
    attenuation::{InverseSquare, NoAttenuation},
    falloff::{AnyFalloff, Falloff},
    light::QuickSpotLight,
    number::Quick,
};
use support::{
    format::Format,
    oracle::{
        self, DVec3,
        climb::{self, Worst},
    },
    shapes::{self, tables},
    sweep,
};

/// A light at the origin that is evaluated quickly, with its inner and outer versine and its stated
/// bound.
#[derive(Clone, Copy)]
struct Beam<S: Format + Quick> {
    shape: AnyFalloff,
    level: QuickSpotLight<S, AnyFalloff, NoAttenuation>,
    falling: QuickSpotLight<S, AnyFalloff, InverseSquare>,
    axis: DVec3,
    versines: [f64; 2],
    half: f64,
    bound: f64,
}

/// Intensity of the light that falls with the distance: at most full scale from a distance of 2 on.
const INTENSITY: f32 = 4.0;

impl<S: Format + Quick> Beam<S> {
    /// A random cone of 0.5 to 90 degrees, about one in three with a hotspot.
    fn random(rng: &mut Rng, tables: &[&'static [u16]]) -> Option<Self> {
        let shape = shapes::random(rng, tables);
        if shape.formula().exact(f64::MIN_POSITIVE) > 1e-9 {
            return None;
        }
        let half = 0.5 * 180.0_f32.powf(rng.f32());
        let inner = if rng.u8(..3) == 0 { half * rng.f32() } else { 0.0 };
        let cone = Cone::from_outer(shape, HalfAngle::degrees(half)).ok()?;
        let cone = cone.with_inner(HalfAngle::degrees(inner)).ok()?;
        let axis = sweep::single(sweep::direction(rng));
        let light = SpotLight::new(Vec3::default(), axis, cone).ok()?;
        Some(Self {
            shape,
            level: light.with_attenuation(NoAttenuation).compile_quick().ok()?,
            falling: light.with_intensity(INTENSITY).ok()?.compile_quick().ok()?,
            axis: S::exact_direction(light.axis_in::<S>()).normalize(),
            versines: [inner, half].map(|angle| oracle::versine(angle.into())),
            half: half.into(),
            bound: light.quick_error::<S>().into(),
        })
    }

    /// A point in the cone or just outside it, at a distance from 1/100 to 10,000, and a normal.
    fn site(&self, rng: &mut Rng) -> [Vec3<f32>; 2] {
        let off_axis = (1.02 * self.half * rng.f64().sqrt()).to_radians();
        let way = sweep::direction_off(rng, self.axis, off_axis);
        let distance = 0.01 * 1e6_f64.powf(rng.f64());
        let incidence = if rng.bool() { 0.0 } else { 1.5 * rng.f64() };
        let normal = sweep::direction_off(rng, -way, incidence);
        [sweep::single(distance * way), sweep::single(normal)]
    }

    /// The larger error of the two lights at a point, in units of the bound.
    fn error(&self, [point, normal]: [Vec3<f32>; 2]) -> f64 {
        let (point, normal) = (point.map(S::length), normal.map(S::from_f32));
        let (way, exact_normal) = (S::exact_point(point), S::exact_normal(normal));
        let distance = way.length();
        if distance < 1e-3 {
            return 0.0;
        }
        let versine = oracle::versine_between(way, self.axis);
        let [inner, outer] = self.versines;
        let t = ((outer - versine) / (outer - inner)).clamp(0.0, 1.0);
        let falloff = if t > 0.0 { self.shape.formula().exact(t) } else { 0.0 };
        let share = falloff * (-way.dot(exact_normal) / distance).max(0.0);
        let level = (S::exact_light(self.level.irradiance(point, normal)) - share).abs();
        let attenuated = f64::from(INTENSITY) / (distance * distance);
        let falling = S::exact_light(self.falling.irradiance(point, normal)) - share * attenuated;
        let falling = if attenuated <= 1.0 { falling.abs() } else { 0.0 };
        oracle::counted(level).max(oracle::counted(falling)) / self.bound
    }
}

fn assert_bound<S: Format + Quick>() {
    let full = std::env::var_os("LUMINAIRE_FULL").is_some();
    let (mut rng, tables) = (Rng::with_seed(1975), tables());
    let (mut worst, mut place) = (0.0, String::new());
    let mut left = if full { 20_000 } else { 600 };
    while left > 0 {
        let Some(beam) = Beam::<S>::random(&mut rng, &tables) else { continue };
        left -= 1;
        let start = |rng: &mut Rng| {
            let input = beam.site(rng);
            Worst { input, error: beam.error(input) }
        };
        let starts: Vec<_> = (0..64).map(|_| start(&mut rng)).collect();
        let best = starts.into_iter().max_by(|a, b| a.error.total_cmp(&b.error)).expect("64 starts");
        let moved = |rng: &mut Rng, [point, normal]: [Vec3<f32>; 2]| {
            let size = climb::size(rng);
            if rng.u8(..4) == 0 {
                [point, climb::one_of(rng, normal, |c| c + size).unit()]
            } else {
                [climb::one_of(rng, point, |c| c * (1.0 + size)), normal]
            }
        };
        let best = climb::climb(&mut rng, best, 600, moved, |site| beam.error(site));
        if best.error > worst {
            worst = best.error;
            place = format!("{:?} of {} degrees, {:?}", beam.shape, beam.half, best.input);
        }
    }
    println!("{}: {worst:.3} of the bound for {place}", S::NAME);
    assert!((0.5..=1.0).contains(&worst), "{}: {worst:.3} of the bound for {place}", S::NAME);
}

#[test]
fn f32_keeps_its_bound() {
    assert_bound::<f32>();
}

#[test]
fn fx16_keeps_its_bound() {
    assert_bound::<Fx16>();
}
