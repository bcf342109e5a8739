//! The spotlight of embedded-3dgfx beside the kernel's: errors against f64, and instructions.

use anyhow::{Context, Result};

use crate::boards::board::Board;
use crate::boards::cost::{self, Cost};
use crate::boards::laboratory::{Laboratory, on_the_host_of};
use tools::command;
use tools::progress::Progress;
use tools::project;

/// The workspace of both spotlights.
const FOLDER: &str = "examples/renderers/spotlights";

/// The program whose instructions are counted.
const PROGRAM: &str = "luminaire-spotlights";

/// The processors, as the columns of the table.
const BOARDS: [&str; 2] = ["cortex-m0", "cortex-m4f"];

/// What is counted: its words in the table, and its name in the program.
const KERNELS: [(&str, &str); 6] = [
    ("embedded-3dgfx, `SpotLight::contribution_at`: cone and colour", "embedded-3dgfx.f32"),
    ("luminaire in `f32`: the same", "cone.f32"),
    ("luminaire in `Fx16`: the same", "cone.fx16"),
    ("luminaire in `Fx16`, from a point in floats: the same", "cone-of-floats.fx16"),
    ("luminaire in `f32`: the whole pixel", "pixel.f32"),
    ("luminaire in `Fx16`: the whole pixel", "pixel.fx16"),
];

/// Returns the rows of the table of errors.
///
/// # Errors
/// If the program does not compile or its asserts fail.
pub fn errors(progress: &Progress) -> Result<Vec<String>> {
    on_the_host_of(FOLDER, "errors", progress)
}

/// Returns the compiler and the rows of the table of instructions, counted in QEMU.
///
/// # Errors
/// If a result differs from the host's.
pub fn instructions(progress: &Progress) -> Result<(String, Vec<String>)> {
    let host = on_the_host_of(FOLDER, PROGRAM, progress)?;
    let mut counted = Vec::new();
    for board in BOARDS {
        let board = Board::named(board).map_err(anyhow::Error::msg)?;
        let laboratory = Laboratory::with_program_of(FOLDER, PROGRAM, board, progress)?;
        counted.push(cost::measure(&laboratory, PROGRAM, &host, None)?);
    }
    let cell = |costs: &[Cost], name: &str| {
        let cost = costs.iter().find(|cost| cost.name() == name).context("a line for each kernel")?;
        anyhow::Ok(format!("{:.0}", cost.instructions))
    };
    let row = |(title, name): (&str, &str)| {
        let cells: Result<Vec<_>> = counted.iter().map(|costs| cell(&costs.kernels, name)).collect();
        Ok(format!("| {title} | {} |", cells?.join(" | ")))
    };
    let rows: Result<Vec<_>> = KERNELS.into_iter().map(row).collect();
    Ok((counted[0].compiler.clone(), rows?))
}

/// Checks the source: its format, and Clippy's rules.
///
/// # Errors
/// If the source is not as `cargo fmt` writes it, or Clippy warns.
pub fn lint(progress: &Progress) -> Result<()> {
    for words in [&["fmt", "--check"][..], &["clippy", "--all-targets", "--", "-Dwarnings"]] {
        let mut cargo = command::cargo(words[0]);
        cargo.args(&words[1..]).current_dir(project::root().join(FOLDER));
        progress.run(cargo)?;
    }
    Ok(())
}
