//! Which steps have passed on this very tree, so that a long run can be interrupted and continued.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicU32, Ordering};
use std::{env, fs};

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};

use crate::tally::Tally;
use crate::{command, project, toolchain};

/// The steps that have passed, in a file below `target`.
#[derive(Debug)]
pub struct Record {
    file: PathBuf,
    /// What they have passed on: git's name of the tree, and the compiler.
    on: [String; 2],
    passed: BTreeMap<String, Tally>,
}

impl Record {
    /// Reads what has passed on the tree as it is now, with changes that are not committed.
    pub fn read(file: PathBuf) -> Result<Self> {
        let on = [tree(project::root())?, toolchain::active_compiler()?];
        let found = fs::read_to_string(&file).ok().and_then(|text| serde_json::from_str::<Value>(&text).ok());
        let found = found.filter(|found| found["on"] == json!(on)).unwrap_or_default();
        let steps = found["passed"].as_object().into_iter().flatten();
        let passed = steps
            .filter_map(|(name, tests)| Some((name.clone(), Tally { passed: tests.as_u64()?, failed: 0 })));
        Ok(Self { file, on, passed: passed.collect() })
    }

    /// Whether no step has passed.
    pub fn is_empty(&self) -> bool {
        self.passed.is_empty()
    }

    /// The tests of a step that has passed.
    pub fn of(&self, name: &str) -> Option<Tally> {
        self.passed.get(name).copied()
    }

    /// Notes that a step has passed, unless the tree has changed since this was read.
    pub fn note(&mut self, name: &str, tally: Tally) -> Result<()> {
        ensure!(
            tree(project::root())? == self.on[0],
            "the files have changed since the start, so that what passes is not kept"
        );
        self.passed.insert(name.to_owned(), tally);
        let passed: BTreeMap<_, _> = self.passed.iter().map(|(name, tally)| (name, tally.passed)).collect();
        let text = json!({ "on": self.on, "passed": passed }).to_string();
        project::replace(&self.file, text.as_bytes())
    }
}

/// Git's name of the tree of a checkout as it is now: its files, committed or not, but for what
/// `.gitignore` names. The checkout's own index and objects stay as they are.
fn tree(root: &Path) -> Result<String> {
    // Steps end side by side, and each of them takes the name of the tree.
    static COUNT: AtomicU32 = AtomicU32::new(0);
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    let kept = env::temp_dir().join(format!("luminaire-tree-{}-{count}", std::process::id()));
    let _removed = Removed(&kept);
    fs::create_dir_all(kept.join("objects")).with_context(|| format!("cannot write {}", kept.display()))?;
    let git = |words: &[&str]| {
        let mut git = Command::new("git");
        git.args(words).current_dir(root).env("GIT_INDEX_FILE", kept.join("index"));
        git
    };
    let objects =
        command::answer(&mut git(&["rev-parse", "--path-format=absolute", "--git-path", "objects"]))
            .context("only a checkout of git tells which tree it is")?;
    let answer = |words: &[&str]| {
        let git = &mut git(words);
        git.env("GIT_OBJECT_DIRECTORY", kept.join("objects"))
            .env("GIT_ALTERNATE_OBJECT_DIRECTORIES", &objects);
        command::answer(git)
    };
    answer(&["read-tree", "HEAD"])?;
    answer(&["add", "--all"])?;
    answer(&["write-tree"])
}

/// A folder that is removed in the end.
struct Removed<'a>(&'a Path);

impl Drop for Removed<'_> {
    fn drop(&mut self) {
        // An error does not matter: the system removes what is temporary.
        let _ = fs::remove_dir_all(self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tree_has_another_name_after_each_change_and_its_own_again_without() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        let git =
            |words: &[&str]| command::answer(Command::new("git").args(words).current_dir(root)).unwrap();
        git(&["init", "--quiet"]);
        fs::write(root.join(".gitignore"), "/built\n").unwrap();
        fs::write(root.join("one"), "1").unwrap();
        git(&["add", "--all"]);
        git(&["-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "--quiet", "--message=one"]);
        let first = tree(root).unwrap();
        fs::write(root.join("built"), "ignored").unwrap();
        assert_eq!(tree(root).unwrap(), first);
        fs::write(root.join("two"), "2").unwrap();
        let second = tree(root).unwrap();
        fs::write(root.join("one"), "other").unwrap();
        assert!(second != first && ![first.clone(), second].contains(&tree(root).unwrap()));
        fs::write(root.join("one"), "1").unwrap();
        fs::remove_file(root.join("two")).unwrap();
        assert_eq!(tree(root).unwrap(), first);
        assert_eq!(git(&["status", "--porcelain"]), "");
        std::thread::scope(|scope| {
            let trees: Vec<_> = (0..8).map(|_| scope.spawn(|| tree(root).unwrap())).collect();
            assert!(trees.into_iter().all(|tree| tree.join().unwrap() == first));
        });
    }
}
