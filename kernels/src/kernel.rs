//! What a kernel is, and who may come to see it.

use crate::{oracle, scene::Site, value::Value};

/// A function of one input, with the constants of one light.
pub trait Kernel: Copy {
    /// The exact input: the versine of the angle off axis for a falloff, a [`Site`] for a lit
    /// point.
    type Place: Copy;
    /// The input, rounded to the kernel's format.
    type Input: Copy;
    /// The answer in the kernel's format.
    type Output: Value;

    /// The nearest input for a place.
    fn input(&self, place: &Self::Place) -> Self::Input;

    /// The answer: this is what costs are counted of.
    fn evaluate(&self, input: &Self::Input) -> Self::Output;

    /// A word of an input: what a loop loads that does nothing.
    fn touch(input: &Self::Input) -> u32;

    /// Visits every input at which an error can be largest, with the exact place, where a format
    /// has so few that none has to be left out. Answers whether it has.
    fn bounds(&self, _visit: &mut dyn FnMut(Self::Input, f64)) -> bool {
        false
    }
}

/// How far a kernel goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stage {
    /// From the angle off axis to an intensity.
    Falloff,
    /// From a place and a normal to the light that arrives.
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
    /// How far it goes.
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

/// Who walks the list.
pub trait Visitor {
    /// A falloff, with the truth about it.
    fn falloff<K: Kernel<Place = f32>>(&mut self, row: Row, kernel: K, truth: &oracle::Falloff);

    /// A lit point, with the truth about it, at sites of the population.
    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &oracle::Point);

    /// A row whose format cannot hold the cone. `narrowest` is the half angle in degrees that it
    /// can.
    fn refused(&mut self, _row: Row, _narrowest: f32) {}
}
