//! The demo as one folder that any web server can serve at any path.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde_json::Value;

use super::{chip, chips, shrink};
use crate::progress::Progress;
use crate::project;
use crate::wasm;

/// The price list that the page shows beside its pictures.
const PRICE_LIST: &str = "accuracy-vs-cost.json";
/// The prices of the effects, which the page shows beside their switches.
const EFFECTS: &str = "effects.json";

/// The picture that other sites show beside a link to the demo.
pub const PREVIEW: &str = "preview.png";

/// The page, whose navigation lists its views.
const PAGE: &str = include_str!("../../../../wasm-demo/web/index.html");

/// The names of the page's views, as its navigation links to them and its address shows them.
pub fn views() -> impl Iterator<Item = &'static str> {
    let navigation = PAGE.split_once("<nav class=\"views\"").and_then(|(_, rest)| rest.split_once("</nav>"));
    let links = navigation.map_or("", |(links, _)| links).split("href=\"#").skip(1);
    links.filter_map(|link| Some(link.split_once('"')?.0))
}

/// How the demo is built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Build {
    /// Without the view of the chip, whose firmware and hardware layer are built for another target.
    Part,
    /// All of it.
    Whole,
    /// All of it as it is published: shrunk by `wasm-opt`.
    Small,
}

/// The view that a [part](Build::Part) of the demo has not.
const CHIP: &str = "chip";

/// The demo's folder, `target/demo`.
pub fn folder() -> PathBuf {
    project::target().join("demo")
}

/// The views of the demo in its folder, with which the chip may not have been built.
pub fn built_views() -> impl Iterator<Item = &'static str> {
    let has_chip = chip::is_in(&folder());
    views().filter(move |view| *view != CHIP || has_chip)
}

/// Builds the demo into its folder: the page from `wasm-demo/web`, the price list, the picture for
/// link previews, the bindings in `pkg`, and what the board in the page needs.
pub fn build(build: Build, progress: &Progress) -> Result<PathBuf> {
    let site = folder();
    renew(&site, |new| {
        let step = progress.begin("Gathering", project::shown(&site));
        copy_folder(&project::root().join("wasm-demo/web"), new)?;
        for list in [PRICE_LIST, EFFECTS] {
            copy_list(list, &project::root().join("docs"), new)?;
        }
        chips::write(&project::root().join("docs"), new)?;
        let (page, list) = (new.join("index.html"), new.join(PRICE_LIST));
        fs::write(&page, with_figures(&fs::read_to_string(&page)?, &fs::read_to_string(list)?)?)?;
        let preview = project::root().join("docs/figures").join(PREVIEW);
        fs::copy(&preview, new.join(PREVIEW))
            .with_context(|| format!("cannot copy {}", preview.display()))?;
        step.done();
        for (package, folder) in wasm::PAGE {
            let module = package.compile(progress)?;
            build.finish(&package.bind(&module, &new.join(folder), progress)?, progress)?;
        }
        if build == Build::Part { Ok(()) } else { chip::write(new, build, progress) }
    })?;
    Ok(site)
}

impl Build {
    /// Makes a bound module what the page loads.
    pub(super) fn finish(self, module: &Path, progress: &Progress) -> Result<()> {
        if self == Self::Small { shrink::shrink(module, progress) } else { Ok(()) }
    }
}

/// Fills a new folder, and replaces `folder` by it once it is complete, because `folder` may be in
/// use. Concurrent calls wait for each other.
fn renew(folder: &Path, fill: impl FnOnce(&Path) -> Result<()>) -> Result<()> {
    let [new, old, lock] = ["new", "old", "lock"].map(|extension| folder.with_extension(extension));
    let lock = File::create(&lock).with_context(|| format!("cannot write {}", lock.display()))?;
    lock.lock().with_context(|| format!("cannot wait for another build of {}", folder.display()))?;
    // An interrupted build may have left its folders, and may have moved `folder` away without
    // replacing it.
    if !folder.exists() {
        let _ = fs::rename(&old, folder);
    }
    for left in [&new, &old] {
        if left.exists() {
            fs::remove_dir_all(left).with_context(|| format!("cannot remove {}", left.display()))?;
        }
    }
    fill(&new)?;
    // Renaming onto an existing folder works only if that folder is empty.
    let replaced = match fs::rename(folder, &old) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => fs::rename(&new, folder).inspect_err(|_| {
            let _ = fs::rename(&old, folder);
        }),
    };
    replaced.with_context(|| format!("cannot replace {}", folder.display()))?;
    if old.exists() {
        fs::remove_dir_all(&old).with_context(|| format!("cannot remove {}", old.display()))?;
    }
    Ok(())
}

/// Copies a list of prices, or writes `null` if there is none. The page always requests the list, and
/// a missing file would be an error on its console.
fn copy_list(name: &str, from: &Path, to: &Path) -> Result<()> {
    let (list, copy) = (from.join(name), to.join(name));
    if list.exists() {
        fs::copy(&list, &copy).with_context(|| format!("cannot copy {}", list.display())).map(drop)
    } else {
        fs::write(&copy, "null").with_context(|| format!("cannot write {}", copy.display()))
    }
}

/// The page with the figures of the price list in its first sentence, or without that sentence if
/// there is no list.
fn with_figures(page: &str, list: &str) -> Result<String> {
    const ENDS: [&str; 2] = ["<!-- figures -->", "<!-- end of figures -->"];
    let (before, rest) = page.split_once(ENDS[0]).context("the page has no place for figures")?;
    let (figures, after) = rest.split_once(ENDS[1]).context("the page's figures have no end")?;
    let list: Value = serde_json::from_str(list).context("the price list is no JSON")?;
    let mut rows = list["rows"].as_array().into_iter().flatten();
    let is_shown = |row: &&Value| row["kernel"] == "lit-inverse-square" && row["format"] == "fx16";
    let Some(row) = rows.find(is_shown) else { return Ok(format!("{before}{after}")) };
    let number = |value: &Value| value.as_f64().with_context(|| format!("{value} is no figure of the list"));
    let hundredths = 100.0 * number(&row["error"]["codes"])?;
    let instructions = number(&row["cost"]["cortex-m0"]["instructions"])?.round();
    let cone = (2.0 * number(&list["meta"]["half_angle"])?).round();
    // Rounded as in the documents, but for an upper bound, which is rounded up.
    let (bound, hundredths) = match row["error"]["kind"].as_str().context("the error has no kind")? {
        "searched" => ("the largest error found is", hundredths.round()),
        _ => ("the error is at most", hundredths.ceil()),
    };
    let error = hundredths / 100.0;
    let mut figures = figures.to_owned();
    for (name, value) in
        [("instructions", instructions.to_string()), ("error", error.to_string()), ("cone", cone.to_string())]
    {
        figures = figures.replace(&format!("{{{name}}}"), &value);
    }
    Ok(format!("{before}{}{after}", figures.replace("{bound}", bound)))
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
        fs::write(from.join("data/deep/lights.csv"), "lights").unwrap();
        copy_folder(&from, &to).unwrap();
        assert_eq!(fs::read_to_string(to.join("index.html")).unwrap(), "page");
        assert_eq!(fs::read_to_string(to.join("data/deep/lights.csv")).unwrap(), "lights");
    }

    #[test]
    fn the_price_list_is_there_whether_it_was_measured_or_not() {
        let temporary = tempfile::tempdir().unwrap();
        let (from, to) = (temporary.path().join("from"), temporary.path().join("to"));
        for folder in [&from, &to] {
            fs::create_dir(folder).unwrap();
        }
        let copied = || {
            copy_list(PRICE_LIST, &from, &to).unwrap();
            fs::read_to_string(to.join(PRICE_LIST)).unwrap()
        };
        assert_eq!(copied(), "null");
        fs::write(from.join(PRICE_LIST), r#"{"rows":[]}"#).unwrap();
        assert_eq!(copied(), r#"{"rows":[]}"#);
    }

    #[test]
    fn the_figures_are_those_of_the_list() {
        let list = |codes: f64| {
            format!(
                r#"{{"meta":{{"half_angle":21.81}},"rows":[{{"kernel":"lit-inverse-square","format":"fx16",
                "error":{{"codes":{codes},"kind":"searched"}},"cost":{{"cortex-m0":{{"instructions":222.4}}}}}}]}}"#
            )
        };
        let page = "<p><!-- figures -->{instructions}, {error}, {cone}, {bound}<!-- end of figures --></p>";
        assert_eq!(
            with_figures(page, &list(0.2538)).unwrap(),
            "<p>222, 0.25, 44, the largest error found is</p>"
        );
        let bound = list(0.2538).replace("searched", "exhaustive");
        assert_eq!(with_figures(page, &bound).unwrap(), "<p>222, 0.26, 44, the error is at most</p>");
        assert_eq!(with_figures(page, "null").unwrap(), "<p></p>");
        assert!(with_figures(page, &list(0.25).replace("222.4", "null")).is_err());
        assert!(with_figures("<p></p>", "null").is_err());
        let recorded = fs::read_to_string(project::root().join("docs").join(PRICE_LIST)).unwrap();
        let page = with_figures(PAGE, &recorded).unwrap();
        assert!(page.contains(" instructions on a Cortex-M0") && !page.contains('{'), "{page}");
    }

    #[test]
    fn the_views_are_those_of_the_navigation() {
        assert_eq!(views().collect::<Vec<_>>(), ["stage", "compare", "museum", "chip"]);
    }

    #[test]
    fn a_folder_is_renewed_whole_or_not_at_all() {
        let temporary = tempfile::tempdir().unwrap();
        let folder = temporary.path().join("demo");
        let page = || fs::read_to_string(folder.join("index.html")).unwrap();
        let write = |new: &Path, text: &str| {
            fs::create_dir(new)?;
            Ok(fs::write(new.join("index.html"), text)?)
        };
        renew(&folder, |new| write(new, "first")).unwrap();
        assert_eq!(page(), "first");
        let failed = renew(&folder, |new| {
            write(new, "half")?;
            assert_eq!(page(), "first");
            anyhow::bail!("no module")
        });
        assert_eq!((failed.unwrap_err().to_string().as_str(), page().as_str()), ("no module", "first"));
        renew(&folder, |new| write(new, "second")).unwrap();
        assert_eq!(page(), "second");
        let names = temporary.path().read_dir().unwrap().map(|entry| entry.unwrap().file_name());
        assert_eq!(names.count(), 2, "a folder is left beside the new one and its lock");
    }

    #[test]
    fn builds_at_the_same_time_take_nothing_from_one_another() {
        let temporary = tempfile::tempdir().unwrap();
        let folder = temporary.path().join("demo");
        std::thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    renew(&folder, |new| {
                        fs::create_dir(new)?;
                        for part in 0..20 {
                            fs::write(new.join(part.to_string()), "")?;
                        }
                        Ok(())
                    })
                    .unwrap();
                });
            }
        });
        assert_eq!(folder.read_dir().unwrap().count(), 20);
    }

    #[test]
    fn a_folder_that_is_not_there_is_named() {
        let temporary = tempfile::tempdir().unwrap();
        let error = copy_folder(&temporary.path().join("web"), &temporary.path().join("to")).unwrap_err();
        assert!(error.to_string().contains("web"), "{error}");
    }
}
