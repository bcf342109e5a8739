//! The picture's part of `cargo xtask full`.

use tools::suite::Suite;

use super::drawn;
use crate::boards::Board;
use crate::record;

/// Adds the steps of each board. The picture is the host's, there is no soft float, and the counts
/// are those on record.
pub fn run(suite: &mut Suite, boards: &[&'static Board]) {
    for &board in boards {
        let name = format!("frame: the picture, no soft float, and its counts on {}", board.name);
        suite.remarked(&name, |progress| record::check(&drawn(&[board], progress)?));
    }
}
