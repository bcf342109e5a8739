//! The names in a file.

use super::expression::{Constant, Value};
use crate::name::global;

/// The names of a light's constants and functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Names<'a>(pub(crate) &'a str);

impl Names<'_> {
    /// Returns a name.
    pub(crate) fn of(&self, part: &str) -> String {
        global(self.0, part)
    }

    /// Returns a constant with a name.
    pub(crate) fn constant(&self, part: &str, doc: &'static str, value: Value) -> Constant {
        Constant { doc, name: self.of(part), value }
    }
}
