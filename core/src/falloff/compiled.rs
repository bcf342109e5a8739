//! Falloffs compiled for a number format.

use crate::number::{Fraction, Scalar};

/// A falloff that is a square.
#[derive(Clone, Copy, Debug)]
pub enum Square {
    /// `t^2`, the soft edge.
    Soft,
    /// `1 - (1 - t)^2`, the hard edge.
    Hard,
}

/// A [`Falloff`](super::Falloff) compiled for the format `S`, evaluated per point.
pub trait CompiledFalloff<S: Scalar>: Copy + PartialEq + core::fmt::Debug {
    /// Whether the intensity has neither a branch nor a look-up, so that fixed point evaluates many points in
    /// vectors.
    #[doc(hidden)]
    const IN_VECTORS: bool = false;
    /// Returns the intensity in [0, 1] at `t`.
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value;
    /// Returns the coefficients of the [`cubic`](Fraction::cubic) of this falloff, if there is one: for a choice at run
    /// time, one loop over many points serves all of them. It has the same bits at every `t` unless the falloff is
    /// a square: see [`as_square`](Self::as_square).
    #[doc(hidden)]
    #[inline]
    fn as_cubic(self) -> Option<[S::Weight; 2]> {
        None
    }
    /// Returns the square that this falloff is, if it is one: `Fx32` rounds it otherwise than a cubic.
    #[doc(hidden)]
    #[inline]
    fn as_square(self) -> Option<Square> {
        None
    }
}
