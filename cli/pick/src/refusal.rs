//! A refusal of a request.

use std::fmt;

use luminaire_export::ExportError;
use serde::Serialize;

/// A parameter with a value that cannot be accepted, and the accepted values.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Refusal {
    /// The parameter.
    pub parameter: String,
    /// The value of the parameter.
    pub value: String,
    /// The accepted values.
    pub expected: String,
}

impl Refusal {
    pub(crate) fn parameter(parameter: &str, value: String, expected: String) -> Self {
        Self { parameter: parameter.to_owned(), value, expected }
    }
}

impl From<luminaire::Error> for Refusal {
    fn from(error: luminaire::Error) -> Self {
        ExportError::from(error).into()
    }
}

impl From<ExportError> for Refusal {
    fn from(ExportError { parameter, value, expected }: ExportError) -> Self {
        Self { parameter, value, expected }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}: expected {}", self.parameter, self.value, self.expected)
    }
}

impl std::error::Error for Refusal {}
