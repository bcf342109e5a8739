//! Square root without a crate or an instruction.
//!
//! An estimate, computed with `+ - *`, has an error of at most one ULP. The remainder (the number
//! minus the square of the estimate), exact in a 32-bit integer, decides whether a neighbour of the
//! estimate is nearer to the root. So the result is correctly rounded and bit-identical to any
//! other correctly rounded square root. This method takes about half the instructions of a square
//! root in integers.

/// Returns the square root, correctly rounded; NaN for a negative number.
pub(crate) fn sqrt(x: f32) -> f32 {
    if (f32::MIN_POSITIVE..f32::INFINITY).contains(&x) {
        normal_sqrt(x)
    } else if x > 0.0 && x < f32::INFINITY {
        // Scales a subnormal number to a normal one by an even power of two.
        normal_sqrt(x * 16_777_216.0) / 4_096.0
    } else if x < 0.0 {
        f32::NAN
    } else {
        // Zero of either sign, infinity and NaN are their own roots.
        x
    }
}

/// Returns the correctly rounded square root of a positive normal number. For any other number the
/// result is unspecified.
#[inline]
fn normal_sqrt(x: f32) -> f32 {
    let bits = x.to_bits();
    nearest(bits, estimate(x, bits))
}

/// Returns the square root of `x` within one ULP (exhaustive).
#[inline]
fn estimate(x: f32, bits: u32) -> f32 {
    // Halving and negating the exponent in the integer representation gives `1 / sqrt(x)` with an
    // error of 3.5 % (Lomont 2003, "Fast Inverse Square Root").
    let seed = f32::from_bits(0x5f37_59df - (bits >> 1));
    // The quadratic in `s` approximates `1/sqrt(s)` with the least relative error, 2.5e-5, over all
    // `s` that the seed can give.
    let s = x * seed * seed;
    let reciprocal = seed * (1.876_617 + s * (-1.252_138 + s * 0.375_521_3));
    // One Newton step refines the root, in a form that stays within the range of f32.
    let root = x * reciprocal;
    root + root * (0.5 - 0.5 * reciprocal * root)
}

/// Returns the float nearest to the exact root: the estimate or one of its two neighbours.
#[inline]
fn nearest(bits: u32, estimate: f32) -> f32 {
    let bits_of_root = estimate.to_bits();
    // Let the estimate's significand be an integer `m` from 2^23 to 2^24. The number `x` is then an
    // integer of 47 or 48 bits. The difference `x - m^2` is so small that its lower 32 bits are
    // enough.
    let m = (bits_of_root & 0x007f_ffff | 0x0080_0000) as i32;
    let number = (bits << (24 - ((bits >> 23) & 1))) as i32;
    let rest = number.wrapping_sub(m.wrapping_mul(m));
    // `(m + 1/2)^2 = m^2 + m + 1/4`, so the root is rounded up if `rest > m`, and down if
    // `rest < -m`. `rest` is never `-m`: then `x` would be `m^2 - m`, which needs more than 24
    // bits, except for two numbers whose estimate is right.
    let up = m.wrapping_sub(rest) >> 31;
    let down = rest.wrapping_add(m) >> 31;
    f32::from_bits(bits_of_root.wrapping_sub(up as u32).wrapping_add(down as u32))
}

#[cfg(test)]
mod tests {
    use super::*;

    extern crate std;

    /// Asserts that `sqrt` of every number is the exact square root, correctly rounded.
    ///
    /// The test covers two binades in full, which contain all cases, and the other binades with a
    /// stride. With `LUMINAIRE_FULL` it covers every normal number.
    fn assert_correctly_rounded(numbers: impl Iterator<Item = u32>, exact: impl Fn(f32) -> f32) {
        for x in numbers.map(f32::from_bits) {
            assert_eq!(sqrt(x), exact(x), "the root of {x:e}");
        }
    }

    #[test]
    fn every_root_is_rounded_correctly() {
        let exact = |x: f32| f64::from(x).sqrt() as f32;
        if std::env::var_os("LUMINAIRE_FULL").is_some() {
            assert_correctly_rounded(0x0080_0000..0x7f80_0000, exact);
        } else {
            assert_correctly_rounded(0x3f80_0000..0x4080_0000, exact);
            assert_correctly_rounded((0x0080_0000..0x7f80_0000).step_by(1021), exact);
        }
    }

    #[test]
    fn any_number_has_the_root_of_std() {
        let bits = (0..0x0080_0000).step_by(1021).chain([0x007f_ffff, 0x7f80_0000, 0x8000_0000]);
        for x in bits.map(f32::from_bits).chain([1.0, 2.0, f32::MAX]) {
            assert_eq!(sqrt(x).to_bits(), x.sqrt().to_bits(), "{x:e}");
        }
        assert!([-1.0, -1e-40, f32::NEG_INFINITY, f32::NAN].into_iter().all(|x| sqrt(x).is_nan()));
    }

    /// The estimate needs corrections in both directions, and never by more than one ULP.
    #[test]
    fn the_estimate_is_a_unit_off_at_most() {
        let off = |bits: u32| {
            let x = f32::from_bits(bits);
            estimate(x, bits).to_bits().wrapping_sub(sqrt(x).to_bits()) as i32
        };
        let (least, most) = (0x3f80_0000..0x4080_0000)
            .step_by(61)
            .map(off)
            .fold((0, 0), |(least, most): (i32, i32), off| (least.min(off), most.max(off)));
        assert_eq!((least, most), (-1, 1));
    }
}
