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
    let mut metadata = board::in_folder(board::RP2040, command::cargo("metadata"));
    metadata.args(["--format-version=1", "--locked", "--filter-platform", board::TARGET]);
    let metadata: Value = serde_json::from_str(&command::answer(&mut metadata)?)?;
    let mut names: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    // The project's own packages have no source.
    for package in linked(&metadata)?.into_iter().filter(|package| !package["source"].is_null()) {
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

/// The packages that are linked into the program: its dependencies, but for those of build scripts
/// and of macros.
fn linked(metadata: &Value) -> Result<Vec<&Value>> {
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let packages = metadata["packages"].as_array().context("the metadata have no packages")?;
    let by_id: BTreeMap<_, _> = packages.iter().map(|package| (package["id"].as_str(), package)).collect();
    let nodes = list(&metadata["resolve"]["nodes"]);
    let nodes: BTreeMap<_, _> = nodes.iter().map(|node| (node["id"].as_str(), &node["deps"])).collect();
    let mut waiting = vec![metadata["resolve"]["root"].clone()];
    let (mut known, mut found) = (BTreeSet::new(), Vec::new());
    while let Some(id) = waiting.pop() {
        let id = id.as_str();
        let package = by_id.get(&id).context("a package is missing")?;
        let is_macro = list(&package["targets"]).iter().any(|target| target["kind"][0] == "proc-macro");
        if is_macro || !known.insert(id.map(str::to_owned)) {
            continue;
        }
        found.push(*package);
        let is_linked = |deps: &&Value| list(&deps["dep_kinds"]).iter().any(|kind| kind["kind"].is_null());
        let deps = list(nodes.get(&id).context("a package is not resolved")?);
        waiting.extend(deps.iter().filter(is_linked).map(|dependency| dependency["pkg"].clone()));
    }
    Ok(found)
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
    fn only_what_is_linked_is_listed() {
        let package = |id: &str, kind: &str| format!(r#"{{"id":"{id}","targets":[{{"kind":["{kind}"]}}]}}"#);
        let packages = [("a", "bin"), ("b", "lib"), ("macro", "proc-macro"), ("c", "lib"), ("build", "lib")]
            .map(|(id, kind)| package(id, kind));
        let metadata = format!(
            r#"{{"packages":[{}],"resolve":{{"root":"a","nodes":[
                {{"id":"a","deps":[{{"pkg":"b","dep_kinds":[{{"kind":null}}]}},
                    {{"pkg":"macro","dep_kinds":[{{"kind":null}}]}},
                    {{"pkg":"build","dep_kinds":[{{"kind":"build"}}]}}]}},
                {{"id":"b","deps":[]}},
                {{"id":"macro","deps":[{{"pkg":"c","dep_kinds":[{{"kind":null}}]}}]}}]}}}}"#,
            packages.join(",")
        );
        let metadata: Value = serde_json::from_str(&metadata).unwrap();
        let mut found: Vec<_> =
            linked(&metadata).unwrap().iter().map(|package| package["id"].clone()).collect();
        found.sort_by_key(Value::to_string);
        assert_eq!(found, ["a", "b"]);
    }

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
