//! The light of `luminaire export`, with any falloff and any attenuation.

use luminaire::attenuation::AnyAttenuation;
use luminaire::falloff::{AnyFalloff, Soft};
use luminaire::{Angle, Cone, Rgb, SpotLight};
use luminaire_export::ExportError;

use crate::arguments::Export;
use crate::words::{Given, Law, Row, rows};

fn refused(parameter: &str, value: &str, expected: &str) -> ExportError {
    ExportError { parameter: parameter.to_owned(), value: value.to_owned(), expected: expected.to_owned() }
}

fn attenuation(options: &Export) -> Result<AnyAttenuation, ExportError> {
    let standard = Law { name: "inverse-square".to_owned(), numbers: Vec::new() };
    let law = options.attenuation.as_ref().unwrap_or(&standard);
    let window = options.window.as_deref().unwrap_or("cut");
    let rows = rows();
    let fits = |row: &Row| row.law == law.name && row.window.as_ref().is_none_or(|own| own == window);
    let Some(index) = rows.iter().position(fits) else {
        let own = rows.iter().filter(|row| row.law == law.name);
        let windows: Vec<_> = own.filter_map(|row| row.window.as_deref()).collect();
        return Err(refused("window", window, &windows.join(" or ")));
    };
    if rows[index].window.is_none() && options.range.is_none() {
        return Err(refused("range", "none", &format!("a distance, because {} ends there", law.name)));
    }
    let mut given = Given { numbers: &law.numbers, used: 0, range: options.range };
    Ok(AnyAttenuation::built(index, &mut given)?)
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
    let intensity =
        if options.attenuation.as_ref().is_some_and(|law| law.name == "none") { 1.0 } else { 16.0 };
    let [red, green, blue] = options.color.unwrap_or([1.0; 3]);
    let (position, axis) = (spot.position.unwrap_or([0.0; 3]), spot.axis.unwrap_or([0.0, -1.0, 0.0]));
    let light = SpotLight::new(position, axis, cone(options)?)?.with_color(Rgb::new(red, green, blue))?;
    Ok(light.with_intensity(spot.intensity.unwrap_or(intensity))?.with_attenuation(attenuation(options)?))
}
