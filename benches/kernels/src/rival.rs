//! The alternatives of a user: falloffs of the field in f32, and lit points as one computes them without
//! the crate `luminaire`.
//!
//! Each lit point is a text of its own of the published law, or calls a crate. It gets the same points and
//! normals as the kernels, in the words of `Fx16` or in f32, and its light is a constant, too.

pub(crate) mod baked;
mod falloff;
pub(crate) mod float;
pub(crate) mod q15;
pub(crate) mod q16;
mod values;

pub use falloff::*;
pub use values::RANGE;

use crate::{
    kernel::Kernel,
    scene::{Population, Site},
};

/// A lit point of others, as a type for each.
pub trait Rival: Kernel<Place = Site> + 'static {
    /// The name on the price list.
    const NAME: &'static str;
    /// What it computes by.
    const WHAT: &'static str;
    /// Who would choose it, and why.
    const WHO: &'static str;
    /// Bytes of its tables.
    const TABLES: usize;
    /// Its distance law.
    const LAW: Law;
    /// The surface points that it lights.
    const POPULATION: Population;
    /// The light of the standard setting, whose costs are counted.
    const STANDARD: &'static Self;

    /// The light whose cone ends at this versine.
    fn ending_at(outer: f32) -> Self;
}

/// The fall of light with distance.
#[derive(Clone, Copy, Debug)]
pub enum Law {
    /// The inverse square.
    InverseSquare,
    /// `(1 - (d/r)^2)^n` up to the [range](RANGE), with this power.
    Window(f64),
}
