//! The address follows what the page shows. The page also works if it cannot write the address.

use anyhow::{Result, ensure};

use crate::Visitor;
use browser::Page;

/// A browser that accepts a hundred addresses in ten seconds, as Safari does, of which five are
/// left.
const LIMITED: &str = "{
    const write = history.replaceState.bind(history);
    let left = 5;
    history.replaceState = (...what) => {
        if (left === 0) throw new DOMException('more than 100 times per 10 seconds', 'SecurityError');
        left -= 1;
        setTimeout(() => { left += 1; }, 10000);
        write(...what);
    };
}";

const REFUSING: &str = "history.replaceState = () => { throw new DOMException('no', 'SecurityError'); }";

pub(crate) fn is_written_seldom(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_with("#compare?left=f32-cosine&right=f32&half=10", LIMITED)?;
    for half in 1..=20 {
        enter(&mut page, "half-angle-number", &(f64::from(half) / 4.0).to_string())?;
    }
    alive(&mut page)?;
    says(&mut page, "#compare?left=f32-cosine&right=f32&half=5")?;

    // A pending address of one view must not overwrite the address of the next view.
    enter(&mut page, "half-angle-number", "7")?;
    page.ask("void (location.hash = '#stage?scene=bare-spot&play=none')")?;
    page.settle()?;
    says(&mut page, "#stage?v=1&scene=bare-spot&play=none")?;
    // Forty pictures of a drag, one address.
    let middle = page.middle("view")?;
    for step in 0..40 {
        let by = if step % 2 == 0 { 4.0 } else { -4.0 };
        page.drag(middle, (by, 0.0))?;
    }
    enter(&mut page, "format", "fx32")?;
    alive(&mut page)?;
    page.ask("probe.until(() => location.hash.includes('format=fx32'))").map(drop)
}

pub(crate) fn may_be_refused(visitor: &mut Visitor) -> Result<()> {
    for view in ["#compare?half=10", "#stage?scene=pocket&play=none"] {
        let mut page = visitor.ready_with(view, REFUSING)?;
        for (control, value) in [("half-angle-number", "3"), ("format", "fx32")] {
            page.enter(control, value)?;
        }
        // Longer than the page waits before it writes the last change.
        page.ask("new Promise((resolve) => setTimeout(resolve, 600))")?;
        alive(&mut page)?;
    }
    Ok(())
}

/// Enters a value and waits only for the next picture, not until the page has settled.
fn enter(page: &mut Page, id: &str, value: &str) -> Result<()> {
    page.ask(&format!("probe.enter('{id}', '{value}')"))?;
    page.ask("new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))")
        .map(drop)
}

fn says(page: &mut Page, hash: &str) -> Result<()> {
    page.ask(&format!("probe.until(() => location.hash === '{hash}')")).map(drop)
}

fn alive(page: &mut Page) -> Result<()> {
    ensure!(page.state()? == "ready", "the page is dead: {}", page.message("failure")?);
    ensure!(!page.shows("trouble")?, "the visitor is told of {}", page.message("trouble")?);
    page.must_be_content()
}
