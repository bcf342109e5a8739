//! The times of the kernels, by a clock.

use std::hint::black_box;

use luminaire_kernels::scene::{Site, Sites};
use luminaire_kernels::{
    Kernel, Row, Setting, Value, Visitor, falloffs, oracle, points, rivals, truth::Point,
};

use crate::Lines;

/// Number of inputs in a batch, which a kernel evaluates from memory to memory.
pub const BATCH: usize = 4096;

/// Number of times that are measured. Their median counts.
const SAMPLES: usize = 41;

/// A clock and its resolution.
pub trait Clock {
    /// Nanoseconds since a fixed but arbitrary moment.
    fn now(&self) -> f64;
    /// The shortest time in nanoseconds that the clock measures well.
    fn shortest(&self) -> f64;
}

/// Times the kernel of this number. Returns lines: nanoseconds a call, the median and the quartiles, and a
/// checksum of the results. Empty if there is no such kernel.
pub fn time(number: usize, clock: &impl Clock) -> String {
    let setting = Setting::standard();
    let outer = setting.outer_versine();
    let mut stopwatch = Stopwatch { clock, outer, wanted: number, seen: 0, lines: Lines::default() };
    falloffs(setting, &mut stopwatch);
    points(setting, &mut stopwatch);
    rivals(setting, &mut stopwatch);
    stopwatch.lines.0
}

struct Stopwatch<'a, C> {
    clock: &'a C,
    /// The versine where the cone ends.
    outer: f32,
    wanted: usize,
    seen: usize,
    lines: Lines,
}

impl<C: Clock> Stopwatch<'_, C> {
    fn is_wanted(&mut self) -> bool {
        self.seen += 1;
        self.seen - 1 == self.wanted
    }

    fn time<K: Kernel>(&mut self, row: Row, kernel: &K, inputs: &[K::Input]) {
        let mut outputs: Vec<_> = inputs.iter().map(|input| kernel.evaluate(input)).collect();
        let sum = outputs.iter().fold(0, |sum: u32, output| sum.wrapping_mul(3) ^ output.bits());
        // Doubles the number of batches until the clock resolves their time.
        let mut batches = 1;
        while self.lapse(kernel, inputs, &mut outputs, batches) < self.clock.shortest() {
            batches *= 2;
        }
        let calls = (batches * inputs.len()) as f64;
        let mut samples: Vec<_> =
            (0..SAMPLES).map(|_| self.lapse(kernel, inputs, &mut outputs, batches) / calls).collect();
        samples.sort_by(f64::total_cmp);
        for (index, unit) in [(SAMPLES / 2, "ns"), (SAMPLES / 4, "ns_lower"), (3 * SAMPLES / 4, "ns_upper")] {
            self.lines.add(row, (samples[index] * 1e4).round() / 1e4, unit);
        }
        self.lines.add(row, format_args!("{sum:08x}"), "bits");
    }

    /// Measures the time of `batches` batches, in nanoseconds.
    fn lapse<K: Kernel>(
        &self,
        kernel: &K,
        inputs: &[K::Input],
        outputs: &mut [K::Output],
        batches: usize,
    ) -> f64 {
        let start = self.clock.now();
        for _ in 0..batches {
            batch(black_box(kernel), black_box(inputs), black_box(&mut *outputs));
        }
        self.clock.now() - start
    }
}

/// Evaluates a batch. Not inlined: each kernel has its own function, so that none affects another.
#[inline(never)]
fn batch<K: Kernel>(kernel: &K, inputs: &[K::Input], outputs: &mut [K::Output]) {
    for (output, input) in outputs.iter_mut().zip(inputs) {
        *output = kernel.evaluate(input);
    }
}

impl<C: Clock> Visitor for Stopwatch<'_, C> {
    fn falloff<K: Kernel<Place = f32>>(&mut self, row: Row, kernel: K, _: &oracle::Cone) {
        if self.is_wanted() {
            let versine = |i| self.outer * ((i as f32 + 0.5) / BATCH as f32);
            let inputs: Vec<_> = (0..BATCH).map(|i| kernel.input(&versine(i))).collect();
            self.time(row, &kernel, &inputs);
        }
    }

    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &Point) {
        if self.is_wanted() {
            let sites = Sites::new(truth.population, self.outer);
            let inputs: Vec<_> = sites.take(BATCH).map(|site| kernel.input(&site)).collect();
            self.time(row, &kernel, &inputs);
        }
    }
}
