//! What cannot be exported.

use std::fmt;

/// A light, a name or a language that cannot be exported.
#[derive(Clone, PartialEq, Debug)]
pub struct ExportError {
    /// The parameter.
    pub parameter: String,
    /// The value of the parameter.
    pub value: String,
    /// The accepted values, and the remedy.
    pub expected: String,
}

impl ExportError {
    /// Refuses a value, whose unprintable characters are escaped.
    pub fn new(parameter: &str, value: impl fmt::Display, expected: impl Into<String>) -> Self {
        let value = printable(&value.to_string());
        Self { parameter: parameter.to_owned(), value, expected: expected.into() }
    }
}

impl fmt::Display for ExportError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} = {}: expected {}", self.parameter, self.value, self.expected)
    }
}

impl std::error::Error for ExportError {}

impl From<luminaire::Error> for ExportError {
    fn from(error: luminaire::Error) -> Self {
        let told = error.to_string();
        // An error of the kernel reads `parameter = value: expected accepted`.
        let (parameter, rest) = told.split_once(" = ").unwrap_or(("light", &told));
        let (value, expected) = rest.split_once(": expected ").unwrap_or((rest, "a valid light"));
        Self::new(parameter, value, expected)
    }
}

/// Returns a text on one line, with the characters escaped that a terminal does not print: text of
/// a file steers no terminal and has no line of its own.
pub fn printable(text: &str) -> String {
    let escaped = |c: char| if is_printed(c) { c.to_string() } else { c.escape_debug().to_string() };
    text.chars().map(escaped).collect()
}

/// Returns JSON with the same characters escaped as JSON has them. Line ends stay.
pub(crate) fn printable_json(json: &str) -> String {
    let mut text = String::with_capacity(json.len());
    for c in json.chars() {
        if c == '\n' || is_printed(c) {
            text.push(c);
        } else {
            text.extend(c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")));
        }
    }
    text
}

fn is_printed(c: char) -> bool {
    matches!(c, '\'' | '"' | '\\') || c.escape_debug().count() == 1
}
