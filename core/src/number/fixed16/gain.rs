//! The arithmetic of gains of 16 bits, in 32-bit products.

use super::{Fx16, Gain16, shifted};
use crate::number::Light16;
use crate::number::{Gain, reciprocal, root, within_reach};

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
    const ONE: Self = Self { mantissa: 1 << 31, shift: 31 };

    /// The gain of these bits, a mantissa of 32 bits and a shift. A shorter mantissa is moved up.
    pub const fn from_bits([mantissa, shift]: [i32; 2]) -> Self {
        let mantissa = mantissa.cast_unsigned();
        let up = if mantissa == 0 { 0 } else { mantissa.leading_zeros() };
        Self { mantissa: mantissa << up, shift: within_reach(shift) + up.cast_signed() }
    }

    /// The mantissa and the shift.
    pub const fn to_bits(self) -> [i32; 2] {
        [self.mantissa.cast_signed(), self.shift]
    }

    /// The upper 16 bits of the mantissa.
    #[inline(always)]
    pub(super) fn top(self) -> u32 {
        self.mantissa >> 16
    }

    /// `bits / 2^shift`, rounded to a mantissa of 16 bits.
    #[inline(always)]
    pub(super) fn normalised(bits: u32, shift: i32) -> Self {
        if bits == 0 {
            return Self { mantissa: 0, shift: 0 };
        }
        let up = u32::BITS.cast_signed() - root::bit_length(bits).cast_signed();
        let mantissa = bits << up;
        let rounded = (mantissa >> 16) + ((mantissa >> 15) & 1);
        // Rounding up can carry into a seventeenth bit.
        let carry = rounded >> 16;
        Self { mantissa: rounded << (16 - carry), shift: within_reach(shift + up - carry.cast_signed()) }
    }

    /// A light times the gain.
    #[inline(always)]
    pub(super) fn amplify(self, light: Light16) -> Light16 {
        let (top, shift) = (self.top(), self.shift - 16);
        let (high, low) = ((light.to_bits() >> 16) * top, (light.to_bits() & 0xffff) * top);
        if shift < 16 {
            shifted(high, shift - 16).saturating_add(shifted(low, shift))
        } else {
            shifted(high + (low >> 16), shift - 16)
        }
    }
}

impl Gain<Fx16> for Gain16 {
    #[inline(always)]
    fn by(self, other: Self) -> Self {
        Self::normalised(self.top() * other.top(), self.shift + other.shift - 32)
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        if self.mantissa == 0 || other.mantissa == 0 {
            return if self.mantissa == 0 { other } else { self };
        }
        let (large, small) = if self.shift < other.shift { (self, other) } else { (other, self) };
        let apart = (small.shift - large.shift).cast_unsigned();
        let aligned = (small.top() << 15).checked_shr(apart).unwrap_or(0);
        Self::normalised((large.top() << 15) + aligned, large.shift - 1)
    }

    #[inline(always)]
    fn inverse_capped(self) -> Self {
        if self.mantissa == 0 || self.shift > 31 {
            return Self::ONE;
        }
        Self::normalised(reciprocal::inverse_16(self.top()), 47 - self.shift)
    }

    #[inline(always)]
    fn fraction(self) -> Fx16 {
        if self.mantissa != 0 && self.shift <= 31 {
            return Fx16::ONE;
        }
        Fx16::from_bits(shifted(self.top(), self.shift - 30).to_bits() as i16)
    }
}
