//! Functions for tests: random lights, the exact light of an answer, and longer searches for its
//! error.

use luminaire_oracle::SplitMix64;

use crate::evaluation::Evaluation;
use crate::light::{Attenuation, Edge, Light};
use crate::refusal::Refusal;
use crate::request::Answer;
use crate::search::Search;
use crate::target::{Display, Tolerance};

/// Returns a random light, with a cone from 1 to 140 degrees and distances from 0.1 to 100.
pub fn random_light(random: &mut SplitMix64) -> Light {
    let one_of = |random: &mut SplitMix64, count| random.below(count) == 0;
    let ratio = |random: &mut SplitMix64, least: f64, most: f64| {
        (least * (most / least).powf(random.between(0.0, 1.0))) as f32
    };
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

/// Returns the exact light of an answer.
pub fn truth(answer: &Answer) -> Result<luminaire_oracle::SpotLight, Refusal> {
    Ok(answer.light.truth(&answer.light.cone()?, answer.light.axis))
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
    let search = Search::new(&answer.light, &cone, seed, effort);
    Ok(search.bound(answer.evaluation, answer.tolerance, answer.display, f64::INFINITY)?.found)
}

/// Returns the largest ratio of the error found by a longer search to that found by an answer's
/// search.
///
/// The longer search has 30 times as many points. The maximum is over all evaluations of `count`
/// random lights. `visit` is called with every ratio.
pub fn margins(count: u64, mut visit: impl FnMut(f64, &Light, Evaluation)) -> f64 {
    let mut most: f64 = 0.0;
    for number in 0..count {
        let light = random_light(&mut SplitMix64(number));
        let Ok(cone) = light.cone() else { continue };
        let [short, long] =
            [(1983, 1), (number + 1, 30)].map(|(seed, effort)| Search::new(&light, &cone, seed, effort));
        for &evaluation in Evaluation::ALL {
            let bound = |search: &Search<'_>| {
                search.bound(evaluation, Tolerance::Steps(1.0), Display::Rgb565, f64::INFINITY)
            };
            let (Ok(short), Ok(long)) = (bound(&short), bound(&long)) else { continue };
            let ratio = long.found / short.found;
            visit(ratio, &light, evaluation);
            most = most.max(ratio);
        }
    }
    most
}
