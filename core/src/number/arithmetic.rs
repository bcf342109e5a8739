//! The private interface between the kernel and the number formats: the stages of a point.
//!
//! The kernel is written once, in terms of the high-level operations of these traits, which stand in
//! the order of the data: [`Offset`], [`Ray`], [`Fraction`], [`Share`],
//! [`Gain`]. Each format implements them in a file of its own, in the same order: `fx16.rs`,
//! `fx32.rs` and `float.rs` contain all widening, shifting, rounding and saturation. What else the kernel
//! requires of a format is in `set_up.rs`, and in the files of this name in the folder of each format.
//!
//! | | `f32` | `Fx32` | `Fx16` |
//! |---|---|---|---|
//! | fraction: the argument of a falloff | f32 | U1F31 | U1F15; U1F31 for steep cones and bright lights |
//! | gain: a factor with its own exponent | f32 | 28-bit mantissa and shift | 32-bit mantissa (computed gains: 16 bits) and shift |
//! | rounding of a product of scalars | to nearest, ties to even | to nearest, ties up | to nearest, ties up |
//!
//! One operation has one name: a product is `times`, with a suffix if the result is of another kind
//! than the operands; `1 - x` is `complement`; a factor times a gain as light is `light`.
//!
//! In every format and for every bit pattern:
//!
//! - No operation panics.
//! - A NaN in a point, a normal, a versine or a gain gives zero light.
//! - `ONE.times(x) == x` for x in `[0, 1]`.

use super::{InversePower, Knot, RealExponent};
use crate::{distribution::Distribution, vec3::Vec3};

/// The types of a number format.
pub trait Types: Copy + Default + PartialOrd + core::fmt::Debug + Share<Self> {
    /// [`super::Scalar::Length`].
    type Position: Copy + Default + PartialOrd + core::fmt::Debug;
    /// [`super::Scalar::Unit`].
    type Direction: Copy + Default + PartialEq + core::fmt::Debug;
    /// [`super::Scalar::Irradiance`].
    type Received: Copy + Default + PartialOrd + core::fmt::Debug;
    /// Versine of an angle off axis, in the scale of a [`Ramp`](Self::Ramp).
    ///
    /// In `Fx16` a ramp scales its versines, so that those of a narrow cone keep their leading
    /// bits.
    type Versine: Copy + PartialOrd + core::fmt::Debug;
    /// Argument `t` of a falloff: 0 at the edge of a cone, 1 on the axis.
    type Fraction: Fraction<Self>;
    /// Argument `t` of a falloff with more bits, for a steep cone or a bright light.
    ///
    /// In a format whose `Fraction` has enough bits, `Fine` is the same type as `Fraction`.
    type Fine: Fraction<Self>;
    /// A ray with more bits than that of [`Offset`](Self::Offset), for the same points; the same
    /// type in a format with only one evaluation.
    type FineRay: Directed<Self, Fraction = Self::Fine>;
    /// Coefficient of a falloff, in `[-4, 4]`.
    type Weight: Copy + PartialEq + core::fmt::Debug;
    /// Compiled ramp of a cone: the map from versines to the falloff's argument `t`.
    type Ramp: Copy + PartialEq + core::fmt::Debug;
    /// Compiled frame of a projection: the axis of a light and two vectors orthogonal to the axis.
    type Frame: Copy + PartialEq + core::fmt::Debug;
    /// Factor of at least 0 with its own exponent, so that it keeps its leading bits at every
    /// magnitude.
    type Gain: Gain<Self>;
    /// Vector from a light to a point, before its length is computed.
    type Offset: Vectors<
            Self,
            Ray: Directed<Self, Fraction = Self::Fraction, Share = <Self::Fraction as Fraction<Self>>::Value>,
        >;
}

/// Argument `t` of a falloff, with as many bits as the cone needs.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub enum Rise<S: Types> {
    /// A fraction with one bit more than a scalar.
    Coarse(S::Fraction),
    /// A fraction with the format's full precision.
    Fine(S::Fine),
}

impl<S: Types> Rise<S> {
    /// Returns the nearest scalar.
    #[inline]
    pub(crate) fn scalar(self) -> S {
        match self {
            Self::Coarse(t) => t.value().scalar(),
            Self::Fine(t) => t.value().scalar(),
        }
    }
}

/// Vector from a light to a point, and the square root that gives its length.
///
/// A format has one type of offset for each of its evaluations, standard and [quick](super::Quick).
pub trait Offset<S: Types>: Copy + core::fmt::Debug {
    /// Direction and distance, available after the square root.
    type Ray: Ray<S>;
    /// Inner product of a surface normal and the vector back to the light. The scale and the sign
    /// of the inner product depend on the format.
    type Facing: Copy + core::fmt::Debug;

    /// Returns the offset from a light to a point.
    fn between(light: Vec3<S::Position>, point: Vec3<S::Position>) -> Self;
    /// Returns whether the offset is so short that the whole evaluation must be fine: see
    /// [`Errors::fine_below`](super::Errors::fine_below).
    #[inline]
    fn is_near(&self, _fine_below: u32) -> bool {
        false
    }
    /// Returns the inner product of the normal and the vector back to the light.
    fn facing(&self, normal: Vec3<S>) -> Self::Facing;
    /// Returns whether the surface faces away from the light, so that no light arrives. NaN counts
    /// as facing away.
    fn faces_away(facing: Self::Facing) -> bool;
    /// Returns whether the surface faces so far away that the fine evaluation also gives zero
    /// light.
    #[inline]
    fn faces_far_away(facing: Self::Facing) -> bool {
        Self::faces_away(facing)
    }
    /// Returns whether the point is certainly outside a cone, by comparing squares.
    ///
    /// The test may return `false` for a point outside the cone, but never `true` for a point
    /// inside. `bound` is the squared cosine of the outer half angle, less a margin for rounding
    /// errors. The quick evaluations have no such test.
    #[inline]
    fn is_outside(&self, _axis: Vec3<S::Direction>, _bound: S) -> bool {
        false
    }
    /// Returns the result of [`is_outside`](Self::is_outside) for the centre of a sphere, which may
    /// be farther from the light than any lit point: `false` if the squared distance overflows.
    #[inline]
    fn is_center_outside(&self, axis: Vec3<S::Direction>, bound: S) -> bool {
        self.is_outside(axis, bound)
    }
    /// Returns the squared distance.
    fn squared_distance(&self) -> S::Gain;
    /// Computes the direction and the distance, with one square root.
    fn ray(&self) -> Self::Ray;
}

/// An offset that shares most of its computation with those to other points of a row.
pub trait OffsetAlong<S: Types>: Offset<S> {
    /// What the offsets to the points of a stretch share. The points differ in x alone.
    type Stretch: Copy + core::fmt::Debug;

    /// Returns the stretch around a point. It may be empty.
    fn stretch(light: Vec3<S::Position>, point: Vec3<S::Position>) -> Self::Stretch;
    /// Returns whether the point with this x is in a stretch. A stretch has all points between two of its own.
    fn is_in(stretch: &Self::Stretch, x: S::Position) -> bool;
    /// Returns the offset to the point of a stretch with this x: that of [`Offset::between`].
    fn on_stretch(stretch: &Self::Stretch, x: S::Position) -> Self;
}

/// What the loops over many points need of a spotlight with the inverse-square law.
#[derive(Clone, Copy, Debug)]
pub struct Lamp<S: Types> {
    /// The position of the light.
    pub position: Vec3<S::Position>,
    /// The axis, in the form that the rays of the evaluation take.
    pub axis: Vec3<S::Direction>,
    /// The ramp of the cone.
    pub ramp: S::Ramp,
    /// The intensity.
    pub intensity: S::Gain,
    /// The distance within which points are evaluated finely: see [`Offset::is_near`].
    pub fine_below: u32,
}

/// An offset of which many are computed by vector instructions, for formats whose evaluation of a single point has
/// branches.
pub trait Vectors<S: Types>: Offset<S> {
    /// Whether [`in_vectors`](Self::in_vectors) ever returns `true` on this processor.
    const IS_VECTORISED: bool = false;
    /// Whether [`Fraction::cubic`] has the bits of every falloff that is one, also of a soft and a hard edge.
    const HAS_ONE_CUBIC: bool = false;

    /// Computes the light of a lamp at many surface points, bit-identical to that of each point. Returns `false`,
    /// and writes nothing, if the evaluation does not have this, or if a point is rare: one whose evaluation takes
    /// a branch.
    ///
    /// `falloff` is that of the cone; `lobe` returns the specular lobe at the point of an index for the
    /// direction of the light and the cosine of incidence. Matte surfaces do not shine: for these the second
    /// output is not written.
    #[inline(always)]
    fn in_vectors<const N: usize>(
        _lamp: &Lamp<S>,
        _points: Vec3<&[S::Position; N]>,
        _normals: Vec3<&[S; N]>,
        _falloff: impl Fn(S::Fraction) -> <S::Fraction as Fraction<S>>::Value,
        _shines: bool,
        _lobe: impl Fn(usize, Vec3<S::Direction>, S) -> S,
        _arrivals: (&mut [S::Received; N], &mut [S::Received; N]),
    ) -> bool {
        false
    }
}

/// Unit direction from a light to a point, and the distance between them.
///
/// A point at the light itself, or so far away that the squared distance overflows, has no
/// direction. Such a point gets zero light, because its [`cosine`](Ray::cosine) is zero or its
/// versine is outside every cone.
pub trait Ray<S: Types>: Copy + core::fmt::Debug {
    /// Type of the falloff's argument `t`, and of the cosine of the angle of incidence.
    type Fraction: Fraction<S, Value = Self::Share>;
    /// Result type of falloffs and attenuations.
    type Share: Share<S>;

    /// Returns the distance.
    fn distance(&self) -> S::Gain;
    /// Returns the unit direction.
    fn direction(&self) -> Vec3<S::Direction>;
    /// Returns the falloff's argument `t` in this direction, for a cone about this axis.
    ///
    /// The versine of the angle between the direction `l` and the axis `s` is computed as
    /// `|l - s|^2 / 2`. This form keeps the leading bits of the versine in narrow beams; `1 - l.s`
    /// would lose these bits.
    fn rise(&self, axis: Vec3<S::Direction>, ramp: S::Ramp) -> Self::Fraction;
    /// Returns the cosine of the angle of incidence on a surface with this normal. The result is
    /// zero if the surface faces away.
    ///
    /// `facing` is the result of [`Offset::facing`] for the same normal.
    fn cosine(&self, facing: <S::Offset as Offset<S>>::Facing, normal: Vec3<S>) -> Self::Fraction;
    /// Returns the distance times a gain, and exactly 1 if the product is 1 or more.
    #[inline(always)] // `lit-smooth-range` on Cortex-M0: +87 instructions without.
    fn range_share(&self, gain: S::Gain) -> Self::Share {
        Self::Share::of_scalar(self.distance().times(gain).scalar())
    }
    /// Returns the squared distance times a gain, and exactly 1 if the product is 1 or more.
    ///
    /// The squared distance is that of `offset`.
    #[inline(always)] // `lit-smooth-range` on Cortex-M0: +74 instructions without.
    fn squared_range_share<O: Offset<S>>(&self, offset: &O, gain: S::Gain) -> Self::Share {
        Self::Share::of_scalar(offset.squared_distance().times(gain).scalar())
    }
    /// Returns a share times a gain as light, attenuated by the inverse square of the distance.
    ///
    /// The light is zero for a negative share.
    fn light(&self, share: Self::Share, gain: S::Gain) -> S::Received;
    /// Returns a share times a gain as light, attenuated by `1 / (a0 + a1 d + a2 d^2)` of the distance,
    /// at most 1.
    #[inline(always)] // `lit-polynomial` on Cortex-M0: +174 instructions without.
    fn light_by_polynomial(
        &self,
        share: Self::Share,
        coefficients: &[S::Gain; 3],
        gain: S::Gain,
    ) -> S::Received {
        let &[constant, linear, quadratic] = coefficients;
        let distance = self.distance();
        let divisor = quadratic.times(distance).plus(linear).times(distance).plus(constant);
        share.light(divisor.inverse_capped().times(gain))
    }
    /// Returns a share times a gain as light, attenuated by a real power of the distance.
    #[inline]
    fn light_by_decay(&self, share: Self::Share, power: InversePower, gain: S::Gain) -> S::Received {
        share.light(self.distance().inverse_power(power).times(gain))
    }
}

/// A ray along which a light with a distribution is evaluated. The quick evaluations have no such light.
pub trait Directed<S: Types>: Ray<S> {
    /// Returns the intensity of a distribution in the direction of the ray, and zero for a direction that is NaN.
    ///
    /// The vectors of the frame are the side, the front and the axis of the light. The function takes nine multiplications
    /// for the components of the direction, three for the interpolation, and in fixed point six for the reciprocal
    /// `1 / s` and the places: a quadratic, and one step of Newton's iteration.
    fn distributed(&self, frame: &[Vec3<S::Direction>; 3], distribution: Distribution<'_>) -> Self::Share;
    /// Returns the intensity of a light that emits the same in all directions: 1, and zero without a direction.
    fn whole(&self) -> Self::Share;
}

/// A number in `[0, 1]`: the argument of a falloff, or the cosine of an angle of incidence.
///
/// A falloff multiplies the rounding error of its argument by the falloff's derivative, so in fixed
/// point a fraction has at least one bit more than a scalar. The extra bit costs nothing, because a
/// product of fractions needs no wider integer than a product of scalars.
///
/// Only [`Ramps::rise`](super::Ramps::rise), [`Ray::rise`] and [`Ray::cosine`] create fractions, so the argument of
/// a falloff is in range for every input. In the descriptions of the functions, this fraction is
/// `t`, and `u = 1 - t`.
pub trait Fraction<S: Types>: Copy + PartialOrd + core::fmt::Debug {
    /// Result type of a falloff: a scalar, or a number with more bits if a scalar has too few.
    type Value: Share<S>;

    /// Returns `1 - t`.
    fn complement(self) -> Self;
    /// Returns the product of two fractions as a fraction, for further multiplication.
    fn times(self, other: Self) -> Self;
    /// Returns the product of two fractions, rounded once to a value.
    fn times_to_value(self, other: Self) -> Self::Value;
    /// Returns `t` times a value in `[0, 1]`.
    fn times_value(self, value: Self::Value) -> Self::Value;
    /// Returns `t^p` for a non-integer exponent `p` as a fraction: exactly 0 at `t = 0` and exactly 1 at
    /// `t = 1`.
    ///
    /// The error before the format's own rounding is at most `e = 2e-9 + 6.5e-10 p`, and with a floor
    /// `2 e / (1 - floor^p) + 8e-9`. The function takes eleven 64-bit multiplications in every format.
    /// For an exponent with a floor the function returns
    /// `(max(t, floor)^p - floor^p) / (1 - floor^p)`.
    fn real_power(self, exponent: RealExponent) -> Self;
    /// Returns `t`, rounded to the nearest value.
    fn value(self) -> Self::Value;
    /// Returns 1 if `t > 0`, else 0.
    fn step(self) -> Self::Value;
    /// Returns `t^2 (3 - 2 t)`: two multiplications.
    fn smooth(self) -> Self::Value;
    /// Returns `t (1 + g u)` for `g` in `[-1, 1]`: two multiplications.
    fn quadratic(self, g: S::Weight) -> Self::Value;
    /// Returns `t (1 + u (g + h t))`: three multiplications.
    ///
    /// Valid coefficients are `g` in `[-1, 3]`, `h` in `[-4, 2]` and `g + h` in `[-3, 1]`, where
    /// the cubic is monotone.
    fn cubic(self, g: S::Weight, h: S::Weight) -> Self::Value;
    /// Returns `(1 - k) t^2 + k w^2` with `w = max(0, 1 - g u)`, for `k` in `[0, 1]` and `g` in `[1, 1024]`: exactly
    /// 0 at `t = 0` and exactly 1 at `t = 1`. Five multiplications, in an order that keeps the result monotone.
    fn soft_pair(self, share: S::Weight, ratio: S::Gain) -> Self::Value;
    /// Interpolates linearly between samples that are evenly spaced from `u = 0`; 65,535 means 1.
    ///
    /// The function takes one multiplication for the position and one for the interpolation.
    /// Without samples the result is 0; at most 65,536 samples are supported.
    fn sample(self, samples: &[u16]) -> Self::Value;
    /// Returns the value at `u` of the line that starts at the last knot before `u`, clamped to
    /// `[0, 1]`.
    ///
    /// The function takes a binary search and one multiplication. Without knots the result is 0.
    fn sample_knots(self, knots: &[Knot]) -> Self::Value;
}

/// A factor of a light in `[0, 1]`, such as a falloff: a scalar, or a number with more bits.
pub trait Share<S: Types>: Copy + Default + PartialOrd + core::fmt::Debug {
    /// Converts a scalar in `[0, 1]` exactly.
    fn of_scalar(scalar: S) -> Self;
    /// Returns the nearest scalar.
    fn scalar(self) -> S;
    /// Returns whether the share is exactly 1.
    fn is_one(self) -> bool;
    /// Returns `1 - share`.
    fn complement(self) -> Self;
    /// Returns the product of two shares.
    ///
    /// For scalars outside `[0, 1]`, fixed point returns an unspecified value in `[0, 1]`.
    fn times(self, other: Self) -> Self;
    /// Returns `t^2 (3 - 2t)`, where `t` is this share clamped to `[0, 1]`. The result is exact at 0
    /// and 1.
    fn smooth(self) -> Self;
    /// Returns this share times a gain as light, without attenuation; zero for a negative scalar.
    fn light(self, gain: S::Gain) -> S::Received;
}

/// A factor of at least 0 with its own exponent, for arithmetic on distances.
///
/// Fixed point rounds every result to the nearest mantissa, of 16 bits in [`Fx16`](super::Fx16) and
/// 28 bits in [`Fx32`](super::Fx32). Rounding to nearest keeps monotone functions monotone.
pub trait Gain<S: Types>: Copy + PartialEq + core::fmt::Debug {
    /// Returns the product.
    fn times(self, other: Self) -> Self;
    /// Returns the sum.
    fn plus(self, other: Self) -> Self;
    /// Returns the reciprocal, capped at 1: `1 / max(gain, 1)`.
    fn inverse_capped(self) -> Self;
    /// Returns the nearest scalar, and exactly 1 for gains of 1 and more.
    fn scalar(self) -> S;
    /// Returns the product with a scalar that is clamped to `[0, 1]`; NaN counts as 0. The product
    /// with 1 has the same bits.
    fn times_scalar(self, scalar: S) -> Self;
    /// Returns the power of the gain, at most its cap.
    fn inverse_power(self, power: InversePower) -> Self;
}
