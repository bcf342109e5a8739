//! Falloffs and attenuations by their names and numbers, as the command line and the JSON have them.

use std::ops::RangeInclusive;

use luminaire::attenuation::{AnyAttenuation, AttenuationRow};
use luminaire::falloff::{AnyFalloff, Falloff, FalloffRow, Formula, Knot, Table};
use luminaire::models::Number;

use crate::error::ExportError;

/// Returns the falloff of a name in the list of models, with its parameters.
///
/// A table of `table` has samples from 65,535 on the axis, evenly spaced over the versine; one of
/// `knots` has three numbers for each knot. Both live as long as the program.
///
/// # Errors
/// A name that is not in the list, or parameters that the falloff does not accept.
pub fn falloff(name: &str, numbers: &[f64]) -> Result<AnyFalloff, ExportError> {
    match name {
        "table" => {
            let sample = |&number: &f64| whole("sample", number, 0..=65_535).map(|whole| whole as u16);
            Ok(Table::new(Vec::leak(numbers.iter().map(sample).collect::<Result<_, _>>()?))?.into())
        }
        KNOTS if numbers.len().is_multiple_of(3) => {
            let knot = |three: &[f64]| {
                let [place, value] =
                    [0, 1].map(|i| whole("knot", three[i], 0..=65_535).map(|whole| whole as u16));
                Ok(Knot::from_bits(place?, value?, three[2] as i32))
            };
            let knots = numbers.chunks(3).map(knot).collect::<Result<_, ExportError>>()?;
            Ok(Table::from_knots(Vec::leak(knots))?.into())
        }
        KNOTS => Err(ExportError::new(name, count_of(numbers.len()), "three numbers for each knot")),
        _ => {
            let row = AnyFalloff::LIST.iter().find(|row| row.name == name).ok_or_else(|| {
                let names: Vec<_> = falloff_names().collect();
                ExportError::new("falloff", name, format!("one of {}", names.join(", ")))
            })?;
            if !counts(row.numbers).contains(&numbers.len()) {
                return Err(ExportError::new(name, count_of(numbers.len()), told(row.numbers)));
            }
            let numbers: Vec<_> = numbers.iter().map(|&number| number as f32).collect();
            Ok(row.of(&numbers)?)
        }
    }
}

/// The name of a table with knots.
const KNOTS: &str = "knots";

fn count_of(count: usize) -> String {
    if count == 1 { "1 number".to_owned() } else { format!("{count} numbers") }
}

/// Returns how many of these numbers may be given: all, or those that may be left out are.
fn counts<'a>(numbers: impl IntoIterator<Item = &'a Number>) -> RangeInclusive<usize> {
    let numbers = numbers.into_iter().map(|number| usize::from(number.default.is_none()));
    let (least, most) = numbers.fold((0, 0), |(least, most), is_required| (least + is_required, most + 1));
    least..=most
}

/// Tells which numbers are expected.
fn told<'a>(numbers: impl IntoIterator<Item = &'a Number>) -> String {
    let told = |number: &Number| {
        let optional = if number.default.is_some() { "optionally " } else { "" };
        format!("{optional}the {}", number.name.replace('_', " "))
    };
    let told: Vec<_> = numbers.into_iter().map(told).collect();
    if told.is_empty() { "no numbers".to_owned() } else { told.join(", ") }
}

/// Returns a model as a word of a command, with the names of its numbers.
fn word<'a>(name: &str, numbers: impl IntoIterator<Item = &'a Number>) -> String {
    let mut word = name.to_owned();
    for (place, number) in numbers.into_iter().enumerate() {
        let before = if place == 0 { "=" } else { "," };
        let name = number.name.to_uppercase().replace('_', "-");
        word +=
            &if number.default.is_some() { format!("[{before}{name}]") } else { format!("{before}{name}") };
    }
    word
}

/// Returns the names of the falloffs that [`falloff`] takes.
pub fn falloff_names() -> impl Iterator<Item = &'static str> {
    AnyFalloff::LIST.iter().map(|row| row.name).chain([KNOTS])
}

/// Returns the falloffs as words of a command, each with the names of its numbers.
pub fn falloff_words() -> String {
    let word = |row: &FalloffRow| {
        let word = word(row.name, row.numbers);
        if row.name == "table" {
            word + "=SAMPLES from 65535 on the axis, evenly spaced over the versine"
        } else {
            word
        }
    };
    AnyFalloff::LIST.iter().map(word).collect::<Vec<_>>().join(", ")
}

/// Returns the name and the parameters by which [`falloff`] makes the same falloff.
pub fn described(falloff: &AnyFalloff) -> (&'static str, Vec<f64>) {
    let row = falloff.row();
    match falloff.formula() {
        Formula::Samples(samples) => (row.name, samples.iter().map(|&sample| sample.into()).collect()),
        Formula::Knots(knots) => {
            let bits = knots.iter().map(|knot| knot.to_bits());
            let numbers = bits.flat_map(|(place, value, slope)| [place.into(), value.into(), slope.into()]);
            (KNOTS, numbers.collect())
        }
        _ => {
            let mut numbers: Vec<f64> = falloff.numbers().map(f64::from).collect();
            while row.numbers[..numbers.len()]
                .last()
                .is_some_and(|last| last.default.map(f64::from) == numbers.last().copied())
            {
                numbers.pop();
            }
            (row.name, numbers)
        }
    }
}

/// Returns a whole number of a range. A cast alone would round and saturate.
fn whole(parameter: &str, number: f64, range: RangeInclusive<u32>) -> Result<u32, ExportError> {
    let value = number as u32;
    if f64::from(value) == number && range.contains(&value) {
        return Ok(value);
    }
    let expected = format!("a whole number from {} to {}", range.start(), range.end());
    Err(ExportError::new(parameter, number, expected))
}

/// The names of laws in data for which people use others.
const NAMES: [(&str, &str); 2] = [("constant", "none"), ("smoothstep", "smooth-range")];

/// Returns the name that people use for a law.
fn usual(law: &'static str) -> &'static str {
    NAMES.iter().find(|(name, _)| *name == law).map_or(law, |(_, own)| own)
}

/// Returns the rows of a law, by either of its names: one for each of its windows.
fn rows(law: &str) -> impl Iterator<Item = &'static AttenuationRow> {
    AnyAttenuation::LIST.iter().filter(move |row| row.law == law || usual(row.law) == law)
}

/// Returns the first row of each law.
fn laws() -> impl Iterator<Item = &'static AttenuationRow> {
    let list = AnyAttenuation::LIST;
    let is_first = |place: usize| list[..place].iter().all(|before| before.law != list[place].law);
    list.iter().enumerate().filter(move |(place, _)| is_first(*place)).map(|(_, row)| row)
}

/// Returns the names of the laws that [`attenuation`] takes: those that people use, and those in data.
pub fn law_names() -> Vec<&'static str> {
    let mut names: Vec<_> = laws().flat_map(|row| [usual(row.law), row.law]).collect();
    names.dedup();
    names
}

/// Returns the laws as words of a command, each with the names of its numbers.
pub fn law_words() -> String {
    laws().map(|row| word(usual(row.law), row.beside_range())).collect::<Vec<_>>().join(", ")
}

/// Returns the numbers of a law without its range; `None` for an unknown law.
pub fn law_numbers(law: &str) -> Option<Vec<&'static Number>> {
    rows(law).next().map(|row| row.beside_range().collect())
}

/// Returns the attenuation of a law with its numbers, and the window by which it ends at a range.
///
/// # Errors
/// A law or a window that is not in the list, a wrong count of numbers, a law without its range, or
/// numbers that the law does not accept.
pub fn attenuation(
    law: &str,
    numbers: &[f32],
    window: &str,
    range: Option<f32>,
) -> Result<AnyAttenuation, ExportError> {
    let Some(first) = rows(law).next() else {
        let names: Vec<_> = laws().map(|row| usual(row.law)).collect();
        return Err(ExportError::new("attenuation", law, format!("one of {}", names.join(", "))));
    };
    if !counts(first.beside_range()).contains(&numbers.len()) {
        return Err(ExportError::new(law, count_of(numbers.len()), told(first.beside_range())));
    }
    let row = if first.window.is_none() {
        if window != "cut" {
            return Err(ExportError::new("window", window, format!("none, because {law} ends by itself")));
        }
        if range.is_none() {
            return Err(ExportError::new("range", "none", format!("a distance, because {law} ends there")));
        }
        first
    } else {
        rows(law).find(|row| row.window == Some(window)).ok_or_else(|| {
            let windows: Vec<_> = rows(law).filter_map(|row| row.window).collect();
            ExportError::new("window", window, windows.join(" or "))
        })?
    };
    Ok(row.of(numbers, range)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of a model, of all that it accepts.
    fn anywhere<'a>(rng: &mut fastrand::Rng, numbers: impl IntoIterator<Item = &'a Number>) -> Vec<f32> {
        numbers.into_iter().map(|number| number.anywhere(rng.f32())).collect()
    }

    #[test]
    fn every_falloff_is_made_again_from_its_words() {
        let (mut rng, help) = (fastrand::Rng::with_seed(60), falloff_words());
        for row in AnyFalloff::LIST {
            let mut made = || row.of(&anywhere(&mut rng, row.numbers)).ok();
            let all: Vec<_> = (0..200).filter_map(|_| made()).collect();
            assert!(all.len() > 20, "{}: {} falloffs", row.name, all.len());
            for own in all {
                let (name, numbers) = described(&own);
                assert_eq!(falloff(name, &numbers).expect("its own words"), own);
            }
            assert!(help.contains(row.name), "{help}: expected {}", row.name);
        }
    }

    #[test]
    fn every_attenuation_is_made_again_from_its_words() {
        let (mut rng, help) = (fastrand::Rng::with_seed(60), law_words());
        for row in AnyAttenuation::LIST {
            let mut made = 0;
            for _ in 0..200 {
                let numbers = anywhere(&mut rng, row.beside_range());
                let Ok(own) = row.of(&numbers, Some(9.5)) else { continue };
                let window = row.window.unwrap_or("cut");
                let again = attenuation(row.law, &numbers, window, Some(9.5)).expect("its own words");
                assert_eq!((again, again.row().law), (own, row.law));
                assert_eq!(own.numbers().count(), row.numbers.len());
                made += 1;
            }
            assert!(made > 20, "{}: {made} attenuations", row.law);
            assert!(help.contains(usual(row.law)), "{help}: expected {}", row.law);
        }
    }

    #[test]
    fn wrong_words_of_a_law_are_told() {
        for (law, numbers, window, range, told) in [
            (
                "sqaure",
                &[][..],
                "cut",
                None,
                "attenuation = sqaure: expected one of none, inverse-square, polynomial, ",
            ),
            ("none", &[1.0], "cut", None, "none = 1 number: expected no numbers"),
            (
                "polynomial",
                &[1.0],
                "cut",
                None,
                "polynomial = 1 number: expected the constant, the linear, the quadratic",
            ),
            ("decay", &[17.0, 1.0], "cut", None, "decay = 17: expected more than 0 and at most 16"),
            ("decay", &[1.0, 1.0], "gltf", None, "window = gltf: expected cut or square"),
            (
                "smooth-range",
                &[],
                "square",
                Some(1.0),
                "window = square: expected none, because smooth-range ends by itself",
            ),
            (
                "smooth-range",
                &[],
                "cut",
                None,
                "range = none: expected a distance, because smooth-range ends there",
            ),
        ] {
            let refused = attenuation(law, numbers, window, range).expect_err(told).to_string();
            assert!(refused.starts_with(told), "{refused}: expected {told}");
        }
    }

    #[test]
    fn wrong_numbers_are_told() {
        for (name, numbers, told) in [
            ("soft", &[1.0][..], "soft = 1 number: expected no numbers"),
            ("quadratic", &[], "quadratic = 0 numbers: expected the edge slope"),
            ("cubic", &[1.0], "cubic = 1 number: expected the edge slope, the middle slope"),
            ("power", &[1.5], "exponent = 1.5: expected a whole number from 1 to 1024"),
            (
                "inverted-real-power",
                &[1.0; 3],
                "inverted-real-power = 3 numbers: expected the exponent, optionally the floor",
            ),
            ("inverted-real-power", &[0.5, 1.0], "floor = 1: expected a finite number from 0 to "),
            ("knots", &[1.0], "knots = 1 number: expected three numbers for each knot"),
        ] {
            let refused = falloff(name, numbers).expect_err(told).to_string();
            assert!(refused.starts_with(told), "{refused}: expected {told}");
        }
    }
}
