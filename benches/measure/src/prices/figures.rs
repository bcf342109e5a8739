//! Numbers for people.

/// Formats an error with two significant digits, or as an integer from 10 on.
pub(super) fn error(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if value >= 9.95 => format!("{value:.0}"),
        value if value >= 0.995 => format!("{value:.1}"),
        value if value >= 0.0995 => format!("{value:.2}"),
        value if value >= 0.009_95 => format!("{value:.3}"),
        value => format!("{value:.1e}"),
    }
}

/// Formats a cost with three significant digits, or as an integer from 100 on.
pub(super) fn cost(value: f64) -> String {
    match value {
        value if value >= 99.95 => format!("{value:.0}"),
        value if value >= 9.995 => format!("{value:.1}"),
        value => format!("{value:.2}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_short() {
        let errors = [0.0, 3.098e-7, 0.0241, 0.155, 0.9275, 1.6, 50.51].map(error);
        assert_eq!(errors, ["0", "3.1e-7", "0.024", "0.15", "0.93", "1.6", "51"]);
        assert_eq!([0.126, 20.066, 132.1, 10260.94].map(cost), ["0.13", "20.1", "132", "10261"]);
    }
}
