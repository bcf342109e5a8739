//! Kernels, the rows of the price list, and visitors of the list.

use luminaire_oracle::Cone;

use crate::{scene::Site, truth::Point, value::Value};

/// A function of one input, with the constants of one light.
pub trait Kernel: Copy {
    /// The exact input: the versine of the angle off axis for a falloff, a [`Site`] for a lit
    /// point.
    type Place: Copy;
    /// The input, rounded to the kernel's format.
    type Input: Copy;
    /// The result in the kernel's format.
    type Output: Value;

    /// Rounds an exact input to the format.
    fn input(&self, place: &Self::Place) -> Self::Input;

    /// Returns the result. The costs are those of this function.
    fn evaluate(&self, input: &Self::Input) -> Self::Output;

    /// Returns a word of an input: the empty loop loads only this.
    fn touch(input: &Self::Input) -> u32;

    /// Visits every input at which an error can be largest, with the exact input, if the format
    /// has few enough to visit them all. Returns whether it visited them.
    fn bounds(&self, _visit: &mut dyn FnMut(Self::Input, f64)) -> bool {
        false
    }
}

/// The part of the light that a kernel computes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stage {
    /// From the angle off axis to an intensity.
    Falloff,
    /// From a position and a normal to the irradiance.
    Lit,
}

impl Stage {
    /// The name on the price list.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Falloff => "falloff",
            Self::Lit => "lit",
        }
    }
}

/// A line of the price list. Names have no spaces.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Row {
    /// The model.
    pub kernel: &'static str,
    /// The stage.
    pub stage: Stage,
    /// The number format, or `rival`.
    pub format: &'static str,
}

impl Row {
    pub(crate) const fn falloff(kernel: &'static str, format: &'static str) -> Self {
        Self { kernel, stage: Stage::Falloff, format }
    }

    pub(crate) const fn lit(kernel: &'static str, format: &'static str) -> Self {
        Self { kernel, stage: Stage::Lit, format }
    }
}

/// A visitor of the list.
pub trait Visitor {
    /// Visits a falloff with its exact model.
    fn falloff<K: Kernel<Place = f32>>(&mut self, row: Row, kernel: K, truth: &Cone);

    /// Visits a lit point with its exact model, at sites of the population.
    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &Point);

    /// Visits a row whose format cannot hold the cone. `narrowest` is the narrowest half angle in
    /// degrees that it holds.
    fn refused(&mut self, _row: Row, _narrowest: f32) {}
}
