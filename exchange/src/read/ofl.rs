//! Fixtures of the Open Fixture Library: one JSON file each.

use std::collections::BTreeMap;
use std::{iter, ptr};

use serde::Deserialize;

use crate::lamp::Lamps;
use crate::refusal::Refusal;
use crate::sheet::{Edge, Sheet};
use crate::system::System;

/// A fixture, or one of its modes.
#[derive(Deserialize)]
struct Part {
    name: String,
    #[serde(default)]
    categories: Vec<String>,
    #[serde(default)]
    physical: Physical,
    #[serde(default)]
    modes: Vec<Part>,
    #[serde(default)]
    wheels: BTreeMap<String, Wheel>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
struct Physical {
    bulb: Numbers,
    lens: Numbers,
}

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Numbers {
    lumens: Option<f64>,
    color_temperature: Option<f64>,
    degrees_min_max: Option<[f64; 2]>,
}

#[derive(Deserialize)]
struct Wheel {
    slots: Vec<Slot>,
}

#[derive(Deserialize)]
struct Slot {
    r#type: String,
    name: Option<String>,
}

/// Reads the light of a fixture, and one more for each mode with another lens or bulb.
///
/// The library documents the angle of a lens (`Physical.lensDegreesMin`) as the beam angle, but most
/// files have the only angle of a data sheet, of whatever kind: [`Sheet`] takes it as the beam angle and
/// notes the other choice. The edge is hard for scanners and for fixtures with gobos.
///
/// # Errors
/// Other text than the JSON of a fixture, more than 2 MiB, or no angle.
pub(crate) fn read(text: &str) -> Result<Lamps, Refusal> {
    if text.len() > 2 << 20 {
        return Err(Refusal::new("size", text.len(), "at most 2 MiB"));
    }
    let fixture: Part = serde_json::from_str(text)
        .map_err(|error| Refusal::new("file", error, "a fixture of the Open Fixture Library"))?;
    let mut lamps = Lamps::new(System::Ofl);
    let gobos = fixture.wheels.values().flat_map(|wheel| &wheel.slots).filter(|slot| slot.r#type == "Gobo");
    let gobos: Vec<_> = gobos.take(20).map(|slot| slot.name.as_deref().unwrap_or("unnamed")).collect();
    lamps.notes.extend((!gobos.is_empty()).then(|| format!("gobos: {}", gobos.join(", "))));
    let scans = fixture.categories.iter().any(|category| category.ends_with("Scanner"));
    let edge = if scans || !gobos.is_empty() { Edge::Hard } else { Edge::Soft };

    let mut seen = Vec::new();
    let own = &fixture.physical;
    for part in iter::once(&fixture).chain(&fixture.modes).take(1_000) {
        let physical = &part.physical;
        let lumens = physical.bulb.lumens.or(own.bulb.lumens);
        let kelvin = physical.bulb.color_temperature.or(own.bulb.color_temperature);
        let degrees = physical.lens.degrees_min_max.or(own.lens.degrees_min_max);
        let Some([from, to]) = degrees.filter(|_| !seen.contains(&(degrees, lumens, kelvin))) else {
            continue;
        };
        seen.push((degrees, lumens, kelvin));
        let mode = if ptr::eq(part, &fixture) { String::new() } else { format!(": {:.80}", part.name) };
        let name = format!("{:.80}{mode}", fixture.name);
        let notes = kelvin.map(|kelvin| format!("the colour temperature of {kelvin} K is left out"));
        let (beam, widest) = (Some(from.min(to)), Some([Some(from.max(to)); 2]));
        let notes = notes.into_iter().collect();
        let sheet = Sheet { name, beam, field: beam, lumens, edge, widest, notes, ..Sheet::default() };
        match sheet.lamp() {
            Ok(lamp) => lamps.lamps.push(lamp),
            Err(refusal) => lamps.refused.push(refusal.at(sheet.name)),
        }
    }
    if seen.is_empty() {
        let expected = "[from, to] in degrees; or give the angles of the data sheet";
        return Err(Refusal::new("physical.lens.degreesMinMax", "none", expected).at(fixture.name));
    }
    Ok(lamps)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FIXTURE: &str = include_str!("../../tests/files/fixture.json");

    #[test]
    fn fixtures_have_a_light_for_each_bulb_and_pieces_are_refused() {
        let lamps = read(FIXTURE).expect("a fixture");
        let [own, bright] = &lamps.lamps[..] else { panic!("expected two lights, found {lamps:?}") };
        assert_eq!([&own.name, &bright.name], ["One Lens", "One Lens: Bright"]);
        assert!((bright.light.intensity() / own.light.intensity() - 12.0 / 9.0).abs() < 1e-6);
        assert!(own.widest.is_some_and(|wide| wide.intensity() < own.light.intensity() / 20.0));
        assert!(own.notes.iter().any(|note| note.starts_with("if 8 degrees is the field angle")));
        assert_eq!(lamps.notes, ["gobos: Leaves"]);
        assert!((0..FIXTURE.trim_end().len()).all(|end| read(&FIXTURE[..end]).is_err()));
        assert!(read(r#"{"name": "Hazer"}"#).is_err_and(|refusal| refusal.place == "Hazer"));
        assert!(read(&"[".repeat(100_000)).is_err());
    }
}
