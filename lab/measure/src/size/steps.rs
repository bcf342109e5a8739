//! The part of `cargo xtask test` that reads linked programs: no float, no panic, no heap, and no
//! byte for nothing.

use anyhow::{Result, ensure};

use super::effects::{EMPTY, EVERYTHING, Effects, Format, PROOFS, UNUSED};
use super::program::{Program, is_heap};
use crate::boards::laboratory::{self, Laboratory};
use crate::boards::{Board, board};
use tools::progress::Progress;
use tools::suite::Suite;

/// The most that a soft spotlight with Lambert's cosine may take in 16 bits on the smallest
/// processor.
const BUDGET: u64 = 1920;

/// Adds the steps.
pub fn run(suite: &mut Suite, boards: &[&'static Board]) {
    suite.step("effects: everything at once, built for each board", |progress| {
        Format::ALL
            .iter()
            .try_for_each(|&format| Effects::build_one_for_all(format, EVERYTHING, boards, progress))
    });
    for &board in boards {
        suite.step(
            &format!("effects: nothing panics and nothing is allocated on {}", board.name),
            |progress| no_panic(&[EVERYTHING], board, progress),
        );
        suite.step(
            &format!("still: the picture of a constant light, and no soft float, on {}", board.name),
            |progress| still(board, progress),
        );
    }
    suite.step("effects: no function panics and none allocates", |progress| {
        no_panic(&PROOFS, smallest(), progress)
    });
    suite.step("effects: what is not used takes no bytes", unused);
    suite.step("effects: the soft spotlight keeps to its budget", budget);
}

/// A panic that can be reached fails to link.
fn no_panic(names: &[&str], board: &Board, progress: &Progress) -> Result<()> {
    for format in Format::ALL {
        let effects = Effects::build_some(board, format, names, progress)?;
        for name in names {
            let program = effects.program(name)?;
            let (heap, format) = (program.names_of(is_heap), format.name());
            ensure!(heap.is_empty(), "in {name} in {format} there is a heap: {}", heap.join(", "));
            // Nothing would be shown by a program from which the linker has thrown everything out.
            ensure!(program.bytes > 20_000, "in {name} in {format} there is nothing left to panic");
        }
    }
    Ok(())
}

/// The picture is the host's, and no function stands in for a floating point unit.
fn still(board: &'static Board, progress: &Progress) -> Result<()> {
    let laboratory = Laboratory::new(board, progress)?;
    let host = laboratory::on_the_host("still", progress)?;
    ensure!(!host.is_empty(), "the firmware has printed nothing on the host");
    ensure!(laboratory.run("still")?.lines == host, "not the picture of the host");
    Program::read(&laboratory.program("still"))?.has_no_float()
}

fn unused(progress: &Progress) -> Result<()> {
    let effects = Effects::build(smallest(), Format::Fx16, progress)?;
    let [alone, beside] = [effects.program("spot_soft_lambert")?, effects.program(UNUSED)?];
    ensure!(alone.bytes == beside.bytes, "{} bytes alone, {} beside others", alone.bytes, beside.bytes);
    let empty = effects.program(EMPTY)?;
    let used = empty.names_of(|name| name.contains("luminaire::"));
    ensure!(used.is_empty(), "the empty program has {}", used.join(", "));
    Ok(())
}

fn budget(progress: &Progress) -> Result<()> {
    let effects = Effects::build(smallest(), Format::Fx16, progress)?;
    let bytes = effects.program("spot_soft_lambert")?.bytes - effects.program(EMPTY)?.bytes;
    ensure!(bytes <= BUDGET, "{bytes} bytes, and {BUDGET} are promised");
    Ok(())
}

/// The processor with the least of everything.
fn smallest() -> &'static Board {
    &board::ALL[0]
}
