//! Counting the instructions and the bytes of every program.

use std::collections::BTreeMap;

use anyhow::{Context, Result, ensure};

use super::catalogue;
use super::list::{Price, Prices};
use crate::boards::cost::Cost;
use crate::boards::laboratory::{RELEASE, SIZE};
use crate::boards::{self, Board, Rp2040};
use crate::size::effects::{Effects, Format};
use tools::progress::Progress;

/// A processor with the number format that suits it.
#[derive(Debug)]
pub(super) struct Stand {
    /// The name of the board.
    pub(super) board: &'static str,
    format: Format,
    /// The feature of the firmware that selects the format.
    feature: &'static str,
}

/// The smallest processor, and one with a floating point unit.
pub(super) static STANDS: [Stand; 2] = [
    Stand { board: "cortex-m0", format: Format::Fx16, feature: "effects" },
    Stand { board: "cortex-m4f", format: Format::F32, feature: "effects-f32" },
];

/// What is counted of a program while it runs.
#[derive(Clone, Copy, Debug)]
struct Counted {
    instructions: f64,
    instructions_for_size: f64,
    cycles: Option<f64>,
}

/// The counts of each program.
type Counts = BTreeMap<String, Counted>;

/// Counts on a board. An error if its results are not the host's.
pub(super) fn count(stand: &Stand, progress: &Progress) -> Result<Prices> {
    let board = Board::named(stand.board).map_err(anyhow::Error::msg)?;
    let clock = Rp2040::for_board(board, progress)?;
    let costs = boards::effects(board, stand.feature, RELEASE, clock.as_ref(), progress)?;
    let for_size = boards::effects(board, stand.feature, SIZE, None, progress)?;
    let mut counted = BTreeMap::new();
    // The order is that of the results, which are the host's in both.
    for (cost, for_size) in costs.kernels.into_iter().zip(for_size.kernels) {
        ensure!(cost.format == stand.format.name(), "{} on {} is another format", cost.name(), board.name);
        let name = cost.kernel.replace('_', "-");
        let Cost { instructions, cycles, .. } = cost;
        let instructions_for_size = for_size.instructions;
        counted.insert(name, Counted { instructions, instructions_for_size, cycles });
    }
    let bytes = Effects::build(board, stand.format, progress)?.bytes()?;
    Ok(Prices {
        format: stand.format.name().to_owned(),
        compiler: costs.compiler,
        runs_on: costs.emulator,
        prices: joined(counted, bytes)?,
    })
}

/// Joins counts and bytes by program. Every program of the catalogue must have both, and no
/// other program may have either.
fn joined(mut counted: Counts, bytes: Vec<(String, u64)>) -> Result<BTreeMap<String, Price>> {
    let mut prices = BTreeMap::new();
    for (program, bytes) in bytes {
        let counts = counted.remove(&program);
        let Counted { instructions, instructions_for_size, cycles } =
            counts.with_context(|| format!("the instructions of {program} are missing"))?;
        prices.insert(program, Price { instructions, instructions_for_size, cycles, bytes });
    }
    ensure!(counted.is_empty(), "these have no program: {counted:?}");
    for entry in catalogue::entries() {
        ensure!(prices.contains_key(entry.program), "there is no program {}", entry.program);
    }
    for program in prices.keys() {
        ensure!(catalogue::entries().any(|entry| entry.program == program), "the catalogue lacks {program}");
    }
    Ok(prices)
}

#[cfg(test)]
mod tests {
    use super::*;

    const COUNTED: Counted = Counted { instructions: 10.0, instructions_for_size: 12.0, cycles: Some(14.0) };

    /// Counts in which each program has 10 instructions, 12 for size, 14 cycles and 20 bytes.
    fn counted() -> (Counts, Vec<(String, u64)>) {
        let instructions: BTreeMap<_, _> =
            catalogue::entries().map(|entry| (entry.program.to_owned(), COUNTED)).collect();
        let bytes = instructions.keys().map(|program| (program.clone(), 20)).collect();
        (instructions, bytes)
    }

    #[test]
    fn a_price_is_instructions_and_bytes() {
        let (instructions, bytes) = counted();
        let prices = joined(instructions, bytes).unwrap();
        let Counted { instructions, instructions_for_size, cycles } = COUNTED;
        assert_eq!(prices["phong"], Price { instructions, instructions_for_size, cycles, bytes: 20 });
    }

    #[test]
    fn a_program_that_was_counted_one_way_only_is_named() {
        let (mut instructions, bytes) = counted();
        instructions.remove("phong");
        assert!(joined(instructions, bytes).unwrap_err().to_string().contains("phong"));
        let (mut instructions, mut bytes) = counted();
        bytes.retain(|(name, _)| name != "phong");
        assert!(joined(instructions.clone(), bytes.clone()).unwrap_err().to_string().contains("phong"));
        instructions.remove("phong");
        assert!(joined(instructions, bytes).unwrap_err().to_string().contains("phong"));
    }

    #[test]
    fn a_program_that_the_catalogue_lacks_is_named() {
        let (mut instructions, mut bytes) = counted();
        instructions.insert("halo".to_owned(), COUNTED);
        bytes.push(("halo".to_owned(), 2));
        assert!(joined(instructions, bytes).unwrap_err().to_string().contains("halo"));
    }
}
