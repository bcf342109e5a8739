//! Compilers of C and C++ for this machine and for small processors, and what the tests of C need beside them.

use std::path::Path;
use std::process::Command;

use anyhow::{Result, bail};

use crate::progress::Progress;
use crate::{command, install};

/// The compilers, each with a file of its library of C that is a package of its own, and Debian's
/// packages; and other programs and files.
const COMPILERS: [(&str, Option<&str>, &[&str]); 11] = [
    ("cc", None, &["gcc"]),
    ("c++", None, &["g++"]),
    ("clang", None, &["clang"]),
    ("arm-none-eabi-gcc", Some("rdimon.specs"), &["gcc-arm-none-eabi", "libnewlib-arm-none-eabi"]),
    ("arm-none-eabi-g++", None, &["gcc-arm-none-eabi"]),
    (
        "riscv64-unknown-elf-gcc",
        Some("picolibc.specs"),
        &["gcc-riscv64-unknown-elf", "picolibc-riscv64-unknown-elf"],
    ),
    ("avr-gcc", Some("libc.a"), &["gcc-avr", "avr-libc"]),
    ("avr-size", None, &["binutils-avr"]),
    ("simavr", None, &["simavr"]),
    ("/usr/share/arduino/hardware/arduino/avr/boards.txt", None, &["arduino-core-avr"]),
    ("cmake", None, &["cmake"]),
];

/// Finds the compilers and their libraries. As root on Debian, installs those that are missing.
pub fn find(progress: &Progress) -> Result<()> {
    let missing = COMPILERS.iter().filter(|(program, file, _)| !is_installed(program, *file));
    let packages: Vec<_> = missing.flat_map(|(_, _, packages)| *packages).copied().collect();
    if packages.is_empty() {
        return Ok(());
    }
    if !install::debian_root() {
        bail!("compilers of C are missing: on Debian, `apt-get install {}`", packages.join(" "));
    }
    install::apt(&packages, progress)
}

/// Whether a compiler is installed, and finds a file of its library.
fn is_installed(program: &str, file: Option<&str>) -> bool {
    // A file that the compiler does not find is printed as its name.
    let finds = |file: &str| {
        let place = command::answer(Command::new(program).arg(format!("-print-file-name={file}")));
        place.is_ok_and(|place| Path::new(place.trim()).is_absolute())
    };
    command::on_path(&[program]).is_some() && file.is_none_or(finds)
}
