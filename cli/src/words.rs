//! Falloffs and attenuations of `luminaire export`, as words of the command line.

use std::ops::RangeInclusive;
use std::str::FromStr;

use luminaire::Error;
use luminaire::attenuation::{AnyAttenuation, Attenuation, Describe};
use luminaire::falloff::{
    AnyFalloff, Cubic, IntegerPower, InvertedIntegerPower, InvertedRealPower, Quadratic, RealPower, Table,
};
use luminaire::models::Parameters;

/// An attenuation without its range: its name and its numbers.
#[derive(Clone, Debug)]
pub(crate) struct Law {
    pub(crate) name: String,
    pub(crate) numbers: Vec<f32>,
}

/// A row of the kernel's list of attenuations.
#[derive(Default)]
pub(crate) struct Row {
    pub(crate) law: String,
    /// `None` for a law that has a range always.
    pub(crate) window: Option<String>,
    /// How many numbers the law takes.
    numbers: usize,
}

/// Names that this program has for laws.
const NAMES: [(&str, &str); 2] = [("constant", "none"), ("smoothstep", "smooth-range")];

impl Describe for Row {
    fn law(&mut self, _: &str, law: &str, _: &[(&str, &[f32])]) {
        let own = NAMES.iter().find(|(name, _)| *name == law);
        self.law = own.map_or(law, |(_, own)| own).to_owned();
    }

    fn window(&mut self, _: &str, window: &str, _: Option<f32>) {
        self.window = Some(window.to_owned());
    }
}

/// Builds a row from given numbers, and counts them.
pub(crate) struct Given<'a> {
    pub(crate) numbers: &'a [f32],
    pub(crate) used: usize,
    pub(crate) range: Option<f32>,
}

impl Parameters for Given<'_> {
    fn number(&mut self, most: f32) -> f32 {
        self.used += 1;
        self.numbers.get(self.used - 1).copied().unwrap_or(most / 2.0)
    }

    fn range(&mut self) -> Option<f32> {
        self.range
    }

    fn end(&mut self) -> f32 {
        self.range.unwrap_or(f32::NAN)
    }
}

/// The rows of the list, in their order.
pub(crate) fn rows() -> Vec<Row> {
    let row = |index| {
        let mut given = Given { numbers: &[], used: 0, range: Some(1.0) };
        let sample = AnyAttenuation::built(index, &mut given).expect("half of the most is accepted");
        let mut row = Row { numbers: given.used, ..Row::default() };
        sample.describe(&mut row);
        row
    };
    (0..AnyAttenuation::COUNT).map(row).collect()
}

/// Splits `name=1,2` into the name and the numbers.
fn split(text: &str) -> Result<(&str, Vec<f32>), String> {
    let Some((name, numbers)) = text.split_once('=') else { return Ok((text, Vec::new())) };
    let numbers = numbers.split(',').map(|number| number.trim().parse());
    Ok((name, numbers.collect::<Result<_, _>>().map_err(|_| format!("expected numbers after `{name}=`"))?))
}

/// Returns a whole number of a range. A cast alone would round and saturate.
fn whole(parameter: &str, number: f32, range: RangeInclusive<u32>) -> Result<u32, String> {
    let value = number as u32;
    if value as f32 == number && range.contains(&value) {
        return Ok(value);
    }
    Err(format!("{parameter} = {number}: expected a whole number from {} to {}", range.start(), range.end()))
}

/// Returns the falloff of a name in the list of models, with its parameters.
pub(crate) fn falloff(text: &str) -> Result<AnyFalloff, String> {
    let (name, numbers) = split(text)?;
    let told = |error: Error| error.to_string();
    let exponent = |number| whole("exponent", number, 1..=1_024);
    let found: Result<AnyFalloff, Error> = match (name, &numbers[..]) {
        ("quadratic", &[slope]) => Quadratic::new(slope).map(Into::into),
        ("cubic", &[edge, middle]) => Cubic::with_slopes(edge, middle).map(Into::into),
        ("power", &[n]) => IntegerPower::new(exponent(n)?).map(Into::into),
        ("inverted-power", &[n]) => InvertedIntegerPower::new(exponent(n)?).map(Into::into),
        ("real-power", &[exponent]) => RealPower::new(exponent).map(Into::into),
        ("inverted-real-power", &[exponent]) => InvertedRealPower::new(exponent).map(Into::into),
        ("table", samples) => {
            let sample = |&sample| whole("sample", sample, 0..=65_535).map(|whole| whole as u16);
            // The light lives as long as the command.
            Table::new(Vec::leak(samples.iter().map(sample).collect::<Result<_, _>>()?)).map(Into::into)
        }
        ("quadratic" | "cubic" | "power" | "inverted-power", _)
        | ("real-power" | "inverted-real-power", _) => {
            return Err(format!("expected other parameters of `{name}`: see `luminaire export --help`"));
        }
        (name, []) => {
            let name_of = |falloff: &AnyFalloff| falloff.effect().name();
            let found = AnyFalloff::samples().find(|sample| name_of(sample) == name);
            return found.ok_or_else(|| {
                let names: Vec<_> = AnyFalloff::samples().map(|sample| name_of(&sample)).collect();
                format!("expected one of {}", names.join(", "))
            });
        }
        (name, _) => return Err(format!("`{name}` has no parameters")),
    };
    found.map_err(told)
}

impl FromStr for Law {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, numbers) = split(text)?;
        let rows = rows();
        if rows.iter().any(|row| row.law == name && row.numbers == numbers.len()) {
            return Ok(Self { name: name.to_owned(), numbers });
        }
        let mut laws = Vec::new();
        for Row { law, numbers, .. } in rows {
            let law = if numbers == 0 { law } else { format!("{law} with {numbers} numbers") };
            if !laws.contains(&law) {
                laws.push(law);
            }
        }
        Err(format!("expected one of {}", laws.join(", ")))
    }
}
