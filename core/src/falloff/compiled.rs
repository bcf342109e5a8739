//! Falloffs compiled for a number format.

use crate::number::{Fraction, Scalar};

/// A [`Falloff`](super::Falloff) compiled for the format `S`, evaluated per point.
pub trait CompiledFalloff<S: Scalar>: Copy + PartialEq + core::fmt::Debug {
    /// Returns the intensity in [0, 1] at `t`.
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value;
}
