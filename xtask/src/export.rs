//! The part of `cargo xtask test` that compiles and runs what `luminaire-export` writes.

use anyhow::{Result, bail};

use browser_tests::shaders;
use tools::browser::Chromium;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::{command, install};

/// The compilers that the tests call, and Debian's packages of them.
const COMPILERS: [(&str, &str); 5] = [
    ("cc", "gcc"),
    ("c++", "g++"),
    ("arm-none-eabi-gcc", "gcc-arm-none-eabi"),
    ("arm-none-eabi-g++", "gcc-arm-none-eabi"),
    ("riscv64-unknown-elf-gcc", "gcc-riscv64-unknown-elf"),
];

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
    let missing = |(program, _): &&(&str, &str)| command::on_path(&[program]).is_none();
    let mut packages: Vec<_> = COMPILERS.iter().filter(missing).map(|(_, package)| *package).collect();
    packages.dedup();
    if !packages.is_empty() {
        if !install::debian_root() {
            bail!("compilers of C are missing: on Debian, `apt-get install {}`", packages.join(" "));
        }
        install::apt(&packages, progress)?;
    }
    let mut test = command::cargo("test");
    // The tests skip a compiler that is not installed, unless this variable is set.
    test.args(["--package", "luminaire-export", "--test", "fixed", "--test", "float"])
        .env("LUMINAIRE_TOOLS", "1");
    tally::cargo_test(test, progress)
}
