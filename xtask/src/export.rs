//! The part of `cargo xtask test` that compiles and runs what `luminaire-export` writes, and programs
//! in C that call the library.

use anyhow::Result;

use browser_tests::shaders;
use tools::browser::Chromium;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::{command, compilers};

/// Adds the steps: the tests with all compilers, and the shaders in Chromium.
pub(crate) fn run(suite: &mut Suite) {
    suite.count("export: C compiles for small processors, and has the bits of the kernel", by_all_compilers);
    for language in shaders::LANGUAGES {
        let name = format!("export: shaders in {language} draw what the kernel computes");
        suite.remarked(&name, |progress| {
            let found = shaders::differences(&mut Chromium::start(progress)?, language)?;
            shaders::check(&found)?;
            Ok(vec![format!("{language}: {found}")])
        });
    }
}

fn by_all_compilers(progress: &Progress) -> Result<Tally> {
    compilers::find(progress)?;
    let mut test = command::cargo("test");
    // The tests skip a compiler that is not installed, unless this variable is set.
    test.args(["--package", "luminaire-export", "--test", "fixed", "--test", "float"])
        .args(["--package", "luminaire-c", "--test", "calls"])
        .env("LUMINAIRE_TOOLS", "1");
    tally::cargo_test(test, progress)
}
