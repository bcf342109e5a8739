//! axe-core finds no fault: neither against the criteria of WCAG 2.2, A and AA, nor against best
//! practice.

use std::fs;

use anyhow::{Context, Result, ensure};

use crate::{Visitor, states};
use browser::Page;
use tools::demo::site;
use tools::install;
use tools::progress::Progress;

const RUN: &str = "axe.run({
    runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'],
    resultTypes: ['violations'],
}).then(({ passes, violations }) => ({
    passes: passes.length,
    violations: violations.flatMap(({ id, nodes }) =>
        nodes.map(({ target, failureSummary }) => `${id} at ${target.join(' ')}: ${failureSummary}`)),
}))";

/// The widths of a laptop and of a telephone.
const WIDTHS: [u32; 2] = [1280, 390];

/// Every view once, with all panels open.
pub(crate) fn finds_nothing_in_the_views(visitor: &mut Visitor) -> Result<()> {
    let mut page = states::open(visitor, states::EVERY_PANEL)?;
    load(&mut page)?;
    page.resize(WIDTHS[0], 900)?;
    for view in site::built_views() {
        page.ask(&format!("document.querySelector('.views a[href=\"#{view}\"]').click()"))?;
        page.ask("probe.until(() => document.querySelector('main > :not([hidden])')?.textContent)")?;
        page.settle()?;
        finds_nothing(&mut page, view)?;
    }
    page.must_be_content()
}

/// Every state at every width.
pub(crate) fn finds_nothing_anywhere(visitor: &mut Visitor) -> Result<()> {
    for state in states::ALL {
        let mut page = states::open(visitor, state)?;
        load(&mut page)?;
        for width in WIDTHS {
            page.resize(width, 900)?;
            page.settle()?;
            finds_nothing(&mut page, &format!("{}, {width} pixels wide", state.0))?;
        }
        page.must_be_content()?;
    }
    Ok(())
}

fn load(page: &mut Page) -> Result<()> {
    let file = install::npm("axe-core", &Progress::kept())?.join("axe.min.js");
    let axe = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
    page.ask(axe.trim_end_matches(';')).map(drop)
}

fn finds_nothing(page: &mut Page, place: &str) -> Result<()> {
    let found = page.ask(RUN)?;
    ensure!(found["passes"].as_u64() > Some(20), "{place}: axe has checked next to nothing: {found}");
    ensure!(
        found["violations"].as_array().is_some_and(|list| list.is_empty()),
        "{place}: {:#}",
        found["violations"]
    );
    Ok(())
}
