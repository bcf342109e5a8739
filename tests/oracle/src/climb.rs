//! The search for the worst input: from the worst of many random ones it climbs.

use std::vec::Vec;

use fastrand::Rng;

use crate::counted;

/// A search by climbing. It is generic over the input: `f32`, an array, a light with a point.
#[derive(Clone, Copy, Debug)]
pub struct Search {
    /// Random inputs to begin with.
    pub starts: usize,
    /// How many of them are climbed from: the worst.
    pub climbs: usize,
    /// Steps of each climb.
    pub steps: usize,
    /// The seed of the random numbers.
    pub seed: u64,
}

impl Default for Search {
    fn default() -> Self {
        Self { starts: 2_000, climbs: 8, steps: 6_000, seed: 1953 }
    }
}

/// The worst input that was found.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Worst<T> {
    /// The input.
    pub input: T,
    /// Its error.
    pub error: f64,
}

impl Search {
    /// Returns the worst input found, or `None` if no error is more than 0.
    pub fn worst<T: Copy>(
        &self,
        somewhere: impl Fn(&mut Rng) -> T,
        moved: impl Fn(&mut Rng, T) -> T,
        error: impl Fn(T) -> f64,
    ) -> Option<Worst<T>> {
        let mut rng = Rng::with_seed(self.seed);
        let start = |input| Worst { input, error: counted(error(input)) };
        let mut starts: Vec<_> = (0..self.starts).map(|_| start(somewhere(&mut rng))).collect();
        starts.sort_by(|a, b| b.error.total_cmp(&a.error));
        let worst = starts.into_iter().take(self.climbs);
        let climbed = worst.map(|worst| climb(&mut rng, worst, self.steps, &moved, &error));
        let wrong = climbed.filter(|worst| worst.error > 0.0);
        wrong.reduce(|most, worst| if worst.error > most.error { worst } else { most })
    }
}

/// Climbs from an input. A step to another input is kept unless the error falls, so that a climb
/// crosses plateaus.
pub fn climb<T: Copy>(
    rng: &mut Rng,
    mut worst: Worst<T>,
    steps: usize,
    moved: impl Fn(&mut Rng, T) -> T,
    error: impl Fn(T) -> f64,
) -> Worst<T> {
    worst.error = counted(worst.error);
    for _ in 0..steps {
        let input = moved(rng, worst.input);
        let error = counted(error(input));
        if error >= worst.error {
            worst = Worst { input, error };
        }
    }
    worst
}

/// The vector with one of its components changed.
pub fn one_of<V: Into<[f32; 3]> + From<[f32; 3]>>(rng: &mut Rng, v: V, change: impl Fn(f32) -> f32) -> V {
    let mut v: [f32; 3] = v.into();
    let component = &mut v[usize::from(rng.u8(..3))];
    *component = change(*component);
    v.into()
}

/// A random power of two from 2^-1 to 2^-23, of either sign: by how much to change a direction, or
/// the relative change of a length.
pub fn size(rng: &mut Rng) -> f32 {
    (0..rng.i32(1..24)).fold(if rng.bool() { 1.0 } else { -1.0 }, |size, _| size / 2.0)
}

/// A change on the grid of 2^-16: relative by a [`size`], or by 1 to 15 quanta in its direction.
pub fn grid_step(rng: &mut Rng, size: f32) -> impl Fn(f32) -> f32 + use<> {
    let quantum = size.signum() * f32::from(rng.u8(1..16)) / 65_536.0;
    let coarse = rng.bool();
    move |c| if coarse { libm::roundf(c * (1.0 + size) * 65_536.0) / 65_536.0 } else { c + quantum }
}

/// A change by a random power of two of units in the last place, of either sign. It stays finite.
pub fn ulp_step(rng: &mut Rng) -> impl Fn(f32) -> f32 + use<> {
    let step = (1_i32 << rng.u8(..24)) * if rng.bool() { 1 } else { -1 };
    // The bits of a negative number fall as it rises: order them by value, with both zeros as one.
    let ordered = |bits: i32| if bits < 0 { i32::MIN - bits } else { bits };
    let largest = f32::MAX.to_bits() as i32;
    move |c| {
        let moved = ordered(c.to_bits() as i32).saturating_add(step).clamp(-largest, largest);
        f32::from_bits(ordered(moved) as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn climb_finds_a_planted_maximum_to_the_bit() {
        let search = Search { starts: 100, climbs: 2, steps: 2_000, seed: 7 };
        for planted in [1.234_567_8_f32, -3e-20, 7.5e30, -1.0, f32::MIN_POSITIVE] {
            let distance = |c: f32| (f64::from(c) / f64::from(planted) - 1.0).abs();
            let somewhere = |rng: &mut Rng| planted * (0.5 + rng.f32());
            let found = search.worst(somewhere, |rng, c| ulp_step(rng)(c), |c| 1.0 / (1e-9 + distance(c)));
            assert_eq!(found.map(|found| found.input.to_bits()), Some(planted.to_bits()), "{planted}");
        }
    }

    #[test]
    fn climb_crosses_a_plateau_and_finds_nothing_where_nothing_is() {
        let search = Search { starts: 4, climbs: 4, steps: 3_000, seed: 3 };
        let moved = |rng: &mut Rng, v| {
            let size = size(rng);
            one_of(rng, v, |c| c + size)
        };
        let step = |v: [f32; 3]| if v[0] > 3.0 { 2.0 } else { 1.0 };
        let found = search.worst(|_| [1.0; 3], moved, step).map(|found| found.error);
        assert_eq!(found, Some(2.0));
        assert!(search.worst(|_| [1.0; 3], moved, |_| 0.0).is_none());
    }
}
