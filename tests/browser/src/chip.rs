//! The board in the page: what its display receives, and what it costs to load.

use std::fs;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};

use crate::Visitor;
use browser::Page;
use tools::demo::publish;

/// How long the chip may take to show its first pictures, on a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// Upper bound of the bytes of the view, compressed by gzip.
const BUDGET: usize = 150_000;

pub(crate) fn shows_the_right_pixels(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let early = page.requests()?.iter().find(|request| is_of_the_chip(request)).cloned();
    ensure!(early.is_none(), "{early:?} is loaded before the view is opened");
    page.ask("location.hash = '#chip'")?;
    let drawn = until(&mut page, "luminaire.chip?.drawn >= 3")?;
    ensure!(drawn, "the display has received no frame in {PATIENCE:?}");
    page.ask("document.getElementById('chip-run').click()")?;
    let (picture, name) = (page.ask("luminaire.chip.picture")?, page.message("chip-name")?);
    ensure!(picture["differing"] == 0 && picture["count"] == 19_200, "{picture}");
    ensure!(picture["name"] == name.as_str() && name.starts_with("frame "), "{picture} is called {name}");
    ensure!(page.message("chip-differ")? == "0", "the page tells of {} pixels", page.message("chip-differ")?);
    let sums = [page.message("chip-checksum")?, page.message("chip-expected")?];
    ensure!(sums[0] == sums[1] && picture["checksum"] == sums[0].as_str(), "checksums {sums:?}");
    let cycles: f64 = page.message("chip-cycles")?.parse().context("the cycles a pixel")?;
    ensure!((100.0..1000.0).contains(&cycles), "{cycles} cycles a pixel");
    ensure!(page.number("probe.place('#chip-display').width % 240")? == 0.0, "the pixels have unequal sizes");

    // Stopped, the chip shows one picture more when the visitor steps.
    page.ask("new Promise((resolve) => setTimeout(resolve, 300))")?;
    let before = page.number("luminaire.chip.drawn")?;
    page.ask("document.getElementById('chip-picture').click()")?;
    ensure!(until(&mut page, &format!("luminaire.chip.drawn > {before}"))?, "a step shows no picture");
    page.ask("new Promise((resolve) => setTimeout(resolve, 300))")?;
    let after = page.number("luminaire.chip.drawn")?;
    ensure!(after == before + 1.0, "a step shows {} pictures", after - before);
    page.must_be_content()
}

/// Waits until an expression is true. Returns whether it became so in time.
fn until(page: &mut Page, expression: &str) -> Result<bool> {
    let start = Instant::now();
    while !page.holds(&format!("Boolean({expression})"))? {
        if start.elapsed() > PATIENCE {
            return Ok(false);
        }
        thread::sleep(Duration::from_millis(50));
    }
    Ok(true)
}

fn is_of_the_chip(address: &str) -> bool {
    let name = address.rsplit_once('/').map_or(address, |(_, name)| name);
    ["chip", "luminaire_chip", "rp2040"].iter().any(|start| name.starts_with(start))
}

/// The files of the view in a folder for static hosts are small, and the licences are among them.
pub(crate) fn is_small(folder: &Path) -> Result<()> {
    let mut bytes = 0;
    for folder in [folder.to_owned(), folder.join("chip")] {
        for entry in folder.read_dir().with_context(|| format!("cannot read {}", folder.display()))? {
            let path = entry?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            if path.is_file() && is_of_the_chip(&name) && !name.starts_with("chip-licenses") {
                bytes += publish::gzip(&fs::read(&path)?)?;
            }
        }
    }
    ensure!((50_000..BUDGET).contains(&bytes), "the chip takes {bytes} bytes, expected under {BUDGET}");
    let licenses = folder
        .read_dir()?
        .flatten()
        .find(|entry| entry.file_name().to_string_lossy().starts_with("chip-licenses"));
    let text = fs::read_to_string(licenses.context("the licences are missing")?.path())?;
    for name in ["rp2040js 1.4.1", "rp2040-hal", "Uri Shaked", "Raspberry Pi (Trading) Ltd."] {
        ensure!(text.contains(name), "the licences do not name {name}");
    }
    Ok(())
}
