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
