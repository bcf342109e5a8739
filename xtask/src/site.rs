//! The demo as one folder, which works wherever it is served from.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::progress::Progress;
use crate::{project, shrink, wasm};

/// The price list that the page shows beside its pictures.
const PRICE_LIST: &str = "accuracy-vs-cost.json";

/// Builds the demo into `target/demo`: the page from `wasm-demo/web`, the price list, the bindings in `pkg`.
pub(crate) fn build(progress: &Progress) -> Result<PathBuf> {
    let module = wasm::DEMO.compile(progress)?;
    let site = project::target().join("demo");
    let step = progress.begin("Gathering", project::shown(&site));
    if site.exists() {
        fs::remove_dir_all(&site).with_context(|| format!("cannot empty {}", site.display()))?;
    }
    copy_folder(&project::root().join("wasm-demo/web"), &site)?;
    copy_price_list(&project::root().join("docs"), &site)?;
    step.done();
    let bound = wasm::DEMO.bind(&module, &site.join("pkg"), progress)?;
    shrink::shrink(&bound, progress)?;
    Ok(site)
}

/// Copies the price list, or writes `null` where none was measured: the page asks for it either way, and a file
/// that is missing would be an error on its console.
fn copy_price_list(from: &Path, to: &Path) -> Result<()> {
    let (list, copy) = (from.join(PRICE_LIST), to.join(PRICE_LIST));
    if list.exists() {
        fs::copy(&list, &copy).with_context(|| format!("cannot copy {}", list.display())).map(drop)
    } else {
        fs::write(&copy, "null").with_context(|| format!("cannot write {}", copy.display()))
    }
}

fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to).with_context(|| format!("cannot create {}", to.display()))?;
    let entries = from.read_dir().with_context(|| format!("cannot read {}", from.display()))?;
    for entry in entries {
        let source = entry.with_context(|| format!("cannot read {}", from.display()))?.path();
        let Some(name) = source.file_name() else { continue };
        let copy = to.join(name);
        if source.is_dir() {
            copy_folder(&source, &copy)?;
        } else {
            fs::copy(&source, &copy).with_context(|| format!("cannot copy {}", source.display()))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_copied_with_its_folders() {
        let temporary = tempfile::tempdir().unwrap();
        let (from, to) = (temporary.path().join("from"), temporary.path().join("to"));
        fs::create_dir_all(from.join("data/deep")).unwrap();
        fs::write(from.join("index.html"), "page").unwrap();
        fs::write(from.join("data/deep/lamps.csv"), "lamps").unwrap();
        copy_folder(&from, &to).unwrap();
        assert_eq!(fs::read_to_string(to.join("index.html")).unwrap(), "page");
        assert_eq!(fs::read_to_string(to.join("data/deep/lamps.csv")).unwrap(), "lamps");
    }

    #[test]
    fn the_price_list_is_there_whether_it_was_measured_or_not() {
        let temporary = tempfile::tempdir().unwrap();
        let (from, to) = (temporary.path().join("from"), temporary.path().join("to"));
        for folder in [&from, &to] {
            fs::create_dir(folder).unwrap();
        }
        let copied = || {
            copy_price_list(&from, &to).unwrap();
            fs::read_to_string(to.join(PRICE_LIST)).unwrap()
        };
        assert_eq!(copied(), "null");
        fs::write(from.join(PRICE_LIST), r#"{"rows":[]}"#).unwrap();
        assert_eq!(copied(), r#"{"rows":[]}"#);
    }

    #[test]
    fn a_folder_that_is_not_there_is_named() {
        let temporary = tempfile::tempdir().unwrap();
        let error = copy_folder(&temporary.path().join("web"), &temporary.path().join("to")).unwrap_err();
        assert!(error.to_string().contains("web"), "{error}");
    }
}
