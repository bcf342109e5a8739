//! Profiles of every kind at random, each with its formula.

use super::reference;
use fastrand::Rng;
use luminaire::{
    Blend, Cubic, Hard, IntegerPower, IntegerRim, Linear, Matched, MixedPower, MixedRim, Smooth, Soft, Table,
};

/// The largest exponent of a power.
const MOST: u32 = 1_024;

/// A profile and its formula in f64.
pub struct Shape {
    pub profile: Matched,
    pub exact: Box<dyn Fn(f64) -> f64>,
}

impl Shape {
    pub fn new(profile: impl Into<Matched>, exact: impl Fn(f64) -> f64 + 'static) -> Self {
        Self { profile: profile.into(), exact: Box::new(exact) }
    }

    pub fn blend(slope: f32) -> Self {
        let a = f64::from(slope);
        Self::new(Blend::new(slope).expect("a sound slope"), move |t| t * (a + (1.0 - a) * t))
    }

    pub fn random(rng: &mut Rng, tables: &[&'static [u16]]) -> Self {
        let power = |n: u32| move |x: f64| x.powi(n.cast_signed());
        let exponent = |rng: &mut Rng| (f64::from(MOST).powf(rng.f64()) as u32).max(1);
        match rng.u8(..12) {
            0 => Self::new(Soft, reference::soft),
            1 => Self::new(Hard, reference::hard),
            2 => Self::new(Linear, reference::linear),
            3 => Self::new(Smooth, reference::smooth),
            4 => Self::blend(2.0 * rng.f32()),
            5 => loop {
                let Ok(cubic) = Cubic::with_slopes(4.0 * rng.f32(), 4.0 * rng.f32()) else { continue };
                let [a, b, c] = cubic.coefficients().map(f64::from);
                break Self::new(cubic, move |t| t * (a + t * (b + t * c)));
            },
            6 | 7 => {
                let n = exponent(rng);
                Self::new(IntegerPower::new(n).expect("a sound exponent"), power(n))
            }
            8 => {
                let (n, exact) = (exponent(rng), power);
                Self::new(IntegerRim::new(n).expect("a sound exponent"), move |t| 1.0 - exact(n)(1.0 - t))
            }
            kind @ (9 | 10) => {
                let (low, share) = (rng.u32(1..MOST), rng.f32());
                let high = rng.u32(low + 1..=MOST);
                let mixture = move |x: f64| {
                    let [low, high] = [power(low)(x), power(high)(x)];
                    low - (low - high) * f64::from(share)
                };
                if kind == 9 {
                    Self::new(MixedPower::new([low, high], share).expect("a sound mixture"), mixture)
                } else {
                    let profile = MixedRim::new([low, high], share).expect("a sound mixture");
                    Self::new(profile, move |t| 1.0 - mixture(1.0 - t))
                }
            }
            _ => {
                let samples = tables[rng.usize(..tables.len())];
                Self::new(Table::new(samples).expect("sound samples"), move |t| interpolated(samples, t))
            }
        }
    }
}

/// The table in f64.
pub fn interpolated(samples: &[u16], t: f64) -> f64 {
    let place = (1.0 - t) * (samples.len() - 1) as f64;
    let index = (place as usize).min(samples.len() - 2);
    let [from, to] = [samples[index], samples[index + 1]].map(f64::from);
    (from + (to - from) * (place - index as f64)) / 65_535.0
}

/// Tables with steps, hills and gaps.
pub fn tables() -> Vec<&'static [u16]> {
    let mut rng = Rng::with_seed(12);
    let step = |count: usize, at: usize| (0..count).map(|i| if i < at { 65_535 } else { 0 }).collect();
    let mut tables: Vec<Vec<u16>> = vec![step(100, 50), step(10, 5), step(2, 1), step(1_000, 900)];
    for count in [3, 20, 64, 256] {
        tables.push((0..count).map(|_| rng.u16(..)).collect());
        let mut falling: Vec<u16> = (0..count).map(|_| rng.u16(..)).collect();
        falling.sort_by(|a, b| b.cmp(a));
        tables.push(falling);
    }
    tables.into_iter().map(|table| &*table.leak()).collect()
}
