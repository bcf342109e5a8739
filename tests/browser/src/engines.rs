//! What the page promises in every browser engine.

use anyhow::{Result, ensure};

use crate::{Test, Visitor};
use browser::{Engine, Page};

/// The test for the engines other than the first alone.
const ELSEWHERE: [Test; 1] =
    [("the page outlives the engine's limit of new addresses", outlives_the_limit_of_addresses)];

/// Tests that an engine cannot run, and why.
const LIMITED: [(Engine, &str, &str); 11] = [
    (
        Engine::Firefox,
        "forced colours hide nothing",
        "WebDriver BiDi's command for forced colours is not in Firefox yet",
    ),
    (Engine::Firefox, "no task of the page takes longer than 50 ms", "only Chromium records tasks"),
    (Engine::WebKit, "no task of the page takes longer than 50 ms", "only Chromium records tasks"),
    (Engine::WebKit, "forced colours hide nothing", "WebKit forces no colours"),
    (
        Engine::WebKit,
        "a hidden page draws nothing, and goes on when it is seen",
        "windows of a virtual display are never hidden",
    ),
    (
        Engine::WebKit,
        "a lost connection keeps views from opening, until it is back",
        "WebDriver has no command to disconnect a page",
    ),
    (
        Engine::WebKit,
        "fixed point is loaded when it is chosen, or that is told",
        "WebDriver has no command to disconnect a page",
    ),
    (
        Engine::WebKit,
        "at rest the picture has the resolution of the device",
        "WebDriver has no command for the density of a display",
    ),
    (Engine::WebKit, "rest ends with a change", "WebDriver has no command for the density of a display"),
    (
        Engine::WebKit,
        "a page that is opened as a file says so",
        "WebKitGTK answers no script in a page from a file",
    ),
    (
        Engine::WebKit,
        "what decorates a picture may fail",
        "WebKit tells a page nothing of the errors that a test's script throws",
    ),
];

/// The size of the picture in the engines other than the first, as a part of the address.
pub(crate) const SIZE: &str = "?width=480&height=270";

/// The pictures that all engines must draw alike: each effect in each number format.
const PICTURES: [&str; 4] = [
    "#stage?play=none&scene=show",
    "#stage?play=none&scene=three-point&format=f32",
    "#stage?play=none&scene=three-point&format=fx32",
    "#stage?play=none&scene=three-point&format=fx16",
];

/// All tests that an engine other than the first can run.
pub fn tests_of(engine: Engine) -> impl Iterator<Item = &'static Test> {
    let all = crate::QUICK.iter().chain(&crate::MORE).chain(&ELSEWHERE);
    all.filter(move |(name, _)| !LIMITED.iter().any(|(limited, test, _)| *limited == engine && test == name))
}

/// Fails if the pictures of two visitors differ in a bit.
pub fn draw_alike(one: &mut Visitor, other: &mut Visitor) -> Result<()> {
    for address in PICTURES {
        let [one, other] = [&mut *one, &mut *other].map(|visitor| {
            let mut page = visitor.ready_at(&format!("{SIZE}{address}"))?;
            ensure!(page.lit_share()? > 0.0, "{address} is black in {}", visitor.browser.engine());
            page.must_be_content()?;
            page.text("probe.digest()")
        });
        let (one, other) = (one?, other?);
        ensure!(one == other, "{address} has the SHA-256 {other}, expected {one}");
    }
    Ok(())
}

/// WebKit refuses a page's 101st change of its address within ten seconds. The page is used while its
/// changes are refused.
fn outlives_the_limit_of_addresses(visitor: &mut Visitor) -> Result<()> {
    const SPEND: &str = "(() => {
        try { for (let i = 0; i < 1000; i += 1) history.replaceState(null, '', location.hash); }
        catch (error) { return error.name; }
        return 'none';
    })()";
    let refusal = if visitor.browser.engine() == Engine::WebKit { "SecurityError" } else { "none" };
    let mut page = visitor.ready()?;
    let spend = |page: &mut Page| -> Result<()> {
        let found = page.text(SPEND)?;
        ensure!(found == refusal, "a thousand addresses are refused by {found}, expected {refusal}");
        Ok(())
    };
    spend(&mut page)?;
    page.change("a beam", |page| page.enter("light-beam-number", 15))?;
    let middle = page.middle("view")?;
    for by in [40.0, -30.0] {
        page.change("a drag", |page| page.drag(middle, (by, 10.0)))?;
        spend(&mut page)?;
    }
    // Longer than the page waits before it writes the last change.
    page.ask("new Promise((resolve) => setTimeout(resolve, 600))")?;
    ensure!(page.state()? == "ready", "the page is dead: {}", page.message("failure")?);
    ensure!(!page.shows("trouble")?, "the visitor is told of {}", page.message("trouble")?);
    page.must_be_content()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_tests_of_the_list_are_limited() {
        for (engine, name, why) in LIMITED {
            let mut all = crate::QUICK.iter().chain(&crate::MORE);
            assert!(all.any(|(test, _)| *test == name), "{engine} has no test {name:?}");
            assert!(!why.is_empty());
        }
    }
}
