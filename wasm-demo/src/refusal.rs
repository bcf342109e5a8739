//! Refusals in words for the page: the parameter, its value, and the remedy.

use luminaire_render::{DrawError, SizeError};
use std::{borrow::Cow, fmt};
use wasm_bindgen::JsValue;

/// A rejected value. A rejection changes nothing.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Refusal {
    /// The kernel refused a parameter of a light.
    Light(luminaire::Error),
    /// The renderer refused the size of the picture.
    Size(SizeError),
    /// The renderer refused to draw something.
    Draw(DrawError),
    /// A light does not fit into a number format.
    Format {
        /// The number format in words.
        format: &'static str,
        /// Which light, counted from 0.
        light: usize,
        /// The stage-lighting name of this kind of fixture.
        name: &'static str,
        error: luminaire::Error,
    },
    /// An unknown name for a choice.
    Name { parameter: &'static str, value: String, expected: Cow<'static, str> },
    /// The settings of a light in an address, which opens with that light as the scene has it.
    Opened { light: usize, reason: String },
    /// An index of a light that does not exist.
    Number { value: usize, count: usize },
    /// A zoom angle outside the range of the fixture.
    Zoom { value: f32, narrow: f32, wide: f32 },
    /// A number outside its range.
    Outside { parameter: &'static str, value: f32, least: f32, most: f32, unit: &'static str },
    /// A language that cannot express a light.
    #[cfg(feature = "code")]
    Export(luminaire_export::ExportError),
    /// A failed call of the browser.
    Browser { what: &'static str, reason: String },
}

impl Refusal {
    /// An unknown name for a choice.
    pub(crate) fn name(parameter: &'static str, value: &str, expected: impl Into<Cow<'static, str>>) -> Self {
        Self::Name { parameter, value: value.to_owned(), expected: expected.into() }
    }

    /// A number outside its range.
    pub(crate) fn outside(
        parameter: &'static str,
        value: f32,
        [least, most]: [f32; 2],
        unit: &'static str,
    ) -> Self {
        Self::Outside { parameter, value, least, most, unit }
    }

    /// A failure of the browser, with its own message.
    pub(crate) fn browser(what: &'static str, reason: &JsValue) -> Self {
        Self::Browser { what, reason: format!("{reason:?}") }
    }
}

/// Returns the one of these choices that has a name.
pub(crate) fn choose<T: Copy>(
    parameter: &'static str,
    name: &str,
    choices: &[T],
    name_of: fn(T) -> &'static str,
) -> Result<T, Refusal> {
    let found = choices.iter().copied().find(|&choice| name_of(choice) == name);
    found.ok_or_else(|| Refusal::name(parameter, name, one_of(choices.iter().copied().map(name_of))))
}

/// Lists names in words: `a, b or c`.
pub(crate) fn one_of<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<_> = names.collect();
    match names.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => names.concat(),
    }
}

/// Formats a number as the kernel's errors do: very large and very small numbers with an exponent.
struct Short(f32);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        if value == 0.0 || (1e-6..1e12).contains(&value.abs()) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Light(error) => error.fmt(f),
            Self::Size(error) => error.fmt(f),
            Self::Draw(error) => error.fmt(f),
            #[cfg(feature = "code")]
            Self::Export(error) => error.fmt(f),
            Self::Format { format, light, name, error } => {
                write!(f, "{format} cannot hold light {}, {name}: {error}", light + 1)
            }
            Self::Name { parameter, value, expected } => {
                write!(f, "{parameter} = \"{value}\": expected {expected}")
            }
            Self::Opened { light, reason } => {
                write!(f, "light {} is as the scene has it: {reason}", light + 1)
            }
            Self::Number { value, count } => {
                write!(f, "light = {value}: expected a number from 0 to {}", count - 1)
            }
            Self::Zoom { value, narrow, wide } => {
                write!(
                    f,
                    "zoom = {}: expected {narrow} to {wide} degrees, as this fixture has",
                    Short(*value)
                )
            }
            Self::Outside { parameter, value, least, most, unit } => {
                write!(f, "{parameter} = {}: expected {least} to {most} {unit}", Short(*value))
            }
            Self::Browser { what, reason } => write!(f, "{what}: {reason}"),
        }
    }
}

impl From<luminaire::Error> for Refusal {
    fn from(error: luminaire::Error) -> Self {
        Self::Light(error)
    }
}

impl From<SizeError> for Refusal {
    fn from(error: SizeError) -> Self {
        Self::Size(error)
    }
}

impl From<DrawError> for Refusal {
    fn from(error: DrawError) -> Self {
        Self::Draw(error)
    }
}

#[cfg(feature = "code")]
impl From<luminaire_export::ExportError> for Refusal {
    fn from(error: luminaire_export::ExportError) -> Self {
        Self::Export(error)
    }
}

impl From<Refusal> for JsValue {
    /// Converts to a plain string, which the page shows unchanged.
    fn from(refusal: Refusal) -> Self {
        Self::from_str(&refusal.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refused_number_is_short_whatever_its_size() {
        for value in [f32::MAX, f32::MIN, f32::MIN_POSITIVE, 1e-9, 3.4e38, f32::NAN, f32::INFINITY] {
            let zoom = Refusal::Zoom { value, narrow: 1.0, wide: 2.0 }.to_string();
            let outside =
                Refusal::Outside { parameter: "zoom", value, least: 1.0, most: 2.0, unit: "" }.to_string();
            let light = luminaire::Angle::degrees(value);
            let light = luminaire::Cone::from_field(luminaire::falloff::Soft, light).map(drop);
            let light = light.map_or_else(|error| error.to_string(), |()| String::new());
            for words in [zoom, outside, light] {
                assert!(words.len() < 100, "{words}");
            }
        }
        assert!(
            Refusal::Zoom { value: 20.5, narrow: 1.0, wide: 2.0 }.to_string().starts_with("zoom = 20.5:")
        );
    }
}
