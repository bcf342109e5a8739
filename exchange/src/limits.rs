//! Limits, and what decimal rounding carries across them.

/// Returns a value between two limits. A value beyond a limit by at most a millionth of it, such as pi with
/// six decimals or a right angle from an `f32`, becomes the limit.
pub(crate) fn within(value: f64, least: f64, most: f64) -> Option<f64> {
    let is_near = |limit: &f64| (value - limit).abs() <= 1e-6 * limit.abs();
    match (least..=most).contains(&value) {
        true => Some(value),
        false => [most, least].into_iter().find(is_near),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn within_clamps_a_millionth_beyond_a_limit_and_no_more() {
        for limit in [std::f64::consts::PI, 90.0, 180.0] {
            assert_eq!(within(limit * (1.0 + 0.99e-6), 0.0, limit), Some(limit));
            assert_eq!(within(limit * (1.0 + 1.01e-6), 0.0, limit), None);
            assert_eq!(within(-limit * (1.0 + 0.99e-6), -limit, 0.0), Some(-limit));
        }
        assert_eq!([within(0.5, 0.0, 1.0), within(-1e-12, 0.0, 1.0)], [Some(0.5), None]);
        assert_eq!(within(f64::NAN, 0.0, 1.0), None);
    }
}
