//! The effects' part of `cargo xtask test`.

use super::check;
use super::prices::STANDS;
use tools::suite::Suite;

/// Adds a step for the smallest processor, or with `full` for each: the prices are those recorded. With
/// `full`, the cycles are, too.
pub fn run(suite: &mut Suite, full: bool) {
    for stand in if full { &STANDS[..] } else { &STANDS[..1] } {
        let name = format!("effects: instructions and bytes are those recorded on {}", stand.board);
        suite.remarked(&name, |progress| check(stand, full, progress));
    }
}
