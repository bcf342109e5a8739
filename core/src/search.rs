//! A search for set-up.

/// Returns the number in [`low`, `high`] at which a predicate changes from true to false.
///
/// The predicate is true at `low`. The result is accurate to the last place.
pub(crate) fn bisect(mut low: f32, mut high: f32, holds: impl Fn(f32) -> bool) -> f32 {
    for _ in 0..26 {
        let middle = (low + high) / 2.0;
        if holds(middle) { low = middle } else { high = middle }
    }
    (low + high) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bisection_ends_at_the_place() {
        for place in [0.25, 0.7, 1.0, 1.9] {
            let found = bisect(0.25, 1.9, |x| x < place);
            assert!((found - place).abs() <= 1.2e-7, "{found} for {place}");
        }
    }
}
