//! Compilers of C and C++ for this machine and for small processors.

use anyhow::{Result, bail};

use crate::progress::Progress;
use crate::{command, install};

/// The compilers, and Debian's packages of them.
const COMPILERS: [(&str, &[&str]); 5] = [
    ("cc", &["gcc"]),
    ("c++", &["g++"]),
    ("arm-none-eabi-gcc", &["gcc-arm-none-eabi", "libnewlib-arm-none-eabi"]),
    ("arm-none-eabi-g++", &["gcc-arm-none-eabi"]),
    ("riscv64-unknown-elf-gcc", &["gcc-riscv64-unknown-elf"]),
];

/// Finds the compilers. As root on Debian, installs those that are missing.
pub fn find(progress: &Progress) -> Result<()> {
    let missing = COMPILERS.iter().filter(|(program, _)| command::on_path(&[program]).is_none());
    let packages: Vec<_> = missing.flat_map(|(_, packages)| *packages).copied().collect();
    if packages.is_empty() {
        return Ok(());
    }
    if !install::debian_root() {
        bail!("compilers of C are missing: on Debian, `apt-get install {}`", packages.join(" "));
    }
    install::apt(&packages, progress)
}
