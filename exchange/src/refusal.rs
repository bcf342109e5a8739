//! The error of every reader: where, what, and the remedy.

use std::fmt;

use luminaire_export::{ExportError, printable};

/// A rejected value of a file or of a command: its place, its name, and the accepted values.
///
/// The message has the form `{place}: {parameter} = {value}: expected {expected}` and at most 2,000
/// characters; a longer value is cut.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refusal {
    /// The line or the element, such as `line 14` or `nodes[3]`; empty for the whole input.
    pub place: String,
    /// The parameter, in the words of its system.
    pub parameter: String,
    /// The value.
    pub value: String,
    /// The accepted values, and the remedy if there is one.
    pub expected: String,
}

/// The most characters of a part of a message.
const MOST: usize = 480;

impl Refusal {
    /// Creates a refusal without a place. Control characters are escaped, and long parts are cut.
    pub fn new(parameter: impl fmt::Display, value: impl fmt::Display, expected: impl fmt::Display) -> Self {
        let [parameter, value, expected] = [cut(&parameter), cut(&value), cut(&expected)];
        Self { place: String::new(), parameter, value, expected }
    }

    /// Returns the refusal with the place of the value. A place that is known already stays, after the
    /// new one.
    #[must_use]
    pub fn at(self, place: impl fmt::Display) -> Self {
        let place = cut(&place);
        let place = if self.place.is_empty() { place } else { cut(&format!("{place}, {}", self.place)) };
        Self { place, ..self }
    }
}

/// Returns a text on one line, cut to its most characters.
fn cut(text: &impl fmt::Display) -> String {
    let text = printable(&text.to_string());
    if text.chars().count() <= MOST {
        return text;
    }
    let mut short: String = text.chars().take(MOST - 3).collect();
    short.push_str("...");
    short
}

impl From<luminaire::Error> for Refusal {
    fn from(error: luminaire::Error) -> Self {
        ExportError::from(error).into()
    }
}

impl From<ExportError> for Refusal {
    fn from(ExportError { parameter, value, expected }: ExportError) -> Self {
        Self::new(parameter, value, expected)
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.place.is_empty() {
            write!(f, "{}: ", self.place)?;
        }
        write!(f, "{} = {}: expected {}", self.parameter, self.value, self.expected)
    }
}

impl std::error::Error for Refusal {}
