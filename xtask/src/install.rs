//! Installing missing tools: Debian packages where we may, npm packages into the project's own target folder.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};

use crate::progress::Progress;
use crate::{command, project};

/// Whether Debian packages can be installed without asking anybody: this is Debian, and we are root.
pub(crate) fn debian_root() -> bool {
    let debian = fs::read_to_string("/etc/os-release").is_ok_and(|release| is_debian(&release));
    debian && command::answer(Command::new("id").arg("-u")).is_ok_and(|user| user == "0")
}

fn is_debian(os_release: &str) -> bool {
    os_release.lines().any(|line| line == "ID=debian" || line == "ID=\"debian\"")
}

/// Installs Debian packages. Ask [`debian_root`] first.
pub(crate) fn apt(packages: &[&str], progress: &Progress) -> Result<()> {
    let step = progress.begin("Installing", format_args!("Debian packages: {}", packages.join(" ")));
    let apt_get = || {
        let mut command = Command::new("apt-get");
        command.env("DEBIAN_FRONTEND", "noninteractive");
        command
    };
    let remedy = || {
        format!("cannot install them: try `apt-get update && apt-get install {}` by hand", packages.join(" "))
    };
    let mut update = apt_get();
    update.arg("update");
    progress.run(update).with_context(remedy)?;
    let mut install = apt_get();
    install.args(["install", "-y", "--no-install-recommends"]).args(packages);
    progress.run(install).with_context(remedy)?;
    step.done();
    Ok(())
}

/// The program that an npm package brought into `target/tools`, if it was installed there.
pub(crate) fn npm_program(name: &str) -> Option<PathBuf> {
    let program = tools().join("node_modules/.bin").join(name);
    program.is_file().then_some(program)
}

/// Installs an npm package into `target/tools`, never globally.
pub(crate) fn npm(package: &str, progress: &Progress) -> Result<()> {
    let npm = command::on_path(&["npm"]).context("npm is not installed")?;
    let step = progress.begin("Installing", format_args!("npm package {package} into target/tools"));
    fs::create_dir_all(tools()).with_context(|| format!("cannot create {}", tools().display()))?;
    let mut install = Command::new(npm);
    // Without a network the default retries would hold up the build for minutes.
    install.args(["install", "--no-audit", "--no-fund", "--fetch-retries=1", "--fetch-timeout=60000"]);
    install.arg("--prefix").arg(tools()).arg(package).current_dir(tools());
    progress.run(install)?;
    step.done();
    Ok(())
}

fn tools() -> PathBuf {
    project::target().join("tools")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_debian_itself_is_debian() {
        assert!(is_debian("PRETTY_NAME=\"Debian GNU/Linux 12\"\nID=debian\n"));
        assert!(!is_debian("ID=ubuntu\nID_LIKE=debian\n"));
        assert!(!is_debian(""));
    }
}
