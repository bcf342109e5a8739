//! The edges that a visitor can choose: the falloffs of the library, by name.

use crate::{model::Chosen, refusal::Refusal};
use luminaire::falloff::AnyFalloff;

/// The name of the edge that a beam angle and a field angle determine together.
pub(crate) const FITTED: &str = "fitted";

/// Returns the falloff of this name; `None` for the light's own edge.
pub(crate) fn chosen(name: &str) -> Result<Option<AnyFalloff>, Refusal> {
    if name == "own" {
        return Ok(None);
    }
    let expected = "own, fitted or a falloff of the list";
    AnyFalloff::named(name).map(Some).ok_or_else(|| Refusal::name("edge", name, expected))
}
