//! A crate that is published packs every file that its packed files name.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::listing::{crates, lines_of};

/// What stands before a file that is named relative to the folder of the file that names it.
const NAMING: [&str; 4] = ["include_str!(\"", "include_bytes!(\"", "include!(\"", "#[path = \""];

/// The files that a file names.
fn named(file: &Path, text: &str) -> Vec<PathBuf> {
    let folder = file.parent().expect("a file is in a folder");
    let after = |start: &'static str| {
        let places = text.match_indices(start).map(move |(at, _)| &text[at + start.len()..]);
        places.filter_map(|rest| rest.split_once('"')).map(|(name, _)| folder.join(name))
    };
    let mut named: Vec<_> = NAMING.iter().flat_map(|start| after(start)).collect();
    // A module of a test program, which is beside it.
    if folder.ends_with("tests") {
        let modules = text.lines().filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(';'));
        let lines: Vec<_> = text.lines().collect();
        let is_plain = |name: &&str| {
            let at = lines.iter().position(|line| *line == format!("mod {name};"));
            !at.is_some_and(|at| at > 0 && lines[at - 1].starts_with("#[path"))
        };
        named.extend(modules.filter(is_plain).map(|name| {
            let alone = folder.join(format!("{name}.rs"));
            if alone.is_file() { alone } else { folder.join(name).join("mod.rs") }
        }));
    }
    named.into_iter().map(|path| plain(&path)).collect()
}

/// A path without `..`.
fn plain(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut path, part| {
        match part {
            Component::ParentDir => drop(path.pop()),
            part => path.push(part),
        }
        path
    })
}

#[test]
fn packed_file_names_only_packed_files() {
    let crates = crates();
    assert!(crates.len() >= 5, "expected the published crates, found {crates:?}");
    let mut checked = 0;
    for (name, folder) in crates {
        let list =
            lines_of("cargo", &["package", "--list", "--allow-dirty", "--offline", "--package", &name]);
        let packed: BTreeSet<_> = list.iter().map(|file| folder.join(file)).collect();
        for file in packed.iter().filter(|file| file.extension().is_some_and(|end| end == "rs")) {
            let text = fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            for other in named(file, &text) {
                checked += 1;
                assert!(
                    packed.contains(&other),
                    "{name} packs {}, which names {}: expected both or none in `exclude` of its manifest",
                    file.display(),
                    other.display()
                );
            }
        }
    }
    assert!(checked > 20, "expected files that name others, found {checked}");
}
