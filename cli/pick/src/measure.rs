//! Functions for tests: random lights, the exact light of an answer, and longer searches for its
//! error.

use luminaire_oracle::SplitMix64;

use crate::light::{Attenuation, Edge, Light};
use crate::refusal::Refusal;
use crate::request::Answer;
use crate::search::Search;

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

/// Returns a random light of all that the fields of [`Light`] take, their ends with weight. Many are refused.
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

/// Returns the exact light of an answer.
pub fn truth(answer: &Answer) -> Result<luminaire_oracle::SpotLight, Refusal> {
    Ok(answer.light.truth(&answer.light.cone()?))
}

/// Returns the error of a light in the unit of the answer's tolerance.
pub fn error(answer: &Answer, found: f64, exact: f64) -> f64 {
    answer.tolerance.error(answer.display, found, exact)
}

/// Returns the largest error of an answer that another search finds.
///
/// This search uses `effort` times as many points, and the random numbers of `seed`.
pub fn found(answer: &Answer, seed: u64, effort: usize) -> Result<f64, Refusal> {
    let cone = answer.light.cone()?;
    let kernel = answer.evaluation.compile(&answer.light, &cone)?;
    let search = Search::new(&answer.light, &cone, seed, effort);
    Ok(search.largest(&*kernel, answer.tolerance, answer.display).0)
}
