//! The repository's files, and what its tools print of it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// The folder of the repository.
pub(crate) const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// What a program that must succeed prints, line by line, when it runs in the folder of the repository.
pub(crate) fn lines_of(program: &str, words: &[&str]) -> Vec<String> {
    // A copy of the files is no part of a repository that it may lie in.
    let outside = Path::new(ROOT).parent().unwrap_or(Path::new(ROOT));
    let ended =
        Command::new(program).args(words).current_dir(ROOT).env("GIT_CEILING_DIRECTORIES", outside).output();
    let ended = ended.unwrap_or_else(|error| panic!("cannot start {program}: {error}"));
    assert!(ended.status.success(), "{program} {words:?}: {}", String::from_utf8_lossy(&ended.stderr));
    String::from_utf8(ended.stdout).expect("text in UTF-8").lines().map(str::to_owned).collect()
}

/// The files of the repository, or of a copy of its files, that match one of git's patterns, committed or not.
pub(crate) fn files(patterns: &[&str]) -> Vec<PathBuf> {
    let is_repository = Path::new(ROOT).join(".git").exists();
    let words: &[&str] = match is_repository {
        true => &["ls-files", "--cached", "--others", "--exclude-standard", "--"],
        // Every file has the empty text.
        false => &["grep", "--no-index", "--exclude-standard", "--files-with-matches", "", "--"],
    };
    let words = [words, patterns].concat();
    let files = lines_of("git", &words).into_iter().map(|line| Path::new(ROOT).join(line));
    files.filter(|file| file.is_file()).collect()
}

/// The packages of the workspace of a manifest, as cargo states them.
fn packages(manifest: &Path) -> Vec<Value> {
    let manifest = manifest.display().to_string();
    let words = ["metadata", "--no-deps", "--offline", "--format-version=1", "--manifest-path", &manifest];
    let metadata: Value = serde_json::from_str(&lines_of("cargo", &words).concat()).expect("JSON");
    metadata["packages"].as_array().expect("packages").clone()
}

fn text(value: &Value) -> String {
    value.as_str().expect("text").to_owned()
}

/// The folder of a package.
fn folder(package: &Value) -> PathBuf {
    Path::new(&text(&package["manifest_path"])).with_file_name("")
}

/// The published crates: their names and folders.
pub(crate) fn crates() -> Vec<(String, PathBuf)> {
    let packages = packages(&Path::new(ROOT).join("Cargo.toml")).into_iter();
    let published = packages.filter(|package| package["publish"].is_null());
    published.map(|package| (text(&package["name"]), folder(&package))).collect()
}

/// The folder of every package of every workspace, with the folders of the packages that it depends on.
pub(crate) fn dependencies() -> BTreeMap<PathBuf, Vec<PathBuf>> {
    let mut found = BTreeMap::new();
    for manifest in files(&["Cargo.toml", "*/Cargo.toml"]) {
        if found.contains_key(&manifest.with_file_name("")) {
            continue;
        }
        for package in packages(&manifest) {
            let needed = package["dependencies"].as_array().expect("dependencies").iter();
            let needed = needed.filter_map(|needed| needed["path"].as_str().map(PathBuf::from)).collect();
            found.insert(folder(&package), needed);
        }
    }
    found
}
