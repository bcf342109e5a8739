//! Attenuation: how the intensity of a light falls with the distance from it.
//!
//! | model | f(d) | source |
//! |---|---|---|
//! | [`NoAttenuation`] | 1 | directional light brought to a place |
//! | [`InverseSquare`] | `1 / d^2` | physics; the default |
//! | [`Polynomial`] | `1 / (a0 + a1 d + a2 d^2)`, at most 1 | OpenGL and Direct3D 9; capped as lectures teach it |
//! | [`SmoothRange`] | `t^2 (3 - 2t)` of `t = 1 - d/r` | the dual-cone spotlight, smoothstep from its range to 0 |
//! | [`GltfRange`] | `(1 - (d/r)^4) / d^2`, at least 0 | glTF's KHR_lights_punctual |
//! | [`FilamentRange`] | `(1 - (d/r)^4)^2 / d^2` within r | Filament, Bevy, three.js with decay 2 |
//! | [`CutAt`] of a model | the model within r, 0 from there on | Direct3D 9 |
//! | [`Windowed`] of a model | the model times `(1 - (d/r)^4)^2` within r | Godot, and three.js with any decay |
//! | [`AnyAttenuation`] | one of the above | the choice at run time |
//!
//! A light without a range says `None`, never 0. At and beyond its range the light is exactly zero; in fixed point it ends
//! half a step of the format earlier. Points out of range are rejected before the square root, and the reject changes no
//! bit of any result.
//!
//! Here *falloff* is the intensity over the angle, and *attenuation* the one over the distance.

mod any;
mod ranged;

pub(crate) use self::any::with_attenuation;
pub use self::{
    any::{AnyAttenuation, CompiledAnyAttenuation},
    ranged::{Cut, CutAt, FilamentRange, GltfRange, GltfWindow, Ranged, SquareWindow, Windowed},
};

use crate::{
    effect::{Effect, Effects},
    error::{Error, Expected, Parameter, check_between},
    number::{Gain, Offset, Ray, Scalar, Share},
    source::named,
};

/// A distance model. The type decides which one is compiled in: there is no branch per point, and a model that is not
/// named is not linked.
///
/// Sealed: it has a bound that is private.
pub trait Attenuation: Copy + PartialEq + core::fmt::Debug {
    /// What the model knows once it is compiled for a format.
    type Constants<S: Scalar>: Copy + PartialEq + core::fmt::Debug;

    /// Compiles the model for the format `S`.
    fn constants<S: Scalar>(self) -> Self::Constants<S>;

    /// Whether the light falls with the square of the distance and by nothing else.
    #[inline]
    fn is_inverse_square<S: Scalar>(_: &Self::Constants<S>) -> bool {
        false
    }

    /// Whether the light is exactly zero at this distance, told before the root is paid for.
    #[inline]
    fn is_beyond<S: Scalar>(_: &Self::Constants<S>, _: &S::Offset) -> bool {
        false
    }

    /// Where the light ends, if it does.
    fn range(&self) -> Option<f32> {
        None
    }

    /// The effects that the attenuation requires.
    fn effects(&self) -> Effects;

    /// The factor at a distance in f64, as plainly as it can be written: the truth that errors are
    /// measured against.
    fn exact(&self, distance: f64) -> f64;

    /// Whether more than the intensity arrives where the light is nearer than 1.
    fn grows(&self) -> bool {
        true
    }

    /// The light of a share of an intensity that is left at this distance; none for a negative share.
    fn expose<S: Scalar, R: Ray<S>>(
        constants: &Self::Constants<S>,
        offset: &S::Offset,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance;
}

/// No fall with distance.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct NoAttenuation;

/// The inverse-square law, which is the default: an intensity of 1 lights a facing surface at distance 1 to full scale.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct InverseSquare;

/// `1 / (a0 + a1 d + a2 d^2)`, capped at 1: no more arrives than the intensity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Polynomial {
    coefficients: [f32; 3],
}

/// Smoothstep to a range: 1 at distance 0, 0 at the range, flat at both ends.
///
/// The dual-cone article writes `smoothstep(range, 0, d)`, whose edges GLSL wants in rising order or leaves undefined;
/// this is what it means.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SmoothRange {
    range: f32,
}

named!(NoAttenuation InverseSquare Polynomial SmoothRange);

/// The shortest and the longest range. Their squares and the reciprocals of these stay clear of the ends of f32.
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

/// What turns a squared distance into a fraction of the squared range; zero where there is no range.
fn inverse_squared<S: Scalar>(range: Option<f32>) -> S::Gain {
    S::gain(range.map_or(0.0, |range| 1.0 / (range * range)))
}

/// `(d/r)^2`, and exactly one from the range on.
#[inline]
fn squared_fraction<S: Scalar>(inverse_squared: S::Gain, offset: &S::Offset) -> S {
    offset.squared_distance().by(inverse_squared).fraction()
}

/// What a factor in [0, 1] leaves of a share; nothing of a negative one.
#[inline(always)] // `spot-soft-lambert-smooth-range` on Cortex-M0: +22 without.
fn dimmed<S: Scalar, T: Share<S>>(share: T, factor: T) -> T {
    if share > T::default() { share.share_of(factor) } else { T::default() }
}

impl Polynomial {
    /// The constant, linear and quadratic coefficients, in units of the world's length. All zero is no fall at all,
    /// by the cap.
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

    /// The constant, linear and quadratic coefficients.
    pub fn coefficients(&self) -> [f32; 3] {
        self.coefficients
    }
}

impl SmoothRange {
    /// Ends at this range, in units of the world's length.
    ///
    /// # Errors
    /// A range outside 0.001 to 1e9.
    pub fn new(range: f32) -> Result<Self, Error> {
        Ok(Self { range: checked_range(range)? })
    }

    /// Where the light ends.
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

    #[inline(always)] // `spot-soft-lambert-hotspot` on Cortex-M0: +28 without.
    fn expose<S: Scalar, R: Ray<S>>(
        (): &(),
        _: &S::Offset,
        _: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        share.give(intensity)
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
    fn expose<S: Scalar, R: Ray<S>>(
        (): &(),
        _: &S::Offset,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        ray.expose(share, intensity)
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

    #[inline(always)] // `spot-soft-lambert-polynomial` on Cortex-M0: +174 without.
    fn expose<S: Scalar, R: Ray<S>>(
        &[constant, linear, quadratic]: &[S::Gain; 3],
        _: &S::Offset,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        let distance = ray.distance();
        let divisor = quadratic.by(distance).plus(linear).by(distance).plus(constant);
        share.give(divisor.inverse_capped().by(intensity))
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
    fn is_beyond<S: Scalar>(&[_, squared]: &[S::Gain; 2], offset: &S::Offset) -> bool {
        squared_fraction::<S>(squared, offset) == S::ONE
    }

    #[inline(always)] // `spot-soft-lambert-smooth-range` on Cortex-M0: +273 without.
    fn expose<S: Scalar, R: Ray<S>>(
        constants: &[S::Gain; 2],
        offset: &S::Offset,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        let smooth = ray.near(constants[0]).rest().smoothed();
        let is_beyond = ray.squared_near(offset, constants[1]).is_all();
        let smooth = if is_beyond { R::Share::default() } else { smooth };
        dimmed::<S, _>(share, smooth).give(intensity)
    }
}
