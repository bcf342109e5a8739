//! The folder for static hosts: under any path, without special headers, and quickly loaded.

use std::collections::BTreeSet;
use std::fs;

use anyhow::{Context, Result, ensure};

use crate::{Visitor, chip};
use browser::Page;
use tools::demo::{publish::publish, site};
use tools::server::{self, Server};

/// The path under which the folder is served.
const PATH: &str = "some/where/";

/// Upper bound of the bytes that the first picture takes, compressed by gzip.
const GZIP: usize = 400_000;

/// What the page loads by itself after the first picture: the beginnings of the files' names.
const LATE: [&str; 6] = ["curve.", "effect-prices.", "effects.", "handles.", "press.", "shapes."];

/// The first picture is, and so is what the chip loads, once `wasm-opt` has shrunk the modules.
pub(crate) fn is_small(_: &mut Visitor) -> Result<()> {
    let folder = tempfile::tempdir()?;
    let first = publish(&site::folder(), folder.path(), None)?;
    ensure!(first.gzip < GZIP, "expected less than {GZIP} bytes by gzip, found: {first}");
    chip::is_small(folder.path())
}

pub(crate) fn works_under_a_path(visitor: &mut Visitor) -> Result<()> {
    let host = tempfile::tempdir()?;
    let folder = host.path().join(PATH);
    let first = publish(&site::folder(), &folder, Some("https://example.org/demo/"))?;
    let server = Server::start_plain(server::listen(0)?, host.path())?;
    let address = format!("{}{PATH}", server.address());

    let mut page = visitor.browser.open(&address, "")?;
    page.ready()?;
    ensure!(page.lit_share()? > 0.0, "the picture is black");
    ensure!(!page.holds("window.crossOriginIsolated")?, "the server sends special headers");
    let mut requested = requested(&mut page, &address)?;
    requested.retain(|name| !LATE.iter().any(|late| name.starts_with(late)));
    let mut needed = first.files;
    needed.remove("index.html");
    // A browser without a window needs no icon.
    let icon = |name: &String| name.starts_with("icon.");
    ensure!(
        requested.is_subset(&needed) && needed.difference(&requested).all(icon),
        "the first picture requests {requested:?}, expected {needed:?}"
    );
    page.must_be_content()?;

    for view in site::built_views() {
        let mut page = visitor.browser.open(&format!("{address}#{view}?play=none"), "")?;
        page.ready()?;
        page.settle()?;
        let current = page.text("document.querySelector('.views [aria-current]').hash")?;
        ensure!(current == format!("#{view}") && !page.shows("absent")?, "{view} does not open");
        page.must_be_content()?;
    }
    preview_is_there(&mut page, &folder)
}

/// The names below an address that the page has requested, without the page itself. Firefox and WebKit
/// also list the pictures and fonts of their own controls, which are data in the address.
fn requested(page: &mut Page, address: &str) -> Result<BTreeSet<String>> {
    let requests = page.requests()?;
    let names = requests.iter().filter(|request| !request.starts_with("data:")).map(|request| {
        request.strip_prefix(address).map(str::to_owned).with_context(|| format!("a stranger: {request}"))
    });
    let mut names = names.collect::<Result<BTreeSet<_>>>()?;
    names.remove("");
    Ok(names)
}

/// The picture for link previews exists and has the size that the page states.
fn preview_is_there(page: &mut Page, folder: &std::path::Path) -> Result<()> {
    let mut stated = |property: &str| {
        page.text(&format!("document.querySelector('meta[property=\"{property}\"]').content"))
    };
    let image = stated("og:image")?;
    let name = image.strip_prefix("https://example.org/demo/").with_context(|| image.clone())?;
    let file = std::io::Cursor::new(fs::read(folder.join(name))?);
    let info = png::Decoder::new(file).read_info()?.info().size();
    let size = format!("{}x{}", stated("og:image:width")?, stated("og:image:height")?);
    ensure!(size == format!("{}x{}", info.0, info.1), "the page states {size} for {info:?}");
    for property in ["og:title", "og:description", "og:url"] {
        ensure!(!stated(property)?.is_empty(), "{property} is empty");
    }
    Ok(())
}
