//! Stage fixtures for the page and for addresses.

use crate::plain::plain;
use luminaire_fixtures::{FIXTURES, Fixture};

plain! {
    /// A stage fixture: see [`Fixture`].
    fn state(fixture: &Fixture) -> FixtureState {
        "name": "string" = fixture.name,
        "kind": "string" = fixture.kind.name(),
        "narrow": "number" = fixture.narrowest,
        "wide": "number" = fixture.widest,
        "lumens": "number | undefined" = fixture.lumens,
    }
}

/// Returns the fixture of this name.
pub(crate) fn find(name: &str) -> Option<&'static Fixture> {
    FIXTURES.iter().find(|fixture| fixture.name == name)
}

/// Returns the initial angle of a fixture: the middle of its zoom range.
pub(crate) fn middle(fixture: &Fixture) -> f32 {
    fixture.narrowest.midpoint(fixture.widest)
}

/// Returns the range of the zoom in degrees. Its least angle is at least a hundredth of the largest.
pub(crate) fn zooms(fixture: &Fixture) -> [f32; 2] {
    [fixture.narrowest.max(0.01 * fixture.widest), fixture.widest]
}

/// Returns the name in an address: lower-case letters, digits and hyphens.
pub(crate) fn slug(fixture: &Fixture) -> String {
    let plain: String = fixture
        .name
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' })
        .collect();
    plain.split('-').filter(|word| !word.is_empty()).collect::<Vec<_>>().join("-")
}

/// Returns the fixture with this [`slug`].
pub(crate) fn with_slug(name: &str) -> Option<&'static Fixture> {
    FIXTURES.iter().find(|fixture| slug(fixture) == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_fixture_is_found_by_its_name_and_by_its_slug() {
        for fixture in FIXTURES {
            assert_eq!(find(fixture.name), Some(fixture));
            assert_eq!(with_slug(&slug(fixture)), Some(fixture), "two fixtures are {}", slug(fixture));
            assert!(middle(fixture) > 0.0, "{}", fixture.name);
        }
        assert_eq!(find("Nobody's lamp"), None);
        assert_eq!(with_slug(""), None);
    }
}
