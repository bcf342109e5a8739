//! The oldest compiler that the published crates promise to support.

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;

use tools::progress::Progress;
use tools::suite::Suite;
use tools::{command, install, project};

/// The compiler, as in `rust-version` of the published crates.
pub(crate) const VERSION: &str = "1.85";

/// The crates that promise it, and their folders.
const CRATES: [(&str, &str); 4] = [
    ("luminaire", "core"),
    ("luminaire-native", "native"),
    ("luminaire-render", "render"),
    ("luminaire-fixtures", "export/fixtures"),
];

/// Debian's packages of compilers of that version, each with those of its standard library.
const PACKAGES: [[&str; 3]; 2] = [
    ["rustc", "libstd-rust-dev", "libstd-rust-1.85"],
    ["rustc-web", "libstd-rust-web-dev", "libstd-rust-web-1.85"],
];

/// The package of the library that all these compilers are linked with.
const LLVM: &str = "libllvm19";

/// Adds the step: the published crates compile with the oldest compiler. If Debian's packages
/// cannot be downloaded, nothing is compiled, and only clippy checks that the promised version has
/// every item that is used.
pub(crate) fn run(suite: &mut Suite) {
    suite.remarked(&format!("oldest compiler: the crates compile with rustc {VERSION}"), |progress| {
        let Some(usr) = unpacked(progress)? else {
            return Ok(vec!["not compiled: there is no such package of Debian; clippy checks it".to_owned()]);
        };
        let mut check = command::cargo(["check", "--lib", "--all-features"]);
        check.args(CRATES.iter().flat_map(|(name, _)| ["--package", name]));
        check.env("RUSTC", usr.join("bin/rustc")).env("LD_LIBRARY_PATH", usr.join("lib/x86_64-linux-gnu"));
        check.env("CARGO_TARGET_DIR", project::target().join("oldest-compiler"));
        progress.run(check).map(|()| Vec::new())
    });
}

/// The folder `usr` of the compiler, which is unpacked below `target` and not installed. `None` if
/// apt does not offer it.
fn unpacked(progress: &Progress) -> Result<Option<PathBuf>> {
    let folder = project::target().join("tools/oldest-compiler");
    let usr = folder.join("usr");
    if usr.join("bin/rustc").exists() {
        return Ok(Some(usr));
    }
    let Some(packages) = PACKAGES.iter().find_map(|packages| offered(packages)) else { return Ok(None) };
    let packages: Vec<_> = [LLVM].into_iter().chain(packages.iter().map(String::as_str)).collect();
    install::unpack(&packages, &folder, progress, |_| Ok(()))?;
    Ok(Some(usr))
}

/// A compiler's packages with their version, as in `rustc=1.85.0+dfsg3-1`, if apt offers the promised
/// one.
fn offered(packages: &[&str]) -> Option<Vec<String>> {
    // A row is `name | version | source`.
    let table = command::answer(Command::new("apt-cache").args(["madison", packages[0]])).ok()?;
    let mut versions = table.lines().filter_map(|line| line.split('|').nth(1)).map(str::trim);
    let version = versions.find(|version| version.starts_with(&format!("{VERSION}.")))?;
    Some(packages.iter().map(|package| format!("{package}={version}")).collect())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn the_version_is_that_of_the_published_manifests() {
        for (name, folder) in CRATES {
            let manifest = fs::read_to_string(project::root().join(folder).join("Cargo.toml")).unwrap();
            assert!(manifest.contains(&format!("rust-version = \"{VERSION}\"")), "{name}");
        }
    }
}
