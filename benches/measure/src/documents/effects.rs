//! The page `docs/EFFECTS.md`.

use anyhow::{Context, Result};
use luminaire::dynamic::Effect;
use luminaire_effects::Entry;
use tools::turntable::LOADS;

use super::text::{cells, table};
use crate::drawn::{DRAWN, PREFIX};
use crate::effects::{SUITED, catalogue, figure, has_price};
use crate::record::{Group, Record};
use crate::target::{BOARDS, Board};

const INTRODUCTION: &str = "\
# What effects cost

A scene pays only for the effects that it needs: the renderer skips a light only where its contribution is
exactly zero, and an effect that a firmware does not name is not linked. The effects are those of
[`luminaire::dynamic::Effect`](../core/src/effect.rs), and what every picture has besides.

**Instructions** are those of an average pixel, counted under QEMU over 256 inputs as
[benches/firmware/README.md](../benches/firmware/README.md#what-is-counted) describes. All surface points face the
light and lie inside the cone, so no early-out is taken: the mean of a lit point, not the [worst case](PRICES.md#worst-case-of-a-call). Colours are spread evenly;
the light that is exposed and fitted is that of such points, some of it over full scale. Lights and materials are
constants of the program; one that is made at run time is loaded from memory as well. Folding three channels
takes two instructions, which count. Instructions are exact, and not cycles: **cycles** are those of an RP2040.

**Flash** is what a program takes more than an empty one, compiled for size, constant tables included. Effects share
the root and its tables, so the bytes of two effects do not add up. **Instructions for size** are those of a program
that is compiled for size, too (`opt-level = \"s\"`).

What an effect **adds** is in brackets: the difference to the program that lacks only this effect. Each program is
compiled by itself, so a difference can be slightly negative.

`cargo xtask measure` writes this page of the [record](prices.json).
";

/// Writes the page.
pub(super) fn page(record: &Record) -> Result<String> {
    let mut text = INTRODUCTION.to_owned();
    for chapter in catalogue() {
        let heads = cells([
            "effect",
            "what it is",
            "Cortex-M0 in `fx16`, instr.",
            "Cortex-M4F in `f32`, instr.",
            "RP2040, cycles",
            "Cortex-M0, instr. for size",
            "Cortex-M4F, instr. for size",
            "Cortex-M0, flash",
            "Cortex-M4F, flash",
        ]);
        let rows = chapter.entries.iter().map(|entry| row(record, entry)).collect::<Result<Vec<_>>>()?;
        text += &format!("\n## {}\n\n{}\n\n{}", chapter.title, chapter.note, table(&heads, rows));
    }
    text += &drawn(record);
    Ok(text + &frames(&record.group("demo")))
}

fn row(record: &Record, entry: &Entry) -> Result<Vec<String>> {
    let mut row = vec![entry.title.to_owned(), entry.what.trim().to_owned()];
    for (unit, decimals, is_compared, boards) in [
        ("instructions", 1, true, &SUITED[..]),
        ("cycles", 1, false, &SUITED[..1]),
        ("instructions_for_size", 1, false, &SUITED),
        ("flash", 0, true, &SUITED),
    ] {
        for (board, format) in boards {
            let group = record.group(board);
            // An effect that is not measured yet has empty cells.
            let is_counted = group.figures.contains_key(&figure(entry.name, format.name));
            if !has_price(entry, *format) || !is_counted {
                row.push(String::new());
                continue;
            }
            let number = |program: &str| {
                let name = figure(program, format.name);
                group.number(&name, unit).with_context(|| format!("{board} has no {unit} of {name}"))
            };
            let value = number(entry.name)?;
            let mut cell = format!("{value:.decimals$}");
            for over in entry.over.iter().filter(|_| is_compared) {
                cell += &format!(" ({:+.decimals$})", value - number(over)?);
            }
            row.push(cell);
        }
    }
    Ok(row)
}

/// The table of what a point of each row call costs.
fn drawn(record: &Record) -> String {
    let mut heads = cells(["row call", "what it is"]);
    heads.extend(BOARDS.iter().map(|board| board.title.to_owned()));
    heads.insert(3, "RP2040, cycles".to_owned());
    let rows = DRAWN.iter().map(|(name, title, what)| {
        let mut row = cells([title, what]);
        let figure = |board: &Board, unit: &str| {
            let figure = record.group(board.name).number(&format!("{PREFIX}{name}"), unit);
            figure.map_or_else(String::new, |figure| format!("{figure:.1}"))
        };
        row.extend(BOARDS.iter().map(|board| figure(board, "instructions")));
        row.insert(3, figure(&BOARDS[0], "cycles"));
        row
    });
    let note = "Instructions of one pixel, point or LED, with the loop around it, in `fx16` by the quick evaluation; \
                pixels are dithered RGB565. The program is [`drawn`](../benches/firmware/src/drawn.rs).";
    format!("\n## Rows, drawables and LEDs\n\n{note}\n\n{}", table(&heads, rows))
}

/// The table of what each effect adds to a frame, in the order of the library.
fn frames(demo: &Group) -> String {
    let time = |name: &str, unit| demo.number(name, unit).unwrap_or(f64::NAN);
    let effects =
        Effect::ALL.iter().map(|effect| effect.name()).filter(|name| demo.figures.contains_key(*name));
    let effects = effects.map(|name| {
        let [with, without] = ["ms_with", "ms_without"].map(|unit| time(name, unit));
        let scene = format!("`{}`", demo.text(name, "scene").unwrap_or_default());
        let times = [with, without].map(|time| format!("{time:.1}"));
        [vec![name.to_owned(), scene], times.into(), vec![format!("{:+.1}", with - without)]].concat()
    });
    let loads = LOADS.iter().map(|load| {
        let times = ["ms_at_rest", "ms_moving"].map(|unit| format!("{:.1}", time(load.name, unit)));
        [vec![load.name.to_owned()], times.into()].concat()
    });
    format!(
        "\n## In a browser\n\nMilliseconds a frame of 960 x 540 in `f32` while all lights move and the camera is at rest, in \
         {}: the median of 15 frames, in the quickest of three rounds. They depend on the machine and its other work, and \
         nothing fails because of them.\n\n{}\nWhole frames of `turntable`, whose spotlights all move and whose \
         surfaces all shine:\n\n{}",
        demo.about.get("runs_on").map_or("", String::as_str),
        table(&cells(["effect", "scene", "with", "without", "adds"]), effects),
        table(&cells(["load", "camera at rest", "camera moving"]), loads)
    )
}
