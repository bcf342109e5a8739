//! The part of `cargo xtask test` that reads linked programs: no float, no panic, no heap, and not
//! a byte for unused effects.

use anyhow::{Result, ensure};

use super::effects::{EMPTY, Effects, Format, UNUSED};
use super::program::{Program, is_heap};
use super::proof::{Configuration, MAIN, MORE, Proof, programs};
use crate::boards::{Board, board};
use tools::progress::Progress;
use tools::suite::Suite;

/// Upper bound, in bytes of flash, of a soft spotlight with Lambert's cosine in `Fx16` on the
/// smallest processor.
const BUDGET: u64 = 1920;

/// The program of that spotlight.
const SPOT: &str = "spot_soft_lambert";

/// Adds the steps. Without `full`, the proof is for one board, because what panics does so on every
/// processor, and for one format, because the formats share their generic code.
pub fn run(suite: &mut Suite, full: bool) {
    for board in if full { &board::ALL[..] } else { &board::ALL[..1] } {
        let name = format!("effects: no function panics and none allocates on {}", board.name);
        suite.remarked(&name, |progress| {
            let formats = if full { &Format::ALL[..] } else { &[Format::Fx16] };
            Ok(vec![no_panic(&MAIN, board, formats, progress)?])
        });
    }
    for configuration in if full { &MORE[..] } else { &[] } {
        let name = format!("effects: no function panics in the configuration {}", configuration.name);
        suite.remarked(&name, |progress| {
            Ok(vec![no_panic(configuration, smallest(), &Format::ALL, progress)?])
        });
    }
    suite.step("effects: what is not used adds no byte and no instruction", unused);
    suite.step("effects: the soft spotlight keeps to its budget", budget);
}

/// Links the programs in formats, which fails if a panic can be reached, and checks that they have no
/// heap. Returns the number of functions.
fn no_panic(
    configuration: &'static Configuration,
    board: &Board,
    formats: &[Format],
    progress: &Progress,
) -> Result<String> {
    let proof = Proof::write(configuration, progress)?;
    for &format in formats {
        let names = programs(format);
        let files = proof.link(board, format, names, &[], progress).or_else(|error| {
            let culprits = proof.culprits(board, format, names, progress).unwrap_or_default();
            ensure!(culprits.is_empty(), "in {} these can panic:\n{}", format.name(), culprits.join("\n"));
            Err(error)
        })?;
        for (name, file) in names.iter().zip(files) {
            let program = Program::read(&file)?;
            let (heap, format) = (program.names_of(is_heap), format.name());
            ensure!(heap.is_empty(), "in {name} in {format} there is a heap: {}", heap.join(", "));
            // A program from which the linker has removed everything would prove nothing.
            ensure!(program.bytes > 100_000, "in {name} in {format} there is nothing left to panic");
        }
    }
    Ok(proof.to_string())
}

/// The programs that the two steps below compare.
fn built(progress: &Progress) -> Result<Effects> {
    let programs = [EMPTY, SPOT, UNUSED].iter().flat_map(|name| ["--bin", name]);
    Effects::build_some(&programs.collect::<Vec<_>>(), smallest(), Format::Fx16, progress)
}

/// Checks that a program that could name other effects, but does not, is the same to the byte.
fn unused(progress: &Progress) -> Result<()> {
    let effects = built(progress)?;
    let [alone, beside] = [effects.program(SPOT)?, effects.program(UNUSED)?];
    ensure!(alone.flash == beside.flash, "{} bytes alone, {} beside others", alone.bytes, beside.bytes);
    let empty = effects.program(EMPTY)?;
    let used = empty.names_of(|name| name.contains("luminaire::"));
    ensure!(used.is_empty(), "the empty program has {}", used.join(", "));
    Ok(())
}

fn budget(progress: &Progress) -> Result<()> {
    let effects = built(progress)?;
    let bytes = effects.program(SPOT)?.bytes - effects.program(EMPTY)?.bytes;
    ensure!(bytes <= BUDGET, "{bytes} bytes, and {BUDGET} are promised");
    Ok(())
}

/// The smallest board.
fn smallest() -> &'static Board {
    &board::ALL[0]
}
