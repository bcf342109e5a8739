//! From which distance on an evaluation is good enough.

use serde::Serialize;

use crate::evaluation::Evaluation;
use crate::light::Light;
use crate::refusal::Refusal;
use crate::request::{Answer, Request};
use crate::scene::SceneAnswer;

/// An evaluation with fewer instructions than that of an answer, which is within the tolerance where surfaces are farther
/// away.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Farther {
    /// The evaluation.
    pub evaluation: Evaluation,
    /// Mean number of instructions of a lit point from there on.
    pub instructions: f64,
    /// The distance of the nearest surface from which on its bound is within the tolerance.
    pub from: f32,
}

impl Request {
    /// Returns the evaluations with fewer instructions than that of an answer that are within the tolerance if the nearest
    /// surface is farther away, the nearest distance first.
    ///
    /// # Errors
    /// A parameter of the light that is invalid.
    pub fn farther(&self, answer: &Answer) -> Result<Vec<Farther>, Refusal> {
        self.farther_within(answer, self.tolerance.amount())
    }

    /// Returns the same for each light of a scene, where a light may take what the sum of the others leaves.
    ///
    /// # Errors
    /// A parameter of a light that is invalid.
    pub fn farther_in_scene(&self, answer: &SceneAnswer) -> Result<Vec<Vec<Farther>>, Refusal> {
        let left = self.tolerance.amount() - answer.budget.total;
        let each = answer.lights.iter().map(|light| self.farther_within(light, light.bound.value + left));
        each.collect()
    }

    /// Returns the evaluations whose bound is at most a limit from a distance on.
    fn farther_within(&self, answer: &Answer, limit: f64) -> Result<Vec<Farther>, Refusal> {
        /// Twice as many parts as a picture needs: the distance is found to a 4,000th of the range.
        const STEPS: usize = 12;
        let (light, any) = (&answer.light, answer.light.any()?);
        let measure = |lit| self.tolerance.measure(self.display, lit);
        let mut found = Vec::new();
        for offer in self.offers(light)? {
            let evaluation = offer.evaluation;
            if offer.price.instructions >= answer.price.instructions || offer.bound() <= limit {
                continue;
            }
            let holds = |near: f32| {
                let bound = evaluation.bound(&any, [near, light.far], &measure);
                bound.is_ok_and(|bound| f64::from(bound.light) <= limit)
            };
            let [mut near, mut far] = [light.near, light.far];
            if !holds(far) {
                continue;
            }
            for _ in 0..STEPS {
                let middle = f32::midpoint(near, far);
                *(if holds(middle) { &mut far } else { &mut near }) = middle;
            }
            let beyond = Light { near: far, ..light.clone() };
            let priced = self.offers(&beyond)?.into_iter().find(|offer| offer.evaluation == evaluation);
            found.extend(priced.map(|offer| Farther {
                evaluation,
                instructions: offer.price.instructions,
                from: far,
            }));
        }
        // Of several the one that costs less from a nearer distance on is enough.
        found.sort_by(|a, b| a.from.total_cmp(&b.from).then(a.instructions.total_cmp(&b.instructions)));
        let mut kept: Vec<Farther> = Vec::new();
        for own in found {
            if kept.last().is_none_or(|last| own.instructions < last.instructions) {
                kept.push(own);
            }
        }
        Ok(kept)
    }
}
