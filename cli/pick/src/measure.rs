//! Functions for tests: random lights, and longer searches for the error of an answer.

use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Table};
use luminaire::light::{Distribution, Symmetry};
use luminaire::{Cone, DirectionalLight, HalfAngle, MeasuredLight, PointLight, SpotLight};
use luminaire_oracle::SplitMix64;

use crate::light::{Attenuation, Edge, Light};
use crate::refusal::Refusal;
use crate::request::{Answer, Request, largest};

/// Returns a random light, with a cone from 1 to 140 degrees and distances from 0.1 to 100.
pub fn random_light(random: &mut SplitMix64) -> Light {
    let one_of = |random: &mut SplitMix64, count| random.below(count) == 0;
    let field = ratio(random, 1.0, 140.0);
    let near = ratio(random, 0.1, 20.0);
    let is_fitted = one_of(random, 3);
    let attenuation = if one_of(random, 3) { Attenuation::None } else { Attenuation::InverseSquare };
    let brightness = ratio(random, 0.1, 16.0);
    let is_even = attenuation == Attenuation::None;
    let [axis, position] = [1.0, 10.0].map(|most| random.vector(-most, most).as_vec3().to_array());
    Light {
        axis,
        position,
        edge: if one_of(random, 2) { Edge::Soft } else { Edge::Hard },
        beam: is_fitted.then(|| field / ratio(random, 1.17, 2.0)),
        field: Some(field),
        inner: one_of(random, 4).then(|| field * random.between(0.1, 0.5) as f32),
        attenuation,
        intensity: if is_even { brightness.min(1.0) } else { brightness * near * near },
        near,
        far: near * ratio(random, 1.0, 10.0),
        ..Light::default()
    }
}

/// Returns a random light of any kind with any models, as [`Light::light`] takes it, by the ends of what is accepted or
/// by usual numbers; `None` if the numbers make none.
pub fn any_light_anywhere(random: &mut SplitMix64) -> Option<Light> {
    let is_usual = random.below(2) == 0;
    let near = if is_usual { ratio(random, 0.1, 20.0) } else { anywhere(random, 16.0 / 65_536.0, 32_767.0) };
    let far =
        if is_usual { near * ratio(random, 1.0, 10.0) } else { anywhere(random, near.into(), 65_535.0) };
    let reach = if is_usual { 10.0 } else { anywhere(random, 1e-4, 32_767.0) };
    let [axis, position] =
        [1.0, f64::from(reach)].map(|most| random.vector(-most, most).as_vec3().to_array());
    let intensity = if is_usual { ratio(random, 0.1, 100.0) } else { anywhere(random, 1e-9, 1e9) };
    let index = random.below(1 << 32) as usize;
    let law = if is_usual { AnyAttenuation::drawn } else { AnyAttenuation::anywhere };
    let attenuation = law(index, || random.between(0.0, 1.0) as f32).ok()?;
    // An end between the distances: a range that ends the light, or its jump.
    let [near, far] = match attenuation.range() {
        Some(range) if random.below(2) == 0 && (0.001..32_000.0).contains(&range) => {
            [range / 2.0, 1.01 * range]
        }
        _ => [near, far],
    };
    let light: AnyLight = match random.below(8) {
        0 => DirectionalLight::new(axis).ok()?.into(),
        1 => PointLight::new(position).ok()?.with_attenuation(attenuation).into(),
        2 => measured_anywhere(random, position, axis, is_usual)?.with_attenuation(attenuation).into(),
        _ => SpotLight::new(position, axis, cone_anywhere(random, is_usual)?)
            .ok()?
            .with_attenuation(attenuation)
            .into(),
    };
    let light = light.with_intensity(intensity).ok()?;
    Some(Light { near, far, ..Light::of("light", &light) })
}

/// Returns a measured light of any symmetry, of random samples; of usual numbers, of samples that differ by a quarter.
/// The samples stay in memory: a light of a test borrows them.
fn measured_anywhere(
    random: &mut SplitMix64,
    position: [f32; 3],
    axis: [f32; 3],
    is_usual: bool,
) -> Option<MeasuredLight<'static>> {
    let size = (2 << random.below(8)) + 1;
    let symmetry = [Symmetry::None, Symmetry::Bilateral, Symmetry::Quadrant][random.below(3) as usize];
    let least = if is_usual { 0.75 } else { 0.0 };
    let mut any = |_| (65_535.0 * random.between(least, 1.0)) as u16;
    let drawn: Vec<u16> = (0..size * size).map(&mut any).collect();
    let last = size - 1;
    let [columns, rows] = Distribution::from_parts(&[], size, symmetry).shape().map(|count| count as u32);
    let sample = |column: u32, row: u32| {
        // Both places of a direction on the edge of the square have one sample.
        let is_edge = [0, last].iter().any(|end| column == *end || row == *end);
        let place = |at: u32| if is_edge { at.max(last - at) } else { at };
        drawn[(place(row) * size + place(column)) as usize]
    };
    let [columns, rows] = [columns, rows].map(|count| size - count..size);
    let samples: Vec<u16> =
        rows.flat_map(|row| columns.clone().map(move |column| sample(column, row))).collect();
    let distribution = Distribution::new(samples.leak(), size, symmetry).expect("a sound table");
    let side = random.vector(-1.0, 1.0).as_vec3().to_array();
    MeasuredLight::new(position, axis, side, distribution).ok()
}

/// Returns a random cone of any falloff, often with a hotspot or a cutoff.
fn cone_anywhere(random: &mut SplitMix64, is_usual: bool) -> Option<Cone<AnyFalloff>> {
    /// Tables as photometric files have them: one with a dark ring, and one of few samples.
    const TABLES: [&[u16]; 2] = [&[65_535, 65_535, 40_000, 3_000, 9_000, 700, 0], &[65_535, 32_768, 0]];
    let index = random.below(1 << 32) as usize;
    let falloff = if is_usual { AnyFalloff::drawn } else { AnyFalloff::anywhere };
    let mut falloff = falloff(index, || random.between(0.0, 1.0) as f32).ok()?;
    if let AnyFalloff::Table(_) = falloff {
        falloff = Table::new(TABLES[random.below(2) as usize]).ok()?.into();
    }
    let outer = if is_usual { ratio(random, 1.0, 80.0) } else { anywhere(random, 1e-4, 90.0) };
    let part = |random: &mut SplitMix64| HalfAngle::degrees(outer * random.between(0.0, 1.0) as f32);
    let mut cone = Cone::from_outer(falloff, HalfAngle::degrees(outer)).ok()?;
    if random.below(4) == 0 {
        cone = cone.with_inner(part(random)).ok()?;
    }
    if random.below(6) == 0 {
        cone = cone.with_cutoff(part(random)).ok()?;
    }
    Some(cone)
}

/// Returns a random light of all that the other fields of [`Light`] take, their ends with weight. Many are refused.
pub fn light_anywhere(random: &mut SplitMix64) -> Light {
    let one_of = |random: &mut SplitMix64, count| random.below(count) == 0;
    let one = |random: &mut SplitMix64| random.between(0.0, 1.0) as f32;
    let [axis, position] = [[1e-15, 1e15], [1e-4, 32_767.0]].map(|[least, most]| {
        let length = anywhere(random, least, most);
        random.vector(-1.0, 1.0).as_vec3().to_array().map(|c| length * c)
    });
    let angle = anywhere(random, 1e-4, 180.0);
    let [beam, field, outer] = match random.below(4) {
        0 => [Some(angle), None, None],
        1 => [None, Some(angle), None],
        2 => [None, None, Some(angle)],
        _ => [Some(angle), Some(angle * (1.0 + 1.5 * one(random))), None],
    };
    let near = anywhere(random, 16.0 / 65_536.0, 32_767.0);
    Light {
        axis,
        position,
        edge: if one_of(random, 2) { Edge::Soft } else { Edge::Hard },
        slopes: one_of(random, 3).then(|| [4.0 * one(random), 4.0 * one(random)]),
        beam,
        field,
        outer,
        inner: one_of(random, 4).then(|| angle * one(random)),
        attenuation: if one_of(random, 3) { Attenuation::None } else { Attenuation::InverseSquare },
        intensity: if one_of(random, 16) { 0.0 } else { anywhere(random, 1e-9, 1e9) },
        near,
        far: anywhere(random, near.into(), 65_535.0),
        ..Light::default()
    }
}

/// Returns a [`ratio`] between two ends, which have weight.
fn anywhere(random: &mut SplitMix64, least: f64, most: f64) -> f32 {
    match random.below(8) {
        0 => least as f32,
        1 => most as f32,
        _ => ratio(random, least, most),
    }
}

/// Returns a number whose logarithm is even between two ends.
fn ratio(random: &mut SplitMix64, least: f64, most: f64) -> f32 {
    (least * (most / least).powf(random.between(0.0, 1.0))) as f32
}

/// Returns the largest error of an answer that another search finds.
///
/// This search uses `effort` times as many points, and the random numbers of `seed`.
pub fn found(answer: &Answer, seed: u64, effort: usize) -> Result<f64, Refusal> {
    let request = Request::new(answer.chip, answer.display).tolerance(answer.tolerance);
    let offers = request.offers(&answer.light)?;
    let offer = offers.iter().find(|offer| offer.evaluation == answer.evaluation);
    let offer = offer.expect("the evaluation of the answer");
    Ok(largest(&request, offer, &answer.light, seed, effort)?.0)
}
