//! Angular falloffs: the intensity from the axis of a cone to its edge.
//!
//! Each falloff is a function `f(t)`. `t` is 1 on the axis and within an inner angle, and 0 at and
//! beyond the outer angle: `t = (v_outer - v) / (v_outer - v_inner)`, with the versines
//! `v = 1 - cos` of the angle off axis, of the outer half angle and of the inner half angle. So `t`
//! is linear in the cosine between the outer and the inner angle. In the table, `u = 1 - t`.
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
//! | [`IntegerPower`], [`InvertedIntegerPower`] | the same, `N` at run time | as [`Power`] | lights of other systems |
//! | [`RealPower`], [`InvertedRealPower`] | `t^p`, `1 - u^p`, real `p` in (0, 1024] | 11, and two tables | imports |
//! | [`SoftPair`] | `(1 - k) t^2 + k max(0, 1 - g u)^2` | 5 | two of [`Soft`], for a beam and a field angle |
//! | [`SoftEdged`] | [`Cubic`] or [`SoftPair`] | the same, and a branch | the same, for any two angles |
//! | [`Table`] | samples, evenly spaced or [`Knot`]s | 2, or 1 and a binary search | goniometric data |
//! | [`SoftOrHard`], [`FittedFalloff`], [`AnyFalloff`] | one of the above | the same, and a branch | the choice at run time |

mod any;
mod choice;
mod compiled;
mod cubic;
pub(crate) mod fit;
mod formula;
mod integer;
mod polynomial;
mod power;
mod quadratic;
mod real;
mod soft_pair;
mod step;
mod table;

pub(crate) use self::{
    compiled::Square,
    real::{STRIP, slope_beside_axis},
};
use crate::{number::Scalar, source::Source};

pub use self::{
    any::{AnyFalloff, CompiledAnyFalloff},
    choice::{CompiledFittedFalloff, FittedFalloff, SoftOrHard},
    cubic::{CompiledCubic, Cubic, Smooth},
    formula::Formula,
    integer::{IntegerPower, InvertedIntegerPower},
    power::{InvertedPower, Power},
    quadratic::{CompiledQuadratic, Hard, Linear, Quadratic, Soft},
    real::{CompiledInvertedRealPower, CompiledRealPower, InvertedRealPower, RealPower},
    soft_pair::{CompiledSoftEdged, CompiledSoftPair, SoftEdged, SoftPair},
    step::Step,
    table::Table,
};
#[cfg(feature = "arithmetic")]
pub use self::{
    any::{
        FalloffRow, FalloffVisitor, ListedFalloff, WithFalloff, constant_falloffs, falloffs, with_falloff,
    },
    compiled::CompiledFalloff,
};
#[cfg(not(feature = "arithmetic"))]
pub(crate) use self::{
    any::{WithFalloff, with_falloff},
    compiled::CompiledFalloff,
};
pub use crate::number::Knot;

/// An angular falloff: a function of `t`, and the properties from which a cone is designed.
///
/// The type selects the function at compile time: there is no branch per point, and an unused
/// falloff is not linked. [`SoftOrHard`], [`FittedFalloff`] and [`AnyFalloff`] choose at run time
/// and take a branch per point.
///
/// For any other curve use a [`Table`].
pub trait Falloff: Copy + core::fmt::Debug + Source {
    /// The falloff with its coefficients in the format `S`; `Self` if it has no coefficients.
    type Compiled<S: Scalar>: CompiledFalloff<S> + From<Self> + Source;

    /// Converts the coefficients to the format `S`, once per light.
    fn compile<S: Scalar>(self) -> Self::Compiled<S> {
        self.into()
    }

    /// Returns the formula as data.
    fn formula(&self) -> Formula<'_>;

    /// Returns the `u` at the beam angle, where the intensity is 1/2; in [0, 1].
    fn beam_versine(self) -> f32;

    /// Returns the `u` at the field angle, where the intensity is 1/10; in [0, 1].
    fn field_versine(self) -> f32;

    /// Returns the steepness: the largest derivative of the intensity with respect to the angle off
    /// axis.
    ///
    /// The angle is in units of the outer half angle. The falloff magnifies an error of the
    /// direction by the steepness. The steepness is that of a narrow cone whose inner versine is
    /// `hotspot` times the outer versine, with `hotspot` in [0, 1).
    ///
    /// A step has no finite derivative and returns 1. With this value, the error bound of an
    /// intensity (1/510) keeps the position of the edge within 1/510 of the outer half angle.
    fn steepness(self, hotspot: f32) -> f32;

    /// Returns the integral of the intensity from 0 to `u`, with `u` in [0, 1]. The luminous flux
    /// follows from this integral.
    fn integral(self, u: f32) -> f32;
}
