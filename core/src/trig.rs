//! The one seam to square root and trigonometry.
//!
//! Trigonometry is asked for at set-up only, never per point. `libm` answers first, on every target, so that
//! the same angles compile to the same bits everywhere; then `std`; then `micromath`, whose approximations are a
//! tier of their own. The square root is correctly rounded in `std` and `libm`, so those two agree to the bit.

#[cfg(not(any(feature = "libm", feature = "std", feature = "micromath")))]
compile_error!(
    "luminaire needs a square root: enable the feature `libm` (same bits everywhere), `std` or `micromath`"
);

/// Sine of an angle in radians.
pub(crate) fn sin(x: f32) -> f32 {
    #[cfg(feature = "libm")]
    return libm::sinf(x);
    #[cfg(all(feature = "std", not(feature = "libm")))]
    return x.sin();
    #[cfg(all(feature = "micromath", not(any(feature = "libm", feature = "std"))))]
    return micromath::F32Ext::sin(x);
}

/// Arc sine in radians.
pub(crate) fn asin(x: f32) -> f32 {
    #[cfg(feature = "libm")]
    return libm::asinf(x);
    #[cfg(all(feature = "std", not(feature = "libm")))]
    return x.asin();
    #[cfg(all(feature = "micromath", not(any(feature = "libm", feature = "std"))))]
    return micromath::F32Ext::asin(x);
}

/// Square root; the fastest correctly rounded one there is.
#[inline(always)]
pub(crate) fn sqrt(x: f32) -> f32 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(all(feature = "libm", not(feature = "std")))]
    return libm::sqrtf(x);
    #[cfg(all(feature = "micromath", not(any(feature = "libm", feature = "std"))))]
    return micromath::F32Ext::sqrt(x);
}
