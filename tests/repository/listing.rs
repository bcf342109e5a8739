//! The repository's files, and what its tools print of it.

use std::path::{Path, PathBuf};
use std::process::Command;

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

/// The published crates: their names and folders.
pub(crate) fn crates() -> Vec<(String, PathBuf)> {
    let metadata = lines_of("cargo", &["metadata", "--no-deps", "--offline", "--format-version=1"]).concat();
    let metadata: serde_json::Value = serde_json::from_str(&metadata).expect("JSON");
    let packages = metadata["packages"].as_array().expect("packages").iter();
    let text = |value: &serde_json::Value| value.as_str().expect("text").to_owned();
    packages
        .filter(|package| package["publish"].is_null())
        .map(|package| {
            (text(&package["name"]), Path::new(&text(&package["manifest_path"])).with_file_name(""))
        })
        .collect()
}
