//! The JavaScript class of the class: figures that teach spotlights, drawn by the kernel.

mod figure;
mod figures;
mod lit;
#[cfg(test)]
mod tests;

use crate::{false_colour::rgba, panic, quantity::Quantity, refusal::Refusal};
use figure::{Drawing, Figure, Parameter, Picture, Values, tidy};
use figures::ALL;
use serde_json::{Value, json};
use std::fmt;
use wasm_bindgen::{Clamped, prelude::*};

/// A figure at the values of its controls. Every setter either takes its value, or changes nothing and
/// throws a string that names the parameter, its value and the remedy.
#[wasm_bindgen]
pub struct Class {
    values: Values,
    drawing: Drawing,
}

impl fmt::Debug for Class {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Class").field(&self.values.address()).finish()
    }
}

#[wasm_bindgen]
impl Class {
    /// Opens the first figure.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Result<Self, Refusal> {
        panic::tell_the_page();
        let [first, ..] = &ALL;
        Self::of(first)
    }

    /// The figures in the order of the class, as JSON.
    pub fn figures() -> Result<String, Refusal> {
        let all: Result<Vec<_>, _> = ALL.iter().map(described).collect();
        Ok(Value::from(all?).to_string())
    }

    /// Opens the figure of an address, such as `figure=attenuation&c=1`, at its values. Returns what is
    /// refused in words; the other values are taken.
    pub fn open(&mut self, address: &str) -> Result<String, Refusal> {
        let (mut figure, mut refused) = (self.values.figure, Vec::new());
        let (names, pairs): (Vec<_>, Vec<_>) =
            address.split('&').filter_map(|pair| pair.split_once('=')).partition(|(key, _)| *key == "figure");
        for (_, name) in names {
            match ALL.iter().find(|figure| figure.name == name) {
                Some(found) => figure = found,
                None => refused.push(Refusal::name("figure", name, "one of the list")),
            }
        }
        let mut values = Values::of(figure);
        // A name that is no parameter is ignored, because trackers add some.
        let is_own = |name: &str| figure.parameters.iter().any(|parameter| parameter.name() == name);
        for (name, text) in pairs.into_iter().filter(|(name, _)| is_own(name)) {
            refused.extend(values.set(name, text).err());
        }
        let drawing = (figure.draw)(&values).or_else(|refusal| {
            refused.push(refusal);
            values = Values::of(figure);
            (figure.draw)(&values)
        })?;
        (self.values, self.drawing) = (values, drawing);
        Ok(refused.iter().map(Refusal::to_string).collect::<Vec<_>>().join(" "))
    }

    /// Sets a parameter of the figure.
    pub fn set(&mut self, name: &str, text: &str) -> Result<(), Refusal> {
        let mut values = self.values.clone();
        values.set(name, text)?;
        self.drawing = (values.figure.draw)(&values)?;
        self.values = values;
        Ok(())
    }

    /// The values, the address that restores them, and what is drawn but for the pixels, as JSON.
    pub fn told(&self) -> String {
        let Drawing { pictures, graph, numbers, refused } = &self.drawing;
        let picture = |Picture { label, seen, width, codes }: &Picture| json!({ "label": label, "seen": seen, "width": width, "height": codes.len() / width });
        let graph = graph.as_ref().map(|graph| {
            json!({ "across": graph.across, "up": graph.up, "curves": graph.curves, "marks": graph.marks })
        });
        let number =
            |&(label, value, unit): &(&str, f64, &str)| [label.to_owned(), format!("{}{unit}", tidy(value))];
        json!({
            "figure": self.values.figure.name,
            "values": self.values.texts().collect::<std::collections::BTreeMap<_, _>>(),
            "address": self.values.address(),
            "pictures": pictures.iter().map(picture).collect::<Vec<_>>(),
            "graph": graph,
            "numbers": numbers.iter().map(number).collect::<Vec<_>>(),
            "refused": refused,
        })
        .to_string()
    }

    /// The pixels of a picture of the figure: RGBA, sRGB.
    pub fn pixels(&self, picture: usize) -> Clamped<Vec<u8>> {
        let codes = self.drawing.pictures.get(picture).map_or(&[][..], |picture| &picture.codes);
        Clamped(rgba(codes.iter().map(|&code| [code; 3])))
    }
}

impl Class {
    fn of(figure: &'static Figure) -> Result<Self, Refusal> {
        let values = Values::of(figure);
        Ok(Self { drawing: (figure.draw)(&values)?, values })
    }
}

fn described(figure: &Figure) -> Result<Value, Refusal> {
    let parameter = |parameter: &Parameter| match parameter {
        Parameter::Choice(name, label, options) => {
            json!({ "name": name, "label": label, "options": options })
        }
        Parameter::Dial(Quantity { name, label, unit, ends, is_logarithmic, .. }, _) => {
            json!({ "name": name, "label": label, "unit": unit, "ends": ends, "isLogarithmic": is_logarithmic })
        }
    };
    let Figure { name, title, text, formula, source, question, .. } = figure;
    let parameters: Vec<_> = figure.parameters.iter().map(parameter).collect();
    let (answer, which) = ((figure.answer)()?, Parameter::WHICH);
    Ok(json!({
        "name": name, "title": title, "text": text, "formula": formula, "source": source, "question": question,
        "answer": answer, "which": which, "parameters": parameters,
    }))
}
