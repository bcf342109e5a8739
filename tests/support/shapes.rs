//! Falloffs of every kind at random.

use fastrand::Rng;
use luminaire::falloff::{
    AnyFalloff, Cubic, Hard, IntegerPower, InvertedIntegerPower, InvertedMixedPower, Linear, MixedPower,
    Quadratic, Smooth, Soft, Table,
};

/// The largest exponent of a power.
const MOST: u32 = 1_024;

/// A random falloff, its tables from a list.
pub fn random(rng: &mut Rng, tables: &[&'static [u16]]) -> AnyFalloff {
    let exponent = |rng: &mut Rng| (f64::from(MOST).powf(rng.f64()) as u32).max(1);
    let falloff = match rng.u8(..12) {
        0 => Ok(Soft.into()),
        1 => Ok(Hard.into()),
        2 => Ok(Linear.into()),
        3 => Ok(Smooth.into()),
        4 => Quadratic::new(2.0 * rng.f32()).map(AnyFalloff::from),
        5 => loop {
            let cubic = Cubic::with_slopes(4.0 * rng.f32(), 4.0 * rng.f32());
            if cubic.is_ok() {
                break cubic.map(AnyFalloff::from);
            }
        },
        6 | 7 => IntegerPower::new(exponent(rng)).map(AnyFalloff::from),
        8 => InvertedIntegerPower::new(exponent(rng)).map(AnyFalloff::from),
        kind @ (9 | 10) => {
            let (low, share) = (rng.u32(1..MOST), rng.f32());
            let exponents = [low, rng.u32(low + 1..=MOST)];
            if kind == 9 {
                MixedPower::new(exponents, share).map(AnyFalloff::from)
            } else {
                InvertedMixedPower::new(exponents, share).map(AnyFalloff::from)
            }
        }
        _ => Table::new(tables[rng.usize(..tables.len())]).map(AnyFalloff::from),
    };
    falloff.expect("sound parameters")
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
