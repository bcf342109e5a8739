//! Falloffs and attenuations of `luminaire export`, as words of the command line.

use std::ops::RangeInclusive;
use std::str::FromStr;

use luminaire::Error;
use luminaire::falloff::{
    AnyFalloff, Cubic, IntegerPower, InvertedIntegerPower, InvertedRealPower, Quadratic, RealPower, Table,
};

/// An attenuation without its range.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Law {
    None,
    InverseSquare,
    Polynomial([f32; 3]),
    SmoothRange,
}

/// How a light ends at its range.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Window {
    Cut,
    Gltf,
    Square,
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
        match (name, &numbers[..]) {
            ("none", []) => Ok(Self::None),
            ("inverse-square", []) => Ok(Self::InverseSquare),
            ("polynomial", &[constant, linear, quadratic]) => {
                Ok(Self::Polynomial([constant, linear, quadratic]))
            }
            ("smooth-range", []) => Ok(Self::SmoothRange),
            _ => Err("expected none, inverse-square, polynomial=A,B,C or smooth-range".to_owned()),
        }
    }
}

impl FromStr for Window {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        match name {
            "cut" => Ok(Self::Cut),
            "gltf" => Ok(Self::Gltf),
            "square" => Ok(Self::Square),
            _ => Err("expected cut, gltf or square".to_owned()),
        }
    }
}
