//! The check of a board's firmware: what its display receives, against the host's pixels.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use luminaire_stage::Shown;
use serde::Deserialize;
use tools::command;
use tools::progress::Progress;
use tools::project;

use super::lines::{Line, PAGE, row};
use crate::{frame, rp2040};

/// Runs firmware in the emulator.
const SCRIPT: &str = "benches/measure/src/device/rp2040.mjs";
/// The pictures that are checked: the still, the black display, the frame on record, and the first that
/// moves.
const PICTURES: usize = 4;
/// The name of the emulator in the table of boards, and how many of its lines the page quotes.
const EMULATOR: &str = "rp2040js, an emulator";
const PRINTED: usize = 3;
/// The cycles that a miss of the flash's cache takes at least: 8 clocks of four bits for the address and the
/// mode, 4 in which the flash prepares, and 16 for the line of 8 bytes, of 4 cycles each, as the second stage of
/// the boot sets them (`rp2040-boot2`, `boot2_w25q080.S`).
const MISS: u64 = (8 + 4 + 16) * 4;

/// What the emulator has recorded.
#[derive(Debug, Deserialize)]
struct Recorded {
    /// The lines on the UART, one for each picture.
    lines: Vec<String>,
    pictures: Vec<Received>,
    /// Instructions, cycles without misses of the flash's cache, and misses of each region.
    regions: Vec<[u64; 3]>,
}

/// A picture that the display has received.
#[derive(Debug, Deserialize)]
struct Received {
    /// The first and the last column of the window.
    columns: [u16; 2],
    /// The first and the last row of the window.
    rows: [u16; 2],
    pixels: Vec<u16>,
}

/// Runs the firmware of the RP2040 from the second stage of the boot on. Returns a line for each
/// picture, that of the recorded frame last. An error if a pixel differs from the host's, or if the
/// recorded frame takes another number of instructions than in QEMU, or the page states other cycles, by the same compiler.
pub(super) fn check(firmware: &Path, progress: &Progress) -> Result<Vec<String>> {
    let recorded = run(firmware, progress)?;
    let stages = luminaire_stage::STAGES.split(' ').count();
    let mut regions = recorded.regions.as_slice();
    let (mut lines, mut last) = (Vec::new(), None);
    ensure!(recorded.pictures.len() == PICTURES, "the display has received {}", recorded.pictures.len());
    let printed = recorded.lines.iter().map(|line| Line::parse(line)).collect::<Result<Vec<_>>>()?;
    for ((number, received), line) in (0..).zip(&recorded.pictures).zip(&printed) {
        let expected = Shown::numbered(number);
        compare(&expected, received)?;
        line.is_of(&expected)?;
        if !expected.is_lit {
            continue;
        }
        let count = stages * (expected.rows[1] - expected.rows[0] + 1) as usize;
        let (counted, rest) = regions.split_at_checked(count).context("the emulator lacks regions")?;
        regions = rest;
        let pixels = expected.pixels.len();
        let [instructions, cycles, misses] = [0, 1, 2].map(|i| counted.iter().map(|region| region[i]).sum());
        let [cycles, slowed] = [cycles, cycles + MISS * misses].map(|cycles| cycles as f64 / pixels as f64);
        let line = format!(
            "{pixels} pixels, 0 differ, {cycles:.1} cycles a pixel, {slowed:.1} with {misses} misses of the cache, \
             {:.1} on two cores",
            line.cycles_a_pixel()
        );
        if expected.name == "frame 0" {
            frame::agrees(firmware, instructions)?;
            last = Some(format!("rp2040: {line}"));
        } else {
            lines.push(format!("{}: {line}", expected.name));
        }
    }
    lines.extend(last);
    if frame::is_of_record(firmware)? {
        let row = row(EMULATOR, &printed).context("the emulator lacks pictures")?;
        let page = fs::read_to_string(project::root().join(PAGE)).context(PAGE)?;
        let is_there = |line: &&String| page.contains(line.as_str());
        let stated = recorded.lines[..PRINTED].iter().chain([&row]);
        let missing: Vec<_> = stated.filter(|line| !is_there(line)).map(String::as_str).collect();
        ensure!(missing.is_empty(), "{PAGE} lacks these lines:\n{}", missing.join("\n"));
    }
    Ok(lines)
}

fn run(firmware: &Path, progress: &Progress) -> Result<Recorded> {
    let result = project::target().join("rp2040.json");
    let mut node = rp2040::script(SCRIPT, progress)?;
    command::answer(node.arg(firmware).arg(PICTURES.to_string()).arg(&result))?;
    let text = fs::read_to_string(&result).context("rp2040js has recorded nothing")?;
    serde_json::from_str(&text).context("rp2040js has recorded something else")
}

/// Fails if the display has received something else than expected.
fn compare(expected: &Shown, received: &Received) -> Result<()> {
    let Shown { name, columns, rows, pixels, .. } = expected;
    let window = (&received.columns, &received.rows);
    ensure!(window == (columns, rows), "{name}: window {window:?}, expected {columns:?} and {rows:?}");
    let count = received.pixels.len();
    ensure!(count == pixels.len(), "{name}: {count} pixels received, expected {}", pixels.len());
    let differ = received.pixels.iter().zip(pixels).filter(|(received, pixel)| received != pixel).count();
    ensure!(differ == 0, "{name}: {count} pixels, {differ} differ");
    Ok(())
}
