//! `cargo xtask prove`: the errors of the fixed-point stages, by Gappa and Coq, and the list of them.

use std::fs;

use anyhow::{Context, Result, ensure};

use tools::command::cargo;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::{install, project, tool};

/// Adds the step. As root on Debian, it installs Gappa, Coq and the library that checks Gappa's proofs.
pub(crate) fn step(suite: &mut Suite) {
    suite.count("proofs: the errors of the fixed-point stages, by Gappa and Coq", prove);
}

fn prove(progress: &Progress) -> Result<Tally> {
    install::program(&tool::GAPPA, progress)?;
    install::program(&tool::COQ, progress)?;
    let mut test = cargo(["test", "--package", "luminaire", "--lib", "--features", "fixed"]);
    test.args(["--", "proofs", "model_of_the_proofs", "--nocapture"]).env("LUMINAIRE_COQ", "1");
    let tally = tally::cargo_test(test, progress)?;
    let list = project::target().join("proofs/stages.md");
    let list = fs::read_to_string(&list).with_context(|| format!("cannot read {}", list.display()))?;
    let text = fs::read_to_string(project::root().join("docs/NUMERICS.md"))
        .context("cannot read docs/NUMERICS.md")?;
    ensure!(text.contains(&list), "docs/NUMERICS.md does not have this list of the stages:\n{list}");
    Ok(tally)
}
