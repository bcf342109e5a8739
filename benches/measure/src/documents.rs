//! The documents that show the figures on record.

mod effects;
mod picker;
mod prices;
mod summary;

use std::fs;

use anyhow::{Context, Result};
use tools::project;

use crate::plot;
use crate::record::Record;

/// Every document, as its path below the project's folder and its content.
pub(crate) fn of(record: &Record) -> Result<Vec<(String, String)>> {
    let documents = [
        ("docs/ACCURACY-VS-COST.md", prices::answer(record)),
        ("docs/PRICES.md", prices::list(record)),
        ("docs/EFFECTS.md", effects::page(record)?),
        (plot::FILE, plot::draw(record)),
        ("cli/pick/prices.json", picker::prices(record)?),
        ("README.md", inserted("README.md", "prices", &summary::readme(record))?),
        (FIRMWARE, inserted(FIRMWARE, "frame", &summary::frame(record))?),
    ];
    Ok(documents.map(|(file, content)| (file.to_owned(), content)).into())
}

const FIRMWARE: &str = "benches/firmware/README.md";

/// A document with the part between two lines replaced.
fn inserted(file: &str, name: &str, part: &str) -> Result<String> {
    let text = fs::read_to_string(project::root().join(file)).context(file.to_owned())?;
    let (begin, end) =
        (format!("<!-- {name}: written by `cargo xtask measure` -->\n"), format!("<!-- end of {name} -->"));
    let (before, rest) = text.split_once(&begin).with_context(|| format!("{file} has no line {begin}"))?;
    let (_, after) = rest.split_once(&end).with_context(|| format!("{file} has no line {end}"))?;
    Ok(format!("{before}{begin}\n{part}\n{end}{after}"))
}

/// A table in Markdown: heads, and the cells of each row.
fn table(heads: &[String], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rows: String = rows.into_iter().map(|row| line(&row)).collect();
    format!("{}|{}\n{rows}", line(heads), "---|".repeat(heads.len()))
}

/// Owned texts of cells.
fn cells<const N: usize>(texts: [&str; N]) -> Vec<String> {
    texts.map(str::to_owned).into()
}

/// Formats an error with two significant digits, or as an integer from 10 on.
fn error(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if value >= 9.95 => format!("{value:.0}"),
        value if value >= 0.995 => format!("{value:.1}"),
        value if value >= 0.0995 => format!("{value:.2}"),
        value if value >= 0.009_95 => format!("{value:.3}"),
        value => format!("{value:.1e}"),
    }
}

/// Formats a cost with three significant digits, or as an integer from 100 on.
fn cost(value: f64) -> String {
    match value {
        value if value >= 99.95 => format!("{value:.0}"),
        value if value >= 9.995 => format!("{value:.1}"),
        value => format!("{value:.2}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_short() {
        let errors = [0.0, 3.098e-7, 0.0241, 0.155, 0.9275, 1.6, 50.51].map(error);
        assert_eq!(errors, ["0", "3.1e-7", "0.024", "0.15", "0.93", "1.6", "51"]);
        assert_eq!([0.126, 20.066, 132.1, 10260.94].map(cost), ["0.13", "20.1", "132", "10261"]);
    }
}
