//! A figure: what it says, what the visitor changes, and what is drawn of that.

use crate::{
    quantity::Quantity,
    refusal::{Refusal, one_of},
};

/// A figure of the class: one idea.
pub(crate) struct Figure {
    /// The name in addresses.
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    /// At most three sentences.
    pub(crate) text: &'static str,
    pub(crate) formula: &'static str,
    /// The document and the place in it.
    pub(crate) source: &'static str,
    /// What an address keeps. At most two controls show them: see [`Parameter::WHICH`].
    pub(crate) parameters: &'static [Parameter],
    pub(crate) question: &'static str,
    pub(crate) answer: fn() -> Result<String, Refusal>,
    pub(crate) draw: fn(&Values) -> Result<Drawing, Refusal>,
}

/// What a visitor changes.
pub(crate) enum Parameter {
    /// A name, a label, and the names and labels of the options, the first of which is chosen at the start.
    Choice(&'static str, &'static str, &'static [(&'static str, &'static str)]),
    /// A quantity, and its value at the start.
    Dial(Quantity, f32),
}

impl Parameter {
    /// The name of a choice whose options are the dials of the figure: only the chosen one is shown.
    pub(crate) const WHICH: &'static str = "which";

    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Choice(name, ..) => name,
            Self::Dial(quantity, _) => quantity.name,
        }
    }
}

/// A figure and the values of its parameters: for a choice the index of its option.
#[derive(Clone)]
pub(crate) struct Values {
    pub(crate) figure: &'static Figure,
    values: Vec<f32>,
}

impl Values {
    /// The values at the start.
    pub(crate) fn of(figure: &'static Figure) -> Self {
        let start = |parameter: &_| if let Parameter::Dial(_, start) = parameter { *start } else { 0.0 };
        Self { figure, values: figure.parameters.iter().map(start).collect() }
    }

    /// The values of dials; NaN without one.
    pub(crate) fn numbers<const N: usize>(&self, quantities: [Quantity; N]) -> [f32; N] {
        let parameters = self.figure.parameters;
        let place = |Quantity { name, .. }| parameters.iter().position(|parameter| parameter.name() == name);
        quantities.map(|quantity| place(quantity).map_or(f32::NAN, |place| self.values[place]))
    }

    /// The name of the chosen option of the first parameter.
    pub(crate) fn choice(&self) -> String {
        self.texts().next().map_or(String::new(), |(_, text)| text)
    }

    /// Sets a parameter from the text of an address or of a control.
    pub(crate) fn set(&mut self, name: &str, text: &str) -> Result<(), Refusal> {
        let names = || one_of(self.figure.parameters.iter().map(Parameter::name));
        let place = self.figure.parameters.iter().position(|parameter| parameter.name() == name);
        let place = place.ok_or_else(|| Refusal::name("parameter", name, names()))?;
        self.values[place] = match &self.figure.parameters[place] {
            Parameter::Choice(_, label, options) => {
                let found = options.iter().position(|(option, _)| *option == text);
                let names = || one_of(options.iter().map(|(option, _)| *option));
                found.ok_or_else(|| Refusal::name(label, text, names()))? as f32
            }
            Parameter::Dial(Quantity { label, unit, ends, is_whole, .. }, _) => {
                let number = text.parse().unwrap_or(f32::NAN);
                if !(ends[0]..=ends[1]).contains(&number) {
                    return Err(Refusal::outside(label, number, *ends, unit.trim()));
                }
                if *is_whole { number.round() } else { number }
            }
        };
        Ok(())
    }

    /// Every parameter with its value as text.
    pub(crate) fn texts(&self) -> impl Iterator<Item = (&'static str, String)> {
        self.figure.parameters.iter().zip(&self.values).map(|(parameter, value)| match parameter {
            Parameter::Choice(name, _, options) => (*name, options[*value as usize].0.to_owned()),
            Parameter::Dial(quantity, _) => (quantity.name, value.to_string()),
        })
    }

    /// The address that restores the values.
    pub(crate) fn address(&self) -> String {
        let parts = self.texts().map(|(name, value)| format!("&{name}={value}"));
        format!("figure={}{}", self.figure.name, parts.collect::<String>())
    }
}

/// What is drawn of a figure.
#[derive(Default)]
pub(crate) struct Drawing {
    pub(crate) pictures: Vec<Picture>,
    pub(crate) graph: Option<Graph>,
    /// Labels, values and units.
    pub(crate) numbers: Vec<(&'static str, f64, &'static str)>,
    /// What the kernel has refused, or a formula cannot give; empty if nothing.
    pub(crate) refused: String,
}

/// A picture of grey sRGB codes, row by row from the top.
pub(crate) struct Picture {
    pub(crate) label: &'static str,
    /// What is seen, in words.
    pub(crate) seen: String,
    pub(crate) width: usize,
    pub(crate) codes: Vec<u8>,
}

/// Curves over one axis.
pub(crate) struct Graph {
    /// The axis across: its label and its ends.
    pub(crate) across: (&'static str, [f64; 2]),
    /// The axis up from 0: its label and its end.
    pub(crate) up: (&'static str, f64),
    /// The first is the subject, others are for comparison.
    pub(crate) curves: Vec<(&'static str, Vec<[f64; 2]>)>,
    /// Labelled points.
    pub(crate) marks: Vec<([f64; 2], String)>,
}

/// A value with four significant digits, or all of a whole number.
pub(crate) fn tidy(value: impl Into<f64>) -> String {
    let value = value.into();
    if value == f64::INFINITY {
        return "∞".to_owned();
    }
    let decimals = if value == 0.0 { 0.0 } else { (3.0 - value.abs().log10().floor()).clamp(0.0, 12.0) };
    let text = format!("{value:.0$}", decimals as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
