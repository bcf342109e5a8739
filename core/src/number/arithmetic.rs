//! The private interface between the kernel and the number formats.
//!
//! The kernel is written once, in terms of the high-level operations of these traits. Their
//! implementations contain all widening, shifting, rounding and saturation.
//!
//! | | `f32` | `Fx32` | `Fx16` |
//! |---|---|---|---|
//! | fraction: the argument of a falloff | f32 | U1F31 | U1F15; U1F31 for steep cones and bright lights |
//! | gain: a factor with its own exponent | f32 | 28-bit mantissa and shift | 32-bit mantissa (computed gains: 16 bits) and shift |
//! | rounding of `times` | to nearest, ties to even | to nearest, ties up | to nearest, ties up |
//!
//! In every format and for every bit pattern:
//!
//! - No operation panics.
//! - A NaN in a point, a normal, a versine or a gain gives zero light.
//! - `ONE.times(x) == x` for x in `[0, 1]`.

use super::{Fraction, ProjectedPoint, Scalar};
#[cfg(feature = "fixed")]
use super::{Fx16, Fx32};
use crate::vec3::Vec3;

/// Arithmetic of a number format: the high-level operations that the kernel is written in.
pub trait Arithmetic: Copy + Default + PartialOrd + core::fmt::Debug + Share<Self> {
    /// [`Scalar::Length`].
    type Position: Copy + Default + PartialOrd + core::fmt::Debug;
    /// [`Scalar::Unit`].
    type Direction: Copy + Default + PartialEq + core::fmt::Debug;
    /// [`Scalar::Irradiance`].
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
    type Offset: FullOffset<Self>;
    /// Upper bound of the error of the direction from a light to a point, in radians.
    ///
    /// A narrow cone magnifies this error. In `f32` about half of this bound is the rounding error
    /// of `point - light`. The difference `point - light` is exact if both positions are multiples
    /// of the same power of two.
    const DIRECTION_ERROR: f32;
    /// Step of the squared cosines that [`FullOffset::is_outside`] compares.
    const OUTSIDE_STEP: f32;
    /// Returns `steps / 16384` for `steps` in `[0, 16384]`: exact in every format.
    fn part(steps: u32) -> Self;
    /// Converts an axis to a unit vector of the format. The given axis has length 1 within the
    /// rounding error of `f32`.
    fn axis(axis: Vec3<f32>) -> Vec3<Self::Direction>;
    /// Returns the unit vector along a vector whose largest component is in `[1/2, 1]`.
    ///
    /// `unit` is the same vector, normalised in `f32`.
    fn aim(_: Vec3<f32>, unit: Vec3<f32>) -> Vec3<Self::Direction> {
        Self::axis(unit)
    }
    /// Returns the nearest versine in the scale of a ramp. Only a value beyond the end of the ramp
    /// saturates.
    fn versine(ramp: Self::Ramp, value: f32) -> Self::Versine;
    /// Returns the nearest coefficient of a falloff; saturates at -4 and 4, and NaN becomes zero.
    fn weight(value: f32) -> Self::Weight;
    /// Returns the nearest gain; a negative value or NaN becomes zero.
    fn gain(value: f32) -> Self::Gain;

    /// Returns the product of two values in `[0, 1]`.
    ///
    /// For values outside `[0, 1]`, fixed point returns an unspecified value in `[0, 1]`.
    fn times(self, other: Self) -> Self;
    /// Returns `self - other`; fixed point saturates.
    fn minus(self, other: Self) -> Self;

    /// Returns the offset: the vector from a light to a point.
    fn offset(light: Vec3<Self::Position>, point: Vec3<Self::Position>) -> Self::Offset;
    /// Returns the centre and the radius of a sphere around the line between two points, and around
    /// points within a step of it.
    fn enclosing(a: Vec3<Self::Position>, b: Vec3<Self::Position>) -> (Vec3<Self::Position>, Self::Position);
    /// Returns the tip of a cone, moved back along the axis by at least `radius / sin(angle)` with
    /// the half angle. A sphere of this radius is outside the cone if its centre is outside the cone
    /// with the moved tip.
    ///
    /// `bound` is that of [`FullOffset::is_outside`], from which the test removes the margin. The
    /// result is `None` for a half angle of 90 degrees or more, for one that the margin hides, and
    /// in fixed point if the tip moves by 8 km or more, or beyond the range of a length.
    fn moved_back(
        tip: Vec3<Self::Position>,
        axis: Vec3<Self::Direction>,
        bound: Self,
        radius: Self::Position,
    ) -> Option<Vec3<Self::Position>>;
    /// Returns an offset along a vector of any length, for its direction.
    fn offset_along(direction: Vec3<Self::Direction>) -> Self::Offset;
    /// Compiles a ramp between two versines: `t` is 0 at `outer`, and 1 up to `inner`.
    ///
    /// From the versine `limit` outwards `t` is 0. With `limit == outer` the ramp has no cutoff.
    /// With `inner == outer` the ramp is a step.
    fn ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp;
    /// Returns an upper bound of the rounding error of an intensity, without the effect of the
    /// direction's error.
    ///
    /// The bound holds for a cone of any angle. The bound covers the errors of the direction's
    /// length, of the versines computed at set-up, of the falloff's argument `t` and of the falloff
    /// itself. The bound is infinite if the format cannot keep the error within half a linear code
    /// (1/510 of full scale) at any angle.
    fn rounding(edge: &Slopes) -> f32;
    /// Returns an upper bound of the intensity error of the coarse evaluation, including the
    /// direction's error.
    ///
    /// The cone spans versines from 0 to `outer` and is evaluated up to the versine `limit`. If the
    /// bound exceeds half a linear code, the cone needs a [`fine_ramp`](Self::fine_ramp). The bound
    /// is zero in a format that has only one evaluation.
    fn coarse_error(_edge: &Slopes, _outer: f32, _limit: f32) -> f32 {
        0.0
    }
    /// Compiles the ramp of [`ramp`](Self::ramp), but for evaluation with [`Fine`](Self::Fine)
    /// fractions only.
    fn fine_ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp {
        Self::ramp(inner, outer, limit)
    }
    /// Returns the ramp of the cone between the cones of two ramps, and the bound of this cone for
    /// [`FullOffset::is_outside`].
    ///
    /// The roots of the three versines of a cone are interpolated. `part` is between 0 and 1; for
    /// any other part the ramp is an unspecified one. If one of the ramps is a
    /// [`fine_ramp`](Self::fine_ramp), then so is the result.
    fn zoomed(from: Self::Ramp, to: Self::Ramp, part: Self) -> (Self::Ramp, Self);
    /// Returns the falloff's argument `t` at a versine, in `[0, 1]`.
    ///
    /// `t` is exactly 0 from the ramp's limit on, and otherwise exactly 1 up to the inner versine.
    /// Between the two versines `t` is monotone.
    fn rise(ramp: Self::Ramp, versine: Self::Versine) -> Rise<Self>;
    /// Returns the distance from a light within which points need the fine evaluation.
    ///
    /// The result is encoded for [`FullOffset::is_near`]. The light at a point is a share (falloff
    /// times cosine) times a gain. The gain magnifies the error of the share. Below the returned
    /// distance, the light may be wrong by half a linear code. `error` is the
    /// [`coarse_error`](Self::coarse_error) of the light's cone, 0 for a light without a cone.
    /// `intensity` is the gain at distance 1. If the irradiance does not grow towards the light
    /// (`!grows`), `intensity` is the gain at every distance.
    fn fine_below(_error: f32, _intensity: f32, _grows: bool) -> u32 {
        0
    }
    /// Returns whether `light` exceeds full scale for every possible error of `share`.
    ///
    /// `light` is the product of `share`, window included, and a gain. If `light` exceeds full scale, the fine
    /// evaluation would give the same clipped result.
    #[inline]
    fn is_clipped(_share: Self, _light: Self::Received) -> bool {
        false
    }
    /// Returns `t^2 (3 - 2t)`, where `t` is this value clamped to `[0, 1]`. The result is exact at
    /// 0 and 1.
    fn smooth(self) -> Self;

    /// Compiles the frame of a projected square from three unit vectors and the size of the square.
    ///
    /// The vectors point right, down and along the axis, and are orthogonal within the rounding
    /// error of `f32`. `tangent` is half the side of the square at distance 1 along the axis.
    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> Self::Frame;
    /// Returns the position of a point on the square that a light projects.
    fn place(
        frame: &Self::Frame,
        light: Vec3<Self::Position>,
        point: Vec3<Self::Position>,
    ) -> ProjectedPoint<Self>
    where
        Self: Scalar;

    /// Converts a weighted sum of bytes to a value, where the weights sum to 2^24 and byte 255
    /// means 1.
    ///
    /// The result is exactly 0 if all bytes are 0, and exactly 1 if all bytes are 255 or the sum is
    /// larger. Any other result is within one step of the exact value.
    fn weighted_byte(sum: u32) -> Self;

    /// Returns the versine of the angle between two unit directions, in the scale of a ramp.
    ///
    /// The versine is half the squared difference of the directions.
    fn versine_between(a: Vec3<Self::Direction>, b: Vec3<Self::Direction>, ramp: Self::Ramp)
    -> Self::Versine;
    /// Returns `(1 - versine)^exponent` by repeated squaring, and zero from a right angle on.
    ///
    /// The base `1 - versine` is the cosine. Fixed point computes with `1 - cosine`, because
    /// `1 - cosine` keeps its leading bits near the axis. The versine is in the scale of a ramp
    /// from 0 to 1.
    fn power(versine: Self::Versine, exponent: u32) -> Self;
    /// Converts a surface normal to the number type of directions.
    fn normal_unit(normal: Vec3<Self>) -> Vec3<Self::Direction>;
    /// Rounds a unit direction to a surface normal.
    fn unit_normal(unit: Vec3<Self::Direction>) -> Vec3<Self>;
    /// Returns a vector in proportion to three bytes.
    fn unit_of_bytes(bytes: [i8; 3]) -> Vec3<Self::Direction>;
    /// Reflects a direction `d` in the surface with the normal `n`: `d - 2 (d.n) n`.
    fn mirror(direction: Vec3<Self::Direction>, normal: Vec3<Self>) -> Vec3<Self::Direction>;
    /// Returns the unit vector along `b - a`, for two unit directions.
    ///
    /// For equal directions the result is (nearly) zero, and so not close to any unit direction.
    fn direction_between(a: Vec3<Self::Direction>, b: Vec3<Self::Direction>) -> Vec3<Self::Direction>;
    /// Returns the cosine of the angle of incidence of light in a unit direction. The result is
    /// zero if the surface faces away.
    fn incidence(direction: Vec3<Self::Direction>, normal: Vec3<Self>) -> Self;

    /// Returns this scalar times a gain as light, without attenuation; zero for a negative scalar.
    fn expose(self, gain: Self::Gain) -> Self::Received;
    /// Multiplies a channel of light by the same channel of a colour.
    fn filter(light: Self::Received, color: Self) -> Self::Received;
    /// Returns the sum of two lights.
    fn add_light(a: Self::Received, b: Self::Received) -> Self::Received;
    /// Converts a light to a gain.
    fn light_to_gain(light: Self::Received) -> Self::Gain;
    /// Multiplies a light by a gain; a gain of one changes no bit.
    fn amplify(light: Self::Received, gain: Self::Gain) -> Self::Received;
    /// Clips a light to full scale.
    fn clip(light: Self::Received) -> Self;
    /// Returns a light in steps of 2^-14 of full scale, truncated; saturates.
    fn light_steps(light: Self::Received) -> u32;
    /// Returns the value as the word that the format stores.
    fn word(self) -> Word;
}

/// A scalar as the word that its format stores, for comparisons with the display tables.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Word {
    /// An `f32`.
    Single(f32),
    /// An integer in units of 2^-14.
    #[cfg(feature = "fixed")]
    Steps14(i16),
    /// An integer in units of 2^-30.
    #[cfg(feature = "fixed")]
    Steps30(i32),
}

/// Half a linear code, 1/510: the largest permitted error of an intensity.
pub(crate) const HALF_A_CODE: f32 = 1.0 / 510.0;

/// Upper bounds of the derivatives of a cone's intensity, by which errors of the arguments are
/// magnified.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Slopes {
    /// Derivative with respect to the angle off axis, where the angle is in units of the outer half
    /// angle.
    ///
    /// A relative error `e` of the versine changes the intensity by at most `angle * e / 2`.
    pub angle: f32,
    /// Derivative with respect to the argument `t` of the falloff.
    pub fraction: f32,
}

impl Slopes {
    /// The values used for a step, whose true derivatives are infinite.
    ///
    /// With these values, the bound of half a linear code (1/510) for the intensity error limits
    /// the error of the step's position to 1/510 of the half angle.
    pub const STEP: Self = Self { angle: 1.0, fraction: 0.0 };
}

/// Argument `t` of a falloff, with as many bits as the cone needs.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub enum Rise<S: Arithmetic> {
    /// A fraction with one bit more than a scalar.
    Coarse(S::Fraction),
    /// A fraction with the format's full precision.
    Fine(S::Fine),
}

impl<S: Arithmetic> Rise<S> {
    /// Returns the nearest scalar.
    #[inline]
    pub(crate) fn scalar(self) -> S {
        match self {
            Self::Coarse(t) => t.scalar().rounded(),
            Self::Fine(t) => t.scalar().rounded(),
        }
    }
}

/// A factor of a light in `[0, 1]`, such as a falloff: a scalar, or a number with more bits.
pub trait Share<S: Arithmetic>: Copy + Default + PartialOrd + core::fmt::Debug {
    /// Converts a scalar in `[0, 1]` exactly.
    fn of_scalar(scalar: S) -> Self;
    /// Returns the nearest scalar.
    fn rounded(self) -> S;
    /// Returns whether the share is exactly 1.
    fn is_all(self) -> bool;
    /// Returns `1 - share`.
    fn rest(self) -> Self;
    /// Returns the product of two shares.
    fn share_of(self, other: Self) -> Self;
    /// Returns `t^2 (3 - 2t)` for this share `t`.
    fn smoothed(self) -> Self;
    /// Returns this share times a gain as light, without attenuation.
    fn give(self, gain: S::Gain) -> S::Received;
}

/// Implements `Share` for a scalar by the scalar's own operations.
macro_rules! share_of_its_own {
    ($($scalar:ty)*) => {$(
        impl Share<$scalar> for $scalar {
            #[inline]
            fn of_scalar(scalar: Self) -> Self {
                scalar
            }

            #[inline]
            fn rounded(self) -> Self {
                self
            }

            #[inline]
            fn is_all(self) -> bool {
                self == Self::ONE
            }

            #[inline]
            fn rest(self) -> Self {
                Self::ONE.minus(self)
            }

            #[inline]
            fn share_of(self, other: Self) -> Self {
                self.times(other)
            }

            #[inline]
            fn smoothed(self) -> Self {
                self.smooth()
            }

            #[inline]
            fn give(self, gain: <Self as Arithmetic>::Gain) -> <Self as Arithmetic>::Received {
                self.expose(gain)
            }
        }
    )*};
}

share_of_its_own!(f32);
#[cfg(feature = "fixed")]
share_of_its_own!(Fx16 Fx32);

/// A factor of at least 0 with its own exponent, for arithmetic on distances.
///
/// Fixed point rounds every result to the nearest mantissa, of 16 bits in [`Fx16`] and 28 bits in
/// [`Fx32`]. Rounding to nearest keeps monotone functions monotone.
pub trait Gain<S: Arithmetic>: Copy + PartialEq + core::fmt::Debug {
    /// Returns the product.
    fn by(self, other: Self) -> Self;
    /// Returns the sum.
    fn plus(self, other: Self) -> Self;
    /// Returns the reciprocal, capped at 1: `1 / max(gain, 1)`.
    fn inverse_capped(self) -> Self;
    /// Returns the nearest scalar, and exactly 1 for gains of 1 and more.
    fn fraction(self) -> S;
    /// Returns the product with a scalar that is clamped to `[0, 1]`; NaN counts as 0. The product
    /// with 1 has the same bits.
    fn part(self, part: S) -> Self;
}

/// Vector from a light to a point, and the square root that gives its length.
pub trait Offset<S: Arithmetic>: Copy + core::fmt::Debug {
    /// Direction and distance, available after the square root.
    type Ray: Ray<S>;
    /// Inner product of a surface normal and the vector back to the light. The scale and the sign
    /// of the inner product depend on the format.
    type Facing: Copy + core::fmt::Debug;

    /// Returns the inner product of the normal and the vector back to the light.
    fn facing(&self, normal: Vec3<S>) -> Self::Facing;
    /// Returns whether the surface faces away from the light, so that no light arrives. NaN counts
    /// as facing away.
    fn faces_away(facing: Self::Facing) -> bool;
    /// Returns the squared distance.
    fn squared_distance(&self) -> S::Gain;
    /// Computes the direction and the distance, with one square root.
    fn ray(&self) -> Self::Ray;
}

/// An offset of the format's standard evaluation. This trait adds an early-out test for the cone,
/// and rays of the format's full precision.
pub trait FullOffset<S: Arithmetic>:
    Offset<S, Ray: Ray<S, Fraction = S::Fraction, Share = <S::Fraction as Fraction<S>>::Value>>
{
    /// A ray with more bits than [`Ray`](Offset::Ray); the same type in a format with only one
    /// evaluation.
    type FineRay: Ray<S, Fraction = S::Fine>;

    /// Whether a loop over many points first computes all reciprocal lengths with
    /// [`reciprocal`](Self::reciprocal), without early-outs.
    const ROOTS_FIRST: bool = false;

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
    /// errors.
    fn is_outside(&self, axis: Vec3<S::Direction>, bound: S) -> bool;
    /// Returns whether the offset has a direction: whether it is not zero, and in `f32` whether its
    /// squared length is a normal number.
    fn has_direction(&self) -> bool;
    /// Computes the direction and the distance with the format's full precision.
    fn fine_ray(&self) -> Self::FineRay;
    /// Returns whether the offset is so short that the whole evaluation must be fine: see
    /// `Arithmetic::fine_below`.
    #[inline]
    fn is_near(&self, _fine_below: u32) -> bool {
        false
    }
    /// Returns the reciprocal of the length; zero if the offset has no direction, or if
    /// `ROOTS_FIRST` is false.
    #[inline]
    fn reciprocal(&self) -> f32 {
        0.0
    }
    /// Returns the result of [`ray`](Offset::ray), but reuses the reciprocal length returned by
    /// [`reciprocal`](Self::reciprocal).
    #[inline]
    fn ray_of(&self, _reciprocal: f32) -> Self::Ray {
        self.ray()
    }
}

/// Unit direction from a light to a point, and the distance between them.
///
/// A point at the light itself, or so far away that the squared distance overflows, has no
/// direction. Such a point gets zero light, because its [`cosine`](Ray::cosine) is zero or its
/// versine is outside every cone.
pub trait Ray<S: Arithmetic>: Copy + core::fmt::Debug {
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
    #[inline(always)] // `spot-soft-lambert-smooth-range` on Cortex-M0: +87 instructions without.
    fn near(&self, gain: S::Gain) -> Self::Share {
        Self::Share::of_scalar(self.distance().by(gain).fraction())
    }
    /// Returns the squared distance times a gain, and exactly 1 if the product is 1 or more.
    ///
    /// The squared distance is that of `offset`.
    #[inline(always)] // `spot-soft-lambert-smooth-range` on Cortex-M0: +74 instructions without.
    fn squared_near<O: Offset<S>>(&self, offset: &O, gain: S::Gain) -> Self::Share {
        Self::Share::of_scalar(offset.squared_distance().by(gain).fraction())
    }
    /// Returns a share times a gain as light, attenuated by the inverse square of the distance.
    ///
    /// The light is zero for a negative share.
    fn expose(&self, share: Self::Share, gain: S::Gain) -> S::Received;
}
