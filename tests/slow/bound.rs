//! The derived bound of a light's error: random lights of every falloff and attenuation in their
//! whole domain, and from the worst of random points a climb by bits.
//!
//! `cargo test --test slow bound:: -- --nocapture --test-threads 1` prints the light that comes
//! nearest to its bound, and the middle of what was found; `LUMINAIRE_FULL=1` tries 7 times as
//! many lights.

use fastrand::Rng;
use luminaire::{
    Cone, DirectionalLight, Error, Fx16, Fx32, HalfAngle, Scalar, SpotLight, Vec3,
    attenuation::{AnyAttenuation, Attenuation},
    bound::ErrorBound,
    falloff::{AnyFalloff, Falloff, Formula},
    number::Quick,
};
use std::ops::RangeInclusive;
use support::{
    format::Format,
    oracle::{
        self, DVec3,
        climb::{self, Search, Worst},
        sweep::{SurfacePoint, Surfaces},
    },
    shapes::tables,
    sweep,
};

type Any = SpotLight<AnyFalloff, AnyAttenuation>;

/// An evaluation of a format: its light at a point with a normal, and its bound.
trait Evaluation {
    type Format: Format;
    type Compiled: Copy;
    const NAME: &'static str;

    fn bound(light: &Any, distances: RangeInclusive<f32>) -> Result<ErrorBound, Error>;
    fn compile(light: &Any) -> Self::Compiled;
    fn light(
        compiled: &Self::Compiled,
        point: Vec3<<Self::Format as Scalar>::Length>,
        normal: Vec3<Self::Format>,
    ) -> f64;
    /// The light at a surface that faces the light.
    fn facing(compiled: &Self::Compiled, point: Vec3<<Self::Format as Scalar>::Length>) -> f64;
}

struct Standard<S>(S);
struct Fast<S>(S);

impl<S: Format> Evaluation for Standard<S> {
    type Format = S;
    type Compiled = luminaire::light::CompiledSpotLight<S, AnyFalloff, AnyAttenuation>;
    const NAME: &'static str = S::NAME;

    fn bound(light: &Any, distances: RangeInclusive<f32>) -> Result<ErrorBound, Error> {
        light.error_bound::<S>(distances)
    }

    fn compile(light: &Any) -> Self::Compiled {
        light.compile().expect("it has a bound")
    }

    fn light(compiled: &Self::Compiled, point: Vec3<S::Length>, normal: Vec3<S>) -> f64 {
        S::exact_light(compiled.irradiance(point, normal))
    }

    fn facing(compiled: &Self::Compiled, point: Vec3<S::Length>) -> f64 {
        S::exact_light(compiled.irradiance_facing(point))
    }
}

impl<S: Format + Quick> Evaluation for Fast<S> {
    type Format = S;
    type Compiled = luminaire::light::QuickSpotLight<S, AnyFalloff, AnyAttenuation>;
    const NAME: &'static str = "fx16-quick";

    fn bound(light: &Any, distances: RangeInclusive<f32>) -> Result<ErrorBound, Error> {
        light.quick_error_bound::<S>(distances)
    }

    fn compile(light: &Any) -> Self::Compiled {
        light.compile_quick().expect("it has a bound")
    }

    fn light(compiled: &Self::Compiled, point: Vec3<S::Length>, normal: Vec3<S>) -> f64 {
        S::exact_light(compiled.irradiance(point, normal))
    }

    fn facing(compiled: &Self::Compiled, point: Vec3<S::Length>) -> f64 {
        S::exact_light(compiled.irradiance_facing(point))
    }
}

/// A light, its distances and its bound.
struct Beam<E: Evaluation> {
    light: Any,
    compiled: E::Compiled,
    position: DVec3,
    axis: DVec3,
    distances: [f32; 2],
    bound: ErrorBound,
    /// The angles at which the falloff jumps or has an infinite derivative.
    edges: Vec<f64>,
}

/// A cone with usual angles, or with any.
fn cone(rng: &mut Rng, falloff: AnyFalloff, is_usual: bool) -> Option<Cone<AnyFalloff>> {
    let outer = HalfAngle::degrees(90.0 * 1e-3_f32.powf(rng.f32() * rng.f32()));
    let part = |rng: &mut Rng| {
        let part = if is_usual || rng.bool() { rng.f32() } else { 1.0 - 1e-6_f32.powf(rng.f32()) };
        HalfAngle::degrees(outer.to_degrees() * part)
    };
    let cone = Cone::from_outer(falloff, outer).ok()?;
    let cone = if rng.u8(..3) == 0 { cone.with_inner(part(rng)).ok()? } else { cone };
    if rng.u8(..6) == 0 { cone.with_cutoff(part(rng)).ok() } else { Some(cone) }
}

/// The angle of a versine, in radians.
fn angle(versine: f64) -> f64 {
    oracle::half_degrees(versine).to_radians()
}

impl<E: Evaluation> Beam<E> {
    /// A light with usual numbers, or with any that the constructors take, the ends among them.
    fn random(rng: &mut Rng, tables: &[&'static [u16]]) -> Option<Self> {
        let is_usual = rng.bool();
        let falloff = if is_usual { AnyFalloff::drawn } else { AnyFalloff::anywhere };
        let falloff = match falloff(rng.usize(..), || rng.f32()).ok()? {
            AnyFalloff::Table(_) => {
                luminaire::falloff::Table::new(tables[rng.usize(..tables.len())]).ok()?.into()
            }
            falloff => falloff,
        };
        let cone = cone(rng, falloff, is_usual)?;
        let farthest = f64::from(<E::Format as Scalar>::FARTHEST).min(1e6);
        let reach = if rng.bool() { 8.0 } else { farthest * 1e-4_f64.powf(rng.f64()) };
        let position = DVec3::from_array([0; 3].map(|_| match rng.u8(..8) {
            0 if !is_usual => farthest.copysign(rng.f64() - 0.5),
            _ => reach * (2.0 * rng.f64() - 1.0),
        }));
        let attenuation = if is_usual { AnyAttenuation::drawn } else { AnyAttenuation::anywhere };
        let attenuation = attenuation(rng.usize(..), || rng.f32()).ok()?;
        let intensity = match rng.u8(..4) {
            0 => 1.0,
            1 if !is_usual => rng.choice([1e-9, 1e9])?,
            2 if !is_usual => 10.0_f32.powf(18.0 * rng.f32() - 9.0),
            _ => 10.0_f32.powf(7.0 * rng.f32() - 3.0),
        };
        let axis = sweep::single(sweep::direction(rng));
        let light = SpotLight::new(sweep::single(position), axis, cone).ok()?;
        let light = light.with_attenuation(attenuation).with_intensity(intensity).ok()?;
        let near = 10.0_f32.powf(5.0 * rng.f32() - 3.0);
        let distances = match attenuation.range() {
            Some(range) if !is_usual && range < 1e5 => [range * (0.5 + 0.5 * rng.f32()), 1.01 * range],
            _ => [near, near * 100.0_f32.powf(rng.f32())],
        };
        Self::between(light, distances, E::compile)
    }

    /// A light between these distances, and how it is compiled once it has a bound.
    fn between(light: Any, distances: [f32; 2], compile: impl Fn(&Any) -> E::Compiled) -> Option<Self> {
        let bound = E::bound(&light, distances[0]..=distances[1]).ok()?;
        let [inner, _, limit] = light.cone().versines().map(f64::from);
        let edges = match light.cone().falloff().formula() {
            Formula::InvertedPower(p, _) if p < 1.0 => vec![angle(inner), angle(limit)],
            _ => vec![angle(limit)],
        };
        let position = E::Format::exact_point(light.position().map(E::Format::length));
        let Vec3 { x, y, z } = light.given_axis();
        let axis = DVec3::new(x.into(), y.into(), z.into()).normalize();
        Some(Self { compiled: compile(&light), light, position, axis, distances, bound, edges })
    }

    fn surfaces(&self) -> Surfaces {
        let [_, _, limit] = self.light.cone().versines().map(f64::from);
        let distances = self.distances.map(f64::from);
        Surfaces { position: self.position, axis: self.axis, half_angle: angle(limit), distances }
    }

    /// The error of the clipped light at a point, in units of the bound.
    fn error(&self, at: SurfacePoint) -> f64 {
        let error = self.off(at);
        if error > 0.0 { error / f64::from(self.bound.light) } else { 0.0 }
    }

    /// The error of the clipped light at a point.
    fn off(&self, SurfacePoint { point, normal }: SurfacePoint) -> f64 {
        let (point, normal) = (E::Format::point(point), E::Format::normal(normal));
        let (way, exact_normal) =
            (E::Format::exact_point(point) - self.position, E::Format::exact_normal(normal));
        let distance = way.length();
        let [near, far] = self.distances.map(f64::from);
        let is_at_range = self
            .light
            .attenuation()
            .range()
            .is_some_and(|range| (distance - f64::from(range)).abs() < f64::from(self.bound.range));
        if !(near..=far).contains(&distance) || is_at_range {
            return 0.0;
        }
        let versine = oracle::versine_between(way, self.axis);
        let off = angle(versine);
        if self.edges.iter().any(|edge| (off - edge).abs() < f64::from(self.bound.edge)) {
            return 0.0;
        }
        let [inner, outer, limit] = self.light.cone().versines().map(f64::from);
        let formula = self.light.cone().falloff();
        let formula = formula.formula();
        let falloff = if versine >= limit {
            0.0
        } else if versine <= inner {
            formula.exact(1.0)
        } else {
            formula.exact((outer - versine) / (outer - inner))
        };
        let cosine = (-way.dot(exact_normal) / distance).clamp(0.0, 1.0);
        let gain = f64::from(self.light.intensity()) * self.light.attenuation().exact(distance);
        let error = |found: f64, cosine: f64| {
            oracle::counted((found.min(1.0) - (falloff * cosine * gain).min(1.0)).abs())
        };
        error(E::light(&self.compiled, point, normal), cosine)
            .max(error(E::facing(&self.compiled, point), 1.0))
    }
}

/// A random light, from these tables.
type Draw<E> = fn(&mut Rng, &[&'static [u16]]) -> Option<Beam<E>>;

/// No light exceeds its bound, the one that comes nearest reaches `least` of it, and half of them reach
/// `middle`.
fn assert_bound<E: Evaluation>(draw: Draw<E>, least: f64, middle: f64) {
    let full = std::env::var_os("LUMINAIRE_FULL").is_some();
    let (mut rng, tables) = (Rng::with_seed(2026), tables());
    let mut found = Vec::new();
    let count = if full { 1_500 } else { 200 };
    while found.len() < count {
        let Some(beam) = draw(&mut rng, &tables) else { continue };
        // A bound of more than full scale says nothing.
        if beam.bound.light >= 1.0 {
            continue;
        }
        let surfaces = beam.surfaces();
        let start = |rng: &mut Rng| {
            let stored = |normal| E::Format::exact_normal(E::Format::normal(normal));
            let input = surfaces.point(rng, stored);
            Worst { input, error: beam.error(input) }
        };
        let mut starts: Vec<_> = (0..2_000).map(|_| start(&mut rng)).collect();
        starts.sort_by(|a, b| b.error.total_cmp(&a.error));
        let climbs = starts.into_iter().take(6);
        let best =
            climbs.map(|start| climb::climb(&mut rng, start, 1_500, Surfaces::moved, |at| beam.error(at)));
        let best = best.max_by(|a, b| a.error.total_cmp(&b.error)).expect("six climbs");
        let place = || format!("{:?} {:?} {:?}: {:?}", beam.light, beam.distances, beam.bound, best.input);
        assert!(best.error <= 1.0, "{}: {:.3} of the bound for {}", E::NAME, best.error, place());
        found.push((best.error, place()));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let ((worst, place), half) = (found.last().expect("lights"), found[count / 2].0);
    println!(
        "{}: half of the lights reach {half:.3} of the bound, the largest {worst:.3} for {place}",
        E::NAME
    );
    assert!(*worst >= least && half >= middle, "{}: {worst:.3} and {half:.3} of the bound", E::NAME);
}

#[test]
fn f32_keeps_its_bound() {
    assert_bound::<Standard<f32>>(Beam::random, 0.3, 0.08);
}

#[test]
fn fx32_keeps_its_bound() {
    assert_bound::<Standard<Fx32>>(Beam::random, 0.6, 0.15);
}

#[test]
fn fx16_keeps_its_bound() {
    assert_bound::<Standard<Fx16>>(Beam::random, 0.9, 0.15);
}

#[test]
fn quick_fx16_keeps_its_bound() {
    assert_bound::<Fast<Fx16>>(Beam::random, 0.9, 0.25);
}

impl Beam<Fast<Fx16>> {
    /// A zoom from a light to another cone of its falloff. The bound is that of the cone between.
    fn zoomed(rng: &mut Rng, tables: &[&'static [u16]]) -> Option<Self> {
        let Self { light, compiled, distances, .. } = Self::random(rng, tables)?;
        let is_usual = rng.bool();
        let other = cone(rng, light.cone().falloff(), is_usual)?;
        // A cone whose cutoff is within its hotspot zooms as a step.
        let is_step = |[inner, _, limit]: [f32; 3]| limit <= inner;
        if is_step(light.cone().versines()) || is_step(other.versines()) {
            return None;
        }
        let to = light.with_cone(other).compile_quick::<Fx16>().ok()?;
        let part = match rng.u8(..4) {
            0 => rng.choice([1, 2, (1 << 14) - 2, (1 << 14) - 1])?,
            _ => rng.i16(0..=1 << 14),
        };
        let part = Fx16::from_bits(part);
        let between = light.with_cone(light.cone().zoomed(&other, part.to_f32()));
        Self::between(between, distances, |_| compiled.zoomed(&to, part))
    }
}

#[test]
fn a_zoomed_quick_light_keeps_the_bound_of_its_cone() {
    assert_bound(Beam::zoomed, 0.9, 0.2);
}

impl Beam<Standard<Fx16>> {
    /// The light at the distances at which the first points have the coarse evaluation.
    fn beyond_fine(self) -> Option<Self> {
        let is_fine = |distance: f64| {
            self.compiled.is_fine(sweep::single(self.position + distance * self.axis).map(Fx16::length))
        };
        let [mut fine, mut coarse] = [1e-3, 1e4];
        if !is_fine(fine) || is_fine(coarse) {
            return None;
        }
        while coarse > 1.001 * fine {
            let middle = (fine * coarse).sqrt();
            if is_fine(middle) { fine = middle } else { coarse = middle }
        }
        let distances = [fine as f32, 4.0 * fine as f32];
        let bound = self.light.error_bound::<Fx16>(distances[0]..=distances[1]).ok()?;
        (bound.light < 1.0).then_some(Self { distances, bound, ..self })
    }
}

/// The largest error of lights of any falloff and attenuation where they begin to have the coarse evaluation. What is
/// chosen by the gain alone is right to half a linear code for usual lights (`tests/suite/bright.rs`).
#[test]
fn fx16_errs_by_few_codes_beyond_its_fine_evaluation() {
    let full = std::env::var_os("LUMINAIRE_FULL").is_some();
    let (mut rng, tables) = (Rng::with_seed(5556), tables());
    let (mut left, mut worst, mut place) = (if full { 6_000 } else { 60 }, 0.0_f64, String::new());
    while left > 0 {
        let Some(beam) = Beam::random(&mut rng, &tables).and_then(Beam::beyond_fine) else { continue };
        let surfaces = beam.surfaces();
        let is_fine = |at: SurfacePoint| beam.compiled.is_fine(Fx16::point(at.point));
        let off = |at: SurfacePoint| if is_fine(at) { 0.0 } else { beam.off(at) };
        let search = Search { starts: 2_000, climbs: 6, steps: 2_500, seed: rng.u64(..) };
        let stored = |normal| Fx16::exact_normal(Fx16::normal(normal));
        let found = search.worst(|rng| surfaces.point(rng, stored), Surfaces::moved, off);
        if let Some(found) = found.filter(|found| found.error > worst) {
            (worst, place) = (found.error, format!("{:?} {:?}", beam.light, found.input));
        }
        left -= 1;
    }
    let codes = 255.0 * worst;
    println!("{codes:.3} linear codes at {place}");
    assert!((0.6..=1.7).contains(&codes), "{codes:.3} linear codes at {place}");
}

/// Directional lights of any direction and intensity, over random normals and climbs by bits.
fn assert_directional<S: Format>(least: f64) {
    let mut worst = 0.0_f64;
    let mut rng = Rng::with_seed(1969);
    for _ in 0..400 {
        let direction = sweep::single(sweep::direction(&mut rng));
        let intensity = if rng.bool() { 1.0 } else { 10.0_f32.powf(4.0 * rng.f32() - 3.0) };
        let light = DirectionalLight::new(direction).and_then(|light| light.with_intensity(intensity));
        let light = light.expect("a sound light");
        let (compiled, bound) = (light.compile::<S>(), f64::from(light.error_bound::<S>().light));
        let axis = f32::exact_direction(light.given_direction()).normalize();
        let error = |normal: Vec3<f32>| {
            let normal = S::normal(normal);
            let cosine = -axis.dot(S::exact_normal(normal));
            let exact = (f64::from(intensity) * cosine.clamp(0.0, 1.0)).min(1.0);
            oracle::counted((S::exact_light(compiled.irradiance(normal)).min(1.0) - exact).abs()) / bound
        };
        let search = Search { starts: 200, climbs: 4, steps: 500, seed: rng.u64(..) };
        let somewhere = |rng: &mut Rng| sweep::single(sweep::direction(rng));
        let moved = |rng: &mut Rng, normal: Vec3<f32>| {
            let size = climb::size(rng);
            let bent: [f32; 3] = climb::one_of(rng, normal, |c| c + size).into();
            sweep::single(DVec3::from_array(bent.map(f64::from)).normalize())
        };
        let found = search.worst(somewhere, moved, error).map_or(0.0, |worst| worst.error);
        assert!(found <= 1.0, "{}: {found:.3} of the bound for {light:?}", S::NAME);
        worst = worst.max(found);
    }
    println!("{}: directional lights reach {worst:.3} of their bound", S::NAME);
    assert!(worst >= least, "{}: {worst:.3}", S::NAME);
}

#[test]
fn directional_lights_keep_their_bound() {
    assert_directional::<f32>(0.3);
    assert_directional::<Fx32>(0.4);
    assert_directional::<Fx16>(0.4);
}
