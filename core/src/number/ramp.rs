//! The ramp of a cone in fixed point: the map from versines to the falloff's argument `t`.
//!
//! A ramp is compiled here, and evaluated by the formats: by `FixedRamp::rise` with 15 fraction bits in
//! `fx16.rs`, by `FixedRamp::rise_finely` with 31 in `fx32.rs`.
//!
//! The cones between which a cone zooms are interpolated by their *chords*: the chord of an angle with
//! versine `v` is `sqrt(v)`, that is `sqrt(2) sin(angle / 2)`. It grows nearly in proportion to the
//! angle.

use super::{
    Fx32, Versine,
    root::{self, high_half, inverse_32},
    rounded,
};
use crate::{trig, vec3::Vec3};

/// The largest zoom of a ramp, which scales versines by `4^zoom`. A larger zoom would need more
/// bits than a direction has.
pub(crate) const MOST_ZOOM: u32 = 15;

/// A ramp: maps the excess of a versine over the inner versine to the falloff's argument `t`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FixedRamp {
    /// The versines of this ramp are scaled by `4^zoom`.
    pub(crate) zoom: u32,
    /// Inner versine, up to which the intensity is full.
    pub(super) inner: u32,
    /// Excess over the inner versine at which the intensity becomes zero.
    ///
    /// The intensity becomes zero at the outer versine, or at the versine of a narrower cutoff.
    pub(super) width: u32,
    /// Right shift that brings the span from inner to outer versine to at most 16 bits.
    pub(super) shift: u32,
    /// `2^31` divided by the shifted span.
    pub(super) mantissa: u32,
    /// Number from which the product of shifted excess and `mantissa` is subtracted.
    ///
    /// The number is 1 with 31 fraction bits, plus half a step of the result, less half the
    /// truncation error of a shifted excess.
    pub(super) one: u32,
    /// The width of a ramp that is always evaluated finely; 0 for any other ramp.
    ///
    /// The field `width` of such a ramp is 0.
    pub(super) fine: u32,
    /// Bit length of the span from inner to outer versine.
    fine_shift: u32,
    /// `2^63` divided by the span after a shift to 32 bits.
    fine_mantissa: u32,
}

impl FixedRamp {
    /// Restores a ramp from its bits, in the order of the fields.
    ///
    /// Invalid values are replaced, so that every versine gives a `t` in `[0, 1]`.
    pub const fn from_bits(bits: [u32; 9]) -> Self {
        /// Largest value of `one` with which the inner versine gives a `t` of at most 1.
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

    /// Returns the bits, in the order of the fields.
    pub const fn to_bits(self) -> [u32; 9] {
        let Self { zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa } = self;
        [zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa]
    }

    /// Builds the ramp between two versines, with `t = 0` from the versine `limit` on.
    pub(super) fn new(inner: f32, outer: f32, limit: f32) -> Self {
        // The zoom is such that the scaled limit is at most 2, the square of the largest component
        // of a difference that `versine_between` accepts. A difference with a larger component is
        // beyond the limit.
        Self::with_zoom(inner, outer, limit, zoom(if limit < outer { limit } else { outer }))
    }

    /// Builds the ramp of [`new`](Self::new) with a given zoom: versines are scaled by `4^zoom`.
    pub(super) fn with_zoom(inner: f32, outer: f32, limit: f32, zoom: u32) -> Self {
        let limit = if limit < outer { limit } else { outer };
        let [inner, limit] = [inner, limit].map(|versine| magnified(versine, zoom).to_bits());
        let outer = rounded(outer * (1_u64 << (29 + 2 * zoom)) as f32) as u64;
        let span = outer.saturating_sub(inner.into()).max(1);
        let divisor = ((span << span.leading_zeros()) >> 32) as u32;
        Self::with_span(zoom, inner, limit, divisor, u64::BITS - span.leading_zeros())
    }

    /// Builds a ramp whose span from inner to outer versine is `divisor * 2^(fine_shift - 32)`. The
    /// upper bit of the divisor is set.
    ///
    /// The mantissas divide by the whole span: the bits that the shifted span loses would change
    /// the slope of the ramp.
    fn with_span(zoom: u32, inner: u32, limit: u32, divisor: u32, fine_shift: u32) -> Self {
        let fine_mantissa = inverse_32(divisor);
        let shift = fine_shift.saturating_sub(16).min(31);
        let mantissa = (fine_mantissa >> (fine_shift - shift - 1)).div_ceil(2);
        let width = limit.saturating_sub(inner);
        let one = (1 << 31) + (1 << 15) - (mantissa - (mantissa >> shift)) / 2;
        // The last versine before the limit must not give a negative `t`.
        let one = one.max((width.saturating_sub(1) >> shift).wrapping_mul(mantissa));
        let inner = inner.min(limit);
        Self { zoom, inner, width, shift, mantissa, one, fine: 0, fine_shift, fine_mantissa }
    }

    /// Returns the nearest versine in the scale of this ramp; saturates, and NaN becomes the largest.
    pub(super) fn versine(self, value: f32) -> Versine {
        if value.is_nan() { Versine::MAX } else { magnified(value, self.zoom) }
    }

    /// Returns the ramp between this ramp and another one, and the chords of its cone.
    ///
    /// `part` has 32 fraction bits, and `most` is the largest zoom. The ramp is fine if one of the
    /// two ramps is.
    pub(super) fn between(self, other: Self, part: u32, most: u32) -> (Self, Chords) {
        let chords = self.chords().between(other.chords(), part);
        let ramp = Self::of_chords(chords, most);
        (if self.fine > 0 || other.fine > 0 { ramp.into_fine() } else { ramp }, chords)
    }

    /// Builds the ramp of a cone with these chords, with the largest zoom up to `most`.
    pub(crate) fn of_chords(Chords { inner, outer, limit }: Chords, most: u32) -> Self {
        let zoom = chord_zoom(limit, most);
        let [start, end] = [inner, limit].map(|chord| squared(chord, zoom));
        let (span, less) = if outer > limit {
            // A cutoff may be so narrow that the outer versine is out of range in the scale of the
            // ramp.
            let wide = chord_zoom(outer, zoom);
            (squared(outer, wide).saturating_sub(squared(inner, wide)), zoom - wide)
        } else {
            (end.saturating_sub(start), 0)
        };
        let (span, bits) = (span.max(1), root::bit_length(span));
        Self::with_span(zoom, start, end, span << (u32::BITS - bits), bits + 2 * less)
    }

    /// Returns the chords of the cone. A cone whose cutoff is within its hotspot counts as a step.
    fn chords(self) -> Chords {
        let (width, zoom) = (self.width.max(self.fine), self.zoom);
        let limit = zoomed_chord(self.limit(), zoom);
        let inner = if self.inner > 0 { zoomed_chord(self.inner, zoom).min(limit) } else { 0 };
        // Without a cutoff, `t` is zero at the limit, but for roundings.
        let is_cut = width > 0 && self.fallen(width) < (1 << 31) - 4;
        Chords { inner, outer: if is_cut { self.outer_chord().max(limit) } else { limit }, limit }
    }

    /// Returns the chord of the outer versine, which the ramp has only as a reciprocal.
    #[cold]
    fn outer_chord(self) -> u32 {
        let divisor = u64::from(inverse_32(self.fine_mantissa | 1 << 31));
        let span = (divisor << self.fine_shift.saturating_sub(32)) >> 32_u32.saturating_sub(self.fine_shift);
        let outer = (u64::from(self.inner) + span).min(1 << (30 + 2 * self.zoom));
        chord(outer << (32 - 2 * self.zoom))
    }

    /// Returns the same ramp as a fine ramp, which always has the fine evaluation.
    pub(crate) fn into_fine(self) -> Self {
        Self { width: 0, fine: self.width, ..self }
    }

    /// Returns the versine from which on the intensity is zero.
    pub(crate) fn limit(self) -> u32 {
        self.inner.saturating_add(self.width.max(self.fine))
    }

    /// Returns `1 - t` at an excess over the inner versine, with 31 fraction bits.
    #[inline(always)]
    pub(super) fn fallen(self, past: u32) -> u32 {
        if self.fine_shift < u32::BITS {
            high_half(past.wrapping_shl(u32::BITS - self.fine_shift), self.fine_mantissa)
        } else {
            high_half(past, self.fine_mantissa) >> (self.fine_shift - u32::BITS)
        }
    }
}

/// Returns the zoom of a ramp that ends at this versine.
pub(super) fn zoom(limit: f32) -> u32 {
    (1..=MOST_ZOOM).take_while(|&zoom| magnified(limit, zoom).to_bits() <= 2 << 29).last().unwrap_or(0)
}

/// Returns the nearest versine times `4^zoom`; saturates, and NaN becomes zero.
fn magnified(value: f32, zoom: u32) -> Versine {
    Versine::from_bits(rounded(value * (1_u64 << (29 + 2 * zoom)) as f32) as u32)
}

/// `Errors::CHORD_ERROR` of a ramp in fixed point.
///
/// A root has the first part. The outer chord of a cone with a cutoff has the second, half of the error of its versine: that comes
/// from two reciprocals, each within 2^-31, of a divisor of 32 bits, as a span rounded down by a unit of 2^-29 of at least a half.
pub(super) const CHORD_ERROR: f32 = 7.5e-9 + 2.6e-9;

/// `Errors::CHORD_STEP` of a ramp in fixed point: less than three units of 2^-31. A root is off by two, which is one before the
/// shift by a zoom and one of that shift, and a chord between by one more. At the largest zoom the unit of a versine is
/// as much as 0.002 of a chord's.
pub(super) const CHORD_STEP: f32 = 3.01 / (1_u32 << 31) as f32;

/// Returns `Errors::edge_error` of a ramp in fixed point.
///
/// In the scale of the ramp a versine is rounded by half a unit of 2^-29, and the last one is more than a half
/// unless the zoom is the largest. Two such roundings of the edge weigh `1 - t` and `t`, one in all. With a cutoff the span
/// has two of its own. An argument of up to 4 units of 2^-31 at the end counts as no cutoff, which moves `t` by as much.
pub(super) fn edge_error(outer: f32) -> f32 {
    const UNIT: f32 = 1.0 / (1_u64 << (29 + 2 * MOST_ZOOM)) as f32;
    7.5e-9 + 1.5 * UNIT / outer
}

/// Returns `Errors::inner_chord_error` of a ramp in fixed point.
///
/// A ramp rounds an inner versine to its unit: less than half of it counts as no hotspot.
pub(super) fn inner_chord_error(inner: f32, limit: f32) -> f32 {
    let half = 0.5 / (1_u64 << (29 + 2 * zoom(limit))) as f32;
    let chord = trig::sqrt(inner);
    if inner > half { half / (chord + trig::sqrt(inner - half)) } else { chord }
}

/// The largest chord: `sqrt(2)` with 31 fraction bits, of a versine of 2.
pub(crate) const LARGEST: u32 = 3_037_000_499;

/// The chords of a cone's inner and outer angle and of its cutoff, with 31 fraction bits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chords {
    /// The chord up to which the intensity is full, at most `limit`.
    inner: u32,
    /// The chord at which the falloff ends, at least `limit`.
    outer: u32,
    /// The chord from which on the intensity is zero.
    limit: u32,
}

impl Chords {
    /// Returns the chords of a cone without a cutoff.
    pub(crate) fn open(inner: u32, outer: u32) -> Self {
        Self { inner, outer, limit: outer }
    }

    /// Returns the chords between two cones. `part` has 32 fraction bits.
    fn between(self, other: Self, part: u32) -> Self {
        let limit = between(self.limit, other.limit, part);
        let is_cut = self.limit < self.outer || other.limit < other.outer;
        let outer = if is_cut { between(self.outer, other.outer, part).max(limit) } else { limit };
        Self { inner: between(self.inner, other.inner, part).min(limit), outer, limit }
    }

    /// Returns the squared cosine of the limit, with 30 fraction bits and an error of less than 2
    /// units; zero from a right angle on.
    pub(super) fn squared_cosine(self) -> u32 {
        let cosine = (1_u32 << 30).saturating_sub(high_half(self.limit, self.limit)) << 1;
        high_half(cosine, cosine)
    }
}

/// Returns the number between two numbers. `part` has 32 fraction bits.
fn between(from: u32, to: u32, part: u32) -> u32 {
    if from <= to { from + high_half(to - from, part) } else { from - high_half(from - to, part) }
}

/// Returns the chord of a versine with 61 fraction bits. A versine over 2 counts as 2.
///
/// The relative error is at most 7.5e-9 and the absolute error less than 2 units, as for all
/// functions here.
fn chord(versine: u64) -> u32 {
    root::sqrt_64(2 * versine.min(1 << 62)).min(LARGEST)
}

/// Returns the chord of a versine with `29 + 2 zoom` fraction bits. A versine over `2 / 4^zoom`
/// counts as this number.
fn zoomed_chord(versine: u32, zoom: u32) -> u32 {
    root::sqrt_32(2 * versine.min(1 << 30)).min(LARGEST) >> zoom
}

/// Returns the versine of a chord times `4^zoom`, with 29 fraction bits, rounded to nearest.
fn squared(chord: u32, zoom: u32) -> u32 {
    high_half(chord << zoom, chord << zoom).div_ceil(2)
}

/// Returns the largest zoom up to `most` with which a chord's versine is at most 2.
pub(crate) fn chord_zoom(chord: u32, most: u32) -> u32 {
    let zoom = (u32::BITS - root::bit_length(chord)).min(most);
    if chord << zoom > LARGEST { zoom.saturating_sub(1) } else { zoom }
}

/// Returns whether an offset `v` is certainly outside a cone with this axis. `bound` is the bound of
/// [`Offset::is_outside`](super::Offset::is_outside), with 14 fraction bits.
#[inline]
pub(super) fn is_outside(v: Vec3<i32>, axis: Vec3<Fx32>, bound: i32) -> bool {
    let products = axis.zip(v, |s, v| (s.to_bits() >> 16) * v);
    let along = products.x.wrapping_add(products.y).wrapping_add(products.z) >> 14;
    // The axis has unit length, so 16 bits hold the component of `v` along the axis.
    let along = along.max(0) as u32;
    let bound = u32::from(bound.max(0) as u16);
    along.wrapping_mul(along) < (root::squared_length(v) >> 14).wrapping_mul(bound)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::fx16::Fraction16;
    use crate::number::fx32::Fine;
    use crate::number::proofs::model::Constants;

    extern crate std;

    /// Returns ramps of every width, with hotspots and cutoffs.
    fn ramps() -> impl Iterator<Item = FixedRamp> {
        (0..20_000_u32).flat_map(|i| {
            let outer = (1.0 - i as f32 / 40_000.0) / (1_u32 << (i % 14)) as f32;
            let inner = outer * [0.0, 0.3, 0.97][i as usize % 3];
            [outer, outer - 0.4 * (outer - inner)].map(|limit| FixedRamp::new(inner, outer, limit))
        })
    }

    /// Integers of 24 bits are versines as they are: half a unit more would be rounded to the next even one.
    #[test]
    fn the_outer_versine_is_the_nearest() {
        for units in (1_u32 << 23..1 << 24).step_by(1_001) {
            let versine = units as f32 / (1_u32 << 29) as f32;
            let ramp = FixedRamp::with_zoom(0.0, versine, versine, 0);
            assert_eq!(ramp.fine_mantissa, inverse_32(units << 8), "{units}");
        }
    }

    #[test]
    fn a_ramp_keeps_its_bits() {
        for ramp in ramps().flat_map(|ramp| [ramp, ramp.into_fine()]) {
            assert_eq!(FixedRamp::from_bits(ramp.to_bits()), ramp);
        }
    }

    #[test]
    fn bits_beyond_their_limits_are_replaced() {
        const MOST: u32 = (1 << 31) + (1 << 16) - 1;
        let most = FixedRamp::from_bits([u32::MAX; 9]).to_bits();
        assert_eq!(most, [15, u32::MAX, 0, 31, u32::MAX, MOST, u32::MAX, 63, u32::MAX]);
        let mantissa =
            |width, mantissa| FixedRamp::from_bits([0, 0, width, 0, mantissa, 1 << 31, 0, 0, 0]).mantissa;
        assert_eq!([mantissa(2, 1 << 31), mantissa(2, (1 << 31) + 1)], [1 << 31, 0]);
        assert_eq!([mantissa(3, 1 << 30), mantissa(3, (1 << 30) + 1)], [1 << 30, 0]);
    }

    /// A step is full inside its edge, and dark from its edge on.
    #[test]
    fn a_step_is_dark_from_its_edge_on() {
        for versine in [1.0, 0.3, 1e-3] {
            let ramp = FixedRamp::new(versine, versine, versine);
            let edge = magnified(versine, ramp.zoom).to_bits();
            let [inside, on] = [edge - 1, edge].map(Versine::from_bits);
            assert_eq!([inside, on].map(|v| ramp.rise(v)), [Fraction16(1 << 15), Fraction16(0)]);
            let ramp = ramp.into_fine();
            assert_eq!([inside, on].map(|v| ramp.rise_finely(v)), [Fine::ONE, Fine(0)]);
        }
    }

    /// A wide ramp with a narrow cutoff keeps the precision of `t`.
    ///
    /// The difference between the outer and the inner versine then has many more bits than any
    /// versine inside the cutoff.
    #[test]
    fn a_cutoff_may_be_narrow_within_a_wide_ramp() {
        for shift in 8..29 {
            let limit = 1.0 / (1_u32 << shift) as f32;
            let ramp = FixedRamp::new(0.0, 1.0, limit);
            for share in [0.0, 0.5, 0.99] {
                let t = ramp.rise(magnified(limit * share, ramp.zoom));
                let error = f64::from(t.0) / 32_768.0 - f64::from(1.0 - limit * share);
                assert!(error.abs() < 1e-4, "off by {error} within {limit}");
            }
        }
    }

    /// Returns pairs of ramps, a part with 32 fraction bits, and the ramp between the two.
    fn zooms() -> impl Iterator<Item = ([FixedRamp; 2], u32, FixedRamp)> {
        let zooms = ramps().zip(ramps().skip(7_919)).enumerate();
        zooms.map(|(i, (from, to))| {
            let part = (i as u32 + 1).wrapping_mul(0x9e37_79b9);
            ([from, to], part, from.between(to, part, if i % 3 == 0 { 0 } else { MOST_ZOOM }).0)
        })
    }

    #[test]
    fn a_ramp_between_keeps_its_bits() {
        for (ends, part, ramp) in zooms() {
            assert_eq!(FixedRamp::from_bits(ramp.to_bits()), ramp, "{ends:?} {part}");
        }
    }

    /// Returns the inner versine, the outer versine and the limit of a ramp. The outer versine is
    /// within 2^-31 of the span of that from which the ramp was built.
    fn exact(ramp: FixedRamp) -> [f64; 3] {
        let unit = 0.5_f64.powi(29 + 2 * ramp.zoom as i32);
        let span = 2_f64.powi(ramp.fine_shift as i32 + 31) / f64::from(ramp.fine_mantissa);
        let inner = f64::from(ramp.inner);
        [inner, inner + span, f64::from(ramp.limit())].map(|versine| versine * unit)
    }

    /// The versines are those between, relative to the limit, and `t` is that of these versines
    /// times the width of the edge.
    #[test]
    fn a_ramp_between_has_the_versines_between() {
        let (mut of_versines, mut of_fine, mut of_coarse) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (ends, part, ramp) in zooms().filter(|(.., ramp)| ramp.zoom == zoom(exact(*ramp)[2] as f32)) {
            let part = f64::from(part) / 4_294_967_296.0;
            let [from, to] = ends.map(exact);
            let between =
                [0, 1, 2].map(|i| (from[i].sqrt() + (to[i].sqrt() - from[i].sqrt()) * part).powi(2));
            let [inner, outer, limit] = between;
            for (found, exact) in exact(ramp).into_iter().zip(between) {
                of_versines = of_versines.max((found - exact).abs() / limit.max(exact));
            }
            for step in 1..32 {
                let versine = magnified((inner + (limit - inner) * f64::from(step) / 32.0) as f32, ramp.zoom);
                let exact = f64::from(versine.to_bits()) * 0.5_f64.powi(29 + 2 * ramp.zoom as i32);
                let t = ((outer - exact) / (outer - inner)).min(1.0);
                let fine = f64::from(ramp.rise_finely(versine).0) / 2_147_483_648.0;
                let coarse = f64::from(ramp.rise(versine).0) / 32_768.0;
                of_fine = of_fine.max((fine - t).abs() * (1.0 - inner / outer));
                of_coarse = of_coarse.max((coarse - t).abs());
            }
        }
        assert!(
            (1e-7..=2.5e-7).contains(&of_versines),
            "error of versines {of_versines:.2e}, expected 1e-7 to 2.5e-7"
        );
        assert!(
            (1e-7..=1.7e-7).contains(&of_fine),
            "error of a fine t {of_fine:.2e}, expected 1e-7 to 1.7e-7"
        );
        assert!(
            (3e-5..=4e-5).contains(&of_coarse),
            "error of a coarse t {of_coarse:.2e}, expected 3e-5 to 4e-5"
        );
    }

    /// The proofs are about a model of the ramp. It has the bits of the kernel, and raises by no more than
    /// they assume.
    #[test]
    fn the_model_of_the_proofs_has_the_bits_of_a_ramp() {
        let model = Constants::KERNEL;
        for (i, ramp) in ramps().enumerate() {
            let up = 1 << 16_u32.saturating_sub(ramp.fine_shift);
            let mantissa = model.ramp_mantissa(i128::from(ramp.fine_mantissa), up);
            assert_eq!(i128::from(ramp.mantissa), mantissa, "{ramp:?}");
            let step = 1 << ramp.shift;
            let raised = i128::from(ramp.one) - model.risen(mantissa, step, 0, 0);
            assert!((0..=32_769).contains(&raised), "{ramp:?}: raised by {raised}");
            let past = (i as u32).wrapping_mul(0x9e37_79b9) % ramp.width.max(1);
            if ramp.width > 0 {
                let t = model.risen(mantissa, step, i128::from(past) / step, raised) >> 16;
                let found = ramp.rise(Versine::from_bits(ramp.inner + past)).0;
                assert_eq!(i128::from(found), t, "{ramp:?} {past}");
            }
            let short = 32_u32.saturating_sub(ramp.fine_shift);
            let long = ramp.fine_shift.saturating_sub(32);
            let fallen = model.fallen(i128::from(past) << short, ramp.fine_mantissa.into(), 1 << long);
            assert_eq!(i128::from(ramp.fallen(past)), fallen, "{ramp:?} {past}");
        }
    }
}
