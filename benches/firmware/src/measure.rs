//! Running kernels over inputs between the markers.

use core::array;

use luminaire_kernels::scene::{Site, Sites};
use luminaire_kernels::{
    Kernel, Rival, RivalVisitor, Row, Setting, Value, Visitor, doubles, falloffs, oracle, truth::Point,
};

use crate::board::{begin, end, opaque, println};

/// Number of inputs that each kernel is run over.
pub const COUNT: usize = 256;

/// Runs every falloff of the price list, every method of others, and the points in `f64` over their
/// inputs.
///
/// Each run prints a line, `name sum bits`, with a checksum of the results. Before each kernel runs the
/// empty loop over the same inputs, whose instructions are subtracted from the kernel's.
pub fn measure() {
    let setting = Setting::standard();
    let mut bench = Bench { outer: setting.outer_versine() };
    begin_lines();
    falloffs(setting, &mut bench);
    doubles(setting, &mut bench);
}

/// Prints the first line: the number of inputs.
pub fn begin_lines() {
    println!("calls {COUNT} inputs");
}

struct Bench {
    /// The versine of the outer angle.
    outer: f32,
}

// Never inlined: the smallest board's memory holds a single table of inputs.
impl Visitor for Bench {
    /// The inputs are versines between the axis and the edge, both excluded.
    #[inline(never)]
    fn falloff<K: Kernel<Place = f32>>(&mut self, row: Row, kernel: K, _: &oracle::Cone) {
        let versine = |index| self.outer * ((index as f32 + 0.5) / COUNT as f32);
        run(row, &kernel, &array::from_fn(|index| kernel.input(&versine(index))));
    }

    #[inline(never)]
    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &Point) {
        let mut site = Sites::new(truth.population, truth.light.cone.outer as f32);
        run(row, &kernel, &array::from_fn(|_| kernel.input(&site.next().expect("an endless sequence"))));
    }
}

/// Runs the lit points of others over their inputs, in the same way. Their lights are constants, as those of
/// the other lit points.
#[inline]
pub fn rivals() {
    begin_lines();
    luminaire_kernels::rivals(Setting::standard(), &mut Constants);
}

struct Constants;

impl RivalVisitor for Constants {
    #[inline(never)]
    fn rival<R: Rival>(&mut self, row: Row, truth: &Point) {
        let rival = R::STANDARD;
        let mut site = Sites::new(truth.population, truth.light.cone.outer as f32);
        let inputs: [R::Input; COUNT] =
            array::from_fn(|_| rival.input(&site.next().expect("an endless sequence")));
        report("empty", row.format, pass(&inputs, R::touch));
        report(row.kernel, row.format, pass(&inputs, |input| rival.evaluate(input).bits()));
    }
}

#[inline(always)]
fn run<K: Kernel>(row: Row, kernel: &K, inputs: &[K::Input; COUNT]) {
    let kernel = opaque(kernel);
    report("empty", row.format, pass(inputs, |input| K::touch(input)));
    report(row.kernel, row.format, pass(inputs, |input| kernel.evaluate(input).bits()));
}

/// Prints the checksum of a kernel's results.
#[inline(never)]
pub fn report(kernel: &str, format: &str, sum: u32) {
    println!("{kernel}.{format} {sum:08x} bits");
}

/// The loop over the inputs. Not inlined: each kernel has its own copy, so that no kernel affects
/// the code of another.
#[inline(never)]
pub fn pass<I>(inputs: &[I], function: impl Fn(&I) -> u32) -> u32 {
    begin();
    let mut sum: u32 = 0;
    for input in inputs {
        sum = sum.wrapping_mul(3) ^ function(opaque(input));
    }
    end();
    sum
}
