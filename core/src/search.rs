//! The one way in which set-up searches.

/// Where a predicate that is true from `low` on becomes false, within [`low`, `high`], to the last place.
pub(crate) fn bisect(mut low: f32, mut high: f32, holds: impl Fn(f32) -> bool) -> f32 {
    for _ in 0..26 {
        let middle = (low + high) / 2.0;
        if holds(middle) { low = middle } else { high = middle }
    }
    (low + high) / 2.0
}
