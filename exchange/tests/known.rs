//! The formulas of other tools, against what the tools draw and what their sources state.

mod formulas;

use formulas::{FORMULAS, Kind};

/// Every row of the table. Drawn rows differ by the errors of f32, by the place of the pixel, and by the
/// steps of the picture.
#[test]
fn formulas_are_those_of_the_tools() {
    let rows = include_str!("formulas/known.txt").lines().filter(|row| !row.starts_with('#'));
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let mut seen = Vec::new();
    for row in rows {
        let mut words = row.split(' ');
        let mut word = || words.next().expect("tool, kind, angle, distance, irradiance, difference");
        let (tool, kind) = (word(), word());
        let [angle, distance, expected, relative] = [word(), word(), word(), word()].map(number);
        let values: Vec<_> = words.map(|word| word.split_once('=').expect("name=value")).collect();
        let values: Vec<_> = values.into_iter().map(|(name, value)| (name, number(value))).collect();
        let kind = match kind {
            "spot" => Kind::Spot,
            "point" => Kind::Point,
            "directional" => Kind::Directional,
            _ => panic!("{row}: expected a kind"),
        };
        let (_, formula) = FORMULAS.iter().find(|formula| formula.0 == tool).expect(tool);
        let found = formula(&values, kind, angle, distance);
        assert!((found - expected).abs() <= relative * expected, "{row}: found {found}");
        seen.push(tool);
    }
    assert!(FORMULAS.iter().all(|(tool, _)| seen.contains(tool)), "{seen:?}: expected every tool");
}
