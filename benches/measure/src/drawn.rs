//! What a point of a row call costs: rows of a wall, the drawables and a strip of LEDs.

use anyhow::{Result, ensure};
use tools::progress::Progress;

use crate::counted::Firmware;
use crate::record::{Group, Line};
use crate::target::Board;

/// The prefix of the names on record.
pub(crate) const PREFIX: &str = "drawn.";

/// The row calls: name, title, and what they are.
pub(crate) const DRAWN: [(&str, &str, &str); 7] = [
    ("row", "row of points", "a row of a wall inside a spotlight's pool: its irradiance"),
    ("row-every-4th", "row, every 4th point", "the same row, interpolated between every 4th point"),
    ("gradient", "gradient, linear", "a slanted gradient of two colours"),
    ("gradient-radial", "gradient, radial", "a radial gradient of two colours"),
    ("pool", "pool of light", "a spotlight on a screen of 240 x 240 pixels, of which it lights a part"),
    ("sprite", "sprite", "a ball of 120 x 120 pixels with a normal each, under one spotlight"),
    (
        "leds",
        "LED",
        "one of 500 LEDs under four spotlights, and its three bytes within a limit of the current",
    ),
];

/// Adds the instructions and, where they are counted, the cycles of one point of each row call to the
/// board's group. The results must be the host's.
pub(crate) fn add(board: &'static Board, group: &mut Group, progress: &Progress) -> Result<()> {
    let mut run = Firmware::new("drawn", &[]).run(board, progress)?;
    let cycles = run.cycles(board, progress)?;
    let lines = Line::all(&run.text)?;
    ensure!(
        lines.len() == 2 * run.regions.len(),
        "drawn: {} lines, {} regions",
        lines.len(),
        run.regions.len()
    );
    for (number, (lines, region)) in lines.chunks(2).zip(&run.regions).enumerate() {
        let (name, points) = (format!("{PREFIX}{}", lines[1].name), lines[1].value.parse::<f64>()?);
        let tenths = |count: u64| (10.0 * count as f64 / points).round() / 10.0;
        group.add(&name, "instructions", tenths(region.values().sum()));
        if let Some(cycles) = &cycles {
            group.add(&name, "cycles", tenths(cycles[number]));
        }
    }
    Ok(())
}
