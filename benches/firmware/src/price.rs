//! Running effects over inputs between the markers.

use luminaire::Scalar;
use luminaire_effects::{Entry, Format, Input, Inputs, Output, Visit, each, each_choice, each_evaluation};

use crate::COUNT;
use crate::measure::{begin_lines, pass, report};

/// Runs every effect over its inputs, after the empty loop over the same inputs, and prints lines as
/// [`measure`](crate::measure()) does.
pub fn price() {
    begin_lines();
    each(&mut Run);
}

/// Runs the lit points of the price list that are no effects. They have a program of their own, because the
/// compiler inlines a function less that more effects share.
pub fn evaluations() {
    begin_lines();
    each_evaluation(&mut Run);
}

/// Runs the lit points that have one model each of the library's lists, in a program of their own for the same
/// reason. Inlined, because this crate would inline the functions above less if it compiled these points
/// (`lit-cut-at` on Cortex-M0: -2 instructions).
#[inline]
pub fn choices() {
    begin_lines();
    each_choice(&mut Run);
}

/// Runs effects over inputs of their kind.
struct Run;

impl Visit for Run {
    // Never inlined: the smallest board's memory holds a single table of inputs.
    #[inline(never)]
    fn effect<I: Input, O: Output>(
        &mut self,
        entry: Entry,
        next: fn(&mut Inputs) -> I,
        effect: impl Fn(I) -> O,
    ) {
        let mut sequence = Inputs::default();
        let mut inputs = [next(&mut sequence); COUNT];
        for input in &mut inputs[1..] {
            *input = next(&mut sequence);
        }
        report("empty", Format::NAME, pass(&inputs, I::word));
        report(entry.name, Format::NAME, pass(&inputs, |input| effect(*input).fold()));
    }
}
