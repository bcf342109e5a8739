//! Fractions and directions of 30 bits in 32-bit products, for the cones that 15 bits do not hold.
//!
//! A cone whose edge is steep over its width magnifies what 15 bits have rounded away: the length of a direction, the
//! components of a difference and the argument of the profile. Here each has about 28 bits, for some 100 instructions
//! more on a Cortex-M0. Only the cones pay that need it: [`Cone::compile`](crate::Cone::compile) chooses by a bound.

use super::{Fx16, Offset16, Ramp16, gain, offset};
use crate::{
    scalar::{Fraction, Rise, fraction::neighbours, root},
    vec3::Vec3,
};
use fixed::types::{I2F30, I18F14, U3F29};

/// A number from 0 to 1 with 31 fraction bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Default, Debug)]
pub struct Fine16(u32);

/// `a b / 2^32`, rounded down: exactly, so that it never falls where a factor rises.
#[inline(always)]
const fn high_half(a: u32, b: u32) -> u32 {
    let (high, low) = (a >> 16, a & 0xffff);
    let upper = high * (b & 0xffff) + ((low * (b & 0xffff)) >> 16);
    let lower = low * (b >> 16) + (upper & 0xffff);
    high * (b >> 16) + (upper >> 16) + (lower >> 16)
}

impl Fine16 {
    const ONE: Self = Self(1 << 31);

    /// The product, within 2^-30 below the exact one; exact where a factor is one or zero.
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self(high_half(self.0, other.0) << 1)
    }

    /// The nearest scalar.
    #[inline(always)]
    pub(super) fn rounded(self) -> Fx16 {
        Fx16::from_bits(((self.0 + (1 << 16)) >> 17) as i16)
    }

    /// `t (1 + u slope)` for a slope of 28 fraction bits, within [0, 1] whatever the slope.
    #[inline(always)]
    fn lifted(self, slope: i32) -> Self {
        // At most 28 bits each: a sound slope is from -3 to 3.
        let lift = high_half(high_half(self.0, self.complement().0) << 1, slope.unsigned_abs());
        let lift = lift.min((1 << 28) - 1) << 4;
        let lifted = if slope < 0 { self.0.saturating_sub(lift) } else { self.0.saturating_add(lift) };
        Self(lifted.min(Self::ONE.0))
    }
}

impl Fraction<Fx16> for Fine16 {
    type Value = Self;

    #[inline(always)]
    fn complement(self) -> Self {
        Self(Self::ONE.0 - self.0)
    }

    #[inline(always)]
    fn fine_product(self, other: Self) -> Self {
        self.times(other)
    }

    #[inline(always)]
    fn product(self, other: Self) -> Self {
        self.times(other)
    }

    #[inline(always)]
    fn scalar(self) -> Self {
        self
    }

    #[inline(always)]
    fn of(self, value: Self) -> Self {
        self.times(value)
    }

    #[inline(always)]
    fn lack(value: Self) -> Self {
        value.complement()
    }

    #[inline(always)]
    fn mixed(low: Self, high: Self, share: Fx16) -> Self {
        let share = Self(u32::from(share.to_bits().clamp(0, 1 << 14).cast_unsigned()) << 17);
        Self(low.0 - Self(low.0.saturating_sub(high.0)).times(share).0)
    }

    #[inline(always)]
    fn step(self) -> Self {
        if self.0 > 0 { Self::ONE } else { Self(0) }
    }

    #[inline(always)]
    fn smooth(self) -> Self {
        let square = self.times(self);
        Self((square.0 + 2 * square.times(self.complement()).0).min(Self::ONE.0))
    }

    #[inline(always)]
    fn blend(self, g: I18F14) -> Self {
        self.lifted(g.to_bits().wrapping_shl(14))
    }

    #[inline(always)]
    fn cubic(self, g: I18F14, h: I18F14) -> Self {
        let bend = high_half(self.0, h.to_bits().unsigned_abs() << 14).cast_signed() << 1;
        let bend = if h < 0 { bend.wrapping_neg() } else { bend };
        self.lifted(g.to_bits().wrapping_shl(14).wrapping_add(bend))
    }

    #[inline(always)]
    fn sample(self, samples: &[u16]) -> Self {
        let last = (samples.len().min(1 << 16) as u32).saturating_sub(1);
        // With 15 fraction bits: 31 and 16 bits in, 16 cut off.
        let place = gain::high_product(self.complement().0, last);
        let (here, next) = neighbours(samples, (place >> 15) as usize);
        let (here, next) = (i32::from(here), i32::from(next));
        let between = ((here << 15) + (next - here) * (place & 0x7fff).cast_signed()).cast_unsigned();
        // 65,535 is one: `2^16 / (2^16 - 1) = 1 + 2^-16 + ..`
        Self((between + ((between + (1 << 15)) >> 16)).min(Self::ONE.0))
    }
}

impl Ramp16 {
    /// The ramp between two versines times `2^29 4^zoom`, in 32 bits.
    pub(super) fn finely(zoom: u32, inner: u32, limit: u32, outer: u64) -> Self {
        let span = outer.saturating_sub(inner.into()).max(1);
        // The span is `divisor 2^(shift - 32)`.
        let shift = u64::BITS - span.leading_zeros();
        let divisor = (span << (64 - shift)) >> 32;
        let mantissa = ((1 << 63) / divisor).min(u32::MAX.into()) as u32;
        Self { zoom, inner: inner.min(limit), width: 0, shift, mantissa, one: 0, fine: limit.saturating_sub(inner) }
    }

    /// Where a versine stands on the ramp. On a fine one, which no versine is within coarsely, `finely` gives it with all
    /// of its bits.
    #[inline(always)]
    pub(super) fn rise(self, versine: U3F29, finely: impl FnOnce() -> U3F29) -> Rise<Fx16> {
        let past = versine.to_bits().wrapping_sub(self.inner);
        if past < self.width {
            Rise::Coarse(self.within(past))
        } else if self.fine == 0 {
            Rise::Coarse(self.end(versine.to_bits()))
        } else {
            core::hint::cold_path();
            Rise::Fine(self.rise_finely(finely()))
        }
    }

    /// Where a versine stands on a fine ramp.
    fn rise_finely(&self, versine: U3F29) -> Fine16 {
        let versine = versine.to_bits();
        let past = versine.wrapping_sub(self.inner);
        if past >= self.fine {
            return if versine < self.inner { Fine16::ONE } else { Fine16(0) };
        }
        let fallen = if self.shift < u32::BITS {
            high_half(past.wrapping_shl(u32::BITS - self.shift), self.mantissa)
        } else {
            high_half(past, self.mantissa) >> (self.shift - u32::BITS)
        };
        Fine16(Fine16::ONE.0.saturating_sub(fallen))
    }
}

impl Offset16 {
    /// The unit direction with 30 fraction bits: each component within 6 units and the length within 3e-8.
    #[inline(always)]
    fn fine_direction(&self) -> Vec3<i32> {
        let reciprocal = root::inverse_sqrt_16(self.squared());
        let nearly = self.whole().map(|c| gain::signed_high_product(c, reciprocal));
        // What the squared length is over one is `x`; `1 / sqrt(1 + x) = 1 - x / 2 + 3/8 x^2`.
        let squares = nearly.map(|c| high_half(2 * c.unsigned_abs(), 2 * c.unsigned_abs()));
        let over = (squares.x + squares.y + squares.z).wrapping_sub(1 << 30).cast_signed();
        let coarse = over >> 4;
        let excess = (over >> 1) - 3 * (coarse.wrapping_mul(coarse) >> 25);
        nearly.map(|c| c - ((c >> 14).wrapping_mul(excess >> 4) >> 12))
    }

    /// The versine of the angle between direction and axis, as [`versine_between`](crate::Scalar::versine_between) has
    /// it, of 29 bits.
    #[inline(always)]
    pub(super) fn fine_versine(&self, axis: Vec3<I2F30>, zoom: u32) -> U3F29 {
        let difference = self.fine_direction().zip(axis, |d, s| d.wrapping_sub(s.to_bits()));
        if offset::size(difference) >> (31 - zoom) != 0 {
            return U3F29::MAX;
        }
        let squares = difference.map(|c| {
            let c = c.unsigned_abs() << zoom;
            high_half(c, c)
        });
        U3F29::from_bits(squares.x + squares.y + squares.z)
    }
}
