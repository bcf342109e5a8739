//! The errors of the stages of the 32-bit format, where each of them comes from.

use crate::number::{
    Placing, Rounding, Stages,
    real::INVERSE_POWER,
    stages::{RANGE, power_of_two},
};

/// A step of a scalar; a fraction has half of it.
const STEP: f64 = power_of_two(-30);
/// The relative error of a mantissa of 28 bits that is rounded.
const MANTISSA: f64 = power_of_two(-28);

/// The root of the axis' length (exhaustive), of 31 bits, and the components of the result, rounded to half a step.
pub(in crate::number) const AXIS_LENGTH: f64 = 4.7e-10 + 0.5 * STEP + 0.866_1 * STEP;
/// The same, across the axis.
pub(in crate::number) const AXIS_TURN: f64 = 0.866_2 * STEP;

/// The relative error of a distance: the direction's 2.4e-8, three squares and three products that are rounded down.
/// A halved offset changes it by 0.71 steps.
pub(in crate::number) const DISTANCE: f64 = 4.7e-8;

/// Two squares and their products with the shares are rounded down by 2 units of 2^-31 each. The narrow part is up to 2
/// units too large, and its square 4.
pub(in crate::number) const PAIR: f64 = 8.0 * power_of_two(-31);

/// The evaluation.
pub(in crate::number) const STAGES: Stages = Stages {
    // The direction's 2.4e-8 is that of its excess: three squares rounded down, by 5.6e-9 of the length,
    // and a step of 2^-26 in either direction.
    length: 2.4e-8 + AXIS_LENGTH,
    // A component is within a step. An offset with a component of more than 32,768 units is halved, which
    // turns it by 0.71 steps.
    turn: (1.001 * 1.732_1 + 0.71) * STEP + AXIS_TURN,
    difference: 0.0,
    // Three squares are rounded down, in units of 2^-29.
    versine: Rounding::absolute(3.0 * power_of_two(-29)),
    set_up: power_of_two(-30),
    ramp: Rounding::absolute(power_of_two(-29)),
    complement: Rounding::NONE,
    product: Rounding::absolute(STEP),
    value: Rounding::absolute(STEP),
    // The product with a slope is rounded down by 16 units of 2^-31, and its factor by 2, of which a slope
    // makes 6.
    lift: Rounding::absolute(22.0 * power_of_two(-31)),
    // A coefficient is truncated to 28 bits, and a product of one is rounded down by two units.
    weight: power_of_two(-27),
    // A square that is rounded down by 2 units of 2^-31, three times, and twice a product.
    smooth: Rounding::absolute(5.0 * STEP),
    // The share is rounded to 30 bits, and truncated to 28.
    pair: Rounding::absolute(PAIR + power_of_two(-31) + power_of_two(-28)),
    place: Rounding::NONE,
    // A share of the step to the next sample is rounded down, and the sum, too, beside half a unit of its conversion:
    // 2 units of 2^-31.
    sample: Rounding::absolute(STEP),
    // The bits of a power are those of the result.
    power: Rounding::NONE,
    // Three products of half a component are rounded down in units of 2^-27; a component of the
    // direction is within a step, and half of one of the normal loses half a unit, which is a step. The
    // direction's length is that of the cosine itself.
    cosine: Rounding { absolute: power_of_two(-27) * 3.0 + 2.01 * 1.732_1 * STEP, relative: 2.4e-8 },
    // The axis; products lose less than a hundredth of a step, and the sum is rounded.
    incidence: Rounding { absolute: AXIS_TURN + 0.51 * STEP, relative: AXIS_LENGTH },
    share: Rounding::absolute(STEP),
    // A distance, two roundings to a mantissa, and a constant of a range. Then it is rounded to a scalar.
    near: Rounding { absolute: STEP / 2.0, relative: DISTANCE + 2.0 * MANTISSA + RANGE },
    gain: 0.0,
    // Twice the excess' 2.4e-8. Its product with the gain has 11 bits at least, which lose up to 7.4e-4 of
    // twice an excess of 2.85e-4; four results are rounded down.
    inverse_square: 5.0e-7,
    // The product is rounded down: by 2 of a gain that is at least `2^31 / 12` if it is attenuated.
    given: 2.0 * 12.1 * power_of_two(-31),
    // Twice a distance that is rounded to a mantissa; two products, two sums, the reciprocal, which is within 0.9 units
    // of at least 2^27, and the last product.
    inverse_polynomial: 2.0 * (DISTANCE + MANTISSA) + 6.81 * MANTISSA,
    inverse_power: [2.0 * MANTISSA + INVERSE_POWER[0], DISTANCE + MANTISSA + INVERSE_POWER[1]],
    light: Rounding::absolute(STEP / 2.0),
};

/// The stages of a distribution, which the fine evaluation of `Fx16` shares.
pub(in crate::number) const PLACING: Placing = Placing {
    // A component of a cross product is within 2^-28 of one of length 1, which turns it by up to 6.5e-9; scaled to length
    // 1, it is off by a direction's 1.9e-9 more. So the front, of two vectors within an axis' turn, is off by 1e-8, and
    // the side by 1.9e-8 more. A direction's length is within 2.4e-8.
    frame: 3.1e-8 + 2.4e-8,
    // Three products are rounded down in units of 2^-28, of which half is added: a component is within 1.5 units, and `s`
    // within three times as much. The reciprocal is within 4e-9 of its size (searched), and a place is rounded down to 30
    // bits.
    square: 5.0 * 1.5 * 4.0 * STEP + 4e-9 + STEP,
    // A share of a step of 16 bits is rounded down to 31 bits, and again that of the step between two of these; the
    // conversion rounds by half a unit.
    cell: 2.5 * power_of_two(-31),
};
