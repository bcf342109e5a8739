//! The oldest compiler that the published crates promise to support.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};

use tools::progress::Progress;
use tools::suite::Suite;
use tools::{command, install, project};

/// The compiler, as in `rust-version` of the published crates.
const VERSION: &str = "1.85";

/// The crates that promise it, and their folders.
const CRATES: [(&str, &str); 3] =
    [("luminaire", "core"), ("luminaire-render", "render"), ("luminaire-fixtures", "export/fixtures")];

/// Debian's packages of compilers of that version, each with the packages of its standard library.
const COMPILERS: [(&str, [&str; 2]); 2] = [
    ("rustc", ["libstd-rust-dev", "libstd-rust-1.85"]),
    ("rustc-web", ["libstd-rust-web-dev", "libstd-rust-web-1.85"]),
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
        let mut check = command::cargo("check");
        check.args(["--lib", "--all-features"]);
        check.args(CRATES.iter().flat_map(|(name, _)| ["--package", name]));
        check.env("RUSTC", usr.join("bin/rustc")).env("LD_LIBRARY_PATH", usr.join("lib/x86_64-linux-gnu"));
        check.env("CARGO_TARGET_DIR", project::target().join("oldest-compiler"));
        progress.run(check).map(|()| Vec::new())
    });
}

/// The folder `usr` of the compiler, which is unpacked below `target` and not installed. `None` if
/// apt does not know the compiler.
fn unpacked(progress: &Progress) -> Result<Option<PathBuf>> {
    let folder = project::target().join("tools/oldest-compiler");
    let usr = folder.join("usr");
    if usr.join("bin/rustc").exists() {
        return Ok(Some(usr));
    }
    let Some((packages, version)) = COMPILERS.iter().find_map(offered) else { return Ok(None) };
    fs::create_dir_all(&folder).with_context(|| format!("cannot create {}", folder.display()))?;
    let wanted = packages.iter().map(|package| format!("{package}={version}")).chain([LLVM.to_owned()]);
    let wanted: Vec<_> = ["download".to_owned()].into_iter().chain(wanted).collect();
    install::apt_get(&wanted.iter().map(String::as_str).collect::<Vec<_>>(), &folder, progress)?;
    for entry in fs::read_dir(&folder)? {
        let package = entry?.path();
        if package.extension().is_some_and(|extension| extension == "deb") {
            let mut unpack = Command::new("dpkg-deb");
            unpack.arg("-x").arg(&package).arg(&folder);
            progress.run(unpack)?;
            fs::remove_file(package)?;
        }
    }
    Ok(Some(usr))
}

/// A compiler's packages and full version, if apt offers it in the promised version.
fn offered((compiler, library): &(&'static str, [&'static str; 2])) -> Option<([&'static str; 3], String)> {
    let table = command::answer(Command::new("apt-cache").args(["madison", compiler])).ok()?;
    let version = version(&table, VERSION)?;
    Some(([compiler, library[0], library[1]], version.to_owned()))
}

/// The first version in a table of `apt-cache madison` that begins with `begin`.
fn version<'a>(table: &'a str, begin: &str) -> Option<&'a str> {
    let mut versions = table.lines().filter_map(|line| line.split('|').nth(1)).map(str::trim);
    versions.find(|version| version.strip_prefix(begin).is_some_and(|rest| rest.starts_with('.')))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_is_that_of_the_published_manifests() {
        for (name, folder) in CRATES {
            let manifest = fs::read_to_string(project::root().join(folder).join("Cargo.toml")).unwrap();
            assert!(manifest.contains(&format!("rust-version = \"{VERSION}\"")), "{name}");
        }
    }

    #[test]
    fn a_version_is_found_in_the_table_of_apt() {
        let table = " rustc-web | 1.96.0+dfsg1-1~deb12u2 | http://one\n rustc-web | 1.85.0+dfsg3-1~deb12u3 | http://two\n";
        assert_eq!(version(table, "1.85"), Some("1.85.0+dfsg3-1~deb12u3"));
        assert_eq!(version(table, "1.8"), None);
        assert_eq!(version("", "1.85"), None);
    }
}
