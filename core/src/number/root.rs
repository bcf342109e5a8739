//! Square roots of integers and their reciprocals, with multiplications and shifts only.

use super::product::{high_half, high_product, signed_high_product};

/// Values of `2^31 / sqrt(n)` at multiples of 2^25, from `n = 2^30` on, for linear interpolation.
///
/// Each value is lowered by half the largest deviation of the chord from the curve, so that the
/// largest positive and negative interpolation errors are equal.
pub(crate) const NODES: [u16; 129] = {
    let mut nodes = [0; 129];
    let mut node = 32;
    while node < nodes.len() {
        let with_12_bits_more = ((1 << 61) / node as u64).isqrt();
        let sag = 3 * with_12_bits_more / (64 * node * node) as u64;
        nodes[node] = ((with_12_bits_more - sag) >> 12) as u16;
        node += 1;
    }
    nodes
};

/// `floor(log2 n)` for each `n` of seven bits; 0 for zero.
const ILOG2: [u8; 128] = {
    let mut table = [0; 128];
    let mut number = 1;
    while number < table.len() {
        table[number] = number.ilog2() as u8;
        number += 1;
    }
    table
};

/// Whether the processor has an instruction that counts leading zeros.
///
/// Without that instruction, the table [`ILOG2`] is three times as fast as the compiler's routine.
/// Rust has no `cfg` for the instruction, so the constant tests for 32-bit atomics instead: the
/// small cores without the instruction lack compare-and-swap, too.
const COUNTS_ZEROS: bool = cfg!(target_has_atomic = "32");

/// Returns `floor(log2 n)` for `n` of seven bits; 0 for zero.
#[inline]
pub(super) const fn ilog2_of_seven_bits(n: u32) -> u32 {
    // With a larger `n` only the table gives a wrong result, and the processors that use the table
    // run few of the tests.
    debug_assert!(n < 128, "expected seven bits");
    if COUNTS_ZEROS { 31 - (n | 1).leading_zeros() } else { ILOG2[n as usize & 0x7f] as u32 }
}

/// Returns the bit length of `n`; 1 for zero.
#[inline]
pub(super) const fn bit_length(n: u32) -> u32 {
    if COUNTS_ZEROS { u32::BITS - (n | 1).leading_zeros() } else { looked_up_bit_length(n) }
}

#[inline]
const fn looked_up_bit_length(mut n: u32) -> u32 {
    let mut length = 1;
    while n >> 7 != 0 {
        n >>= 7;
        length += 7;
    }
    length + ILOG2[n as usize & 0x7f] as u32
}

/// Returns `2^31 / sqrt(n)` for `n >= 2^30`: 65,533 at `n = 2^30`, 32,768 at the largest `n`. For
/// `n = 0` the result is 0.
///
/// The function interpolates linearly between [`NODES`]. Its relative error is at most 6.0e-5
/// (exhaustive).
#[inline]
const fn guess(n: u32) -> u32 {
    let place = (n >> 25) as usize;
    let (here, next) = (NODES[place] as u32, NODES[place + 1] as u32);
    here.wrapping_sub((here.wrapping_sub(next).wrapping_mul((n << 7) >> 16)) >> 16)
}

/// Returns `2^30 / sqrt(n)` for `n >= 2^28`: 65,533 at `n = 2^28`, 16,384 at the largest `n`. For
/// `n = 0` the result is 0.
///
/// The relative error is at most 9.0e-5 (exhaustive).
#[inline]
pub(super) const fn inverse_sqrt_16(n: u32) -> u32 {
    if n >= 1 << 30 { (guess(n) + 1) >> 1 } else { guess(n << 2) }
}

/// Values of `2^30 / sqrt(n)` at multiples of 2^24, from `n = 2^28` on, for linear interpolation.
///
/// Each value is lowered like those of [`NODES`]. The upper bits of a squared length are the index,
/// without a case for the parity of the exponent. The first and the last values are not used.
const QUICK_NODES: [u16; 257] = {
    let mut nodes = [0; 257];
    let mut node = 16;
    while node < nodes.len() {
        let with_12_bits_more = ((1 << 60) / node as u64).isqrt();
        let sag = 3 * with_12_bits_more / (64 * node * node) as u64;
        let rounded = (with_12_bits_more - sag) >> 12;
        nodes[node] = if rounded < 1 << 16 { rounded as u16 } else { u16::MAX };
        node += 1;
    }
    nodes
};

/// Returns `2^30 / sqrt(n)` for `n >= 2^28`: 65,535 at `n = 2^28`, 16,384 at the largest `n`. For
/// `n = 0` the result is 0.
///
/// The function interpolates linearly, without a branch. Its relative error is at most 2.0e-4
/// (exhaustive).
#[inline]
pub(super) const fn quick_inverse_sqrt_16(n: u32) -> u32 {
    let place = (n >> 24) as usize;
    let (here, next) = (QUICK_NODES[place] as u32, QUICK_NODES[place + 1] as u32);
    here.wrapping_sub(here.wrapping_sub(next).wrapping_mul((n << 8) >> 16) >> 16)
}

/// Returns `2^63 / sqrt(n)` for `n >= 2^62`: 2^32 at `n = 2^62`, 2^31 at the largest `n`.
///
/// One step of Halley's method, which is of third order, refines the result of [`guess`] in 64-bit
/// products. The relative error is at most 4.7e-10, just over 2^-31 (exhaustive: only the upper 34
/// bits of `n` affect the result).
#[inline]
pub(super) const fn inverse_sqrt_32(n: u64) -> u64 {
    let seed = guess((n >> 32) as u32) as u64;
    let lack = 0_u64.wrapping_sub((n >> 30).wrapping_mul(seed * seed)) as i64 >> 24;
    let correction = lack / 2 + 3 * ((lack * lack) >> 40) / 8;
    (seed << 16).wrapping_add_signed((seed as i64 * correction) >> 24)
}

/// Returns `2^16 sqrt(n)`, with a relative error of at most 7.5e-9 and less than 2 units.
///
/// One step of Newton's method refines the product of `n` and [`guess`]. The largest result is
/// `u32::MAX`, and the result for zero is zero.
pub(super) fn sqrt_32(n: u32) -> u32 {
    // The shift is even, so that the root is shifted by half of it.
    let shift = (u32::BITS - bit_length(n)) & !1;
    let n = n << shift;
    let seed = guess(n);
    let root = high_product(n, seed).min((1 << 31) - 1) << 1;
    let lack = n.wrapping_sub(high_half(root, root)) as i32;
    root.saturating_add_signed(signed_high_product(lack, seed)) >> (shift / 2)
}

/// Returns `sqrt(n)`, with the relative error of [`sqrt_32`] and less than 2 units.
pub(super) fn sqrt_64(n: u64) -> u32 {
    let high = (n >> 32) as u32;
    if high == 0 {
        return sqrt_32(n as u32) >> 16;
    }
    let shift = (bit_length(high) + 1) & !1;
    sqrt_32((n >> shift) as u32) >> (16 - shift / 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    extern crate std;

    /// Returns the largest relative error of `inverse_sqrt_16` over inputs from 2^28 up, `stride`
    /// apart.
    fn worst_16(stride: usize) -> f64 {
        ((1_u32 << 28)..=u32::MAX)
            .step_by(stride)
            .map(|n| {
                let exact = 1_073_741_824.0 / f64::from(n).sqrt();
                (f64::from(inverse_sqrt_16(n)) / exact - 1.0).abs()
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn the_table_knows_every_bit_length() {
        assert_eq!(looked_up_bit_length(0), 1);
        for bits in 1..=u32::BITS {
            let (least, most) = (1 << (bits - 1), u32::MAX >> (u32::BITS - bits));
            assert_eq!((looked_up_bit_length(least), looked_up_bit_length(most)), (bits, bits));
        }
    }

    #[test]
    fn sixteen_bits_keep_their_stated_error() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 1 } else { 251 };
        let worst = worst_16(stride);
        assert!((4.0e-5..=9.0e-5).contains(&worst), "worst relative error {worst:e}");
    }

    /// Exhaustive in the upper 30 bits with `LUMINAIRE_FULL`.
    #[test]
    fn a_root_keeps_its_stated_error() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 4 } else { 997 };
        let error = |n: u64, found: u32| f64::from(found) / (n as f64).sqrt() - 1.0;
        let worst = ((1_u64 << 30)..1 << 32)
            .step_by(stride)
            .map(|n| error(n << 32, sqrt_32(n as u32)).abs().max(error(n << 32, sqrt_64(n << 32)).abs()))
            .fold(0.0, f64::max);
        assert!((4e-9..=7.5e-9).contains(&worst), "worst relative error {worst:e}");
        for bits in 0..64 {
            for n in [1, 3, 5, 0x9e37_79b9_7f4a_7c15].map(|n: u64| n.wrapping_shl(bits)) {
                let exact = (n as f64).sqrt();
                let off = (f64::from(sqrt_64(n)) - exact).abs();
                assert!(
                    off < 2.0 + 7.5e-9 * exact,
                    "root of {n}: off by {off}, expected under 2 + 7.5e-9 of {exact}"
                );
                let exact = f64::from(n as u32).sqrt() * 65_536.0;
                let off = (f64::from(sqrt_32(n as u32)) - exact).abs();
                assert!(
                    off < 2.0 + 7.5e-9 * exact,
                    "root of {n}: off by {off}, expected under 2 + 7.5e-9 of {exact}"
                );
            }
        }
        assert_eq!([sqrt_32(0), sqrt_64(0)], [0; 2]);
        assert!(sqrt_32(u32::MAX) > u32::MAX - 40 && sqrt_64(u64::MAX) > u32::MAX - 40);
    }

    /// Exhaustive with `LUMINAIRE_FULL`: every squared length of an offset of 15 bits, from the
    /// shortest to the longest.
    #[test]
    fn a_quick_root_keeps_its_stated_error() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 1 } else { 251 };
        let worst = ((1_u32 << 28)..3 << 30)
            .step_by(stride)
            .map(|n| {
                (f64::from(quick_inverse_sqrt_16(n)) * f64::from(n).sqrt() / 1_073_741_824.0 - 1.0).abs()
            })
            .fold(0.0, f64::max);
        assert!((1.5e-4..=2.0e-4).contains(&worst), "worst relative error {worst:e}");
        assert_eq!(quick_inverse_sqrt_16(0), 0);
    }

    /// Returns the largest relative error of `inverse_sqrt_32` over classes of inputs with the same
    /// result, `stride` apart. The function tests the first and the last input of each class.
    fn worst_32(stride: usize) -> f64 {
        ((1_u64 << 32)..1 << 34)
            .step_by(stride)
            .map(|class| {
                let (first, last) = (class << 30, (class << 30) + ((1 << 30) - 1));
                let found = inverse_sqrt_32(first) as f64 * 0.5_f64.powi(63);
                let error = |n: u64| (found * (n as f64).sqrt() - 1.0).abs();
                error(first).max(error(last))
            })
            .fold(0.0, f64::max)
    }

    /// No feature changes a result, so only the build with `std` runs the exhaustive test.
    #[test]
    fn thirty_two_bits_keep_their_stated_error() {
        let is_full = cfg!(feature = "std") && std::env::var_os("LUMINAIRE_FULL").is_some();
        let stride = if is_full { 1 } else { 4_099 };
        let worst = worst_32(stride);
        assert!((4.0e-10..=4.7e-10).contains(&worst), "worst relative error {worst:e}");
    }

    /// The first input of a class represents the class: bits below the upper 34 do not affect the
    /// result.
    #[test]
    fn thirty_two_bits_have_one_answer_for_a_class() {
        for class in ((1_u64 << 32)..1 << 34).step_by(65_537) {
            for low in [0, 1, 0x2aaa_aaaa, (1 << 30) - 1] {
                assert_eq!(inverse_sqrt_32((class << 30) + low), inverse_sqrt_32(class << 30), "{class:#x}");
            }
        }
    }
}
