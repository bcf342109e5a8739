//! Search algorithms for set-up.

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

/// Returns the position of the minimum of a unimodal function, within 10^-4 of the interval's
/// length.
pub(crate) fn least_at(mut low: f64, mut high: f64, mut value: impl FnMut(f64) -> f64) -> f64 {
    for _ in 0..23 {
        let third = (high - low) / 3.0;
        if value(low + third) < value(high - third) { high -= third } else { low += third }
    }
    (low + high) / 2.0
}

/// Returns the maximum of a function that may have many local maxima.
///
/// No local maximum may be narrower than 1/256 of the interval. The search refines each local
/// maximum.
pub(crate) fn maximum(low: f64, high: f64, value: impl Fn(f64) -> f64) -> f64 {
    const STEPS: u32 = 512;
    let step = (high - low) / f64::from(STEPS);
    let at = |i: u32| low + step * f64::from(i);
    let (mut before, mut here) = (f64::NEG_INFINITY, value(low));
    let mut largest = here;
    for i in 0..=STEPS {
        let after = if i < STEPS { value(at(i + 1)) } else { f64::NEG_INFINITY };
        if here >= before && here >= after {
            let summit = least_at((at(i) - step).max(low), (at(i) + step).min(high), |x| -value(x));
            largest = largest.max(value(summit)).max(here);
        }
        (before, here) = (here, after);
    }
    largest
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

    #[test]
    fn a_minimum_is_found_to_its_stated_share_of_the_interval() {
        for place in [-3.0, -2.999, 0.1, 4.5, 7.0] {
            let found = least_at(-3.0, 7.0, |x| (x - place) * (x - place));
            assert!((found - place).abs() <= 1e-4 * 10.0, "{found} for {place}");
        }
    }

    /// Finds narrow maxima at any position: at both ends of the interval, and the largest of
    /// several.
    #[test]
    fn a_maximum_is_found_wherever_it_is() {
        for place in [2.0, 2.0001, 2.000_9, 2.47, 2.999, 2.999_1, 3.0] {
            let hat = |x: f64, place: f64| 1.0 - 100.0 * (x - place) * (x - place);
            let found = maximum(2.0, 3.0, |x| hat(x, place).max(hat(x, 2.2) - 0.5));
            assert!(
                (1.0 - 1e-6..=1.0).contains(&found),
                "{found} at {place}, expected found in 1.0 - 1e-6..=1.0"
            );
        }
    }

    /// A search evaluates the function only in the interval: outside, the function may be larger or
    /// undefined.
    #[test]
    fn a_search_stays_in_its_interval() {
        for slope in [-1.0, 0.0, 1.0] {
            let within = |x: f64| {
                assert!((2.0..=3.0).contains(&x), "{x}, expected x in 2.0..=3.0");
                slope * x
            };
            assert_eq!(maximum(2.0, 3.0, within), (2.0 * slope).max(3.0 * slope));
            least_at(2.0, 3.0, within);
        }
    }
}
