//! What may be lost of measured intensities.

/// How measured intensities become a light with rotational symmetry.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Reading {
    /// The largest difference in linear codes, in [0, 255], at which a cheaper cone takes the place of a light's
    /// table, and the mean of all planes that of a plane. A plane that differs by up to 1 is one of a round light.
    pub fit: f64,
    /// Whether the mean of all planes is taken whatever their difference.
    pub is_round: bool,
    /// How to have the mean nevertheless, at the end of the refusal of planes that differ.
    pub remedy: &'static str,
}

impl Default for Reading {
    fn default() -> Self {
        Self { fit: 1.0, is_round: false, remedy: "" }
    }
}
