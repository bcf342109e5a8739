//! Blocks of pixels and their buffers.

use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::{Rgb, Scalar};

/// Number of pixels in a block: neighbouring pixels of a row that are lit together.
pub const LANES: usize = 32;

/// Light at the pixels of a block: linear, 1 is full scale.
pub(crate) type Lights<S> = [<S as Scalar>::Irradiance; LANES];

/// Light from the surfaces of a block's pixels, and from the air in front of them, towards the eye.
pub(crate) type Radiance<S> = Rgb<Lights<S>>;

/// Returns a vector of `count` equal values, or an error if there is no memory for the values.
pub(crate) fn filled<T: Clone>(count: usize, value: T) -> Result<Vec<T>, TryReserveError> {
    let mut values = Vec::new();
    values.try_reserve_exact(count)?;
    values.resize(count, value);
    Ok(values)
}
