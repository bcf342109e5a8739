//! The states of the page in which its accessibility and its layout are tested.

use anyhow::{Context, Result};

use crate::Visitor;
use browser::Page;

/// A state: its name, its address, and what a visitor does there as a JavaScript expression.
pub(crate) type State = (&'static str, &'static str, &'static str);

/// Opens every panel and drawer of the page, also those that are loaded when they are in view.
const OPEN_ALL: &str = "(async () => {
    document.getElementById('price').scrollIntoView();
    await probe.until(() => document.querySelector('#price-picked b'));
    for (const details of document.querySelectorAll('details')) details.open = true;
    await probe.until(() => [...document.querySelectorAll('details pre')].every((pre) => pre.textContent));
})()";

/// Runs the board until it has shown a picture, and stops it.
const RUN_BOARD: &str = "(async () => {
    await probe.until(() => luminaire.chip?.drawn > 0);
    document.getElementById('chip-run').click();
    await probe.until(() => probe.text('chip-state') === 'The chip waits.');
})()";

/// The stage with all panels open.
pub(crate) const EVERY_PANEL: State =
    ("every panel open", "#stage?scene=three-point&play=none&format=fx16", OPEN_ALL);

/// Every view, the stage and the comparison in each of their modes.
pub(crate) const ALL: [State; 12] = [
    ("the show", "#stage?scene=show&play=none", ""),
    EVERY_PANEL,
    ("a refused address", "#stage?scene=three-point&play=none&lights=0:b0.1&format=fx16", ""),
    ("a refused angle", "#stage?scene=three-point&play=none", "probe.enter('light-beam-number', 1000)"),
    ("a divided picture", "#stage?scene=pocket&play=none", "probe.enter('divided-format', 'fx16')"),
    ("the map of lights", "#stage?scene=pocket&play=none&map=lights", ""),
    ("the map of costs", "#stage?scene=pocket&play=none&map=cost", ""),
    ("the map of tiles", "#stage?scene=pocket&play=none&map=tiles", ""),
    ("the comparison", "#compare?left=fx16&half=10", ""),
    ("a refused form", "#compare?left=fx16&half=0.1", ""),
    ("the museum", "#museum", "probe.enter('exhibit-number', 1000)"),
    ("the chip", "#chip", RUN_BOARD),
];

/// Opens the page in a state.
pub(crate) fn open(visitor: &mut Visitor, (name, address, act): State) -> Result<Page> {
    let mut page = visitor.ready_at(address).with_context(|| name.to_owned())?;
    page.ask(act).with_context(|| name.to_owned())?;
    page.settle()?;
    Ok(page)
}
