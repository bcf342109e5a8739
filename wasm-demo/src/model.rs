//! Models that a visitor chooses by name, with a dial for each of their numbers: edges and laws of distance, as
//! the lists of the library have them.

use crate::{
    decimal,
    plain::plain,
    refusal::{Refusal, one_of},
};
use luminaire::{
    Error,
    attenuation::{AnyAttenuation, Attenuation, AttenuationRow},
    falloff::AnyFalloff,
    models::{Accepts, Number},
};
use wasm_bindgen::JsValue;

/// A model that a visitor can choose.
pub(crate) trait Chosen: Copy + PartialEq {
    /// All models, each with the numbers that it begins with.
    fn all() -> Vec<Self>;

    /// The name, in addresses and lists.
    fn name(&self) -> &'static str;

    /// What its numbers are.
    fn list(&self) -> &'static [Number];

    /// Its numbers.
    fn values(&self) -> Vec<f32>;

    /// Returns the same model with other numbers.
    ///
    /// # Errors
    /// Numbers that the library refuses.
    fn with_values(&self, values: &[f32]) -> Result<Self, Error>;

    /// Returns the model of a name, with the numbers that it begins with.
    fn named(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|model| model.name() == name)
    }

    /// Returns the model that a visitor chooses by its name; `None` for one of the names that are `none`.
    fn chosen(parameter: &str, name: &str, none: &[&'static str]) -> Result<Option<Self>, Refusal> {
        let model = Self::named(name);
        if model.is_none() && !none.contains(&name) {
            let all = Self::all();
            let names = none.iter().copied().chain(all.iter().map(Self::name));
            return Err(Refusal::name(parameter, name, one_of(names)));
        }
        Ok(model)
    }

    /// Returns the same model with another number at a place.
    fn with_value(&self, place: usize, value: f32) -> Result<Self, Refusal> {
        let mut values = self.values();
        let count = values.len();
        let expected = || format!("the place of one of the {count} numbers of {}", self.name());
        *values.get_mut(place).ok_or_else(|| Refusal::name("number", &place.to_string(), expected()))? =
            value;
        Ok(self.with_values(&values)?)
    }

    /// Writes the model for an address: its name, and its numbers if they are not those that it begins with.
    fn written(&self) -> String {
        let name = self.name();
        let is_new = Self::named(name) == Some(*self);
        if is_new { name.to_owned() } else { format!("{name}/{}", decimal::numbers(&self.values())) }
    }

    /// Reads what [`written`](Self::written) writes.
    fn read(text: &str) -> Option<Self> {
        let (name, numbers) = text.split_once('/').map_or((text, None), |(name, rest)| (name, Some(rest)));
        let model = Self::named(name)?;
        let Some(numbers) = numbers else { return Some(model) };
        let values = numbers.split('/').map(decimal::read).collect::<Option<Vec<_>>>()?;
        if values.len() == model.list().len() { model.with_values(&values).ok() } else { None }
    }
}

impl Chosen for AnyFalloff {
    fn all() -> Vec<Self> {
        Self::samples().collect()
    }

    fn name(&self) -> &'static str {
        self.row().name
    }

    fn list(&self) -> &'static [Number] {
        self.row().numbers
    }

    fn values(&self) -> Vec<f32> {
        self.numbers().collect()
    }

    fn with_values(&self, values: &[f32]) -> Result<Self, Error> {
        self.row().of(values)
    }
}

/// Laws without a window, which would only end them at a range.
impl Chosen for AnyAttenuation {
    fn all() -> Vec<Self> {
        let is_alone = |row: &&AttenuationRow| row.window.is_none_or(|window| window == "cut");
        let sample = |row: &AttenuationRow| {
            let numbers: Vec<_> = row.numbers.iter().map(Number::in_sample).collect();
            row.of_law(&numbers).ok()
        };
        Self::LIST.iter().filter(is_alone).filter_map(sample).collect()
    }

    /// The name of the law among the effects.
    fn name(&self) -> &'static str {
        self.effects().iter().next().map_or("", |effect| effect.name())
    }

    fn list(&self) -> &'static [Number] {
        self.row().numbers
    }

    fn values(&self) -> Vec<f32> {
        self.numbers().collect()
    }

    fn with_values(&self, values: &[f32]) -> Result<Self, Error> {
        self.row().of_law(values)
    }
}

/// Whether the slider of a number has the same way for each factor, and not for each difference.
pub(crate) fn is_logarithmic(number: &Number) -> bool {
    number.accepts != Accepts::All
}

/// Returns the models of a kind with their numbers, as [`model`] has them.
pub(crate) fn listed<M: Chosen>() -> Vec<JsValue> {
    let state = |own: M| model(own.name(), own.list().iter().map(number).collect());
    M::all().into_iter().map(state).collect()
}

/// Returns a name of the library as words: `edge_slope` is `Edge slope`.
fn label(name: &str) -> String {
    let mut letters = name.replace('_', " ");
    if let Some(first) = letters.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    letters
}

/// Returns a power of the metre as it follows a number.
fn unit(dimension: i8) -> String {
    match dimension {
        0 => String::new(),
        1 => " m".to_owned(),
        -1 => " /m".to_owned(),
        -2 => " /m²".to_owned(),
        _ => format!(" m^{dimension}"),
    }
}

plain! {
    /// A model and what its numbers are.
    fn model(name: &str, numbers: Vec<JsValue>) -> ModelState {
        "name": "string" = name,
        "numbers": "NumberState[]" = numbers,
    }
}

plain! {
    /// The dial of a number of a model, without its ends, which depend on the light.
    fn number(number: &Number) -> NumberState {
        "label": "string" = label(number.name),
        "unit": "string" = unit(number.dimension),
        "isLogarithmic": "boolean" = is_logarithmic(number),
        "isWhole": "boolean" = number.accepts == Accepts::Whole,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Models with the numbers that they begin with, and with any that they accept, come back from an address.
    fn assert_written<M: Chosen + std::fmt::Debug>() {
        let mut random = fastrand::Rng::with_seed(8);
        let (mut numbers, mut made) = (0, 0);
        for model in M::all() {
            assert_eq!(model.written(), model.name());
            assert_eq!(M::read(model.name()), Some(model));
            numbers += model.list().len();
            for _ in 0..50 {
                let values: Vec<_> =
                    model.list().iter().map(|number| number.anywhere(random.f32())).collect();
                let Ok(own) = model.with_values(&values) else { continue };
                assert_eq!(M::read(&own.written()), Some(own), "{}", own.written());
                made += usize::from(own != model);
            }
            let wrong = format!("{}/1/2/3/4", model.name());
            assert_eq!((M::read(&wrong), model.with_value(4, 1.0).is_err()), (None, true), "{wrong}");
            assert_eq!(M::chosen("model", model.name(), &["own"]), Ok(Some(model)));
        }
        assert_eq!(
            (M::chosen("model", "own", &["own"]), M::chosen("model", "own", &[]).is_err()),
            (Ok(None), true)
        );
        assert!(numbers > 5 && made > 100, "{numbers} numbers, {made} models");
    }

    #[test]
    fn every_edge_and_every_law_comes_back_with_its_numbers() {
        assert_written::<AnyFalloff>();
        assert_written::<AnyAttenuation>();
        assert_eq!(label("edge_slope"), "Edge slope");
    }
}
