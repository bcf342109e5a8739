//! The private interface between the kernel and the number formats.
//!
//! The kernel is written once, in terms of the high-level operations below. All widening, shifting,
//! rounding and saturation is in the implementations of these operations.
//!
//! | | `f32` | `Fx32` | `Fx16` |
//! |---|---|---|---|
//! | fraction: the argument of a falloff | f32 | U1F31 | U1F15 |
//! | gain: a factor with its own exponent | f32 | 28-bit mantissa and shift | 32-bit mantissa (results: 16 bits) and shift |
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
    /// Versine of an angle off axis, in the scale of a ramp.
    ///
    /// The scale keeps the leading bits of a narrow cone.
    type Versine: Copy + PartialOrd + core::fmt::Debug;
    /// Argument of a profile: 0 at the edge of a cone, 1 in its middle.
    type Fraction: Fraction<Self, Value = Self>;
    /// The same argument with more bits, for a steep cone or a bright light.
    ///
    /// A format whose `Fraction` has enough bits uses the same type here.
    type Fine: Fraction<Self>;
    /// Coefficient of an edge profile, in `[-4, 4]`.
    type Weight: Copy + PartialEq + core::fmt::Debug;
    /// Compiled ramp from the edge of a cone to its middle.
    type Ramp: Copy + PartialEq + core::fmt::Debug;
    /// Compiled frame of a projection about the axis of a light.
    type Frame: Copy + PartialEq + core::fmt::Debug;
    /// Factor of at least 0 that keeps its leading bits at every magnitude.
    type Gain: Gain<Self>;
    /// Vector from a light to a point, before its length is computed.
    type Offset: FullOffset<Self>;
    /// Upper bound of the error of the direction to a point, in radians.
    ///
    /// A narrow cone magnifies this error. In `f32` about half of this bound is the rounding of
    /// `point - light`. That difference is exact if both positions are multiples of the same power
    /// of two.
    const DIRECTION_ERROR: f32;
    /// Returns `steps / 16384` for `steps` in `[0, 16384]`: exact in every format.
    fn part(steps: u32) -> Self;
    /// Converts an axis whose length is 1 within the rounding of `f32` to a unit vector of the
    /// format.
    fn axis(axis: Vec3<f32>) -> Vec3<Self::Direction>;
    /// Returns the unit vector along a vector whose largest component is in `[1/2, 1]`.
    ///
    /// `unit` is the same direction, normalised in `f32`.
    fn aim(_: Vec3<f32>, unit: Vec3<f32>) -> Vec3<Self::Direction> {
        Self::axis(unit)
    }
    /// Returns the nearest versine in the scale of a ramp; saturates beyond the ramp's outer
    /// versine.
    fn versine(ramp: Self::Ramp, value: f32) -> Self::Versine;
    /// Returns the nearest weight; saturates at -4 and 4, and NaN becomes zero.
    fn weight(value: f32) -> Self::Weight;
    /// Returns the nearest gain; a negative value or NaN becomes zero.
    fn gain(value: f32) -> Self::Gain;

    /// Returns the product of two values in `[0, 1]`.
    ///
    /// Outside that domain fixed point still returns a value in `[0, 1]`, but an unspecified one.
    fn times(self, other: Self) -> Self;
    /// Returns the difference; fixed point saturates.
    fn minus(self, other: Self) -> Self;

    /// Returns the offset from a light to a point.
    fn offset(light: Vec3<Self::Position>, point: Vec3<Self::Position>) -> Self::Offset;
    /// Compiles a ramp between two versines: 0 at `outer`, 1 at and inside `inner`.
    ///
    /// From the versine `limit` outwards the ramp is cut off to 0. With `limit == outer` nothing is
    /// cut off. With `inner == outer` the ramp is a step.
    fn ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp;
    /// Upper bound of the rounding error of an intensity, in addition to the error from the
    /// direction.
    ///
    /// The bound holds for a cone of any angle. It covers the errors of the direction's length, of
    /// the set-up versines, of the argument of the profile and of the profile itself. It is
    /// infinite if the format cannot keep the error within half a linear code at any angle.
    fn rounding(edge: &Slopes) -> f32;
    /// Upper bound of the intensity error of the whole coarse evaluation, including the error of
    /// the direction.
    ///
    /// The cone spans versines from 0 to `outer` and is evaluated up to `limit`. If the bound
    /// exceeds half a linear code, the cone needs a [`fine_ramp`](Self::fine_ramp). The bound is
    /// zero in a format that has only one evaluation.
    fn coarse_error(_edge: &Slopes, _outer: f32, _limit: f32) -> f32 {
        0.0
    }
    /// As [`ramp`](Self::ramp), but the ramp is always evaluated with [`Fine`](Self::Fine)
    /// fractions.
    fn fine_ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp {
        Self::ramp(inner, outer, limit)
    }
    /// Maps a versine to its position on a ramp, in `[0, 1]`.
    ///
    /// It is exactly 0 at and beyond the limit, otherwise exactly 1 at and inside the inner
    /// versine, and monotone between.
    fn rise(ramp: Self::Ramp, versine: Self::Versine) -> Rise<Self>;
    /// Returns the length of an offset below which the evaluation must be fine.
    ///
    /// The result is encoded for [`FullOffset::is_near`]. The gain multiplies a share and so
    /// magnifies the error of the share; below the returned length the product may be off by half a
    /// linear code. `error` is the [`coarse_error`](Self::coarse_error) of the light's cone, 0 for
    /// a light without a cone. `intensity` is the gain at distance 1; if the irradiance does not
    /// grow towards the light (`!grows`), it is the gain at every distance.
    fn fine_below(_error: f32, _intensity: f32, _grows: bool) -> u32 {
        0
    }
    /// Returns whether `light`, the product of this share and a gain, exceeds full scale whatever
    /// the error of the share.
    ///
    /// A fine evaluation would then give the same clipped result.
    #[inline]
    fn is_clipped(_share: Self, _light: Self::Received) -> bool {
        false
    }
    /// Returns `t^2 (3 - 2t)` for a `t` clamped to `[0, 1]`: exact at both ends.
    fn smooth(self) -> Self;

    /// Compiles the frame of a square from three unit vectors and the tangent of half its side.
    ///
    /// The vectors point right, down and along the axis. They are orthogonal within the rounding of
    /// `f32`.
    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> Self::Frame;
    /// Projects a point onto the square of a light.
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
    /// The result is exactly zero if all bytes are 0, exactly one if all bytes are 255 and for
    /// larger sums, and otherwise within one step.
    fn weighted_byte(sum: u32) -> Self;

    /// Returns the versine of the angle between two unit directions, in the scale of a ramp.
    ///
    /// It is computed from the difference of the directions.
    fn versine_between(a: Vec3<Self::Direction>, b: Vec3<Self::Direction>, ramp: Self::Ramp)
    -> Self::Versine;
    /// Returns `(1 - versine)^exponent` by repeated squaring, and zero from a right angle on.
    ///
    /// This is a power of the cosine. Fixed point computes with `1 - cosine`, which keeps its
    /// leading bits near the axis. The versine is in the scale of a ramp from 0 to 1.
    fn power(versine: Self::Versine, exponent: u32) -> Self;
    /// Converts a normal to the resolution of directions.
    fn normal_unit(normal: Vec3<Self>) -> Vec3<Self::Direction>;
    /// Reflects a direction in the surface with this normal: `d - 2 (d.n) n`.
    fn mirror(direction: Vec3<Self::Direction>, normal: Vec3<Self>) -> Vec3<Self::Direction>;
    /// Returns the unit vector along `b - a`, for two unit directions.
    ///
    /// Equal directions have no such vector. The result is then (nearly) zero, which is not close
    /// to any unit direction it is compared with.
    fn direction_between(a: Vec3<Self::Direction>, b: Vec3<Self::Direction>) -> Vec3<Self::Direction>;
    /// Returns the cosine of the angle of incidence of a unit direction; zero if the surface faces
    /// away.
    fn incidence(direction: Vec3<Self::Direction>, normal: Vec3<Self>) -> Self;

    /// Returns a fraction of a gain as light, without attenuation; zero for a negative fraction.
    fn expose(self, gain: Self::Gain) -> Self::Received;
    /// Multiplies a channel of light by a colour.
    fn filter(light: Self::Received, color: Self) -> Self::Received;
    /// Returns the sum of two lights.
    fn add_light(a: Self::Received, b: Self::Received) -> Self::Received;
    /// Converts a light to a gain.
    fn light_to_gain(light: Self::Received) -> Self::Gain;
    /// Multiplies a light by a gain; a gain of one changes no bit.
    fn amplify(light: Self::Received, gain: Self::Gain) -> Self::Received;
    /// Clips a light to full scale.
    fn clip(light: Self::Received) -> Self;
    /// Returns the stored word of the value.
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

/// Upper bounds of the slopes of a cone's intensity, which magnify the errors of its arguments.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Slopes {
    /// Slope with respect to the angle off axis, in units of the outer half angle.
    ///
    /// A relative error `e` of the versine changes the intensity by at most `angle * e / 2`.
    pub angle: f32,
    /// Slope with respect to the argument of the profile.
    pub fraction: f32,
}

impl Slopes {
    /// The slopes that stand for a step, whose true slopes are infinite: with them, the bound of
    /// half a code limits the error of the step's position to 1/510 of the half angle.
    pub const STEP: Self = Self { angle: 1.0, fraction: 0.0 };
}

/// Argument of a profile, with as many bits as the cone needs.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub enum Rise<S: Arithmetic> {
    /// One bit more than a scalar.
    Coarse(S::Fraction),
    /// The format's full precision.
    Fine(S::Fine),
}

impl<S: Arithmetic> Rise<S> {
    /// Returns the nearest scalar.
    #[inline]
    pub(crate) fn scalar(self) -> S {
        match self {
            Self::Coarse(t) => t.scalar(),
            Self::Fine(t) => t.scalar().rounded(),
        }
    }
}

/// A share of a light in `[0, 1]`: a scalar, or a number with more bits.
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
    /// Returns `t^2 (3 - 2t)`.
    fn smoothed(self) -> Self;
    /// Returns this share of a gain as light, without attenuation.
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
}

/// Offset from a light to a point, before the square root, and the root itself.
pub trait Offset<S: Arithmetic>: Copy + core::fmt::Debug {
    /// Direction and distance, available after the square root.
    type Ray: Ray<S>;
    /// Type of the inner product of a surface normal and the vector back to the light, in a scale
    /// that depends on the format.
    type Facing: Copy + core::fmt::Debug;

    /// Returns the inner product of the normal and the vector back to the light.
    fn facing(&self, normal: Vec3<S>) -> Self::Facing;
    /// Returns whether the surface faces away, so that no light arrives. NaN counts as facing away.
    fn faces_away(facing: Self::Facing) -> bool;
    /// Returns the squared distance.
    fn squared_distance(&self) -> S::Gain;
    /// Computes the square root.
    fn ray(&self) -> Self::Ray;
}

/// An offset of the format's standard evaluation: with the early-out test for the cone, and with
/// the format's full precision.
pub trait FullOffset<S: Arithmetic>:
    Offset<S, Ray: Ray<S, Fraction = S::Fraction, Share = S, Ramp = S::Ramp>>
{
    /// [`Ray`](Offset::Ray) with more bits; the same type in a format that has only one.
    type FineRay: Ray<S, Fraction = S::Fine, Ramp = S::Ramp>;

    /// Whether a batch loop first computes all roots with [`reciprocal`](Self::reciprocal), without
    /// early-outs.
    const ROOTS_FIRST: bool = false;

    /// Returns whether the surface faces away so far that the fine evaluation also gives zero.
    #[inline]
    fn faces_far_away(facing: Self::Facing) -> bool {
        Self::faces_away(facing)
    }
    /// Returns whether the point is certainly outside a cone, by comparing squares.
    ///
    /// It may return `false` for a point outside, but never `true` for a point inside. `bound` is
    /// the squared cosine of the outer half angle, less a margin for rounding.
    fn is_outside(&self, axis: Vec3<S::Direction>, bound: S) -> bool;
    /// Computes the square root with the format's full precision.
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
    /// As [`ray`](Offset::ray), but reuses the root returned by [`reciprocal`](Self::reciprocal).
    #[inline]
    fn ray_of(&self, _reciprocal: f32) -> Self::Ray {
        self.ray()
    }
}

/// Unit direction from a light to a point, and the distance between them.
///
/// A point at the light itself, or so far away that the squared distance overflows, has no
/// direction. It gets zero light, because its [`cosine`](Ray::cosine) is zero or its versine is
/// outside every cone.
pub trait Ray<S: Arithmetic>: Copy + core::fmt::Debug {
    /// Type of the position of a direction on a ramp, and of the cosine of an angle of incidence.
    type Fraction: Fraction<S, Value = Self::Share>;
    /// Result type of profiles and distance models.
    type Share: Share<S>;
    /// Compiled ramp from the edge of a cone to its middle.
    type Ramp: Copy + PartialEq + core::fmt::Debug;

    /// Returns the distance.
    fn distance(&self) -> S::Gain;
    /// Returns the unit direction.
    fn direction(&self) -> Vec3<S::Direction>;
    /// Returns the position of the direction on a ramp, for a cone about this axis.
    ///
    /// The versine of the angle between them is computed as `|l - s|^2 / 2` for the direction `l`
    /// and the axis `s`, which keeps the leading bits in narrow beams; `1 - l.s` would lose them.
    fn rise(&self, axis: Vec3<S::Direction>, ramp: Self::Ramp) -> Self::Fraction;
    /// Returns the cosine of the angle of incidence on a surface with this normal; zero if it faces
    /// away.
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
    /// Returns the light of a share of a gain, attenuated by the inverse square of the distance.
    ///
    /// Zero for a negative share.
    fn expose(&self, share: Self::Share, gain: S::Gain) -> S::Received;
}
