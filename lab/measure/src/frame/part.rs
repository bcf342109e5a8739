//! The table of the picture, as the command prints it and as `lab/firmware/README.md` has it.

use super::list::{Counts, StageList};
use crate::boards::board;

/// The lines of the README between which the table stands.
pub(super) const LINES: [&str; 2] =
    ["<!-- frame: written by `cargo xtask frame --bless` -->\n", "<!-- end of frame -->\n"];

/// The names of the stages, and their titles in the README.
const TITLES: [(&str, &str); 6] = [
    ("geometry", "geometry: what the pixel sees, point and normal"),
    ("ambient", "ambient light alone"),
    ("light", "light: falloff, Lambert's cosine, inverse square"),
    ("shadow", "shadow: is the ball or the column in the way"),
    ("colour", "colour: ambient light and the spotlight's, as the material sends it back"),
    ("display", "display: clipped, dithered, packed"),
];
/// The stages of the whole picture, and of the picture without the light.
const WITH: [&str; 5] = ["geometry", "light", "shadow", "colour", "display"];
const WITHOUT: [&str; 3] = ["geometry", "ambient", "display"];

/// The part of the README.
pub(super) fn write(list: &StageList) -> String {
    format!("\n{}\nOf {} pixels: {}.\n\n", table(list), list.pixels, list.light)
}

/// A row for each stage, a column for each board.
pub(super) fn table(list: &StageList) -> String {
    let boards: Vec<_> = board::ALL
        .iter()
        .filter_map(|board| list.boards.get(board.name).map(|counts| (board.title, counts)))
        .collect();
    let row = |title: &str, cell: &dyn Fn(&Counts) -> String| {
        let cells: String = boards.iter().map(|(_, counts)| format!(" {} |", cell(counts))).collect();
        format!("| {title} |{cells}\n")
    };
    let each = |counts: &Counts, stages: &[&str]| {
        let sum: u64 = stages.iter().filter_map(|stage| counts.instructions.get(*stage)).sum();
        sum as f64 / list.pixels as f64
    };
    let heads: String = boards.iter().map(|(title, _)| format!(" {title} |")).collect();
    let mut text =
        format!("| instructions a pixel, on average |{heads}\n|---|{}\n", "---|".repeat(boards.len()));
    for (stage, title) in TITLES {
        text += &row(title, &|counts| format!("{:.1}", each(counts, &[stage])));
    }
    text += &row("the picture without the spotlight", &|counts| format!("{:.1}", each(counts, &WITHOUT)));
    text += &row("the picture with the spotlight", &|counts| format!("{:.1}", each(counts, &WITH)));
    text +=
        &row("so the spotlight", &|counts| format!("{:.1}", each(counts, &WITH) - each(counts, &WITHOUT)));
    text + &row("KiB of flash, the whole program", &|counts| counts.kibibytes.to_string())
}
