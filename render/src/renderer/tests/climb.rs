//! The search for the worst input, by a climb from the worst of random ones. The crate is packed without the
//! search of `tests/oracle`.

extern crate std;

use fastrand::Rng;

/// A search: random inputs to begin with, and the steps of a climb from the worst of them.
pub(super) struct Search {
    pub(super) starts: usize,
    pub(super) steps: usize,
    pub(super) seed: u64,
}

/// The worst input that was found.
#[derive(Debug)]
pub(super) struct Worst<T> {
    pub(super) input: T,
    pub(super) error: f64,
}

impl Search {
    /// Returns the worst input found, or `None` if no error is more than 0. A step to another input is kept
    /// unless the error falls.
    pub(super) fn worst<T: Copy>(
        &self,
        somewhere: impl Fn(&mut Rng) -> T,
        moved: impl Fn(&mut Rng, T) -> T,
        error: impl Fn(T) -> f64,
    ) -> Option<Worst<T>> {
        let mut rng = Rng::with_seed(self.seed);
        let mut worst: Option<Worst<T>> = None;
        for number in 0..self.starts + self.steps {
            let input = match &worst {
                Some(worst) if number >= self.starts => moved(&mut rng, worst.input),
                _ => somewhere(&mut rng),
            };
            let error = error(input);
            if error > 0.0 && worst.as_ref().is_none_or(|worst| error >= worst.error) {
                worst = Some(Worst { input, error });
            }
        }
        worst
    }
}

/// A random power of two from 2^-1 to 2^-23, of either sign.
pub(super) fn size(rng: &mut Rng) -> f32 {
    let size = 0.5_f32.powi(rng.i32(1..24));
    if rng.bool() { size } else { -size }
}

/// A change of a positive number by a random power of two of units in the last place, of either sign.
pub(super) fn ulp_step(rng: &mut Rng) -> impl Fn(f32) -> f32 + use<> {
    let step = (1_i32 << rng.u8(..24)) * if rng.bool() { 1 } else { -1 };
    move |c| f32::from_bits(c.to_bits().saturating_add_signed(step))
}
