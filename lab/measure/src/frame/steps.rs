//! The picture's part of `cargo xtask test`.

use tools::suite::Suite;

use super::drawn;
use crate::boards::Board;
use crate::record;

/// Adds a step for each board: the picture is the host's, there is no soft float, and the counts
/// are those on record. With `full`, the cycles are, too.
pub fn run(suite: &mut Suite, boards: &[&'static Board], full: bool) {
    for &board in boards {
        let name = format!("frame: the picture, no soft float, and its counts on {}", board.name);
        suite.remarked(&name, |progress| record::check(&drawn(&[board], full, progress)?));
    }
}
