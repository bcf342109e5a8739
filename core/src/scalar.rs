//! The seam between the kernel and the number formats.
//!
//! A format is a type that implements [`Scalar`]. The kernel above this seam is written once, in the coarse steps
//! below; every widening, shift, rounding and saturation lives under it.
//!
//! | | [`f32`] | [`Fx32`] | [`Fx16`] |
//! |---|---|---|---|
//! | scalar: intensities, normals, colours | f32 | I2F30 | I2F14 |
//! | length: world coordinates | f32 | I16F16 | I16F16 |
//! | unit: the axis and the direction to a point | f32 | I2F30 | I2F30 |
//! | versine of the angle off axis | f32 | 61 fraction bits in a u64 | u32, scaled to the cone |
//! | fraction: the argument of an edge profile | f32 | U1F31 | U1F15 |
//! | weight: a coefficient of an edge profile | f32 | I34F30 | I18F14 |
//! | gain: a factor with an exponent of its own | f32 | 32-bit mantissa and shift | 16-bit mantissa and shift |
//! | irradiance: light that has arrived, with headroom | f32 | U34F30 | U18F14 |
//! | rounding of a product | to nearest, ties to even | to nearest, ties up | to nearest, ties up |
//! | overflow | saturates (at 2^64 for irradiance) | saturates | saturates |
//! | widest product | 32 bits | 64 bits | 32 bits |
//!
//! Laws that hold for every bit pattern, in every format: no operation panics; what is not a number counts as
//! zero; `ONE.times(x) == x`; a falloff is in [0, 1], exactly 1 on the axis and exactly 0 from the edge outwards.

pub(crate) mod float;
mod fraction;

#[cfg(feature = "fixed")]
pub(crate) mod fixed16;
#[cfg(feature = "fixed")]
pub(crate) mod fixed32;
#[cfg(feature = "fixed")]
mod root;

use crate::vec3::Vec3;

pub use self::fraction::Fraction;
#[cfg(feature = "fixed")]
pub use self::{fixed16::Fx16, fixed32::Fx32};

/// A number format that the kernel runs in: `f32`, and with the feature `fixed` also [`Fx32`] and [`Fx16`].
///
/// Sealed: the formats are final in number, so that each can be measured. The module's table states the laws.
pub trait Scalar: Copy + Default + PartialOrd + core::fmt::Debug + sealed::Sealed + 'static {
    /// One component of a position in the world.
    type Length: Copy + Default + PartialEq + core::fmt::Debug;
    /// One component of a unit vector, at the format's finest resolution.
    type Unit: Copy + Default + PartialEq + core::fmt::Debug;
    /// The versine of an angle off axis, in the scale of a ramp: a narrow cone keeps its leading bits.
    type Versine: Copy + PartialOrd + core::fmt::Debug;
    /// The argument of an edge profile: from 0 at the edge of a cone to 1 in its middle.
    type Fraction: Fraction<Self>;
    /// A coefficient of an edge profile, from -4 to 4.
    type Weight: Copy + PartialEq + core::fmt::Debug;
    /// The ramp from the edge of a cone to its middle, compiled.
    type Ramp: Copy + PartialEq + core::fmt::Debug;
    /// A factor from zero upwards that keeps its leading bits whatever its size.
    type Gain: Copy + PartialEq + core::fmt::Debug;
    /// Light that has arrived at a surface: from zero upwards, 1 is full scale.
    type Irradiance: Copy + Default + PartialEq + core::fmt::Debug;
    /// The way from a light to a point before its length is known.
    type Offset: Offset<Self>;

    /// The name of the format, as the price list writes it.
    const NAME: &'static str;
    /// Zero.
    const ZERO: Self;
    /// One, which is full scale.
    const ONE: Self;
    /// The unit in the last place of one.
    const STEP: f32;
    /// How far off the direction to a point can be, in radians: what a narrow cone magnifies.
    const DIRECTION_ERROR: f32;

    /// The nearest value; saturates, and what is not a number becomes zero.
    fn from_f32(value: f32) -> Self;
    /// The value, rounded to f32 where it has more bits.
    fn to_f32(self) -> f32;
    /// The nearest length.
    fn length(value: f32) -> Self::Length;
    /// The unit vector along an axis whose length is 1 within the roundings of f32.
    fn axis(axis: Vec3<f32>) -> Vec3<Self::Unit>;
    /// The nearest versine in the scale of a ramp; saturates beyond its outer versine.
    fn versine(ramp: Self::Ramp, value: f32) -> Self::Versine;
    /// The nearest weight; saturates at -4 and 4, and what is not a number becomes zero.
    fn weight(value: f32) -> Self::Weight;
    /// The nearest gain; negative or not a number becomes zero.
    fn gain(value: f32) -> Self::Gain;

    /// The product.
    fn times(self, other: Self) -> Self;
    /// The difference.
    fn minus(self, other: Self) -> Self;

    /// The way from a light to a point.
    fn offset(light: Vec3<Self::Length>, point: Vec3<Self::Length>) -> Self::Offset;
    /// Compiles a ramp between two versines, from 0 at `outer` to 1 from `inner` inwards, that is cut off to 0 from
    /// `limit` outwards. A limit at `outer` cuts nothing off; an inner versine at `outer` makes a step.
    fn ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp;
    /// Where a versine stands on a ramp: exactly 0 at and beyond the limit, else exactly 1 at and within the inner
    /// versine, monotone between.
    fn rise(ramp: Self::Ramp, versine: Self::Versine) -> Self::Fraction;

    /// The light of a fraction of a gain, whatever the distance; none for a negative fraction.
    fn expose(self, gain: Self::Gain) -> Self::Irradiance;
    /// A channel of light after a colour.
    fn filter(light: Self::Irradiance, color: Self) -> Self::Irradiance;
    /// The sum of two lights.
    fn add_light(a: Self::Irradiance, b: Self::Irradiance) -> Self::Irradiance;
    /// The value of a light, for display and for tests.
    fn light_to_f32(light: Self::Irradiance) -> f32;
}

/// The way from a light to a point: what can be asked of it before a square root is paid for, and the root.
pub trait Offset<S: Scalar>: Copy + core::fmt::Debug {
    /// What is known once the root is paid for.
    type Ray: Ray<S>;
    /// The inner product of a surface normal with the way back to the light, in a scale of its own.
    type Facing: Copy + core::fmt::Debug;

    /// How far the surface faces the light.
    fn facing(&self, normal: Vec3<S>) -> Self::Facing;
    /// Whether the surface faces away, so that nothing can arrive. Not a number faces away.
    fn faces_away(facing: Self::Facing) -> bool;
    /// Whether the point is outside a cone for certain: by squares, and only ever in error towards evaluating.
    /// `bound` is the squared cosine of the outer half angle, less a margin for the roundings.
    fn is_outside(&self, axis: Vec3<S::Unit>, bound: S) -> bool;
    /// Pays for the square root.
    fn ray(&self) -> Self::Ray;
}

/// A direction of unit length from a light to a point, and the length it had.
///
/// A point on the light itself, or one so far that its squared distance cannot be held, has no direction: it stays
/// dark, because its [`cosine`](Ray::cosine) is zero or its versine outside every cone.
pub trait Ray<S: Scalar>: Copy + core::fmt::Debug {
    /// The direction.
    fn direction(&self) -> Vec3<S::Unit>;
    /// The versine of the angle between direction and axis, in the scale of a ramp, by the difference of the two:
    /// `|l - s|^2 / 2` keeps the narrow beams that `1 - l.s` loses.
    fn versine(&self, axis: Vec3<S::Unit>, ramp: S::Ramp) -> S::Versine;
    /// The cosine of the angle of incidence, and zero where the surface faces away.
    fn cosine(&self, facing: <S::Offset as Offset<S>>::Facing) -> S;
    /// The light of a fraction of a gain at this distance, by the inverse-square law; none for a negative fraction.
    fn expose(&self, fraction: S, gain: S::Gain) -> S::Irradiance;
}

/// The bound for [`Offset::is_outside`]: the squared cosine of the outer half angle, less a margin for the roundings
/// of both sides. Outer versines are at most 1, so the cosine is not negative.
///
/// A point is outside when `z |z| < bound |v|^2`, `z` being the part of the offset along the axis. The slope of
/// `c |c|` is at most 2, so a margin of 16 steps leaves every versine up to 8 steps beyond the edge to the
/// evaluation: more than the error of the versine in any format. An epsilon more stands for the squared sine, which
/// is f32 in every format and is formed first because it is what a narrow cone keeps.
pub(crate) fn outside_bound<S: Scalar>(outer_versine: f32) -> S {
    let squared_sine = outer_versine * (2.0 - outer_versine);
    let margin = squared_sine * f32::EPSILON + 16.0 * S::STEP;
    S::ONE.minus(S::from_f32(squared_sine)).minus(S::from_f32(margin))
}

/// A value as `mantissa / 2^shift` with a mantissa of 24 bits, which is exact; zero where it is not more than zero.
#[cfg(feature = "fixed")]
fn mantissa_and_shift(value: f32) -> (u32, i32) {
    if !matches!(value.partial_cmp(&0.0), Some(core::cmp::Ordering::Greater)) {
        return (0, 0);
    }
    let bits = value.min(f32::MAX).to_bits();
    let (exponent, fraction) = ((bits >> 23).cast_signed(), bits & 0x007f_ffff);
    if exponent == 0 { (0, 0) } else { (fraction | 0x0080_0000, 150 - exponent) }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    #[cfg(feature = "fixed")]
    impl Sealed for super::Fx16 {}
    #[cfg(feature = "fixed")]
    impl Sealed for super::Fx32 {}
}
