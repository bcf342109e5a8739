//! The laboratory's part of `cargo xtask test` and `cargo xtask full`.

use anyhow::Result;

use measure::boards::{self, Board};
use measure::{c, conform, device, effects, frame, pick, prices, size};
use tools::suite::Suite;

use crate::arguments::{Part, StepsOptions};
use crate::{browsers, package, renderers};

/// Runs the steps, and writes their counts for the program that has called this one.
pub(crate) fn run(options: StepsOptions) -> Result<()> {
    let StepsOptions { part, full, only, report } = options;
    let mut suite = Suite::new(only).beside_others();
    match part {
        Part::Boards if full => all_boards(&mut suite),
        Part::Boards => smallest_board(&mut suite),
        Part::Browsers => browsers::visit(&mut suite, full),
    }
    suite.report(&report)
}

/// The promises that need a linker or other processors than the host's: no panic, nothing for what is
/// not used, the budget of bytes, and the same bits. What panics does so on every processor.
fn smallest_board(suite: &mut Suite) {
    size::steps::run(suite, false);
    conform::steps::run(suite, false);
}

/// All that is promised or recorded of any board.
fn all_boards(suite: &mut Suite) {
    let boards: Vec<_> = boards::BOARDS.iter().collect();
    boards::steps::run(suite, &boards);
    frame::steps::run(suite, &boards);
    size::steps::run(suite, true);
    effects::steps::run(suite);
    pick::steps(suite, &boards);
    c::steps(suite);
    device::steps::run(suite);
    renderers::steps(suite);
    prices(suite, &boards);
    conform::steps::run(suite, true);
    package::run(suite);
}

fn prices(suite: &mut Suite, boards: &[&'static Board]) {
    suite.remarked("prices: errors and instructions are those of the list", |progress| {
        let targets: Vec<_> = boards.iter().map(|board| prices::Target::Board(board)).collect();
        prices::check(&targets, progress)
    });
}
