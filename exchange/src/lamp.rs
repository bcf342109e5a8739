//! A light that was read.

use luminaire::dynamic::AnyLight;
use luminaire::import::Difference;

use crate::curve::Curve;

/// A light of a file or of a command, as a light of [`luminaire`].
#[derive(Clone, PartialEq, Debug)]
pub struct Lamp {
    /// The name in the file; not unique, and not an identifier.
    pub name: String,
    /// The light. Its intensity is that of the source: candela, where the source has candela.
    pub light: AnyLight,
    /// The largest difference between the light and that of the source.
    pub difference: Difference,
    /// The measured intensities, of a photometric file or of the numbers of a data sheet.
    pub measured: Option<Curve>,
    /// The light of the widest zoom, of a fixture with one. `light` is that of the narrowest.
    pub widest: Option<AnyLight>,
    /// The nearest and the farthest surface, where the source says so.
    pub surfaces: Option<[f32; 2]>,
    /// What was assumed or left out, a sentence each.
    pub notes: Vec<String>,
}

/// The lights of one input.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Lamps {
    /// The lights, in the order of the file.
    pub lamps: Vec<Lamp>,
    /// The lights of the file that could not be read.
    pub refused: Vec<crate::Refusal>,
    /// What holds for the whole file, a sentence each.
    pub notes: Vec<String>,
}
