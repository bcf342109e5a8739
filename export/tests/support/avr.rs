//! Programs for AVR, in an emulator.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::compiler::{compile, is_missing};

/// The headers of the library, whose tables are in flash: not beside the stand-in of `write_headers`.
pub(crate) const LIBRARY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/c/src");

/// The options for an AVR with memory for the tests.
const OPTIONS: &str = "-std=gnu99 -Os -mmcu=atmega1284p -DF_CPU=16000000UL";

/// Runs a program that ends by a sleep without interrupts. Returns the lines of its UART; `None` without
/// the emulator.
pub(crate) fn emulate(processor: &str, program: &Path) -> Option<Vec<String>> {
    // Before `timeout` is called, which on Windows names a different program.
    if Command::new("simavr").arg("--help").output().is_err() {
        return is_missing("simavr");
    }
    let mut emulator = Command::new("timeout");
    let Ok(output) =
        emulator.args(["300", "simavr", "-f", "16000000", "-m", processor]).arg(program).output()
    else {
        return is_missing("timeout");
    };
    assert!(output.status.success(), "{}: {:?}", program.display(), output.status);
    let text = String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
    // A line is green, and its carriage return and line feed are printed as points.
    let lines = text.split("\x1b[32m").skip(1).filter_map(|line| line.split_once("..\n"));
    Some(lines.map(|(line, _)| line.to_owned()).collect())
}

/// Compiles a program of C with an input. Returns what its UART prints: with `-DPRINT`, also what the
/// program does.
pub(crate) fn printed(flags: &str, main: &Path, input: &[u8]) -> Option<Vec<String>> {
    let folder = main.parent().expect("a folder");
    fs::write(folder.join("input.bin"), input).expect("a folder");
    let frame = folder.join("frame.c");
    fs::write(&frame, include_str!("../avr/main.c")).expect("a folder");
    let flags = format!("{OPTIONS} {flags} -I{LIBRARY} -Wa,-I{}", folder.display());
    let [object, program] = ["frame.o", "program.elf"].map(|name| folder.join(name));
    compile("avr-gcc", &format!("{flags} -c"), &frame, &object)?;
    let main_object = folder.join("main.o");
    compile("avr-gcc", &format!("{flags} -Dmain=program -c"), main, &main_object)?;
    let mut link = Command::new("avr-gcc");
    link.args(["-mmcu=atmega1284p", "-o"]).arg(&program).args([&object, &main_object]);
    assert!(link.status().expect("avr-gcc").success());
    emulate("atmega1284p", &program)
}

/// Asserts that a program writes these bytes. Does nothing without the compiler and the emulator.
///
/// # Panics
/// The bytes differ, or the program returns another code than 0.
pub(crate) fn writes(main: &Path, input: &[u8], expected: &[u8]) {
    let Some(lines) = printed("", main, input) else { return };
    let hash = expected
        .iter()
        .fold(2_166_136_261_u32, |hash, byte| (hash ^ u32::from(*byte)).wrapping_mul(16_777_619));
    let expected = format!("{:08x} {:08x} {hash:08x}", 0, expected.len());
    assert_eq!(lines, [expected], "{}: code, bytes and hash", main.display());
}
