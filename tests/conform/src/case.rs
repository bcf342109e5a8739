//! One case: its inputs, which a model reads by name, and its outputs.

use core::fmt::Write;

use luminaire::{Error, Rgb, Vec3};

use crate::text::Text;
use crate::word::{Format, Word};

/// The kind of an input.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A number of a light's or material's description, in f32.
    Number,
    /// A whole number.
    Whole,
    /// A scalar of the format.
    Scalar,
    /// A coordinate of the format.
    Length,
    /// A component of a direction in the format.
    Unit,
    /// A versine in the scale of a cone.
    Versine,
    /// Light that has arrived.
    Light,
}

/// An input of a model.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Input {
    /// The name of the input, such as `position`.
    pub name: &'static str,
    /// The index of the component, 0 to 2: x, y, z or red, green, blue.
    pub component: usize,
    /// The kind of the input.
    pub kind: Kind,
    /// The name of the format that the word is stored in.
    pub format: &'static str,
    /// The number of hexadecimal digits of the word.
    pub digits: usize,
}

/// The source of the inputs: the words of a line, or a generator.
pub trait Inputs {
    /// Returns the next input as a word, or `None` if there is no further one.
    fn word(&mut self, input: Input) -> Option<u64>;
}

/// A case that is being evaluated. A model reads all its inputs before it calls a constructor that
/// may refuse them, so that all lines of a section have the same number of words.
pub struct Case<'a> {
    inputs: &'a mut dyn Inputs,
    pub(crate) outputs: Text,
    pub(crate) is_complete: bool,
}

impl core::fmt::Debug for Case<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Case").field("outputs", &self.outputs.as_str()).finish_non_exhaustive()
    }
}

impl<'a> Case<'a> {
    /// Evaluates a model on inputs. Returns its outputs as words, or the name of the parameter that
    /// was refused, or `None` if inputs are missing.
    pub fn run(evaluate: Evaluate, inputs: &'a mut dyn Inputs) -> Option<Text> {
        let mut case = Case { inputs, outputs: Text::default(), is_complete: true };
        if let Err(error) = evaluate(&mut case) {
            case.outputs = Text::default();
            // Writing into memory does not fail.
            let _ = write!(case.outputs, "refused: {}", error.parameter);
        }
        case.is_complete.then_some(case.outputs)
    }

    fn input<T: Word>(&mut self, name: &'static str, component: usize, kind: Kind) -> T {
        let word = self.inputs.word(Input { name, component, kind, format: T::NAME, digits: T::DIGITS });
        self.is_complete &= word.is_some();
        T::from_word(word.unwrap_or_default())
    }

    fn vector_of<T: Word>(&mut self, name: &'static str, kind: Kind) -> Vec3<T> {
        let mut component = |index| self.input(name, index, kind);
        Vec3::new(component(0), component(1), component(2))
    }

    /// A number of a description.
    pub(crate) fn number(&mut self, name: &'static str) -> f32 {
        self.input(name, 0, Kind::Number)
    }

    /// A vector of a description.
    pub(crate) fn vector(&mut self, name: &'static str) -> Vec3<f32> {
        self.vector_of(name, Kind::Number)
    }

    /// A colour of a description.
    pub(crate) fn color(&mut self, name: &'static str) -> Rgb<f32> {
        let Vec3 { x, y, z } = self.vector(name);
        Rgb::new(x, y, z)
    }

    /// A whole number.
    pub(crate) fn whole(&mut self, name: &'static str) -> u32 {
        self.input(name, 0, Kind::Whole)
    }

    /// A scalar.
    pub(crate) fn scalar<S: Format>(&mut self, name: &'static str) -> S {
        self.input(name, 0, Kind::Scalar)
    }

    /// A normal.
    pub(crate) fn normal<S: Format>(&mut self, name: &'static str) -> Vec3<S> {
        self.vector_of(name, Kind::Scalar)
    }

    /// A point.
    pub(crate) fn point<S: Format>(&mut self, name: &'static str) -> Vec3<S::Length> {
        self.vector_of(name, Kind::Length)
    }

    /// A direction.
    pub(crate) fn direction<S: Format>(&mut self, name: &'static str) -> Vec3<S::Unit> {
        self.vector_of(name, Kind::Unit)
    }

    /// A versine.
    pub(crate) fn versine<S: Format>(&mut self, name: &'static str) -> S::Versine {
        self.input(name, 0, Kind::Versine)
    }

    /// Light of three channels.
    pub(crate) fn light<S: Format>(&mut self, name: &'static str) -> Rgb<S::Irradiance> {
        let Vec3 { x, y, z } = self.vector_of(name, Kind::Light);
        Rgb::new(x, y, z)
    }

    /// An output.
    pub(crate) fn give(&mut self, value: impl Word) {
        fn digits<T: Word>(_: T) -> usize {
            T::DIGITS
        }
        self.outputs.push_word(value.word(), digits(value));
    }

    /// A colour as an output.
    pub(crate) fn give_color(&mut self, color: Rgb<impl Word>) {
        for channel in [color.red, color.green, color.blue] {
            self.give(channel);
        }
    }
}

/// The result of a model: `Ok` if its outputs are in the case, or the error of a constructor that
/// refused an input.
pub(crate) type Outcome = Result<(), Error>;

/// Evaluates a model: reads the inputs of a case and adds its outputs.
pub type Evaluate = fn(&mut Case<'_>) -> Outcome;
