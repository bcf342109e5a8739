//! Attenuation: the intensity of a light as a function of distance.
//!
//! | attenuation | f(d) | source |
//! |---|---|---|
//! | [`NoAttenuation`] | 1 | a directional light with a position |
//! | [`InverseSquare`] | `1 / d^2` | physics; the default |
//! | [`Polynomial`] | `1 / (a0 + a1 d + a2 d^2)`, at most 1 | OpenGL and Direct3D 9, with the cap common in textbooks |
//! | [`Decay`] | `d^-k`, at most a cap, real `k` in (0, 16] | three.js and Godot, with their windows |
//! | [`SmoothRange`] | `t^2 (3 - 2t)` with `t = 1 - d/r` | the dual-cone spotlight, smoothstep from its range to 0 |
//! | [`GltfRange`] | `(1 - (d/r)^4) / d^2`, at least 0 | glTF's KHR_lights_punctual |
//! | [`FilamentRange`] | `(1 - (d/r)^4)^2 / d^2` within r | Filament, Bevy, three.js with decay 2 |
//! | [`CutAt`] of an attenuation | that attenuation within r, 0 from there on | Direct3D 9 |
//! | [`Windowed`] of an attenuation | that attenuation times `(1 - (d/r)^4)^2` within r | Godot, and three.js with any decay |
//! | [`AnyAttenuation`] | one of the above | the choice at run time |
//!
//! A light without a range has the range `None`, never 0. At and beyond the range of a light, its
//! irradiance is exactly zero; in fixed point, the irradiance becomes zero up to half a step of the
//! format before the range. Points out of range are rejected before the square root. Results are
//! bit-identical with and without this early-out.
//!
//! *Falloff* is the intensity as a function of the angle; *attenuation* is the intensity as a
//! function of the distance.

mod any;
mod decay;
mod plain;
mod polynomial;
mod ranged;
mod smooth_range;

pub(crate) use self::any::WithConstants;
pub use self::{
    any::{AnyAttenuation, CompiledAnyAttenuation},
    decay::Decay,
    plain::{InverseSquare, NoAttenuation},
    polynomial::Polynomial,
    ranged::{Cut, CutAt, FilamentRange, GltfRange, GltfWindow, Ranged, SquareWindow, Windowed},
    smooth_range::SmoothRange,
};
#[cfg(feature = "arithmetic")]
pub use self::{
    any::{AttenuationRow, AttenuationVisitor, attenuations},
    ranged::Window,
};

use crate::{
    effect::Effects,
    error::Error,
    model::Number,
    number::{Gain, Offset, Ray, Scalar, Share},
    source::{Named, Source},
};

/// Takes an attenuation as its own type.
#[cfg(feature = "arithmetic")]
pub trait WithAttenuation {
    /// The result.
    type Output;

    /// Takes the attenuation.
    fn attenuation<A: Attenuation>(self, attenuation: A) -> Self::Output;
}

/// An attenuation. The type selects the attenuation at compile time: there is no branch per point,
/// and an unused attenuation is not linked.
///
/// The trait is sealed by a private bound.
pub trait Attenuation: Copy + PartialEq + core::fmt::Debug + Named {
    /// Whether the type is the inverse-square law itself.
    #[doc(hidden)]
    const IS_INVERSE_SQUARE: bool = false;
    /// The constants of the attenuation in a number format.
    type Constants<S: Scalar>: Copy + PartialEq + core::fmt::Debug + Source;

    /// Compiles the attenuation for the format `S`.
    fn constants<S: Scalar>(self) -> Self::Constants<S>;

    /// Returns whether the attenuation is exactly the inverse-square law, without a range or a
    /// window.
    #[inline]
    fn is_inverse_square<S: Scalar>(_: &Self::Constants<S>) -> bool {
        Self::IS_INVERSE_SQUARE
    }

    /// Returns whether the light is exactly zero at this distance. Callers test this before the
    /// square root. `false` for a light without an end.
    fn is_beyond<S: Scalar, O: Offset<S>>(constants: &Self::Constants<S>, offset: &O) -> bool;

    /// Returns the range of the light; `None` for a light without a range.
    fn range(&self) -> Option<f32> {
        None
    }

    /// Returns the effects that the attenuation requires.
    fn effects(&self) -> Effects;

    /// Evaluates the attenuation factor at a distance in f64, by the formula that defines the
    /// attenuation.
    ///
    /// The result is the reference for error measurements.
    fn exact(&self, distance: f64) -> f64;

    /// Returns the exponent `k` by which the light grows towards its position: at a distance `d` the
    /// attenuation factor is at most about `d^-k`; 0 for a factor of at most 1 everywhere.
    fn growth(&self) -> f32;

    /// Passes the attenuation as its own type, without the windows that have no range.
    #[cfg(feature = "arithmetic")]
    fn with<V: WithAttenuation>(self, visitor: V) -> V::Output {
        visitor.attenuation(self)
    }

    /// Returns a share of the intensity times the window that ends the light at a range.
    #[inline]
    fn windowed<S: Scalar, O: Offset<S>, R: Ray<S>>(
        _: &Self::Constants<S>,
        _: &O,
        _: &R,
        share: R::Share,
    ) -> R::Share {
        share
    }

    /// Returns the irradiance at this distance from a share of the intensity; 0 for a negative
    /// share.
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        constants: &Self::Constants<S>,
        offset: &O,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance;
}

/// Returns a range that is accepted.
fn checked_range(range: f32) -> Result<f32, Error> {
    Number::range().checked(range)
}

/// Returns `1 / r^2` of a range `r`; 0 without a range. A squared distance times this factor is
/// `(d/r)^2`.
fn inverse_squared<S: Scalar>(range: Option<f32>) -> S::Gain {
    S::gain(range.map_or(0.0, |range| 1.0 / (range * range)))
}

/// Returns `(d/r)^2`, and exactly 1 at and beyond the range.
#[inline]
fn squared_fraction<S: Scalar, O: Offset<S>>(inverse_squared: S::Gain, offset: &O) -> S {
    offset.squared_distance().times(inverse_squared).scalar()
}

/// Multiplies a share by a factor in [0, 1]; 0 for a negative share.
#[inline(always)] // `lit-smooth-range` on Cortex-M0: +22 instructions without.
fn dimmed<S: Scalar, T: Share<S>>(share: T, factor: T) -> T {
    if share > T::default() { share.times(factor) } else { T::default() }
}
