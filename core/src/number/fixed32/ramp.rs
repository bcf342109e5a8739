//! The ramp of a cone in the 32-bit format: the map from versines to the falloff's argument `t`.

use crate::number::{
    Versine32,
    chord::{self, Chords},
    fraction::Fraction32,
    reciprocal::inverse_32,
    root, rounded,
};

/// Largest versine that counts as zero, that is, as that of a direction on the axis.
///
/// Each component of a direction, whether of the axis or to a point, is within one ULP of its exact
/// value. So two computed values of the same direction differ by at most 2 ULPs in each component.
const ON_AXIS: u64 = 3 * 2 * 2;

/// A ramp: maps the gap between a versine and the outer versine to the falloff's argument `t`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ramp32 {
    /// Versine from which on the intensity is zero: the outer versine, or the versine of a narrower
    /// cutoff.
    limit: u64,
    outer: u64,
    /// Versine up to which the intensity is full: the larger of the inner versine and [`ON_AXIS`].
    inner: u64,
    span: u64,
    /// Right shift that brings the span to at most 32 bits.
    shift: u32,
    /// `2^63` divided by the shifted span.
    mantissa: u64,
    /// Sum of two rounding constants: half the truncation error of a shifted gap, and half a step
    /// of the result.
    half: u64,
}

impl Ramp32 {
    /// Restores a ramp from its bits, in the order of the fields.
    ///
    /// Invalid values are replaced, so that every versine gives a `t` in `[0, 1]`.
    pub const fn from_bits([limit, outer, inner, span, shift, mantissa, half]: [u64; 7]) -> Self {
        // Largest sum for which `t` is at most 1: of `half`, and of `mantissa` times a shifted gap
        // less than the span.
        const MOST: u64 = (1 << 63) + (1 << 32) - 1;
        let shift = shift as u32 % u64::BITS;
        let steps = span.saturating_sub(1) >> shift;
        let mantissa = if steps.saturating_mul(mantissa) <= MOST { mantissa } else { 0 };
        let room = MOST - steps * mantissa;
        Self {
            limit: if limit < outer { limit } else { outer },
            outer,
            // A gap larger than the span would give a `t` over 1.
            inner: if inner > outer.saturating_sub(span) { inner } else { outer.saturating_sub(span) },
            span,
            shift,
            mantissa,
            half: if half < room { half } else { room },
        }
    }

    /// Returns the bits, in the order of the fields.
    pub const fn to_bits(self) -> [u64; 7] {
        [self.limit, self.outer, self.inner, self.span, self.shift as u64, self.mantissa, self.half]
    }

    /// Builds the ramp between two versines, with `t = 0` from the versine `limit` on.
    pub(super) fn new(inner: f32, outer: f32, limit: f32) -> Self {
        let [inner, outer, limit] = [inner, outer, limit].map(|versine| nearest_versine(versine).to_bits());
        let span = outer.saturating_sub(inner);
        let shift = (u64::BITS - span.leading_zeros()).saturating_sub(32);
        let divisor = (span >> shift).max(1);
        let mantissa = ((1 << 63) + divisor / 2) / divisor;
        Self::with_mantissa([inner, outer, limit], shift, mantissa)
    }

    /// Builds a ramp from its versines, the shift of its span and the reciprocal of the shifted
    /// span.
    fn with_mantissa([inner, outer, limit]: [u64; 3], shift: u32, mantissa: u64) -> Self {
        let span = outer.saturating_sub(inner);
        let inner = inner.max(ON_AXIS);
        // The largest gap that is less than the span must not give a `t` over 1.
        let room = ((1 << 63) + (1 << 32) - 1) - (span.saturating_sub(1) >> shift) * mantissa;
        let half = ((mantissa - (mantissa >> shift)) / 2 + (1 << 31)).min(room);
        Self { limit: limit.min(outer), outer, inner, span, shift, mantissa, half }
    }

    /// Returns the ramp between this ramp and another one, and the chords of its cone.
    ///
    /// `part` has 32 fraction bits.
    pub(super) fn between(self, other: Self, part: u32) -> (Self, Chords) {
        let chords = self.chords().between(other.chords(), part);
        let Chords { inner, outer, limit } = chords;
        let versines = [inner, outer, limit].map(|chord| (u64::from(chord) * u64::from(chord)) >> 1);
        let span = versines[1].saturating_sub(versines[0]);
        let shift = root::bit_length((span >> 31) as u32) - 1;
        let divisor = ((span >> shift) as u32).max(1);
        let less = u32::BITS - root::bit_length(divisor);
        // The mantissa is rounded down to 32 bits, so the largest gap gives no `t` over 1.
        let mantissa = u64::from(inverse_32(divisor << less)) << less;
        (Self::with_mantissa(versines, shift, mantissa), chords)
    }

    /// Returns the chords of the cone.
    fn chords(self) -> Chords {
        let outer = chord::chord(self.outer);
        let limit = if self.limit < self.outer { chord::chord(self.limit) } else { outer };
        let inner = chord::chord(self.outer.saturating_sub(self.span));
        Chords { inner, outer, limit }
    }

    /// Returns the falloff's argument `t` at a versine.
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

/// Returns the nearest versine; NaN becomes zero.
pub(super) fn nearest_versine(value: f32) -> Versine32 {
    Versine32::from_bits(rounded(value * (1_u64 << 61) as f32) as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns ramps of every width, with hotspots and cutoffs.
    fn ramps() -> impl Iterator<Item = Ramp32> {
        (0..40_000_u32).flat_map(|i| {
            let outer = (1.0 - i as f32 / 80_000.0) / (1_u32 << (i % 30)) as f32;
            let inner = outer * [0.0, 0.3, 0.97][i as usize % 3];
            [outer, outer - 0.4 * (outer - inner)].map(|limit| Ramp32::new(inner, outer, limit))
        })
    }

    #[test]
    fn a_ramp_keeps_its_bits() {
        let steps = [1.0, 0.3, 1e-3, 1e-9].map(|versine| Ramp32::new(versine, versine, versine));
        for ramp in ramps().chain(steps) {
            assert_eq!(Ramp32::from_bits(ramp.to_bits()), ramp);
        }
    }

    /// At versines next to the hotspot, rounding must not give a `t` over 1.
    #[test]
    fn a_ramp_ends_at_one() {
        let mut reached = 0;
        // Ramps with a mantissa that is rounded up, for a span whose lower bits are all set.
        let full = |i: u32| Ramp32::new(1e-12, 0.5 + i as f32 / 16_777_216.0, 1.0);
        for ramp in ramps().chain((0..4_000).map(full)) {
            let rise = |beyond| ramp.rise(Versine32::from_bits(ramp.inner + beyond)).0;
            let rises = [1, 2, 1 << ramp.shift].map(rise);
            assert!(rises.iter().all(|rise| *rise <= 1 << 31), "{ramp:?}: {rises:?}, expected at most 2^31");
            reached += u32::from(rises[0] == 1 << 31);
        }
        assert!(reached > 1_000, "only {reached} ramps are rounded to 1");
    }

    /// With a larger `mantissa` or `half`, the ramp would give a `t` over 1 next to the hotspot.
    #[test]
    fn bits_beyond_their_limits_are_replaced() {
        const MOST: u64 = (1 << 63) + (1 << 32) - 1;
        let ramp = Ramp32::from_bits([u64::MAX, 9, 0, 3, 64, MOST / 2, u64::MAX]);
        assert_eq!(ramp.to_bits(), [9, 9, 6, 3, 0, MOST / 2, 1]);
        let largest = Ramp32::from_bits([0, 9, 0, 2, 0, MOST, 0]);
        assert_eq!(largest.to_bits(), [0, 9, 7, 2, 0, MOST, 0]);
        assert_eq!(Ramp32::from_bits([0, 9, 0, 3, 0, MOST / 2 + 1, 7]).to_bits(), [0, 9, 6, 3, 0, 0, 7]);
    }

    /// The chords are those between within 2 units of 2^-31 and 6e-9, and `t` is that of the ramp's
    /// versines within 1.8 units of 2^-31.
    #[test]
    fn a_ramp_between_has_the_versines_between() {
        let (mut of_chords, mut of_t) = (0.0_f64, 0.0_f64);
        let zooms = ramps().zip(ramps().skip(11_003)).enumerate();
        for (i, (from, to)) in zooms {
            let part = (i as u32 + 1).wrapping_mul(0x9e37_79b9);
            let ramp = from.between(to, part).0;
            assert_eq!(Ramp32::from_bits(ramp.to_bits()), ramp, "{from:?} {to:?} {part}");
            let exact = |ramp: Ramp32| {
                let inner = ramp.outer - ramp.span;
                [inner, ramp.outer, ramp.limit].map(|versine| versine as f64 * 0.5_f64.powi(61))
            };
            let part = f64::from(part) / 4_294_967_296.0;
            for ((found, from), to) in exact(ramp).into_iter().zip(exact(from)).zip(exact(to)) {
                let chord = from.sqrt() + (to.sqrt() - from.sqrt()) * part;
                let error = (found.sqrt() - chord).abs();
                of_chords = of_chords.max((error - 6e-9 * chord) * 2_147_483_648.0);
            }
            let [inner, outer, limit] = exact(ramp);
            for step in 1..32 {
                let versine = nearest_versine((inner + (limit - inner) * f64::from(step) / 32.0) as f32);
                let past = versine.to_bits() as f64 * 0.5_f64.powi(61);
                if past < limit && versine.to_bits() > ON_AXIS {
                    let t = ((outer - past) / (outer - inner)).min(1.0);
                    of_t = of_t.max((f64::from(ramp.rise(versine).0) - t * 2_147_483_648.0).abs());
                }
            }
        }
        assert!((1.5..=2.0).contains(&of_chords), "error of chords {of_chords}, expected 1.5 to 2");
        assert!((1.2..=1.8).contains(&of_t), "error of t {of_t}, expected 1.2 to 1.8");
    }
}
