//! The arithmetic of gains of 28 bits, in 64-bit products.

use super::{Fx32, Gain32, shifted};
use crate::number::Light32;
use crate::number::{Gain, reciprocal, within_reach};

impl Gain32 {
    const ONE: Self = Self { mantissa: 1 << 27, shift: 27 };

    /// The gain of these bits, a mantissa of 28 bits and a shift. A shorter mantissa is moved up, and of a longer one the
    /// lower bits count.
    pub const fn from_bits([mantissa, shift]: [i32; 2]) -> Self {
        let mantissa = mantissa.cast_unsigned() & ((1 << 28) - 1);
        let up = if mantissa == 0 { 0 } else { mantissa.leading_zeros() - 4 };
        Self { mantissa: mantissa << up, shift: within_reach(shift) + up.cast_signed() }
    }

    /// The mantissa and the shift.
    pub const fn to_bits(self) -> [i32; 2] {
        [self.mantissa.cast_signed(), self.shift]
    }

    /// `bits / 2^shift`, rounded to a mantissa of 28 bits.
    #[inline(always)]
    pub(super) fn normalised(bits: u64, shift: i32) -> Self {
        if bits == 0 {
            return Self { mantissa: 0, shift: 0 };
        }
        let excess = 36 - bits.leading_zeros().cast_signed();
        if excess <= 0 {
            return Self { mantissa: (bits << -excess) as u32, shift: within_reach(shift - excess) };
        }
        let rounded = (((bits >> (excess - 1)) + 1) >> 1) as u32;
        // Rounding up can carry into a twenty-ninth bit.
        let carry = rounded >> 28;
        Self { mantissa: rounded >> carry, shift: within_reach(shift - excess - carry.cast_signed()) }
    }

    /// A light times the gain.
    #[inline(always)]
    pub(super) fn amplify(self, light: Light32) -> Light32 {
        let mantissa = u64::from(self.mantissa);
        let (high, low) = ((light.to_bits() >> 32) * mantissa, (light.to_bits() & 0xffff_ffff) * mantissa);
        if self.shift < 32 {
            shifted(high, self.shift - 32).saturating_add(shifted(low, self.shift))
        } else {
            shifted(high + (low >> 32), self.shift - 32)
        }
    }
}

impl Gain<Fx32> for Gain32 {
    #[inline(always)]
    fn by(self, other: Self) -> Self {
        Self::normalised(u64::from(self.mantissa) * u64::from(other.mantissa), self.shift + other.shift)
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        if self.mantissa == 0 || other.mantissa == 0 {
            return if self.mantissa == 0 { other } else { self };
        }
        let (large, small) = if self.shift < other.shift { (self, other) } else { (other, self) };
        let apart = (small.shift - large.shift).cast_unsigned();
        let aligned = (u64::from(small.mantissa) << 32).checked_shr(apart).unwrap_or(0);
        Self::normalised((u64::from(large.mantissa) << 32) + aligned, large.shift + 32)
    }

    #[inline(always)]
    fn inverse_capped(self) -> Self {
        if self.mantissa == 0 || self.shift > 27 {
            return Self::ONE;
        }
        Self::normalised(reciprocal::inverse_28(self.mantissa).into(), 55 - self.shift)
    }

    #[inline(always)]
    fn fraction(self) -> Fx32 {
        if self.mantissa != 0 && self.shift <= 27 {
            return Fx32::ONE;
        }
        Fx32::from_bits(shifted(self.mantissa.into(), self.shift - 30).to_bits() as i32)
    }
}
