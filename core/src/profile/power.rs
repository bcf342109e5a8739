//! Integer powers, by repeated squaring.

use super::{Curve, Profile, without_coefficients};
use crate::{
    scalar::{Fraction, Scalar},
    trig,
};

/// The power `t^N`, by repeated squaring: one multiply for each of `t^2`, `t^4`, `t^8` and so on, and one more for
/// each further binary one of `N`. `N` is from 1 to 128.
///
/// The larger `N`, the more of the cone is close to dark: `Power<2>` is [`Soft`](crate::Soft).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Power<const N: u32>;

/// The rim power `1 - u^N` (Godot's spotlight, for an integer attenuation): as many multiplies as [`Power`]. `N`
/// is from 1 to 128.
///
/// The larger `N`, the flatter the middle and the crisper the rim: `Rim<2>` is [`Hard`](crate::Hard).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Rim<const N: u32>;

/// `1 - exp(-x)` for `x` in [0, 2.4], without cancellation: the series of the exponential, to the last place.
fn lost_after(x: f32) -> f32 {
    let terms = (2..=20).rev().fold(1.0, |sum, n| 1.0 - x / n as f32 * sum);
    x * terms
}

/// `x^n`, set-up only.
fn raised(x: f32, n: u32) -> f32 {
    (0..n).fold(1.0, |product, _| product * x)
}

/// `t^n` for `n` from 1 up, kept fine: by the binary digits of `n`, from the second highest down.
#[inline(always)]
fn power<S: Scalar>(t: S::Fraction, n: u32) -> S::Fraction {
    let mut power = t;
    let mut digit = n.ilog2();
    while digit > 0 {
        digit -= 1;
        power = power.fine_product(power);
        if n >> digit & 1 == 1 {
            power = power.fine_product(t);
        }
    }
    power
}

/// `t^N`, whose last product is rounded to the scalar at once.
#[inline(always)]
fn rounded_power<S: Scalar, const N: u32>(t: S::Fraction) -> S {
    const { assert!(N >= 1 && N <= 128, "a power has an exponent from 1 to 128") };
    if N == 1 {
        t.scalar()
    } else if N.is_multiple_of(2) {
        let root = power::<S>(t, N / 2);
        root.product(root)
    } else {
        power::<S>(t, N - 1).product(t)
    }
}

impl<const N: u32> Profile for Power<N> {
    without_coefficients!();

    /// `1 - (1/2)^(1/N)`.
    fn beam_versine(self) -> f32 {
        lost_after(core::f32::consts::LN_2 / N as f32)
    }

    /// `1 - (1/10)^(1/N)`.
    fn field_versine(self) -> f32 {
        lost_after(core::f32::consts::LN_10 / N as f32)
    }

    /// The largest of `2 N (1 - v)^(N - 1) sqrt(v)`, at `v = 1 / (2 N - 1)` if that is outside the hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        let span = 1.0 - hotspot;
        let steepest = (1.0 / (2 * N - 1) as f32).max(hotspot);
        2.0 * N as f32 * raised((1.0 - steepest) / span, N - 1) * trig::sqrt(steepest) / span
    }

    fn integral(self, u: f32) -> f32 {
        // (1 - t^(N + 1)) / (1 - t) is a sum of powers: nothing cancels where u is small.
        let (sum, _) = (0..=N).fold((0.0, 1.0), |(sum, power), _| (sum + power, power * (1.0 - u)));
        u * sum / (N + 1) as f32
    }
}

impl<S: Scalar, const N: u32> Curve<S> for Power<N> {
    #[inline(always)]
    fn intensity(self, t: S::Fraction) -> S {
        rounded_power::<S, N>(t)
    }
}

impl<const N: u32> Profile for Rim<N> {
    without_coefficients!();

    /// `(1/2)^(1/N)`.
    fn beam_versine(self) -> f32 {
        1.0 - lost_after(core::f32::consts::LN_2 / N as f32)
    }

    /// `(9/10)^(1/N)`.
    fn field_versine(self) -> f32 {
        const LOST: f32 = 0.105_360_516; // ln(10/9)
        1.0 - lost_after(LOST / N as f32)
    }

    /// The slope at the edge: `2 N` without a hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        2.0 * N as f32 / (1.0 - hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u - raised(u, N + 1) / (N + 1) as f32
    }
}

impl<S: Scalar, const N: u32> Curve<S> for Rim<N> {
    #[inline(always)]
    fn intensity(self, t: S::Fraction) -> S {
        S::ONE.minus(rounded_power::<S, N>(t.complement()))
    }
}
