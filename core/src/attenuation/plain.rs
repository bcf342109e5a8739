//! The attenuations without parameters.

use super::Attenuation;
use crate::{
    effect::{Effect, Effects},
    model::plain,
    number::{Offset, Ray, Scalar, Share},
};

/// No attenuation: the same intensity at every distance.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct NoAttenuation;

/// The inverse-square law, the default: an intensity of 1 lights a facing surface at distance 1 to
/// full scale.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct InverseSquare;

plain!(law NoAttenuation InverseSquare);

impl Attenuation for NoAttenuation {
    type Constants<S: Scalar> = ();

    fn constants<S: Scalar>(self) {}

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::Unattenuated)
    }

    fn exact(&self, _: f64) -> f64 {
        1.0
    }

    fn growth(&self) -> f32 {
        0.0
    }

    #[inline]
    fn is_beyond<S: Scalar, O: Offset<S>>(_: &Self::Constants<S>, _: &O) -> bool {
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
    const IS_INVERSE_SQUARE: bool = true;

    type Constants<S: Scalar> = ();

    fn constants<S: Scalar>(self) {}

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::InverseSquare)
    }

    fn exact(&self, d: f64) -> f64 {
        1.0 / (d * d)
    }

    fn growth(&self) -> f32 {
        2.0
    }

    #[inline]
    fn is_beyond<S: Scalar, O: Offset<S>>(_: &Self::Constants<S>, _: &O) -> bool {
        false
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
