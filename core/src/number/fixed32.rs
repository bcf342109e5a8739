//! The 32-bit format: scalars, lengths and directions of 32 bits, products of 64 bits.

mod frame;
mod lobe;
mod offset;
mod quick;
mod ramp;

pub use self::{frame::Frame32, ramp::Ramp32};
use self::{offset::Offset32, ramp::nearest_versine};
pub use super::gain::Gain32;
use super::{
    Arithmetic, Fx32, Length, Light32, Offset, ProjectedPoint, Ray, Rise, Scalar, Slopes, Versine32,
    Weight32, Word, fraction::Fraction32, operations, rounded, sphere,
};
use crate::vec3::Vec3;

/// Returns the product in 64 bits.
#[inline]
fn wide(a: i32, b: i32) -> i64 {
    i64::from(a) * i64::from(b)
}

/// Returns the square of a component.
#[inline]
fn square(component: i32) -> u64 {
    wide(component, component) as u64
}

/// Returns a scalar clamped to `[0, 1]`, as an unsigned factor.
#[inline]
fn factor(scalar: Fx32) -> u64 {
    u64::from(scalar.clamp(Fx32::ZERO, Fx32::ONE).to_bits() as u32)
}

/// Converts a scalar between 0 and 1 to a number with 32 fraction bits.
#[inline]
fn fraction(part: Fx32) -> u32 {
    (part.to_bits() as u32) << 2
}

/// The margin of the bound for rejecting points outside a cone, of which `number::outside_bound`
/// states the reason, and two steps for the roundings of the squared cosine.
const OUTSIDE: i32 = 16 + 2;

impl Arithmetic for Fx32 {
    operations!(i32, u32, u64, Light32, Weight32, Gain32, Offset32, Frame32, Steps30);

    type Versine = Versine32;
    type Fraction = Fraction32;
    type Fine = Fraction32;
    type Ramp = Ramp32;
    // The rounding of three components by half a step each turns the direction by 0.87 steps of
    // 2^-30. The constant does not include the halving of an offset with a component of more than
    // 32,768 units, which turns the direction by 0.71 steps more.
    const DIRECTION_ERROR: f32 = 8.2e-10;

    /// Uses all bits of the components, and normalises the axis like the direction to a point.
    fn axis(axis: Vec3<f32>) -> Vec3<Fx32> {
        Offset32::new(axis.map(|c| Self::from_f32(c).to_bits())).ray().direction()
    }

    fn aim(toward: Vec3<f32>, _: Vec3<f32>) -> Vec3<Fx32> {
        Self::axis(toward)
    }

    fn versine(_: Ramp32, value: f32) -> Versine32 {
        if value.is_nan() { Versine32::MAX } else { nearest_versine(value) }
    }

    #[inline]
    fn offset(light: Vec3<Length>, point: Vec3<Length>) -> Offset32 {
        Offset32::between(light, point)
    }

    /// The versines computed at set-up are `f32`, with a relative error of at most 4e-7.
    fn rounding(edge: &Slopes) -> f32 {
        edge.angle * 0.21e-6 + (edge.fraction + 1.5) * Self::STEP
    }

    fn ramp(inner: f32, outer: f32, limit: f32) -> Ramp32 {
        Ramp32::new(inner, outer, limit)
    }

    fn zoomed(from: Ramp32, to: Ramp32, part: Self) -> (Ramp32, Self) {
        let (ramp, chords) = from.between(to, fraction(part));
        (ramp, Self::from_bits(chords.squared_cosine() as i32 - OUTSIDE))
    }

    #[inline]
    fn rise(ramp: Ramp32, versine: Versine32) -> Rise<Self> {
        Rise::Coarse(ramp.rise(versine))
    }

    #[inline]
    fn weighted_byte(sum: u32) -> Self {
        /// `2^38 / 255`. The product of this constant and the sum has at most 63 bits.
        const INVERSE: u64 = 1_077_952_576;
        Self::from_bits(((u64::from(sum) * INVERSE + (1 << 31)) >> 32).min(1 << 30) as i32)
    }

    #[inline]
    fn versine_between(a: Vec3<Fx32>, b: Vec3<Fx32>, _: Ramp32) -> Versine32 {
        let difference = a.zip(b, |a, b| a.to_bits().saturating_sub(b.to_bits()));
        let squares = difference.map(square);
        Versine32::from_bits(squares.x.saturating_add(squares.y).saturating_add(squares.z))
    }
}
