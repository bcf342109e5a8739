//! The page `docs/EFFECTS.md`.

use anyhow::{Context, Result};

use super::catalogue::{Entry, GROUPS, Group, UNPRICED};
use super::prices::STANDS;
use super::record::{Price, Prices, Record};
use crate::firmware::Board;

const INTRODUCTION: &str = "\
# What effects cost

`cargo xtask effects` counts, and writes this page and [effects.json](effects.json), the same figures by program;
`cargo xtask effects --check` compares. A scene pays for the effects that it calls for and for no others: the renderer skips a
light only where its contribution is exactly zero, and what a firmware does not name is not linked. The names are those of
[`luminaire::Effect`](../core/src/effect.rs).

**Instructions** are those of an average pixel, counted under QEMU over 256 inputs, less an empty loop that loads a word of
the same inputs and folds it into the same checksum. The points are in the cone and face the light, none of them in the
dark, so that nothing is skipped: an upper bound for a pixel that lights fall on. Fields and functions are inlined in
the loop; lights and materials are constants of the program, as a firmware has them. Folding three channels into the
checksum takes two instructions, which are counted with the effect. The results must be the host's, bit for bit.

**Bytes** are of flash, over an empty program, compiled for size, as [firmware/README.md](../firmware/README.md#bytes-of-flash-and-no-panic)
describes. Effects share the root and its tables, so that the bytes of two do not add up.

In brackets is what the effect **adds**: the difference from the program that lacks it and nothing else, which each group
names. This is what a scene pays for it. Each program is
compiled by itself, so that a difference may be less than nothing by a little.

Instructions are exact and the same in every run. They are not cycles, and nothing here says how long a pixel takes.
";

/// Writes the page.
pub(super) fn write(record: &Record) -> Result<String> {
    let mut text = INTRODUCTION.to_owned();
    for stand in &STANDS {
        let prices = board(record, stand.board)?;
        let Prices { format, compiler, runs_on, .. } = prices;
        text += &format!("\n- {}: `{format}`, {compiler}, {runs_on}", title(stand.board)?);
    }
    text += "\n";
    for group in &GROUPS {
        text += &section(record, group)?;
    }
    text += "\n## Without a price of their own\n\n";
    for (effect, reason) in &UNPRICED {
        text += &format!("- `{}` {reason}.\n", effect.name());
    }
    Ok(text)
}

fn section(record: &Record, group: &Group) -> Result<String> {
    let boards = STANDS.iter().map(|stand| title(stand.board)).collect::<Result<Vec<_>>>()?;
    let head = |unit: &str| boards.iter().map(|board| format!(" {board}, {unit} |")).collect::<String>();
    let mut text = format!(
        "\n## {}\n\n{}\n\n| effect | what it is |{}{}\n|---|---|{}\n",
        group.title,
        group.note,
        head("instr."),
        head("bytes"),
        "---:|".repeat(2 * boards.len())
    );
    for entry in group.entries {
        text += &row(record, entry)?;
    }
    Ok(text)
}

fn row(record: &Record, entry: &Entry) -> Result<String> {
    let mut instructions = String::new();
    let mut bytes = String::new();
    for stand in &STANDS {
        let prices = board(record, stand.board)?;
        let price = price(prices, entry.program)?;
        let over = entry.over.map(|over| self::price(prices, over)).transpose()?;
        let more = |figure: fn(&Price) -> f64| over.map(|over| figure(price) - figure(over));
        let adds = more(|price| price.instructions);
        instructions += &cell(&format!("{:.1}", price.instructions), adds.map(|adds| format!("{adds:+.1}")));
        let adds = more(|price| price.bytes as f64);
        bytes += &cell(&price.bytes.to_string(), adds.map(|adds| format!("{adds:+}")));
    }
    Ok(format!("| {} | {} |{instructions}{bytes}\n", entry.title, entry.what))
}

fn cell(figure: &str, adds: Option<String>) -> String {
    adds.map_or_else(|| format!(" {figure} |"), |adds| format!(" {figure} ({adds}) |"))
}

fn board<'a>(record: &'a Record, name: &str) -> Result<&'a Prices> {
    record.boards.get(name).with_context(|| format!("{name} is not recorded"))
}

fn price<'a>(prices: &'a Prices, program: &str) -> Result<&'a Price> {
    prices.prices.get(program).with_context(|| format!("{program} is not recorded"))
}

fn title(board: &str) -> Result<&'static str> {
    Ok(Board::named(board).map_err(anyhow::Error::msg)?.title)
}

#[cfg(test)]
mod tests {
    use super::super::catalogue::entries;
    use super::*;

    /// On both boards a hundred instructions more and ten bytes less for each program than for the one before.
    fn record() -> Record {
        let mut record = Record::default();
        for stand in &STANDS {
            let prices = record.boards.entry(stand.board.to_owned()).or_default();
            for (number, entry) in entries().enumerate() {
                let price = Price { instructions: 100.0 * number as f64, bytes: 1000 - 10 * number as u64 };
                prices.prices.entry(entry.program.to_owned()).or_insert(price);
            }
        }
        record
    }

    #[test]
    fn a_row_has_the_figures_and_what_is_added() {
        let text = write(&record()).unwrap();
        let line = |start: &str| text.lines().find(|line| line.starts_with(start)).unwrap_or_default();
        let hard = line("| hard |");
        assert!(hard.ends_with("| 500.0 (+500.0) | 500.0 (+500.0) | 950 (-50) | 950 (-50) |"), "{hard}");
        assert!(line("| matt |").ends_with("0 | 770 | 770 |"), "{}", line("| matt |"));
    }

    #[test]
    fn a_figure_that_is_missing_is_named() {
        let mut record = record();
        record.boards.get_mut("cortex-m4f").unwrap().prices.remove("phong");
        assert!(write(&record).unwrap_err().to_string().contains("phong"));
        record.boards.remove("cortex-m4f");
        assert!(write(&record).unwrap_err().to_string().contains("cortex-m4f"));
    }
}
