//! Upper bits of products that are wider than 32 bits, rounded down.
//!
//! A processor without an instruction for such products computes them from products of 16-bit
//! numbers, with the same result.

/// Whether the processor has an instruction for the upper half of a product.
///
/// Rust has no `cfg` for the instruction. Of the 32-bit processors, the small Arm cores lack the
/// instruction; these cores also lack compare-and-swap.
const HAS_HIGH_HALVES: bool = !cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// Returns `a b / 2^16` for `b` of 16 bits, rounded down.
#[inline]
pub(super) fn high_product(a: u32, b: u32) -> u32 {
    if HAS_HIGH_HALVES { high_half(a, b << 16) } else { high_product_by_parts(a, b) }
}

/// Returns the result of [`high_product`], computed from two products of 16-bit numbers.
#[inline]
fn high_product_by_parts(a: u32, b: u32) -> u32 {
    (a >> 16) * b + (((a & 0xffff) * b) >> 16)
}

/// Returns `a b / 2^16` for a signed `a` and `b` of 16 bits, rounded down.
#[inline]
pub(super) fn signed_high_product(a: i32, b: u32) -> i32 {
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
#[inline(always)] // `spot-step-lambert` on Cortex-M0: +38 instructions without.
pub(super) fn high_half(a: u32, b: u32) -> u32 {
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
pub(super) fn signed_high_half(a: i32, b: i32) -> i32 {
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
pub(super) fn high_square(a: i32) -> u32 {
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

#[cfg(test)]
mod tests {
    use super::*;

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
}
