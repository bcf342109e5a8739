//! Integer powers with a compile-time exponent.

use core::fmt::{self, Formatter};

use super::{
    CompiledFalloff, Falloff, Formula,
    integer::{IntegerPower, InvertedIntegerPower, MOST, rounded_power},
};
use crate::{
    number::{Fraction, Scalar, Share},
    source::Source,
};

/// The power `t^N`, by repeated squaring. The power takes one multiply for each of `t^2`, `t^4`,
/// `t^8` and so on, and one multiply for each further set bit of `N`. `N` is in [1, 1024].
///
/// The larger `N`, the narrower the bright centre. `Power<2>` is [`Soft`](crate::falloff::Soft).
///
/// Any other `N` does not compile:
///
/// ```compile_fail,E0080
/// let falloff = luminaire::falloff::AnyFalloff::from(luminaire::falloff::Power::<0>);
/// ```
///
/// ```compile_fail,E0080
/// let falloff = luminaire::falloff::AnyFalloff::from(luminaire::falloff::Power::<4_000_000_000>);
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Power<const N: u32>;

/// The inverted power `1 - u^N`, Godot's spotlight with an angle attenuation of `1/N`. The inverted
/// power takes as many multiplies as [`Power`]. `N` is in [1, 1024].
///
/// The larger `N`, the flatter the centre and the steeper the edge. `InvertedPower<2>` is
/// [`Hard`](crate::falloff::Hard).
///
/// Any other `N` does not compile:
///
/// ```compile_fail,E0080
/// let falloff = luminaire::falloff::AnyFalloff::from(luminaire::falloff::InvertedPower::<0>);
/// ```
///
/// ```compile_fail,E0080
/// let falloff = luminaire::falloff::AnyFalloff::from(luminaire::falloff::InvertedPower::<4_000_000_000>);
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct InvertedPower<const N: u32>;

/// Returns `N` after a compile-time check. Every use of `N` calls this function, so no conversion
/// accepts an invalid `N`.
pub(super) const fn sound<const N: u32>() -> u32 {
    const { assert!(N >= 1 && N <= MOST, "a power has an exponent from 1 to 1,024") };
    N
}

impl<const N: u32> Source for Power<N> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "Power::<{N}>")
    }
}

impl<const N: u32> Source for InvertedPower<N> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "InvertedPower::<{N}>")
    }
}

impl<const N: u32> Falloff for Power<N> {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Power(sound::<N>() as f32)
    }

    fn beam_versine(self) -> f32 {
        IntegerPower::of(sound::<N>()).beam_versine()
    }

    fn field_versine(self) -> f32 {
        IntegerPower::of(sound::<N>()).field_versine()
    }

    fn steepness(self, hotspot: f32) -> f32 {
        IntegerPower::of(sound::<N>()).steepness(hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        IntegerPower::of(sound::<N>()).integral(u)
    }
}

impl<S: Scalar, const N: u32> CompiledFalloff<S> for Power<N> {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        rounded_power::<S, F>(t, sound::<N>())
    }
}

impl<const N: u32> Falloff for InvertedPower<N> {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::InvertedPower(sound::<N>() as f32, 0.0)
    }

    fn beam_versine(self) -> f32 {
        InvertedIntegerPower::of(sound::<N>()).beam_versine()
    }

    fn field_versine(self) -> f32 {
        InvertedIntegerPower::of(sound::<N>()).field_versine()
    }

    fn steepness(self, hotspot: f32) -> f32 {
        InvertedIntegerPower::of(sound::<N>()).steepness(hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        InvertedIntegerPower::of(sound::<N>()).integral(u)
    }
}

impl<S: Scalar, const N: u32> CompiledFalloff<S> for InvertedPower<N> {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        rounded_power::<S, F>(t.complement(), sound::<N>()).complement()
    }
}
