//! The table of the picture, as the command prints it and as `benches/firmware/README.md` has it.

use std::collections::BTreeMap;

use super::list::StageList;
use crate::boards::board;

/// The lines of the README between which the table stands.
pub(super) const LINES: [&str; 2] =
    ["<!-- frame: written by `cargo xtask frame --bless` -->\n", "<!-- end of frame -->\n"];

/// The names of the stages, and their titles in the README.
const TITLES: [(&str, &str); 5] = [
    ("geometry", "geometry: what the pixel sees, point and normal"),
    ("ambient", "pixels of ambient light alone, from a table"),
    ("light", "light: falloff, Lambert's cosine, inverse square"),
    ("shadow", "shadow: is the ball or the column in the way"),
    ("display", "display: the dithered pixel of the material in its light, where the light arrives"),
];
/// The stages of the whole picture, and of the picture without the light.
const WITH: [&str; 5] = ["geometry", "ambient", "light", "shadow", "display"];
const WITHOUT: [&str; 2] = ["geometry", "ambient"];

/// The part of the README.
pub(super) fn write(list: &StageList) -> String {
    format!("\n{}\nOf {} pixels: {}.\n\n", table(list), list.pixels, list.light)
}

/// A column of the table: the head, the figures of the stages, and the size of the program.
type Column<'a> = (String, &'a BTreeMap<String, u64>, String);

/// A row for each stage, a column for each board, and one for cycles.
pub(super) fn table(list: &StageList) -> String {
    let mut columns: Vec<Column<'_>> = Vec::new();
    for board in &board::ALL {
        let Some(counts) = list.boards.get(board.name) else { continue };
        columns.push((board.title.to_owned(), &counts.instructions, counts.kibibytes.to_string()));
        if !counts.cycles.is_empty() {
            columns.push(("cycles of an RP2040".to_owned(), &counts.cycles, String::new()));
        }
    }
    let row = |title: &str, cell: &dyn Fn(&Column<'_>) -> String| {
        let cells: String = columns.iter().map(|column| format!(" {} |", cell(column))).collect();
        format!("| {title} |{cells}\n")
    };
    let each = |(_, figures, _): &Column<'_>, stages: &[&str]| {
        let sum: u64 = stages.iter().filter_map(|stage| figures.get(*stage)).sum();
        sum as f64 / list.pixels as f64
    };
    let mut text = row("instructions a pixel, on average", &|(head, _, _)| head.clone());
    text += &format!("|---|{}\n", "---|".repeat(columns.len()));
    for (stage, title) in TITLES {
        text += &row(title, &|column| format!("{:.1}", each(column, &[stage])));
    }
    text += &row("the picture without the spotlight", &|column| format!("{:.1}", each(column, &WITHOUT)));
    text += &row("the picture with the spotlight", &|column| format!("{:.1}", each(column, &WITH)));
    text +=
        &row("so the spotlight", &|column| format!("{:.1}", each(column, &WITH) - each(column, &WITHOUT)));
    text + &row("KiB of flash, the whole program", &|(_, _, size)| size.clone())
}
