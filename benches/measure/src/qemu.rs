//! Running programs in QEMU, with the instruction counter loaded or without.

use std::collections::{BTreeMap, BTreeSet};
use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use tools::progress::Progress;
use tools::system::System;
use tools::{command, install, project, tool};

use crate::target::Board;

/// Upper bound, in seconds, of the run time of firmware on a busy machine. Without it a crashed processor
/// would loop for ever.
const PATIENCE: &str = "600";

/// The executions in a region between two markers, by address.
pub(crate) type Region = BTreeMap<u64, u64>;

/// QEMU with the arguments that select a board.
#[derive(Debug)]
pub(crate) struct Qemu {
    program: PathBuf,
    board: &'static Board,
    /// Major and minor.
    version: (u32, u32),
    /// Whether single letters of the semihosting console are printed as the rest.
    has_console: bool,
}

impl Qemu {
    /// Finds the emulator of a board, on PATH or among unpacked packages. As root on Debian, unpacks the
    /// packages if they are missing.
    pub(crate) fn find(board: &'static Board, progress: &Progress) -> Result<Self> {
        let folder = project::target().join("tools/qemu");
        let unpacked = folder.join("usr/bin").join(board.emulator);
        let program = match command::on_path(&[board.emulator]) {
            Some(program) => program,
            None if unpacked.is_file() => unpacked,
            None if install::debian_root() => {
                unpack(&folder, progress)?;
                unpacked
            }
            None => bail!("{} is missing: {}", board.emulator, tool::remedy(&[&tool::QEMU], System::HERE)),
        };
        let answer = command::answer(Command::new(&program).arg("--version"))?;
        let version = version(&answer).with_context(|| format!("QEMU has no version: {answer}"))?;
        Ok(Self { program, board, version, has_console: false })
    }

    /// QEMU's version and the board, as in `QEMU 7.2, -M microbit`.
    pub(crate) fn describe(&self) -> String {
        let (major, minor) = self.version;
        format!("QEMU {major}.{minor}, {}", self.board.machine.join(" "))
    }

    /// The emulator with a device for the console of semihosting. picolibc writes single letters to it, which
    /// QEMU else writes to its standard error.
    pub(crate) fn with_console(self) -> Self {
        Self { has_console: true, ..self }
    }

    /// A call that still lacks the firmware.
    pub(crate) fn command(&self) -> Command {
        let mut qemu = Command::new(&self.program);
        // macOS has no such program, and Windows another one of this name.
        if System::HERE == System::Linux {
            qemu = Command::new("timeout");
            qemu.arg(PATIENCE).arg(&self.program);
        }
        qemu.args(self.board.machine).args(["-nographic", "-monitor", "none", "-serial", "none"]);
        if self.has_console {
            qemu.args(["-semihosting-config", "enable=on,target=native,chardev=console"]);
            qemu.args(["-chardev", "stdio,id=console"]);
        } else {
            qemu.args(["-semihosting-config", "enable=on,target=native"]);
        }
        qemu
    }

    /// Runs firmware with the counter, in the folder of what is built, where it may read files. Returns what it prints,
    /// and its regions.
    pub(crate) fn count(&self, firmware: &Path, progress: &Progress) -> Result<(String, Vec<Region>)> {
        self.counted(firmware, "", progress)
    }

    /// The same with one count for each region, which takes a small part of the time where there are many.
    pub(crate) fn totals(&self, firmware: &Path, progress: &Progress) -> Result<(String, Vec<u64>)> {
        let (printed, regions) = self.counted(firmware, ",by=region", progress)?;
        Ok((printed, regions.iter().map(|region| region.values().sum()).collect()))
    }

    fn counted(&self, firmware: &Path, by: &str, progress: &Progress) -> Result<(String, Vec<Region>)> {
        let counter = self.counter(progress)?;
        let counts = project::target().join(format!("{}.counts", self.board.name));
        // The file of an earlier run must not pass for that of this run.
        fs::write(&counts, "")?;
        // In a list of options QEMU expects each comma of a path doubled.
        let path = |path: &Path| path.display().to_string().replace(',', ",,");
        let mut qemu = self.command();
        qemu.current_dir(project::target()).arg("-plugin").arg(format!(
            "{},out={}{by}",
            path(&counter),
            path(&counts)
        ));
        let printed = command::answer(qemu.arg("-kernel").arg(firmware))?;
        Ok((printed, regions(&fs::read_to_string(&counts)?)?))
    }

    /// Builds the counter.
    fn counter(&self, progress: &Progress) -> Result<PathBuf> {
        let mut build = command::cargo(["build", "--release", "--package", "luminaire-counter"]);
        if self.version >= (9, 1) {
            build.args(["--features", "api-3"]);
        }
        progress.run(build)?;
        Ok(project::target().join("release").join(format!("{DLL_PREFIX}luminaire_counter{DLL_SUFFIX}")))
    }
}

/// Fails unless a program prints on a board what it prints on the host.
pub(crate) fn prints_the_same(board: &Board, found: &str, host: &str) -> Result<()> {
    let name = board.name;
    if let Some((line, host)) = found.lines().zip(host.lines()).find(|(line, host)| line != host) {
        bail!("{name}: not the bits of the host: `{line}`, on the host `{host}`");
    }
    ensure!(!host.is_empty() && found.lines().eq(host.lines()), "{name}: not all lines of the host");
    Ok(())
}

/// Reads the counter's file: `region address count` on each line. A region without executed instructions
/// has no line.
fn regions(text: &str) -> Result<Vec<Region>> {
    let mut regions = Vec::new();
    for line in text.lines() {
        let words: Vec<_> = line.split(' ').collect();
        let [region, address, count] = words[..] else { bail!("not a count: {line}") };
        let region: usize = region.parse()?;
        regions.resize(regions.len().max(region + 1), Region::new());
        regions[region].insert(u64::from_str_radix(address, 16)?, count.parse()?);
    }
    Ok(regions)
}

/// The version in `QEMU emulator version 7.2.22 (Debian …)`.
fn version(answer: &str) -> Option<(u32, u32)> {
    let (_, version) = answer.lines().next()?.split_once("version ")?;
    let mut numbers = version.split(|c: char| !c.is_ascii_digit()).map_while(|number| number.parse().ok());
    Some((numbers.next()?, numbers.next()?))
}

/// Unpacks the packages instead of installing them, and installs the libraries that they need. The
/// packages have some of the same files as a `qemu-utils` of another release: installed beside one, they
/// would leave the machine's packages in disorder.
fn unpack(folder: &Path, progress: &Progress) -> Result<()> {
    install::unpack(tool::QEMU.debian, folder, progress, |files| {
        let mut libraries = BTreeSet::new();
        for file in files {
            let depends = command::answer(Command::new("dpkg-deb").arg("-f").arg(file).arg("Depends"))?;
            // The first of each choice, as in `libc6 (>= 2.34), libfdt1 | libfdt2`.
            let first = depends.split(',').filter_map(|choice| choice.split_whitespace().next());
            libraries.extend(first.filter(|name| name.starts_with("lib")).map(str::to_owned));
        }
        install::apt(&libraries.iter().map(String::as_str).collect::<Vec<_>>(), progress)
    })
}
