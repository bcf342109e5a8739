//! The licences of what the demo distributes of others.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::{board, command, install, project};

/// The start of the names of files with licences.
const NAMES: [&str; 4] = ["LICEN", "COPYING", "UNLICENSE", "NOTICE"];

/// Writes the licences of the packages that are linked into the firmware of the board, and of the
/// emulator. Each text is there once, after the names of what it applies to.
pub(super) fn write(file: &Path, emulator: &Path) -> Result<()> {
    // Without the dependencies of build scripts, and without macros.
    let tree =
        ["tree", "--locked", "--edges=normal,no-proc-macro", "--prefix=none", "--target", board::TARGET];
    let tree = command::answer(&mut board::cargo(board::RP2040, tree))?;
    let metadata = ["metadata", "--format-version=1", "--locked", "--filter-platform", board::TARGET];
    let metadata = command::answer(&mut board::cargo(board::RP2040, metadata))?;
    let metadata: Value = serde_json::from_str(&metadata)?;
    let mut names: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for package in metadata["packages"].as_array().context("the metadata have no packages")? {
        let [name, version] = ["name", "version"].map(|field| package[field].as_str().unwrap_or_default());
        let line = format!("{name} v{version}");
        // The project's own packages have no source.
        if package["source"].is_null() || !tree.lines().any(|linked| linked.trim_end_matches(" (*)") == line)
        {
            continue;
        }
        let (name, texts) = texts(package)?;
        for text in texts {
            names.entry(text).or_default().insert(name.clone());
        }
    }
    let texts = licenses(emulator)?;
    ensure!(!texts.is_empty(), "{} has no licence", emulator.display());
    for text in texts {
        names.entry(text).or_default().insert(install::npm_version(board::RP2040JS)?);
    }
    let line = "-".repeat(80);
    let all = names.into_iter().map(|(text, names)| {
        let names: Vec<_> = names.into_iter().collect();
        format!("{}\n\n{}\n\n{line}\n\n", names.join(", "), text.trim_end())
    });
    fs::write(file, all.collect::<String>()).with_context(|| format!("cannot write {}", file.display()))
}

/// The name of a package, and the texts of its licences. A package without any gets the text of a
/// licence that it names, and its authors after its name.
fn texts(package: &Value) -> Result<(String, Vec<String>)> {
    let word = |field: &str| package[field].as_str().unwrap_or_default();
    let name = format!("{} {} ({})", word("name"), word("version"), word("license"));
    let folder = Path::new(word("manifest_path")).parent().context("a manifest without a folder")?;
    let texts = licenses(folder)?;
    if !texts.is_empty() {
        return Ok((name, texts));
    }
    let file = match word("license") {
        choice if choice.contains("Apache-2.0") => "LICENSE-APACHE".to_owned(),
        only => format!("examples/boards/licenses/{only}.txt"),
    };
    let text =
        fs::read_to_string(project::root().join(&file)).with_context(|| format!("{name}: no {file}"))?;
    let authors: Vec<_> =
        package["authors"].as_array().into_iter().flatten().flat_map(Value::as_str).collect();
    Ok((format!("{name} by {}", authors.join(", ")), vec![text]))
}

/// The texts of the licences in a package's folder.
fn licenses(folder: &Path) -> Result<Vec<String>> {
    let mut texts = Vec::new();
    for entry in folder.read_dir().with_context(|| format!("cannot read {}", folder.display()))? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        if path.is_file() && NAMES.iter().any(|start| name.starts_with(start)) {
            texts.push(fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?);
        }
    }
    Ok(texts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_package_without_a_text_gets_that_of_its_licence() {
        let folder = tempfile::tempdir().unwrap();
        let package = |license: &str| {
            serde_json::json!({
                "name": "void", "version": "1.0.2", "license": license, "authors": ["A. Author"],
                "manifest_path": folder.path().join("Cargo.toml"),
            })
        };
        let (name, found) = texts(&package("MIT")).unwrap();
        assert_eq!(name, "void 1.0.2 (MIT) by A. Author");
        assert!(found[0].starts_with("Permission is hereby granted"));
        assert!(
            texts(&package("GPL-3.0"))
                .unwrap_err()
                .to_string()
                .contains("examples/boards/licenses/GPL-3.0.txt")
        );
        fs::write(folder.path().join("LICENSE-MIT"), "its own").unwrap();
        assert_eq!(texts(&package("MIT")).unwrap().1, ["its own"]);
    }
}
