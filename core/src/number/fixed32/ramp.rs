//! The ramp from the edge of a cone to its middle, in 32 bits.

use crate::number::{Versine32, fraction::Fraction32, rounded};

/// A versine of no more than this is one on the axis: each component of a direction, of the axis as of the way to a
/// point, is within a unit in the last place of the exact one, so that two of the same direction are at most 2 units
/// apart in each.
const ON_AXIS: u64 = 3 * 2 * 2;

/// A ramp: from the gap between a versine and the outer one to `t`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ramp32 {
    /// From here on there is no light: the outer versine, or that of a tighter cutoff.
    limit: u64,
    outer: u64,
    /// From here on inwards there is all the light: the inner versine, or [`ON_AXIS`].
    inner: u64,
    span: u64,
    /// Takes the span to at most 32 bits.
    shift: u32,
    /// `2^63` over the shifted span.
    mantissa: u64,
    /// Half a unit of what a shifted gap has lost, and half a step of the result: both roundings in one addition.
    half: u64,
}

impl Ramp32 {
    /// The ramp of these bits, in the order of the fields. Those that no ramp has are brought to where every versine has a
    /// place.
    pub const fn from_bits([limit, outer, inner, span, shift, mantissa, half]: [u64; 7]) -> Self {
        // What the longest product short of the span must stay within, with `half`, to be one at most.
        const MOST: u64 = (1 << 63) + (1 << 32) - 1;
        let shift = shift as u32 % u64::BITS;
        let steps = span.saturating_sub(1) >> shift;
        let mantissa = if steps.saturating_mul(mantissa) <= MOST { mantissa } else { 0 };
        let room = MOST - steps * mantissa;
        Self {
            limit: if limit < outer { limit } else { outer },
            outer,
            // Beyond the span a gap would be rounded past one.
            inner: if inner > outer.saturating_sub(span) { inner } else { outer.saturating_sub(span) },
            span,
            shift,
            mantissa,
            half: if half < room { half } else { room },
        }
    }

    /// The bits, in the order of the fields.
    pub const fn to_bits(self) -> [u64; 7] {
        [self.limit, self.outer, self.inner, self.span, self.shift as u64, self.mantissa, self.half]
    }

    /// The ramp between two versines, cut off at a limit.
    pub(super) fn new(inner: f32, outer: f32, limit: f32) -> Self {
        let [inner, outer, limit] = [inner, outer, limit].map(|versine| nearest_versine(versine).to_bits());
        let span = outer.saturating_sub(inner);
        let shift = (u64::BITS - span.leading_zeros()).saturating_sub(32);
        let divisor = (span >> shift).max(1);
        let mantissa = ((1 << 63) + divisor / 2) / divisor;
        let inner = inner.max(ON_AXIS);
        // The largest gap short of the span must not be rounded past one.
        let room = ((1 << 63) + (1 << 32) - 1) - (span.saturating_sub(1) >> shift) * mantissa;
        let half = ((mantissa - (mantissa >> shift)) / 2 + (1 << 31)).min(room);
        Self { limit: limit.min(outer), outer, inner, span, shift, mantissa, half }
    }

    /// Where a versine stands on the ramp.
    #[inline]
    pub(super) fn rise(self, versine: Versine32) -> Fraction32 {
        let versine = versine.to_bits();
        if versine >= self.limit {
            return Fraction32(0);
        }
        if versine <= self.inner {
            return Fraction32(1 << 31);
        }
        Fraction32(((((self.outer - versine) >> self.shift) * self.mantissa + self.half) >> 32) as u32)
    }
}

/// The nearest versine; NaN becomes zero.
pub(super) fn nearest_versine(value: f32) -> Versine32 {
    Versine32::from_bits(rounded(value * (1_u64 << 61) as f32) as u64)
}
