//! The keyboard alone is enough: it reaches every control, shows where it is, and does what the mouse
//! does in the picture.

use anyhow::{Context, Result, ensure};

use crate::contrast::Seen;
use crate::{Visitor, states};
use browser::Page;

/// What a mouse does over the picture and the curve: the element that has the focus, the key, whether
/// with Shift, and what it changes.
const GESTURES: [(&str, &str, &str, bool, &str); 10] = [
    ("orbit", "#view", "ArrowLeft", false, PICTURE),
    ("come closer", "#view", "+", false, PICTURE),
    ("go away", "#view", "-", false, PICTURE),
    ("raise a light", "#handle-0", "ArrowUp", false, "probe.value('light-y')"),
    ("move a light at its height", "#handle-0", "ArrowUp", true, "probe.value('light-z')"),
    ("aim a light", "#handle-aim", "ArrowRight", false, "probe.value('light-aim-x')"),
    ("widen a pool", "#handle-aim", "+", false, "probe.value('light-field-number')"),
    ("narrow a pool", "#handle-aim", "-", false, "probe.value('light-field-number')"),
    ("set an angle", "#curve [role=slider]", "ArrowRight", false, "probe.value('light-beam-number')"),
    ("reset the camera", "#view", "r", false, PICTURE),
];

/// A sum of the picture.
const PICTURE: &str = "luminaire.pixels().reduce((sum, code) => (31 * sum + code) % 4294967291, 7)";

/// Finds the controls that the Tab key must reach. Of a group of radio buttons it reaches the checked
/// one.
const FIND: &str = "window.stops = [...document.querySelectorAll(
    'a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex=\"-1\"])')].filter(
    (stop) => !stop.disabled && stop.getClientRects().length > 0 && stop.checkVisibility({ visibilityProperty: true }) &&
        (stop.type !== 'radio' || stop.checked))";

/// Marks what shows that an element has the focus, which is the label of a radio button.
const MARK: &str = "(() => {
    document.querySelector('[data-seen]')?.removeAttribute('data-seen');
    window.focused = document.activeElement;
    (focused.matches('.unseen') ? focused.parentElement : focused).setAttribute('data-seen', '');
    return focused.id || focused.textContent.trim() || focused.outerHTML.slice(0, 120);
})()";

pub(crate) fn does_every_gesture(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?scene=bare-spot&play=none")?;
    for (what, selector, key, shift, changes) in GESTURES {
        let target = format!("document.querySelector('{selector}')");
        page.ask(&format!("probe.until(() => {target})"))?;
        let before = page.number(changes)?;
        let drawn = page.number("luminaire.drawn")?;
        page.ask(&format!("{target}.focus()"))?;
        ensure!(page.holds(&format!("document.activeElement === {target}"))?, "{selector} takes no focus");
        page.ask(&format!("probe.key({target}, {{ key: '{key}', shiftKey: {shift} }})"))?;
        page.ask(&format!("probe.redrawn({drawn})")).with_context(|| format!("no key to {what}"))?;
        ensure!(page.number(changes)? != before, "the key to {what} changes nothing");
    }
    page.must_be_content()
}

/// The Tab key reaches every control of every state, and each shows that it has the focus.
pub(crate) fn reaches_every_control(visitor: &mut Visitor) -> Result<()> {
    for state in states::ALL {
        let mut page = states::open(visitor, state)?;
        walk(&mut page).with_context(|| state.0.to_owned())?;
        page.must_be_content()?;
    }
    Ok(())
}

fn walk(page: &mut Page) -> Result<()> {
    let stops = page.number(&format!("({FIND}).length"))?;
    ensure!(stops > 5.0, "there are only {stops} controls");
    page.ask("void stops[0].focus()")?;
    page.ask("void (window.reached = new Set())")?;
    // Also the parts that scroll are stops.
    for _ in 0..stops as u32 + 20 {
        if page.holds("reached.size > 0 && (document.activeElement === stops[0])")? {
            break;
        }
        if page.holds("document.activeElement !== document.body")? {
            let name = page.text(MARK)?;
            page.ask("void reached.add(focused)")?;
            let focused = Seen::around(page, "[data-seen]", 6)?;
            page.ask("focused.blur()")?;
            let differing = Seen::around(page, "[data-seen]", 6)?.differing(&focused);
            ensure!(differing > 30, "the focus of {name:?} is seen by {differing} pixels");
            page.ask("focused.focus()")?;
        }
        page.press("Tab", 9)?;
    }
    let missed = "stops.filter((stop) => !reached.has(stop)).map((stop) => stop.id || stop.outerHTML).join()";
    let missed = page.text(missed)?;
    ensure!(missed.is_empty(), "not reached: {missed}");
    Ok(())
}
