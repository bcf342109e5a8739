//! Fixtures of the Open Fixture Library: one JSON file each.

use std::collections::BTreeMap;
use std::{iter, ptr};

use super::json::{list, objects, parse, word};
use crate::lamp::Lamps;
use crate::refusal::Refusal;
use crate::sheet::{Edge, Sheet};
use crate::system::System;

objects! {
    // A fixture, or one of its modes.
    Part: name String, categories Vec<String>, physical Physical, modes Vec<Part>,
        wheels BTreeMap<String, Wheel>;
    Physical: bulb Bulb, lens Lens;
    Bulb: lumens f64, colorTemperature f64;
    Lens: degreesMinMax [f64; 2];
    Wheel: slots Vec<Slot>;
    Slot: r#type String, name String;
}

impl Part {
    /// Returns the lumens, the colour temperature and the angles of the zoom, or those of another part.
    fn numbers(&self, other: Numbers) -> Numbers {
        let physical = self.physical.as_deref();
        let bulb = physical.and_then(|own| own.bulb.as_deref());
        let lens = physical.and_then(|own| own.lens.as_deref());
        let kelvin = bulb.and_then(|bulb| bulb.colorTemperature.as_deref().copied());
        (
            bulb.and_then(|bulb| bulb.lumens.as_deref().copied()).or(other.0),
            kelvin.or(other.1),
            lens.and_then(|lens| lens.degreesMinMax.as_deref().copied()).or(other.2),
        )
    }
}

type Numbers = (Option<f64>, Option<f64>, Option<[f64; 2]>);

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
    let fixture: Part = parse(text)?;
    if list(&fixture.modes).len() > 1_000 {
        return Err(Refusal::new("modes", "more", "at most 1000"));
    }
    let mut lamps = Lamps::new(System::Ofl);
    let slots = fixture.wheels.iter().flat_map(|wheels| wheels.values()).flat_map(|wheel| list(&wheel.slots));
    let gobos = slots.filter(|slot| word(&slot.r#type) == "Gobo").take(20);
    let gobos: Vec<_> = gobos.map(|slot| slot.name.as_deref().map_or("unnamed", String::as_str)).collect();
    lamps.notes.extend((!gobos.is_empty()).then(|| format!("gobos: {}", gobos.join(", "))));
    let scans = list(&fixture.categories).iter().any(|category| category.ends_with("Scanner"));
    let edge = if scans || !gobos.is_empty() { Edge::Hard } else { Edge::Soft };

    let (own, mut seen) = (fixture.numbers((None, None, None)), Vec::new());
    for part in iter::once(&fixture).chain(list(&fixture.modes)) {
        let numbers = part.numbers(own);
        let (lumens, kelvin, Some([from, to])) = numbers else { continue };
        if seen.contains(&numbers) {
            continue;
        }
        seen.push(numbers);
        let mode =
            if ptr::eq(part, &fixture) { String::new() } else { format!(": {:.80}", word(&part.name)) };
        let name = format!("{:.80}{mode}", word(&fixture.name));
        let (beam, widest) = (Some(from.min(to)), Some([Some(from.max(to)); 2]));
        let sheet = Sheet { name, beam, field: beam, lumens, kelvin, edge, widest, ..Sheet::default() };
        match sheet.lamp() {
            Ok(lamp) => lamps.lamps.push(lamp),
            Err(refusal) => lamps.refused.push(refusal.at(sheet.name)),
        }
    }
    if seen.is_empty() {
        let expected = "[from, to] in degrees; or give the angles of the data sheet";
        return Err(Refusal::new("physical.lens.degreesMinMax", "none", expected).at(word(&fixture.name)));
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
