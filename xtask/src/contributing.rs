//! The worked example of `CONTRIBUTING.md`, applied to a copy of the tree.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use tools::command;
use tools::progress::Progress;
use tools::project;
use tools::suite::Suite;

/// Upper bound of the number of files that one edits by hand to add a falloff.
const MOST_FILES: usize = 3;

/// Files and folders that are not copied, by the end of their path.
const NOT_COPIED: [&str; 4] = [".git", "target", "node_modules", "benches/firmware/effects/src/bin"];

/// Adds the steps: all packages of the copy compile, and its host tests pass, once its bounds are
/// recorded.
pub(crate) fn run(suite: &mut Suite) {
    suite.step("contributing: the worked example compiles for all packages", |progress| {
        let tree = Tree::with_the_example()?;
        progress.run(tree.cargo("", &["check", "--workspace", "--all-targets"]))?;
        progress.run(
            tree.cargo(
                "benches/firmware",
                &["check", "--workspace", "--all-targets", "--features", "effects"],
            ),
        )
    });
    suite.step("contributing: the worked example passes the host tests", passes);
}

fn passes(progress: &Progress) -> Result<()> {
    let tree = Tree::with_the_example()?;
    let written: [(&[&str], &str); 2] = [
        (&["run", "-p", "luminaire-conform", "--bin", "conform", "generate"], "tests/conform/vectors.txt"),
        (&["run", "-p", "suite", "--example", "worst-places"], "tests/slow/worst/places.txt"),
    ];
    for (arguments, file) in written {
        let written = tree.cargo("", arguments).output().context("cannot start cargo")?;
        ensure!(written.status.success(), "{}", String::from_utf8_lossy(&written.stderr));
        fs::write(tree.folder.join(file), written.stdout)?;
    }
    let mut test = tree.cargo("", &["test", "--no-fail-fast"]);
    test.env("LUMINAIRE_BLESS", "1");
    progress.run(test)
}

/// A copy of the tree, below the folder of everything that is built.
struct Tree {
    folder: PathBuf,
}

impl Tree {
    /// The tree as the example leaves it.
    fn with_the_example() -> Result<Self> {
        let page = fs::read_to_string(project::root().join("CONTRIBUTING.md"))?;
        let example = patched(difference(&page)?)?;
        ensure!(example.len() <= MOST_FILES, "the example touches {} files", example.len());
        let tree = Self { folder: project::target().join("contributing") };
        let mut files = project::files(project::root(), &NOT_COPIED)?;
        files.extend(example);
        project::mirror(&files, &tree.folder, &NOT_COPIED)?;
        Ok(tree)
    }

    /// A call of cargo in a folder of the tree. It has a target folder of its own: cargo tells packages
    /// of two copies of a workspace apart by the times of their files alone, and would take what it has
    /// compiled for the example as the project's.
    fn cargo(&self, folder: &str, arguments: &[&str]) -> Command {
        let mut cargo = command::cargo(arguments[0]);
        cargo.args(&arguments[1..]).current_dir(self.folder.join(folder));
        cargo.env("CARGO_TARGET_DIR", self.folder.join("target"));
        cargo
    }
}

/// The diff of the worked example on the page.
fn difference(page: &str) -> Result<&str> {
    let (_, rest) = page.split_once("```diff\n").context("CONTRIBUTING.md has no example")?;
    let (difference, _) = rest.split_once("```").context("the example of CONTRIBUTING.md does not end")?;
    Ok(difference)
}

/// The files that a diff touches, with their content after it is applied.
fn patched(difference: &str) -> Result<BTreeMap<PathBuf, Vec<u8>>> {
    let touched: Vec<_> = difference.lines().filter_map(|line| line.strip_prefix("+++ b/")).collect();
    let folder = project::target().join("contributing.example");
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    for path in &touched {
        let (from, to) = (project::root().join(path), folder.join(path));
        fs::create_dir_all(to.parent().unwrap_or(&to))?;
        if from.exists() {
            fs::copy(from, to)?;
        }
    }
    let patch = folder.join("example.diff");
    fs::write(&patch, difference)?;
    let mut git = Command::new("git");
    git.arg("apply").arg(&patch).current_dir(&folder).env("GIT_CEILING_DIRECTORIES", project::target());
    let ended = command::capture(git, |_| {})?;
    ensure!(ended.success, "the example of CONTRIBUTING.md does not apply:\n{}", ended.output);
    let read = |path: &&str| Ok((PathBuf::from(path), fs::read(folder.join(path))?));
    touched.iter().map(read).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn an_example_ends_where_its_block_does() {
        assert_eq!(difference("a\n```diff\n+b\n```\nc\n").unwrap(), "+b\n");
        assert!(difference("none").is_err());
    }

    #[test]
    fn the_example_applies_to_at_most_three_files() {
        let page = fs::read_to_string(project::root().join("CONTRIBUTING.md")).unwrap();
        let files = patched(difference(&page).unwrap()).unwrap();
        assert!(
            files.len() <= MOST_FILES && files.contains_key(Path::new("core/src/models.rs")),
            "{files:?}"
        );
    }
}
