//! The light of `luminaire export`, with any falloff and any attenuation.

use std::ops::RangeInclusive;
use std::str::FromStr;

use luminaire::attenuation::{
    AnyAttenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
    Windowed,
};
use luminaire::falloff::{
    AnyFalloff, Cubic, IntegerPower, InvertedIntegerPower, InvertedRealPower, Quadratic, RealPower, Soft,
    Table,
};
use luminaire::{Angle, Cone, Error, Rgb, SpotLight};
use luminaire_export::ExportError;

use crate::arguments::Export;

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

fn refused(parameter: &str, value: &str, expected: &str) -> ExportError {
    ExportError { parameter: parameter.to_owned(), value: value.to_owned(), expected: expected.to_owned() }
}

fn attenuation(options: &Export) -> Result<AnyAttenuation, ExportError> {
    let (law, range) = (options.attenuation.unwrap_or(Law::InverseSquare), options.range);
    let window = options.window.unwrap_or(Window::Cut);
    Ok(match (law, window) {
        (Law::None, Window::Cut) => CutAt::new(NoAttenuation, range)?.into(),
        (Law::None, Window::Square) => Windowed::new(NoAttenuation, range)?.into(),
        (Law::InverseSquare, Window::Cut) => CutAt::new(InverseSquare, range)?.into(),
        (Law::InverseSquare, Window::Gltf) => GltfRange::new(InverseSquare, range)?.into(),
        (Law::InverseSquare, Window::Square) => FilamentRange::new(InverseSquare, range)?.into(),
        (Law::Polynomial([a, b, c]), Window::Cut) => CutAt::new(Polynomial::new(a, b, c)?, range)?.into(),
        (Law::Polynomial([a, b, c]), Window::Square) => {
            Windowed::new(Polynomial::new(a, b, c)?, range)?.into()
        }
        (_, Window::Gltf) => {
            return Err(refused(
                "window",
                "gltf",
                "cut or square: the window of glTF is one of the inverse square",
            ));
        }
        (Law::SmoothRange, _) => {
            let range = range
                .ok_or_else(|| refused("range", "none", "a distance, because smooth-range ends there"))?;
            SmoothRange::new(range)?.into()
        }
    })
}

fn cone(options: &Export) -> Result<Cone<AnyFalloff>, ExportError> {
    let spot = &options.spot;
    let falloff = options.falloff.unwrap_or(Soft.into());
    let [beam, field, outer] = [spot.beam, spot.field, spot.outer].map(|angle| angle.map(Angle::degrees));
    let mut cone = match (beam, field, outer) {
        (None, None, None) => Cone::from_field(falloff, Angle::degrees(36.0))?,
        (Some(beam), None, None) => Cone::from_beam(falloff, beam)?,
        (None, Some(field), None) => Cone::from_field(falloff, field)?,
        (None, None, Some(outer)) => Cone::from_outer(falloff, outer)?,
        (Some(_), Some(_), None) if options.falloff.is_some() => {
            return Err(refused(
                "falloff",
                "given",
                "no falloff beside both a beam and a field angle, which determine it",
            ));
        }
        (Some(beam), Some(field), None) => {
            let cone = Cone::from_beam_and_field(beam, field)?;
            cone.with_falloff(cone.falloff().into())
        }
        (.., Some(outer)) => {
            let outer = outer.to_degrees().to_string();
            return Err(refused("outer angle", &outer, "no beam or field angle beside it"));
        }
    };
    if let Some(inner) = spot.inner {
        cone = cone.with_inner(Angle::degrees(inner))?;
    }
    if let Some(cutoff) = options.cutoff {
        cone = cone.with_cutoff(Angle::degrees(cutoff))?;
    }
    Ok(cone)
}

/// Returns the light.
pub(crate) fn light(options: &Export) -> Result<SpotLight<AnyFalloff, AnyAttenuation>, ExportError> {
    let spot = &options.spot;
    let intensity = if matches!(options.attenuation, Some(Law::None)) { 1.0 } else { 16.0 };
    let [red, green, blue] = options.color.unwrap_or([1.0; 3]);
    let (position, axis) = (spot.position.unwrap_or([0.0; 3]), spot.axis.unwrap_or([0.0, -1.0, 0.0]));
    let light = SpotLight::new(position, axis, cone(options)?)?.with_color(Rgb::new(red, green, blue))?;
    Ok(light.with_intensity(spot.intensity.unwrap_or(intensity))?.with_attenuation(attenuation(options)?))
}
