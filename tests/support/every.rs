//! Visits the inputs of a domain, in chunks on all processors: every input if `LUMINAIRE_FULL` is
//! set, else one in [`STRIDE`].

use super::oracle;
use std::ops::RangeInclusive;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::Instant;

/// Distance between the inputs of the quick run. It is a prime, so that all bits change.
pub const STRIDE: u64 = 1_009;

/// Number of inputs that a processor takes at a time.
const CHUNK: u64 = 1 << 26;

/// Whether `LUMINAIRE_FULL` requests the long run.
pub fn is_full() -> bool {
    std::env::var_os("LUMINAIRE_FULL").is_some()
}

/// What the visit of a domain found about a function.
#[derive(Clone, Copy, Default, Debug)]
pub struct Seen {
    /// The largest distance from the exact value.
    pub error: f64,
    /// The largest rise from one input to the next.
    pub rise: f64,
    /// The largest fall from one input to the next.
    pub fall: f64,
}

impl Seen {
    pub fn and(self, other: Self) -> Self {
        Self {
            error: self.error.max(other.error),
            rise: self.rise.max(other.rise),
            fall: self.fall.max(other.fall),
        }
    }

    /// Enters the result `found`, the previous result and the exact values: more than one value if
    /// several inputs share a result.
    #[inline(always)]
    fn see(&mut self, before: f64, found: f64, exact: &[f64]) {
        for exact in exact {
            let error = oracle::counted((found - exact).abs());
            if error > self.error {
                self.error = error;
            }
        }
        let step = found - before;
        if step > self.rise {
            self.rise = step;
        }
        if -step > self.fall {
            self.fall = -step;
        }
    }
}

/// Visits a domain in ascending order. `at` returns the computed and the exact result for an input.
///
/// The long run reports on stderr when it has finished a domain, and how long that took.
pub fn input(name: &str, domain: RangeInclusive<u64>, at: impl Fn(u64) -> [f64; 2] + Sync) -> Seen {
    let [seen] = inputs(name, domain, |input| {
        let [found, exact] = at(input);
        [(found, [exact])]
    });
    seen
}

/// As [`input`], for several functions of an input. Each result comes with an exact value for each
/// of the inputs that share it.
pub fn inputs<const FUNCTIONS: usize, const EXACT: usize>(
    name: &str,
    domain: RangeInclusive<u64>,
    at: impl Fn(u64) -> [(f64, [f64; EXACT]); FUNCTIONS] + Sync,
) -> [Seen; FUNCTIONS] {
    let (start, stride) = (Instant::now(), if is_full() { 1 } else { STRIDE });
    let (first, last) = (*domain.start(), *domain.end());
    let next = AtomicU64::new(0);
    let seen = Mutex::new([Seen::default(); FUNCTIONS]);
    let chunks = (last - first) / CHUNK + 1;
    let work = || {
        loop {
            let chunk = next.fetch_add(1, Ordering::Relaxed);
            if chunk >= chunks {
                return;
            }
            let from = first + chunk * CHUNK;
            // One input more than the chunk, so that the step to the next chunk is tested as well.
            let to = from.saturating_add(CHUNK).min(last);
            let found = over(from, to, stride, &at);
            let mut seen = seen.lock().expect("no other processor has failed");
            seen.iter_mut().zip(found).for_each(|(seen, found)| *seen = seen.and(found));
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    if is_full() {
        let inputs = (last - first) as f64 + 1.0;
        eprintln!("{name}: {inputs:.3e} inputs in {:.1} s", start.elapsed().as_secs_f64());
    }
    seen.into_inner().expect("no processor has failed")
}

/// One in `stride` inputs, the last one always.
fn over<const FUNCTIONS: usize, const EXACT: usize>(
    from: u64,
    to: u64,
    stride: u64,
    at: &impl Fn(u64) -> [(f64, [f64; EXACT]); FUNCTIONS],
) -> [Seen; FUNCTIONS] {
    let mut seen = [Seen::default(); FUNCTIONS];
    // The first input has no predecessor: a difference to NaN counts as no step.
    let mut before = [f64::NAN; FUNCTIONS];
    let mut input = from;
    loop {
        for (i, (found, exact)) in at(input).into_iter().enumerate() {
            seen[i].see(before[i], found, &exact);
            before[i] = found;
        }
        if input == to {
            return seen;
        }
        input = (input + stride).min(to);
    }
}
