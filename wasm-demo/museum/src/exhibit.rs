//! A faulty formula, its source and its control.

use luminaire::Error;

use crate::beam::Beam;

/// An exhibit of the museum.
#[derive(Clone, Copy, Debug)]
pub struct Exhibit {
    /// The name in addresses.
    pub name: &'static str,
    /// A few words for lists.
    pub label: &'static str,
    /// What breaks, in one sentence.
    pub title: &'static str,
    /// Where the formula is from.
    pub source: Source,
    /// The formula as published, abridged to the lines at fault.
    pub code: &'static str,
    /// Why the formula fails.
    pub cause: &'static str,
    /// The case in which the crate is no better.
    pub no_better: &'static str,
    /// A value of the control at which both pictures are within a code of the truth, if there is
    /// one.
    pub agrees_at: Option<f32>,
    /// What the visitor changes.
    pub control: Control,
    /// The errors at the start of the control.
    pub bounds: Bounds,
    /// The beam at a value of the control.
    pub beam: fn(f32) -> Result<Beam, Error>,
}

/// Where a formula was published.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Source {
    /// The project.
    pub project: &'static str,
    /// The file, or the document.
    pub file: &'static str,
    /// The version, or for how long the formula was in use.
    pub version: &'static str,
    /// The licence of the file.
    pub licence: &'static str,
    /// The thread about the fault; empty if none is known.
    pub thread: &'static str,
}

/// The control of an exhibit.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Control {
    /// What is controlled.
    pub label: &'static str,
    /// The unit; empty for a number.
    pub unit: &'static str,
    /// The least value.
    pub least: f32,
    /// The largest value.
    pub most: f32,
    /// The value at which the exhibit opens: the named case.
    pub start: f32,
    /// Whether the slider is logarithmic.
    pub is_logarithmic: bool,
}

impl Control {
    /// A control with a linear slider, from the least value over that of the start to the largest.
    pub(crate) const fn linear(label: &'static str, unit: &'static str, range: [f32; 3]) -> Self {
        let [least, start, most] = range;
        Self { label, unit, least, most, start, is_logarithmic: false }
    }

    /// A control with a logarithmic slider, from the least value over that of the start to the largest.
    pub(crate) const fn logarithmic(label: &'static str, unit: &'static str, range: [f32; 3]) -> Self {
        Self { is_logarithmic: true, ..Self::linear(label, unit, range) }
    }
}

/// Bounds of the largest errors over the pixels of a picture of 100 x 100 pixels at the start of
/// the control, in linear codes. They are exhaustive over these points.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bounds {
    /// The error of the faulty formula is at least this; infinite if some points are NaN.
    pub faulty: f64,
    /// The error of the crate is at most this.
    pub ours: f64,
}
