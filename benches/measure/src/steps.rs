//! The laboratory's part of `cargo xtask test` and `cargo xtask full`.

use anyhow::ensure;

use crate::counted::Firmware;
use crate::documents::check;
use crate::effects::{self, EMPTY, FORMATS, FX16, UNUSED, write_programs};
use crate::program::Program;
use crate::proof::{CONFIGURATIONS, no_panic};
use crate::target::{BOARDS, ESP8266, Target};
use crate::{c, conform, counted, device, on, pictures};
use tools::suite::Suite;
use tools::{command, project};

/// Upper bound, in bytes of flash, of a soft spotlight with Lambert's cosine in `Fx16` on the
/// smallest processor.
const BUDGET: u64 = 1920;

/// The program of that spotlight.
const SPOT: &str = "lit";

/// Adds the promises that need a linker or other processors than the host's: no panic, and the same bits. What
/// panics does so on every processor.
pub fn smallest_board(suite: &mut Suite) {
    suite.remarked("effects: no function panics and none allocates on cortex-m0", |progress| {
        Ok(vec![no_panic(CONFIGURATIONS[0], &BOARDS[0], &[FX16], progress)?])
    });
    conform::steps(suite, false);
}

/// Adds all that is promised or recorded of any board.
pub fn all_boards(suite: &mut Suite) {
    firmware(suite);
    for board in &BOARDS {
        suite.step(&format!("firmware: the counter is exact on {}", board.name), |progress| {
            counted::is_exact(board, progress)
        });
        if board.has_root() {
            suite.step(
                &format!("firmware: a square root has the host's bits on {}", board.name),
                |progress| Firmware::new("roots", &[]).run(board, progress).map(drop),
            );
        }
        suite.remarked(&format!("measure: the counts are those on record on {}", board.name), |progress| {
            check(&on(Target::Board(board), true, progress)?)
        });
    }
    suite.remarked("measure: the counts are those on record on esp8266", |progress| {
        check(&on(Target::OfC(&ESP8266), true, progress)?)
    });
    // Of each instruction set, and with a floating point unit: what panics does so on every processor, but what a
    // compiler leaves out may differ.
    let [cortex_m0, _, cortex_m4f, rv32imc, ..] = &BOARDS;
    for board in [cortex_m0, cortex_m4f, rv32imc] {
        suite.remarked(
            &format!("effects: no function panics and none allocates on {}", board.name),
            |progress| Ok(vec![no_panic(CONFIGURATIONS[0], board, &FORMATS, progress)?]),
        );
    }
    for configuration in &CONFIGURATIONS[1..] {
        let name = format!("effects: no function panics in the configuration {}", configuration.0);
        suite.remarked(&name, |progress| Ok(vec![no_panic(*configuration, &BOARDS[0], &FORMATS, progress)?]));
    }
    linked(suite);
    suite.remarked("measure: the errors are those on record", |progress| {
        check(&on(Target::Errors, true, progress)?)
    });
    pictures::step(suite);
    c::steps(suite);
    device::steps(suite);
    conform::steps(suite, true);
}

/// The firmware's format and lints. It has no tests: what it does is compared with the record.
fn firmware(suite: &mut Suite) {
    let cargo = |words: &[&str]| {
        let mut cargo = command::cargo(words);
        cargo.current_dir(project::root().join(counted::FIRMWARE));
        cargo
    };
    suite.step("firmware: cargo fmt", |progress| progress.run(cargo(&["fmt", "--all", "--check"])));
    suite.step("firmware: cargo clippy", |progress| {
        write_programs()?;
        let options =
            ["--workspace", "--features", "conform,effects,pictures", "--all-targets", "--", "-Dwarnings"];
        progress.run(cargo(&[&["clippy"], &options[..]].concat()))
    });
}

/// What linked programs prove of effects that are not used, and of the soft spotlight.
fn linked(suite: &mut Suite) {
    suite.step("effects: what is not used adds no byte and no instruction", |progress| {
        let names = [EMPTY, SPOT, UNUSED];
        let options: Vec<_> = names.iter().flat_map(|name| ["--bin", name]).collect();
        let folder = effects::build(&options, &BOARDS[0], FX16, progress)?;
        let [empty, alone, beside] = names.map(|name| Program::read(&folder.join(name)));
        let (empty, alone, beside) = (empty?, alone?, beside?);
        // A program that could name other effects, but does not, is the same to the byte.
        ensure!(
            alone.flash == beside.flash,
            "{} bytes alone, {} beside others",
            alone.bytes(),
            beside.bytes()
        );
        let used = empty.names_of(|name| name.contains("luminaire::"));
        ensure!(used.is_empty(), "the empty program has {}", used.join(", "));
        let bytes = alone.bytes() - empty.bytes();
        ensure!(bytes <= BUDGET, "the soft spotlight takes {bytes} bytes, and {BUDGET} are promised");
        Ok(())
    });
}
