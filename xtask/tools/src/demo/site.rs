//! The demo as one folder that any web server can serve at any path.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use super::{chip, chips};
use crate::progress::Progress;
use crate::project;
use crate::wasm;

pub use super::shrink::Build;

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

/// Builds the demo into its folder: the page from `wasm-demo/web`, the prices of formats and effects,
/// the picture for link previews, the bindings in `pkg`, and what the board in the page needs.
pub fn build(build: Build, progress: &Progress) -> Result<PathBuf> {
    let site = folder();
    renew(&site, |new| {
        progress.say("Gathering", project::shown(&site));
        let docs = project::root().join("docs");
        let mut files = project::files(&project::root().join("wasm-demo/web"), &[])?;
        for (folder, name) in [("", "prices.json"), ("figures", PREVIEW)] {
            let file = docs.join(folder).join(name);
            let content = fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?;
            files.insert(name.into(), content);
        }
        project::mirror(&files, new, &[])?;
        chips::write(&docs, new)?;
        for (package, folder) in wasm::PAGE {
            let module = package.compile(build.profile(), progress)?;
            build.finish(&package.bind(&module, &new.join(folder), progress)?, progress)?;
        }
        // How large the module is once a host's compression is undone: what the page's progress counts.
        let bytes = fs::metadata(new.join("pkg/wasm_demo_bg.wasm"))?.len();
        let page = new.join("index.html");
        let text = fs::read_to_string(&page)?;
        fs::write(&page, text.replace("id=\"loaded\" max=\"1\"", &format!("id=\"loaded\" max=\"{bytes}\"")))?;
        if build == Build::Part { Ok(()) } else { chip::write(new, build, progress) }
    })?;
    Ok(site)
}

/// Fills a new folder, and replaces `folder` by it once it is complete, because `folder` may be in
/// use. Concurrent calls wait for each other.
fn renew(folder: &Path, fill: impl FnOnce(&Path) -> Result<()>) -> Result<()> {
    let [new, lock] = ["new", "lock"].map(|extension| folder.with_extension(extension));
    let lock = File::create(&lock).with_context(|| format!("cannot write {}", lock.display()))?;
    lock.lock().with_context(|| format!("cannot wait for another build of {}", folder.display()))?;
    let remove = |left: &Path| match fs::remove_dir_all(left) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    };
    // An interrupted build may have left a new folder.
    remove(&new).with_context(|| format!("cannot remove {}", new.display()))?;
    fill(&new)?;
    remove(folder)
        .and_then(|()| fs::rename(&new, folder))
        .with_context(|| format!("cannot replace {}", folder.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let failed = renew(&folder, |new| {
            write(new, "half")?;
            anyhow::bail!("no module")
        });
        assert_eq!((failed.unwrap_err().to_string().as_str(), page().as_str()), ("no module", "first"));
        renew(&folder, |new| write(new, "second")).unwrap();
        assert_eq!(page(), "second");
    }
}
