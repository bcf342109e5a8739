//! Errors of drawing.

use crate::size::SizeError;
use core::fmt;
use luminaire::Error;

/// The reason why drawing failed. The message names the parameter, its value and the accepted
/// values.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum DrawError {
    /// A fixture that the format can't hold.
    Fixture(Error),
    /// A shadow map that does not fit into memory.
    ShadowMap(SizeError),
}

impl fmt::Display for DrawError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fixture(error) => error.fmt(f),
            Self::ShadowMap(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for DrawError {}

impl From<Error> for DrawError {
    fn from(error: Error) -> Self {
        Self::Fixture(error)
    }
}

impl From<SizeError> for DrawError {
    fn from(error: SizeError) -> Self {
        Self::ShadowMap(error)
    }
}
