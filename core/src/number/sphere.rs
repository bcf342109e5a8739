//! Spheres in the fixed-point formats: a sphere around a line, and a cone that spheres cannot reach.

use super::{
    Fx32, Length, Scalar,
    root::{self, high_product, signed_high_half},
};
use crate::vec3::Vec3;

/// Returns the centre and the radius of a sphere around the line between two points, and around
/// points within a step of it.
pub(super) fn enclosing(a: Vec3<Length>, b: Vec3<Length>) -> (Vec3<Length>, Length) {
    let [a, b] = [a, b].map(|point| point.map(|c| c.to_bits() >> 1));
    let half = a.zip(b, |a, b| a.abs_diff(b) >> 1);
    let (sum, largest) = (half.x + half.y + half.z, half.x.max(half.y).max(half.z));
    // A vector is no longer than half the sum of its largest component and of all three. The shifts
    // lose up to 3 steps, and the centre and the points are off by up to 1.8 steps each.
    let radius = sum.saturating_add(largest).saturating_add(7).min(i32::MAX as u32);
    (a.zip(b, |a, b| Length::from_bits(a + b)), Length::from_bits(radius as i32))
}

/// Returns the tip of a cone moved back along the axis: see `Places::moved_back`. The squared
/// sine of the half angle has 30 fraction bits.
pub(super) fn moved_back(
    tip: Vec3<Length>,
    axis: Vec3<Fx32>,
    squared_sine: u32,
    radius: Length,
) -> Option<Vec3<Length>> {
    if squared_sine == 0 {
        return None;
    }
    // The shift is even, so that the root is shifted by half of it. `reciprocal` is
    // `2^(15 - shift / 2) / sin(angle)`, with a relative error of at most 9.0e-5, less than 2^-13.
    let shift = (31 - root::bit_length(squared_sine)) & !1;
    let reciprocal = root::inverse_sqrt_16(squared_sine << shift);
    // The products with the axis lose up to 4 steps in each component.
    let radius = (radius.to_bits().max(0) as u32).saturating_add(8);
    let product = high_product(radius, reciprocal) + (radius >> 13) + 1;
    let up = 1 + shift / 2;
    let is_far = product >> (29 - up) != 0;
    let back = (product << up) as i32;
    let back = axis.map(|axis| signed_high_half(axis.to_bits(), back) << 2);
    let tip = tip.map(Length::to_bits);
    // The moved tip can only be beyond `FARTHEST` if the tip has a coordinate of 31 bits.
    let ends = tip.map(|c| c ^ (c << 1));
    if is_far || (ends.x | ends.y | ends.z) < 0 && is_beyond(tip, back) {
        return None;
    }
    Some(tip.zip(back, |tip, back| Length::from_bits(tip.wrapping_sub(back))))
}

/// Returns whether a component of `a - b` is beyond the farthest light of [`Fx32`], of which offsets
/// may wrap.
#[cold]
fn is_beyond(a: Vec3<i32>, b: Vec3<i32>) -> bool {
    const FARTHEST: u32 = (Fx32::FARTHEST as u32) << 16;
    let Vec3 { x, y, z } = a.zip(b, |a, b| a.checked_sub(b).is_none_or(|c| c.unsigned_abs() > FARTHEST));
    x || y || z
}
