//! The page `docs/EFFECTS.md`.

use anyhow::{Context, Result};
use luminaire::dynamic::Effect;

use super::browser::{Browser, Frame, Whole};
use super::catalogue::{Entry, GROUPS, Group};
use super::list::{EffectList, Price, Prices};
use super::prices::STANDS;
use crate::boards::Board;
use browser::turntable::LOADS;

const INTRODUCTION: &str = "\
# What effects cost

`cargo xtask effects` writes this page, and [effects.json](effects.json) with the same figures by
program; `cargo xtask effects --check` counts again and compares. A scene pays only for the effects
that it needs: the renderer skips a light only where its contribution is exactly zero, and an effect
that a firmware does not name is not linked. The effects are those of
[`luminaire::dynamic::Effect`](../core/src/effect.rs), and what every picture has besides.

**Instructions** are those of an average pixel, counted under QEMU over 256 inputs as
[benches/firmware/README.md](../benches/firmware/README.md#what-is-counted) describes. Programs are compiled for
speed; the instructions of an empty loop, which loads a word of the same inputs and folds it into the
same checksum, are subtracted. All surface points face the light and lie inside the cone, so no
early-out is taken: these are worst-case figures. Colours are spread evenly; the light that is exposed
and fitted is that of such points, some of it over full scale. Lights and materials are constants of
the program; one that is made at run time is loaded from memory as well. Folding three channels takes
two instructions, which count. Results must be bit-identical to the host's.

**Bytes** are bytes of flash more than those of an empty program, compiled for size, constant tables
included. Effects share the root and its tables, so the bytes of two effects do not add up.
**Instructions for size** are those of a program that is compiled for size, too (`opt-level = \"s\"`).

What an effect **adds** is in brackets: the difference to the program that lacks only this effect. Each
program is compiled by itself, so a difference can be slightly negative.

Instructions are exact, and the same in every run of the same compiler. They are not cycles.
**Cycles** are those of the same program on the core of an RP2040, a Cortex-M0+, run by rp2040js without
wait states; the instructions are then those that QEMU counts, in every program.
";

/// Writes the page.
pub(super) fn write(list: &EffectList) -> Result<String> {
    let mut text = INTRODUCTION.to_owned();
    for stand in &STANDS {
        let prices = board(list, stand.board)?;
        let Prices { format, compiler, runs_on, .. } = prices;
        text += &format!("\n- {}: `{format}`, {compiler}, {runs_on}", title(stand.board)?);
    }
    text += "\n";
    for group in GROUPS.iter() {
        text += &section(list, group)?;
    }
    if let Some(browser) = &list.browser {
        text += &frames(browser);
    }
    Ok(text)
}

/// The table of what each effect adds to a frame, in the order of the library.
fn frames(browser: &Browser) -> String {
    let mut text = format!(
        "\n## In a browser\n\nMilliseconds a frame of 960 x 540 in `f32` while all lights move and the camera is at rest, in \
         {}: the median of 15 frames, in the quickest of three rounds. They depend on the machine and its other work, and \
         nothing fails because of them. `cargo xtask effects --time` times them again.\n\n\
         | effect | scene | with | without | adds |\n|---|---|---:|---:|---:|\n",
        browser.runs_on
    );
    for effect in Effect::ALL {
        if let Some(Frame { scene, with_ms, without_ms }) = browser.frames.get(effect.name()) {
            let adds = with_ms - without_ms;
            text +=
                &format!("| {} | `{scene}` | {with_ms:.1} | {without_ms:.1} | {adds:+.1} |\n", effect.name());
        }
    }
    text += "\nWhole frames of `turntable`, whose spotlights all move and whose surfaces all shine:\n\n\
             | load | camera at rest | camera moving |\n|---|---:|---:|\n";
    for load in &LOADS {
        if let Some(Whole { at_rest_ms, moving_ms }) = browser.loads.get(load.name) {
            text += &format!("| {} | {at_rest_ms:.1} | {moving_ms:.1} |\n", load.name);
        }
    }
    text
}

fn section(list: &EffectList, group: &Group) -> Result<String> {
    let boards = STANDS.iter().map(|stand| title(stand.board)).collect::<Result<Vec<_>>>()?;
    let head = |unit: &str| boards.iter().map(|board| format!(" {board}, {unit} |")).collect::<String>();
    let mut text = format!(
        "\n## {}\n\n{}\n\n| effect | what it is |{}{}\n|---|---|{}\n",
        group.title,
        group.note,
        head("instr.") + " RP2040, cycles |",
        head("instr. for size") + &head("bytes"),
        "---:|".repeat(3 * boards.len() + 1)
    );
    for entry in &group.entries {
        text += &row(list, entry)?;
    }
    Ok(text)
}

fn row(list: &EffectList, entry: &Entry) -> Result<String> {
    let [mut instructions, mut cycles, mut for_size, mut bytes] = [(); 4].map(|()| String::new());
    for stand in &STANDS {
        let prices = board(list, stand.board)?;
        let price = price(prices, entry.program)?;
        let over = entry.over.map(|over| self::price(prices, over)).transpose()?;
        let more = |figure: fn(&Price) -> f64| over.map(|over| figure(price) - figure(over));
        let adds = more(|price| price.instructions);
        instructions += &cell(&format!("{:.1}", price.instructions), adds.map(|adds| format!("{adds:+.1}")));
        if let Some(counted) = price.cycles {
            cycles += &cell(&format!("{counted:.1}"), None);
        }
        for_size += &cell(&format!("{:.1}", price.instructions_for_size), None);
        let adds = more(|price| price.bytes as f64);
        bytes += &cell(&price.bytes.to_string(), adds.map(|adds| format!("{adds:+}")));
    }
    Ok(format!("| {} | {} |{instructions}{cycles}{for_size}{bytes}\n", entry.title, entry.what))
}

fn cell(figure: &str, adds: Option<String>) -> String {
    adds.map_or_else(|| format!(" {figure} |"), |adds| format!(" {figure} ({adds}) |"))
}

fn board<'a>(list: &'a EffectList, name: &str) -> Result<&'a Prices> {
    list.boards.get(name).with_context(|| format!("{name} is not on record"))
}

fn price<'a>(prices: &'a Prices, program: &str) -> Result<&'a Price> {
    prices.prices.get(program).with_context(|| format!("{program} is not on record"))
}

fn title(board: &str) -> Result<&'static str> {
    Ok(Board::named(board).map_err(anyhow::Error::msg)?.title)
}

#[cfg(test)]
mod tests {
    use super::super::catalogue::entries;
    use super::*;
    use luminaire::dynamic::Effects;

    /// A list in which each program costs 100 instructions and 1000 bytes.
    fn list() -> EffectList {
        let mut list = EffectList::default();
        for stand in &STANDS {
            let prices = list.boards.entry(stand.board.to_owned()).or_default();
            let price =
                Price { instructions: 100.0, instructions_for_size: 110.0, cycles: None, bytes: 1000 };
            prices.prices = entries().map(|entry| (entry.program.to_owned(), price)).collect();
        }
        list
    }

    #[test]
    fn a_row_has_the_figures_and_what_is_added() {
        let mut list = list();
        for prices in list.boards.values_mut() {
            let price =
                Price { instructions: 100.25, instructions_for_size: 130.0, cycles: None, bytes: 500 };
            prices.prices.insert("plain".to_owned(), price);
            let price = Price { instructions: 120.5, bytes: 490, ..price };
            prices.prices.insert("better".to_owned(), price);
        }
        let mut entry = Entry {
            title: "b",
            program: "better",
            listed: None,
            effects: Effects::NONE,
            over: None,
            what: "It.",
        };
        assert_eq!(row(&list, &entry).unwrap(), "| b | It. | 120.5 | 120.5 | 130.0 | 130.0 | 490 | 490 |\n");
        entry.over = Some("plain");
        let adds = "| b | It. | 120.5 (+20.2) | 120.5 (+20.2) | 130.0 | 130.0 | 490 (-10) | 490 (-10) |\n";
        assert_eq!(row(&list, &entry).unwrap(), adds);
    }

    #[test]
    fn a_browser_that_was_timed_has_a_section() {
        let mut list = list();
        assert!(!write(&list).unwrap().contains("browser"));
        let frame = Frame { scene: "show".to_owned(), with_ms: 12.25, without_ms: 10.0 };
        let frames = [("haze".to_owned(), frame)].into();
        let loads = [("8 spots".to_owned(), Whole { at_rest_ms: 10.0, moving_ms: 20.06 })].into();
        list.browser = Some(Browser { runs_on: "Chromium 1".to_owned(), frames, loads });
        let text = write(&list).unwrap();
        assert!(text.contains("| haze | `show` | 12.2 | 10.0 | +2.2 |"));
        assert!(text.contains("| 8 spots | 10.0 | 20.1 |"));
    }

    #[test]
    fn a_figure_that_is_missing_is_named() {
        let mut list = list();
        list.boards.get_mut("cortex-m4f").unwrap().prices.remove("phong");
        assert!(write(&list).unwrap_err().to_string().contains("phong"));
        list.boards.remove("cortex-m4f");
        assert!(write(&list).unwrap_err().to_string().contains("cortex-m4f"));
    }
}
