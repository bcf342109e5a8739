//! Reciprocal square roots of integers, in multiplications and shifts alone.

/// `256 / sqrt(x) - 256` in the middle of each of the 192 steps of `x` from 1/4 to 1, rounded.
const SEED: [u8; 192] = {
    let mut table = [0; 192];
    let mut step = 0;
    while step < table.len() {
        // Twice the root: isqrt rounds down, and halving the odd bit away rounds to nearest.
        let doubled = ((4 << 25) / (129 + 2 * step as u64)).isqrt();
        table[step] = (doubled.div_ceil(2) - 256) as u8;
        step += 1;
    }
    table
};

/// How many bits each number of eight bits has.
const LENGTH: [u8; 256] = {
    let mut table = [0; 256];
    let mut number = 0;
    while number < table.len() {
        table[number] = (usize::BITS - number.leading_zeros()) as u8;
        number += 1;
    }
    table
};

/// How many bits a number has. Where the processor cannot count leading zeros, a table is three times as fast as the
/// compiler's way: these are the small ones, which have no compare-and-swap either.
#[inline(always)]
pub(super) const fn bit_length(n: u32) -> u32 {
    if cfg!(target_has_atomic = "32") { u32::BITS - n.leading_zeros() } else { looked_up_bit_length(n) }
}

#[inline(always)]
const fn looked_up_bit_length(n: u32) -> u32 {
    let (n, half) = if n >> 16 == 0 { (n, 0) } else { (n >> 16, 16) };
    let (n, quarter) = if n >> 8 == 0 { (n, 0) } else { (n >> 8, 8) };
    half + quarter + LENGTH[n as usize & 0xff] as u32
}

/// `2^31 / sqrt(n)` for n from 2^30 up: 65,536 at n = 2^30, 32,768 at the top.
///
/// One Newton step from a seed of eight bits, in 32-bit products. Relative error at most 4.0e-5 (exhaustive).
#[inline]
pub(super) const fn inverse_sqrt_16(n: u32) -> u32 {
    let seed = 256 + SEED[(n >> 24).saturating_sub(64) as usize] as u32;
    // n seed^2 is close to 2^34 in this scale: the wrapped product holds just what it lacks.
    let lack = 0_u32.wrapping_sub((n >> 14).wrapping_mul(seed * seed)).cast_signed();
    let correction = (seed.cast_signed() * (lack >> 10) + (1 << 17)) >> 18;
    (seed << 7).wrapping_add_signed(correction)
}

/// `2^63 / sqrt(n)` for n from 2^62 up: 2^32 at n = 2^62, 2^31 at the top.
///
/// One step of third order (Halley's) from [`inverse_sqrt_16`], in 64-bit products. Relative error at most
/// 2^-31 (searched).
#[inline]
pub(super) const fn inverse_sqrt_32(n: u64) -> u64 {
    let seed = inverse_sqrt_16((n >> 32) as u32) as u64;
    let lack = 0_u64.wrapping_sub((n >> 30).wrapping_mul(seed * seed)).cast_signed() >> 24;
    let correction = lack / 2 + 3 * ((lack * lack) >> 40) / 8;
    (seed << 16).wrapping_add_signed((seed.cast_signed() * correction) >> 24)
}

#[cfg(test)]
mod tests {
    use super::*;

    extern crate std;

    /// The largest relative error over `count` inputs from `first` on, `stride` apart.
    fn worst_16(stride: usize) -> f64 {
        ((1_u32 << 30)..=u32::MAX)
            .step_by(stride)
            .map(|n| {
                let exact = 2_147_483_648.0 / f64::from(n).sqrt();
                (f64::from(inverse_sqrt_16(n)) / exact - 1.0).abs()
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn the_table_knows_every_bit_length() {
        assert_eq!(looked_up_bit_length(0), 0);
        for bits in 1..=u32::BITS {
            let (least, most) = (1 << (bits - 1), u32::MAX >> (u32::BITS - bits));
            assert_eq!((looked_up_bit_length(least), looked_up_bit_length(most)), (bits, bits));
        }
    }

    #[test]
    fn sixteen_bits_keep_their_stated_error() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 1 } else { 251 };
        let worst = worst_16(stride);
        assert!((2.0e-5..=4.0e-5).contains(&worst), "worst relative error {worst:e}");
    }

    #[test]
    fn thirty_two_bits_keep_their_stated_error() {
        let mut worst = 0.0_f64;
        let mut n = 1_u64 << 62;
        // An odd stride that visits all bits; 2^62 .. 2^64 in two million steps.
        while let Some(next) = n.checked_add(6_917_529_027_641) {
            let exact = 9_223_372_036_854_775_808.0 / (n as f64).sqrt();
            worst = worst.max((inverse_sqrt_32(n) as f64 / exact - 1.0).abs());
            n = next;
        }
        assert!((1e-10..=4.7e-10).contains(&worst), "worst relative error {worst:e}");
    }
}
