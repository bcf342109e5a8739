//! `cargo xtask board`: the firmware of real boards, built, and run from the boot on where the whole
//! chip can be emulated.

mod check;
pub mod steps;
mod uf2;

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use tools::progress::Progress;
use tools::{board, project};

use crate::size::program::Program;

/// The options of `board`.
#[derive(Debug, PartialEq, clap::Args)]
pub struct DeviceOptions {
    /// The board: rp2040, stm32f411 or esp32c3
    #[arg(value_name = "NAME", value_parser = Device::named)]
    pub device: &'static Device,
    /// Run the firmware in an emulator of the whole chip, and compare each pixel that the display
    /// receives with the host's
    #[arg(long)]
    pub check: bool,
}

/// A board with a display, and the package of its firmware.
#[derive(Debug, PartialEq)]
pub struct Device {
    /// The name of the board on the command line, which is also the folder of its package.
    name: &'static str,
    /// The target that the firmware is compiled for.
    target: &'static str,
    /// Whether an emulator of the whole chip runs the firmware.
    is_run: bool,
}

/// All boards.
static ALL: [Device; 3] = [
    Device { name: "rp2040", target: "thumbv6m-none-eabi", is_run: true },
    Device { name: "stm32f411", target: "thumbv7em-none-eabihf", is_run: false },
    Device { name: "esp32c3", target: "riscv32imc-unknown-none-elf", is_run: false },
];

impl Device {
    fn named(name: &str) -> Result<&'static Self, String> {
        ALL.iter().find(|device| device.name == name).ok_or_else(|| {
            let names: Vec<_> = ALL.iter().map(|device| device.name).collect();
            format!("there is no board {name}; there are {}", names.join(", "))
        })
    }

    /// Builds the firmware. Returns its file.
    fn build(&self, progress: &Progress) -> Result<PathBuf> {
        let file = board::build(self.name, self.target, progress)?;
        Program::read(&file)?.has_no_float()?;
        Ok(file)
    }
}

/// Builds the firmware of a board and writes the file that is copied to it, or checks the firmware.
pub fn run(options: &DeviceOptions) -> Result<()> {
    let progress = Progress::Live;
    let device = options.device;
    let file = device.build(&progress)?;
    if options.check {
        ensure!(device.is_run, "no emulator runs the whole {}: build it without --check", device.name);
        return check::check(&file, &progress).map(|lines| lines.iter().for_each(|line| println!("{line}")));
    }
    let bytes = Program::read(&file)?.bytes;
    if device.is_run {
        let image = project::target().join(format!("{}.uf2", device.name));
        fs::write(&image, uf2::image(&file)?).with_context(|| format!("cannot write {}", image.display()))?;
        println!("{}: {bytes} bytes of flash; copy it to the drive of the board's boot ROM", image.display());
    } else {
        println!("{}: {bytes} bytes of flash; built, not run", file.display());
    }
    Ok(())
}
