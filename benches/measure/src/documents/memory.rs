//! Stack and RAM of calls.

use luminaire_effects::Entry;

use super::text::{cells, table};
use crate::c;
use crate::effects::{Format, SUITED, catalogue, figure};
use crate::record::Record;
use crate::target::BOARDS;

const ABOUT: &str = "
## Stack and RAM

Nothing allocates. **In C** a call takes at most these bytes of stack, its return address included: a bound, the longest
way through the calls of gcc's own account (`-fcallgraph-info=su`) at the worst of `-O3`, `-O2` and `-Os`, if the compiler
inlines it into nothing. A type takes these bytes of RAM.

";

const RUST: &str = "
**In Rust** an effect takes these bytes of stack, the most over 256 inputs, measured on a painted stack with the call
compiled for speed (`opt-level = 3`) in a function of its own. A constant light takes no RAM; one that is made at run time takes
the bytes of its type.

";

/// The tables of bytes.
pub(super) fn section(record: &Record) -> String {
    let boards: Vec<_> = BOARDS.iter().filter(|board| of_c(record, board.name).next().is_some()).collect();
    let cell = |board: &str, name: &str, unit| {
        record.group(board).number(name, unit).map_or_else(String::new, |bytes| bytes.to_string())
    };
    let mut heads = cells(["bytes in C"]);
    heads.extend(boards.iter().map(|board| board.title.to_owned()));
    let rows = of_c(record, "cortex-m0").map(|(name, unit)| {
        let what = if unit == "ram" { "RAM" } else { "stack" };
        let own = format!("{what}, `{}`", name.trim_start_matches("c."));
        let figures = boards.iter().map(|board| cell(board.name, &name, unit));
        [own].into_iter().chain(figures).collect::<Vec<_>>()
    });
    let text = ABOUT.to_owned() + &table(&heads, rows) + RUST;
    let types = TYPES.map(|(name, title)| {
        let bytes = SUITED.map(|(board, format)| cell(board, &figure(name, format.name), "ram"));
        [vec![format!("RAM, {title}")], bytes.into()].concat()
    });
    let mut stacks = self::rows(record, &["stack"]);
    stacks.iter_mut().for_each(|row| row[0].insert_str(0, "stack, "));
    let heads = [cells(["bytes in Rust"]), self::heads(&[""])].concat();
    text + &table(&heads, types.into_iter().chain(stacks))
}

/// The heads of columns of effects: boards with the format that suits each, and words.
pub(super) fn heads(words: &[&str]) -> Vec<String> {
    let head = |(board, format): &(&str, Format), word: &&str| {
        let title = BOARDS.iter().find(|of| of.name == *board).map_or(*board, |board| board.title);
        let separator = if word.is_empty() { "" } else { ", " };
        format!("{title}, `{}`{separator}{word}", format.name)
    };
    SUITED.iter().flat_map(|suited| words.iter().map(move |word| head(suited, word))).collect()
}

/// The rows of the effects that the last of these units is on record of: their titles, and their figures.
pub(super) fn rows(record: &Record, units: &[&str]) -> Vec<Vec<String>> {
    let groups = SUITED.map(|(board, format)| (record.group(board), format));
    let chapters = catalogue();
    let entries = chapters.iter().flat_map(|chapter| &chapter.entries);
    let row = |entry: &Entry| {
        let figures = groups.iter().flat_map(|(group, format)| {
            let name = figure(entry.name, format.name);
            let cell =
                move |unit: &&str| group.number(&name, unit).map_or_else(String::new, |n| format!("{n:.0}"));
            units.iter().map(cell)
        });
        [entry.title.to_owned()].into_iter().chain(figures).collect()
    };
    let is_on_record = |entry: &&Entry| {
        let last = units.last().copied().unwrap_or_default();
        groups.iter().any(|(group, format)| group.number(&figure(entry.name, format.name), last).is_some())
    };
    entries.filter(is_on_record).map(row).collect()
}

/// The bytes on record of C on a board: names and units, types first.
fn of_c(record: &Record, board: &str) -> impl Iterator<Item = (String, &'static str)> {
    let figures = record.group(board).figures;
    ["ram", "stack"].into_iter().flat_map(move |unit| {
        let of_unit = figures
            .iter()
            .filter(|(name, units)| name.starts_with(&c::figure("")) && units.contains_key(unit));
        of_unit.map(|(name, _)| (name.clone(), unit)).collect::<Vec<_>>()
    })
}

/// The types, by their name on record.
const TYPES: [(&str, &str); 8] = [
    ("spotlight", "a soft spotlight with the inverse square"),
    ("spotlight-no-attenuation", "a soft spotlight without attenuation"),
    ("point-light", "a point light"),
    ("directional-light", "a directional light"),
    ("any-light", "a light of any kind, chosen at run time"),
    ("surface-point", "a point, its normal and the direction to the eye"),
    ("ramp-rgb565", "a material's table of dithered RGB565"),
    ("led-dither", "the carries of an LED"),
];
