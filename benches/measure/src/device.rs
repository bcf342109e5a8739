//! `cargo xtask board`: the firmware of a real board or console, built, and run from the boot on in an emulator of
//! the whole chip.

mod cartridge;
mod check;
mod console;
mod elf;
mod flash;
mod lines;
mod uf2;

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use tools::board::{GBA, RP2040};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::{board, project};

use crate::program::Program;
use flash::Cable;

/// The options of `board`.
#[derive(Debug, PartialEq, clap::Args)]
pub struct DeviceOptions {
    /// The board or the console
    #[arg(value_name = "NAME", value_parser = [RP2040, GBA])]
    device: String,
    /// Run the firmware in an emulator of the whole chip or console, and compare each pixel that its display
    /// receives with the host's
    #[arg(long)]
    pub check: bool,
    /// With --check of gba: write the console's screen to this PNG, magnified
    #[arg(long, value_name = "FILE", requires = "check")]
    screenshot: Option<PathBuf>,
    /// Copy the firmware to a connected board, compare the checksums that it prints on GPIO 0 with the host's, and
    /// print its row for the table of boards
    #[arg(long, conflicts_with = "check")]
    flash: bool,
    /// Folder at which the drive of the board's boot ROM is mounted [default: looked for]
    #[arg(long, value_name = "FOLDER", requires = "flash")]
    drive: Option<PathBuf>,
    /// Serial port that reads GPIO 0 of the board [default: the only one]
    #[arg(long, value_name = "FILE", requires = "flash")]
    port: Option<PathBuf>,
}

/// Builds the firmware. Returns its file.
fn build(progress: &Progress) -> Result<PathBuf> {
    let file = board::build(progress)?;
    Program::read(&file)?.has_no_float()?;
    Ok(file)
}

/// Builds the firmware of a board and writes the file that is copied to it, or checks the firmware.
pub fn run(options: &DeviceOptions) -> Result<()> {
    let progress = Progress::Live;
    if options.device == GBA {
        return run_console(options, &progress);
    }
    ensure!(options.screenshot.is_none(), "--screenshot: expected the console {GBA}");
    let file = build(&progress)?;
    if options.check {
        return check::check(&file, &progress).map(|lines| lines.iter().for_each(|line| println!("{line}")));
    }
    // A port that is missing is an error before anything is written.
    let cable = options.flash.then(|| Cable::new(options.drive.clone(), options.port.clone())).transpose()?;
    let image = project::target().join(format!("{}.uf2", options.device));
    fs::write(&image, uf2::image(&file)?).with_context(|| format!("cannot write {}", image.display()))?;
    if let Some(cable) = cable {
        let row = cable.run(&image, &progress)?;
        println!("Every pixel is the host's. For the table in {}:\n{row}", lines::PAGE);
        return Ok(());
    }
    let bytes = Program::read(&file)?.bytes();
    println!("{}: {bytes} bytes of flash; copy it to the drive of the board's boot ROM", image.display());
    Ok(())
}

/// Builds the program of the console and writes the cartridge, or checks it.
fn run_console(options: &DeviceOptions, progress: &Progress) -> Result<()> {
    ensure!(!options.flash, "--flash: expected the board {RP2040}");
    let (file, image) = write_cartridge(progress)?;
    if options.check {
        let lines = console::check(&file, &image, options.screenshot.as_deref(), progress)?;
        lines.iter().for_each(|line| println!("{line}"));
        return Ok(());
    }
    let bytes = fs::metadata(&image)?.len();
    println!("{}: {bytes} bytes; open it in an emulator", image.display());
    Ok(())
}

/// Builds the program of the console and writes its cartridge. Returns the files of both.
fn write_cartridge(progress: &Progress) -> Result<(PathBuf, PathBuf)> {
    let file = board::build_console(progress)?;
    Program::read(&file)?.has_no_float()?;
    let image = project::target().join(format!("luminaire.{GBA}"));
    fs::write(&image, cartridge::image(&file)?)
        .with_context(|| format!("cannot write {}", image.display()))?;
    Ok((file, image))
}

/// Adds the steps: the packages are formatted, and the firmware is built and checked in an emulator.
pub(crate) fn steps(suite: &mut Suite) {
    for name in ["panel", "template", RP2040, GBA] {
        suite.step(&format!("board: {name}, cargo fmt"), |progress| {
            progress.run(board::cargo(name, ["fmt", "--check"]))
        });
    }
    suite.remarked("board: rp2040 sends the host's pixels to its display", |progress| {
        check::check(&build(progress)?, progress)
    });
    suite.remarked("board: gba shows the host's pixels in both modes", |progress| {
        let (file, image) = write_cartridge(progress)?;
        console::check(&file, &image, None, progress)
    });
}
