//! The picture's part of `cargo xtask test`.

use super::record::Record;
use super::{PROGRAM, compare, draw, on_the_host};
use crate::boards::Board;
use crate::boards::laboratory::Laboratory;
use tools::suite::Suite;

/// Adds a step for each board: the picture is the host's, there is no soft float, and what is
/// counted is what is recorded.
pub fn run(suite: &mut Suite, boards: &[&'static Board]) {
    for &board in boards {
        let name = format!("frame: the picture, no soft float, and its counts on {}", board.name);
        suite.remarked(&name, |progress| {
            let host = on_the_host(progress)?;
            let mut record = Record::new(&host);
            record.boards.insert(
                board.name.to_owned(),
                draw(&Laboratory::with_program(PROGRAM, board, progress)?, &host)?,
            );
            compare(&record, &host.picture)
        });
    }
}
