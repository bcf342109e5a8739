//! A request and its answer.

use serde::Serialize;

use crate::evaluation::Evaluation;
use crate::light::{Light, Shaped};
use crate::price::Price;
use crate::refusal::Refusal;
use crate::search::{Bound, Search};
use crate::target::{Chip, Display, Tolerance};

/// A request: the chip, the display and the tolerance. The default tolerance is one step of the
/// display.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Request {
    pub(crate) chip: Chip,
    pub(crate) display: Display,
    pub(crate) tolerance: Tolerance,
}

/// The cheapest evaluation of a light whose error is within the tolerance.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Answer {
    /// The light.
    pub light: Light,
    /// The full angle in degrees at which the light ends.
    pub outer: f32,
    /// The chip.
    pub chip: Chip,
    /// The display.
    pub display: Display,
    /// The tolerance.
    pub tolerance: Tolerance,
    /// The evaluation.
    pub evaluation: Evaluation,
    /// The cost of a lit point.
    #[serde(flatten)]
    pub price: Price,
    /// The bound of the error, in the unit of the tolerance.
    pub bound: Bound,
    /// Rust source of the constant `LIGHT`, the compiled light.
    pub code: String,
}

impl Request {
    /// Requests an evaluation for a chip and a display.
    pub fn new(chip: Chip, display: Display) -> Self {
        Self { chip, display, tolerance: Tolerance::Steps(1.0) }
    }

    /// Returns the request with a tolerance in steps of the display.
    #[must_use]
    pub fn steps(self, steps: f64) -> Self {
        self.tolerance(Tolerance::Steps(steps))
    }

    /// Returns the request with a tolerance in linear codes.
    #[must_use]
    pub fn codes(self, codes: f64) -> Self {
        self.tolerance(Tolerance::Codes(codes))
    }

    /// Returns the request with a tolerance.
    #[must_use]
    pub fn tolerance(self, tolerance: Tolerance) -> Self {
        Self { tolerance, ..self }
    }

    /// Returns the cheapest evaluation of the light whose error is within the tolerance.
    ///
    /// # Errors
    /// A parameter of the light that is invalid. A tolerance that no evaluation keeps: the refusal
    /// names the smallest bound and its evaluation.
    pub fn pick(&self, light: &Light) -> Result<Answer, Refusal> {
        let amount = self.tolerance.amount();
        if !(amount > 0.0 && amount.is_finite()) {
            return Err(Refusal::parameter("tolerance", amount.to_string(), "more than 0".to_owned()));
        }
        let offers = self.offers(light, amount)?;
        if let Some(offer) = offers.into_iter().find(|offer| offer.bound.value <= amount) {
            return Ok(offer);
        }
        let offers = self.offers(light, f64::INFINITY)?;
        let Some(nearest) = offers.iter().min_by(|a, b| a.bound.value.total_cmp(&b.bound.value)) else {
            return Err(none_holds(light));
        };
        Err(Refusal::parameter(
            "tolerance",
            self.tolerance.to_string(),
            format!(
                "at least {} {}, the bound of {}",
                rounded_up(nearest.bound.value),
                self.tolerance.unit(self.display),
                nearest.evaluation
            ),
        ))
    }

    /// Returns an offer for every evaluation that can hold the light, the cheapest first.
    ///
    /// If `enough` is finite, the list ends at the first offer whose bound is at most `enough`. The
    /// bounds of the offers before are not fully searched; they are only known to exceed `enough`.
    pub(crate) fn offers(&self, light: &Light, enough: f64) -> Result<Vec<Answer>, Refusal> {
        light.check()?;
        let cone = light.cone()?;
        let search = Search::new(light, &cone, 1983, 1);
        let farthest = light.position.iter().fold(light.far, |most, c| most.max(c.abs() + light.far));
        let mut offers = Vec::new();
        let mut refused = None;
        for &evaluation in Evaluation::ALL {
            match evaluation.compile(light, &cone, light.axis) {
                Ok(_) if farthest > evaluation.farthest() => {}
                Ok(kernel) => {
                    let share = search.fine_share(&*kernel);
                    let price = Price::of(self.chip, light, &cone, evaluation, share);
                    offers.push((price, evaluation, kernel));
                }
                Err(error) => refused = Some(error),
            }
        }
        offers.sort_by(|(a, ..), (b, ..)| a.instructions.total_cmp(&b.instructions));
        let mut answers: Vec<Answer> = Vec::new();
        for (price, evaluation, kernel) in offers {
            let Ok(bound) = search.bound(evaluation, self.tolerance, self.display, enough) else { continue };
            let code = code(light, &cone, evaluation, &kernel.source());
            answers.push(Answer {
                light: light.clone(),
                outer: cone.outer(),
                chip: self.chip,
                display: self.display,
                tolerance: self.tolerance,
                evaluation,
                price,
                bound,
                code,
            });
            if enough.is_finite() && bound.value <= enough {
                break;
            }
        }
        match refused {
            Some(error) if answers.is_empty() => Err(error.into()),
            _ => Ok(answers),
        }
    }
}

/// Returns the refusal of a light whose coordinates no evaluation can hold.
fn none_holds(light: &Light) -> Refusal {
    let farthest = Evaluation::ALL.iter().map(|evaluation| evaluation.farthest()).fold(0.0, f32::max);
    Refusal::parameter("far", light.far.to_string(), format!("coordinates of at most {farthest}"))
}

fn code(light: &Light, cone: &Shaped, evaluation: Evaluation, source: &str) -> String {
    format!(
        "/// `{}`, evaluated by {evaluation}.\npub const LIGHT: {} = {};\n",
        light.name,
        evaluation.type_of(light, cone),
        source.trim_end()
    )
}

/// Returns a positive number with three digits, rounded up so that a tolerance of this number is
/// accepted.
pub(crate) fn rounded_up(value: f64) -> String {
    let decimals = (2.0 - value.log10().floor()).clamp(0.0, 30.0);
    let unit = 10_f64.powf(-decimals);
    format!("{:.*}", decimals as usize, (value / unit + 1e-6).ceil() * unit)
}
