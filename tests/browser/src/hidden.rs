//! A page that nobody sees draws nothing, and goes on when it is seen again.

use std::thread;
use std::time::Duration;

use anyhow::{Result, ensure};

use crate::Visitor;

/// Opens another tab before the page.
const COVER: &str = "void (window.other = open('about:blank'))";

pub(crate) fn draws_nothing(visitor: &mut Visitor) -> Result<()> {
    let query = "?width=320&height=180#stage?scene=show";
    let mut page = visitor.browser.open(&format!("{}{query}", visitor.address), "")?;
    page.ready()?;
    page.ask("probe.until(() => luminaire.drawn > 3)")?;
    page.ask(COVER)?;
    page.ask("probe.until(() => document.hidden)")?;
    // The picture that was being drawn may still end.
    thread::sleep(Duration::from_millis(500));
    let drawn = page.number("luminaire.drawn")?;
    thread::sleep(Duration::from_secs(2));
    let later = page.number("luminaire.drawn")?;
    ensure!(later == drawn, "{} pictures are drawn while nobody sees them", later - drawn);
    page.ask("other.close()")?;
    page.ask(&format!("probe.until(() => luminaire.drawn > {later} + 3)"))?;
    page.must_be_content()
}
