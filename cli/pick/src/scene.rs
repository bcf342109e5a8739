//! Several lights that share a tolerance.

use serde::Serialize;

use crate::evaluation::Evaluation;
use crate::light::Light;
use crate::refusal::Refusal;
use crate::request::{Answer, Offer, Request, remedy, rounded_up};
use crate::target::Tolerance;

/// The lights of a scene. Any of these lights may light the same point.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Scene {
    /// The lights.
    pub lights: Vec<Light>,
}

/// How the errors of a picture add up, in the unit of the tolerance.
///
/// The sum of the bounds of the lights is proved to be a bound for the picture, if each bound holds
/// for its light. The encoding `g(x) = srgb(min(x, 1))` is concave and increasing. So
/// `g(a + b + e + f) - g(a + b)`, for lights `a` and `b` with errors `e` and `f`, is at most
/// `|g(a + e) - g(a)| + |g(b + f) - g(b)|`: an error changes a brighter picture less. A colour or a
/// reflectance `c <= 1` scales a light and its error by the same factor. This scaling increases the
/// error in steps by at most 1.8 %, because `x g'(x)` is increasing except for a decrease of 1.7 %
/// where the two pieces of sRGB meet. The last two sentences hold for light within full scale:
/// brighter light counts as clipped before the multiplication by its colour.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Budget {
    /// The sum of the bounds of the lights.
    pub lights: f64,
    /// The error that colours and materials add. This error is `lights` times the factor of colours
    /// and materials, less 1. In the formats of 16 bits, the rounding errors of the two products
    /// are added, as encoded where sRGB is steepest.
    pub materials: f64,
    /// The sum of `lights` and `materials`: at most the tolerance.
    pub total: f64,
    /// The error of the rounding to the display's steps, in steps. This error is not part of the
    /// total.
    pub display_rounding: f64,
}

/// The evaluations of the lights of a scene with the least sum of instructions.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct SceneAnswer {
    /// The lights in the order of the scene.
    pub lights: Vec<Answer>,
    /// How the errors of the lights add up.
    pub budget: Budget,
    /// Instructions for a point that all lights reach; those of the worst cases if the request is for them.
    pub instructions: f64,
    /// Instructions for a point that all lights reach, with `Fx16` for all lights; `None` if `Fx16`
    /// cannot hold all lights.
    pub instructions_fx16: Option<f64>,
}

/// Relative increase of an error in steps that a colour may cause.
const COLORS: f64 = 0.018;

impl Request {
    /// Returns the cheapest evaluations of a scene's lights that keep the picture's error within
    /// the tolerance.
    ///
    /// The search for the least sum of instructions is exact.
    ///
    /// # Errors
    /// The same errors as [`pick`](Self::pick). A tolerance that no combination of evaluations
    /// keeps: the refusal names the smallest sum of the bounds.
    pub fn pick_scene(&self, scene: &Scene) -> Result<SceneAnswer, Refusal> {
        let tolerance = self.tolerance.amount();
        let offers: Result<Vec<_>, _> = scene.lights.iter().map(|light| self.offers(light)).collect();
        let offers = offers?;
        // The Pareto-optimal choices for the lights so far: no other choice has both a smaller
        // error and fewer instructions.
        let mut best = vec![Choice { error: 0.0, instructions: 0.0, offers: Vec::new() }];
        for offers in &offers {
            let mut longer: Vec<_> = best
                .iter()
                .flat_map(|choice| offers.iter().enumerate().map(|offer| self.with(choice, offer)))
                .collect();
            longer.sort_by(|a, b| {
                (a.error, a.instructions).partial_cmp(&(b.error, b.instructions)).expect("numbers")
            });
            best.clear();
            for choice in longer {
                if best.last().is_none_or(|last| choice.instructions < last.instructions) {
                    best.push(choice);
                }
            }
        }
        // The choices are sorted by ascending error and descending instructions.
        let Some(choice) = best.iter().rev().find(|choice| choice.error <= tolerance) else {
            let least = best.first().map_or(f64::INFINITY, |choice| choice.error);
            return Err(Refusal::parameter(
                "tolerance",
                self.tolerance.to_string(),
                format!(
                    "at least {} {} for these lights{}",
                    rounded_up(least),
                    self.tolerance.unit(self.display),
                    remedy(&scene.lights)?
                ),
            ));
        };
        let fx16 = offers.iter().map(|offers| {
            let fx16 = offers.iter().find(|offer| offer.evaluation == Evaluation::Fx16);
            fx16.map(|offer| offer.instructions)
        });
        // Without lights a sum is -0.
        let instructions_fx16 = fx16.sum::<Option<f64>>().map(|sum| 0.0 + sum);
        let instructions = choice.instructions;
        let chosen = scene.lights.iter().zip(&offers).zip(&choice.offers);
        let lights: Result<Vec<_>, _> =
            chosen.map(|((light, offers), &number)| self.answer(&offers[number], light)).collect();
        let lights = lights?;
        let sum = 0.0 + lights.iter().map(|answer| answer.bound.value).sum::<f64>();
        let budget =
            Budget { lights: sum, materials: choice.error - sum, total: choice.error, display_rounding: 0.5 };
        Ok(SceneAnswer { lights, budget, instructions, instructions_fx16 })
    }

    fn with(&self, choice: &Choice, (number, offer): (usize, &Offer)) -> Choice {
        let mut offers = choice.offers.clone();
        offers.push(number);
        Choice {
            error: choice.error + self.with_material(offer),
            instructions: choice.instructions + offer.instructions,
            offers,
        }
    }

    /// Returns the bound of the error of a light, after its colour and a material.
    fn with_material(&self, offer: &Offer) -> f64 {
        let is_16 = matches!(offer.evaluation, Evaluation::Fx16 | Evaluation::Fx16Quick);
        // Two products, each with a rounding error of at most a step of 2^-14.
        let rounding = if is_16 { 2.0 / 16_384.0 } else { 0.0 };
        offer.bound()
            + match self.tolerance {
                Tolerance::Steps(_) => COLORS * offer.bound() + rounding * self.display.slope(),
                Tolerance::Codes(_) => rounding * 255.0,
            }
    }
}

struct Choice {
    error: f64,
    instructions: f64,
    /// The index of the chosen offer of each light.
    offers: Vec<usize>,
}
