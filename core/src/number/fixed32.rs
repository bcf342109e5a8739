//! The 32-bit format: scalars, lengths and directions of 32 bits.
//!
//! From a point to the light at the point, nearly all products are the upper halves of products of
//! two 32-bit numbers. A processor without an instruction for an upper half computes it from products
//! of 16-bit numbers, in 18 instructions on a Cortex-M0, where a product of 64 bits takes 39. The
//! other operations, such as those on colours, have products of 64 bits.

mod frame;
mod lobe;
mod offset;

pub use self::frame::Frame32;
use self::offset::Offset32;
pub use super::gain::Gain32;
use super::{
    Arithmetic, FixedRamp, Fx32, Length, Light32, Offset, ProjectedPoint, Ray, Rise, Slopes, Versine,
    Weight32, Word,
    fine::Fine,
    fine_ray, operations,
    ramp::{MOST_ZOOM, magnified},
    rounded, sphere,
};
use crate::vec3::Vec3;

/// Returns the product in 64 bits.
#[inline]
fn wide(a: i32, b: i32) -> i64 {
    i64::from(a) * i64::from(b)
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
/// states the reason, and one step for the rounding of the squared cosine.
const OUTSIDE: i32 = (16 + 1) << 16;

impl Arithmetic for Fx32 {
    operations!(i32, u32, u64, Light32, Weight32, Gain32, Offset32, Frame32, Steps30);

    type Fraction = Fine;
    type Fine = Fine;
    // The components of a direction are within one step of 2^-30 and those of an axis within half a
    // step, up to a common factor: together they turn by `1.5 sqrt(3) / 2^30 = 2.42e-9`. Two errors
    // of a versine are largest, relative to the outer versine, in the narrowest cone, a step with a
    // half angle `a` of 1.35e-6: half the square of the difference of the two lengths, at most 2.4e-8,
    // is as much as a turn by `(2.4e-8)^2 / 2 a = 2.13e-10`, and the last place of the versine by
    // `3 / 2^59 a = 4e-12`. The constant does not include the halving of an offset with a component
    // of more than 32,768 units, which turns the direction by 0.71 steps more.
    const DIRECTION_ERROR: f32 = 2.65e-9;
    const OUTSIDE_STEP: f32 = 1.0 / (1 << 14) as f32;

    /// Uses all bits of the components, and normalises the axis with 64-bit products.
    fn axis(axis: Vec3<f32>) -> Vec3<Fx32> {
        Offset32::new(axis.map(|c| Self::from_f32(c).to_bits())).unit()
    }

    fn aim(toward: Vec3<f32>, _: Vec3<f32>) -> Vec3<Fx32> {
        Self::axis(toward)
    }

    #[inline]
    fn offset(light: Vec3<Length>, point: Vec3<Length>) -> Offset32 {
        Offset32::between(light, point)
    }

    /// Adds the other error terms:
    ///
    /// - The versines computed at set-up are `f32`, with a relative error of at most 4e-7.
    /// - The length of a direction has an error of at most 2.4e-8.
    /// - A versine is rounded down by less than 3 units of its last place, 1.2e-8 of the outer versine.
    /// - The falloff's argument `t` and the products after it have 31 fraction bits.
    fn rounding(edge: &Slopes) -> f32 {
        const LENGTH: f32 = 2.4e-8;
        edge.angle * (0.21e-6 + LENGTH / 2.0 + 0.6e-8) + edge.fraction * 3e-9 + 3.0 * LENGTH
    }

    fn zoomed(from: FixedRamp, to: FixedRamp, part: Self) -> (FixedRamp, Self) {
        let (ramp, chords) = from.between(to, fraction(part), MOST_ZOOM);
        (ramp, Self::from_bits(chords.squared_cosine() as i32 - OUTSIDE))
    }

    #[inline]
    fn rise(ramp: FixedRamp, versine: Versine) -> Rise<Self> {
        Rise::Coarse(ramp.rise_finely(versine))
    }

    #[inline]
    fn weighted_byte(sum: u32) -> Self {
        /// `2^38 / 255`. The product of this constant and the sum has at most 63 bits.
        const INVERSE: u64 = 1_077_952_576;
        Self::from_bits(((u64::from(sum) * INVERSE + (1 << 31)) >> 32).min(1 << 30) as i32)
    }

    #[inline]
    fn versine_between(a: Vec3<Fx32>, b: Vec3<Fx32>, ramp: FixedRamp) -> Versine {
        fine_ray::versine(a.map(Self::to_bits), b, ramp)
    }
}
