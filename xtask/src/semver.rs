//! The public API against that of the last release.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::{command, install, project};

/// The crates whose API is promised, and their folders.
const CRATES: [(&str, &str); 2] = [("luminaire", "core"), ("luminaire-render", "render")];

/// Adds the step.
pub(crate) fn run(suite: &mut Suite) {
    suite.remarked("semver: the version says what has changed since the last release", |progress| {
        let Some(tag) = last_release() else {
            return Ok(vec!["there is no tag v* to compare with".to_owned()]);
        };
        let folder = tempfile::tempdir()?;
        let checks = install::cargo_program("cargo-semver-checks", progress)?;
        for (name, current) in CRATES {
            let baseline = packed(&tag, name, folder.path(), progress)?;
            let mut check = Command::new(&checks);
            check.args(["semver-checks", "--manifest-path"]);
            check.arg(project::root().join(current).join("Cargo.toml")).arg("--baseline-root").arg(baseline);
            check.env("CARGO_TARGET_DIR", project::target().join("semver"));
            progress.run(check)?;
        }
        Ok(vec![format!("compared with {tag}")])
    });
}

/// The tag of the last release, if there is one.
fn last_release() -> Option<String> {
    let mut describe = Command::new("git");
    describe.args(["describe", "--tags", "--abbrev=0", "--match", "v*"]).current_dir(project::root());
    command::answer(&mut describe).ok()
}

/// The folder of a crate as it was packed for a release: what its users have.
fn packed(tag: &str, name: &str, folder: &Path, progress: &Progress) -> Result<PathBuf> {
    let (source, archive) = (folder.join("source"), folder.join("release.tar"));
    std::fs::create_dir_all(&source)?;
    let mut export = Command::new("git");
    export.args(["archive", "--output"]).arg(&archive).arg(tag).current_dir(project::root());
    progress.run(export)?;
    let unpack = |archive: &Path, into: &Path| {
        let mut tar = Command::new("tar");
        tar.arg("xf").arg(archive).current_dir(into);
        progress.run(tar)
    };
    unpack(&archive, &source)?;
    let mut package = command::cargo("package");
    package.args(["--no-verify", "--package", name]).current_dir(&source).env("CARGO_TARGET_DIR", folder);
    if name != "luminaire" {
        package.args(["--package", "luminaire"]);
    }
    progress.run(package)?;
    let release = format!("{name}-{}", tag.trim_start_matches('v'));
    unpack(&folder.join("package").join(&release).with_added_extension("crate"), folder)?;
    Ok(folder.join(release))
}
