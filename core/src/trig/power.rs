//! Real powers in f64, for set-up.

use super::sqrt;

/// Returns `base^exponent` for real `base >= 0` and `exponent >= 0`, with a relative error under
/// 1e-9. Used at set-up only.
///
/// The function uses repeated squaring for the integer part of the exponent, and square roots for
/// 40 binary digits of the exponent's fraction.
pub(crate) fn real_power(base: f64, exponent: f64) -> f64 {
    let whole = exponent as u32;
    let mut power = 1.0;
    for digit in (0..32 - whole.leading_zeros()).rev() {
        power *= power;
        if whole >> digit & 1 == 1 {
            power *= base;
        }
    }
    let (mut root, mut rest) = (base, exponent - f64::from(whole));
    for _ in 0..40 {
        root = square_root(root);
        rest *= 2.0;
        if rest >= 1.0 {
            power *= root;
            rest -= 1.0;
        }
    }
    power
}

/// Returns the square root in f64: the f32 root, refined by one Newton step.
pub(crate) fn square_root(x: f64) -> f64 {
    let root = f64::from(sqrt(x as f32));
    if root > 0.0 { (root + x / root) / 2.0 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    extern crate std;

    #[test]
    fn real_powers_keep_their_stated_error() {
        let worst = (1..400_u16)
            .flat_map(|i| (0..200_u16).map(move |j| (f64::from(i) / 13.0, f64::from(j) / 17.3)))
            .map(|(base, exponent)| (real_power(base, exponent) / base.powf(exponent) - 1.0).abs())
            .fold(0.0, f64::max);
        assert!((1e-14..=1e-9).contains(&worst), "largest relative error {worst:.2e}");
        assert_eq!([0.0, 0.5, 3.25].map(|exponent| real_power(0.0, exponent)), [1.0, 0.0, 0.0]);
    }
}
