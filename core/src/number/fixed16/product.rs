//! Upper bits of products that are wider than 32 bits, computed with 32-bit products.

/// Returns `a b / 2^16` for `b` of 16 bits, rounded down.
#[inline]
pub(super) fn high_product(a: u32, b: u32) -> u32 {
    (a >> 16) * b + (((a & 0xffff) * b) >> 16)
}

/// Returns `a b / 2^16` for a signed `a` and `b` of 16 bits, rounded down.
#[inline]
pub(super) fn signed_high_product(a: i32, b: u32) -> i32 {
    let low = ((a as u32 & 0xffff) * b) >> 16;
    (a >> 16).wrapping_mul(b as i32).wrapping_add(low as i32)
}

/// Returns `a b / 2^32`, rounded down exactly, so it is monotone in both factors.
#[inline(always)] // `spot-step-lambert` on Cortex-M0: +38 instructions without.
pub(super) const fn high_half(a: u32, b: u32) -> u32 {
    let (high, low) = (a >> 16, a & 0xffff);
    let upper = high * (b & 0xffff) + ((low * (b & 0xffff)) >> 16);
    let lower = low * (b >> 16) + (upper & 0xffff);
    high * (b >> 16) + (upper >> 16) + (lower >> 16)
}

/// Returns the upper half of a square, within 2: two products, where [`high_half`] has four.
#[inline]
pub(super) fn high_square(a: u32) -> u32 {
    let (high, low) = (a >> 16, a & 0xffff);
    high * high + ((high * low) >> 15)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers next to all powers of two and their complements, as factors of each other.
    #[test]
    fn a_high_half_is_exact_and_a_high_square_within_two() {
        let numbers =
            || (0..32).flat_map(|shift| [-1, 0, 1].map(|i| (1_u32 << shift).wrapping_add_signed(i)));
        let numbers = || numbers().flat_map(|n| [n, !n, n.wrapping_mul(0x9e37_79b9)]);
        let exact = |a: u32, b: u32| (u64::from(a) * u64::from(b)) >> 32;
        for a in numbers() {
            for b in numbers() {
                assert_eq!(u64::from(high_half(a, b)), exact(a, b), "{a} {b}");
            }
            assert!(exact(a, a) - u64::from(high_square(a)) <= 2, "{a}");
        }
    }
}
