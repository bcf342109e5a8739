//! The edges that a visitor can choose: the falloffs of the library, by name.

use crate::refusal::Refusal;
use luminaire::falloff::AnyFalloff;

/// The name of the edge that a beam angle and a field angle determine together.
pub(crate) const FITTED: &str = "fitted";

/// Returns one of each kind of falloff, as the library's list has them.
pub(crate) fn all() -> impl Iterator<Item = AnyFalloff> {
    AnyFalloff::samples()
}

/// Returns the falloff of this name.
pub(crate) fn named(name: &str) -> Option<AnyFalloff> {
    all().find(|falloff| falloff.effect().name() == name)
}

/// Returns the falloff of this name; `None` for the light's own edge.
pub(crate) fn chosen(name: &str) -> Result<Option<AnyFalloff>, Refusal> {
    if name == "own" {
        return Ok(None);
    }
    named(name).map(Some).ok_or_else(|| Refusal::name("edge", name, "own, fitted or a falloff of the list"))
}
