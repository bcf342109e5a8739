//! The worked examples of `CONTRIBUTING.md`, applied to a copy of the tree.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use tools::command;
use tools::progress::Progress;
use tools::project;
use tools::suite::Suite;

/// Upper bound of the number of files that one edits by hand to add a model.
const MOST_FILES: usize = 3;

/// Files and folders that are not copied, by the end of their path.
const NOT_COPIED: [&str; 4] = [".git", "target", "node_modules", "benches/firmware/effects/src/bin"];

/// Adds the steps: all packages of the copy compile, and its host tests pass once its bounds are
/// recorded.
pub(crate) fn run(suite: &mut Suite) {
    suite.step("contributing: the worked examples compile for all packages", |progress| {
        let tree = Tree::with_the_examples()?;
        progress.run(tree.cargo("", &["check", "--workspace", "--all-targets"]))?;
        let check = ["check", "--workspace", "--all-targets", "--features", "effects"];
        progress.run(tree.cargo("benches/firmware", &check))
    });
    suite.step("contributing: the worked examples pass the host tests", passes);
}

fn passes(progress: &Progress) -> Result<()> {
    let tree = Tree::with_the_examples()?;
    let generate = ["run", "-p", "luminaire-conform", "--bin", "conform", "generate"];
    let vectors = tree.cargo("", &generate).output().context("cannot start cargo")?;
    ensure!(vectors.status.success(), "{}", String::from_utf8_lossy(&vectors.stderr));
    fs::write(tree.folder.join("tests/conform/vectors.txt"), vectors.stdout)?;
    let mut test = tree.cargo("", &["test", "--no-fail-fast"]);
    test.env("LUMINAIRE_BLESS", "1");
    progress.run(test)
}

/// A copy of the tree, below the folder of everything that is built.
struct Tree {
    folder: PathBuf,
}

impl Tree {
    /// The tree as the examples leave it.
    fn with_the_examples() -> Result<Self> {
        let tree = Self { folder: project::target().join("contributing") };
        project::mirror(&project::files(project::root(), &NOT_COPIED)?, &tree.folder, &NOT_COPIED)?;
        examples()?.iter().try_for_each(|example| apply(example, &tree.folder))?;
        Ok(tree)
    }

    /// A call of cargo in a folder of the tree. It has a target folder of its own: cargo tells packages
    /// of two copies of a workspace apart by the times of their files alone, and would take what it has
    /// compiled for the example as the project's.
    fn cargo(&self, folder: &str, arguments: &[&str]) -> Command {
        let mut cargo = command::cargo(arguments);
        cargo.current_dir(self.folder.join(folder)).env("CARGO_TARGET_DIR", self.folder.join("target"));
        cargo
    }
}

/// The diffs of the worked examples on the page.
fn examples() -> Result<Vec<String>> {
    let page = fs::read_to_string(project::root().join("CONTRIBUTING.md"))?;
    let examples = page.split("```diff\n").skip(1).map(|rest| {
        let (example, _) = rest.split_once("```").context("an example of CONTRIBUTING.md does not end")?;
        let touched = example.lines().filter(|line| line.starts_with("+++ b/")).count();
        ensure!((1..=MOST_FILES).contains(&touched), "an example touches {touched} files");
        Ok(example.to_owned())
    });
    let examples: Vec<_> = examples.collect::<Result<_>>()?;
    ensure!(!examples.is_empty(), "CONTRIBUTING.md has no example");
    Ok(examples)
}

/// Applies a diff to a folder.
fn apply(difference: &str, folder: &Path) -> Result<()> {
    let file = project::target().join("contributing.diff");
    fs::write(&file, difference)?;
    let mut git = Command::new("git");
    // The copy is no part of the repository that it is in.
    git.arg("apply").arg(&file).current_dir(folder);
    git.env("GIT_CEILING_DIRECTORIES", project::target());
    let ended = command::capture(git, |_| {})?;
    ensure!(ended.success, "an example of CONTRIBUTING.md does not apply:\n{}", ended.output);
    Ok(())
}
