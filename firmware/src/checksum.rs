//! Results as bits, of which a checksum is made.

use fixed::{FixedI16, FixedI32, FixedU32, FixedU64};

/// A value as 32 bits that tell it from its neighbours.
pub trait Bits: Copy {
    /// The bits.
    fn bits(self) -> u32;
}

impl Bits for f32 {
    #[inline(always)]
    fn bits(self) -> u32 {
        self.to_bits()
    }
}

impl<F> Bits for FixedI16<F> {
    #[inline(always)]
    fn bits(self) -> u32 {
        i32::from(self.to_bits()).cast_unsigned()
    }
}

impl<F> Bits for FixedI32<F> {
    #[inline(always)]
    fn bits(self) -> u32 {
        self.to_bits().cast_unsigned()
    }
}

impl<F> Bits for FixedU32<F> {
    #[inline(always)]
    fn bits(self) -> u32 {
        self.to_bits()
    }
}

impl<F> Bits for FixedU64<F> {
    #[inline(always)]
    fn bits(self) -> u32 {
        (self.to_bits() >> 32) as u32 ^ self.to_bits() as u32
    }
}

/// One more result in a checksum; the order counts.
#[inline(always)]
pub(crate) fn fold(sum: u32, result: impl Bits) -> u32 {
    sum.wrapping_mul(3) ^ result.bits()
}
