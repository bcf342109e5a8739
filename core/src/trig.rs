//! The only interface to square root and trigonometry.
//!
//! Trigonometry runs at set-up only, never per point. The backend of the trigonometry is the first
//! available of:
//!
//! - `libm`, on every target, so that the same angles compile to the same bits everywhere.
//! - `std`.
//! - `micromath`, a separate tier because its results are approximations.
//! - A series, so that a build of constants and integers needs no other crate.
//!
//! The square root is the first available of `std`'s, that of the processor by `native`, and the
//! backend's. Every backend except `micromath` rounds the square root correctly, so all of these are
//! bit-identical.

mod power;
#[cfg(any(test, not(any(feature = "libm", feature = "std", feature = "micromath"))))]
mod root;

pub(crate) use backend::{asin, sin};
pub(crate) use power::{real_power, square_root};

/// Returns the square root.
#[inline]
pub(crate) fn sqrt(x: f32) -> f32 {
    #[cfg(all(feature = "native", not(feature = "std")))]
    if let Some(root) = luminaire_native::sqrt(x) {
        return root;
    }
    backend::sqrt(x)
}

/// Returns `1 / sqrt(x)` for a normal number `x > 0`.
///
/// Returns zero for any other `x`: zero or less, subnormal, infinite or NaN.
#[inline]
pub(crate) fn inverse_sqrt(x: f32) -> f32 {
    if x >= f32::MIN_POSITIVE { 1.0 / sqrt(x) } else { 0.0 }
}

#[cfg(any(feature = "libm", feature = "std"))]
mod backend {
    /// Returns the sine of an angle in radians.
    pub(crate) fn sin(x: f32) -> f32 {
        #[cfg(feature = "libm")]
        return libm::sinf(x);
        #[cfg(not(feature = "libm"))]
        return x.sin();
    }

    /// Returns the arc sine in radians.
    pub(crate) fn asin(x: f32) -> f32 {
        #[cfg(feature = "libm")]
        return libm::asinf(x);
        #[cfg(not(feature = "libm"))]
        return x.asin();
    }

    /// Returns the correctly rounded square root.
    #[inline]
    pub(crate) fn sqrt(x: f32) -> f32 {
        #[cfg(feature = "std")]
        return x.sqrt();
        #[cfg(not(feature = "std"))]
        return libm::sqrtf(x);
    }
}

/// The backend `micromath`, whose results are approximations.
///
/// Newton's method refines micromath's estimate of the reciprocal square root, because directions
/// need the precision.
#[cfg(all(feature = "micromath", not(any(feature = "libm", feature = "std"))))]
mod backend {
    use micromath::F32Ext;

    pub(crate) use super::inverse::asin;

    /// Returns the sine of an angle in radians, with a relative error of at most 0.11 %.
    ///
    /// micromath bounds the absolute error only, but a narrow cone needs a small relative error.
    /// For small angles, two terms of the sine's series have a small relative error.
    pub(crate) fn sin(x: f32) -> f32 {
        if x.abs() < 0.5 { x - x * x * x / 6.0 } else { F32Ext::sin(x) }
    }

    /// Returns the square root, within two units in the last place.
    #[inline]
    pub(crate) fn sqrt(x: f32) -> f32 {
        x * (0..3).fold(F32Ext::invsqrt(x), |y, _| y * (1.5 - 0.5 * x * y * y))
    }
}

/// The backend that needs no other crate.
#[cfg(not(any(feature = "libm", feature = "std", feature = "micromath")))]
mod backend {
    pub(crate) use super::{inverse::asin, root::sqrt};

    /// Returns the sine of an angle of at most 90 degrees, in radians.
    ///
    /// The function sums the series of the sine up to the eleventh power, with a relative error of
    /// at most 1.5e-7.
    pub(crate) fn sin(x: f32) -> f32 {
        /// The coefficients of `x^11` down to `x^3`.
        const SERIES: [f32; 5] =
            [-1.0 / 39_916_800.0, 1.0 / 362_880.0, -1.0 / 5_040.0, 1.0 / 120.0, -1.0 / 6.0];
        let square = x * x;
        x + x * SERIES.iter().fold(0.0, |sum, coefficient| (sum + coefficient) * square)
    }
}

/// Arc sine for backends that provide only a sine.
#[cfg(not(any(feature = "libm", feature = "std")))]
mod inverse {
    use super::{sin, sqrt};

    /// Returns the angle in radians whose [`sin`] is `x`.
    ///
    /// The function inverts this backend's `sin`, and not the exact sine, so that
    /// `asin(sin(angle))` returns the angle.
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

    /// Arguments from 1e-6 to `most`, evenly spaced in the logarithm.
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
        // The test ends at 0.8, because near a right angle the sine hardly changes with the angle.
        let worst = largest(arguments(0.8).map(error));
        assert!((1e-8..=1e-6).contains(&worst), "largest relative difference {worst:.2e}");
    }

    #[test]
    fn what_is_not_normal_has_no_reciprocal() {
        let normal = [f32::MIN_POSITIVE, 1.0, 2.0, f32::MAX];
        let others = [0.0, 1e-40, f32::from_bits(0x007f_ffff), f32::INFINITY, f32::NAN];
        for x in others.into_iter().flat_map(|x| [x, -x]).chain(normal.map(|x| -x)) {
            assert_eq!(inverse_sqrt(x), 0.0, "{x}");
        }
        for x in normal {
            let error = inverse_sqrt(x) * x.sqrt() - 1.0;
            let is_exact = cfg!(any(feature = "libm", feature = "std")) || !cfg!(feature = "micromath");
            assert!(if is_exact { inverse_sqrt(x) == 1.0 / x.sqrt() } else { error.abs() < 1e-6 }, "{x}");
        }
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

    /// Tests every mantissa with an even and with an odd exponent. All other normal numbers repeat
    /// these cases.
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
