//! A light on its way into a source.

use luminaire::dynamic::AnyLight;

use crate::json::NamedLight;

/// A light of a source.
pub(crate) struct Item<'a> {
    pub(crate) name: &'a str,
    pub(crate) light: AnyLight,
    /// Its text, without what all lights of a program share.
    pub(crate) text: String,
}

impl Item<'_> {
    pub(crate) fn named(&self) -> NamedLight {
        NamedLight { name: self.name.to_owned(), light: self.light, surfaces: None, about: None }
    }
}
