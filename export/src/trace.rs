//! The formula of a falloff, recorded from the kernel.
//!
//! The kernel evaluates a falloff by the operations of the trait [`Fraction`]. A [`Symbol`]
//! implements these operations by recording them. So the kernel's own code is the only place of a
//! formula, and a falloff that is added to the list of models is exported without more code.

use std::cell::RefCell;
use std::cmp::Ordering;

use luminaire::Scalar;
use luminaire::falloff::{AnyFalloff, Curve, Falloff};
use luminaire::number::{Arithmetic, Fraction, Knot, RealExponent, Share};

/// An operation on the results of earlier operations, which are given by their indices.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Operation<S: Arithmetic> {
    /// The falloff's argument.
    Argument,
    /// `1 - x` of a fraction.
    Complement(usize),
    /// The product of two fractions, as a fraction.
    FineProduct(usize, usize),
    /// The product of two fractions, as an intensity.
    Product(usize, usize),
    /// A power of a fraction. The exponent is `mantissa / 2^shift`; see [`RealExponent::to_bits`].
    RealPower(usize, [u32; 4]),
    /// A fraction as an intensity.
    Scalar(usize),
    /// A fraction of an intensity.
    Of(usize, usize),
    /// `1 - x` of an intensity.
    Rest(usize),
    /// 1 for a fraction above 0.
    Step(usize),
    /// `x^2 (3 - 2x)`.
    Smooth(usize),
    /// `x (1 + (1 - x) g)`.
    Quadratic(usize, S::Weight),
    /// `x (1 + (1 - x) (g + h x))`.
    Cubic(usize, S::Weight, S::Weight),
    /// The interpolation of evenly spaced samples at `1 - x`.
    Sample(usize, Vec<u16>),
    /// The line of a knot at `1 - x`.
    Along(usize, Vec<Knot>),
}

impl<S: Arithmetic> Operation<S> {
    /// Returns the indices of the operands.
    pub(crate) fn operands(&self) -> impl Iterator<Item = usize> {
        let (first, second) = match *self {
            Self::Argument => (None, None),
            Self::FineProduct(a, b) | Self::Product(a, b) | Self::Of(a, b) => (Some(a), Some(b)),
            Self::Complement(a)
            | Self::RealPower(a, _)
            | Self::Scalar(a)
            | Self::Rest(a)
            | Self::Step(a)
            | Self::Smooth(a)
            | Self::Quadratic(a, _)
            | Self::Cubic(a, ..)
            | Self::Sample(a, _)
            | Self::Along(a, _) => (Some(a), None),
        };
        first.into_iter().chain(second)
    }
}

/// The operations of a falloff in the format `S`, in the order in which the kernel computes them.
#[derive(Clone, Debug)]
pub(crate) struct Trace<S: Arithmetic> {
    /// The operations.
    pub(crate) operations: Vec<Operation<S>>,
    /// The index of the result.
    pub(crate) result: usize,
    /// The index of an intensity without which the result is 0.
    pub(crate) guard: Option<usize>,
}

impl<S: Scalar> Trace<S> {
    /// Records a falloff.
    pub(crate) fn of(falloff: AnyFalloff) -> Self {
        let record = Record::default();
        let result = falloff.compile::<S>().intensity(record.push(Operation::Argument)).index();
        let Record { operations, guard } = record;
        Self { operations: operations.into_inner(), result, guard: guard.into_inner() }
    }

    /// Returns how often each result is used.
    pub(crate) fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.operations.len()];
        for operand in self.operations.iter().flat_map(Operation::operands) {
            uses[operand] += 1;
        }
        uses
    }
}

/// A trace while it is recorded.
#[derive(Debug)]
struct Record<S: Arithmetic> {
    operations: RefCell<Vec<Operation<S>>>,
    guard: RefCell<Option<usize>>,
}

impl<S: Arithmetic> Default for Record<S> {
    fn default() -> Self {
        Self { operations: RefCell::default(), guard: RefCell::default() }
    }
}

impl<S: Arithmetic> Record<S> {
    fn push(&self, operation: Operation<S>) -> Symbol<'_, S> {
        let mut operations = self.operations.borrow_mut();
        operations.push(operation);
        Symbol::Result(self, operations.len() - 1)
    }
}

/// The result of a recorded operation, or the constant 0.
#[derive(Clone, Copy, Default, Debug)]
enum Symbol<'a, S: Arithmetic> {
    #[default]
    Zero,
    Result(&'a Record<S>, usize),
}

impl<'a, S: Arithmetic> Symbol<'a, S> {
    fn index(self) -> usize {
        self.parts().1
    }

    fn parts(self) -> (&'a Record<S>, usize) {
        match self {
            Self::Result(record, index) => (record, index),
            Self::Zero => unreachable!("within the cone a falloff depends on its argument"),
        }
    }

    fn record(self, operation: impl FnOnce(usize) -> Operation<S>) -> Self {
        let (record, index) = self.parts();
        record.push(operation(index))
    }

    fn record_with(self, other: Self, operation: impl FnOnce(usize, usize) -> Operation<S>) -> Self {
        self.record(|index| operation(index, other.index()))
    }
}

impl<S: Arithmetic> PartialEq for Symbol<'_, S> {
    fn eq(&self, _: &Self) -> bool {
        false
    }
}

/// A falloff may test whether an intensity is above 0, and be 0 otherwise. The recorded branch is
/// the one above 0; the test becomes the guard.
impl<S: Arithmetic> PartialOrd for Symbol<'_, S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let (record, index) = self.parts();
        assert!(matches!(other, Self::Zero), "a falloff compares an intensity with 0 alone");
        let before = record.guard.replace(Some(index));
        assert!(before.is_none(), "a falloff compares once");
        Some(Ordering::Greater)
    }
}

impl<S: Arithmetic> Fraction<S> for Symbol<'_, S> {
    type Value = Self;

    fn complement(self) -> Self {
        self.record(Operation::Complement)
    }

    fn times(self, other: Self) -> Self {
        self.record_with(other, Operation::FineProduct)
    }

    fn times_to_value(self, other: Self) -> Self {
        self.record_with(other, Operation::Product)
    }

    fn real_power(self, exponent: RealExponent) -> Self {
        self.record(|x| Operation::RealPower(x, exponent.to_bits()))
    }

    fn value(self) -> Self {
        self.record(Operation::Scalar)
    }

    fn times_value(self, value: Self) -> Self {
        self.record_with(value, Operation::Of)
    }

    fn step(self) -> Self {
        self.record(Operation::Step)
    }

    fn smooth(self) -> Self {
        self.record(Operation::Smooth)
    }

    fn quadratic(self, g: S::Weight) -> Self {
        self.record(|x| Operation::Quadratic(x, g))
    }

    fn cubic(self, g: S::Weight, h: S::Weight) -> Self {
        self.record(|x| Operation::Cubic(x, g, h))
    }

    fn sample(self, samples: &[u16]) -> Self {
        self.record(|x| Operation::Sample(x, samples.to_vec()))
    }

    fn along(self, knots: &[Knot]) -> Self {
        self.record(|x| Operation::Along(x, knots.to_vec()))
    }
}

/// The operations on intensities. A falloff ends with an intensity and computes with
/// [`Share::complement`] alone.
impl<S: Arithmetic> Share<S> for Symbol<'_, S> {
    fn complement(self) -> Self {
        self.record(Operation::Rest)
    }

    fn of_scalar(_: S) -> Self {
        unreachable!("an operation of attenuations")
    }

    fn scalar(self) -> S {
        unreachable!("an operation of attenuations")
    }

    fn is_one(self) -> bool {
        unreachable!("an operation of attenuations")
    }

    fn times(self, _: Self) -> Self {
        unreachable!("an operation of attenuations")
    }

    fn smooth(self) -> Self {
        unreachable!("an operation of attenuations")
    }

    fn light(self, _: S::Gain) -> S::Received {
        unreachable!("an operation of attenuations")
    }
}
