//! Search algorithms for set-up.

/// Returns where a predicate that is true at `low` becomes false, within [`low`, `high`], to the
/// last place.
pub(crate) fn bisect(mut low: f32, mut high: f32, holds: impl Fn(f32) -> bool) -> f32 {
    for _ in 0..26 {
        let middle = (low + high) / 2.0;
        if holds(middle) { low = middle } else { high = middle }
    }
    (low + high) / 2.0
}

/// Returns the position of the minimum of a unimodal function, to 10^-4 of the interval.
pub(crate) fn least_at(mut low: f64, mut high: f64, mut value: impl FnMut(f64) -> f64) -> f64 {
    for _ in 0..23 {
        let third = (high - low) / 3.0;
        if value(low + third) < value(high - third) { high -= third } else { low += third }
    }
    (low + high) / 2.0
}

/// Returns the maximum of a function that may have many local maxima, none narrower than 1/256 of
/// the interval. Each local maximum is refined.
pub(crate) fn maximum(low: f64, high: f64, value: impl Fn(f64) -> f64) -> f64 {
    const STEPS: u32 = 512;
    let step = (high - low) / f64::from(STEPS);
    let at = |i: u32| low + step * f64::from(i);
    let (mut before, mut here) = (f64::NEG_INFINITY, value(low));
    let mut largest = here;
    for i in 0..STEPS {
        let after = value(at(i + 1));
        if here >= before && here >= after {
            let summit = least_at((at(i) - step).max(low), at(i + 1), |x| -value(x));
            largest = largest.max(value(summit)).max(here);
        }
        (before, here) = (here, after);
    }
    largest.max(here)
}
