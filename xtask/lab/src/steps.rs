//! The laboratory's part of `cargo xtask test` and `cargo xtask full`.

use anyhow::Result;

use measure::steps;
use tools::suite::Suite;

use crate::arguments::{Part, StepsOptions};
use crate::{browsers, package, renderers};

/// Runs the steps, and writes their counts for the program that has called this one.
pub(crate) fn run(options: StepsOptions) -> Result<()> {
    let StepsOptions { part, full, only, report } = options;
    let mut suite = Suite::new(only).beside_others();
    match part {
        Part::Boards if full => {
            steps::all_boards(&mut suite);
            renderers::steps(&mut suite);
            package::run(&mut suite);
        }
        Part::Boards => steps::smallest_board(&mut suite),
        Part::Browsers => browsers::visit(&mut suite, full),
    }
    suite.report(&report)
}
