//! Stage fixtures with their published data.

use std::{fmt, sync::LazyLock};
use wasm_bindgen::prelude::*;

/// The table, as `fixtures/data/README.md` describes it.
const TABLE: &str = include_str!("../../fixtures/data/fixtures.csv");

const HEADER: &str =
    "kind,manufacturer,fixture,mode,lens,categories,lens_full_angle_min_deg,lens_full_angle_max_deg,lumens";

static FIXTURES: LazyLock<Vec<Fixture>> = LazyLock::new(|| {
    // A table that does not parse counts as empty; a test below ensures that the shipped table
    // parses.
    parse(TABLE).unwrap_or_default()
});

/// A stage fixture with one of its lenses.
///
/// Its angle is the published lens angle. It is a full angle, but whether beam or field angle is
/// not published.
#[wasm_bindgen]
#[derive(Clone, PartialEq, Debug)]
pub struct Fixture {
    name: String,
    kind: String,
    categories: String,
    narrow: f32,
    wide: f32,
    lumens: Option<f32>,
}

#[wasm_bindgen]
impl Fixture {
    /// Maker and fixture, and the lens or mode if the fixture has several. The name is unique in
    /// the table.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        self.name.clone()
    }

    /// The kind of fixture in one word, by this project's own grouping.
    #[wasm_bindgen(getter)]
    pub fn kind(&self) -> String {
        self.kind.clone()
    }

    /// The Open Fixture Library's categories.
    #[wasm_bindgen(getter)]
    pub fn categories(&self) -> String {
        self.categories.clone()
    }

    /// The smallest published full angle, in degrees.
    #[wasm_bindgen(getter)]
    pub fn narrow(&self) -> f32 {
        self.narrow
    }

    /// The largest published full angle, in degrees.
    #[wasm_bindgen(getter)]
    pub fn wide(&self) -> f32 {
        self.wide
    }

    /// Luminous flux in lumens, if known.
    #[wasm_bindgen(getter)]
    pub fn lumens(&self) -> Option<f32> {
        self.lumens
    }
}

impl Fixture {
    /// Returns the initial angle of a fixture: the middle of its zoom range.
    pub(crate) fn middle(&self) -> f32 {
        self.narrow.midpoint(self.wide)
    }
}

/// All fixtures, in the order of the table.
pub(crate) fn all() -> &'static [Fixture] {
    &FIXTURES
}

/// The fixture of this name.
pub(crate) fn find(name: &str) -> Option<&'static Fixture> {
    FIXTURES.iter().find(|fixture| fixture.name == name)
}

/// A line of the table that can't be parsed.
#[derive(Clone, PartialEq, Eq, Debug)]
struct BadLine {
    line: usize,
    problem: &'static str,
}

impl fmt::Display for BadLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {} of the fixture table: {}", self.line, self.problem)
    }
}

/// Parses the table. No name contains a comma, so no cell needs quotes, and a quote is an error.
fn parse(table: &str) -> Result<Vec<Fixture>, BadLine> {
    let mut lines = table.lines();
    if lines.next() != Some(HEADER) {
        return Err(BadLine { line: 1, problem: "these are not the columns" });
    }
    lines
        .enumerate()
        .map(|(i, row)| parse_row(row).map_err(|problem| BadLine { line: i + 2, problem }))
        .collect()
}

fn parse_row(row: &str) -> Result<Fixture, &'static str> {
    if row.contains('"') {
        return Err("quotes are not read");
    }
    let cells: Vec<&str> = row.split(',').collect();
    let [kind, maker, fixture, mode, lens, categories, narrow, wide, lumens] = cells[..] else {
        return Err("there must be 9 cells");
    };
    let detail = match (lens, mode) {
        ("" | "Other", "") => String::new(),
        ("", mode) => format!(", {mode}"),
        (lens, _) => format!(", {lens}"),
    };
    let (narrow, wide) = (number(narrow)?, number(wide)?);
    if narrow > wide {
        return Err("the smallest angle is over the largest");
    }
    Ok(Fixture {
        name: format!("{maker} {fixture}{detail}"),
        kind: kind.to_owned(),
        categories: categories.to_owned(),
        narrow,
        wide,
        lumens: if lumens.is_empty() { None } else { Some(number(lumens)?) },
    })
}

fn number(cell: &str) -> Result<f32, &'static str> {
    match cell.parse() {
        Ok(value) if f32::is_finite(value) && value >= 0.0 => Ok(value),
        _ => Err("an angle or a flux is not a number from 0 upwards"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn every_row_is_read() {
        let rows = TABLE.lines().count() - 1;
        assert_eq!(parse(TABLE).map(|fixtures| fixtures.len()), Ok(rows));
        assert_eq!(all().len(), rows);
    }

    #[test]
    fn every_name_is_found_and_finds_itself() {
        let names: HashSet<_> = all().iter().map(Fixture::name).collect();
        assert_eq!(names.len(), all().len(), "two fixtures have one name");
        for fixture in all() {
            assert_eq!(find(&fixture.name), Some(fixture));
        }
        assert_eq!(find("Nobody's lamp"), None);
    }

    #[test]
    fn every_angle_is_an_opening() {
        for fixture in all() {
            assert!((0.0..=180.0).contains(&fixture.narrow), "{}", fixture.name);
            assert!((fixture.narrow..=180.0).contains(&fixture.wide), "{}", fixture.name);
            assert!(fixture.middle() > 0.0, "{}", fixture.name);
            assert!(fixture.lumens.is_none_or(|lumens| lumens > 0.0), "{}", fixture.name);
        }
    }

    #[test]
    fn the_table_spans_the_field() {
        let kinds: HashSet<_> = all().iter().map(Fixture::kind).collect();
        for kind in ["beam", "profile", "fresnel", "par", "spot", "wash", "flood"] {
            assert!(kinds.contains(kind), "no {kind}");
        }
        assert!(all().iter().any(|fixture| fixture.wide <= 1.0), "no needle");
        assert!(all().iter().any(|fixture| fixture.narrow >= 120.0), "no flood");
        assert!(all().iter().any(|fixture| fixture.narrow < fixture.wide), "no zoom");
    }

    #[test]
    fn what_cannot_be_read_is_named() {
        let problem = |row: &str| parse(&format!("{HEADER}\n{row}\n")).unwrap_err();
        for (row, word) in [
            ("wash,Maker,Lamp,,,Dimmer,10,20", "cells"),
            ("wash,\"Maker\",Lamp,,,Dimmer,10,20,", "quotes"),
            ("wash,Maker,Lamp,,,Dimmer,wide,20,", "number"),
            ("wash,Maker,Lamp,,,Dimmer,-1,20,", "number"),
            ("wash,Maker,Lamp,,,Dimmer,10,NaN,", "number"),
            ("wash,Maker,Lamp,,,Dimmer,30,20,", "smallest"),
        ] {
            let message = problem(row).to_string();
            assert!(message.contains("line 2") && message.contains(word), "{row}: {message}");
        }
        assert!(parse("name,angle\n").is_err());
    }
}
