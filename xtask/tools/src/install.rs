//! Installing missing tools: Debian packages if the program runs as root, npm packages into the
//! project's target folder.

use std::env::consts::EXE_SUFFIX;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use std::{fs, io, thread};

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::progress::Progress;
use crate::system::System;
use crate::tool::{self, Tool};
use crate::{command, project};

/// How long to wait for another apt, such as the one that updates a fresh Debian.
const PATIENCE: Duration = Duration::from_secs(600);

/// Time between two attempts.
const PAUSE: Duration = Duration::from_secs(5);

/// Whether Debian packages can be installed without a password: the system is Debian, and the user
/// is root.
pub fn debian_root() -> bool {
    let release = fs::read_to_string("/etc/os-release").unwrap_or_default();
    let is_debian = release.lines().any(|line| line == "ID=debian" || line == "ID=\"debian\"");
    is_debian && command::answer(Command::new("id").arg("-u")).is_ok_and(|user| user == "0")
}

/// The program of a tool. As root on Debian, installs its packages if it is missing.
pub fn program(tool: &Tool, progress: &Progress) -> Result<PathBuf> {
    if let Some(program) = tool.find() {
        return Ok(program);
    }
    if debian_root() {
        apt(tool.debian, progress)?;
    }
    tool.find().with_context(|| tool.missing(System::HERE))
}

/// Installs Debian packages. Call it only if [`debian_root`] returns true.
pub fn apt(packages: &[&str], progress: &Progress) -> Result<()> {
    let remedy = || {
        format!("cannot install them: try `apt-get update && apt-get install {}` by hand", packages.join(" "))
    };
    let install = [&["install", "-y", "--no-install-recommends"], packages].concat();
    let mut calls = [&["update"][..], &install].into_iter();
    progress.timed("Installing", format_args!("Debian packages: {}", packages.join(" ")), || {
        calls.try_for_each(|words| apt_get(words, project::root(), progress)).with_context(remedy)
    })
}

/// Runs `apt-get` in a folder, when no other apt is running.
fn apt_get(words: &[&str], folder: &Path, progress: &Progress) -> Result<()> {
    let end = Instant::now() + PATIENCE;
    loop {
        let mut apt = Command::new("apt-get");
        // This option makes apt wait for one of its locks: the one that is held while packages are
        // unpacked.
        apt.arg("-o").arg(format!("DPkg::Lock::Timeout={}", PATIENCE.as_secs())).args(words);
        // apt's messages are parsed, so they must be English.
        apt.env("DEBIAN_FRONTEND", "noninteractive").env("LC_ALL", "C").current_dir(folder);
        let name = command::describe(&apt);
        let ended = progress.capture(apt)?;
        if ended.success {
            return Ok(());
        }
        ensure!(is_locked(&ended.output) && Instant::now() < end, "{name} failed");
        progress.say("Waiting", "for another program that installs packages");
        thread::sleep(PAUSE);
    }
}

/// Downloads Debian packages with apt, and unpacks them into a folder without installing them. `finish`
/// gets their files. The folder is there when all that has succeeded.
pub fn unpack(
    packages: &[&str],
    folder: &Path,
    progress: &Progress,
    finish: impl FnOnce(&[PathBuf]) -> Result<()>,
) -> Result<()> {
    let new = folder.with_extension("new");
    project::remove(&new)?;
    fs::create_dir_all(&new).with_context(|| format!("cannot create {}", new.display()))?;
    for words in [&["update"][..], &[&["download"], packages].concat()] {
        apt_get(words, &new, progress)?;
    }
    let files = fs::read_dir(&new)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    for file in &files {
        let mut extract = Command::new("dpkg-deb");
        extract.arg("-x").arg(file).arg(&new);
        progress.run(extract)?;
    }
    finish(&files)?;
    files.iter().try_for_each(fs::remove_file)?;
    project::remove(folder)?;
    fs::rename(&new, folder).with_context(|| format!("cannot replace {}", folder.display()))
}

/// Whether apt has ended because another holds its lock on the package lists or on the archive, for
/// which it has no option to wait.
fn is_locked(output: &str) -> bool {
    output.lines().any(|line| line.starts_with("E: Could not get lock"))
}

/// The npm packages and their versions. `devDependencies` are those that only tests run.
const NPM_PACKAGES: &str = include_str!("../npm/package.json");

/// The versions of all packages that those need.
const NPM_LOCK: &str = include_str!("../npm/package-lock.json");

/// A call of a program of an npm package, which is installed if need be: its script, run by Node.js. What
/// npm puts into `.bin` is a script for the shell of each system.
pub fn npm_program(package: &str, program: &str, progress: &Progress) -> Result<Command> {
    let script = script(&npm(package, progress)?, program)?;
    let mut node = Command::new(self::program(&tool::NODE, progress)?);
    node.arg(script);
    Ok(node)
}

/// The script of a program in the folder of an npm package, as its manifest names it: `bin` is a file, or
/// has files by the names of programs.
fn script(folder: &Path, program: &str) -> Result<PathBuf> {
    let manifest = folder.join("package.json");
    let text =
        fs::read_to_string(&manifest).with_context(|| format!("cannot read {}", manifest.display()))?;
    let bin = &serde_json::from_str::<Value>(&text)?["bin"];
    let file = bin.as_str().or_else(|| bin[program].as_str());
    Ok(folder.join(file.with_context(|| format!("{}: expected a program {program}", manifest.display()))?))
}

/// The folder of the npm packages in `target/tools`.
pub fn npm_modules() -> PathBuf {
    tools().join(MODULES)
}

const MODULES: &str = "node_modules";

/// The file there with the versions of the packages.
const INSTALLED: &str = "installed.json";

/// The recorded version of an npm package, as in `rp2040js 1.4.1`.
pub fn npm_version(name: &str) -> Result<String> {
    let packages: Value =
        serde_json::from_str(NPM_PACKAGES).context("the list of npm packages is no JSON")?;
    let version = ["dependencies", "devDependencies"].iter().find_map(|kind| packages[kind][name].as_str());
    let version = version.with_context(|| format!("package = {name:?}: expected one of xtask/tools/npm"))?;
    Ok(format!("{name} {version}"))
}

/// The folder of an npm package in `target/tools`. If it is not installed there with the recorded
/// version, all packages are, never globally; those that only tests run are left out until a test
/// needs one.
pub fn npm(name: &str, progress: &Progress) -> Result<PathBuf> {
    npm_version(name)?;
    let (modules, folder) = (npm_modules(), npm_modules().join(name));
    fs::create_dir_all(tools()).with_context(|| format!("cannot create {}", tools().display()))?;
    // Steps that run side by side wait for each other.
    let one_at_a_time = fs::File::create(tools().join("npm.lock")).context("cannot write npm.lock")?;
    one_at_a_time.lock().context("cannot wait for another npm")?;
    let is_recorded = fs::read_to_string(modules.join(INSTALLED)).is_ok_and(|lock| lock == NPM_LOCK);
    if is_recorded && folder.is_dir() {
        return Ok(folder);
    }
    let npm = program(&tool::NPM, progress)?;
    // npm begins with an empty folder. Another step may use the packages that are there, and npm may be
    // interrupted: the new ones take their place when they are complete.
    let new = tools().join("npm");
    project::remove(&new)?;
    fs::create_dir(&new).with_context(|| format!("cannot create {}", new.display()))?;
    fs::write(new.join("package.json"), NPM_PACKAGES)?;
    fs::write(new.join("package-lock.json"), NPM_LOCK)?;
    let mut install = Command::new(npm);
    // What the lock file has, or nothing; and no script of a package is run. Without a network the default
    // retries would hold up the build for minutes.
    install.args(["ci", "--ignore-scripts", "--prefer-offline", "--no-audit", "--no-fund"]);
    install.args(["--fetch-retries=1", "--fetch-timeout=60000"]);
    let is_for_tests = serde_json::from_str::<Value>(NPM_PACKAGES)?["devDependencies"][name].is_string();
    let has_tests = modules.join("typescript").is_dir();
    if !is_for_tests && !has_tests {
        install.arg("--omit=dev");
    }
    install.current_dir(&new);
    let what = "the npm packages of xtask/tools/npm into target/tools";
    progress.timed("Installing", what, || progress.run(install))?;
    let fresh = new.join(MODULES);
    ensure!(fresh.join(name).is_dir(), "npm has not installed {name} into {}", fresh.display());
    fs::write(fresh.join(INSTALLED), NPM_LOCK)?;
    let put = || {
        if modules.exists() {
            fs::rename(&modules, new.join("old"))?;
        }
        fs::rename(&fresh, &modules)
    };
    put().with_context(|| format!("cannot replace {}", modules.display()))?;
    project::remove(&new)?;
    Ok(folder)
}

/// The program of a crate, found on PATH or else built into `target/tools`, never into the user's
/// own folder.
pub fn cargo_program(name: &str, progress: &Progress) -> Result<PathBuf> {
    let built = tools().join("bin").join(format!("{name}{EXE_SUFFIX}"));
    if let Some(program) = command::on_path(&[name]).or_else(|| built.is_file().then(|| built.clone())) {
        return Ok(program);
    }
    let mut install = command::cargo(["install", "--locked", name, "--root"]);
    install.arg(tools());
    progress.timed("Building", format_args!("{name} into target/tools"), || progress.run(install))?;
    Ok(built)
}

fn tools() -> PathBuf {
    project::target().join("tools")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_busy_apt_is_waited_for_and_a_failure_is_not() {
        let lists = "Reading package lists...\nE: Could not get lock /var/lib/apt/lists/lock. It is held";
        assert!(is_locked(lists));
        // A message about waiting for a lock does not count: apt may have waited, and then found no
        // network.
        let waited = "Waiting for cache lock: Could not get lock /var/lib/dpkg/lock\nE: Failed to fetch";
        assert!(!is_locked(waited) && !is_locked("E: Unable to locate package"));
    }

    #[test]
    fn npm_packages_have_the_locked_versions() {
        let lock: Value = serde_json::from_str(NPM_LOCK).unwrap();
        for name in ["binaryen", "esbuild", "rp2040js", "typescript"] {
            let locked = &lock["packages"][format!("node_modules/{name}")]["version"];
            assert_eq!(npm_version(name).unwrap(), format!("{name} {}", locked.as_str().unwrap()));
        }
        assert!(npm_version("left-pad").unwrap_err().to_string().contains("left-pad"));
    }

    #[test]
    fn a_program_of_npm_is_the_script_that_its_package_names() {
        let folder = tempfile::tempdir().unwrap();
        let found = |bin: &str| {
            fs::write(folder.path().join("package.json"), format!("{{\"bin\": {bin}}}")).unwrap();
            script(folder.path(), "tsc")
        };
        assert_eq!(found(r#"{"tsc": "./bin/tsc.js"}"#).unwrap(), folder.path().join("./bin/tsc.js"));
        assert_eq!(found(r#""tsc.js""#).unwrap(), folder.path().join("tsc.js"));
        assert!(found(r#"{"other": "a.js"}"#).unwrap_err().to_string().contains("expected a program tsc"));
    }
}
