//! The private interface between the kernel and the number formats, beside the
//! [stages of a point](super::arithmetic): set-up and its error bounds, projections, colours, and the directions of
//! specular lobes.

use super::{Placing, Rise, Stages, Types};
use crate::vec3::Vec3;

/// What the kernel asks of a number format beside the stages of a point: here of its numbers, and in the supertraits
/// of all else.
pub trait Arithmetic: Directions + Places + Ramps + Errors + Lights {
    /// Whether a loop over many points rejects those without light before the root. `f32` does not: without
    /// branches, compilers vectorise the loop.
    const SKIPS: bool = true;

    /// Returns `steps / 16384` for `steps` in `[-16384, 16384]`: exact in every format.
    fn from_steps(steps: i32) -> Self;
    /// Returns the nearest coefficient of a falloff; saturates at -4 and 4, and NaN becomes zero.
    fn weight(value: f32) -> Self::Weight;
    /// Returns the nearest gain; a negative value or NaN becomes zero.
    fn gain(value: f32) -> Self::Gain;
    /// Returns `self - other`; fixed point saturates.
    fn minus(self, other: Self) -> Self;
    /// Converts a weighted sum of bytes to a value, where the weights sum to 2^24 and byte 255
    /// means 1.
    ///
    /// The result is exactly 0 if all bytes are 0, and exactly 1 if all bytes are 255 or the sum is
    /// larger. Any other result is within one step of the exact value.
    fn weighted_byte(sum: u32) -> Self;
    /// Returns a linear value in `[0, 1]` of which the format takes the kind that it can: a float, or an integer in
    /// units of 2^-24, of which it returns the nearest value.
    fn of_linear(float: impl FnOnce() -> f32, steps24: impl FnOnce() -> u32) -> Self;
    /// Returns the value as the word that the format stores.
    fn word(self) -> Word;
}

/// Axes, normals, and the directions of a specular lobe.
pub trait Directions: Types {
    /// Converts an axis to a unit vector of the format. The given axis has length 1 within the
    /// rounding error of `f32`.
    fn axis(axis: Vec3<f32>) -> Vec3<Self::Direction>;
    /// Returns the unit vector along a vector whose largest component is in `[1/2, 1]`.
    ///
    /// `unit` is the same vector, normalised in `f32`.
    fn aim(_: Vec3<f32>, unit: Vec3<f32>) -> Vec3<Self::Direction> {
        Self::axis(unit)
    }
    /// Returns an offset along a vector of any length, for its direction.
    fn offset_along(direction: Vec3<Self::Direction>) -> Self::Offset;
    /// Returns whether the offset has a direction: whether it is not zero, and in `f32` whether its
    /// squared length is a normal number.
    fn has_direction(offset: &Self::Offset) -> bool;
    /// Computes the direction and the distance with the format's full precision.
    fn fine_ray(offset: &Self::Offset) -> Self::FineRay;
    /// Returns the unit vector along `b - a`, for two unit directions.
    ///
    /// For equal directions the result is (nearly) zero, and so not close to any unit direction.
    fn direction_between(a: Vec3<Self::Direction>, b: Vec3<Self::Direction>) -> Vec3<Self::Direction>;
    /// Returns a vector along the cross product of two unit directions.
    fn cross(a: Vec3<Self::Direction>, b: Vec3<Self::Direction>) -> Vec3<Self::Direction>;
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
    /// Returns the cosine of the angle of incidence of light in a unit direction. The result is
    /// zero if the surface faces away.
    fn incidence(direction: Vec3<Self::Direction>, normal: Vec3<Self>) -> Self;
}

/// Spheres that a light may reach, and the square that it projects.
pub trait Places: Types {
    /// Returns the centre and the radius of a sphere around the line between two points, and around
    /// points within a step of it.
    fn enclosing(a: Vec3<Self::Position>, b: Vec3<Self::Position>) -> (Vec3<Self::Position>, Self::Position);
    /// Returns the tip of a cone, moved back along the axis by at least `radius / sin(angle)` with
    /// the half angle. A sphere of this radius is outside the cone if its centre is outside the cone
    /// with the moved tip.
    ///
    /// `bound` is that of [`Offset::is_outside`](super::Offset::is_outside), from which the test removes the margin. The
    /// result is `None` for a half angle of 90 degrees or more, for one that the margin hides, and
    /// in fixed point if the tip moves by 8 km or more, or beyond the range of a length.
    fn moved_back(
        tip: Vec3<Self::Position>,
        axis: Vec3<Self::Direction>,
        bound: Self,
        radius: Self::Position,
    ) -> Option<Vec3<Self::Position>>;
    /// Returns a vector in proportion to three integers, of which the largest is about 2^30.
    fn along_integers(way: [i32; 3]) -> Vec3<Self::Position>;
    /// Returns a length times a whole number; wraps in fixed point.
    fn length_times(length: Self::Position, count: i32) -> Self::Position;
    /// Compiles the frame of a projected square from three unit vectors and the size of the square.
    ///
    /// The vectors point right, down and along the axis, and are orthogonal within the rounding
    /// error of `f32`. `tangent` is half the side of the square at distance 1 along the axis.
    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> Self::Frame;
    /// Returns the column and the row of a point on the square that a light projects, and the depth.
    ///
    /// Column and row are in units of `1 / STEPS` of a side, rounded down, in `[-STEPS, 2 STEPS)`.
    fn project(
        frame: &Self::Frame,
        light: Vec3<Self::Position>,
        point: Vec3<Self::Position>,
    ) -> ([i32; 2], Self::Position);
}

/// The ramp of a cone.
pub trait Ramps: Types {
    /// Compiles a ramp between two versines: `t` is 0 at `outer`, and 1 up to `inner`.
    ///
    /// From the versine `limit` outwards `t` is 0. With `limit == outer` the ramp has no cutoff.
    /// With `inner == outer` the ramp is a step.
    fn ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp;
    /// Compiles the ramp of [`ramp`](Self::ramp), but for evaluation with [`Fine`](Types::Fine)
    /// fractions only.
    fn fine_ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp {
        Self::ramp(inner, outer, limit)
    }
    /// Returns the ramp of the cone between the cones of two ramps, and the bound of this cone for
    /// [`Offset::is_outside`](super::Offset::is_outside).
    ///
    /// The roots of the three versines of a cone are interpolated. `part` is between 0 and 1; for
    /// any other part the ramp is an unspecified one. If one of the ramps is a
    /// [`fine_ramp`](Self::fine_ramp), then so is the result.
    fn zoomed(from: Self::Ramp, to: Self::Ramp, part: Self) -> (Self::Ramp, Self);
    /// Returns the nearest versine in the scale of a ramp. Only a value beyond the end of the ramp
    /// saturates.
    fn versine(ramp: Self::Ramp, value: f32) -> Self::Versine;
    /// Returns the falloff's argument `t` at a versine, in `[0, 1]`.
    ///
    /// `t` is exactly 0 from the ramp's limit on, and otherwise exactly 1 up to the inner versine.
    /// Between the two versines `t` is monotone.
    fn rise(ramp: Self::Ramp, versine: Self::Versine) -> Rise<Self>;
}

/// The errors of the evaluations, and where a light needs the fine one.
pub trait Errors: Types {
    /// Upper bound of the error of the direction from a light to a point, in radians.
    ///
    /// A narrow cone magnifies this error. In `f32` about half of this bound is the rounding error
    /// of `point - light`. The difference `point - light` is exact if both positions are multiples
    /// of the same power of two.
    const DIRECTION_ERROR: f32;
    /// Upper bound of the relative error of a chord `sqrt(versine)` of a [cone between](Ramps::zoomed) two
    /// cones, beside those that the versines of the two have.
    const CHORD_ERROR: f32;
    /// Upper bound of the absolute error of such a chord, beside [`CHORD_ERROR`](Self::CHORD_ERROR).
    const CHORD_STEP: f32;
    /// Whether a ramp has lost the falloff of a cone whose cutoff is within its hotspot, and so zooms as a step.
    const LOSES_HIDDEN: bool;
    /// The shortest distance that is not zero.
    const NEAREST: f64;
    /// Step of the squared cosines that [`Offset::is_outside`](super::Offset::is_outside) compares.
    const OUTSIDE_STEP: f32;
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
    /// The cone spans versines from 0 to `outer` and is evaluated up to the versine `limit`. The bound is that of all cones
    /// with at least this `outer` and at most this `limit`. If the
    /// bound exceeds half a linear code, the cone needs a [`fine_ramp`](Ramps::fine_ramp). The bound
    /// is zero in a format that has only one evaluation.
    fn coarse_error(_edge: &Slopes, _outer: f32, _limit: f32) -> f32 {
        0.0
    }
    /// Returns an upper bound of the rounding errors of the versines that a zoom computes from chords, relative to
    /// the outer versine: what they sum up to in the argument `t`, times the width of the edge as a part of the
    /// outer versine. The bound is zero in a format that does not round them in a unit of its own.
    fn edge_error(_outer: f32) -> f32 {
        0.0
    }
    /// Returns an upper bound of the rounding error of the inner chord in a ramp, for a cone with these inner and
    /// last versines. The bound is zero in a format that stores the versine as it is.
    fn inner_chord_error(_inner: f32, _limit: f32) -> f32 {
        0.0
    }
    /// Returns an upper bound of the intensity error of the coarse evaluation of a distribution of this steepness: the
    /// largest sum of the magnitudes of the two derivatives of a cell.
    ///
    /// The bound is zero in a format that has only one evaluation.
    fn distribution_error(_steepness: f32) -> f32 {
        0.0
    }
    /// Returns the distance from a light within which points need the fine evaluation.
    ///
    /// The result is encoded for [`Offset::is_near`](super::Offset::is_near). The light at a point is a share (falloff
    /// times cosine) times a gain. The gain magnifies the error of the share. Below the returned
    /// distance, the light may be wrong by half a linear code. `error` is the
    /// [`coarse_error`](Self::coarse_error) of the light's cone, 0 for a light without a cone.
    /// `intensity` is the gain at distance 1, and `intensity` times `d^-growth` the gain at a distance
    /// `d`.
    fn fine_below(_error: f32, _intensity: f32, _growth: f32) -> u32 {
        0
    }
    /// Returns the distance that [`fine_below`](Self::fine_below) encodes; infinity if all points have
    /// the fine evaluation.
    fn fine_within(_error: f32, _intensity: f32, _growth: f32) -> f64 {
        0.0
    }
    /// Returns whether `light` exceeds full scale for every possible error of `share`.
    ///
    /// `light` is the product of `share`, window included, and a gain. If `light` exceeds full scale, the fine
    /// evaluation would give the same clipped result.
    #[inline]
    fn is_clipped(_share: Self, _light: Self::Received) -> bool {
        false
    }
    /// Returns the errors of the stages of the evaluation at a distance, the coarse one if the format
    /// has two.
    fn stages(distance: f64) -> Stages;
    /// Returns the errors of the stages of the fine evaluation, up to a distance.
    fn fine_stages(far: f64) -> Stages {
        Self::stages(far)
    }
    /// Returns the errors of the stages of a distribution in the coarse evaluation, or in the fine one.
    fn placing(is_fine: bool) -> Placing;
    /// Returns the next distance from which on the errors of the stages may be larger.
    fn larger_errors_from(_distance: f64) -> f64 {
        f64::INFINITY
    }
    /// Returns the factor by which a ramp magnifies differences of directions, for a cone that ends at
    /// this versine.
    fn magnification(limit: f32) -> f64;
}

/// Light that has arrived.
pub trait Lights: Types {
    /// Multiplies a channel of light by the same channel of a colour.
    fn filter(light: Self::Received, color: Self) -> Self::Received;
    /// Multiplies many lights by the same channel of a colour, each as [`filter`](Self::filter) does.
    #[inline(always)]
    fn filter_each<const N: usize>(lights: &[Self::Received; N], color: Self) -> [Self::Received; N] {
        let mut filtered = *lights;
        filtered.iter_mut().for_each(|light| *light = Self::filter(*light, color));
        filtered
    }
    /// Returns the nearest light, ties to even; saturates, and a negative value or NaN becomes zero.
    fn light_from_f32(value: f32) -> Self::Received;
    /// Converts many values, each as [`light_from_f32`](Self::light_from_f32) does.
    #[inline(always)]
    fn lights_from_f32<const N: usize>(values: &[f32; N]) -> [Self::Received; N] {
        let mut lights = [Self::Received::default(); N];
        lights.iter_mut().zip(values).for_each(|(light, &value)| *light = Self::light_from_f32(value));
        lights
    }
    /// Returns the mean of two lights, in fixed point rounded down.
    fn mean_light(a: Self::Received, b: Self::Received) -> Self::Received;
    /// Converts a light to a gain.
    fn light_to_gain(light: Self::Received) -> Self::Gain;
    /// Multiplies a light by a gain; a gain of one changes no bit.
    fn amplify(light: Self::Received, gain: Self::Gain) -> Self::Received;
    /// Clips a light to full scale.
    fn clip(light: Self::Received) -> Self;
    /// Returns a light in steps of 2^-14 of full scale, truncated; saturates.
    fn light_steps(light: Self::Received) -> u32;
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

impl Word {
    /// Returns the value as f32: exact but for integers in units of 2^-30, which are rounded.
    #[inline(always)]
    pub(crate) fn single(self) -> f32 {
        match self {
            Self::Single(value) => value,
            #[cfg(feature = "fixed")]
            Self::Steps14(steps) => f32::from(steps) / (1 << 14) as f32,
            #[cfg(feature = "fixed")]
            Self::Steps30(steps) => steps as f32 / (1 << 30) as f32,
        }
    }

    /// Returns the value, clamped to `[0, 1]` and rounded down, in units of 2^-24.
    #[cfg(feature = "fixed")]
    #[inline(always)]
    pub(crate) fn steps24(self) -> u32 {
        match self {
            Self::Single(value) => (super::float::clamp(value) * (1 << 24) as f32) as u32,
            Self::Steps14(steps) => u32::from(steps.clamp(0, 1 << 14) as u16) << 10,
            Self::Steps30(steps) => steps.clamp(0, 1 << 30) as u32 >> 6,
        }
    }
}

/// Number of coordinate steps per side of a projected square.
pub(crate) const STEPS: i32 = 1 << 16;

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
    /// Derivative with respect to `t` beside the axis, where it is infinite on it; else 0.
    ///
    /// There an error of a versine that does not shrink with the angle is magnified.
    pub beside_axis: f32,
}

impl Slopes {
    /// The values used for a step, whose true derivatives are infinite.
    ///
    /// With these values, the bound of half a linear code (1/510) for the intensity error limits
    /// the error of the step's position to 1/510 of the half angle.
    pub const STEP: Self = Self { angle: 1.0, fraction: 0.0, beside_axis: 0.0 };
}
