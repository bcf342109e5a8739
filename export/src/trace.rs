//! The formulas of a falloff and of an attenuation, recorded from the kernel.
//!
//! The kernel evaluates a falloff by the operations of the trait [`Fraction`], and an attenuation by
//! those of [`Ray`] and [`Share`]. A [`Symbol`] implements these operations by recording them. So the
//! kernel's own code is the only place of a formula, and a falloff or an attenuation that is added to
//! the list of models is exported without more code.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::marker::PhantomData;

use luminaire::attenuation::{AnyAttenuation, Attenuation, WithAttenuation};
use luminaire::falloff::{AnyFalloff, CompiledFalloff, Falloff};
use luminaire::number::{Fraction, InversePower, Knot, Offset, Ray, RealExponent, Share, Types};
use luminaire::{Scalar, Vec3};

/// An operation on the results of earlier operations, which are given by their indices.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Operation<S: Types> {
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
    /// Two soft falloffs, `(1 - k) x^2 + k w^2` with `w = max(0, 1 - g (1 - x))`, by `k` and `g`.
    SoftPair(usize, S::Weight, S::Gain),
    /// The interpolation of evenly spaced samples at `1 - x`.
    Sample(usize, Vec<u16>),
    /// The line of a knot at `1 - x`.
    Along(usize, Vec<Knot>),
    /// The distance times a gain, at most 1.
    Near(S::Gain),
    /// The squared distance times a gain, at most 1.
    SquaredNear(S::Gain),
    /// The product of two shares.
    ShareOf(usize, usize),
    /// `x^2 (3 - 2x)` of a share.
    Smoothed(usize),
    /// A share of the intensity, as light.
    Give(usize),
    /// A share of the intensity, by the inverse square of the distance.
    InverseSquare(usize),
    /// A share of the intensity, by one over a polynomial of the distance.
    Polynomial(usize, [S::Gain; 3]),
    /// A share of the intensity, by a real power of the distance.
    Decay(usize, InversePower),
}

impl<S: Types> Operation<S> {
    /// Returns the indices of the operands.
    pub(crate) fn operands(&self) -> impl Iterator<Item = usize> {
        let (first, second) = match *self {
            Self::Argument | Self::Near(_) | Self::SquaredNear(_) => (None, None),
            Self::FineProduct(a, b) | Self::Product(a, b) | Self::Of(a, b) | Self::ShareOf(a, b) => {
                (Some(a), Some(b))
            }
            Self::Complement(a)
            | Self::RealPower(a, _)
            | Self::Scalar(a)
            | Self::Rest(a)
            | Self::Step(a)
            | Self::Smooth(a)
            | Self::Quadratic(a, _)
            | Self::Cubic(a, ..)
            | Self::SoftPair(a, ..)
            | Self::Sample(a, _)
            | Self::Along(a, _)
            | Self::Smoothed(a)
            | Self::Give(a)
            | Self::InverseSquare(a)
            | Self::Polynomial(a, _)
            | Self::Decay(a, _) => (Some(a), None),
        };
        first.into_iter().chain(second)
    }
}

/// The operations of a falloff or an attenuation in the format `S`, in the order in which the kernel computes them.
#[derive(Clone, Debug)]
pub(crate) struct Trace<S: Types> {
    /// The operations. The argument is that of the falloff, or the share that is attenuated.
    pub(crate) operations: Vec<Operation<S>>,
    /// The index of the result.
    pub(crate) result: usize,
    /// The index of an intensity without which the result is 0. An attenuation's is its share, and
    /// needs no test: no operation makes light of a share of 0.
    pub(crate) guard: Option<usize>,
    /// The indices of shares of which one is 1 where the result is 0.
    pub(crate) ends: Vec<usize>,
}

impl<S: Scalar> Trace<S> {
    /// Records a falloff.
    pub(crate) fn of(falloff: AnyFalloff) -> Self {
        let record = Record::default();
        let result = falloff.compile::<S>().intensity(record.push(Operation::Argument)).index();
        assert!(record.guards.borrow().len() <= 1, "a falloff compares once");
        record.finished(result)
    }

    /// Records the windows of an attenuation alone, and the whole attenuation.
    pub(crate) fn of_attenuation(attenuation: AnyAttenuation) -> [Self; 2] {
        attenuation.with(Attenuated(PhantomData))
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

/// Records an attenuation.
struct Attenuated<S>(PhantomData<S>);

impl<S: Scalar> WithAttenuation for Attenuated<S> {
    type Output = [Trace<S>; 2];

    fn attenuation<A: Attenuation>(self, attenuation: A) -> [Trace<S>; 2] {
        let constants = attenuation.constants::<S>();
        let nowhere = Vec3::default();
        let offset = S::Offset::between(nowhere, nowhere);
        let [windows, whole] = [Record::default(), Record::default()];
        let share = windows.push(Operation::Argument);
        let windowed = A::windowed::<S, _, _>(&constants, &offset, &windows.ray(), share).index();
        let share = whole.push(Operation::Argument);
        // The light itself is in the record, as the last operation.
        let _ = A::light::<S, _, _>(&constants, &offset, &whole.ray(), share, S::gain(1.0));
        let last = whole.operations.borrow().len() - 1;
        [windows.finished(windowed), whole.finished(last)]
    }
}

/// A trace while it is recorded.
#[derive(Debug)]
struct Record<S: Types> {
    operations: RefCell<Vec<Operation<S>>>,
    guards: RefCell<Vec<usize>>,
    ends: RefCell<Vec<usize>>,
}

impl<S: Types> Default for Record<S> {
    fn default() -> Self {
        Self { operations: RefCell::default(), guards: RefCell::default(), ends: RefCell::default() }
    }
}

impl<S: Types> Record<S> {
    fn push(&self, operation: Operation<S>) -> Symbol<'_, S> {
        let mut operations = self.operations.borrow_mut();
        operations.push(operation);
        Symbol::Result(self, operations.len() - 1)
    }

    /// A ray whose operations are recorded.
    fn ray(&self) -> Way<'_, S> {
        Way(self)
    }

    fn finished(self, result: usize) -> Trace<S> {
        let Self { operations, guards, ends } = self;
        let guard = guards.into_inner().first().copied();
        Trace { operations: operations.into_inner(), result, guard, ends: ends.into_inner() }
    }
}

/// The ray from a light to a point, whose operations are recorded.
#[derive(Clone, Copy, Debug)]
struct Way<'a, S: Types>(&'a Record<S>);

impl<'a, S: Types> Way<'a, S> {
    /// Records the light that arrives.
    fn ends_with(self, light: Operation<S>) -> S::Received {
        self.0.push(light);
        S::Received::default()
    }
}

impl<'a, S: Types> Ray<S> for Way<'a, S> {
    type Fraction = Symbol<'a, S>;
    type Share = Symbol<'a, S>;

    fn distance(&self) -> S::Gain {
        unreachable!("an attenuation computes with the operations of a ray")
    }

    fn direction(&self) -> Vec3<S::Direction> {
        unreachable!("an operation of cones")
    }

    fn rise(&self, _: Vec3<S::Direction>, _: S::Ramp) -> Symbol<'a, S> {
        unreachable!("an operation of cones")
    }

    fn cosine(&self, _: <S::Offset as Offset<S>>::Facing, _: Vec3<S>) -> Symbol<'a, S> {
        unreachable!("an operation of surfaces")
    }

    fn range_share(&self, gain: S::Gain) -> Symbol<'a, S> {
        self.0.push(Operation::Near(gain))
    }

    fn squared_range_share<O: Offset<S>>(&self, _: &O, gain: S::Gain) -> Symbol<'a, S> {
        self.0.push(Operation::SquaredNear(gain))
    }

    fn light(&self, share: Symbol<'a, S>, _: S::Gain) -> S::Received {
        self.ends_with(Operation::InverseSquare(share.index()))
    }

    fn light_by_polynomial(
        &self,
        share: Symbol<'a, S>,
        coefficients: &[S::Gain; 3],
        _: S::Gain,
    ) -> S::Received {
        self.ends_with(Operation::Polynomial(share.index(), *coefficients))
    }

    fn light_by_decay(&self, share: Symbol<'a, S>, power: InversePower, _: S::Gain) -> S::Received {
        self.ends_with(Operation::Decay(share.index(), power))
    }
}

/// The result of a recorded operation, or the constant 0.
#[derive(Clone, Copy, Default, Debug)]
enum Symbol<'a, S: Types> {
    #[default]
    Zero,
    Result(&'a Record<S>, usize),
}

impl<'a, S: Types> Symbol<'a, S> {
    fn index(self) -> usize {
        self.parts().1
    }

    fn parts(self) -> (&'a Record<S>, usize) {
        match self {
            Self::Result(record, index) => (record, index),
            Self::Zero => unreachable!("within its limits a formula depends on its argument"),
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

impl<S: Types> PartialEq for Symbol<'_, S> {
    fn eq(&self, _: &Self) -> bool {
        false
    }
}

/// A formula may test whether an intensity is above 0, and be 0 otherwise. The recorded branch is
/// the one above 0; the test becomes the guard.
impl<S: Types> PartialOrd for Symbol<'_, S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let (record, index) = self.parts();
        assert!(matches!(other, Self::Zero), "a formula compares an intensity with 0 alone");
        record.guards.borrow_mut().push(index);
        Some(Ordering::Greater)
    }
}

impl<S: Types> Fraction<S> for Symbol<'_, S> {
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

    fn soft_pair(self, share: S::Weight, ratio: S::Gain) -> Self {
        self.record(|x| Operation::SoftPair(x, share, ratio))
    }

    fn sample(self, samples: &[u16]) -> Self {
        self.record(|x| Operation::Sample(x, samples.to_vec()))
    }

    fn sample_knots(self, knots: &[Knot]) -> Self {
        self.record(|x| Operation::Along(x, knots.to_vec()))
    }
}

/// The operations on intensities, and on the shares of an attenuation.
impl<S: Types> Share<S> for Symbol<'_, S> {
    fn complement(self) -> Self {
        self.record(Operation::Rest)
    }

    fn of_scalar(_: S) -> Self {
        unreachable!("shares begin with the cosine")
    }

    fn scalar(self) -> S {
        unreachable!("an operation after the formula")
    }

    /// A formula may be 0 where a share is 1. The recorded branch is the other one.
    fn is_one(self) -> bool {
        let (record, index) = self.parts();
        record.ends.borrow_mut().push(index);
        false
    }

    fn times(self, other: Self) -> Self {
        self.record_with(other, Operation::ShareOf)
    }

    fn smooth(self) -> Self {
        self.record(Operation::Smoothed)
    }

    fn light(self, _: S::Gain) -> S::Received {
        let (record, index) = self.parts();
        record.push(Operation::Give(index));
        S::Received::default()
    }
}
