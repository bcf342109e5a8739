//! Gauss-Legendre quadrature with five nodes, exact for polynomials up to degree nine.

/// The nodes in the interval `[-1, 1]`: the middle, and for each other entry the pair `±entry`.
///
/// With fewer nodes the error would be visible in a cone of 180 degrees.
const PLACES: [f32; 3] = [0.0, 0.538_469_3, 0.906_179_85];

/// The weights of the nodes; the weights of all five nodes sum to 2.
const WEIGHTS: [f32; 3] = [0.568_888_9, 0.478_628_67, 0.236_926_88];

/// The number of nodes.
pub(super) const NODES: usize = 5;

/// Returns the integral of a function between two limits; zero unless `from < to`.
#[inline(always)] // Turntable in haze on x86-64: twice the instructions without.
pub(super) fn integrate(from: f32, to: f32, value: impl Fn(f32) -> f32) -> f32 {
    weighed(from, to, nodes(from, to).map(value))
}

/// Returns the nodes between two limits.
#[inline(always)]
pub(super) fn nodes(from: f32, to: f32) -> [f32; NODES] {
    let (half, middle) = (0.5 * (to - from), 0.5 * (from + to));
    let [one, two] = [half * PLACES[1], half * PLACES[2]];
    [middle, middle - one, middle + one, middle - two, middle + two]
}

/// Returns the integral of a function with these values at the [`nodes`].
#[inline(always)]
pub(super) fn weighed(from: f32, to: f32, [middle, a, b, c, d]: [f32; NODES]) -> f32 {
    let half = 0.5 * (to - from);
    let sum = WEIGHTS[0] * middle + (WEIGHTS[1] * (a + b) + WEIGHTS[2] * (c + d));
    if half > 0.0 { half * sum } else { 0.0 }
}

/// Returns the integral by three nodes, which are exact for polynomials up to degree five.
#[inline(always)]
pub(super) fn integrate_short(from: f32, to: f32, value: impl Fn(f32) -> f32) -> f32 {
    let (half, middle) = (0.5 * (to - from), 0.5 * (from + to));
    let place = 0.774_596_7 * half;
    let pair = value(middle - place) + value(middle + place);
    let sum = (8.0 / 9.0) * value(middle) + (5.0 / 9.0) * pair;
    if half > 0.0 { half * sum } else { 0.0 }
}

/// Returns the integrand over `v`, at distance 1: `2 / (1 + v^2)` times the intensity.
///
/// The argument of `intensity` is `1 / (1 + v^2)`.
#[inline]
pub(super) fn by_angle(v: f32, intensity: impl Fn(f32) -> f32) -> f32 {
    let share = 1.0 / (1.0 + v * v);
    2.0 * share * intensity(share)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integral is exact for polynomials up to degree nine, but not for degree ten.
    #[test]
    fn the_rule_is_exact_up_to_its_degree_and_no_further() {
        let error = |degree: i32| {
            let at = |i: usize, side: f64| {
                f64::from(WEIGHTS[i]) / 2.0 * (side * f64::from(PLACES[i])).powi(degree)
            };
            let sum: f64 = (0..3).map(|i| (at(i, 1.0) + at(i, -1.0)) * if i == 0 { 1.0 } else { 2.0 }).sum();
            let exact = if degree % 2 == 0 { 2.0 / f64::from(degree + 1) } else { 0.0 };
            (sum - exact).abs()
        };
        assert!((0..10).map(error).fold(0.0, f64::max) < 2e-7);
        assert!(error(10) > 1e-3);
    }

    #[test]
    fn an_interval_that_is_turned_around_is_empty() {
        assert_eq!(integrate(1.0, 0.5, |_| 1.0), 0.0);
        assert!((integrate(0.5, 1.0, |_| 1.0) - 0.5).abs() < 1e-6);
    }
}
