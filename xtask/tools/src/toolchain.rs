//! Finding a compiler for a target whose standard library may not be installed.
//!
//! The first choice is an installed standard library. Otherwise the library is built from its
//! source, by a compiler that has the source beside it: the active one, or the distribution's.
//! Nothing is installed with rustup, whose toolchains are the user's choice.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, bail};

use crate::progress::Progress;
use crate::system::System;
use crate::{command, install, project};

/// Debian's compiler for web browsers: recent, and with its library's source as a package.
const DEBIAN_PACKAGES: [&str; 4] = ["rustc-web", "rust-web-src", "cargo-web", "lld"];
/// Targets of tier 3: rustup has no standard library for them.
const FROM_SOURCE: [&str; 1] = ["armv4t-none-eabi"];
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";

/// A target, and where its standard library comes from.
#[derive(Debug)]
pub struct Toolchain {
    target: &'static str,
    library: Library,
    /// The features of the processor, as flags of rustc.
    flags: &'static str,
}

#[derive(Debug)]
enum Library {
    Installed,
    FromSource { rustc: PathBuf },
}

impl Toolchain {
    /// Finds a compiler for `target`. As root on Debian, installs one if there is none.
    pub fn find(target: &'static str, progress: &Progress) -> Result<Self> {
        if has_library(target) {
            return Ok(Self { target, library: Library::Installed, flags: "" });
        }
        if let Some(rustc) = rustc_with_source() {
            return Ok(Self { target, library: Library::FromSource { rustc }, flags: "" });
        }
        if install::debian_root() {
            install::apt(&DEBIAN_PACKAGES, progress)?;
            if let Some(rustc) = rustc_with_source() {
                return Ok(Self { target, library: Library::FromSource { rustc }, flags: "" });
            }
        }
        bail!("the standard library for {target} is not installed: {}", remedy(target, System::HERE))
    }

    /// Compiles for a processor with more features than the target's, by a flag of rustc.
    #[must_use]
    pub fn with_flags(self, flags: &'static str) -> Self {
        Self { flags, ..self }
    }

    /// A call of cargo for the target, such as `cargo build`. If the standard library is built from
    /// source, `library` names the crates to build, such as `core,alloc`.
    pub fn cargo(&self, library: &str, words: impl IntoIterator<Item: AsRef<OsStr>>) -> Command {
        let mut build = command::cargo(words);
        build.args(["--target", self.target]);
        let variable = format!("CARGO_TARGET_{}_LINKER", self.target.to_uppercase().replace(['-', '.'], "_"));
        if let (None, Some(linker)) = (env::var_os(&variable), linker(self.target)) {
            build.env(variable, linker);
        }
        // Flags in the environment are meant for the host. Incremental compilation inlines in another
        // way: the template takes 3.8 kB with it, and 4.0 kB without (measured).
        build
            .env_remove("RUSTFLAGS")
            .env("CARGO_ENCODED_RUSTFLAGS", self.flags)
            .env_remove("CARGO_INCREMENTAL");
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

    /// Builds firmware in a folder, with further words of `cargo build`.
    pub fn build(&self, folder: &Path, words: &[&str], progress: &Progress) -> Result<()> {
        let mut build = self.cargo("core", ["build"]);
        build.args(words).current_dir(folder);
        progress.run(build)
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

/// How to install the standard library for a target, in words.
fn remedy(target: &str, system: System) -> String {
    let packages = DEBIAN_PACKAGES.join(" ");
    let debian = match system {
        System::Linux => format!(", or on Debian, as root, `apt-get install {packages}`"),
        System::Mac | System::Windows => String::new(),
    };
    let rustup = match FROM_SOURCE.contains(&target) {
        true => "component add rust-src".to_owned(),
        false => format!("target add {target}"),
    };
    format!("`rustup {rustup}`{debian}")
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
    let is_core = |file: &str| file.starts_with("libcore-") && file.ends_with(".rlib");
    entries.flatten().any(|entry| is_core(&entry.file_name().to_string_lossy()))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_target_is_named_with_what_adds_it() {
        let rustup = "`rustup target add thumbv7m-none-eabi`";
        let linux = format!(
            "{rustup}, or on Debian, as root, `apt-get install rustc-web rust-web-src cargo-web lld`"
        );
        for (system, words) in [(System::Linux, &*linux), (System::Mac, rustup), (System::Windows, rustup)] {
            assert_eq!(remedy("thumbv7m-none-eabi", system), words, "{system:?}");
        }
        assert_eq!(remedy("armv4t-none-eabi", System::Mac), "`rustup component add rust-src`");
    }
}
