//! A file or numbers as lights: which reader, and from what it finds to lights.

use std::path::Path;

use luminaire_export::json;

use crate::convert;
use crate::lamp::{Lamp, Lamps};
use crate::measured;
use crate::read::{self, Found};
use crate::record::{Kind, Record, Value};
use crate::refusal::Refusal;
use crate::system::System;
use crate::text::decode;

/// Returns the lights of a file.
///
/// Without a system, the extension of the name decides, and of JSON the content. `tolerance` is the
/// largest difference in linear codes at which a cheaper cone takes the place of a measured light's
/// table.
///
/// # Errors
/// A name without a known extension; a file that its reader does not accept. A light of a file that
/// cannot be read is in [`Lamps::refused`].
pub fn read(name: &str, bytes: &[u8], system: Option<System>, tolerance: f64) -> Result<Lamps, Refusal> {
    let system = match system {
        Some(system) => system,
        None => recognised(name, bytes)?,
    };
    let text = || decode(bytes);
    let found = match system {
        System::Gltf => read::gltf::read(bytes)?,
        System::Three => read::three::read(&text()?)?,
        System::Babylon => read::babylon::read(&text()?)?,
        System::Godot => read::godot::read(&text()?)?,
        System::Usd => read::usd::read(&text()?)?,
        System::X3d => read::x3d::read(&text()?)?,
        System::Pbrt => read::pbrt::read(&text()?)?,
        System::Unity => read::unity::read(&text()?)?,
        System::Unreal => read::unreal::read(&text()?)?,
        System::Ies => return photometry(system, read::ies::read(&text()?)?, tolerance),
        System::Eulumdat => return photometry(system, read::eulumdat::read(&text()?)?, tolerance),
        System::Gdtf => return read::gdtf::read(bytes),
        System::Ofl => return read::ofl::read(&text()?),
        System::Luminaire => return own(&text()?),
        System::OpenGl | System::Direct3d | System::Blender | System::Bevy => {
            return numbers(system, text()?.lines().filter(|line| !line.trim_start().starts_with('#')));
        }
    };
    Ok(converted(system, found))
}

/// Returns the light of values `key=value` in the names and units of a system. `kind` is spot, point or
/// directional, and `position` and `axis` are three numbers each.
///
/// # Errors
/// A word that is no `key=value`, a key that the system does not have, or a value that it does not
/// accept.
pub fn numbers<'a>(system: System, words: impl IntoIterator<Item = &'a str>) -> Result<Lamps, Refusal> {
    let mut record = Record::new(system.name(), Kind::Spot, "");
    for word in words.into_iter().flat_map(str::split_whitespace) {
        let Some((key, value)) = word.split_once('=') else {
            return Err(Refusal::new("number", word, "key=value, without spaces"));
        };
        let numbers: Result<Vec<f64>, _> = value.split(',').map(str::parse).collect();
        match (key, numbers) {
            ("kind", _) => {
                record.kind = match value {
                    "spot" => Kind::Spot,
                    "point" => Kind::Point,
                    "directional" => Kind::Directional,
                    _ => return Err(Refusal::new("kind", value, "spot, point or directional")),
                };
            }
            ("name", _) => value.clone_into(&mut record.name),
            (_, Ok(numbers)) if numbers.iter().all(|number| number.is_finite()) => {
                record.set(key, Value::Numbers(numbers));
            }
            (_, Ok(_)) => return Err(Refusal::new(key, value, "finite numbers")),
            (_, Err(_)) => record.set(key, Value::Word(value.to_owned())),
        }
    }
    if system == System::Godot && (record.has("omni_range") || record.has("omni_attenuation")) {
        record.kind = Kind::Point;
    }
    record.position = record.triple("position", [0.0; 3])?.into();
    record.axis = record.triple("axis", [0.0, -1.0, 0.0])?.into();
    let mut probe = record.clone();
    let lamp = convert::convert(system, &mut probe)?;
    // A key that was not read is one that the system does not have, or a misspelt one.
    if let Some(key) = probe.unused() {
        let expected = format!("a key of {system}: {}", probe.asked().join(", "));
        return Err(Refusal::new("key", key, expected));
    }
    Ok(Lamps { lamps: vec![lamp], ..Lamps::new(system) })
}

fn converted(system: System, Found { records, mut refused, notes }: Found) -> Lamps {
    let mut lamps = Vec::new();
    for record in records {
        match convert::lamp(system, record) {
            Ok(lamp) => lamps.push(lamp),
            Err(refusal) => refused.push(refusal),
        }
    }
    Lamps { system, lamps, refused, notes }
}

fn photometry(system: System, read: read::photometry::Photometry, tolerance: f64) -> Result<Lamps, Refusal> {
    let lamps = measured::lamps(&read.name, &read.curve, read.difference, tolerance)?;
    Ok(Lamps { lamps, notes: read.notes, ..Lamps::new(system) })
}

fn own(text: &str) -> Result<Lamps, Refusal> {
    let lights =
        json::read(text).map_err(|error| Refusal::new(error.parameter, error.value, error.expected))?;
    let lamp =
        |named: json::NamedLight| Lamp { surfaces: named.surfaces, ..Lamp::new(named.name, named.light) };
    let lamps = lights.into_iter().map(lamp).collect();
    Ok(Lamps { lamps, ..Lamps::new(System::Luminaire) })
}

/// Returns the system of a file, by its name and of JSON by its content.
fn recognised(name: &str, bytes: &[u8]) -> Result<System, Refusal> {
    let extension = Path::new(name).extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let extension = extension.to_ascii_lowercase();
    let has = |word: &str| bytes.windows(word.len()).any(|window| window == word.as_bytes());
    if extension == "json" {
        return Ok(match () {
            () if has("luminaire-lights-") => System::Luminaire,
            () if has("\"metadata\"") && has("\"object\"") => System::Three,
            () if has("\"asset\"") => System::Gltf,
            () => System::Ofl,
        });
    }
    System::ALL.iter().copied().find(|system| system.extensions().contains(&&*extension)).ok_or_else(|| {
        let mut known: Vec<_> = System::ALL.iter().flat_map(|system| system.extensions()).copied().collect();
        known.dedup();
        let value = if extension.is_empty() { "none" } else { &extension };
        Refusal::new("extension", value, format_args!("one of {}", known.join(", ")))
    })
}
