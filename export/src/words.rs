//! Falloffs and attenuations by their names and numbers, as the command line and the JSON have them.

use std::ops::RangeInclusive;

use luminaire::attenuation::{AnyAttenuation, Attenuation, Describe};
use luminaire::falloff::{
    AnyFalloff, Cubic, Falloff, Formula, IntegerPower, InvertedIntegerPower, InvertedRealPower, Knot,
    Quadratic, RealPower, Table,
};
use luminaire::models::Parameters;

use crate::error::ExportError;

/// The falloffs with numbers of which a wrong count was given.
const NUMBERED: [&str; 7] =
    ["quadratic", "cubic", "power", "inverted-power", "real-power", "inverted-real-power", "knots"];

/// Returns the falloff of a name in the list of models, with its parameters.
///
/// A table of `table` has samples from 65,535 on the axis, evenly spaced over the versine; one of
/// `knots` has three numbers for each knot. Both live as long as the program.
///
/// # Errors
/// A name that is not in the list, or parameters that the falloff does not accept.
pub fn falloff(name: &str, numbers: &[f64]) -> Result<AnyFalloff, ExportError> {
    let exponent = |number| whole("exponent", number, 1..=1_024);
    let [first, second] = [0, 1].map(|i| numbers.get(i).copied().unwrap_or_default() as f32);
    Ok(match (name, numbers.len()) {
        ("quadratic", 1) => Quadratic::new(first)?.into(),
        ("cubic", 2) => Cubic::with_slopes(first, second)?.into(),
        ("power", 1) => IntegerPower::new(exponent(numbers[0])?)?.into(),
        ("inverted-power", 1) => InvertedIntegerPower::new(exponent(numbers[0])?)?.into(),
        ("real-power", 1) => RealPower::new(first)?.into(),
        ("inverted-real-power", 1) => InvertedRealPower::new(first)?.into(),
        ("inverted-real-power", 2) => InvertedRealPower::with_floor(first, second)?.into(),
        ("table", _) => {
            let sample = |&number: &f64| whole("sample", number, 0..=65_535).map(|whole| whole as u16);
            Table::new(Vec::leak(numbers.iter().map(sample).collect::<Result<_, _>>()?))?.into()
        }
        ("knots", count) if count % 3 == 0 => {
            let knot = |three: &[f64]| {
                let [place, value] =
                    [0, 1].map(|i| whole("knot", three[i], 0..=65_535).map(|whole| whole as u16));
                Ok(Knot::from_bits(place?, value?, three[2] as i32))
            };
            Table::from_knots(Vec::leak(numbers.chunks(3).map(knot).collect::<Result<_, ExportError>>()?))?
                .into()
        }
        (name, count) if NUMBERED.contains(&name) => {
            let given = format_args!("{count} numbers");
            return Err(ExportError::new(name, given, "the numbers of `luminaire export --help`"));
        }
        (name, count) => {
            let names: Vec<_> = AnyFalloff::samples().map(|sample| sample.effect().name()).collect();
            let found = AnyFalloff::samples().find(|sample| sample.effect().name() == name);
            let falloff = found
                .ok_or_else(|| ExportError::new("falloff", name, format!("one of {}", names.join(", "))))?;
            if count > 0 {
                return Err(ExportError::new(name, format_args!("{count} numbers"), "no numbers"));
            }
            falloff
        }
    })
}

/// Returns the name and the parameters by which [`falloff`] makes the same falloff.
pub fn described(falloff: &AnyFalloff) -> (&'static str, Vec<f64>) {
    let name = falloff.effect().name();
    let numbers = match falloff {
        AnyFalloff::Quadratic(quadratic) => vec![quadratic.edge_slope().into()],
        AnyFalloff::Cubic(cubic) => vec![cubic.edge_slope().into(), cubic.middle_slope().into()],
        AnyFalloff::Power(power) => vec![power.exponent().into()],
        AnyFalloff::InvertedPower(power) => vec![power.exponent().into()],
        AnyFalloff::RealPower(power) => vec![power.exponent().into()],
        AnyFalloff::InvertedRealPower(power) if power.floor() == 0.0 => vec![power.exponent().into()],
        AnyFalloff::InvertedRealPower(power) => vec![power.exponent().into(), power.floor().into()],
        AnyFalloff::Table(_) => match falloff.formula() {
            Formula::Samples(samples) => samples.iter().map(|&sample| sample.into()).collect(),
            Formula::Knots(knots) => {
                let bits = knots.iter().map(|knot| knot.to_bits());
                return (
                    "knots",
                    bits.flat_map(|(place, value, slope)| [place.into(), value.into(), slope.into()])
                        .collect(),
                );
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    };
    (name, numbers)
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
            let name = NAMES.iter().find(|(name, _)| *name == row.law).map_or(&*row.law, |(_, own)| own);
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
