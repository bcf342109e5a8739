//! `cargo demo`: builds the demo, then serves or checks it, or writes it for a static host.

use std::path;
use std::time::Instant;

use anyhow::{Context, Result};

use crate::arguments::DemoOptions;
use tools::browser;
use tools::demo::publish::publish;
use tools::demo::site::{self, Build, Site};
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
    let view = options.view.as_ref().map(|view| format!("#{view}")).unwrap_or_default();
    if checking {
        let server = Server::on(listener, server::HEADERS, &site::build(Build::Whole, &progress)?)?;
        let screenshot = options.screenshot.as_ref().map(path::absolute).transpose();
        let screenshot = screenshot.context("the screenshot has no path")?;
        println!("{}", browser::check(&(server.address() + &view), screenshot.as_deref(), &progress)?);
        return Ok(());
    }
    let start = Instant::now();
    let seconds = || start.elapsed().as_secs_f64();
    let mut site = Site::open(Build::Whole, &progress)?;
    let server = Server::on(listener, server::HEADERS, site.folder())?;
    println!("The demo is at {}{view} after {:.0} s (Ctrl+C ends it)", server.address(), seconds());
    progress.say("Building", format_args!("the other {} parts of the demo behind it", site.count() - 1));
    let failed = site.finish(&progress)?;
    for reason in &failed {
        progress.say("Failed", reason);
    }
    let built = site.count() - failed.len();
    println!(
        "The demo is at {}{view}: {built} of {} parts after {:.0} s",
        server.address(),
        site.count(),
        seconds()
    );
    drop(site);
    server.wait()
}

/// What `cargo demo` builds before it starts: a newcomer waits for it.
#[test]
fn demo_starts_after_few_packages() {
    let words = ["tree", "--package=xtask", "--edges=normal,build", "--prefix=none", "--no-dedupe"];
    let tree = tools::command::answer(&mut tools::command::cargo(words)).unwrap();
    let packages: std::collections::BTreeSet<_> = tree.lines().collect();
    assert!((30..=53).contains(&packages.len()), "{} packages: {packages:#?}", packages.len());
}
