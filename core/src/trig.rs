//! The one seam to square root and trigonometry.
//!
//! Trigonometry is asked for at set-up only, never per point. `libm` answers first, on every target, so that the
//! same angles compile to the same bits everywhere; then `std`; then `micromath`, whose approximations are a tier of
//! their own; and without any of them a series, so that a build of constants and integers needs no other crate. The
//! square root is correctly rounded but in `micromath`, so the others agree to the bit.

// A Cortex-M4F and its kin: they compute in f32, and only `std` may ask for their root. And whoever has no other.
#[cfg(any(
    test,
    all(target_arch = "arm", target_abi = "eabihf", not(feature = "std")),
    not(any(feature = "libm", feature = "std", feature = "micromath"))
))]
mod root;

#[cfg(not(all(target_arch = "arm", target_abi = "eabihf", not(feature = "std"))))]
pub(crate) use backend::inverse_sqrt;
pub(crate) use backend::{asin, sin, sqrt};
#[cfg(all(target_arch = "arm", target_abi = "eabihf", not(feature = "std")))]
pub(crate) use root::inverse_sqrt;

#[cfg(any(feature = "libm", feature = "std"))]
mod backend {
    /// Sine of an angle in radians.
    pub(crate) fn sin(x: f32) -> f32 {
        #[cfg(feature = "libm")]
        return libm::sinf(x);
        #[cfg(not(feature = "libm"))]
        return x.sin();
    }

    /// Arc sine in radians.
    pub(crate) fn asin(x: f32) -> f32 {
        #[cfg(feature = "libm")]
        return libm::asinf(x);
        #[cfg(not(feature = "libm"))]
        return x.asin();
    }

    /// Square root, correctly rounded: the processor's where there is one.
    #[inline]
    pub(crate) fn sqrt(x: f32) -> f32 {
        #[cfg(feature = "std")]
        return x.sqrt();
        #[cfg(not(feature = "std"))]
        return libm::sqrtf(x);
    }

    /// Reciprocal of the square root of a normal number, and zero for any other: zero or less, subnormal, infinite or
    /// NaN.
    #[cfg(not(all(target_arch = "arm", target_abi = "eabihf", not(feature = "std"))))]
    #[inline]
    pub(crate) fn inverse_sqrt(x: f32) -> f32 {
        if x >= f32::MIN_POSITIVE { 1.0 / sqrt(x) } else { 0.0 }
    }
}

/// The small tier. Roots are micromath's guess made good by Newton's method, because a direction needs its precision.
#[cfg(all(feature = "micromath", not(any(feature = "libm", feature = "std"))))]
mod backend {
    use micromath::F32Ext;

    pub(crate) use super::inverse::asin;

    /// Sine of an angle in radians, within 0.11 %. The error of micromath's is absolute, and a narrow cone needs a
    /// relative one: there two terms of the series do better.
    pub(crate) fn sin(x: f32) -> f32 {
        if x.abs() < 0.5 { x - x * x * x / 6.0 } else { F32Ext::sin(x) }
    }

    /// Square root, within two units in the last place.
    #[inline]
    pub(crate) fn sqrt(x: f32) -> f32 {
        x * reciprocal(x)
    }

    /// Reciprocal of the square root of a normal number, within two units in the last place, and zero for any other: zero
    /// or less, subnormal, infinite or NaN.
    #[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
    #[inline]
    pub(crate) fn inverse_sqrt(x: f32) -> f32 {
        if (f32::MIN_POSITIVE..=f32::MAX).contains(&x) { reciprocal(x) } else { 0.0 }
    }

    /// Reciprocal of the square root, within two units in the last place.
    #[inline]
    fn reciprocal(x: f32) -> f32 {
        (0..3).fold(F32Ext::invsqrt(x), |y, _| y * (1.5 - 0.5 * x * y * y))
    }
}

/// What needs no other crate.
#[cfg(not(any(feature = "libm", feature = "std", feature = "micromath")))]
mod backend {
    #[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
    pub(crate) use super::root::inverse_sqrt;
    pub(crate) use super::{inverse::asin, root::any_sqrt as sqrt};

    /// Sine of an angle of at most a right angle, in radians, within 1.5e-7 of itself: the series to the eleventh power.
    pub(crate) fn sin(x: f32) -> f32 {
        /// The coefficients of `x^11` down to `x^3`.
        const SERIES: [f32; 5] =
            [-1.0 / 39_916_800.0, 1.0 / 362_880.0, -1.0 / 5_040.0, 1.0 / 120.0, -1.0 / 6.0];
        let square = x * x;
        x + x * SERIES.iter().fold(0.0, |sum, coefficient| (sum + coefficient) * square)
    }
}

/// The arc sine where only a sine is given.
#[cfg(not(any(feature = "libm", feature = "std")))]
mod inverse {
    use super::{sin, sqrt};

    /// The angle in radians that has this sine by [`sin`] itself, not in truth: an angle that was given is got back.
    pub(crate) fn asin(x: f32) -> f32 {
        if x > 0.75 {
            return core::f32::consts::FRAC_PI_2 - 2.0 * asin(sqrt((1.0 - x) / 2.0));
        }
        let slope = 1.0 / sqrt(1.0 - x * x);
        (0..12).fold(x, |angle, _| angle + (x - sin(angle)) * slope)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    extern crate std;

    const SMALL_TIER: bool = cfg!(all(feature = "micromath", not(any(feature = "libm", feature = "std"))));

    fn largest(errors: impl Iterator<Item = f64>) -> f64 {
        errors.fold(0.0, f64::max)
    }

    /// Arguments evenly spread over the logarithm, from 1e-6 to `most`.
    fn arguments(most: f32) -> impl Iterator<Item = f32> {
        (0..100_000).map(move |i| 1e-6 * (most / 1e-6).powf(i as f32 / 99_999.0))
    }

    #[test]
    fn sines_keep_their_stated_error() {
        let error = |x: f32| (f64::from(sin(x)) / f64::from(x).sin() - 1.0).abs();
        let worst = largest(arguments(1.5).map(error));
        let bounds = if SMALL_TIER { 5e-4..=1.1e-3 } else { 1e-8..=1.5e-7 };
        assert!(bounds.contains(&worst), "largest relative error {worst:.2e}");
    }

    #[test]
    fn an_angle_comes_back_from_its_sine() {
        let error = |x: f32| f64::from((asin(sin(x)) / x - 1.0).abs());
        // Near a right angle the sine hardly tells angles apart.
        let worst = largest(arguments(0.8).map(error));
        assert!((1e-8..=1e-6).contains(&worst), "largest relative difference {worst:.2e}");
    }

    #[test]
    fn roots_keep_their_stated_error() {
        let error = |x: f32| (f64::from(inverse_sqrt(x)) * f64::from(x).sqrt() - 1.0).abs();
        let worst = largest(arguments(1e6).map(error));
        assert!((5e-8..=2.4e-7).contains(&worst), "largest relative error {worst:.2e}");
        let error = |x: f32| (f64::from(sqrt(x)) / f64::from(x).sqrt() - 1.0).abs();
        let worst = largest(arguments(1e6).map(error));
        assert!((2e-8..=2.4e-7).contains(&worst), "largest relative error {worst:.2e}");
    }

    /// Every mantissa, with an even and an odd exponent: what every other normal number repeats.
    #[test]
    fn roots_keep_their_stated_error_over_every_mantissa() {
        let values = || (1.0_f32.to_bits()..4.0_f32.to_bits()).map(f32::from_bits);
        let worst = largest(values().map(|x| (f64::from(sqrt(x)) / f64::from(x).sqrt() - 1.0).abs()));
        let bounds = if SMALL_TIER { 1e-7..=2.4e-7 } else { 5.9e-8..=5.97e-8 };
        assert!(bounds.contains(&worst), "largest relative error of a root {worst:e}");
        let worst = largest(values().map(|x| (f64::from(inverse_sqrt(x)) * f64::from(x).sqrt() - 1.0).abs()));
        let bounds = if SMALL_TIER { 1e-7..=2.4e-7 } else { 8.9e-8..=1.2e-7 };
        assert!(bounds.contains(&worst), "largest relative error of a reciprocal root {worst:e}");
    }
}
