//! A light in the words of its system: what a reader of files finds, and what a command is given.

use std::fmt;
use std::ops::Range;
use std::rc::Rc;

use glam::DVec3;

use crate::limits::within;
use crate::refusal::Refusal;
use crate::tabulate::Tables;

/// The kind of a light.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Spot,
    Point,
    Directional,
    Ambient,
}

/// A value of a record.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Value {
    Numbers(Vec<f64>),
    Word(String),
}

/// A light as its system describes it: named values, and where the light is in the world.
///
/// The values have the names, the units and the defaults of the system. A reader of a file sets the
/// position and the axis from the transforms of the nodes.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    pub(crate) name: String,
    pub(crate) kind: Kind,
    /// The line or the element, for messages.
    pub(crate) place: String,
    pub(crate) position: DVec3,
    /// The direction in which the light shines, of any length.
    pub(crate) axis: DVec3,
    values: Vec<(String, Value)>,
    /// The names that were read: those that the system has.
    asked: Vec<String>,
    pub(crate) notes: Vec<String>,
    /// The photometric file that shapes the light.
    pub(crate) profile: Option<Box<Profile>>,
    /// The tables of the lights of a file.
    pub(crate) tables: Tables,
}

/// The photometric file of a light: an intensity of the light is its own times that of the file.
#[derive(Clone, Debug)]
pub(crate) struct Profile {
    /// The file as the scene names it, or the place of one within the scene.
    pub(crate) file: String,
    /// The content of one within the scene.
    pub(crate) content: Option<Rc<[u8]>>,
    /// The bytes of the file that are the photometric one, if not all are.
    pub(crate) part: Option<Range<usize>>,
    /// Whether the light keeps the flux that it has without the file.
    pub(crate) is_normalized: bool,
    /// The light without the file, if the scene has it.
    pub(crate) without: Option<Record>,
}

impl Record {
    /// Creates a record without values, at the origin and along -z. A name ends after 200 characters: the
    /// lights of a file may share one.
    pub(crate) fn new(name: &str, kind: Kind, place: impl fmt::Display) -> Self {
        Self {
            name: name.chars().take(200).collect(),
            kind,
            place: place.to_string(),
            position: DVec3::ZERO,
            axis: DVec3::NEG_Z,
            values: Vec::new(),
            asked: Vec::new(),
            notes: Vec::new(),
            profile: None,
            tables: Tables::default(),
        }
    }

    /// Sets a value. The last one of a name counts.
    pub(crate) fn set(&mut self, key: impl Into<String>, value: Value) {
        self.values.push((key.into(), value));
    }

    /// Takes the `m_` from the names of the values, as in the files of Unity, whose scripts have none.
    pub(crate) fn without_prefix(&mut self) {
        for (key, _) in &mut self.values {
            let mut own = key.strip_prefix("m_").unwrap_or_default().chars();
            if let Some(first) = own.next() {
                *key = first.to_ascii_lowercase().to_string() + own.as_str();
            }
        }
    }

    /// Sets a number.
    pub(crate) fn number(&mut self, key: impl Into<String>, number: f64) {
        self.set(key, Value::Numbers(vec![number]));
    }

    /// Adds a note for the user: what was assumed or left out.
    pub(crate) fn note(&mut self, note: impl Into<String>) {
        self.notes.push(note.into());
    }

    /// Returns whether a value was given.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.values.iter().any(|(own, _)| own == key)
    }

    /// Removes a value and returns it.
    pub(crate) fn take(&mut self, key: &str) -> Option<Value> {
        let at = self.values.iter().rposition(|(own, _)| own == key)?;
        Some(self.values.remove(at).1)
    }

    fn value(&mut self, key: &str) -> Option<Value> {
        if !self.asked.iter().any(|own| own == key) {
            self.asked.push(key.to_owned());
        }
        self.values.iter().rfind(|(own, _)| own == key).map(|(_, value)| value.clone())
    }

    /// Returns a number, or `None` if it was not given.
    pub(crate) fn optional(&mut self, key: &str) -> Result<Option<f64>, Refusal> {
        match self.value(key) {
            None => Ok(None),
            Some(Value::Numbers(numbers)) if numbers.len() == 1 => Ok(Some(numbers[0])),
            Some(other) => Err(Refusal::new(key, shown(&other), "a number")),
        }
    }

    /// Returns a number, or its default.
    pub(crate) fn get(&mut self, key: &str, default: f64) -> Result<f64, Refusal> {
        Ok(self.optional(key)?.unwrap_or(default))
    }

    /// Returns a number within limits, or its default.
    pub(crate) fn within(&mut self, key: &str, default: f64, least: f64, most: f64) -> Result<f64, Refusal> {
        let value = self.get(key, default)?;
        let refusal = || Refusal::new(key, value, format_args!("a number from {least} to {most}"));
        within(value, least, most).ok_or_else(refusal)
    }

    /// Returns a number, or its default, for the kernel to judge. Only rounding across these limits is undone.
    pub(crate) fn near(&mut self, key: &str, default: f64, least: f64, most: f64) -> Result<f64, Refusal> {
        let value = self.get(key, default)?;
        Ok(within(value, least, most).unwrap_or(value))
    }

    /// Returns all numbers of a value, or `None` if it was not given.
    pub(crate) fn numbers(&mut self, key: &str) -> Result<Option<Vec<f64>>, Refusal> {
        match self.value(key) {
            None => Ok(None),
            Some(Value::Numbers(numbers)) => Ok(Some(numbers)),
            Some(other) => Err(Refusal::new(key, shown(&other), "numbers")),
        }
    }

    /// Returns three numbers, or their default. One number stands for three equal ones.
    pub(crate) fn triple(&mut self, key: &str, default: [f64; 3]) -> Result<[f64; 3], Refusal> {
        match self.value(key) {
            None => Ok(default),
            Some(Value::Numbers(numbers)) if numbers.len() == 1 => Ok([numbers[0]; 3]),
            Some(Value::Numbers(numbers)) if numbers.len() == 3 => Ok([numbers[0], numbers[1], numbers[2]]),
            Some(other) => Err(Refusal::new(key, shown(&other), "three numbers")),
        }
    }

    /// Returns a word, or its default. A number is a word, too.
    pub(crate) fn word(&mut self, key: &str, default: &str) -> String {
        self.value(key).map_or_else(|| default.to_owned(), |value| shown(&value))
    }

    /// Returns the names that the system has, in the order of its formula.
    pub(crate) fn asked(&self) -> &[String] {
        &self.asked
    }

    /// Returns the name of the first value that was never read.
    pub(crate) fn unused(&self) -> Option<&str> {
        self.values.iter().map(|(key, _)| key.as_str()).find(|key| !self.asked.iter().any(|own| own == key))
    }
}

fn shown(value: &Value) -> String {
    match value {
        Value::Word(word) => word.clone(),
        Value::Numbers(numbers) => {
            // Without the hundreds of digits of very large and very small ones.
            let text = |number: &f64| match number.abs() {
                0.0 | 1e-9..1e15 => number.to_string(),
                _ => format!("{number:e}"),
            };
            numbers.iter().take(5).map(text).collect::<Vec<_>>().join(",")
        }
    }
}

/// Returns a linear component of a colour that is stored in sRGB.
pub(crate) fn linear(component: f64) -> f64 {
    if component <= 0.040_45 { component / 12.92 } else { ((component + 0.055) / 1.055).powf(2.4) }
}
