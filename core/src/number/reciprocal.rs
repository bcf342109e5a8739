//! Reciprocals of integers, with multiplications and shifts only.

use super::product::{high_product, signed_high_product};

/// Returns `2^31 / m` for `m` in `[2^15, 2^16)`: 65,535 at `m = 2^15`, never more.
///
/// The relative error is at most 5.6e-5 (exhaustive).
///
/// Two Newton steps in 32-bit products refine the straight line `48/17 - 32/17 m`, where `m` is
/// scaled to `[1/2, 1)`.
#[inline]
pub(super) const fn quick_inverse_16(m: u32) -> u32 {
    let mut inverse = (92_521 - ((61_681 * m) >> 16)) as i32;
    let mut step = 0;
    while step < 2 {
        let lack = (1_u32 << 31).wrapping_sub(inverse as u32 * m) as i32;
        inverse += (inverse * (lack >> 15)) >> 16;
        step += 1;
    }
    inverse as u32
}

/// Returns `2^31 / m` for `m` in `[2^15, 2^16)`: 65,536 at `m = 2^15`, just over 32,768 at the
/// largest `m`.
///
/// One more Newton step refines the result of [`quick_inverse_16`]. The error is at most 0.501
/// units of the result, and 0 at `m = 2^15` (exhaustive).
#[inline]
pub(super) const fn inverse_16(m: u32) -> u32 {
    let inverse = quick_inverse_16(m) as i32;
    let lack = (1_u32 << 31).wrapping_sub(inverse as u32 * m) as i32;
    (inverse + ((inverse * (lack >> 4) + (1 << 26)) >> 27)) as u32
}

/// Returns `2^55 / m` for `m` in `[2^27, 2^28)`: 2^28 at `m = 2^27`, just over 2^27 at the largest
/// `m`.
///
/// One Newton step in 64-bit products refines the result of [`inverse_16`]. The error is at most
/// 0.9 units of the result, and 0 at `m = 2^27` (exhaustive).
#[inline]
pub(super) const fn inverse_28(m: u32) -> u32 {
    let seed = (inverse_16(m >> 12) as i64) << 12;
    let lack = (1_i64 << 55) - seed * m as i64;
    (seed + ((seed * (lack >> 8) + (1 << 46)) >> 47)) as u32
}

/// Returns `2^63 / m`, rounded down, for `m >= 2^31`; `u32::MAX` for `m = 2^31`.
///
/// One step of Halley's method, which is of third order, refines the result of
/// [`quick_inverse_16`] to at most 6 units below the exact result; the remainder corrects it.
pub(super) fn inverse_32(m: u32) -> u32 {
    /// Largest amount by which the refined result is above the exact one.
    const ABOVE: u32 = 3;
    /// Largest amount by which the reduced result is below the exact one.
    const BELOW: u32 = 6;
    let seed = quick_inverse_16(m >> 16);
    // `1 - seed m / 2^47`, with 31 fraction bits.
    let lack = (1_u32 << 31).wrapping_sub(high_product(m, seed)) as i32;
    let eighth = lack >> 3;
    let correction = lack + (eighth.wrapping_mul(eighth) >> 25);
    let refined = (seed << 16).saturating_add_signed(signed_high_product(correction << 1, seed));
    let mut inverse = refined.saturating_sub(ABOVE);
    let m = u64::from(m);
    let mut rest = (1_u64 << 63).wrapping_sub(u64::from(inverse) * m);
    for _ in 0..BELOW {
        if rest >= m {
            rest -= m;
            inverse = inverse.saturating_add(1);
        }
    }
    inverse
}

#[cfg(test)]
mod tests {
    use super::*;

    extern crate std;

    #[test]
    fn two_steps_keep_their_stated_error() {
        let worst = (1_u32 << 15..1 << 16)
            .map(|m| (f64::from(quick_inverse_16(m)) * f64::from(m) / 2_147_483_648.0 - 1.0).abs())
            .fold(0.0, f64::max);
        assert!((5e-5..=5.6e-5).contains(&worst), "worst error {worst}");
        assert_eq!((1 << 15..1 << 16).map(quick_inverse_16).max(), Some(65_535));
    }

    #[test]
    fn sixteen_bits_keep_their_stated_error() {
        let worst = (1_u32 << 15..1 << 16)
            .map(|m| (f64::from(inverse_16(m)) - 2_147_483_648.0 / f64::from(m)).abs())
            .fold(0.0, f64::max);
        assert!((0.5..=0.501).contains(&worst), "worst error {worst}");
        assert_eq!(inverse_16(1 << 15), 1 << 16);
    }

    #[test]
    fn twenty_eight_bits_keep_their_stated_error() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 1 } else { 97 };
        let worst = (1_u32 << 27..1 << 28)
            .step_by(stride)
            .map(|m| (f64::from(inverse_28(m)) - 36_028_797_018_963_968.0 / f64::from(m)).abs())
            .fold(0.0, f64::max);
        assert!((0.5..=0.9).contains(&worst), "worst error {worst}");
        assert_eq!(inverse_28(1 << 27), 1 << 28);
    }

    /// Exhaustive in the upper 28 bits with `LUMINAIRE_FULL`.
    #[test]
    fn thirty_two_bits_are_those_of_the_division() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 15 } else { 1_009 };
        let last = u32::MAX - 100_000..=u32::MAX;
        for m in (1_u32 << 31..=u32::MAX).step_by(stride).chain(1 << 31..(1 << 31) + 100_000).chain(last) {
            let exact = ((1_u64 << 63) / u64::from(m)).min(u32::MAX.into()) as u32;
            assert_eq!(inverse_32(m), exact, "{m}");
        }
    }
}
