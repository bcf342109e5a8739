//! The parts of other documents with figures: the README's prices, and the picture that firmware draws.

use super::text::{cells, cost, error, table};
use crate::c;
use crate::plot;
use crate::record::Record;
use crate::target::{BOARDS, Board, ESP8266, Target};

/// The rows of the README, and their titles.
const ROWS: [(&str, &str); 7] = [
    ("lit-inverse-square.fx16", "`Fx16`"),
    ("lit-inverse-square.fx16-quick", "`Fx16`, quick"),
    ("lit-inverse-square.f32", "`f32`"),
    ("lit-q15-difference.rival", "15 bits by hand"),
    ("lit-q16-libfixmath.rival", "Q16.16, libfixmath"),
    ("lit-f32-difference.rival", "`f32` by hand"),
    ("lit-baked.rival", "baked on a floor"),
];

/// The part of the README: errors in a wide and a narrow cone, and costs.
pub(super) fn readme(record: &Record) -> String {
    let targets =
        ["cortex-m0", "cortex-m4f", "cortex-m33", "rv32imc", "host"].map(Target::named).into_iter().flatten();
    let targets: Vec<_> = targets.collect();
    let mut heads = cells(["", "error at 22°", "at 1°"]);
    heads.extend(targets.iter().map(|target| match target {
        Target::Board(board) => format!("{}, instr.", board.title),
        _ => "host, ns".to_owned(),
    }));
    let rows = ROWS.map(|(name, title)| {
        let error_in =
            |group: &str| record.group(group).number(name, "codes").map_or("refused".to_owned(), error);
        let mut row = vec![title.to_owned(), error_in("errors"), error_in("errors at 1")];
        let price = |target: &Target| record.group(target.name()).number(name, target.unit());
        row.extend(targets.iter().map(|target| price(target).map_or_else(String::new, cost)));
        row
    });
    let (picture, smallest) = (plot::FILE, record.group("cortex-m0"));
    let bytes = |name, unit| smallest.number(name, unit).unwrap_or_default();
    table(&heads, rows)
        + &format!(
            "\nOn a Cortex-M0 a light that moves takes {} bytes of RAM, and a lit point {} of stack, in C at most {}: \
             [all](docs/PRICES.md#stack-and-ram).\n\
             \n![Error against instructions on a Cortex-M0, both logarithmic]({picture})\n",
            bytes("spotlight.fx16", "ram"),
            bytes("lit-inverse-square.fx16", "stack"),
            bytes("c.luminaire_spot_irradiance", "stack"),
        )
}

/// The part of the page of C: the instructions of each call, and the bytes of a whole program.
pub(super) fn calls(record: &Record) -> String {
    let is_counted = |board: &&Board| record.group(board.name).figures.contains_key(&c::figure("light"));
    let columns = BOARDS
        .iter()
        .chain([&ESP8266])
        .filter(is_counted)
        .flat_map(|board| c::LEVELS.map(|level| (board, level)));
    let columns: Vec<_> = columns.collect();
    let figure = |board: &Board, name: &str, unit: &str| {
        record
            .group(board.name)
            .number(&c::figure(name), unit)
            .map_or_else(String::new, |figure| format!("{figure:.0}"))
    };
    let heads = columns.iter().map(|(board, (level, _))| format!("{}, `{level}`", board.title));
    let heads: Vec<_> = cells(["instructions"]).into_iter().chain(heads).collect();
    let call = |(name, title): &(&str, &str)| {
        let figures = columns.iter().map(|(board, (_, unit))| figure(board, name, unit));
        [(*title).to_owned()].into_iter().chain(figures).collect::<Vec<_>>()
    };
    let mut rows: Vec<_> = c::CALLS_COUNTED.iter().map(call).collect();
    let bytes = columns.iter().map(|(board, (level, _))| match *level {
        "-Os" => figure(board, "moving", "bytes"),
        _ => String::new(),
    });
    rows.push(
        cells(["bytes of two coloured lights that move, to RGB565"]).into_iter().chain(bytes).collect(),
    );
    table(&heads, rows)
}

/// The stages of the picture, and their titles.
const STAGES: [(&str, &str); 4] = [
    ("geometry", "geometry: what the pixel sees, point and normal"),
    ("light", "light: falloff, Lambert's cosine, inverse square"),
    ("shadow", "shadow: is the ball or the column in the way"),
    ("display", "display: the dithered pixel of the material in its light"),
];

/// Instructions and cycles of a pixel, by stage and board.
pub(super) fn frame(record: &Record) -> String {
    let picture = record.group("picture");
    let pixels = |name: &str| picture.number(name, "pixels").unwrap_or_default();
    let count = pixels("width") * pixels("height");
    let mut columns = Vec::new();
    for board in &BOARDS {
        columns.push((board.title, board.name, "instructions"));
        if record.group(board.name).number("frame.light", "cycles").is_some() {
            columns.push(("cycles of an RP2040", board.name, "cycles"));
        }
    }
    let row = |title: &str, stages: &[&str]| {
        let sum = |(_, board, unit): &(&str, &str, &str)| {
            let group = record.group(board);
            let figures = stages.iter().filter_map(|stage| group.number(&format!("frame.{stage}"), unit));
            format!("{:.1}", figures.sum::<f64>() / count)
        };
        [title.to_owned()].into_iter().chain(columns.iter().map(sum)).collect::<Vec<_>>()
    };
    let mut rows: Vec<_> = STAGES.iter().map(|(stage, title)| row(title, &[*stage])).collect();
    rows.push(row("the picture", &STAGES.map(|(stage, _)| stage)));
    let flash = columns.iter().map(|(_, board, unit)| match *unit {
        "cycles" => String::new(),
        _ => {
            record.group(board).number("frame", "kibibytes").map_or_else(String::new, |size| size.to_string())
        }
    });
    rows.push(["KiB of flash, the whole program".to_owned()].into_iter().chain(flash).collect());
    let heads =
        ["instructions a pixel, on average"].into_iter().chain(columns.iter().map(|(title, ..)| *title));
    let heads: Vec<_> = heads.map(str::to_owned).collect();
    table(&heads, rows)
        + &format!(
            "\nOf {count} pixels: {} facing away, {} outside the cone, {} in shadow, {} lit.\n",
            pixels("facing-away"),
            pixels("outside"),
            pixels("in-shadow"),
            pixels("lit")
        )
}
