//! The ramp from the edge of a cone to its middle, in 16 bits.

use super::{fine::Fine16, product::high_half};
use crate::number::{Fx16, Rise, Versine16, fraction::Fraction16, rounded};

/// The largest zoom of a ramp: one more would ask for bits that a direction does not have.
pub(super) const MOST_ZOOM: u32 = 15;

/// A ramp: from what a versine has over the inner one to `t`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ramp16 {
    /// Powers of four by which the versines of this ramp are magnified.
    pub(super) zoom: u32,
    /// Up to here there is all the light.
    inner: u32,
    /// So far from the inner versine on there is none: at the outer versine, or at that of a tighter cutoff.
    width: u32,
    /// Takes the span from inner to outer versine to at most 16 bits.
    shift: u32,
    /// `2^31` over the shifted span.
    mantissa: u32,
    /// One with 31 fraction bits, half a step of the result, less half of what a shifted versine has lost: what the
    /// product is taken from, and all roundings, in one subtraction.
    one: u32,
    /// The width of a ramp that is always evaluated finely, so that its `width` is 0; 0 for any other.
    fine: u32,
    /// How many bits the span has.
    fine_shift: u32,
    /// `2^63` over the span, which is shifted to 32 bits for that.
    fine_mantissa: u32,
}

impl Ramp16 {
    /// The ramp of these bits, in the order of the fields. Those that no ramp has are brought to where every versine has a
    /// place.
    pub const fn from_bits(bits: [u32; 9]) -> Self {
        /// Beyond this a versine at the inner one would be more than one.
        const MOST: u32 = (1 << 31) + (1 << 16) - 1;
        let [zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa] = bits;
        let width = if fine == 0 { width } else { 0 };
        let shift = shift % u32::BITS;
        let one = if one < MOST { one } else { MOST };
        let steps = width.saturating_sub(1) >> shift;
        Self {
            zoom: if zoom < MOST_ZOOM { zoom } else { MOST_ZOOM },
            inner,
            width,
            shift,
            mantissa: if steps.saturating_mul(mantissa) <= one { mantissa } else { 0 },
            one,
            fine,
            fine_shift: fine_shift % u64::BITS,
            fine_mantissa,
        }
    }

    /// The bits, in the order of the fields.
    pub const fn to_bits(self) -> [u32; 9] {
        let Self { zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa } = self;
        [zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa]
    }

    /// The ramp between two versines, cut off at a limit.
    pub(super) fn new(inner: f32, outer: f32, limit: f32) -> Self {
        // Two is the square of the largest component that `versine_between` lets pass. Beyond the limit none has to.
        let limit = if limit < outer { limit } else { outer };
        let zoom = zoom(limit);
        let [inner, limit] = [inner, limit].map(|versine| magnified(versine, zoom).to_bits());
        let outer = (outer * (1_u64 << (29 + 2 * zoom)) as f32 + 0.5) as u64;
        let span = outer.saturating_sub(inner.into()).max(1);
        let shift = (u64::BITS - span.leading_zeros()).saturating_sub(16).min(31);
        // The whole span divides, not the shifted one: what the shift loses would be an error of the slope.
        let mantissa = (((1 << (31 + shift)) + span / 2) / span) as u32;
        let width = limit.saturating_sub(inner);
        let one = (1 << 31) + (1 << 15) - (mantissa - (mantissa >> shift)) / 2;
        // The last versine short of the limit must not be taken below zero.
        let one = one.max((width.saturating_sub(1) >> shift) * mantissa);
        // Of the whole span, too: `divisor 2^(fine_shift - 32)`.
        let fine_shift = u64::BITS - span.leading_zeros();
        // The upper bit is set already: the compiler cannot know.
        let divisor = (span << span.leading_zeros()) >> 32 | 1 << 31;
        let fine_mantissa = ((1 << 63) / divisor).min(u32::MAX.into()) as u32;
        let inner = inner.min(limit);
        Self { zoom, inner, width, shift, mantissa, one, fine: 0, fine_shift, fine_mantissa }
    }

    /// The same ramp, always evaluated finely.
    pub(super) fn into_fine(self) -> Self {
        Self { width: 0, fine: self.width, ..self }
    }

    /// Where a versine stands on the ramp.
    #[inline]
    pub(super) fn rise(self, versine: Versine16) -> Rise<Fx16> {
        match self.within(versine) {
            Some(t) => Rise::Coarse(t),
            // No versine is within a fine ramp.
            None if self.fine > 0 => Rise::Fine(self.rise_finely(versine)),
            None => Rise::Coarse(self.end(versine)),
        }
    }

    /// Where it stands on a ramp that is not always fine.
    #[inline]
    pub(super) fn rise_coarsely(self, versine: Versine16) -> Fraction16 {
        self.within(versine).unwrap_or_else(|| self.end(versine))
    }

    /// Where it stands between the ends.
    #[inline]
    fn within(self, versine: Versine16) -> Option<Fraction16> {
        let past = versine.to_bits().wrapping_sub(self.inner);
        (past < self.width).then(|| Fraction16((self.one - (past >> self.shift) * self.mantissa) >> 16))
    }

    /// Where it stands at or beyond one of them.
    #[inline]
    fn end(self, versine: Versine16) -> Fraction16 {
        Fraction16(if versine.to_bits() < self.inner { 1 << 15 } else { 0 })
    }

    /// Where a versine stands on the ramp, with all bits that it has.
    #[inline(always)] // `spot-soft` on Cortex-M0: +21 without.
    pub(super) fn rise_finely(self, versine: Versine16) -> Fine16 {
        let versine = versine.to_bits();
        let past = versine.wrapping_sub(self.inner);
        if past >= self.width.max(self.fine) {
            return if versine < self.inner { Fine16::ONE } else { Fine16(0) };
        }
        let fallen = if self.fine_shift < u32::BITS {
            high_half(past.wrapping_shl(u32::BITS - self.fine_shift), self.fine_mantissa)
        } else {
            high_half(past, self.fine_mantissa) >> (self.fine_shift - u32::BITS)
        };
        Fine16(Fine16::ONE.0.saturating_sub(fallen))
    }
}

/// The zoom of a ramp that ends at this versine.
pub(super) fn zoom(limit: f32) -> u32 {
    (1..=MOST_ZOOM).take_while(|&zoom| magnified(limit, zoom).to_bits() <= 2 << 29).last().unwrap_or(0)
}

/// The nearest versine times `4^zoom`, saturating; NaN becomes zero.
pub(super) fn magnified(value: f32, zoom: u32) -> Versine16 {
    Versine16::from_bits(rounded(value * (1_u64 << (29 + 2 * zoom)) as f32) as u32)
}
