//! The errors of the stages of the 16-bit format, where each of them comes from.
//!
//! `V` is the offset, scaled to 17 bits and not rounded, `v` the truncated offset of 15 bits, and `r`
//! its reciprocal length `2^30 / |v|`.

use crate::number::{
    Placing, Rounding, Stages, float, fx32,
    real::INVERSE_POWER,
    stages::{RANGE, power_of_two},
};

/// A step of a scalar, and of light.
const STEP: f64 = power_of_two(-14);
/// A step of a fraction.
const FINER: f64 = power_of_two(-15);
/// The relative error of a mantissa of 16 bits that is rounded, and of one that is truncated.
const MANTISSA: [f64; 2] = [power_of_two(-16), power_of_two(-15)];
/// The relative error of a gain attenuated by a power of the distance, without that of the distance.
const POWER: f64 = 2.0 * MANTISSA[0] + MANTISSA[1] + INVERSE_POWER[0];
/// `v` loses at most this part of a unit of each component, if the offset has this bit length. An
/// offset of 15 bits or less loses nothing.
const fn lost(bits: u32, kept: u32) -> f64 {
    if bits > kept { 1.0 - power_of_two(kept as i32 - bits as i32) } else { 0.0 }
}

/// The truncation changes the length of `v` by at most this part of it, times what is lost:
/// `(1 + sqrt(3)) / 2` of 2^14 where the largest component is 0.89.
const SHORTENED: f64 = 1.366_1 / 16_384.0;
/// The truncation turns `v` by at most this, times what is lost: across the direction at most 1.575 of
/// 2^14 where the largest component is 0.95.
const TURNED: f64 = 1.576 / 16_384.0;
/// The axis is that of `f32`, whose components are rounded to half a unit of 2^-30.
pub(in crate::number) const AXIS_LENGTH: f64 = float::errors::AXIS_LENGTH + 0.866_1 * power_of_two(-30);
/// The same, across the axis.
pub(in crate::number) const AXIS_TURN: f64 = float::errors::AXIS_TURN + 0.866_1 * power_of_two(-30);
/// The error of the root (exhaustive), in the coarse and in the quick evaluation.
const ROOT: [f64; 2] = [9.0e-5, 2.0e-4];

/// The error of a distance or a squared distance, relative to a range: by the truncation of `v`, which
/// the square has twice and the distance once, beside the error of the root; by a constant and two
/// roundings. Then it is rounded to a scalar.
const fn near(lost: f64, root: f64) -> Rounding {
    let shortened = lost * SHORTENED;
    let other = if root > shortened { root } else { shortened };
    Rounding { absolute: STEP / 2.0, relative: shortened + other + RANGE + 2.0 * MANTISSA[0] + MANTISSA[1] }
}

/// The coarse evaluation of offsets of up to this bit length.
pub(super) const fn coarse(bits: u32) -> Stages {
    let lost = lost(bits, 15);
    Stages {
        // The reciprocal's 9.0e-5 (exhaustive). Its rounding to 14 bits, `2 / r`, and the truncation of
        // `v` have a sum of at most 1.363e-4, at either end of `|v|`. Of the truncation of `V`, at most
        // 1.66e-5 is along the direction.
        length: ROOT[0] + 1.363e-4 + 1.66e-5 + AXIS_LENGTH,
        // A component is truncated by up to `r / 4` units of 2^-30, less `CUT_OFF`; `r / 4` is at most
        // 2^14 times the largest component of the direction. Across the direction that is at most
        // 1.47e-5, where the largest component is 0.95. Of up to 19 bits no more than 3/4 of it is
        // lost, so that `CUT_OFF` is the most: `sqrt(3)` of 6,144 units.
        turn: AXIS_TURN + if bits > 19 { 1.47e-5 } else { 9.92e-6 },
        // Three components are rounded to integers, in units of 2^-14.
        difference: 0.866_1 * STEP,
        versine: Rounding::NONE,
        // Half a unit of 2^-29.
        set_up: power_of_two(-30),
        // [-2.00, 2.25] steps for every ramp and versine.
        ramp: Rounding::absolute(2.25 * FINER),
        complement: Rounding::NONE,
        product: Rounding::absolute(FINER / 2.0),
        value: Rounding::absolute(STEP / 2.0),
        lift: Rounding::relative(FINER / 2.0),
        // Half a unit of 2^-14.
        weight: FINER,
        // The square is rounded to a fraction and multiplied by up to 3.
        smooth: Rounding::absolute(1.5 * FINER + STEP / 2.0),
        // The mantissa of the ratio is rounded down and its product up, by at most a unit and 1/32; the square doubles
        // this, and is rounded. Half a unit of 2^-14 of the share, and the sum is rounded.
        pair: Rounding::absolute((2.0 * 1.032 + 0.501 + 1.0) * FINER + STEP / 2.0),
        place: Rounding::NONE,
        // A sample has 16 bits.
        sample: Rounding::absolute(STEP / 2.0 + power_of_two(-16)),
        power: Rounding::absolute(FINER / 2.0),
        // The truncation turns `v`, and two results are rounded down. The reciprocal's 9.0e-5 is that of
        // the cosine itself.
        cosine: Rounding { absolute: lost * TURNED + 2.0 * FINER, relative: ROOT[0] },
        // A component of the direction is rounded to a step, and the sum, too.
        incidence: Rounding::absolute((0.866_2 + 0.5) * STEP + AXIS_LENGTH + AXIS_TURN),
        share: Rounding::absolute(STEP / 2.0),
        near: near(lost, ROOT[0]),
        gain: MANTISSA[1],
        // Twice the reciprocal's error. The truncation of `v` and that of the square of the reciprocal,
        // `2^16 / r^2`, have a sum of at most 2.45e-4. The gain and its product are truncated.
        inverse_square: 2.0 * ROOT[0] + 2.45e-4 + MANTISSA[1] + 9.2e-5,
        given: 0.0,
        // A distance, two products and two sums in a polynomial without cancellation, its reciprocal and
        // two products.
        inverse_polynomial: 2.0 * (lost * SHORTENED + ROOT[0]) + 8.0 * MANTISSA[0] + 3.0 * MANTISSA[1],
        // The power, its product with the intensity, and the intensity.
        inverse_power: [POWER, lost * SHORTENED + ROOT[0] + 2.0 * MANTISSA[0]],
        light: Rounding::absolute(STEP / 2.0),
    }
}

/// The fine evaluation: the stages of `Fx32` for an offset of `Fx16`.
pub(super) const FINE: Stages = Stages {
    length: 2.5e-8 + AXIS_LENGTH,
    turn: 2.65e-9 + AXIS_TURN,
    difference: 0.0,
    versine: Rounding::absolute(3.0 * power_of_two(-29)),
    set_up: power_of_two(-30),
    ramp: Rounding::absolute(power_of_two(-29)),
    complement: Rounding::NONE,
    product: Rounding::absolute(power_of_two(-30)),
    value: Rounding::absolute(power_of_two(-30)),
    // The product with a slope is rounded down by 16 units of 2^-31, and its factor by 2, of which a slope
    // makes 6.
    lift: Rounding::absolute(22.0 * power_of_two(-31)),
    weight: FINER,
    // A square that is rounded down by 2 units of 2^-31, three times, and twice a product.
    smooth: Rounding::absolute(5.0 * power_of_two(-30)),
    pair: Rounding::absolute(fx32::errors::PAIR + FINER),
    place: Rounding::NONE,
    sample: fx32::errors::STAGES.sample,
    power: Rounding::NONE,
    // A direction, and three products that are rounded down. The direction's length is that of the
    // cosine itself.
    cosine: Rounding { absolute: 2.65e-9 + 3.0 * power_of_two(-30), relative: 2.4e-8 },
    incidence: Rounding::absolute((0.866_2 + 0.5) * STEP + AXIS_LENGTH + AXIS_TURN),
    share: Rounding::absolute(power_of_two(-30)),
    // The length of an offset, a constant, and their product of at least 29 bits, which is rounded down; then the
    // share is rounded down.
    near: Rounding {
        absolute: power_of_two(-31),
        relative: fx32::errors::DISTANCE + RANGE + power_of_two(-29),
    },
    gain: 0.0,
    // As in `Fx32`, of an estimate whose error is 1.75e-4.
    inverse_square: 4.2e-7,
    given: fx32::errors::STAGES.given,
    // Twice a distance that is rounded to a mantissa; a coefficient and the gain are truncated, and two products, two
    // sums, the reciprocal and the last product are rounded.
    inverse_polynomial: 2.0 * fx32::errors::DISTANCE + 8.01 * MANTISSA[0] + 2.0 * MANTISSA[1],
    inverse_power: [POWER, fx32::errors::DISTANCE + MANTISSA[0] + INVERSE_POWER[1]],
    light: Rounding::absolute(STEP / 2.0),
};

/// As in `Fx32`, of axes that are off by [`AXIS_TURN`]: the front by twice as much, and the side by three times.
const FRAME: f64 = fx32::errors::PLACING.frame + 3.75 * AXIS_TURN + AXIS_LENGTH;

/// The stages of a distribution in the coarse evaluation.
pub(super) const COARSE_PLACING: Placing = Placing {
    frame: FRAME,
    // Direction and frame are rounded to 15 fraction bits: each component of the direction by half a unit, which is
    // a vector of `sqrt(3) / 2`, and each of three vectors by as much, together 1.5; a place changes by `sqrt(2)` times
    // as much. Then a component and `s` are rounded, the reciprocal has 3.4e-5 (exhaustive), and a place is rounded.
    square: core::f64::consts::SQRT_2 * (0.866_1 + 1.5) * FINER + 1.5 * FINER + 3.4e-5,
    // Two of 16 bits are rounded to half a unit, and then one between them, which is rounded to a scalar.
    cell: STEP / 2.0 + 2.0 * power_of_two(-16),
};

/// The stages of a distribution in the fine evaluation.
pub(super) const FINE_PLACING: Placing = Placing { frame: FRAME, ..fx32::errors::PLACING };

/// What coordinates that are halved lose: up to half a unit of a difference of at least 2^23, which turns it by up to
/// `sqrt(3) / 2^24`, and changes its length by this part.
const HALVED: f64 = 1.04e-7;

/// The fine evaluation, from 256 units on.
pub(in crate::number) const FAR: Stages = Stages {
    turn: FINE.turn + HALVED,
    cosine: Rounding { absolute: FINE.cosine.absolute + HALVED, relative: FINE.cosine.relative },
    near: Rounding { absolute: FINE.near.absolute, relative: FINE.near.relative + 2.0 * HALVED },
    inverse_square: FINE.inverse_square + 2.001 * HALVED,
    inverse_polynomial: FINE.inverse_polynomial + 2.001 * HALVED,
    inverse_power: [FINE.inverse_power[0], FINE.inverse_power[1] + HALVED],
    ..FINE
};

/// The quick evaluation of offsets of up to this bit length.
pub(super) const fn quick(bits: u32) -> Stages {
    let lost = lost(bits, 15);
    Stages {
        // The product of `v` and its reciprocal length has the length 1, but for the root's 2.0e-4
        // (exhaustive). Of the bias at most `sqrt(3)` of `QUICK_CUT_OFF` is along the direction.
        length: ROOT[1] + 3.97e-5 + AXIS_LENGTH,
        // Four times the truncation of the coarse evaluation: `v` has two bits less than `V`.
        turn: 4.0 * if bits > 17 { 1.47e-5 } else { 9.92e-6 } + AXIS_TURN,
        cosine: Rounding { absolute: lost * TURNED + 2.0 * FINER, relative: ROOT[1] },
        near: near(lost, ROOT[1]),
        inverse_square: 2.0 * ROOT[1] + 2.45e-4 + MANTISSA[1] + 9.2e-5,
        inverse_polynomial: 2.0 * (lost * SHORTENED + ROOT[1]) + 8.0 * MANTISSA[0] + 3.0 * MANTISSA[1],
        inverse_power: [POWER, lost * SHORTENED + ROOT[1] + 2.0 * MANTISSA[0]],
        ..coarse(bits)
    }
}

/// The bit length from which on a bit more changes little.
const MANY: u32 = 21;

/// The largest bit length of an offset of this length; that of any offset from [`MANY`] bits on.
pub(super) fn bits_at(distance: f64) -> u32 {
    let bits = u64::BITS - ((distance * 65_536.0) as u64).leading_zeros();
    if bits < MANY { bits } else { u32::BITS }
}

/// The distance from which on offsets may have more bits than at this one.
pub(super) fn more_bits_from(distance: f64) -> f64 {
    let bits = bits_at(distance);
    if bits < MANY { (1_u64 << bits) as f64 / 65_536.0 } else { f64::INFINITY }
}
