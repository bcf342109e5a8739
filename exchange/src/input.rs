//! A file or numbers as lights: which reader, and from what it finds to lights.

use std::path::Path;

use luminaire_export::json::{self, Lights};

use crate::about;
use crate::convert;
use crate::lamp::{Lamp, Lamps};
use crate::measured;
use crate::profile::{Beside, Profiles};
use crate::read::{
    self, Found,
    photometry::{Photometry, Shape},
};
use crate::reading::Reading;
use crate::record::{Kind, Record, Value};
use crate::refusal::Refusal;
use crate::system::System;
use crate::tabulate::Tables;
use crate::text::{LARGEST, decode};

/// Returns the lights of a file.
///
/// Without a system, the extension of the name decides, and of JSON the content. A text that begins
/// with `# system: NAME` has a value `key=value` in each line, and what the system has no words for
/// in lines such as `# kind: point`: see [`Parameters::text`](crate::Parameters::text). What is lost of measured
/// intensities is part of the light's difference.
///
/// # Errors
/// A name without a known extension; a file that its reader does not accept, or in which there is no light,
/// with the reasons that are known. A light of a file that cannot be read is in [`Lamps::refused`].
pub fn read(name: &str, bytes: &[u8], system: Option<System>, reading: Reading) -> Result<Lamps, Refusal> {
    read_beside(name, bytes, system, reading, &|_| Err("files beside this one are not given".to_owned()))
}

/// Returns the lights of a file like [`read`], and reads the photometric files that shape them by `beside`.
///
/// # Errors
/// Those of [`read`].
pub fn read_beside(
    name: &str,
    bytes: &[u8],
    system: Option<System>,
    reading: Reading,
    beside: Beside,
) -> Result<Lamps, Refusal> {
    let system = match system {
        Some(system) => system,
        None => recognised(name, bytes)?,
    };
    let text = || decode(bytes);
    let lamps = match system {
        _ if bytes.starts_with(BEGIN.as_bytes()) => values(system, &text()?),
        System::Ies => photometry(system, read::ies::read, &text()?, reading),
        System::Eulumdat => photometry(system, read::eulumdat::read, &text()?, reading),
        System::Gdtf => read::gdtf::read(bytes).map(zoomed),
        System::Mvr => read::mvr::read(bytes),
        System::Ofl => read::ofl::read(&text()?).map(zoomed),
        System::Luminaire => own(&text()?),
        _ => match system.tool().and_then(|tool| tool.scene()) {
            Some(scene) => Ok(converted(system, scene(bytes)?, Profiles::new(beside, reading))),
            None => values(system, &text()?),
        },
    }?;
    if lamps.is_empty() {
        let reasons: String = lamps.notes.iter().map(|note| format!("; {note}")).collect();
        return Err(Refusal::new("lights", "none", format_args!("at least one light{reasons}")));
    }
    Ok(lamps)
}

/// Returns the most bytes of a file of this name that are read: more of a container, which has its
/// lights beside meshes or pictures, than of a text.
pub fn largest(name: &str) -> u64 {
    let name = name.to_ascii_lowercase();
    if [".glb", ".gdtf", ".mvr"].iter().any(|extension| name.ends_with(extension)) {
        1 << 30
    } else {
        LARGEST as u64
    }
}

/// What begins a light in a text of values.
const BEGIN: &str = "# system: ";

/// The most lights of a text of values, which bounds the memory.
const LIGHTS: usize = 10_000;

/// Returns the lights of a text with a value in each line, each after `# system: NAME`.
fn values(system: System, text: &str) -> Result<Lamps, Refusal> {
    let lines: Vec<_> = text.lines().collect();
    let mut starts: Vec<_> = (0..lines.len()).filter(|&at| lines[at].starts_with(BEGIN)).collect();
    if starts.is_empty() {
        starts.push(0);
    }
    if starts.len() > LIGHTS {
        return Err(Refusal::new("lights", starts.len(), format_args!("at most {LIGHTS}")));
    }
    let mut all = Lamps::new(system);
    for (number, &start) in starts.iter().enumerate() {
        let end = starts.get(number + 1).copied().unwrap_or(lines.len());
        match light(system, &lines[start..end]) {
            Ok(found) => {
                all.lamps.extend(found.lamps);
                all.ambient.extend(found.ambient);
                all.notes.extend(found.notes);
            }
            Err(refusal) if starts.len() == 1 => return Err(refusal),
            Err(refusal) => all.refused.push(refusal.at(format_args!("line {}", start + 1))),
        }
    }
    Ok(all)
}

/// Returns the light of the lines of values.
fn light(system: System, lines: &[&str]) -> Result<Lamps, Refusal> {
    let told = |key: &str| {
        lines.iter().find_map(|line| line.strip_prefix("# ")?.strip_prefix(key)?.strip_prefix(": "))
    };
    if let Some(other) = told("system").map(str::trim).filter(|other| *other != system.name()) {
        return Err(Refusal::new("system", other, system));
    }
    let known = ["kind", "position", "axis", "color"];
    let known = known.iter().filter_map(|key| Some(format!("{key}={}", told(key)?.trim())));
    let known: Vec<_> = known.collect();
    let own = lines.iter().copied().filter(|line| !line.trim_start().starts_with('#'));
    let mut lamps = numbers(system, known.iter().map(String::as_str).chain(own))?;
    if let Some(name) = told("name") {
        lamps.lamps.iter_mut().for_each(|lamp| name.clone_into(&mut lamp.name));
        lamps.ambient.iter_mut().for_each(|ambient| name.clone_into(&mut ambient.name));
    }
    Ok(lamps)
}

/// Returns the light of values `key=value` in the names and units of a system. `kind` is spot, point,
/// directional or, of some, ambient, and `position` and `axis` are three numbers each.
///
/// # Errors
/// A word that is no `key=value`, a key that the system does not have, or a value that it does not
/// accept.
pub fn numbers<'a>(system: System, words: impl IntoIterator<Item = &'a str>) -> Result<Lamps, Refusal> {
    let (mut record, mut kind) = (Record::new("light", Kind::Spot, ""), None);
    for word in words.into_iter().flat_map(str::split_whitespace) {
        let Some((key, value)) = word.split_once('=') else {
            return Err(Refusal::new("number", word, "key=value, without spaces"));
        };
        let numbers: Result<Vec<f64>, _> = value.split(',').map(str::parse).collect();
        match (key, numbers) {
            ("kind", _) => {
                kind = match value {
                    "spot" => Some(Kind::Spot),
                    "point" => Some(Kind::Point),
                    "directional" => Some(Kind::Directional),
                    "ambient" => Some(Kind::Ambient),
                    _ => return Err(Refusal::new("kind", value, "spot, point, directional or ambient")),
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
    record.kind = kind.or_else(|| Some(system.tool()?.kind(&record))).unwrap_or(record.kind);
    for (key, default) in [("position", [0.0; 3]), ("axis", [0.0, -1.0, 0.0])] {
        // Only of a colour or a polynomial, one number stands for three.
        if let Ok(Some(one)) = record.optional(key) {
            return Err(Refusal::new(key, one, "three numbers"));
        }
        let triple = record.triple(key, default)?.into();
        *(if key == "axis" { &mut record.axis } else { &mut record.position }) = triple;
    }
    let mut lamps = Lamps::new(system);
    if record.kind == Kind::Ambient {
        lamps.ambient.push(convert::ambient(system, &mut record)?);
        lamps.notes = std::mem::take(&mut record.notes);
    } else {
        lamps.lamps.push(convert::convert(system, &mut record)?);
    }
    // A key that was not read is one that the system does not have, or a misspelt one.
    if let Some(key) = record.unused() {
        let expected = format!("a key of {system}: {}", record.asked().join(", "));
        return Err(Refusal::new("key", key, expected));
    }
    Ok(lamps)
}

fn converted(system: System, found: Found, mut profiles: Profiles) -> Lamps {
    let Found { records, mut refused, mut notes } = found;
    let (mut lamps, mut ambient, tables) = (Vec::new(), Vec::new(), Tables::default());
    for (number, mut record) in records.into_iter().enumerate() {
        record.tables = tables.clone();
        if record.name.is_empty() {
            record.name = format!("light {}", number + 1);
        }
        if record.kind == Kind::Ambient {
            match convert::surrounding(system, record, &mut notes) {
                Ok(found) => ambient.push(found),
                Err(refusal) => refused.push(refusal),
            }
            continue;
        }
        match shaped(system, record, &mut profiles) {
            Ok(found) => lamps.extend(found),
            Err(refusal) => refused.push(refusal),
        }
    }
    Lamps { system, lamps, ambient, refused, notes }
}

/// Returns the lights of a record by its photometric file, or else without it, with a note why.
fn shaped(system: System, mut record: Record, profiles: &mut Profiles) -> Result<Vec<Lamp>, Refusal> {
    let Some(mut profile) = record.profile.take() else { return Ok(vec![convert::lamp(system, record)?]) };
    let without = profile.without.take();
    let own = convert::lamp(system, record.clone());
    let found = own.and_then(|own| profiles.lamps(&profile, &own, record.axis));
    match (found, without) {
        (Ok(lamps), _) => Ok(lamps),
        (Err(mut refusal), None) => {
            if profile.content.is_none() && refusal.parameter == "file" {
                refusal.expected += "; put it there, or give the node a light of KHR_lights_punctual, too: without it no intensity is known";
            }
            Err(refusal.at(record.place))
        }
        (Err(refusal), Some(mut without)) => {
            (without.name, without.position, without.axis) = (record.name, record.position, record.axis);
            (without.notes, without.tables) = (record.notes, record.tables);
            without.note(format!("its IES profile is left out: {refusal}"));
            Ok(vec![convert::lamp(system, without)?])
        }
    }
}

fn zoomed(lamps: Lamps) -> Lamps {
    Lamps { lamps: lamps.lamps.into_iter().flat_map(Lamp::ends).collect(), ..lamps }
}

fn photometry(
    system: System,
    reader: fn(&str, Reading) -> Result<Photometry, Refusal>,
    text: &str,
    reading: Reading,
) -> Result<Lamps, Refusal> {
    if !(0.0..=255.0).contains(&reading.fit) {
        return Err(Refusal::new("fit", reading.fit, "a number from 0 to 255 linear codes"));
    }
    let Photometry { name, shape, kelvin, notes } = reader(text, reading)?;
    let name = if name.is_empty() { "light" } else { &name };
    let lamps = match shape {
        Shape::Round(curve, difference) => measured::lamps(name, &curve, difference, reading.fit)?,
        Shape::Planes(sphere, _) => vec![measured::lamp(name, &sphere, reading)?],
    };
    let lamps = lamps.into_iter().map(|lamp| lamp.in_white(kelvin)).collect();
    Ok(Lamps { lamps, notes, ..Lamps::new(system) })
}

fn own(text: &str) -> Result<Lamps, Refusal> {
    let Lights { lights, ambient } = json::read(text)?;
    Ok(Lamps { lamps: about::lamps(text, lights), ambient, ..Lamps::new(System::Luminaire) })
}

/// Returns the system of a file, by its name and of JSON by its content.
pub(crate) fn recognised(name: &str, bytes: &[u8]) -> Result<System, Refusal> {
    let extension = Path::new(name).extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let extension = extension.to_ascii_lowercase();
    if extension == "json" {
        let text = decode(bytes)?;
        let members = read::members(&text);
        let has = |name: &str| members.contains(&name);
        return Ok(match () {
            () if has("format") => System::Luminaire,
            () if has("metadata") => System::Three,
            () if has("asset") => System::Gltf,
            () => System::Ofl,
        });
    }
    // Numbers in a text say in the first line whose they are.
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(200)]);
    let first = text.split(['\n', '\r']).next().unwrap_or("");
    if let Some(name) = first.strip_prefix(BEGIN) {
        return name.trim().parse();
    }
    System::ALL.iter().copied().find(|system| system.extensions().contains(&&*extension)).ok_or_else(|| {
        let mut known: Vec<_> = System::ALL.iter().flat_map(|system| system.extensions()).copied().collect();
        known.sort_unstable();
        known.dedup();
        let value = if extension.is_empty() { "none" } else { &extension };
        Refusal::new("extension", value, format_args!("one of {}", known.join(", ")))
    })
}
