//! Falloffs compiled for a number format.

use crate::number::{Fraction, Scalar};

/// A [`Falloff`](super::Falloff) compiled for the format `S`, evaluated per point.
pub trait CompiledFalloff<S: Scalar>: Copy + PartialEq + core::fmt::Debug {
    /// Whether the intensity has neither a branch nor a look-up, so that fixed point evaluates many points in
    /// vectors.
    #[doc(hidden)]
    const IN_VECTORS: bool = false;
    /// Returns the intensity in [0, 1] at `t`.
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value;
    /// Returns the coefficients of the [`cubic`](Fraction::cubic) with the same bits at every `t`, if there is one: for a choice at run time, one loop over
    /// many points serves all of them.
    #[doc(hidden)]
    #[inline]
    fn as_cubic(self) -> Option<[S::Weight; 2]> {
        None
    }
}
