//! `cargo xtask prove`: the errors of the fixed-point stages, by Gappa and Coq.

use anyhow::Result;

use tools::command::cargo;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::{install, tool};

/// Adds the step. As root on Debian, it installs Gappa, Coq and the library that checks Gappa's proofs.
pub(crate) fn step(suite: &mut Suite) {
    suite.count("proofs: the errors of the fixed-point stages, by Gappa and Coq", prove);
}

fn prove(progress: &Progress) -> Result<Tally> {
    install::program(&tool::GAPPA, progress)?;
    install::program(&tool::COQ, progress)?;
    let mut test = cargo(["test", "--package", "luminaire", "--lib", "--features", "fixed"]);
    test.args(["--", "proofs", "model_of_the_proofs", "--nocapture"]).env("LUMINAIRE_COQ", "1");
    tally::cargo_test(test, progress)
}
