//! Words of the command line: a name, and numbers after `=`.

use std::fmt;
use std::str::FromStr;

use luminaire::falloff::AnyFalloff;
use luminaire_exchange::System;
use luminaire_export::{Language, words};

/// An attenuation without its range: its name and its numbers.
#[derive(Clone, Debug)]
pub(crate) struct Law {
    pub(crate) name: String,
    pub(crate) numbers: Vec<f32>,
}

impl FromStr for Law {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, numbers) = split(text)?;
        let law = Self {
            name: name.to_owned(),
            numbers: numbers.into_iter().map(|number| number as f32).collect(),
        };
        // A law that has a range always is accepted with any.
        words::attenuation(&law.name, &law.numbers, "cut", Some(1.0)).map_err(|error| error.to_string())?;
        Ok(law)
    }
}

/// Splits `name=1,2` into the name and the numbers.
fn split(text: &str) -> Result<(&str, Vec<f64>), String> {
    let Some((name, numbers)) = text.split_once('=') else { return Ok((text, Vec::new())) };
    let numbers = numbers.split(',').map(|number| number.trim().parse());
    Ok((name, numbers.collect::<Result<_, _>>().map_err(|_| format!("expected numbers after `{name}=`"))?))
}

/// Returns the falloff of a name in the list of models, with its parameters.
pub(crate) fn falloff(text: &str) -> Result<AnyFalloff, String> {
    let (name, numbers) = split(text)?;
    words::falloff(name, &numbers).map_err(|error| error.to_string())
}

/// The falloffs, as the help tells them.
pub(crate) fn falloffs() -> String {
    format!(
        "One of {} [default: soft]. Beside both --beam and --field only soft is possible: a soft edge that has both",
        words::falloff_words()
    )
}

/// The laws of the attenuation, as the help tells them.
pub(crate) fn laws() -> String {
    format!("One of {} [default: inverse-square]", words::law_words())
}

/// What a light is written as.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Target {
    /// Source of a language, or JSON.
    Language(Language),
    /// The parameters of a tool.
    Tool(System),
    /// IES LM-63.
    Ies,
}

impl fmt::Display for Target {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Language(language) => language.fmt(out),
            Self::Tool(tool) => tool.fmt(out),
            Self::Ies => out.pad("ies"),
        }
    }
}

impl FromStr for Target {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let tool = System::writable().find(|tool| tool.name() == name);
        match (name.parse(), tool) {
            (Ok(language), _) => Ok(Self::Language(language)),
            (_, Some(tool)) => Ok(Self::Tool(tool)),
            _ if name == "ies" => Ok(Self::Ies),
            (Err(error), None) => {
                let tools: Vec<_> = System::writable().map(System::name).collect();
                Err(format!("{error}, {}, or ies", tools.join(", ")))
            }
        }
    }
}
