//! Gains (factors with their own exponent) in fixed point, declared by one macro for both formats.
//!
//! Only the rounding to a mantissa differs between the formats.

use super::{Fx16, Fx32, Gain, Light16, Light32, product::high_product, reciprocal, root, within_reach};

/// Declares the gain type of a scalar type, and functions of its light type.
///
/// `bits` is the width of the mantissa. `factor_bits` is the number of upper bits of the mantissa
/// that products use. `inverse` is the function that returns the reciprocal of these upper bits.
macro_rules! gain {
    (
        $(#[$doc:meta])*
        $name:ident($scalar:ident, $light:ident, $wide:ident, $bits:literal, $factor_bits:literal, $inverse:path)
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub struct $name {
            pub(super) mantissa: u32,
            pub(super) shift: i32,
        }

        impl $name {
            const ZERO: Self = Self { mantissa: 0, shift: 0 };
            const ONE: Self = Self { mantissa: 1 << ($bits - 1), shift: $bits - 1 };

            /// Restores a gain from a mantissa and a shift.
            ///
            /// A mantissa with too few bits is normalised. If a mantissa has too many bits, only
            /// the lower bits are used.
            pub const fn from_bits([mantissa, shift]: [i32; 2]) -> Self {
                const LONGER: u32 = u32::BITS - $bits;
                let mantissa = mantissa as u32 & (u32::MAX >> LONGER);
                let up = if mantissa == 0 { 0 } else { mantissa.leading_zeros() - LONGER };
                Self { mantissa: mantissa << up, shift: within_reach(shift) + up as i32 }
            }

            /// Returns the mantissa and the shift.
            pub const fn to_bits(self) -> [i32; 2] {
                [self.mantissa as i32, self.shift]
            }

            /// Returns the nearest gain; a negative value or NaN becomes zero.
            pub(crate) fn nearest(value: f32) -> Self {
                let (mantissa, shift) = super::mantissa_and_shift(value);
                Self { mantissa: mantissa << ($bits - 24), shift: shift + $bits - 24 }
            }

            /// Returns the integer factor used in products: the gain is `factor / 2^scale`.
            #[inline]
            pub(super) fn factor(self) -> $wide {
                (self.mantissa >> ($bits - $factor_bits)).into()
            }

            #[inline]
            pub(super) fn scale(self) -> i32 {
                self.shift - ($bits - $factor_bits)
            }

            /// Returns a light times the gain; saturates.
            #[inline]
            pub(super) fn amplify(self, light: $light) -> $light {
                const HALF: u32 = $wide::BITS / 2;
                let (factor, scale) = (self.factor(), self.scale());
                let high = (light.to_bits() >> HALF) * factor;
                let low = (light.to_bits() & ((1 << HALF) - 1)) * factor;
                if scale < HALF as i32 {
                    $light::shifted(high, scale - HALF as i32).saturating_add($light::shifted(low, scale))
                } else {
                    $light::shifted(high + (low >> HALF), scale - HALF as i32)
                }
            }
        }

        impl Gain<$scalar> for $name {
            #[inline]
            fn by(self, other: Self) -> Self {
                Self::normalised(self.factor() * other.factor(), self.scale() + other.scale())
            }

            #[inline]
            fn plus(self, other: Self) -> Self {
                /// Left shift of the factors. The shift leaves one bit free, because the sum of two
                /// mantissas may carry.
                const UP: u32 = $wide::BITS - $factor_bits - 1;
                if self.mantissa == 0 || other.mantissa == 0 {
                    return if self.mantissa == 0 { other } else { self };
                }
                let (large, small) = if self.shift < other.shift { (self, other) } else { (other, self) };
                let apart = (small.shift - large.shift) as u32;
                let aligned = (small.factor() << UP).checked_shr(apart).unwrap_or(0);
                Self::normalised((large.factor() << UP) + aligned, large.scale() + UP as i32)
            }

            #[inline]
            fn inverse_capped(self) -> Self {
                if self.mantissa == 0 || self.scale() >= $factor_bits {
                    return Self::ONE;
                }
                let inverse = $inverse(self.mantissa >> ($bits - $factor_bits));
                Self::normalised(inverse.into(), 2 * $factor_bits - 1 - self.scale())
            }

            #[inline]
            fn fraction(self) -> $scalar {
                if self.mantissa != 0 && self.scale() < $factor_bits {
                    return $scalar::ONE;
                }
                let down = self.scale() - $scalar::FRACTION_BITS as i32;
                $scalar::from_bits($light::shifted(self.factor(), down).to_bits() as _)
            }

            #[inline]
            fn part(self, part: $scalar) -> Self {
                if part >= $scalar::ONE {
                    return self;
                }
                let bits = part.max($scalar::ZERO).to_bits() as $wide;
                self.by(Self::normalised(bits, $scalar::FRACTION_BITS as i32))
            }
        }

        impl $light {
            /// Returns the light with the bits `product / 2^shift`, rounded to nearest; saturates.
            #[inline]
            pub(super) fn shifted(product: $wide, shift: i32) -> Self {
                let but_one = shift.wrapping_sub(1) as u32;
                Self::from_bits(if but_one < $wide::BITS {
                    let doubled = product >> but_one;
                    (doubled >> 1) + (doubled & 1)
                } else if shift > 0 || product == 0 {
                    0
                } else if shift.unsigned_abs() <= product.leading_zeros() {
                    product << shift.unsigned_abs()
                } else {
                    $wide::MAX
                })
            }
        }
    };
}

gain! {
    /// A factor `mantissa / 2^shift` with a mantissa of 32 bits.
    ///
    /// The coarse evaluation uses only the upper 16 bits of the mantissa, in 32-bit products.
    Gain16(Fx16, Light16, u32, 32, 16, reciprocal::inverse_16)
}

gain! {
    /// A factor `mantissa / 2^shift` with a mantissa of 28 bits, in 64-bit products.
    Gain32(Fx32, Light32, u64, 28, 28, reciprocal::inverse_28)
}

impl Gain16 {
    /// A gain over every one that a product of lengths needs.
    pub(super) const HUGE: Self = Self { mantissa: 1 << 31, shift: -1024 };

    /// Returns the gain times `factor / 2^fraction_bits`, as light; saturates.
    #[inline]
    pub(crate) fn light_of(self, factor: u32, fraction_bits: i32) -> Light16 {
        let product = high_product(factor, self.factor());
        Light16::shifted(product, self.scale() + fraction_bits - 16 - Fx16::FRACTION_BITS as i32)
    }

    /// Returns whether this gain is more than another one.
    #[inline]
    pub(crate) fn exceeds(self, other: Self) -> bool {
        self.mantissa != 0 && (self.shift, other.mantissa) < (other.shift, self.mantissa)
    }

    /// Returns `bits / 2^shift`, rounded to a mantissa of 16 bits.
    #[inline]
    pub(super) fn normalised(bits: u32, shift: i32) -> Self {
        if bits == 0 {
            return Self::ZERO;
        }
        let up = u32::BITS as i32 - root::bit_length(bits) as i32;
        let mantissa = bits << up;
        let rounded = (mantissa >> 16) + ((mantissa >> 15) & 1);
        // Rounding up can carry into bit 16.
        let carry = rounded >> 16;
        Self { mantissa: rounded << (16 - carry), shift: within_reach(shift + up - carry as i32) }
    }
}

impl Gain32 {
    /// Returns `bits / 2^shift`, rounded to a mantissa of 28 bits.
    #[inline]
    pub(super) fn normalised(bits: u64, shift: i32) -> Self {
        if bits == 0 {
            return Self::ZERO;
        }
        let excess = 36 - bits.leading_zeros() as i32;
        if excess <= 0 {
            return Self { mantissa: (bits << -excess) as u32, shift: within_reach(shift - excess) };
        }
        let rounded = (((bits >> (excess - 1)) + 1) >> 1) as u32;
        // Rounding up can carry into bit 28.
        let carry = rounded >> 28;
        Self { mantissa: rounded >> carry, shift: within_reach(shift - excess - carry as i32) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gain is `mantissa / 2^shift`, however many bits the mantissa has.
    #[test]
    fn a_short_mantissa_is_the_same_gain() {
        for bits in 0..28 {
            assert_eq!(Gain16::from_bits([1 << bits, bits]), Gain16::ONE);
            assert_eq!(Gain32::from_bits([1 << bits, bits]), Gain32::ONE);
            assert_eq!(Gain16::normalised(1 << bits, bits), Gain16::ONE);
            assert_eq!(Gain32::normalised(1 << bits, bits), Gain32::ONE);
        }
    }
}
