//! The renderer's pictures, lit again by a program for a Cortex-M0: every pixel has the same bits.

use anyhow::{Result, ensure};

use crate::c::ROOMY;
use crate::counted::Firmware;
use crate::program::Program;
use crate::record::Line;
use tools::progress::Progress;
use tools::suite::Suite;

/// The program, and the feature of the firmware that builds it.
const PICTURES: &str = "pictures";

/// Adds the step.
pub(crate) fn step(suite: &mut Suite) {
    suite.remarked("pictures: a program for cortex-m0 draws the pixels of the renderer", check);
}

/// Runs the program, which may not contain soft-float functions. Returns a line for each picture, or an error if
/// a pixel differs from the renderer's.
fn check(progress: &Progress) -> Result<Vec<String>> {
    let run = Firmware::new(PICTURES, &["--features", PICTURES]).run(&ROOMY, progress)?;
    Program::read(&run.file)?.has_no_float()?;
    remarks(&run.text, &run.regions.iter().map(|region| region.values().sum()).collect::<Vec<_>>())
}

/// Returns a line for each picture, from what the program has printed and from the instructions of each picture.
fn remarks(text: &str, instructions: &[u64]) -> Result<Vec<String>> {
    let lines = Line::all(text)?;
    ensure!(
        lines.iter().all(|line| line.unit != "first"),
        "expected the pixels of the renderer, found\n{text}"
    );
    ensure!(lines.len() == 2 * instructions.len() && !lines.is_empty(), "not all pictures:\n{text}");
    let pictures = lines.chunks(2).zip(instructions);
    pictures
        .map(|(lines, instructions)| {
            let (pixels, different) = (lines[0].value.parse::<u64>()?, &lines[1].value);
            ensure!(pixels > 0 && different == "0", "expected the pixels of the renderer, found\n{text}");
            let (name, each) = (&lines[0].name, instructions / pixels);
            Ok(format!("{name}: {pixels} pixels, {different} differ, {each} instructions a pixel"))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_differs_or_is_missing_is_refused() {
        let passed = "vase 4 pixels\nvase 0 different\n";
        assert_eq!(remarks(passed, &[10]).unwrap(), ["vase: 4 pixels, 0 differ, 2 instructions a pixel"]);
        let different = "vase 4 pixels\nvase 1 different\nvase 3:0 first\n";
        for (text, instructions) in [(different, &[10][..]), (passed, &[10, 10]), ("", &[])] {
            assert!(remarks(text, instructions).is_err(), "{text}");
        }
    }
}
