//! Falloffs and attenuations by their names and numbers, as the command line and the JSON have them.

use std::ops::RangeInclusive;

use luminaire::attenuation::{AnyAttenuation, Attenuation, Describe};
use luminaire::falloff::{AnyFalloff, Falloff, FalloffRow, Formula, Knot, Table};
use luminaire::models::{Number, Parameters};

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
            let least = row.numbers.iter().filter(|number| number.default.is_none()).count();
            if !(least..=row.numbers.len()).contains(&numbers.len()) {
                return Err(ExportError::new(name, count_of(numbers.len()), told(row)));
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

/// Tells the numbers of a falloff.
fn told(row: &FalloffRow) -> String {
    let told = |number: &Number| {
        let optional = if number.default.is_some() { "optionally " } else { "" };
        format!("{optional}the {}", number.name.replace('_', " "))
    };
    let told: Vec<_> = row.numbers.iter().map(told).collect();
    if told.is_empty() { "no numbers".to_owned() } else { told.join(", ") }
}

/// Returns the names of the falloffs that [`falloff`] takes.
pub fn falloff_names() -> impl Iterator<Item = &'static str> {
    AnyFalloff::LIST.iter().map(|row| row.name).chain([KNOTS])
}

/// Returns the falloffs as words of a command, each with the names of its numbers.
pub fn falloff_words() -> String {
    let word = |row: &FalloffRow| {
        let mut word = row.name.to_owned();
        for (place, number) in row.numbers.iter().enumerate() {
            let before = if place == 0 { "=" } else { "," };
            let name = number.name.to_uppercase().replace('_', "-");
            word += &if number.default.is_some() {
                format!("[{before}{name}]")
            } else {
                format!("{before}{name}")
            };
        }
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

/// A row of the kernel's list of attenuations.
#[derive(Default)]
struct Row {
    law: String,
    /// The names of the law's parameters, and how many numbers each has.
    parameters: Vec<(String, usize)>,
    /// `None` for a law that has a range always.
    window: Option<String>,
}

/// Names that people use for laws.
const NAMES: [(&str, &str); 2] = [("constant", "none"), ("smoothstep", "smooth-range")];

impl Row {
    /// The name that people use for the law.
    fn word(&self) -> &str {
        NAMES.iter().find(|(name, _)| *name == self.law).map_or(&*self.law, |(_, own)| own)
    }
}

impl Describe for Row {
    fn law(&mut self, _: &str, law: &str, arguments: &[(&str, &[f32])]) {
        law.clone_into(&mut self.law);
        let own = |(name, values): &(&str, &[f32])| ((*name).to_owned(), values.len());
        // The range of a law that always has one is no parameter of the law.
        self.parameters = arguments.iter().filter(|(name, _)| *name != "range").map(own).collect();
    }

    fn window(&mut self, _: &str, window: &str, _: Option<f32>) {
        self.window = Some(window.to_owned());
    }
}

/// Builds a row from given numbers.
struct Given<'a> {
    numbers: std::slice::Iter<'a, f32>,
    range: Option<f32>,
}

impl Parameters for Given<'_> {
    fn number(&mut self, most: f32) -> f32 {
        self.numbers.next().copied().unwrap_or(most / 2.0)
    }

    fn range(&mut self) -> Option<f32> {
        self.range
    }

    fn end(&mut self) -> f32 {
        self.range.unwrap_or(f32::NAN)
    }
}

fn rows() -> Vec<Row> {
    let row = |index| {
        let mut given = Given { numbers: [].iter(), range: Some(1.0) };
        let mut row = Row::default();
        if let Ok(sample) = AnyAttenuation::built(index, &mut given) {
            sample.describe(&mut row);
        }
        row
    };
    (0..AnyAttenuation::COUNT).map(row).collect()
}

/// Returns the names of the laws that [`attenuation`] takes, and those that people use for them.
pub fn law_names() -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for row in rows() {
        if !names.contains(&row.law) {
            names.extend(NAMES.iter().filter(|(name, _)| *name == row.law).map(|(_, own)| (*own).to_owned()));
            names.push(row.law);
        }
    }
    names
}

/// Returns the laws as words of a command, each with the names of its numbers.
pub fn law_words() -> String {
    let mut words: Vec<String> = Vec::new();
    for row in rows() {
        let name = row.word();
        let number = |(name, count): &(String, usize)| {
            let name = name.to_uppercase();
            let names = (1..=*count).map(|number| format!("{name}-{number}"));
            if *count == 1 { name } else { names.collect::<Vec<_>>().join(",") }
        };
        let numbers: Vec<_> = row.parameters.iter().map(number).collect();
        let word = if numbers.is_empty() { name.to_owned() } else { format!("{name}={}", numbers.join(",")) };
        if !words.contains(&word) {
            words.push(word);
        }
    }
    words.join(", ")
}

/// Returns the names of a law's parameters and how many numbers each has; `None` for an unknown law.
pub fn parameters(law: &str) -> Option<Vec<(String, usize)>> {
    let law = canonical(law);
    rows().into_iter().find(|row| row.law == law).map(|row| row.parameters)
}

fn canonical(law: &str) -> &str {
    NAMES.iter().find(|(_, own)| *own == law).map_or(law, |(name, _)| name)
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
    let rows = rows();
    let count = |row: &Row| row.parameters.iter().map(|(_, count)| count).sum::<usize>();
    let own: Vec<_> = rows.iter().enumerate().filter(|(_, row)| row.law == canonical(law)).collect();
    if !own.iter().any(|(_, row)| count(row) == numbers.len()) {
        let mut laws = Vec::new();
        for row in &rows {
            let name = row.word();
            let law =
                if count(row) == 0 { name.to_owned() } else { format!("{name} with {} numbers", count(row)) };
            if !laws.contains(&law) {
                laws.push(law);
            }
        }
        let given =
            if numbers.is_empty() { law.to_owned() } else { format!("{law} with {} numbers", numbers.len()) };
        return Err(ExportError::new("attenuation", given, format!("one of {}", laws.join(", "))));
    }
    let Some((index, row)) = own.iter().find(|(_, row)| row.window.as_ref().is_none_or(|own| own == window))
    else {
        let windows: Vec<_> = own.iter().filter_map(|(_, row)| row.window.as_deref()).collect();
        return Err(ExportError::new("window", window, windows.join(" or ")));
    };
    if row.window.is_none() && window != "cut" {
        return Err(ExportError::new("window", window, format!("none, because {law} ends by itself")));
    }
    if row.window.is_none() && range.is_none() {
        return Err(ExportError::new("range", "none", format!("a distance, because {law} ends there")));
    }
    Ok(AnyAttenuation::built(*index, &mut Given { numbers: numbers.iter(), range })?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Falloffs of a row: the ends of each number, its sample and its default, and numbers between.
    fn falloffs(row: &FalloffRow) -> Vec<AnyFalloff> {
        let mut rng = fastrand::Rng::with_seed(60);
        let mut number = |number: &Number| match rng.u8(..5) {
            0 => number.limits[0],
            1 => number.limits[1],
            2 => number.sample,
            3 => number.default.unwrap_or(number.sample),
            _ => number.drawn(rng.f32()),
        };
        let mut made = || row.of(&row.numbers.iter().map(&mut number).collect::<Vec<_>>()).ok();
        (0..200).filter_map(|_| made()).collect()
    }

    #[test]
    fn every_falloff_is_made_again_from_its_words() {
        let help = falloff_words();
        for row in AnyFalloff::LIST {
            let all = falloffs(row);
            assert!(all.len() > 20, "{}: {} falloffs", row.name, all.len());
            for own in all {
                let (name, numbers) = described(&own);
                assert_eq!(falloff(name, &numbers).expect("its own words"), own);
            }
            assert!(help.contains(row.name), "{help}: expected {}", row.name);
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
