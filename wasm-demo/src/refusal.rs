//! Refusals in words for the page: the parameter, its value, and the remedy.

use std::fmt;
use wasm_bindgen::JsValue;

/// A rejected value, in words. A rejection changes nothing.
#[derive(Clone, PartialEq, Debug)]
pub struct Refusal(pub(crate) String);

impl Refusal {
    /// An unknown name for a choice.
    pub(crate) fn name(parameter: &str, value: &str, expected: impl fmt::Display) -> Self {
        Self(format!("{parameter} = \"{value}\": expected {expected}"))
    }

    /// A number outside its range.
    pub(crate) fn outside(parameter: &str, value: f32, [least, most]: [f32; 2], unit: &str) -> Self {
        Self(format!("{parameter} = {}: expected {least} to {most} {unit}", Short(value)))
    }

    /// An index of a light that does not exist, of a number of lights.
    pub(crate) fn light(index: usize, count: usize) -> Self {
        Self(format!("light = {index}: expected a number from 0 to {}", count.saturating_sub(1)))
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
        f.write_str(&self.0)
    }
}

impl<E: std::error::Error> From<E> for Refusal {
    /// What the kernel, the renderer or the exporter refuses, in its own words.
    fn from(error: E) -> Self {
        Self(error.to_string())
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
            let Refusal(outside) = Refusal::outside("zoom", value, [1.0, 2.0], "degrees");
            let light = luminaire::Angle::degrees(value);
            let light = luminaire::Cone::from_field(luminaire::falloff::Soft, light).map(drop);
            let light = light.map_or_else(|error| error.to_string(), |()| String::new());
            for words in [outside, light] {
                assert!(words.len() < 100, "{words}");
            }
        }
    }
}
