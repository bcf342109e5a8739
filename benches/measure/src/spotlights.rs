//! The spotlight of embedded-3dgfx beside the kernel's: errors against f64, and instructions.

use anyhow::{Context, Result};
use tools::progress::Progress;
use tools::{command, project};

use crate::counted::{Firmware, RELEASE};
use crate::target::BOARDS;

/// The workspace of both spotlights.
const FOLDER: &str = "examples/renderers/spotlights";

/// What is counted: its words in the table, and its name in the program.
const KERNELS: [(&str, &str); 6] = [
    ("embedded-3dgfx, `SpotLight::contribution_at`: cone and colour", "embedded-3dgfx.f32"),
    ("luminaire in `f32`: the same", "cone.f32"),
    ("luminaire in `Fx16`: the same", "cone.fx16"),
    ("luminaire in `Fx16`, from a point in floats: the same", "cone-of-floats.fx16"),
    ("luminaire in `f32`: the whole pixel", "pixel.f32"),
    ("luminaire in `Fx16`: the whole pixel", "pixel.fx16"),
];

fn program(name: &str) -> Firmware<'_> {
    Firmware { folder: FOLDER, name, options: &[], profile: RELEASE }
}

/// Returns the rows of the table of errors.
///
/// # Errors
/// If the program does not compile or its asserts fail.
pub fn errors(progress: &Progress) -> Result<Vec<String>> {
    Ok(program("errors").on_the_host(progress)?.lines().map(str::to_owned).collect())
}

/// Returns the compiler and the rows of the table of instructions, counted in QEMU on a Cortex-M0 and a
/// Cortex-M4F.
///
/// # Errors
/// If a result differs from the host's.
pub fn instructions(progress: &Progress) -> Result<(String, Vec<String>)> {
    let mut counted = Vec::new();
    for board in [&BOARDS[0], &BOARDS[2]] {
        counted.push(program("luminaire-spotlights").costs(board, progress)?);
    }
    let row = |(title, name): (&str, &str)| {
        let cells = counted.iter().map(|(costs, _)| {
            let cost = costs.iter().find(|cost| cost.name == name).context("a line for each kernel")?;
            Ok(format!("{:.0}", cost.instructions))
        });
        Ok(format!("| {title} | {} |", cells.collect::<Result<Vec<_>>>()?.join(" | ")))
    };
    let rows: Result<Vec<_>> = KERNELS.into_iter().map(row).collect();
    Ok((counted[0].1.about[0].1.clone(), rows?))
}

/// Checks the source: its format, and Clippy's rules.
///
/// # Errors
/// If the source is not as `cargo fmt` writes it, or Clippy warns.
pub fn lint(progress: &Progress) -> Result<()> {
    for words in [&["fmt", "--check"][..], &["clippy", "--all-targets", "--", "-Dwarnings"]] {
        let mut cargo = command::cargo(words);
        cargo.current_dir(project::root().join(FOLDER));
        progress.run(cargo)?;
    }
    Ok(())
}
