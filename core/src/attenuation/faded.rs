//! Any distance model, faded out to a range.

use super::{Attenuation, checked_range, dimmed, inverse_squared, squared_fraction, window};
use crate::{
    error::Error,
    scalar::{Ray, Scalar, Share},
};

/// Another model in the squared window `(1 - (d/r)^4)^2`, which ends it at a range without a rim: of the
/// inverse-square law that is [`SquaredWindow`](crate::SquaredWindow), to the bit.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Faded<A> {
    attenuation: A,
    range: Option<f32>,
}

impl<A: Attenuation> Faded<A> {
    /// The model, faded out to this range, in units of the world's length; without one it is the model alone.
    ///
    /// # Errors
    /// A range outside 0.001 to 1e9.
    pub fn new(attenuation: A, range: Option<f32>) -> Result<Self, Error> {
        Ok(Self { attenuation, range: range.map(checked_range).transpose()? })
    }

    /// The model that is faded out.
    pub fn attenuation(&self) -> A {
        self.attenuation
    }

    /// Where the light ends, if it does.
    pub fn range(&self) -> Option<f32> {
        self.range
    }
}

impl<A: Attenuation> Attenuation for Faded<A> {
    /// The reciprocal of the squared range, and the model's.
    type Constants<S: Scalar> = (S::Gain, A::Constants<S>);

    fn constants<S: Scalar>(self) -> Self::Constants<S> {
        (inverse_squared::<S>(self.range), self.attenuation.constants::<S>())
    }

    fn grows(&self) -> bool {
        self.attenuation.grows()
    }

    #[inline(always)]
    fn is_beyond<S: Scalar>((squared, inner): &Self::Constants<S>, offset: &S::Offset) -> bool {
        squared_fraction::<S>(*squared, offset) == S::ONE || A::is_beyond::<S>(inner, offset)
    }

    #[inline(always)]
    fn expose<S: Scalar, R: Ray<S>>(
        (squared, inner): &Self::Constants<S>,
        offset: &S::Offset,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        let window = window::<S, R>(*squared, offset, ray);
        A::expose::<S, R>(inner, offset, ray, dimmed::<S, _>(share, window.share_of(window)), intensity)
    }
}
