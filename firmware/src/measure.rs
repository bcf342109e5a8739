//! Running kernels over inputs between the markers.

use crate::board::{begin, end, opaque, println};
use crate::checksum::{Bits, fold};

/// Inputs in a number format, over which kernels are run.
///
/// Each run prints a line: the format, the name of the kernel, the name of the inputs, the number of calls, and a
/// checksum of the results.
#[derive(Debug)]
pub struct Inputs<'a, I> {
    format: &'static str,
    name: &'static str,
    all: &'a [I],
}

impl<'a, I> Inputs<'a, I> {
    /// Names the inputs, and runs the empty loop over them, under their own name: what its instructions are, is no
    /// kernel's. `touch` should cost nothing but a load.
    #[inline(always)]
    pub fn new<O: Bits>(
        format: &'static str,
        name: &'static str,
        all: &'a [I],
        touch: impl Fn(&I) -> O,
    ) -> Self {
        let inputs = Self { format, name, all };
        inputs.run(name, touch);
        inputs
    }

    /// Runs a kernel over the inputs.
    #[inline(always)]
    pub fn run<O: Bits>(&self, kernel: &str, function: impl Fn(&I) -> O) {
        report(self.format, kernel, self.name, self.all.len(), pass(self.all, function));
    }
}

#[inline(never)]
fn report(format: &str, kernel: &str, inputs: &str, calls: usize, sum: u32) {
    println!("{format} {kernel} {inputs} {calls} {sum:08x}");
}

/// The loop: for each kernel a function of its own, so that none disturbs another.
#[inline(never)]
fn pass<I, O: Bits>(inputs: &[I], function: impl Fn(&I) -> O) -> u32 {
    begin();
    let mut sum = 0;
    for input in inputs {
        sum = fold(sum, function(opaque(input)));
    }
    end();
    sum
}
