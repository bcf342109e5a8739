//! Opens a page of the demo in Chromium and prints what it measures: `check ADDRESS [PICTURE]`, where the
//! picture is the file of a PNG of the page at 1440x900. `cargo demo --check` calls it.

use std::env;
use std::path::PathBuf;

use anyhow::{Context, Result};
use browser::check::check;
use tools::progress::Progress;

fn main() -> Result<()> {
    let mut words = env::args().skip(1);
    let address = words.next().context("expected the address of a page of the demo")?;
    let screenshot = words.next().map(PathBuf::from);
    let progress = Progress::Live;
    let step = progress.begin("Checking", &address);
    let verdict = check(&address, screenshot.as_deref(), &progress)?;
    step.done();
    println!("{verdict}");
    Ok(())
}
