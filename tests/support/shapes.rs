//! Random falloffs of every kind.

use fastrand::Rng;
use luminaire::falloff::{AnyFalloff, Falloff, Formula, Table};

/// A random falloff of the list, with a table from `tables`. Falloffs that jump or have an infinite
/// slope are left out, because a format does not bound their error of intensity.
pub fn random(rng: &mut Rng, tables: &[&'static [u16]]) -> AnyFalloff {
    loop {
        match AnyFalloff::anywhere(rng.usize(..), || rng.f32()) {
            Ok(AnyFalloff::Table(_)) => {
                return Table::new(tables[rng.usize(..tables.len())]).expect("enough samples").into();
            }
            Ok(AnyFalloff::Step(_)) | Err(_) => {}
            Ok(falloff) => match falloff.formula() {
                Formula::Power(exponent) | Formula::InvertedPower(exponent, _) if exponent < 1.0 => {}
                _ => return falloff,
            },
        }
    }
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
