//! GDTF files (DIN SPEC 15800): zips with a `description.xml`, whose `Beam` geometries are lights.

use std::io::{Cursor, Read};

use roxmltree::Node;
use zip::{ZipArchive, result::ZipError};

use super::xml;
use crate::lamp::Lamps;
use crate::refusal::Refusal;
use crate::sheet::{Edge, Sheet};
use crate::system::System;
use crate::text;

/// Reads the lights of a GDTF file: each `Beam` geometry once, in whatever geometry it is.
///
/// Angles are full and without percentages in the standard: `BeamAngle` is the 50 % angle here and
/// `FieldAngle` the 10 % angle. `Zoom` is the beam angle, because it "is used to adjust the beam angle
/// of the light source" (attribute definitions); the field angle keeps its ratio to it.
///
/// # Errors
/// No zip with a `description.xml`, one that is not well-formed, has a DTD or is over the limits, or a
/// zoom without numbers.
pub(crate) fn read(bytes: &[u8]) -> Result<Lamps, Refusal> {
    let text = description(bytes)?;
    let document = xml::document(&text).map_err(|refusal| refusal.at("description.xml"))?;
    let elements = |tag| document.descendants().filter(move |node: &Node| node.has_tag_name(tag));
    let fixture = elements("FixtureType").next();
    let fixture = fixture.ok_or_else(|| Refusal::new("FixtureType", "none", "the element of the fixture"))?;

    let mut lamps = Lamps::new(System::Gdtf);
    let is_gobo = |slot: &Node| slot.attribute("MediaFileName").is_some_and(|file| !file.is_empty());
    let gobos: Vec<_> = elements("Slot").filter(is_gobo).take(20).map(|slot| short(slot, "Name")).collect();
    lamps.notes.extend((!gobos.is_empty()).then(|| format!("gobos: {}", gobos.join(", "))));
    let mut ends = Vec::new();
    let zooms = |node: &Node| node.attribute("Attribute").is_some_and(|name| name.starts_with("Zoom"));
    for node in elements("ChannelFunction").filter(zooms) {
        match [("PhysicalFrom", 0.0), ("PhysicalTo", 1.0)].map(|(key, value)| number(node, key, value)) {
            [Ok(0.0), Ok(1.0)] => {} // the values of the standard, which are no angles
            [Ok(from), Ok(to)] => ends.extend([from, to]),
            [Err(refusal), _] | [_, Err(refusal)] => return Err(refusal.at(path(node))),
        }
    }
    let zoom = ends.iter().copied().reduce(f64::min).zip(ends.iter().copied().reduce(f64::max));
    if elements("Beam").nth(1_000).is_some() {
        return Err(Refusal::new("Beam", "more", "at most 1000"));
    }
    for beam in elements("Beam") {
        let name = [fixture, beam].map(|node| short(node, "Name")).join(": ");
        if let Some(kind @ ("None" | "Glow")) = beam.attribute("BeamType") {
            lamps.notes.push(format!("{name} is left out: a beam of the type {kind} lights nothing"));
            continue;
        }
        match sheet(beam, name, zoom).and_then(|sheet| sheet.lamp()) {
            Ok(lamp) => lamps.lamps.push(lamp),
            Err(refusal) => lamps.refused.push(refusal.at(path(beam))),
        }
    }
    Ok(lamps)
}

/// Returns the text of `description.xml`, if the text and its tree take at most 60 MB.
fn description(bytes: &[u8]) -> Result<String, Refusal> {
    let refused = |error: ZipError| Refusal::new("GDTF file", error, "a zip with a description.xml");
    // The crate reserves memory for the declared number of files: at most 65,535 without zip64, whose
    // locator is near the end.
    if bytes[bytes.len().saturating_sub(1 << 17)..].windows(4).any(|four| four == b"PK\x06\x07") {
        return Err(Refusal::new("GDTF file", "a zip64", "a zip of less than 4 GiB, without zip64"));
    }
    let mut unpacked = Vec::new();
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(refused)?;
    let file = archive.by_name("description.xml").map_err(refused)?;
    // One byte more than is accepted, whatever size the zip declares.
    file.take((16 << 20) + 1).read_to_end(&mut unpacked).map_err(|error| refused(error.into()))?;
    drop(archive);
    text::decode(&unpacked).map_err(|refusal| refusal.at("description.xml"))
}

/// Returns the numbers of a beam at both ends of the zoom.
fn sheet(node: Node, name: String, zoom: Option<(f64, f64)>) -> Result<Sheet, Refusal> {
    let mut notes = Vec::new();
    let mut standard = |key, value| {
        let assumed = || format!("{key} is not in the file: {value}, the value of the standard");
        notes.extend((!node.has_attribute(key)).then(assumed));
        number(node, key, value)
    };
    let angles = [standard("BeamAngle", 25.0)?, standard("FieldAngle", 25.0)?];
    let lumens = Some(standard("LuminousFlux", 10_000.0)?).filter(|lumens| *lumens != 0.0);
    let kelvin = standard("ColorTemperature", 6_000.0)?;
    notes.push(format!("the colour temperature of {kelvin} K is left out"));
    let kind = node.attribute("BeamType").unwrap_or("Wash");
    let edge = match kind {
        "Wash" | "Fresnel" | "PC" => Edge::Soft,
        "Spot" | "Rectangle" => Edge::Hard,
        _ => return Err(Refusal::new("BeamType", kind, "Wash, Fresnel, PC, Spot, Rectangle, None or Glow")),
    };
    notes.extend((kind == "Rectangle").then(|| "the pyramid of the type Rectangle is read as a cone".into()));
    let [mut beam, mut field] = angles.map(|angle| Some(angle).filter(|angle| *angle != 0.0));
    let mut widest = None;
    if let Some((least, most)) = zoom {
        let ratio = field.zip(beam).map(|(field, beam)| field / beam);
        let end = |beam| [Some(beam), ratio.map(|ratio| beam * ratio)];
        ([beam, field], widest) = (end(least), Some(end(most)));
        notes.push(format!("the beam angle is that of Zoom, {least} to {most}, not {} degrees", angles[0]));
    }
    Ok(Sheet { name, beam, field, lumens, edge, widest, notes, ..Sheet::default() })
}

/// Returns a number of an attribute, or that of the standard.
fn number(node: Node, key: &str, standard: f64) -> Result<f64, Refusal> {
    let Some(text) = node.attribute(key) else { return Ok(standard) };
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| Refusal::new(key, text, "a finite number"))
}

/// Returns where an element is, such as `Geometries/Geometry[Body]/Beam[Beam]`.
fn path(node: Node) -> String {
    let within = node.ancestors().take_while(|node| node.is_element() && !node.has_tag_name("FixtureType"));
    let step = |node: Node| match node.attribute("Name") {
        Some(name) => format!("{:.80}[{name:.80}]", node.tag_name().name()),
        None => format!("{:.80}", node.tag_name().name()),
    };
    within.take(16).map(step).reduce(|inner, outer| format!("{outer}/{inner}")).unwrap_or_default()
}

fn short(node: Node, key: &str) -> String {
    format!("{:.80}", node.attribute(key).unwrap_or("unnamed"))
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use luminaire::dynamic::AnyLight;
    use zip::ZipWriter;

    use super::*;

    const DESCRIPTION: &str = include_str!("../../tests/files/description.xml");

    fn zipped(description: &str) -> Vec<u8> {
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        writer.start_file("description.xml", zip::write::SimpleFileOptions::default()).expect("a name");
        writer.write_all(description.as_bytes()).expect("memory");
        writer.finish().expect("memory").into_inner()
    }

    #[test]
    fn every_beam_is_a_light_with_the_angles_of_the_zoom() {
        let lamps = read(&zipped(DESCRIPTION)).expect("a fixture");
        let left_out = "Two Beams: Tip is left out: a beam of the type Glow lights nothing";
        assert_eq!(lamps.notes, ["gobos: Leaves, Bars", left_out]);
        let [main, dot] = &lamps.lamps[..] else { panic!("expected two lights, found {lamps:?}") };
        assert_eq!([&main.name, &dot.name], ["Two Beams: Main", "Two Beams: Dot"]);
        assert!(main.notes.iter().any(|note| note.ends_with("flux 9,000 lm")), "{:?}", main.notes);
        assert!(
            dot.notes.iter().any(|note| note.ends_with("929,746 cd in place of 692,992 cd")),
            "{:?}",
            dot.notes
        );
        for (light, angles) in [(Some(main.light), [8.0, 12.0]), (main.widest, [40.0, 60.0])] {
            let Some(AnyLight::Spot(spot)) = light else { panic!("expected a spotlight, found {light:?}") };
            assert_eq!(
                [spot.cone().beam(), spot.cone().field()].map(|angle| angle.to_degrees().round()),
                angles
            );
        }
    }

    #[test]
    fn refusals_have_the_path_of_the_element() {
        for (from, to) in [("\"10\"", "\"ten\""), ("\"Wash\"", "\"Wish\""), ("\"15\"", "\"5\"")] {
            let lamps = read(&zipped(&DESCRIPTION.replace(from, to))).expect("the other beam");
            assert_eq!(lamps.refused[0].place, "Geometries/Geometry[Base]/Axis[Yoke]/Axis[Head]/Beam[Main]");
        }
    }

    #[test]
    fn bombs_and_pieces_are_refused() {
        let whole = zipped(DESCRIPTION);
        assert!((0..whole.len()).all(|end| read(&whole[..end]).is_err()));
        // The size that the directory declares is 24 bytes after its signature.
        let mut bomb = zipped(&"a".repeat(20 << 20));
        let directory = bomb.windows(4).rposition(|four| four == b"PK\x01\x02").expect("a directory");
        for (declared, word) in [(20 << 20, "16777217"), (100, "declared"), (u32::MAX - 1, "16777217")] {
            bomb[directory + 24..][..4].copy_from_slice(&declared.to_le_bytes());
            let refusal = read(&bomb[..]).unwrap_err().to_string();
            assert!(bomb.len() < 100_000 && refusal.contains(word), "{refusal}");
        }
        let deep = DESCRIPTION.replace("<Axis Name=\"Yoke\">", &"<Axis>".repeat(10_000));
        let deep = deep.replace("</Axis></Axis>", &"</Axis>".repeat(10_001));
        assert_eq!(read(&zipped(&deep)).map(|lamps| lamps.lamps.len()), Ok(2));
        let texts = ["<a>".repeat(10_000), "<a/>".repeat(200_001), format!("<a{}/>", " b=''".repeat(257))];
        let entity = "<!DOCTYPE a [<!ENTITY b \"c\">]><a>&b;</a>".to_owned();
        for (text, word) in texts.iter().chain([&entity]).zip(["well-formed", "200000", "256", "at most 0"]) {
            assert!(read(&zipped(text)).is_err_and(|refusal| refusal.expected.contains(word)), "{word}");
        }
    }
}
