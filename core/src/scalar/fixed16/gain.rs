//! The arithmetic of gains of 16 bits, in 32-bit products.

use super::{Fx16, Gain16, shifted};
use crate::scalar::{Gain, reciprocal, root, within_reach};
use fixed::types::U18F14;

/// `a b / 2^16` for a b of 16 bits, rounded down.
#[inline(always)]
pub(super) fn high_product(a: u32, b: u32) -> u32 {
    (a >> 16) * b + (((a & 0xffff) * b) >> 16)
}

/// The same for a signed a.
#[inline(always)]
pub(super) fn signed_high_product(a: i32, b: u32) -> i32 {
    let low = ((a.cast_unsigned() & 0xffff) * b) >> 16;
    (a >> 16).wrapping_mul(b.cast_signed()).wrapping_add(low.cast_signed())
}

impl Gain16 {
    const ONE: Self = Self { mantissa: 1 << 15, shift: 15 };

    /// The gain of these bits, a mantissa of 16 bits and a shift. A shorter mantissa is moved up, and of a longer one the
    /// lower bits count.
    pub const fn from_bits([mantissa, shift]: [i32; 2]) -> Self {
        let mantissa = mantissa.cast_unsigned() & ((1 << 16) - 1);
        let up = if mantissa == 0 { 0 } else { mantissa.leading_zeros() - 16 };
        Self { mantissa: mantissa << up, shift: within_reach(shift) + up.cast_signed() }
    }

    /// The mantissa and the shift.
    pub const fn to_bits(self) -> [i32; 2] {
        [self.mantissa.cast_signed(), self.shift]
    }

    /// `bits / 2^shift`, rounded to a mantissa of 16 bits.
    #[inline(always)]
    pub(super) fn normalised(bits: u32, shift: i32) -> Self {
        if bits == 0 {
            return Self { mantissa: 0, shift: 0 };
        }
        let excess = root::bit_length(bits).cast_signed() - 16;
        if excess <= 0 {
            return Self { mantissa: bits << -excess, shift: within_reach(shift - excess) };
        }
        let rounded = ((bits >> (excess - 1)) + 1) >> 1;
        // Rounding up can carry into a seventeenth bit.
        let carry = rounded >> 16;
        Self { mantissa: rounded >> carry, shift: within_reach(shift - excess - carry.cast_signed()) }
    }

    /// A light times the gain.
    #[inline(always)]
    pub(super) fn amplify(self, light: U18F14) -> U18F14 {
        let (high, low) =
            ((light.to_bits() >> 16) * self.mantissa, (light.to_bits() & 0xffff) * self.mantissa);
        if self.shift < 16 {
            shifted(high, self.shift - 16).saturating_add(shifted(low, self.shift))
        } else {
            shifted(high + (low >> 16), self.shift - 16)
        }
    }
}

impl Gain<Fx16> for Gain16 {
    #[inline(always)]
    fn by(self, other: Self) -> Self {
        Self::normalised(self.mantissa * other.mantissa, self.shift + other.shift)
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        if self.mantissa == 0 || other.mantissa == 0 {
            return if self.mantissa == 0 { other } else { self };
        }
        let (large, small) = if self.shift < other.shift { (self, other) } else { (other, self) };
        let apart = (small.shift - large.shift).cast_unsigned();
        let aligned = (small.mantissa << 15).checked_shr(apart).unwrap_or(0);
        Self::normalised((large.mantissa << 15) + aligned, large.shift + 15)
    }

    #[inline(always)]
    fn inverse_capped(self) -> Self {
        if self.mantissa == 0 || self.shift > 15 {
            return Self::ONE;
        }
        Self::normalised(reciprocal::inverse_16(self.mantissa), 31 - self.shift)
    }

    #[inline(always)]
    fn fraction(self) -> Fx16 {
        if self.mantissa != 0 && self.shift <= 15 {
            return Fx16::ONE;
        }
        Fx16::from_bits(shifted(self.mantissa, self.shift - 14).to_bits() as i16)
    }
}
