//! Finding a compiler for a target whose standard library may not be installed.
//!
//! The first choice is an installed standard library. Otherwise the library is built from its
//! source, by a compiler that has the source beside it: the active one, or the distribution's.
//! Nothing is installed with rustup, whose toolchains are the user's choice.

use std::env;
use std::iter;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, bail};

use crate::progress::Progress;
use crate::{command, install, project};

/// Debian's compiler for web browsers: recent, and with its library's source as a package.
const DEBIAN_PACKAGES: [&str; 4] = ["rustc-web", "rust-web-src", "cargo-web", "lld"];
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";

/// A target, and where its standard library comes from.
#[derive(Debug)]
pub struct Toolchain {
    target: &'static str,
    library: Library,
}

#[derive(Debug, PartialEq)]
enum Library {
    Installed,
    FromSource { rustc: PathBuf },
}

impl Toolchain {
    /// Finds a compiler for `target`. As root on Debian, installs one if there is none.
    pub fn find(target: &'static str, progress: &Progress) -> Result<Self> {
        if has_library(target) {
            return Ok(Self { target, library: Library::Installed });
        }
        if let Some(rustc) = rustc_with_source() {
            return Ok(Self { target, library: Library::FromSource { rustc } });
        }
        if install::debian_root() {
            install::apt(&DEBIAN_PACKAGES, progress)?;
            if let Some(rustc) = rustc_with_source() {
                return Ok(Self { target, library: Library::FromSource { rustc } });
            }
        }
        bail!(
            "the standard library for {target} is not installed: run `rustup target add {target}`, \
             or on Debian as root `apt-get install {}`",
            DEBIAN_PACKAGES.join(" ")
        )
    }

    /// A `cargo build` for the target. If the standard library is built from source, `library`
    /// names the crates to build, such as `core,alloc`. `flags` are flags of the compiler.
    pub fn cargo_build(&self, library: &str, flags: &[&str]) -> Command {
        self.cargo("build", &[], library, flags)
    }

    /// A `cargo check` for the target: finds the errors of a build, without code generation.
    pub fn cargo_check(&self, library: &str) -> Command {
        self.cargo("check", &[], library, &[])
    }

    /// `cargo build` for many targets: one call per group of targets whose libraries come from the
    /// same place. A call builds for its targets side by side.
    pub fn cargo_builds(toolchains: &[Self], library: &str, flags: &[&str]) -> Vec<Command> {
        let groups = toolchains.chunk_by(|one, next| one.library == next.library);
        let build = |group: &[Self]| {
            let (first, rest) = group.split_first()?;
            Some(first.cargo("build", rest, library, flags))
        };
        groups.filter_map(build).collect()
    }

    /// A command of cargo for the target, and for others whose library comes from the same place.
    fn cargo(&self, command: &str, others: &[Self], library: &str, flags: &[&str]) -> Command {
        let mut build = command::cargo(command);
        for target in iter::once(self).chain(others).map(|toolchain| toolchain.target) {
            build.args(["--target", target]);
            let variable = linker_variable(target);
            if let (None, Some(linker)) = (env::var_os(&variable), linker(target)) {
                build.env(variable, linker);
            }
        }
        // Flags in the environment are meant for the host, and would silently replace `flags`.
        build.env_remove("RUSTFLAGS").env("CARGO_ENCODED_RUSTFLAGS", flags.join("\u{1f}"));
        if let Library::FromSource { rustc } = &self.library {
            // Without features: what shows a backtrace is a tenth of the library's build, and is never linked.
            build.arg(format!("-Zbuild-std={library}")).arg("-Zbuild-std-features=");
            build.arg("--target-dir").arg(self.target_dir());
            build.env("RUSTC", rustc).env("RUSTC_BOOTSTRAP", "1");
            // These variables belong to the active compiler, and `rustc` may be another.
            build.env("RUSTC_WRAPPER", "").env("RUSTC_WORKSPACE_WRAPPER", "").env_remove("LD_LIBRARY_PATH");
        }
        build
    }

    /// The folder of what was built with a profile.
    pub fn artifacts(&self, profile: &str) -> PathBuf {
        self.target_dir().join(self.target).join(profile)
    }

    /// The compiler, as in `rustc 1.96.0`.
    pub fn compiler(&self) -> Result<String> {
        match &self.library {
            Library::Installed => active_compiler(),
            Library::FromSource { rustc } => version_of(rustc),
        }
    }

    /// Where the standard library comes from, for people.
    pub fn describe(&self) -> String {
        match &self.library {
            Library::Installed => format!("{}, standard library installed", self.target),
            Library::FromSource { rustc } => {
                format!("{}, standard library from source by {}", self.target, rustc.display())
            }
        }
    }

    /// Each compiler has its own folder: two compilers in one folder would rebuild everything on
    /// every call.
    fn target_dir(&self) -> PathBuf {
        match self.library {
            Library::Installed => project::target(),
            Library::FromSource { .. } => project::target().join("build-std"),
        }
    }
}

fn active_rustc() -> PathBuf {
    env::var_os("RUSTC").map_or_else(|| "rustc".into(), PathBuf::from)
}

/// The compiler that the host's programs are compiled with, as in `rustc 1.96.0`.
pub fn active_compiler() -> Result<String> {
    version_of(&active_rustc())
}

fn version_of(rustc: &Path) -> Result<String> {
    let told = command::answer(Command::new(rustc).current_dir(project::root()).arg("--version"))?;
    Ok(told.split(' ').take(2).collect::<Vec<_>>().join(" "))
}

fn print(rustc: &Path, what: &[&str]) -> Option<String> {
    command::answer(Command::new(rustc).current_dir(project::root()).arg("--print").args(what)).ok()
}

/// Whether the library is installed. rustc prints the folder's path even if the folder is missing,
/// so this looks for the library itself.
fn has_library(target: &str) -> bool {
    let Some(folder) = print(&active_rustc(), &["target-libdir", "--target", target]) else { return false };
    let Ok(entries) = Path::new(&folder).read_dir() else { return false };
    entries.flatten().any(|entry| is_core(&entry.file_name().to_string_lossy()))
}

fn is_core(file: &str) -> bool {
    file.starts_with("libcore-") && file.ends_with(".rlib")
}

fn rustc_with_source() -> Option<PathBuf> {
    [active_rustc(), DEBIAN_RUSTC.into()].into_iter().find(|rustc| {
        print(rustc, &["sysroot"])
            .is_some_and(|sysroot| Path::new(&sysroot).join("lib/rustlib/src/rust/library/core").exists())
    })
}

/// The linker that rustup has installed, else the system's. A distribution's compiler may come
/// without one.
fn linker(target: &str) -> Option<PathBuf> {
    let bundled = || {
        let sysroot = print(&active_rustc(), &["sysroot"])?;
        let host = print(&active_rustc(), &["host-tuple"])?;
        let folder = Path::new(&sysroot).join("lib/rustlib").join(host).join("bin");
        let file = folder.join(format!("rust-lld{}", env::consts::EXE_SUFFIX));
        file.is_file().then_some(file)
    };
    let system = if target.starts_with("wasm") { "wasm-ld" } else { "ld.lld" };
    bundled().or_else(|| command::on_path(&[system]))
}

fn linker_variable(target: &str) -> String {
    format!("CARGO_TARGET_{}_LINKER", target.to_uppercase().replace(['-', '.'], "_"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_linker_variable_is_the_one_cargo_reads() {
        assert_eq!(linker_variable("wasm32-unknown-unknown"), "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER");
        assert_eq!(linker_variable("thumbv8m.main-none-eabi"), "CARGO_TARGET_THUMBV8M_MAIN_NONE_EABI_LINKER");
    }

    #[test]
    fn only_the_compiled_core_counts_as_installed() {
        assert!(is_core("libcore-9d2c1a.rlib"));
        assert!(!is_core("libcore-9d2c1a.rmeta"));
        assert!(!is_core("libcortex_m-9d2c1a.rlib"));
    }
}
