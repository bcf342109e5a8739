//! Integers without a division: upper halves of products, bit lengths, square roots and reciprocals.
//!
//! | function | result | relative error (exhaustive) |
//! |---|---|---|
//! | [`inverse_sqrt_16`] | `1 / sqrt(n)`, 15 or 16 bits: the root of `Fx16` | 9.0e-5 |
//! | [`quick_inverse_sqrt_16`] | the same from a larger table: the root of `Fx32` and of the quick evaluation | 2.0e-4 |
//! | [`inverse_sqrt_32`] | `1 / sqrt(n)`, 32 bits: axes of `Fx32` | 4.7e-10 |
//! | [`sqrt_32`], [`sqrt_64`] | `sqrt(n)`: chords of a cone that zooms | 7.5e-9 |
//! | [`quick_inverse_16`], [`inverse_16`] | `1 / m`, 16 bits | 5.6e-5; 0.501 units |
//! | [`inverse_28`], [`inverse_32`] | `1 / m`, 28 and 32 bits | 0.9 units; none |

use crate::vec3::Vec3;

/// Whether the processor has an instruction for the upper half of a product.
///
/// Stable Rust shows to crates the features of a RISC-V, but not those of an Arm. There 32-bit atomics
/// stand for the instructions of Armv7-M: the Cortex-M0 lacks both. The Cortex-M23, which has the
/// atomics alone, takes the compiler's routines.
const HAS_HIGH_HALVES: bool = !cfg!(any(
    all(any(target_arch = "riscv32", target_arch = "riscv64"), not(target_feature = "m")),
    all(target_arch = "arm", not(target_has_atomic = "32")),
));

/// Returns `a b / 2^16` for `b` of 16 bits, rounded down.
#[inline]
pub(crate) fn high_product(a: u32, b: u32) -> u32 {
    if HAS_HIGH_HALVES { high_half(a, b << 16) } else { high_product_by_parts(a, b) }
}

/// Returns the result of [`high_product`], computed from two products of 16-bit numbers.
#[inline]
fn high_product_by_parts(a: u32, b: u32) -> u32 {
    (a >> 16) * b + (((a & 0xffff) * b) >> 16)
}

/// Returns `a b / 2^16` for a signed `a` and `b` of 16 bits, rounded down.
#[inline]
pub(crate) fn signed_high_product(a: i32, b: u32) -> i32 {
    if HAS_HIGH_HALVES {
        ((i64::from(a) * i64::from(b << 16)) >> 32) as i32
    } else {
        signed_high_product_by_parts(a, b)
    }
}

/// Returns the result of [`signed_high_product`], computed from two products of 16-bit numbers.
#[inline]
fn signed_high_product_by_parts(a: i32, b: u32) -> i32 {
    let low = ((a as u32 & 0xffff) * b) >> 16;
    (a >> 16).wrapping_mul(b as i32).wrapping_add(low as i32)
}

/// Returns `a b / 2^32`, rounded down exactly. So the result is monotone in both factors.
#[inline(always)] // `lit-step` on Cortex-M0: +38 instructions without.
pub(crate) fn high_half(a: u32, b: u32) -> u32 {
    if HAS_HIGH_HALVES { ((u64::from(a) * u64::from(b)) >> 32) as u32 } else { high_half_by_parts(a, b) }
}

/// Returns the result of [`high_half`], computed from four products of 16-bit numbers.
///
/// Without the black box, the compiler would recognise the sums as a 64-bit product and compute
/// that product, with twice as many instructions on a processor without a 64-bit product.
#[inline(always)]
fn high_half_by_parts(a: u32, b: u32) -> u32 {
    let ([ah, bh], [al, bl]) = ([a >> 16, b >> 16], [a & 0xffff, b & 0xffff]);
    let upper = core::hint::black_box(ah * bl);
    // The sum is at most `65_535^2 + 65_535 + 65_534`, which is `2^32 - 2`.
    let middle = al * bh + (upper & 0xffff) + ((al * bl) >> 16);
    ah * bh + (upper >> 16) + (middle >> 16)
}

/// Returns `a b / 2^32` for numbers of 30 bits and a sign, rounded down. `b` may have 31 bits if
/// its lower 16 bits are zero.
#[inline]
pub(crate) fn signed_high_half(a: i32, b: i32) -> i32 {
    if HAS_HIGH_HALVES {
        ((i64::from(a) * i64::from(b)) >> 32) as i32
    } else {
        signed_high_half_by_parts(a, b)
    }
}

/// Returns the result of [`signed_high_half`], computed from four products of 16-bit numbers.
#[inline]
fn signed_high_half_by_parts(a: i32, b: i32) -> i32 {
    let ([ah, bh], [al, bl]) = ([a >> 16, b >> 16], [a & 0xffff, b & 0xffff]);
    let low = (al as u32).wrapping_mul(bl as u32) >> 16;
    let middle = ah.wrapping_mul(bl).wrapping_add(al.wrapping_mul(bh)).wrapping_add(low as i32);
    ah.wrapping_mul(bh).wrapping_add(middle >> 16)
}

/// Returns `a^2 / 2^32` for a number of 31 bits and a sign, rounded down.
#[inline]
pub(crate) fn high_square(a: i32) -> u32 {
    if HAS_HIGH_HALVES { ((i64::from(a) * i64::from(a)) >> 32) as u32 } else { high_square_by_parts(a) }
}

/// Returns the result of [`high_square`], computed from three products of 16-bit numbers.
#[inline]
fn high_square_by_parts(a: i32) -> u32 {
    let (high, low) = (a >> 16, a & 0xffff);
    let low_squared = (low as u32).wrapping_mul(low as u32) >> 17;
    let middle = high.wrapping_mul(low).wrapping_add(low_squared as i32);
    high.wrapping_mul(high).wrapping_add(middle >> 15) as u32
}

/// Returns the product in 64 bits.
#[inline]
pub(super) fn wide(a: i32, b: i32) -> i64 {
    i64::from(a) * i64::from(b)
}

/// Returns `|v|^2`. The sum of the squares of three numbers with 15 bits and a sign fits 32 bits; those of
/// larger ones wrap.
#[inline]
pub(super) fn squared_length(v: Vec3<i32>) -> u32 {
    let squares = v.map(|c| c.wrapping_mul(c) as u32);
    squares.x.wrapping_add(squares.y).wrapping_add(squares.z)
}

/// Returns a number with the bit length of the largest component.
///
/// A negative component `c` counts as `-1 - c`.
#[inline]
pub(crate) fn size(way: Vec3<i32>) -> u32 {
    let magnitudes = way.map(|c| (c ^ (c >> 31)) as u32);
    magnitudes.x | magnitudes.y | magnitudes.z
}

/// Values of `2^31 / sqrt(n)` at multiples of 2^25, from `n = 2^30` on, for linear interpolation.
///
/// Each value is lowered by half the largest deviation of the chord from the curve, so that the
/// largest positive and negative interpolation errors are equal. With a node every `h`, the chord is above the
/// convex curve `f = n^(-1/2)` by at most `h^2 f'' / 8`, in the middle between two nodes, and `f'' = 3/4 n^(-5/2)`. At
/// `n = node h`, half of that is `3 f / (64 node^2)`: the `sag` below.
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

/// Whether the processor has an instruction that counts leading zeros, known as that of
/// [`HAS_HIGH_HALVES`] is.
///
/// Without that instruction, the table [`ILOG2`] is three times as fast as the compiler's routine.
const COUNTS_ZEROS: bool = cfg!(any(
    target_feature = "zbb",
    all(target_has_atomic = "32", not(any(target_arch = "riscv32", target_arch = "riscv64"))),
));

/// Returns `floor(log2 n)` for `n` of seven bits; 0 for zero.
#[inline]
pub(crate) const fn ilog2_of_seven_bits(n: u32) -> u32 {
    // With a larger `n` only the table gives a wrong result, and the processors that use the table
    // run few of the tests.
    debug_assert!(n < 128, "expected seven bits");
    if COUNTS_ZEROS { 31 - (n | 1).leading_zeros() } else { ILOG2[n as usize & 0x7f] as u32 }
}

/// Returns the bit length of `n`; 1 for zero.
#[inline]
pub(crate) const fn bit_length(n: u32) -> u32 {
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
    interpolated(here, here.wrapping_sub(next), n)
}

/// Returns the result of [`guess`] from the node below `n` and its difference to the next node.
#[inline]
pub(crate) const fn interpolated(node: u32, difference: u32, n: u32) -> u32 {
    node.wrapping_sub(difference.wrapping_mul((n << 7) >> 16) >> 16)
}

/// Returns `2^30 / sqrt(n)` for `n >= 2^28`: 65,533 at `n = 2^28`, 16,384 at the largest `n`. For
/// `n = 0` the result is 0.
///
/// The relative error is at most 9.0e-5 (exhaustive).
#[inline]
pub(crate) const fn inverse_sqrt_16(n: u32) -> u32 {
    if n >= 1 << 30 { (guess(n) + 1) >> 1 } else { guess(n << 2) }
}

/// Values of `2^30 / sqrt(n)` at multiples of 2^24, from `n = 2^28` on, for linear interpolation.
///
/// Each value is lowered like those of [`NODES`]. The upper bits of a squared length are the index,
/// without a case for the parity of the exponent. The first and the last values are not used.
pub(crate) const QUICK_NODES: [u16; 257] = {
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
pub(crate) const fn quick_inverse_sqrt_16(n: u32) -> u32 {
    let place = (n >> 24) as usize;
    let (here, next) = (QUICK_NODES[place] as u32, QUICK_NODES[place + 1] as u32);
    interpolated_quickly(here, here.wrapping_sub(next), n)
}

/// Returns the result of [`quick_inverse_sqrt_16`] from the node below `n` and its difference to the next node.
#[inline]
pub(crate) const fn interpolated_quickly(node: u32, difference: u32, n: u32) -> u32 {
    node.wrapping_sub(difference.wrapping_mul((n << 8) >> 16) >> 16)
}

/// Returns `2^63 / sqrt(n)` for `n >= 2^62`: 2^32 at `n = 2^62`, 2^31 at the largest `n`.
///
/// One step of Halley's method, which is of third order, refines the result of [`guess`] in 64-bit
/// products. The relative error is at most 4.7e-10, just over 2^-31 (exhaustive: only the upper 34
/// bits of `n` affect the result).
///
/// With a guess `y` and what `n y^2` lacks to 1, `e = 1 - n y^2`, the root is
/// `n^(-1/2) = y (1 - e)^(-1/2) = y (1 + e/2 + 3/8 e^2 + 5/16 e^3 + ..)`. A guess is off by at most 6.0e-5, so that `e` is
/// at most 1.2e-4: the terms from `e^3` on, 5.4e-13, are lost in the rounding. Newton's method, the first two terms,
/// would leave `3/8 e^2`, 5.4e-9.
#[inline]
pub(crate) const fn inverse_sqrt_32(n: u64) -> u64 {
    let seed = guess((n >> 32) as u32) as u64;
    let lack = 0_u64.wrapping_sub((n >> 30).wrapping_mul(seed * seed)) as i64 >> 24;
    let correction = lack / 2 + 3 * ((lack * lack) >> 40) / 8;
    (seed << 16).wrapping_add_signed((seed as i64 * correction) >> 24)
}

/// Returns `2^16 sqrt(n)`, with a relative error of at most 7.5e-9 and less than 2 units.
///
/// One step of Newton's method refines the product of `n` and [`guess`]: with a guess `y` of `n^(-1/2)` and the root
/// `s = n y`, it is `s + (n - s^2) y / 2`. A guess with the relative error `d` leaves `3/2 d^2` beside the
/// rounding. The largest result is `u32::MAX`, and the result for zero is zero.
pub(crate) fn sqrt_32(n: u32) -> u32 {
    // The shift is even, so that the root is shifted by half of it.
    let shift = (u32::BITS - bit_length(n)) & !1;
    let n = n << shift;
    let seed = guess(n);
    let root = high_product(n, seed).min((1 << 31) - 1) << 1;
    let lack = n.wrapping_sub(high_half(root, root)) as i32;
    root.saturating_add_signed(signed_high_product(lack, seed)) >> (shift / 2)
}

/// Returns `sqrt(n)`, with the relative error of [`sqrt_32`] and less than 2 units.
pub(crate) fn sqrt_64(n: u64) -> u32 {
    let high = (n >> 32) as u32;
    if high == 0 {
        return sqrt_32(n as u32) >> 16;
    }
    let shift = (bit_length(high) + 1) & !1;
    sqrt_32((n >> shift) as u32) >> (16 - shift / 2)
}

/// Returns `2^31 / m` for `m` in `[2^15, 2^16)`: 65,535 at `m = 2^15`, never more.
///
/// The relative error is at most 5.6e-5 (exhaustive).
///
/// Two Newton steps in 32-bit products refine the straight line `48/17 - 32/17 m`, where `m` is
/// scaled to `[1/2, 1)`.
#[inline]
pub(crate) const fn quick_inverse_16(m: u32) -> u32 {
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
pub(crate) const fn inverse_16(m: u32) -> u32 {
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
pub(crate) const fn inverse_28(m: u32) -> u32 {
    let seed = (inverse_16(m >> 12) as i64) << 12;
    let lack = (1_i64 << 55) - seed * m as i64;
    (seed + ((seed * (lack >> 8) + (1 << 46)) >> 47)) as u32
}

/// Returns `2^63 / m`, rounded down, for `m >= 2^31`; `u32::MAX` for `m = 2^31`.
///
/// One step of Halley's method, which is of third order, refines the result of
/// [`quick_inverse_16`] to at most 6 units below the exact result; the remainder corrects it. With a guess `y` and
/// `e = 1 - m y`, the reciprocal is `y / (1 - e) = y (1 + e + e^2 + ..)`; what is left out, `e^3`, is at most 1.8e-13.
pub(crate) fn inverse_32(m: u32) -> u32 {
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

    /// Multiplies numbers next to all powers of two, and their complements, by each other.
    #[test]
    fn upper_bits_are_those_of_the_product() {
        let numbers =
            || (0..32).flat_map(|shift| [-1, 0, 1].map(|i| (1_u32 << shift).wrapping_add_signed(i)));
        let numbers = || numbers().flat_map(|n| [n, !n, n.wrapping_mul(0x9e37_79b9)]);
        let signed = |bits: u32| numbers().map(move |n| n as i32 >> (31 - bits));
        for (a, b) in numbers().flat_map(|a| numbers().map(move |b| (a, b))) {
            let exact = u64::from(a) * u64::from(b);
            assert_eq!([high_half(a, b), high_half_by_parts(a, b)], [(exact >> 32) as u32; 2], "{a} {b}");
            let (b, signed) = (b & 0xffff, a as i32);
            let exact = u64::from(a) * u64::from(b);
            assert_eq!(
                [high_product(a, b), high_product_by_parts(a, b)],
                [(exact >> 16) as u32; 2],
                "{a} {b}"
            );
            let exact = i64::from(signed) * i64::from(b);
            let found = [signed_high_product(signed, b), signed_high_product_by_parts(signed, b)];
            assert_eq!(found, [(exact >> 16) as i32; 2], "{signed} {b}");
        }
        for (a, b) in signed(30).flat_map(|a| signed(30).map(move |b| (a, b))) {
            let exact = ((i64::from(a) * i64::from(b)) >> 32) as i32;
            assert_eq!([signed_high_half(a, b), signed_high_half_by_parts(a, b)], [exact; 2], "{a} {b}");
        }
        for a in signed(31) {
            let exact = ((i64::from(a) * i64::from(a)) >> 32) as u32;
            assert_eq!([high_square(a), high_square_by_parts(a)], [exact; 2], "{a}");
        }
    }

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

    /// Exhaustive: the guess is constant over 2^9 numbers, of which the first and the last have the largest errors.
    #[test]
    fn a_guess_keeps_its_stated_error() {
        let error = |n: u32| (f64::from(guess(n)) * f64::from(n).sqrt() / 2_147_483_648.0 - 1.0).abs();
        let errors = (1 << 21..=u32::MAX >> 9).map(|n: u32| error(n << 9).max(error((n << 9) + 511)));
        let worst = errors.fold(0.0, f64::max);
        assert!((5.5e-5..=6.0e-5).contains(&worst), "worst relative error {worst:e}");
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

    #[test]
    fn two_steps_keep_their_stated_error() {
        let worst = (1_u32 << 15..1 << 16)
            .map(|m| (f64::from(quick_inverse_16(m)) * f64::from(m) / 2_147_483_648.0 - 1.0).abs())
            .fold(0.0, f64::max);
        assert!((5e-5..=5.6e-5).contains(&worst), "worst error {worst}");
        assert_eq!((1 << 15..1 << 16).map(quick_inverse_16).max(), Some(65_535));
    }

    #[test]
    fn a_reciprocal_of_sixteen_bits_keeps_its_stated_error() {
        let worst = (1_u32 << 15..1 << 16)
            .map(|m| (f64::from(inverse_16(m)) - 2_147_483_648.0 / f64::from(m)).abs())
            .fold(0.0, f64::max);
        assert!((0.5..=0.501).contains(&worst), "worst error {worst}");
        assert_eq!(inverse_16(1 << 15), 1 << 16);
    }

    #[test]
    fn a_reciprocal_of_twenty_eight_bits_keeps_its_stated_error() {
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
    fn a_reciprocal_of_thirty_two_bits_is_that_of_the_division() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 15 } else { 1_009 };
        let last = u32::MAX - 100_000..=u32::MAX;
        for m in (1_u32 << 31..=u32::MAX).step_by(stride).chain(1 << 31..(1 << 31) + 100_000).chain(last) {
            let exact = ((1_u64 << 63) / u64::from(m)).min(u32::MAX.into()) as u32;
            assert_eq!(inverse_32(m), exact, "{m}");
        }
    }
}
