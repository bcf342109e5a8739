//! Falloffs in a number format.

use crate::number::{Fraction, Scalar};

/// A [`Falloff`](super::Falloff) in the format `S`: what is evaluated per point.
pub trait Curve<S: Scalar>: Copy + PartialEq + core::fmt::Debug {
    /// The intensity at `t`, in [0, 1].
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value;
}
