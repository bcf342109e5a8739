//! The formulas of other tools, against what the tools draw and what their sources state.

mod formulas;

use formulas::{FORMULAS, Formula, Kind};

fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| panic!("{text}: expected a number"))
}

fn kind(name: &str) -> Kind {
    match name {
        "spot" => Kind::Spot,
        "point" => Kind::Point,
        "directional" => Kind::Directional,
        _ => panic!("{name}: expected a kind"),
    }
}

fn formula(tool: &str) -> Formula {
    FORMULAS.iter().find(|formula| formula.0 == tool).expect(tool).1
}

/// Returns the values of `name=value`.
fn values<'a>(words: impl Iterator<Item = &'a str>) -> Vec<(&'a str, f64)> {
    words.map(|word| word.split_once('=').expect(word)).map(|(name, value)| (name, number(value))).collect()
}

/// Every row of the table. Drawn rows differ by the errors of f32, by the place of the pixel, and by the
/// steps of the picture.
#[test]
fn formulas_are_those_of_the_tools() {
    let rows = include_str!("formulas/known.txt").lines().filter(|row| !row.starts_with('#'));
    let mut seen = Vec::new();
    for row in rows {
        let mut words = row.split(' ');
        let mut word = || words.next().expect("tool, kind, angle, distance, irradiance, difference");
        let (tool, light) = (word(), kind(word()));
        let [angle, distance, expected, relative] = [word(), word(), word(), word()].map(number);
        let found = formula(tool)(&values(words), light, angle, distance);
        assert!((found - expected).abs() <= relative * expected, "{row}: found {found}");
        seen.push(tool);
    }
    assert!(FORMULAS.iter().all(|(tool, _)| seen.contains(tool)), "{seen:?}: expected every tool");
}
