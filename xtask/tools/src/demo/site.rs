//! The demo as one folder that any web server can serve at any path.
//!
//! It can be served as soon as its page and its first part, the stage, are there. The other parts are
//! added while it is served; until all are, `parts.json` tells the page which are missing.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use serde_json::json;

use super::{chip, chips};
use crate::progress::Progress;
use crate::project;
use crate::wasm::{self, Package};

pub use super::shrink::Build;

/// The picture that other sites show beside a link to the demo.
pub const PREVIEW: &str = "preview.png";

/// The page, whose navigation lists its views.
const PAGE: &str = include_str!("../../../../wasm-demo/web/index.html");

/// The file of the page.
const INDEX: &str = "index.html";

/// The names of the page's views, as its navigation links to them and its address shows them.
pub fn views() -> impl Iterator<Item = &'static str> {
    let navigation = PAGE.split_once("<nav class=\"views\"").and_then(|(_, rest)| rest.split_once("</nav>"));
    let links = navigation.map_or("", |(links, _)| links).split("href=\"#").skip(1);
    links.filter_map(|link| Some(link.split_once('"')?.0))
}

/// The states of the parts, in the demo's folder, while some are missing.
const STATES: &str = "parts.json";

/// What stands in the page for its state, and what tells it of [`STATES`].
const STATE: &str = "<body data-state=\"loading\"";

/// The demo's folder below `target`: one for each kind of build, so that the tests leave to a visitor
/// what he has built.
pub fn folder(build: Build) -> PathBuf {
    project::target().join(match build {
        Build::Whole => "demo",
        Build::Part => "demo-without-chip",
        Build::Small => "demo-published",
    })
}

/// The views that the demo has in its folder. That of the chip may not have been built.
pub fn built_views(build: Build) -> impl Iterator<Item = &'static str> {
    let has_chip = chip::is_in(&folder(build));
    views().filter(move |view| *view != wasm::CHIP.part() || has_chip)
}

/// How far a part of the demo is.
#[derive(Debug, PartialEq)]
enum State {
    Waiting,
    Building,
    Built,
    /// Left out, because this machine lacks a program that it does without.
    Left(String),
    Failed(String),
}

/// The demo while it is built. Concurrent calls of one folder wait for each other.
#[derive(Debug)]
pub struct Site {
    build: Build,
    folder: PathBuf,
    parts: Vec<(&'static str, State)>,
    _lock: File,
}

/// Builds the demo into its folder, with all of its parts.
pub fn build(build: Build, progress: &Progress) -> Result<PathBuf> {
    let mut site = Site::open(build, progress)?;
    let failed = site.finish(progress)?;
    ensure!(failed.is_empty(), "{}", failed.join("; "));
    if site.is_whole() {
        // No page has been served that would read it.
        fs::remove_file(site.folder.join(STATES)).context("cannot remove the states of the parts")?;
    }
    Ok(site.folder)
}

impl Site {
    /// Builds what the first picture needs: the page from `wasm-demo/web`, the prices of formats and
    /// effects, the picture for link previews, and the stage.
    pub fn open(build: Build, progress: &Progress) -> Result<Self> {
        let folder = folder(build);
        let lock = lock(&folder, progress)?;
        let modules = wasm::PAGE.iter().map(|(package, _)| package.part());
        let parts = modules.chain((build != Build::Part).then_some(wasm::CHIP.part()));
        let parts = parts.map(|part| (part, State::Waiting)).collect();
        let mut site = Self { build, folder, parts, _lock: lock };
        let (stage, place) = &wasm::PAGE[0];
        let bindings = build.bound(stage, progress)?;
        site.parts[0].1 = State::Built;
        progress.say("Gathering", project::shown(&site.folder));
        project::renew(&site.folder, |new| {
            site.gather(new)?;
            project::add(&bindings, &new.join(place))?;
            site.tell(new)
        })?;
        Ok(site)
    }

    /// The folder, which can be served.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The number of parts.
    pub fn count(&self) -> usize {
        self.parts.len()
    }

    /// Builds the other parts: each is added to the folder when it is ready. Returns why parts have
    /// failed, with their names; after one, the next is still built.
    pub fn finish(&mut self, progress: &Progress) -> Result<Vec<String>> {
        let mut failed = Vec::new();
        for index in 1..self.parts.len() {
            self.set(index, State::Building)?;
            let name = self.parts[index].0;
            let state = match wasm::PAGE.get(index) {
                Some((package, place)) => self.add(package, place, progress).map(|()| State::Built),
                None => chip::write(&self.folder, self.build, progress).map(|left| match left {
                    None => State::Built,
                    Some(reason) => State::Left(reason),
                }),
            };
            let state = state.unwrap_or_else(|error| State::Failed(format!("{error:#}")));
            match &state {
                State::Failed(reason) => failed.push(format!("{name}: {reason}")),
                State::Left(reason) => progress.say("Leaving", format_args!("out the {name}: {reason}")),
                _ => {}
            }
            self.set(index, state)?;
        }
        Ok(failed)
    }

    /// Adds a module to the folder.
    fn add(&self, package: &Package, place: &str, progress: &Progress) -> Result<()> {
        project::add(&self.build.bound(package, progress)?, &self.folder.join(place))
    }

    /// Writes what needs no compiler.
    fn gather(&self, new: &Path) -> Result<()> {
        let docs = project::root().join("docs");
        let mut files = project::files(&project::root().join("wasm-demo/web"), &[])?;
        for (folder, name) in [("", "prices.json"), ("figures", PREVIEW)] {
            let file = docs.join(folder).join(name);
            let content = fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?;
            files.insert(name.into(), content);
        }
        project::mirror(&files, new, &[])?;
        chips::write(&docs, new)
    }

    /// Notes the state of a part, and tells the page.
    fn set(&mut self, index: usize, state: State) -> Result<()> {
        self.parts[index].1 = state;
        self.tell(&self.folder)
    }

    /// Writes the states of the parts, and the page, into a folder.
    fn tell(&self, folder: &Path) -> Result<()> {
        let parts = self.parts.iter().map(|(name, state)| match state {
            State::Waiting => json!({ "name": name, "state": "waiting" }),
            State::Building => json!({ "name": name, "state": "building" }),
            State::Built => json!({ "name": name, "state": "built" }),
            State::Left(reason) | State::Failed(reason) => {
                json!({ "name": name, "state": "failed", "reason": reason })
            }
        });
        let states = json!({ "parts": parts.collect::<Vec<_>>() });
        project::replace(&folder.join(STATES), states.to_string().as_bytes())?;
        let page = project::root().join("wasm-demo/web").join(INDEX);
        let page = fs::read_to_string(&page).with_context(|| format!("cannot read {}", page.display()))?;
        // What the page's progress counts: how large the module is once a host's compression is undone.
        let bytes = fs::metadata(folder.join("pkg/wasm_demo_bg.wasm"))?.len();
        let mut page = page.replace("id=\"loaded\" max=\"1\"", &format!("id=\"loaded\" max=\"{bytes}\""));
        ensure!(page.contains(STATE), "{INDEX}: expected {STATE}");
        if !self.is_whole() {
            page = page.replace(STATE, &format!("{STATE} data-parts=\"{STATES}\""));
        }
        project::replace(&folder.join(INDEX), page.as_bytes())
    }

    /// Whether all parts are there.
    fn is_whole(&self) -> bool {
        self.parts.iter().all(|(_, state)| *state == State::Built)
    }
}

/// Locks a folder against other builds until the lock is dropped.
fn lock(folder: &Path, progress: &Progress) -> Result<File> {
    let path = folder.with_extension("lock");
    fs::create_dir_all(project::target())?;
    let lock = File::create(&path).with_context(|| format!("cannot write {}", path.display()))?;
    if lock.try_lock().is_err() {
        progress.say("Waiting", format_args!("for another build of {}", project::shown(folder)));
        lock.lock().with_context(|| format!("cannot wait for another build of {}", folder.display()))?;
    }
    Ok(lock)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder with a stage of four bytes, and a part in this state.
    fn told(state: State) -> (String, serde_json::Value) {
        let temporary = tempfile::tempdir().unwrap();
        let folder = temporary.path().to_owned();
        fs::create_dir(folder.join("pkg")).unwrap();
        fs::write(folder.join("pkg/wasm_demo_bg.wasm"), "1234").unwrap();
        let lock = File::create(folder.join("lock")).unwrap();
        let parts = vec![("stage", State::Built), ("chip", State::Building)];
        let mut site = Site { build: Build::Whole, folder: folder.clone(), parts, _lock: lock };
        site.set(1, state).unwrap();
        let read = |name| fs::read_to_string(folder.join(name)).unwrap();
        (read(INDEX), serde_json::from_str(&read(STATES)).unwrap())
    }

    #[test]
    fn page_is_told_of_missing_parts_until_all_are_there() {
        for (state, expected) in [
            (State::Waiting, json!({ "name": "chip", "state": "waiting" })),
            (State::Left("no npm".into()), json!({ "name": "chip", "state": "failed", "reason": "no npm" })),
            (State::Failed("E0308".into()), json!({ "name": "chip", "state": "failed", "reason": "E0308" })),
        ] {
            let (page, states) = told(state);
            assert!(page.contains("<body data-state=\"loading\" data-parts=\"parts.json\">"), "{expected}");
            assert!(page.contains("id=\"loaded\" max=\"4\""), "{expected}");
            assert_eq!(states["parts"], json!([{ "name": "stage", "state": "built" }, expected]));
        }
        let (page, _) = told(State::Built);
        assert!(page.contains("<body data-state=\"loading\">"));
    }
}
