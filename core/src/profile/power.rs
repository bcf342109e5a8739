//! Integer powers whose exponent is part of the type.

use super::{
    Curve, Formula, Profile,
    integer::{IntegerPower, IntegerRim, MOST, rounded_power},
    without_coefficients,
};
use crate::scalar::{Fraction, Scalar};

/// The power `t^N`, by repeated squaring: one multiply for each of `t^2`, `t^4`, `t^8` and so on, and one more for
/// each further binary one of `N`. `N` is from 1 to 1,024.
///
/// The larger `N`, the more of the cone is close to dark: `Power<2>` is [`Soft`](crate::Soft).
///
/// Any other `N` does not compile:
///
/// ```compile_fail,E0080
/// let profile = luminaire::Matched::from(luminaire::Power::<0>);
/// ```
///
/// ```compile_fail,E0080
/// let profile = luminaire::Matched::from(luminaire::Power::<4_000_000_000>);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Power<const N: u32>;

/// The rim power `1 - u^N`, Godot's spotlight of the angle attenuation `1/N`: as many multiplies as [`Power`]. `N` is from 1 to 1,024.
///
/// The larger `N`, the flatter the middle and the crisper the rim: `Rim<2>` is [`Hard`](crate::Hard).
///
/// Any other `N` does not compile:
///
/// ```compile_fail,E0080
/// let profile = luminaire::Matched::from(luminaire::Rim::<0>);
/// ```
///
/// ```compile_fail,E0080
/// let profile = luminaire::Matched::from(luminaire::Rim::<4_000_000_000>);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Rim<const N: u32>;

/// `N`, which the compiler checks. Every use of `N` comes through here, so that no conversion lets another one pass.
pub(super) const fn sound<const N: u32>() -> u32 {
    const { assert!(N >= 1 && N <= MOST, "a power has an exponent from 1 to 1,024") };
    N
}

impl<const N: u32> Profile for Power<N> {
    without_coefficients!();

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

impl<S: Scalar, const N: u32> Curve<S> for Power<N> {
    #[inline(always)]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        rounded_power::<S, F>(t, sound::<N>())
    }
}

impl<const N: u32> Profile for Rim<N> {
    without_coefficients!();

    fn formula(&self) -> Formula<'_> {
        Formula::InvertedPower(sound::<N>() as f32, 0.0)
    }

    fn beam_versine(self) -> f32 {
        IntegerRim::of(sound::<N>()).beam_versine()
    }

    fn field_versine(self) -> f32 {
        IntegerRim::of(sound::<N>()).field_versine()
    }

    fn steepness(self, hotspot: f32) -> f32 {
        IntegerRim::of(sound::<N>()).steepness(hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        IntegerRim::of(sound::<N>()).integral(u)
    }
}

impl<S: Scalar, const N: u32> Curve<S> for Rim<N> {
    #[inline(always)]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        F::lack(rounded_power::<S, F>(t.complement(), sound::<N>()))
    }
}
