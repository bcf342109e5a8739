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
    /// The evaluation of fewer instructions that comes nearest to the tolerance, without keeping it.
    pub cheaper: Option<Cheaper>,
    /// Rust source of the constant `LIGHT`, the compiled light.
    pub code: String,
}

/// An evaluation that costs less than that of an answer.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Cheaper {
    /// The evaluation.
    pub evaluation: Evaluation,
    /// Mean number of instructions of a lit point.
    pub instructions: f64,
    /// The bound of the error, in the unit of the tolerance.
    pub bound: f64,
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
        let offers = self.offers(light)?;
        if let Some(number) = offers.iter().position(|offer| offer.bound <= amount) {
            let cheaper = offers[..number].iter().min_by(|a, b| a.bound.total_cmp(&b.bound));
            let cheaper = cheaper.map(|&Offer { evaluation, price: Price { instructions, .. }, bound }| {
                Cheaper { evaluation, instructions, bound }
            });
            return Ok(Answer { cheaper, ..self.answer(&offers[number], light)? });
        }
        let Some(nearest) = offers.iter().min_by(|a, b| a.bound.total_cmp(&b.bound)) else {
            return Err(none_holds(light));
        };
        Err(Refusal::parameter(
            "tolerance",
            self.tolerance.to_string(),
            format!(
                "at least {} {}, the bound of {}",
                rounded_up(nearest.bound),
                self.tolerance.unit(self.display),
                nearest.evaluation
            ),
        ))
    }

    /// Returns an offer for every evaluation that can hold the light, the cheapest first.
    pub(crate) fn offers(&self, light: &Light) -> Result<Vec<Offer>, Refusal> {
        light.check()?;
        let cone = light.cone()?;
        let search = Search::new(light, &cone, SEED, 1);
        let farthest = light.position.iter().fold(light.far, |most, c| most.max(c.abs() + light.far));
        let measure = |lit| self.tolerance.measure(self.display, lit);
        let (mut offers, mut refused) = (Vec::new(), None);
        for &evaluation in Evaluation::ALL {
            match evaluation.compile(light, &cone) {
                Ok(_) if farthest > evaluation.farthest() => {}
                Ok(kernel) => {
                    let share = search.fine_share(&*kernel);
                    let price = Price::of(self.chip, light, &cone, evaluation, share);
                    offers.push(Offer {
                        evaluation,
                        price,
                        bound: evaluation.bound(light, &cone, &measure)?,
                    });
                }
                Err(error) => refused = Some(error),
            }
        }
        offers.sort_by(|a, b| a.price.instructions.total_cmp(&b.price.instructions));
        match refused {
            Some(error) if offers.is_empty() => Err(error.into()),
            _ => Ok(offers),
        }
    }

    /// Returns the answer of an offer, with the largest error that a search finds.
    pub(crate) fn answer(&self, offer: &Offer, light: &Light) -> Result<Answer, Refusal> {
        let &Offer { evaluation, price, bound } = offer;
        let cone = light.cone()?;
        let kernel = evaluation.compile(light, &cone)?;
        let (found, at) = Search::new(light, &cone, SEED, 1).largest(&*kernel, self.tolerance, self.display);
        Ok(Answer {
            light: light.clone(),
            outer: cone.outer(),
            chip: self.chip,
            display: self.display,
            tolerance: self.tolerance,
            evaluation,
            price,
            bound: Bound { value: bound, found, label: "derived", at },
            cheaper: None,
            code: code(light, &cone, evaluation, &kernel.source()),
        })
    }
}

/// The seed of the searches of answers.
const SEED: u64 = 1983;

/// An evaluation that can hold a light, before its error is searched.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Offer {
    pub(crate) evaluation: Evaluation,
    pub(crate) price: Price,
    /// The bound of the error, in the unit of the tolerance.
    pub(crate) bound: f64,
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
