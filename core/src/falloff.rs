//! Angular falloffs: the intensity from the axis of a cone to its edge.
//!
//! Each is a function of `t`, which is 1 on the axis (and within an inner angle) and 0 at the outer angle and beyond:
//! `t = (v_outer - v) / (v_outer - v_inner)`, with the versine `v = 1 - cos` of the angle off axis, of the outer and of
//! the inner half angle. That is the cosine, on a straight ramp from the outer to the inner angle; `u = 1 - t`.
//!
//! | falloff | f | multiplies | source |
//! |---|---|---|---|
//! | [`Soft`] | `t^2` | 1 | Hast 2004, section 2; glTF, Filament and Bevy square the same ramp |
//! | [`Hard`] | `1 - u^2` | 1 | Hast 2004, section 3 |
//! | [`Linear`] | `t` | 0 | umbra and penumbra; Direct3D 9 with a falloff of 1 |
//! | [`Step`] | 1 for `t > 0` | 0 | a single umbra; OpenGL with exponent 0 |
//! | [`Smooth`] | `t^2 (3 - 2t)` | 2 | smoothstep: dual-cone shaders in GLSL, three.js, Blender |
//! | [`Quadratic`] | `t (a + (1 - a) t)` | 2 | the quadratics between soft (a = 0) and hard (a = 2) |
//! | [`Cubic`] | `t (a + t (b + t c))` | 3 | every monotone cubic; Fritsch and Carlson 1980 |
//! | [`Power`] | `t^N` | log2 N for powers of two | OpenGL's cosine power by [`Cone::opengl`](crate::Cone::opengl) |
//! | [`InvertedPower`] | `1 - u^N` | as [`Power`] | Godot, by an angle attenuation of `1/N` |
//! | [`IntegerPower`], [`InvertedIntegerPower`] | the same, `N` at run time | as [`Power`] | [imports](crate::import) |
//! | [`MixedPower`], [`InvertedMixedPower`] | a mixture of two of these | 2 more | curves between the powers |
//! | [`RealPower`], [`InvertedRealPower`] | `t^p`, `1 - u^p`, `p` over 0 and up to 1,024, any real number | 11, and two tables | imports |
//! | [`Table`] | samples, evenly spaced or [`Knot`]s | 2, or 1 and a search | goniometric data |
//! | [`SoftOrHard`], [`FittedFalloff`], [`AnyFalloff`] | one of the above | as it, and a branch | the choice at run time |

mod any;
mod choice;
mod cubic;
mod curve;
pub(crate) mod exponent;
pub(crate) mod fit;
mod formula;
mod integer;
mod mixed;
mod polynomial;
mod power;
mod quadratic;
mod real;
mod step;
mod table;

use crate::number::Scalar;

pub(crate) use self::any::with_profile;
#[cfg(feature = "arithmetic")]
pub use self::curve::Curve;
#[cfg(not(feature = "arithmetic"))]
pub(crate) use self::curve::Curve;
pub use self::{
    any::{AnyFalloff, CompiledAnyFalloff},
    choice::{CompiledFittedFalloff, FittedFalloff, SoftOrHard},
    cubic::{CompiledCubic, Cubic, Smooth},
    formula::Formula,
    integer::{IntegerPower, InvertedIntegerPower},
    mixed::{CompiledInvertedMixedPower, CompiledMixedPower, InvertedMixedPower, MixedPower},
    power::{InvertedPower, Power},
    quadratic::{CompiledQuadratic, Hard, Linear, Quadratic, Soft},
    real::{CompiledInvertedRealPower, CompiledRealPower, InvertedRealPower, RealPower},
    step::Step,
    table::Table,
};
pub use crate::number::Knot;

/// An edge profile: a function of `t`, and the figures that design a cone with it.
///
/// The type decides which function is compiled in: there is no branch per point, and a profile that is not
/// named is not linked. [`SoftOrHard`], [`FittedFalloff`] and [`AnyFalloff`] leave the choice to run time, at the price
/// of that branch.
///
/// A curve that is none of them is a [`Table`].
pub trait Falloff: Copy + core::fmt::Debug {
    /// The falloff with its coefficients in the format `S`: `Self` where it has none.
    type Compiled<S: Scalar>: Curve<S> + From<Self>;

    /// Takes the coefficients to the format `S`, once per light.
    fn compile<S: Scalar>(self) -> Self::Compiled<S> {
        self.into()
    }

    /// The formula, as data.
    fn formula(&self) -> Formula<'_>;

    /// Where half the intensity is left: `u` from 0 to 1.
    fn beam_versine(self) -> f32;

    /// Where a tenth of the intensity is left: `u` from 0 to 1.
    fn field_versine(self) -> f32;

    /// The largest slope of the intensity over the angle off axis, in units of the outer half angle, in a narrow
    /// cone whose inner versine is `hotspot` of its outer one: how much an error of the direction is magnified.
    /// `hotspot` is in [0, 1).
    ///
    /// A step has no slope. It counts as 1: its place is right within 1/510 of the outer half angle.
    fn steepness(self, hotspot: f32) -> f32;

    /// The integral of the intensity over `u` from 0 to `u`, which is in [0, 1]: what flux is made of.
    fn integral(self, u: f32) -> f32;
}
