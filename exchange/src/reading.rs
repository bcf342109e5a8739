//! What may be lost of measured intensities.

/// How measured intensities become a light.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Reading {
    /// The largest difference in linear codes, in [0, 255], at which a cheaper cone takes the place of a light's
    /// table, and the mean of all planes that of a plane. A plane that differs by up to 1 is one of a round light.
    pub fit: f64,
    /// Whether the mean of all planes is taken whatever their difference.
    pub is_round: bool,
    /// The size of the table of a light that is not round, 3, 5, 9, 17, 33, 65, 129 or 257; `None` for the smallest up to 65
    /// whose samples are within the fit of the file.
    pub size: Option<u32>,
    /// How to have the mean nevertheless, at the end of the refusal of planes that differ.
    pub remedy: &'static str,
}

impl Default for Reading {
    fn default() -> Self {
        Self { fit: 1.0, is_round: false, size: None, remedy: "" }
    }
}
