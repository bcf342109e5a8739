//! Records of a tool as lights.

use luminaire::dynamic::AnyLight;
use luminaire::{DirectionalLight, PointLight, Rgb};

use crate::difference::Difference;
use crate::lamp::Lamp;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::system::System;
use crate::tool::{Spot, vector};

/// Returns the light of a record.
///
/// # Errors
/// A value that the tool does not accept or the kernel cannot hold, with the place of the record.
pub(crate) fn lamp(system: System, mut record: Record) -> Result<Lamp, Refusal> {
    let place = if record.place.is_empty() { record.name.clone() } else { record.place.clone() };
    let mut lamp = convert(system, &mut record).map_err(|refusal| refusal.at(place))?;
    // No value of a file is passed over in silence. Of the version, the reader has told what matters.
    let unused = record.unused().filter(|key| *key != "version");
    lamp.notes.extend(unused.map(|key| format!("`{key}` has no effect")));
    Ok(lamp)
}

/// Returns the light of a record whose place is known.
pub(crate) fn convert(system: System, record: &mut Record) -> Result<Lamp, Refusal> {
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
    let color = Rgb::new(red, green, blue);
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
