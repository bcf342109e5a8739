//! The pixels of a row that are lit at once.

use luminaire::{Rgb, Scalar};

/// How many pixels of a row make a block.
pub(crate) const LANES: usize = 32;

/// The light that the pixels of a block send to the eye: linear, 1 is full scale.
pub(crate) type Radiance = Rgb<[f32; LANES]>;

/// Light at the pixels of a block.
pub(crate) type Lights<S> = [<S as Scalar>::Irradiance; LANES];
