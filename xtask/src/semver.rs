//! Compares the public API with that of the last release.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::{command, install, project};

use crate::test::features_of_luminaire;

/// Adds the step.
pub(crate) fn run(suite: &mut Suite) {
    suite.remarked("semver: the version says what has changed since the last release", |progress| {
        let Some(tag) = project::last_release() else {
            return Ok(vec!["there is no tag v* to compare with".to_owned()]);
        };
        let folder = tempfile::tempdir()?;
        let [release, crates] = ["release", "crates"].map(|name| folder.path().join(name));
        export(&tag, &release, progress)?;
        let checks = install::cargo_program("cargo-semver-checks", progress)?;
        // The renderer is compared unpacked: a packed renderer would need a kernel from a registry.
        let baselines = [
            ("core", packed("luminaire", &tag, &release, &crates, progress)?),
            ("render", release.join("render")),
        ];
        for (current, baseline) in baselines {
            let mut check = Command::new(&checks);
            check.args(["semver-checks", "--manifest-path"]);
            check.arg(project::root().join(current).join("Cargo.toml")).arg("--baseline-root").arg(baseline);
            if current == "core" {
                // The feature `arithmetic` is not covered by the promise of stability.
                let promised = features_of_luminaire()?.into_iter().filter(|name| name != "arithmetic");
                let promised: Vec<_> = promised.collect();
                check.args(["--only-explicit-features", "--features", &promised.join(",")]);
            }
            check.env("CARGO_TARGET_DIR", project::target().join("semver"));
            progress.run(check)?;
        }
        Ok(vec![format!("compared with {tag}")])
    });
}

/// Writes the files of a release into a folder.
fn export(tag: &str, folder: &Path, progress: &Progress) -> Result<()> {
    fs::create_dir_all(folder)?;
    let archive = folder.with_extension("tar");
    let mut git = Command::new("git");
    git.args(["archive", "--output"]).arg(&archive).arg(tag).current_dir(project::root());
    progress.run(git)?;
    unpack(&archive, folder, progress)
}

/// Packs a crate of an exported release. Returns the folder with the packed files, which are what
/// users get.
fn packed(name: &str, tag: &str, release: &Path, folder: &Path, progress: &Progress) -> Result<PathBuf> {
    let mut package = command::cargo("package");
    package.args(["--no-verify", "--package", name]).current_dir(release).env("CARGO_TARGET_DIR", folder);
    progress.run(package)?;
    let name = format!("{name}-{}", tag.trim_start_matches('v'));
    unpack(&folder.join("package").join(&name).with_added_extension("crate"), folder, progress)?;
    Ok(folder.join(name))
}

fn unpack(archive: &Path, into: &Path, progress: &Progress) -> Result<()> {
    let mut tar = Command::new("tar");
    tar.arg("xf").arg(archive).current_dir(into);
    progress.run(tar)
}
