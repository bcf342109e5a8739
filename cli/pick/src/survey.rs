//! All evaluations of a light, on every chip.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::evaluation::Evaluation;
use crate::light::Light;
use crate::price::Price;
use crate::refusal::Refusal;
use crate::request::{Answer, Request};
use crate::search::Bound;
use crate::target::Chip;

/// Every evaluation that can hold a light, and the cheapest whose error is within the tolerance.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Survey {
    /// The evaluations, the cheapest on the chip of the request first.
    pub evaluations: Vec<Surveyed>,
    /// The evaluation that [`Request::pick`] returns; `None` if no bound is within the tolerance.
    pub picked: Option<Evaluation>,
}

/// An evaluation of a light, with its error and its prices.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Surveyed {
    /// The evaluation.
    pub evaluation: Evaluation,
    /// The bound of the error, in the unit of the tolerance.
    pub bound: Bound,
    /// The cost of a lit point by the name of the chip.
    pub prices: BTreeMap<&'static str, Price>,
    /// Rust source of the constant `LIGHT`, the compiled light.
    pub code: String,
}

impl Request {
    /// Returns all evaluations that can hold a light, with their bounds and their prices on every
    /// chip.
    ///
    /// # Errors
    /// A parameter of the light that is invalid. A light that no evaluation can hold.
    pub fn survey(&self, light: &Light) -> Result<Survey, Refusal> {
        let offers = self.offers(light)?;
        let any = light.any()?;
        let amount = self.tolerance.amount();
        let picked = offers.iter().find(|offer| offer.bound() <= amount).map(|offer| offer.evaluation);
        let surveyed = offers.iter().map(|offer| {
            let Answer { evaluation, bound, code, .. } = self.answer(offer, light)?;
            let price = |&chip: &Chip| {
                Price::of(chip, &any, evaluation, offer.fine).map(|price| (chip.name(), price))
            };
            let prices = Chip::ALL.iter().map(price).collect::<Result<_, _>>()?;
            Ok(Surveyed { evaluation, bound, prices, code })
        });
        Ok(Survey { evaluations: surveyed.collect::<Result<_, Refusal>>()?, picked })
    }
}
