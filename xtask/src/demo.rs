//! `cargo demo`: builds the demo, then serves or checks it, or writes it for a static host.

use std::path;

use anyhow::{Context, Result};

use crate::arguments::DemoOptions;
use tools::browser;
use tools::demo::publish::publish;
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::server::{self, Server};

const PORT: u16 = 8080;

/// Builds the demo, then serves or checks it, or writes it for a static host.
pub(crate) fn run(options: &DemoOptions) -> Result<()> {
    let progress = Progress::Live;
    if let Some(folder) = &options.build {
        let site = site::build(Build::Small, &progress)?;
        let first =
            publish(&site, folder, [&options.address, &options.repository].map(Option::as_deref), &progress)?;
        println!("{}: the first picture takes {} files", folder.display(), first.len());
        return Ok(());
    }
    let checking = options.check || options.screenshot.is_some();
    // Before the build, so that a taken port is reported at once.
    let listener = server::listen(options.port.unwrap_or(if checking { 0 } else { PORT }))?;
    let server = Server::on(listener, server::HEADERS, &site::build(Build::Whole, &progress)?)?;
    let view = options.view.as_ref().map(|view| format!("#{view}"));
    let address = server.address() + &view.unwrap_or_default();
    if checking {
        let screenshot = options.screenshot.as_ref().map(path::absolute).transpose();
        let screenshot = screenshot.context("the screenshot has no path")?;
        println!("{}", browser::check(&address, screenshot.as_deref(), &progress)?);
        Ok(())
    } else {
        println!("The demo is at {address} (Ctrl+C ends it)");
        server.wait()
    }
}

/// What `cargo demo` builds before it starts: a newcomer waits for it.
#[test]
fn demo_starts_after_at_most_50_packages() {
    let words = ["tree", "--package=xtask", "--edges=normal,build", "--prefix=none", "--no-dedupe"];
    let tree = tools::command::answer(&mut tools::command::cargo(words)).unwrap();
    let packages: std::collections::BTreeSet<_> = tree.lines().collect();
    assert!((30..=50).contains(&packages.len()), "{} packages: {packages:#?}", packages.len());
}
