//! What the kernel brings into a new project: the packages that cargo chooses without a lock file.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use tools::progress::Progress;
use tools::{command, project};

use crate::features::BARE_METAL;
use crate::msrv;

/// A new project that depends on the kernel.
struct New {
    title: &'static str,
    /// What follows the path in the line of the kernel.
    kernel: &'static str,
    /// The other dependencies.
    beside: &'static str,
    target: &'static str,
    /// The packages that it would not have without the kernel, sorted.
    added: &'static [&'static str],
}

const PROJECTS: [New; 6] = [
    New {
        title: "firmware",
        kernel: ", default-features = false, features = ['fixed']",
        beside: "",
        target: BARE_METAL,
        added: &["az", "bytemuck", "cfg-if", "fixed", "half", "typenum"],
    },
    New {
        title: "firmware for a processor with floats",
        kernel: ", default-features = false, features = ['fixed', 'native']",
        beside: "",
        target: "thumbv8m.main-none-eabihf",
        added: &["az", "bytemuck", "cfg-if", "fixed", "half", "luminaire-native", "typenum"],
    },
    New {
        title: "`f32` alone",
        kernel: ", default-features = false",
        beside: "",
        target: BARE_METAL,
        added: &[],
    },
    New {
        title: "the default features",
        kernel: "",
        beside: "",
        target: "x86_64-unknown-linux-gnu",
        added: &["az", "bytemuck", "cfg-if", "fixed", "half", "libm", "luminaire-native", "typenum"],
    },
    New {
        title: "firmware beside embedded-graphics",
        kernel: ", default-features = false, features = ['embedded-graphics-core04', 'fixed']",
        beside: "embedded-graphics = '0.8'",
        target: BARE_METAL,
        added: &["bytemuck", "cfg-if", "fixed", "half", "typenum"],
    },
    New {
        title: "the default features beside the newest embedded-graphics-core",
        kernel: ", features = ['embedded-graphics-core04']",
        beside: "embedded-graphics-core = '0.4.1'",
        target: BARE_METAL,
        added: &["bytemuck", "cfg-if", "fixed", "half", "libm", "luminaire-native", "typenum"],
    },
];

/// Resolves each project with the newest compiler, and with the oldest one that the kernel supports:
/// fails unless the kernel brings the expected packages, without a procedural macro and for that compiler.
/// `kernel` is its folder, and `settings` are cargo's for what is not on a registry. Returns remarks.
pub(crate) fn check(kernel: &Path, settings: &str, progress: &Progress) -> Result<Vec<String>> {
    let mut remarks = Vec::new();
    for new in PROJECTS {
        for oldest in [None, Some(msrv::VERSION)] {
            let dependency = format!("luminaire = {{ path = {kernel:?}{} }}\n", new.kernel);
            let before = resolved(&new, oldest, "", "", progress)?;
            let mut added = resolved(&new, oldest, &dependency, settings, progress)?;
            added.retain(|name, _| name != "luminaire" && !before.contains_key(name));
            let names: Vec<_> = added.keys().map(String::as_str).collect();
            ensure!(names == new.added, "{}: expected {:?}, found {names:?}", new.title, new.added);
            added.values().try_for_each(|package| is_fit(package, oldest))?;
        }
        remarks.push(format!("{}: {}", new.title, in_words(new.added)));
    }
    let readme = fs::read_to_string(project::root().join("README.md"))?;
    let readme = readme.split_whitespace().collect::<Vec<_>>().join(" ");
    let words = in_words(PROJECTS[0].added);
    ensure!(readme.contains(&words), "README.md: expected `{words}`");
    Ok(remarks)
}

/// As in ``2 packages: `az` and `half` ``.
fn in_words(names: &[&str]) -> String {
    if names.is_empty() {
        return "no packages".to_owned();
    }
    let list = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let list = list.rsplit_once(", ").map_or(list.clone(), |(first, last)| format!("{first} and {last}"));
    format!("{} packages: {list}", names.len())
}

/// The packages of a project with these lines of its dependencies, by name.
fn resolved(
    new: &New,
    oldest: Option<&str>,
    dependency: &str,
    settings: &str,
    progress: &Progress,
) -> Result<BTreeMap<String, Value>> {
    let folder = tempfile::tempdir()?;
    let oldest = oldest.map_or(String::new(), |version| format!("rust-version = '{version}'\n"));
    let manifest = format!(
        "[package]\nname = 'new'\nedition = '2024'\n{oldest}\n[dependencies]\n{dependency}{}\n{settings}",
        new.beside
    );
    fs::write(folder.path().join("Cargo.toml"), manifest)?;
    fs::create_dir(folder.path().join("src"))?;
    fs::write(folder.path().join("src/lib.rs"), "#![no_std]\n")?;
    progress.say("Resolving", new.title);
    let mut metadata = command::cargo(["metadata", "--format-version=1", "--filter-platform", new.target]);
    let metadata = command::answer(metadata.current_dir(folder.path()))?;
    let metadata: Value = serde_json::from_str(&metadata).context("cargo metadata is no JSON")?;
    let packages = metadata["packages"].as_array().context("cargo metadata has no packages")?;
    let mut by_name = BTreeMap::new();
    for package in packages.iter().filter(|package| package["name"] != "new") {
        let name = package["name"].as_str().context("a package has a name")?.to_owned();
        if by_name.insert(name, package.clone()).is_some() {
            bail!("{}: two versions of {}", new.title, package["name"]);
        }
    }
    Ok(by_name)
}

/// Fails if a package is a procedural macro, or needs a later compiler.
fn is_fit(package: &Value, oldest: Option<&str>) -> Result<()> {
    let kinds = package["targets"].as_array().into_iter().flatten().map(|target| &target["kind"][0]);
    ensure!(kinds.into_iter().all(|kind| kind != "proc-macro"), "{} is a macro", package["name"]);
    let (Some(oldest), Some(needed)) = (oldest, package["rust_version"].as_str()) else { return Ok(()) };
    let numbers = |version: &str| version.split('.').take(2).map(str::parse).collect::<Result<Vec<u32>, _>>();
    ensure!(numbers(needed)? <= numbers(oldest)?, "{} needs rustc {needed}", package["name"]);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_macro_and_a_package_for_a_later_compiler_are_not_fit() {
        let package = |kind: &str, version: &str| serde_json::json!({ "name": "a", "rust_version": version, "targets": [{ "kind": [kind] }] });
        assert!(is_fit(&package("lib", "1.85.0"), Some("1.85")).is_ok());
        assert!(is_fit(&package("lib", "1.93"), None).is_ok());
        assert!(is_fit(&package("lib", "1.93"), Some("1.85")).is_err());
        assert!(is_fit(&package("proc-macro", "1.56"), None).is_err());
    }

    #[test]
    fn packages_are_listed_in_words() {
        assert_eq!(in_words(&["az", "fixed", "half"]), "3 packages: `az`, `fixed` and `half`");
        assert_eq!(in_words(&[]), "no packages");
    }
}
