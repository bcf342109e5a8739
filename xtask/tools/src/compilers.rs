//! Compilers of C and C++ for this machine and for small processors, and what the tests of C need beside them.

use std::path::Path;
use std::process::Command;

use anyhow::{Result, bail};

use crate::progress::Progress;
use crate::system::System;
use crate::tool::{self, Tool};
use crate::{command, install};

/// The compilers, each with a file of its library of C that is a package of its own; and other programs
/// and files.
const COMPILERS: [(&Tool, Option<&str>); 13] = [
    (&tool::CC, None),
    (&tool::CXX, None),
    (&tool::CLANG, None),
    (&tool::ARM_CC, Some("rdimon.specs")),
    (&tool::ARM_CXX, None),
    (&tool::RISCV_CC, Some("picolibc.specs")),
    (&tool::XTENSA_CC, None),
    (&tool::XTENSA_LIBRARY, None),
    (&tool::AVR_CC, Some("libc.a")),
    (&tool::AVR_SIZE, None),
    (&tool::SIMAVR, None),
    (&tool::ARDUINO, None),
    (&tool::CMAKE, None),
];

/// Finds the compilers and their libraries. As root on Debian, installs those that are missing.
pub fn find(progress: &Progress) -> Result<()> {
    let missing = COMPILERS.iter().filter(|(tool, file)| !is_installed(tool, *file));
    let missing: Vec<_> = missing.map(|(tool, _)| *tool).collect();
    if missing.is_empty() {
        return Ok(());
    }
    if !install::debian_root() {
        bail!("compilers of C are missing: {}", tool::remedy(&missing, System::HERE));
    }
    install::apt(&missing.iter().flat_map(|tool| tool.debian).copied().collect::<Vec<_>>(), progress)
}

/// Whether a compiler is installed, and finds a file of its library.
fn is_installed(tool: &Tool, file: Option<&str>) -> bool {
    let Some(program) = tool.find() else { return false };
    // A file that the compiler does not find is printed as its name.
    let finds = |file: &str| {
        let place = command::answer(Command::new(&program).arg(format!("-print-file-name={file}")));
        place.is_ok_and(|place| Path::new(place.trim()).is_absolute())
    };
    file.is_none_or(finds)
}
