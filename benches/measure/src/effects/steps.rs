//! The effects' part of `cargo xtask full`.

use super::check;
use super::prices::STANDS;
use tools::suite::Suite;

/// Adds a step for each processor: the prices are those recorded.
pub fn run(suite: &mut Suite) {
    for stand in &STANDS {
        let name = format!("effects: instructions and bytes are those recorded on {}", stand.board);
        suite.remarked(&name, |progress| check(stand, progress));
    }
}
