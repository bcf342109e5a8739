//! The fit of a falloff to a beam and a field angle.
//!
//! Two angles determine the ratio of their versines, `r = field_versine / beam_versine`. A
//! quadratic follows from `r` in closed form. A cubic has one more degree of freedom, its edge
//! slope `a`: the derivative with respect to `t` at the edge. With `a` given, bisection finds the
//! middle slope `d`: the derivative at `t = 1`.

use super::{Cubic, Quadratic, SoftPair, cubic::middle_slopes};
use crate::{search::bisect, trig};

/// The ratio `r` of the hard falloff, the smallest ratio of all quadratics: `3 sqrt(2) / sqrt(10)`.
pub(crate) const HARD_RATIO: f32 = 1.341_640_8;
/// The ratio `r` of the soft falloff, the largest ratio of all quadratics.
pub(crate) const SOFT_RATIO: f32 = 2.334_553_2;
/// The smallest ratio `r` that is accepted for a cubic. With an edge slope of 3.97 a cubic has the
/// slightly smaller ratio 1.1585.
pub(crate) const LEAST_RATIO: f32 = 1.160_4;
/// The largest ratio `r` of a cubic.
pub(crate) const MOST_RATIO: f32 = 5.437;
/// The largest ratio `r` of a soft pair, whose narrow falloff then has a ratio of 1024.
pub(crate) const MOST_SOFT_RATIO: f32 = 862.3;
/// The default edge slope. Cubics with this edge slope have every ratio from 1.46 to
/// [`MOST_RATIO`].
pub(crate) const DEFAULT_SLOPE: f32 = 1.34;

/// Returns the quadratic with this ratio, which is between the ratios of hard and soft.
///
/// Let `x` be the `u` of the beam angle, and `g = a - 1`. Then `1 - f = g u^2 + (1 - g) u` is 1/2
/// at `u = x` and 9/10 at `u = r x`. These two equations are linear in `p = g x^2` and
/// `q = (1 - g) x`. With `p` and `q` known, `x` solves `x^2 - q x - p = 0`.
pub(crate) fn quadratic(ratio: f32) -> Quadratic {
    let p = (0.9 - 0.5 * ratio) / (ratio * (ratio - 1.0));
    let q = 0.5 - p;
    let x = (q + trig::sqrt(q * q + 4.0 * p)) / 2.0;
    Quadratic::nearest(1.0 + p / (x * x))
}

/// Returns the cubic with this ratio and an edge slope in [0, 4], if one exists. Of two solutions
/// the function takes that with the smaller middle slope. The minimum derivative of that cubic is
/// larger, so no ring is visible between axis and edge.
pub(crate) fn cubic(edge_slope: f32, ratio: f32) -> Option<Cubic> {
    let (least, most) = middle_slopes(edge_slope);
    let farthest = if ratio_of(edge_slope, most) >= ratio { most } else { turn(edge_slope) };
    if ratio_of(edge_slope, least) > ratio || ratio_of(edge_slope, farthest) < ratio {
        return None;
    }
    let middle_slope = bisect(least, farthest, |middle| ratio_of(edge_slope, middle) < ratio);
    Some(Cubic::nearest(edge_slope, middle_slope))
}

/// Returns the soft pair whose beam and field angle have these versines, if an outer angle of at most 180 degrees has
/// one. The ratio of the versines is over [`SOFT_RATIO`].
///
/// Let `x` be the `u` of the field angle, where the wide falloff is alone, and `x / r` that of the beam angle, where the
/// narrow one is `p`. Then `(1 - k) (1 - x)^2` is 1/10 and `(1 - k) (1 - x/r)^2 + k p^2` is 1/2. The first equation gives
/// `k`; without `k` the second is `(5 - 10 p^2) (1 - x)^2 = (1 - x/r)^2 - p^2`, a quadratic in `x` for a given `p`.
/// The pair with the least slope on the axis, which is the largest, has a `p` of 0.404 to 0.406; of [`NARROW_AT_BEAM`]
/// that slope is within 1e-5 of the least. If its outer angle were over 180 degrees, `x` is that of 180 degrees and the
/// first equation gives `k`, the second `p`.
pub(crate) fn soft_pair(beam: f32, field: f32) -> Option<SoftPair> {
    let inverse = beam / field;
    let square = NARROW_AT_BEAM * NARROW_AT_BEAM;
    let factor = 5.0 - 10.0 * square;
    let (a, b, c) = (factor - inverse * inverse, factor - inverse, factor - 1.0 + square);
    let best = c / (b + trig::sqrt(b * b - a * c));
    let share_at = |x: f32| 1.0 - 0.1 / ((1.0 - x) * (1.0 - x));
    let (x, narrow) = if best >= field {
        (best, NARROW_AT_BEAM)
    } else {
        let (share, wide) = (share_at(field), 1.0 - beam);
        let left = 0.5 - (1.0 - share) * wide * wide;
        // Below 0 the wide falloff alone is over 1/2 at the beam angle.
        (field, if left >= 0.0 { trig::sqrt(left / share) } else { return None })
    };
    SoftPair::new(share_at(x).clamp(0.0, 1.0), (1.0 - narrow) / (x * inverse)).ok()
}

/// The narrow falloff at the beam angle.
const NARROW_AT_BEAM: f32 = 0.404;

/// Returns the range of edge slopes for which a cubic has this ratio. The ratio is in
/// [[`LEAST_RATIO`], [`MOST_RATIO`]].
pub(crate) fn edge_slopes(ratio: f32) -> (f32, f32) {
    let lowest = |edge_slope| ratio_of(edge_slope, middle_slopes(edge_slope).0);
    let highest = |edge_slope| ratio_of(edge_slope, turn(edge_slope));
    let least = if lowest(0.0) > ratio {
        bisect(0.0, 3.97, |edge_slope| lowest(edge_slope) > ratio)
    } else if highest(0.0) < ratio {
        bisect(0.0, DEFAULT_SLOPE, |edge_slope| highest(edge_slope) < ratio)
    } else {
        0.0
    };
    let most =
        bisect(DEFAULT_SLOPE, 4.0, |edge_slope| ratio_of(edge_slope, middle_slopes(edge_slope).1) > ratio);
    (if least > 0.0 { least + INWARDS } else { least }, most - INWARDS)
}

/// Margin by which the range of edge slopes is narrowed, so that a cubic exists in f32 at both
/// ends.
const INWARDS: f32 = 2e-5;

/// Returns the ratio of the cubic with these slopes.
fn ratio_of(edge_slope: f32, middle_slope: f32) -> f32 {
    Cubic::exactly(edge_slope, middle_slope).ratio()
}

/// Returns the middle slope with the largest ratio for an edge slope. For edge slopes from about
/// 0.7 up, the ratio increases with the middle slope. For smaller edge slopes, the ratio has one
/// maximum.
fn turn(edge_slope: f32) -> f32 {
    let (least, most) = middle_slopes(edge_slope);
    // The ratios of middle slopes that are closer than this are equal in f32.
    const STEP: f32 = 1e-2;
    let rises = |middle| ratio_of(edge_slope, middle + STEP) > ratio_of(edge_slope, middle);
    if most - least < STEP || rises(most - STEP) {
        most
    } else {
        bisect(least, most - STEP, rises) + STEP / 2.0
    }
}
