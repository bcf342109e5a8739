//! The crates as they are packed, tested without the rest of the repository.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use tempfile::TempDir;

use measure::program::Program;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::toolchain::Toolchain;
use tools::{command, compilers, project};

use crate::{fresh, renderers};

/// The crates, each after its dependencies, with the files that each must contain beside its
/// source.
const CRATES: [(&str, &[&str]); 5] = [
    ("luminaire", &["README.md", "LICENSE-APACHE", "LICENSE-MIT"]),
    ("luminaire-native", &["README.md", "LICENSE-APACHE", "LICENSE-MIT"]),
    ("luminaire-render", &["README.md", "LICENSE-APACHE", "LICENSE-MIT", "examples/scenes.rs"]),
    ("luminaire-fixtures", &["README.md", "LICENSE-APACHE", "LICENSE-MIT", "data/README.md"]),
    ("luminaire-export", &["README.md", "LICENSE-APACHE", "LICENSE-MIT", "c/library.properties"]),
];

/// The warnings that are accepted: one until the project has an address to name, and one for each test
/// that needs the repository and is not packed.
const ACCEPTED: [&str; 2] =
    ["manifest has no documentation, homepage or repository", "is not included in the published package"];

/// The firmware to copy.
const TEMPLATE: &str = "examples/boards/template";

/// Changes the files of the template to the quick evaluation.
const QUICK: [(&str, &str, &str); 2] = [
    ("build.rs", "compile::<Fx16>()", "compile_quick::<Fx16>()"),
    ("src/lib.rs", "CompiledSpotLight", "QuickSpotLight"),
];

/// Where the manifests of folders have the crates.
const IN_FOLDERS: [(&str, &str); 3] = [
    ("path = \"../../core\"", "luminaire"),
    ("path = \"../../../core\"", "luminaire"),
    ("path = \"../../export\"", "luminaire-export"),
];

/// The targets of the template: the smallest supported processor of either kind.
const TARGETS: [&str; 2] = ["thumbv6m-none-eabi", "riscv32imc-unknown-none-elf"];

/// Adds the steps.
pub(crate) fn run(suite: &mut Suite) {
    const NAMES: [&str; 6] = [
        "package: the crates are complete",
        "package: the firmware to copy links without float or panic",
        "package: the crates' own tests pass",
        "package: renderers of other projects draw what the kernel computes",
        "package: a new project gets few packages and no procedural macro",
        "package: the kernel compiles with the oldest dependencies that it allows",
    ];
    if !NAMES.iter().any(|name| suite.wants(name)) {
        NAMES.iter().for_each(|name| suite.skip(name));
        return;
    }
    let unpacked = suite.require(NAMES[0], Unpacked::new);
    let unpacked = || unpacked.as_ref().context("the crates were not packed");
    suite.remarked(NAMES[1], |progress| {
        let [exact, quick, riscv] = unpacked()?.firmware(progress)?;
        let readme = fs::read_to_string(project::root().join("README.md"))?;
        for (bytes, before, after) in
            [(exact, "**", " kB of flash**"), (quick, " ", " kB by the quick evaluation")]
        {
            let words = format!("{before}{:.1}{after}", bytes as f64 / 1000.0);
            ensure!(readme.contains(&words), "README.md: expected `{}`", words.trim());
        }
        Ok(vec![format!("{exact} bytes of flash, by the quick evaluation {quick}; on a RISC-V {riscv}")])
    });
    suite.count(NAMES[2], |progress| unpacked()?.tests(progress));
    suite.remarked(NAMES[3], |progress| unpacked()?.renderers(progress));
    suite.remarked(NAMES[4], |progress| {
        let crates = unpacked()?;
        fresh::check(&crates.of("luminaire"), &crates.below("a new project"), progress)
    });
    // Last, because it writes into the lock file.
    suite.step(NAMES[5], |progress| unpacked()?.oldest_dependencies(progress));
}

/// Packs the crates of a checkout, and unpacks them into a folder. Fails if one lacks a file.
pub(crate) fn pack(root: &Path, target: &Path, progress: &Progress) -> Result<TempDir> {
    let mut package = command::cargo(["package", "--allow-dirty", "--no-verify"]);
    package.args(CRATES.iter().flat_map(|(name, _)| ["--package", name]));
    package.current_dir(root).env("CARGO_TARGET_DIR", target);
    let output = progress.output(package)?;
    let warnings = output.lines().filter(|line| line.starts_with("warning"));
    let others: Vec<_> =
        warnings.filter(|line| !ACCEPTED.iter().any(|accepted| line.contains(accepted))).collect();
    ensure!(others.is_empty(), "expected no warning but {ACCEPTED:?}, found {others:?}");
    let unpacked = tempfile::tempdir()?;
    for (name, files) in CRATES {
        let mut tar = Command::new("tar");
        // By its name alone: to some a colon, as in a path of Windows, is the end of a host's name.
        tar.arg("xzf").arg(format!("{name}-{VERSION}.crate")).current_dir(target.join("package"));
        tar.arg("-C").arg(unpacked.path());
        progress.run(tar)?;
        // A link that was not followed has only the path of its file.
        let is_whole = |file: &&&str| {
            let file = unpacked.path().join(format!("{name}-{VERSION}")).join(file);
            fs::metadata(file).is_ok_and(|file| file.is_file() && file.len() > 100)
        };
        let missing: Vec<_> = files.iter().filter(|file| !is_whole(file)).collect();
        ensure!(missing.is_empty(), "the crate {name} lacks {missing:?}");
    }
    Ok(unpacked)
}

/// The packed crates, unpacked in a folder outside every workspace.
struct Unpacked {
    folder: TempDir,
}

impl Unpacked {
    fn new(progress: &Progress) -> Result<Self> {
        let unpacked = Self { folder: pack(project::root(), &project::target(), progress)? };
        for (name, _) in CRATES {
            let settings = unpacked.of(name).join(".cargo");
            fs::create_dir(&settings)?;
            fs::write(settings.join("config.toml"), unpacked.below(name))?;
        }
        Ok(unpacked)
    }

    /// The folder of a crate.
    fn of(&self, name: &str) -> PathBuf {
        self.folder.path().join(format!("{name}-{VERSION}"))
    }

    /// The settings by which cargo takes what a crate or a program needs of the unpacked kernel, which is
    /// not yet on any registry.
    fn below(&self, name: &str) -> String {
        let needed = ["luminaire-native", "luminaire"].into_iter().take_while(|needed| *needed != name);
        let patches = needed.map(|needed| format!("{needed} = {{ path = {:?} }}\n", self.of(needed)));
        format!("[patch.crates-io]\n{}", patches.collect::<String>())
    }

    /// Runs the crates' own tests, doc tests and examples included.
    fn tests(&self, progress: &Progress) -> Result<Tally> {
        compilers::find(progress)?;
        let tallies = CRATES.map(|(name, _)| {
            let mut test = self.cargo(name, &["test", "--all-features"]);
            // Tests that compile C skip a compiler that is not installed, unless this variable is set.
            test.env("LUMINAIRE_TOOLS", "1");
            tally::cargo_test(test, progress)
        });
        for example in fs::read_dir(self.of("luminaire").join("examples"))? {
            let example = example?.path();
            let name = example.file_stem().and_then(OsStr::to_str).unwrap_or_default();
            let run = self.cargo("luminaire", &["run", "--all-features", "--example", name]);
            progress.run(run).with_context(|| format!("the example {name}"))?;
        }
        tallies.into_iter().sum()
    }

    /// Checks the kernel with the oldest version of each dependency that its manifest allows.
    fn oldest_dependencies(&self, progress: &Progress) -> Result<()> {
        let mut update = self.cargo("luminaire", &["update", "-Zdirect-minimal-versions"]);
        // Only nightly cargo has the option, or stable cargo with `RUSTC_BOOTSTRAP`.
        update.env("RUSTC_BOOTSTRAP", "1");
        progress.run(update)?;
        progress.run(self.cargo("luminaire", &["check", "--lib", "--all-features"]))
    }

    /// A call of cargo in the folder of a crate.
    fn cargo(&self, name: &str, words: &[&str]) -> Command {
        let mut cargo = command::cargo(words);
        cargo.current_dir(self.of(name)).env("CARGO_TARGET_DIR", project::target().join("unpacked"));
        // The workspace's profiles are not packed, and without optimisation the renderer's tests
        // take minutes.
        cargo.env("CARGO_PROFILE_DEV_OPT_LEVEL", "2").env("CARGO_PROFILE_TEST_OPT_LEVEL", "2");
        cargo
    }

    /// Draws the pictures of other renderers with the unpacked crates. Returns the rows of the table.
    fn renderers(&self, progress: &Progress) -> Result<Vec<String>> {
        let folder = self.copied(renderers::FOLDER, &["target"])?;
        let rows = renderers::pictures(&folder, progress)?;
        renderers::are_on_the_page(&rows).map(|()| rows)
    }

    /// Copies a folder of the repository, with the unpacked crates in its manifest.
    fn copied(&self, folder: &str, left_out: &[&str]) -> Result<PathBuf> {
        let copies = self.folder.path().join(folder);
        for (file, content) in project::files(&project::root().join(folder), left_out)? {
            let copy = copies.join(file);
            fs::create_dir_all(copy.parent().context("a file has a folder")?)?;
            fs::write(&copy, content).with_context(|| format!("cannot write {}", copy.display()))?;
        }
        let manifest = copies.join("Cargo.toml");
        let mut text = fs::read_to_string(&manifest)?;
        for (path, name) in IN_FOLDERS {
            text = text.replace(path, &format!("path = {:?}", self.of(name)));
        }
        fs::write(&manifest, text + "\n" + &self.below(folder))?;
        Ok(copies)
    }

    /// Builds a copy of the template with the unpacked kernel, with the quick evaluation, and for a RISC-V. Returns
    /// their bytes of flash.
    fn firmware(&self, progress: &Progress) -> Result<[u64; 3]> {
        // A copy takes the versions that are on record, so these must be for this manifest.
        let mut locked = command::cargo(["metadata", "--locked", "--format-version=1"]);
        command::answer(locked.current_dir(project::root().join(TEMPLATE)))?;
        let folder = self.copied(TEMPLATE, &["target"])?;
        let [exact, riscv] = TARGETS.map(|target| scanline(&folder, target, progress));
        let (exact, riscv) = (exact?, riscv?);
        for (file, exact, quick) in QUICK {
            let file = folder.join(file);
            fs::write(&file, fs::read_to_string(&file)?.replace(exact, quick))?;
        }
        let quick = scanline(&folder, TARGETS[0], progress)?;
        ensure!(quick < exact, "expected fewer than {exact} bytes by the quick evaluation, found {quick}");
        Ok([exact, quick, riscv])
    }
}

/// Builds the template in a folder for a target. Returns its bytes of flash.
fn scanline(folder: &Path, target: &'static str, progress: &Progress) -> Result<u64> {
    let toolchain = Toolchain::find(target, progress)?;
    toolchain.build(folder, &["--release"], progress)?;
    let program = Program::read(&toolchain.artifacts("release").join("scanline"))?;
    program.has_no_float()?;
    let panics = program.names_of(|name| name.starts_with("core::panicking"));
    ensure!(panics.is_empty(), "there are panics: {}", panics.join(", "));
    ensure!(program.bytes() > 500, "expected a scanline, found {} bytes", program.bytes());
    Ok(program.bytes())
}

const VERSION: &str = env!("CARGO_PKG_VERSION");
