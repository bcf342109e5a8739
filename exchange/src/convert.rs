//! Records of a tool as lights.

use luminaire::dynamic::AnyLight;
use luminaire::{AmbientLight, DirectionalLight, PointLight, Rgb};
use luminaire_export::json::NamedAmbient;

use crate::difference::Difference;
use crate::lamp::Lamp;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::system::System;
use crate::tool::{Spot, Tool, vector};

/// Returns the light of a record.
///
/// # Errors
/// A value that the tool does not accept or the kernel cannot hold, with the place of the record.
pub(crate) fn lamp(system: System, mut record: Record) -> Result<Lamp, Refusal> {
    let mut lamp = convert(system, &mut record).map_err(|refusal| refusal.at(place(&record)))?;
    lamp.notes.extend(idle(&record));
    Ok(lamp)
}

/// Returns the ambient light of a record, and adds what is to note of it.
///
/// # Errors
/// As those of [`lamp()`].
pub(crate) fn surrounding(
    system: System,
    mut record: Record,
    notes: &mut Vec<String>,
) -> Result<NamedAmbient, Refusal> {
    let found = ambient(system, &mut record).map_err(|refusal| refusal.at(place(&record)))?;
    let own = record.notes.iter().cloned().chain(idle(&record));
    notes.extend(own.map(|note| format!("{}: {note}", record.name)));
    Ok(found)
}

/// Returns where a record is from.
fn place(record: &Record) -> &str {
    if record.place.is_empty() { &record.name } else { &record.place }
}

/// Returns what to note of a value without an effect. No value of a file is passed over in silence. Of the version,
/// the reader has told what matters.
fn idle(record: &Record) -> Option<String> {
    record.unused().filter(|key| *key != "version").map(|key| format!("`{key}` has no effect"))
}

/// Returns the light of a record whose place is known.
pub(crate) fn convert(system: System, record: &mut Record) -> Result<Lamp, Refusal> {
    let (tool, color, strongest) = emission(system, record)?;
    let (light, difference, intensity): (AnyLight, _, _) = if record.kind == Kind::Directional {
        let intensity = tool.sun(record)?;
        (DirectionalLight::new(vector(record.axis))?.into(), Difference::default(), intensity)
    } else {
        let Spot { light, difference } = tool.spot(record)?;
        let intensity = f64::from(light.intensity());
        if record.kind == Kind::Point {
            let point = PointLight::new(light.position())?.with_attenuation(light.attenuation());
            (point.into(), Difference { angle: 0.0, place: 0.0, ..difference }, intensity)
        } else {
            (light.into(), difference, intensity)
        }
    };
    let light = light.with_color(color)?.with_intensity((intensity * strongest) as f32)?;
    let notes = std::mem::take(&mut record.notes);
    Ok(Lamp { difference, notes, ..Lamp::new(&*record.name, light) })
}

/// Returns the ambient light of a record whose place is known.
pub(crate) fn ambient(system: System, record: &mut Record) -> Result<NamedAmbient, Refusal> {
    let (tool, color, strongest) = emission(system, record)?;
    let light = AmbientLight::new(color)?.with_intensity((tool.ambient(record)? * strongest) as f32)?;
    Ok(NamedAmbient { name: record.name.clone(), light })
}

/// Returns the tool of a record, its colour, whose strongest channel is at most 1, and the factor of its intensity.
fn emission(system: System, record: &mut Record) -> Result<(&'static dyn Tool, Rgb<f32>, f64), Refusal> {
    let tool = system
        .tool()
        .ok_or_else(|| Refusal::new("system", system, "a file of it, or a tool with numbers"))?;
    tool.prepare(record);
    let (key, least) = tool.color(record.kind);
    let [own, white] = [record.triple(key, [1.0; 3])?, tool.white(record)?];
    let channels = [0, 1, 2].map(|channel| own[channel] * white[channel]);
    // A channel over 1 is more light, not another colour.
    let strongest = channels.into_iter().fold(least, f64::max);
    let [red, green, blue] = channels.map(|channel| (channel / strongest) as f32);
    Ok((tool, Rgb::new(red, green, blue), strongest))
}
