//! The profile that has its beam and field where a data sheet says.
//!
//! What two angles fix is the ratio `r` of their versines: `field_versine / beam_versine` of the profile. A quadratic
//! follows from it in closed form. A cubic has one freedom more, its edge slope `a`; the slope in the middle, `d`, is
//! then found by bisection.

use super::{Cubic, Quadratic, cubic::middle_slopes};
use crate::{search::bisect, trig};

/// The ratio of the hard edge, the smallest of a quadratic: `3 sqrt(2) / sqrt(10)`.
pub(crate) const HARD_RATIO: f32 = 1.341_640_8;
/// The ratio of the soft edge, the largest of a quadratic.
pub(crate) const SOFT_RATIO: f32 = 2.334_553_2;
/// The smallest ratio that is offered of a cubic. A little less, 1.1585, exists at an edge slope of 3.97.
pub(crate) const LEAST_RATIO: f32 = 1.160_4;
/// The largest ratio of a cubic.
pub(crate) const MOST_RATIO: f32 = 5.437;
/// The edge slope whose cubics reach that far: the default, because it has a cubic for every ratio from 1.46.
pub(crate) const DEFAULT_SLOPE: f32 = 1.34;

/// The quadratic of a ratio between those of hard and soft.
///
/// With `x` the beam's `u` and `g = a - 1`, `g u^2 + (1 - g) u` is 1/2 at `x` and 9/10 at `r x`: linear in
/// `p = g x^2` and `q = (1 - g) x`. From these, `x^2 - q x - p = 0`.
pub(crate) fn quadratic(ratio: f32) -> Quadratic {
    let p = (0.9 - 0.5 * ratio) / (ratio * (ratio - 1.0));
    let q = 0.5 - p;
    let x = (q + trig::sqrt(q * q + 4.0 * p)) / 2.0;
    Quadratic::nearest(1.0 + p / (x * x))
}

/// The cubic of a ratio with an edge slope from 0 to 4, if there is one. Of two, the one with the smaller slope in the
/// middle: its smallest slope is the larger one, so that no ring shows in mid-curve.
pub(crate) fn cubic(edge_slope: f32, ratio: f32) -> Option<Cubic> {
    let (least, most) = middle_slopes(edge_slope);
    let farthest = if ratio_of(edge_slope, most) >= ratio { most } else { turn(edge_slope) };
    if ratio_of(edge_slope, least) > ratio || ratio_of(edge_slope, farthest) < ratio {
        return None;
    }
    let middle_slope = bisect(least, farthest, |middle| ratio_of(edge_slope, middle) < ratio);
    Some(Cubic::nearest(edge_slope, middle_slope))
}

/// The smallest and the largest edge slope with which a cubic has a ratio from [`LEAST_RATIO`] to [`MOST_RATIO`].
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

/// What an interval of edge slopes is narrowed by, so that both of its ends have a cubic in f32.
const INWARDS: f32 = 2e-5;

/// The ratio of the cubic with these slopes.
fn ratio_of(edge_slope: f32, middle_slope: f32) -> f32 {
    Cubic::exactly(edge_slope, middle_slope).ratio()
}

/// The middle slope with the largest ratio for an edge slope. From about 0.7 up the ratio only rises with the
/// middle slope; below it turns once.
fn turn(edge_slope: f32) -> f32 {
    let (least, most) = middle_slopes(edge_slope);
    // Slopes closer than this have ratios that f32 does not tell apart.
    const STEP: f32 = 1e-2;
    let rises = |middle| ratio_of(edge_slope, middle + STEP) > ratio_of(edge_slope, middle);
    if most - least < STEP || rises(most - STEP) {
        most
    } else {
        bisect(least, most - STEP, rises) + STEP / 2.0
    }
}
