//! The private seam between the kernel and the number formats.
//!
//! The kernel above it is written once, in the coarse steps below; every widening, shift, rounding and saturation lives
//! under it.
//!
//! | | `f32` | `Fx32` | `Fx16` |
//! |---|---|---|---|
//! | fraction: the argument of a falloff | f32 | U1F31 | U1F15 |
//! | gain: a factor with an exponent of its own | f32 | 28-bit mantissa and shift | 16-bit mantissa and shift |
//! | rounding of `times` | to nearest, ties to even | to nearest, ties up | to nearest, ties up |
//!
//! Laws for every bit pattern, in every format: no operation panics; NaN gives zero light, in a point, a normal, a
//! versine or a gain; `ONE.times(x) == x` for x from 0 to 1.

use super::{Fraction, ProjectedPoint, Scalar};
#[cfg(feature = "fixed")]
use super::{Fx16, Fx32};
use crate::vec3::Vec3;

/// The arithmetic of a number format, in the coarse steps that the kernel is written in.
pub trait Arithmetic: Copy + Default + PartialOrd + core::fmt::Debug + Share<Self> {
    /// [`Scalar::Length`].
    type Position: Copy + Default + PartialOrd + core::fmt::Debug;
    /// [`Scalar::Unit`].
    type Direction: Copy + Default + PartialEq + core::fmt::Debug;
    /// [`Scalar::Irradiance`].
    type Received: Copy + Default + PartialOrd + core::fmt::Debug;
    /// The versine of an angle off axis, in the scale of a ramp: a narrow cone keeps its leading bits.
    type Versine: Copy + PartialOrd + core::fmt::Debug;
    /// The argument of an edge profile: from 0 at the edge of a cone to 1 in its middle.
    type Fraction: Fraction<Self, Value = Self>;
    /// The same argument with more bits, where a steep cone or a bright light needs them. A format whose fraction has enough
    /// of them has no other.
    type Fine: Fraction<Self>;
    /// A coefficient of an edge profile, from -4 to 4.
    type Weight: Copy + PartialEq + core::fmt::Debug;
    /// The ramp from the edge of a cone to its middle, compiled.
    type Ramp: Copy + PartialEq + core::fmt::Debug;
    /// The frame of a projection about the axis of a light, compiled.
    type Frame: Copy + PartialEq + core::fmt::Debug;
    /// A factor from zero upwards that keeps its leading bits whatever its size.
    type Gain: Gain<Self>;
    /// The way from a light to a point before its length is known.
    type Offset: Offset<Self>;
    /// How far off the direction to a point can be, in radians: what a narrow cone magnifies. In `f32` half of it is the
    /// rounding of the difference of point and light, which have none where both are on a common grid.
    const DIRECTION_ERROR: f32;
    /// So many 16,384ths, from 0 to 16,384: exact in every format.
    fn part(steps: u32) -> Self;
    /// The unit vector along an axis whose length is 1 within the roundings of f32.
    fn axis(axis: Vec3<f32>) -> Vec3<Self::Direction>;
    /// The unit vector along a vector whose largest component is from 1/2 to 1; `unit` is the same in f32.
    fn aim(_: Vec3<f32>, unit: Vec3<f32>) -> Vec3<Self::Direction> {
        Self::axis(unit)
    }
    /// The nearest versine in the scale of a ramp; saturates beyond its outer versine.
    fn versine(ramp: Self::Ramp, value: f32) -> Self::Versine;
    /// The nearest weight; saturates at -4 and 4, and what is not a number becomes zero.
    fn weight(value: f32) -> Self::Weight;
    /// The nearest gain; negative or not a number becomes zero.
    fn gain(value: f32) -> Self::Gain;

    /// The product of two numbers from 0 to 1. Beyond them it is in that range all the same, in fixed point, and has no
    /// meaning.
    fn times(self, other: Self) -> Self;
    /// The difference.
    fn minus(self, other: Self) -> Self;

    /// The way from a light to a point.
    fn offset(light: Vec3<Self::Position>, point: Vec3<Self::Position>) -> Self::Offset;
    /// Compiles a ramp between two versines, from 0 at `outer` to 1 from `inner` inwards, that is cut off to 0 from
    /// `limit` outwards. A limit at `outer` cuts nothing off; an inner versine at `outer` makes a step.
    fn ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp;
    /// Upper bound of what rounding adds to the error of an intensity that the direction makes, whatever the angle of
    /// the cone: the length of the direction, the versines of the set-up, the argument of the profile and the profile
    /// itself. Infinite where the format does not hold the profile at any angle.
    fn rounding(edge: &Slopes) -> f32;
    /// Upper bound of what all of the coarse evaluation, direction included, adds to the error of the intensity of a cone
    /// between versines of 0 and `outer`, evaluated up to `limit`: from half a step of eight bits on the cone wants a
    /// [`fine_ramp`](Self::fine_ramp). Zero in a format that has no finer evaluation.
    fn coarse_error(_edge: &Slopes, _outer: f32, _limit: f32) -> f32 {
        0.0
    }
    /// As [`ramp`](Self::ramp), evaluated with [`Fine`](Self::Fine) fractions.
    fn fine_ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp {
        Self::ramp(inner, outer, limit)
    }
    /// Where a versine stands on a ramp: exactly 0 at and beyond the limit, else exactly 1 at and within the inner
    /// versine, monotone between.
    fn rise(ramp: Self::Ramp, versine: Self::Versine) -> Rise<Self>;
    /// How short the way from a light to a point has to be for a fine evaluation, as [`Offset::is_near`] takes it: where the
    /// gain, which magnifies what a share of it is off, may take that to half a step of eight bits. `error` is the
    /// [`coarse_error`](Self::coarse_error) of the light's cone, 0 for a light without one; `intensity` is the gain at
    /// distance 1, and everywhere if the irradiance does not grow towards the light.
    fn fine_below(_error: f32, _intensity: f32, _grows: bool) -> u32 {
        0
    }
    /// Whether this light of a share of a gain is past full scale whatever the share is off by, so that a fine
    /// evaluation would show nothing else.
    #[inline]
    fn is_clipped(_share: Self, _light: Self::Received) -> bool {
        false
    }
    /// `t^2 (3 - 2t)` of a fraction clamped to [0, 1]: exact at both ends.
    fn smooth(self) -> Self;

    /// Compiles the frame of a square: the unit vectors to its right and down and along the axis, at right angles to one
    /// another within the roundings of f32, and the tangent of half its side.
    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> Self::Frame;
    /// The place of a point on the square of a light.
    fn place(
        frame: &Self::Frame,
        light: Vec3<Self::Position>,
        point: Vec3<Self::Position>,
    ) -> ProjectedPoint<Self>
    where
        Self: Scalar;

    /// The value of a sum of bytes whose weights are 2^24 in all, 255 being one: exactly zero for none, exactly one for all
    /// and for what is more, else within a step.
    fn weighted_byte(sum: u32) -> Self;

    /// The versine of the angle between two unit directions, in the scale of a ramp, by their difference.
    fn versine_between(a: Vec3<Self::Direction>, b: Vec3<Self::Direction>, ramp: Self::Ramp)
    -> Self::Versine;
    /// `(1 - versine)^exponent` by repeated squaring, and zero from a right angle on: a power of the cosine that keeps
    /// what the cosine lacks of one. The versine is in the scale of the ramp from 0 to 1.
    fn power(versine: Self::Versine, exponent: u32) -> Self;
    /// A normal in the resolution of directions.
    fn normal_unit(normal: Vec3<Self>) -> Vec3<Self::Direction>;
    /// The mirror image of a direction in the surface of a normal: `d - 2 (d.n) n`.
    fn mirror(direction: Vec3<Self::Direction>, normal: Vec3<Self>) -> Vec3<Self::Direction>;
    /// The unit direction from one unit direction to another: `b - a` at unit length. Equal ones have none; what
    /// stands in its place is like nothing that it is compared with.
    fn direction_between(a: Vec3<Self::Direction>, b: Vec3<Self::Direction>) -> Vec3<Self::Direction>;
    /// The cosine of the angle of incidence of a unit direction, and zero where the surface faces away.
    fn incidence(direction: Vec3<Self::Direction>, normal: Vec3<Self>) -> Self;

    /// The light of a fraction of a gain, whatever the distance; none for a negative fraction.
    fn expose(self, gain: Self::Gain) -> Self::Received;
    /// A channel of light after a colour.
    fn filter(light: Self::Received, color: Self) -> Self::Received;
    /// The sum of two lights.
    fn add_light(a: Self::Received, b: Self::Received) -> Self::Received;
    /// A light as a gain.
    fn light_to_gain(light: Self::Received) -> Self::Gain;
    /// A light after a gain; a gain of one changes no bit.
    fn amplify(light: Self::Received, gain: Self::Gain) -> Self::Received;
    /// A light clipped to full scale.
    fn clip(light: Self::Received) -> Self;
    /// The value as the word that stores it.
    fn word(self) -> Word;
}

/// A scalar as the word that its format stores: what tables of a display are compared with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Word {
    /// A number of `f32`.
    Single(f32),
    /// Steps of 2^-14.
    #[cfg(feature = "fixed")]
    Steps14(i16),
    /// Steps of 2^-30.
    #[cfg(feature = "fixed")]
    Steps30(i32),
}

/// Half a step of eight bits: what an intensity may be off.
pub(crate) const HALF_A_CODE: f32 = 1.0 / 510.0;

/// How steep the intensity of a cone is, at most: what its errors are magnified by.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Slopes {
    /// Over the angle off axis, in units of the outer half angle. An error of the versine by a factor `1 + e` is an error of
    /// the intensity of no more than half of this times `e`.
    pub angle: f32,
    /// Over the argument of the profile.
    pub fraction: f32,
}

impl Slopes {
    /// Of a jump: its place is to be right within 1/510 of its half angle.
    pub const STEP: Self = Self { angle: 1.0, fraction: 0.0 };
}

/// The argument of an edge profile, with as many bits as the cone needs.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub enum Rise<S: Arithmetic> {
    /// One bit more than a scalar.
    Coarse(S::Fraction),
    /// All that the format can give.
    Fine(S::Fine),
}

impl<S: Arithmetic> Rise<S> {
    /// The nearest scalar.
    #[inline]
    pub(crate) fn scalar(self) -> S {
        match self {
            Self::Coarse(t) => t.scalar(),
            Self::Fine(t) => t.scalar().rounded(),
        }
    }
}

/// A share of a light, from 0 to 1: a scalar, or a number of more bits.
pub trait Share<S: Arithmetic>: Copy + Default + PartialOrd + core::fmt::Debug {
    /// The share with the value of a scalar from 0 to 1.
    fn of_scalar(scalar: S) -> Self;
    /// The nearest scalar.
    fn rounded(self) -> S;
    /// Whether it is all of the light.
    fn is_all(self) -> bool;
    /// One less the share.
    fn rest(self) -> Self;
    /// The product.
    fn share_of(self, other: Self) -> Self;
    /// `t^2 (3 - 2t)`.
    fn smoothed(self) -> Self;
    /// The light of a share of a gain, whatever the distance.
    fn give(self, gain: S::Gain) -> S::Received;
}

/// The share that a scalar is, by its own operations.
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

/// A factor from zero upwards with an exponent of its own, and the arithmetic of distances on it.
///
/// Fixed point rounds every result to the nearest mantissa, of 16 bits in [`Fx16`] and 28 in [`Fx32`], so that what
/// is monotone in exact arithmetic is monotone here.
pub trait Gain<S: Arithmetic>: Copy + PartialEq + core::fmt::Debug {
    /// The product.
    fn by(self, other: Self) -> Self;
    /// The sum.
    fn plus(self, other: Self) -> Self;
    /// One over the gain, and one where the gain is less than one.
    fn inverse_capped(self) -> Self;
    /// The nearest scalar, and exactly one from there on.
    fn fraction(self) -> S;
}

/// The way from a light to a point: what can be asked of it before a square root is paid for, and the root.
pub trait Offset<S: Arithmetic>: Copy + core::fmt::Debug {
    /// What is known once the root is paid for.
    type Ray: Ray<S, Fraction = S::Fraction, Share = S>;
    /// The same with more bits; in a format that has no finer ones, the same.
    type FineRay: Ray<S, Fraction = S::Fine>;
    /// The inner product of a surface normal with the way back to the light, in a scale of its own.
    type Facing: Copy + core::fmt::Debug;

    /// Whether a loop over many points takes all roots first, by [`reciprocal`](Self::reciprocal), and skips none.
    const ROOTS_FIRST: bool = false;

    /// How far the surface faces the light.
    fn facing(&self, normal: Vec3<S>) -> Self::Facing;
    /// Whether the surface faces away, so that nothing can arrive. Not a number faces away.
    fn faces_away(facing: Self::Facing) -> bool;
    /// Whether it faces away so far that a fine evaluation finds nothing either.
    #[inline]
    fn faces_far_away(facing: Self::Facing) -> bool {
        Self::faces_away(facing)
    }
    /// Whether the point is outside a cone for certain: by squares, and only ever in error towards evaluating.
    /// `bound` is the squared cosine of the outer half angle, less a margin for the roundings.
    fn is_outside(&self, axis: Vec3<S::Direction>, bound: S) -> bool;
    /// The squared distance.
    fn squared_distance(&self) -> S::Gain;
    /// Pays for the square root.
    fn ray(&self) -> Self::Ray;
    /// Pays for the square root and for all bits that it can have.
    fn fine_ray(&self) -> Self::FineRay;
    /// Whether the way is so short that all of the evaluation is to be fine: see `Arithmetic::fine_below`.
    #[inline]
    fn is_near(&self, _fine_below: u32) -> bool {
        false
    }
    /// The root alone, as a reciprocal length: zero where there is no direction, or where roots are not taken first.
    #[inline]
    fn reciprocal(&self) -> f32 {
        0.0
    }
    /// As [`ray`](Self::ray), with the root that [`reciprocal`](Self::reciprocal) gave.
    #[inline]
    fn ray_of(&self, _reciprocal: f32) -> Self::Ray {
        self.ray()
    }
}

/// A direction of unit length from a light to a point, and the length it had.
///
/// A point on the light itself, or one so far that its squared distance cannot be held, has no direction: it stays
/// dark, because its [`cosine`](Ray::cosine) is zero or its versine outside every cone.
pub trait Ray<S: Arithmetic>: Copy + core::fmt::Debug {
    /// Where a direction stands on a ramp, and the cosine of an angle of incidence.
    type Fraction: Fraction<S, Value = Self::Share>;
    /// What profiles and distance models make of them.
    type Share: Share<S>;

    /// The distance.
    fn distance(&self) -> S::Gain;
    /// The direction.
    fn direction(&self) -> Vec3<S::Direction>;
    /// The versine of the angle between direction and axis, in the scale of a ramp, by the difference of the two:
    /// `|l - s|^2 / 2` keeps the narrow beams that `1 - l.s` loses.
    fn versine(&self, axis: Vec3<S::Direction>, ramp: S::Ramp) -> S::Versine;
    /// Where the direction stands on a ramp about an axis.
    fn rise(&self, axis: Vec3<S::Direction>, ramp: S::Ramp) -> Self::Fraction;
    /// The cosine of the angle of incidence on a surface of this normal, and zero where it faces away; `facing` is
    /// that of the offset.
    fn cosine(&self, facing: <S::Offset as Offset<S>>::Facing, normal: Vec3<S>) -> Self::Fraction;
    /// The distance times a gain, and exactly one from there on.
    #[inline(always)] // `spot-soft-lambert-smooth-range` on Cortex-M0: +87 without.
    fn near(&self, gain: S::Gain) -> Self::Share {
        Self::Share::of_scalar(self.distance().by(gain).fraction())
    }
    /// The squared distance, which is that of the offset, times a gain, and exactly one from there on.
    #[inline(always)] // `spot-soft-lambert-smooth-range` on Cortex-M0: +74 without.
    fn squared_near(&self, offset: &S::Offset, gain: S::Gain) -> Self::Share {
        Self::Share::of_scalar(offset.squared_distance().by(gain).fraction())
    }
    /// The light of a share of a gain at this distance, by the inverse-square law; none for a negative share.
    fn expose(&self, share: Self::Share, gain: S::Gain) -> S::Received;
}
