//! Attenuation: the intensity of a light as a function of distance.
//!
//! | attenuation | f(d) | source |
//! |---|---|---|
//! | [`NoAttenuation`] | 1 | a directional light with a position |
//! | [`InverseSquare`] | `1 / d^2` | physics; the default |
//! | [`Polynomial`] | `1 / (a0 + a1 d + a2 d^2)`, at most 1 | OpenGL and Direct3D 9, with the cap common in textbooks |
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
mod ranged;

pub(crate) use self::any::WithConstants;
pub use self::{
    any::{AnyAttenuation, CompiledAnyAttenuation},
    ranged::{Cut, CutAt, FilamentRange, GltfRange, GltfWindow, Ranged, SquareWindow, Windowed},
};
#[cfg(feature = "arithmetic")]
pub use self::{
    any::{AttenuationVisitor, WithAttenuation, attenuations},
    ranged::Window,
};

use crate::{
    effect::{Effect, Effects},
    error::{Error, Expected, Parameter, check_between},
    number::{Gain, Offset, Ray, Scalar, Share},
    source::{Named, Source, named},
};

/// An attenuation. The type selects the attenuation at compile time: there is no branch per point,
/// and an unused attenuation is not linked.
///
/// The trait is sealed by a private bound.
pub trait Attenuation: Copy + PartialEq + core::fmt::Debug + Named {
    /// The constants of the attenuation in a number format.
    type Constants<S: Scalar>: Copy + PartialEq + core::fmt::Debug + Source;

    /// Compiles the attenuation for the format `S`.
    fn constants<S: Scalar>(self) -> Self::Constants<S>;

    /// Returns whether the attenuation is exactly the inverse-square law, without a range or a
    /// window.
    #[inline]
    fn is_inverse_square<S: Scalar>(_: &Self::Constants<S>) -> bool {
        false
    }

    /// Returns whether the light is exactly zero at this distance. Callers test this before the
    /// square root.
    #[inline]
    fn is_beyond<S: Scalar, O: Offset<S>>(_: &Self::Constants<S>, _: &O) -> bool {
        false
    }

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

    /// Returns whether the attenuation factor may exceed 1 at distances below 1.
    fn grows(&self) -> bool {
        true
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

/// No attenuation: the same intensity at every distance.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct NoAttenuation;

/// The inverse-square law, the default: an intensity of 1 lights a facing surface at distance 1 to
/// full scale.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct InverseSquare;

/// `1 / (a0 + a1 d + a2 d^2)`, capped at 1: never more than the intensity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Polynomial {
    coefficients: [f32; 3],
}

/// Smoothstep to a range: 1 at distance 0, 0 at the range, with derivative 0 at both ends.
///
/// The dual-cone article writes `smoothstep(range, 0, d)`. In GLSL this expression is undefined,
/// because its edges are in descending order; `SmoothRange` implements the intended function.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SmoothRange {
    range: f32,
}

named!(NoAttenuation InverseSquare Polynomial SmoothRange);

/// The shortest and the longest range. The squares of both ranges, and the reciprocals of these
/// squares, are well inside the limits of f32.
const RANGES: (f32, f32) = (1e-3, 1e9);

fn checked_range(range: f32) -> Result<f32, Error> {
    let (least, most) = RANGES;
    if (least..=most).contains(&range) {
        Ok(range)
    } else {
        let accepted = Expected::RangeBetween(least, most);
        Err(Error { parameter: Parameter::Range, value: range, accepted })
    }
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

impl Polynomial {
    /// Creates the polynomial with a constant, a linear and a quadratic coefficient, for distances
    /// in scene units. If all three coefficients are 0, the attenuation factor is capped at 1
    /// everywhere.
    ///
    /// # Errors
    /// A coefficient outside 0 to 1e9.
    pub fn new(constant: f32, linear: f32, quadratic: f32) -> Result<Self, Error> {
        let coefficients = [constant, linear, quadratic];
        for value in coefficients {
            check_between(Parameter::Attenuation, value, 0.0, 1e9)?;
        }
        Ok(Self { coefficients })
    }

    /// Returns the constant, the linear and the quadratic coefficient.
    pub fn coefficients(&self) -> [f32; 3] {
        self.coefficients
    }
}

impl SmoothRange {
    /// Creates the attenuation with this range, in scene units.
    ///
    /// # Errors
    /// A range outside 0.001 to 1e9.
    pub fn new(range: f32) -> Result<Self, Error> {
        Ok(Self { range: checked_range(range)? })
    }

    /// Returns the range.
    pub fn range(&self) -> f32 {
        self.range
    }
}

impl Attenuation for NoAttenuation {
    type Constants<S: Scalar> = ();

    fn constants<S: Scalar>(self) {}

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::Unattenuated)
    }

    fn exact(&self, _: f64) -> f64 {
        1.0
    }

    fn grows(&self) -> bool {
        false
    }

    #[inline(always)] // `lit-hotspot` on Cortex-M0: +28 instructions without.
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        (): &(),
        _: &O,
        _: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        share.light(intensity)
    }
}

impl Attenuation for InverseSquare {
    type Constants<S: Scalar> = ();

    fn constants<S: Scalar>(self) {}

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::InverseSquare)
    }

    fn exact(&self, d: f64) -> f64 {
        1.0 / (d * d)
    }

    #[inline]
    fn is_inverse_square<S: Scalar>(_: &()) -> bool {
        true
    }

    #[inline]
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        (): &(),
        _: &O,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        ray.light(share, intensity)
    }
}

impl Attenuation for Polynomial {
    type Constants<S: Scalar> = [S::Gain; 3];

    fn constants<S: Scalar>(self) -> [S::Gain; 3] {
        self.coefficients.map(S::gain)
    }

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::Polynomial)
    }

    fn exact(&self, d: f64) -> f64 {
        let [constant, linear, quadratic] = self.coefficients.map(f64::from);
        1.0 / (constant + linear * d + quadratic * d * d).max(1.0)
    }

    fn grows(&self) -> bool {
        false
    }

    #[inline(always)] // `lit-polynomial` on Cortex-M0: +174 instructions without.
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        &[constant, linear, quadratic]: &[S::Gain; 3],
        _: &O,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        let distance = ray.distance();
        let divisor = quadratic.times(distance).plus(linear).times(distance).plus(constant);
        share.light(divisor.inverse_capped().times(intensity))
    }
}

impl Attenuation for SmoothRange {
    /// The reciprocals of the range and of its square.
    type Constants<S: Scalar> = [S::Gain; 2];

    fn constants<S: Scalar>(self) -> [S::Gain; 2] {
        [S::gain(1.0 / self.range), inverse_squared::<S>(Some(self.range))]
    }

    fn range(&self) -> Option<f32> {
        Some(self.range)
    }

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::SmoothRange).with(Effect::Range)
    }

    fn exact(&self, d: f64) -> f64 {
        let t = (1.0 - d / f64::from(self.range)).max(0.0);
        t * t * (3.0 - 2.0 * t)
    }

    fn grows(&self) -> bool {
        false
    }

    #[inline]
    fn is_beyond<S: Scalar, O: Offset<S>>(&[_, squared]: &[S::Gain; 2], offset: &O) -> bool {
        squared_fraction::<S, O>(squared, offset) == S::ONE
    }

    #[inline(always)] // `lit-smooth-range` on Cortex-M0: +273 instructions without.
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        constants: &[S::Gain; 2],
        offset: &O,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        let smooth = ray.near(constants[0]).complement().smooth();
        let is_beyond = ray.squared_near(offset, constants[1]).is_one();
        let smooth = if is_beyond { R::Share::default() } else { smooth };
        dimmed::<S, _>(share, smooth).light(intensity)
    }
}
