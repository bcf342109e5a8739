//! Width of a block and its arrays of light.

use luminaire::{Rgb, Scalar};

/// Number of pixels of a row in a block.
pub(crate) const LANES: usize = 32;

/// Light from the pixels of a block towards the eye: linear, 1 is full scale.
pub(crate) type Radiance = Rgb<[f32; LANES]>;

/// Irradiance at the pixels of a block.
pub(crate) type Lights<S> = [<S as Scalar>::Irradiance; LANES];
