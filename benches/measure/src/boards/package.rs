//! Finding QEMU, or unpacking Debian's packages of it into `target/tools`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

use tools::progress::Progress;
use tools::{command, install, project};

/// Debian's packages of the emulators, and of the files that the emulators share.
const PACKAGES: [&str; 4] = ["qemu-system-arm", "qemu-system-misc", "qemu-system-common", "qemu-system-data"];
/// The packages that hold programs. The libraries that they depend on are installed.
const PROGRAMS: [&str; 2] = ["qemu-system-arm", "qemu-system-misc"];

/// Finds one of QEMU's programs, on PATH or among the unpacked packages. As root on Debian, unpacks
/// the packages if they are missing.
pub(crate) fn program(name: &str, progress: &Progress) -> Result<PathBuf> {
    if let Some(program) = command::on_path(&[name]) {
        return Ok(program);
    }
    let program = folder().join("usr/bin").join(name);
    if !program.is_file() {
        if !install::debian_root() {
            bail!(
                "{name} is not installed: install QEMU's emulators for Arm and RISC-V, \
                 on Debian by `apt-get install {}`",
                PROGRAMS.join(" ")
            );
        }
        unpack(&folder(), progress)?;
    }
    Ok(program)
}

fn folder() -> PathBuf {
    project::target().join("tools/qemu")
}

/// Unpacks the packages instead of installing them. They contain some of the same files as a
/// `qemu-utils` of another release; installing them beside one would leave the machine's packages
/// in disorder.
fn unpack(folder: &Path, progress: &Progress) -> Result<()> {
    let step = progress.begin("Unpacking", "Debian packages of QEMU into target/tools/qemu");
    fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    for words in [&["update"][..], &[&["download"][..], &PACKAGES].concat()] {
        install::apt_get(words, folder, progress)?;
    }
    let mut libraries = Vec::new();
    for entry in fs::read_dir(folder)? {
        let file = entry?.path();
        if file.extension().is_none_or(|extension| extension != "deb") {
            continue;
        }
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if PROGRAMS.iter().any(|program| name.starts_with(program)) {
            let depends = command::answer(Command::new("dpkg-deb").arg("-f").arg(&file).arg("Depends"))?;
            libraries.extend(names(&depends));
        }
        let mut extract = Command::new("dpkg-deb");
        extract.arg("-x").arg(&file).arg(folder);
        progress.run(extract)?;
        fs::remove_file(&file).with_context(|| format!("cannot remove {}", file.display()))?;
    }
    libraries.sort_unstable();
    libraries.dedup();
    install::apt(&libraries.iter().map(String::as_str).collect::<Vec<_>>(), progress)?;
    step.done();
    Ok(())
}

/// The package names in a list such as
/// `libc6 (>= 2.34), libfdt1 | libfdt2, qemu-system-common (= 7.2)`: the first of each choice,
/// without the packages that `unpack` unpacks itself.
fn names(depends: &str) -> impl Iterator<Item = String> {
    let names = depends.split(',').filter_map(|choice| choice.split_whitespace().next());
    names.filter(|name| !PACKAGES.contains(name)).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn libraries_are_told_from_versions_and_from_what_is_unpacked() {
        let depends = "libc6 (>= 2.34), libfdt1 | libfdt2, qemu-system-common (= 1:7.2), zlib1g";
        assert_eq!(names(depends).collect::<Vec<_>>(), ["libc6", "libfdt1", "zlib1g"]);
    }
}
