//! The errors of the stages of `f32`, where each of them comes from.

use crate::number::{Placing, Rounding, Stages};

/// The relative error of a rounding to nearest.
const UNIT: f64 = f32::EPSILON as f64 / 2.0;

/// The axis' squared length has 3 roundings, of which the root takes half; then the root and the division.
pub(in crate::number) const AXIS_LENGTH: f64 = 3.5 * UNIT;
/// The division rounds components.
pub(in crate::number) const AXIS_TURN: f64 = UNIT;

/// The evaluation.
pub(super) const STAGES: Stages = Stages {
    // The squared length has 3 roundings, of which the root takes half; then the root, the division and
    // the product.
    length: 4.5 * UNIT + AXIS_LENGTH,
    // The offset and the product: each rounds components.
    turn: 2.0 * UNIT + AXIS_TURN,
    difference: 0.0,
    // A sum of components, of which the square is taken, and the sum of three squares.
    versine: Rounding::relative(5.0 * UNIT),
    set_up: 0.0,
    // A difference and a product; the reciprocal is that of a rounded difference.
    ramp: Rounding::relative(4.0 * UNIT),
    complement: Rounding::relative(UNIT),
    product: Rounding::relative(UNIT),
    value: Rounding::relative(UNIT),
    // Up to five operations, each of a result up to 4; a coefficient is rounded.
    lift: Rounding::relative(5.0 * 4.0 * UNIT),
    weight: 4.0 * UNIT,
    smooth: Rounding::relative(5.0 * UNIT),
    // The narrow part `w` is a difference, a product and a difference, `(2 - w) UNIT` in all; its square, too, has
    // `(4 w - w^2) UNIT` then, at most 3. Two more products and the sum.
    pair: Rounding::absolute(5.0 * UNIT),
    // A difference, and its product with the number of samples.
    place: Rounding::relative(2.0 * UNIT),
    // The distance from a sample, its slope, their product and sum, and the product with a constant.
    sample: Rounding::absolute(6.0 * UNIT),
    power: Rounding::absolute(2.0 * UNIT),
    // The offset's roundings turn it; at grazing incidence the products have a sum of magnitudes of at
    // most 1, and the first sum is at most half of it. Of the cosine itself: two sums, the reciprocal
    // length and the product.
    cosine: Rounding { absolute: 2.5 * UNIT, relative: 6.5 * UNIT },
    // Three products and two sums of magnitudes of at most 1; the axis.
    incidence: Rounding { absolute: 3.0 * UNIT + AXIS_TURN, relative: AXIS_LENGTH },
    share: Rounding::relative(UNIT),
    near: Rounding { absolute: 0.0, relative: 10.0 * UNIT },
    gain: 0.0,
    inverse_square: 12.0 * UNIT,
    given: 0.0,
    inverse_polynomial: 16.0 * UNIT,
    inverse_power: [3e-7, 1.5e-7],
    // A decay of less than 2^-95 is 0, times an intensity of 1e9.
    light: Rounding { absolute: 2.6e-20, relative: UNIT },
};

/// The stages of a distribution.
pub(super) const PLACING: Placing = Placing {
    // A cross product has three roundings of each component, which turn it by up to 3 units, and scaling it to length 1
    // one more, beside a length of 4.5: the front, of two vectors that are off by one each, is off by 6, and the side,
    // of axis and front, by 11.
    frame: (12.6 + 4.5) * UNIT,
    // Three products and two sums of magnitudes of at most 1 are a component, within 3 units; two sums, the
    // reciprocal, the product, and its place from the first sample: each of up to 1. Another place is its complement.
    square: (2.0 * 3.0 + 6.0) * UNIT,
    // As of samples, twice.
    cell: 12.0 * UNIT,
};
