//! GDTF files (DIN SPEC 15800): zips with a `description.xml`, whose `Beam` geometries are lights.

use std::borrow::Cow;

use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_with_limit};
use rawzip::{CompressionMethod, ZipArchive, ZipVerification, crc32};
use roxmltree::Node;

use super::scene::among;
use super::xml;
use crate::lamp::{Lamp, Lamps};
use crate::refusal::Refusal;
use crate::sheet::{Edge, Sheet};
use crate::system::System;
use crate::text;

/// Reads the lights of a GDTF file: each `Beam` geometry once, in whatever geometry it is.
///
/// Angles are full and without percentages in the standard: `BeamAngle` is the 50 % angle here and
/// `FieldAngle` the 10 % angle. `Zoom` is the beam angle, because it "is used to adjust the beam angle
/// of the light source" (attribute definitions); the field angle keeps its ratio to it. `ZoomMSpeed` and the
/// like are other attributes.
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
    let is_zoom = |name: &str| {
        name.strip_prefix("Zoom").is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let zooms = |node: &Node| node.attribute("Attribute").is_some_and(is_zoom);
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
        match lamp(beam, name, zoom) {
            Ok(lamp) => lamps.lamps.push(lamp),
            Err(refusal) => lamps.refused.push(refusal.at(path(beam))),
        }
    }
    if elements("Beam").next().is_none() {
        lamps
            .notes
            .push("the fixture has no geometry of the type Beam, which has the light of a fixture".into());
    }
    let is_moved = |node: &Node| node.attribute("Position").is_some_and(|own| !is_identity(own));
    let within = elements("Geometries").flat_map(|node| node.descendants());
    if within.clone().any(|node| is_moved(&node)) {
        let note = "positions in the fixture are not read: each beam is at the origin and shines down";
        lamps.notes.push(note.into());
    }
    let again = within.filter(|node| node.has_tag_name("GeometryReference")).count();
    let note = || format!("`GeometryReference` is not read ({again} of them): each beam is read once");
    lamps.notes.extend((again > 0).then(note));
    Ok(lamps)
}

/// Returns whether a matrix such as `{1,0,0,0}{0,1,0,0}{0,0,1,0}{0,0,0,1}` moves nothing.
fn is_identity(matrix: &str) -> bool {
    let numbers = matrix.split(['{', ',', '}']).filter_map(|number| number.trim().parse::<f64>().ok());
    numbers.enumerate().all(|(at, number)| number == f64::from(u8::from(at % 5 == 0)))
}

/// Returns the text of `description.xml`, if the text and its tree take at most 60 MB.
fn description(bytes: &[u8]) -> Result<String, Refusal> {
    let refused = |error: rawzip::Error| Refusal::new("GDTF file", error, "a zip with a description.xml");
    let archive = ZipArchive::from_slice(bytes).map_err(refused)?;
    let mut found = None;
    for entry in archive.entries() {
        let entry = entry.map_err(refused)?;
        // The last one counts: what is added to a zip replaces what was in it.
        found = if entry.file_path().as_ref() == b"description.xml" { Some(entry) } else { found };
    }
    let none = || Refusal::new("GDTF file", "a zip without it", "a zip with a description.xml");
    let entry = found.ok_or_else(none)?;
    let file = archive.get_entry(entry.wayfinder()).map_err(refused)?;
    if entry.flags().is_encrypted() {
        return Err(Refusal::new("GDTF file", "an encrypted zip", "a zip without a password"));
    }
    let text = unpack(file.data(), entry.compression_method()).and_then(|text| {
        let found = ZipVerification { crc: crc32(&text), uncompressed_size: text.len() as u64 };
        file.claim_verifier().valid(found).map_err(refused)?;
        text::decode(&text)
    });
    text.map_err(|refusal| refusal.at("description.xml"))
}

/// Returns the bytes of a file in a zip, whatever size the zip declares.
///
/// # Errors
/// A method but deflate, damaged data, or bytes over the limit of XML.
fn unpack(packed: &[u8], method: CompressionMethod) -> Result<Cow<'_, [u8]>, Refusal> {
    let bytes: Cow<[u8]> = match method {
        CompressionMethod::STORE => packed.into(),
        // One byte more than is accepted.
        CompressionMethod::DEFLATE => match decompress_to_vec_with_limit(packed, xml::LARGEST + 1) {
            Ok(bytes) => bytes.into(),
            Err(error) if error.status == TINFLStatus::HasMoreOutput => error.output.into(),
            Err(error) => return Err(Refusal::new("deflated data", error, "a whole file")),
        },
        _ => {
            let expected = "STORE or DEFLATE: unpack the file, and zip what was in it by one of these";
            return Err(Refusal::new("compression method", method.name().unwrap_or("unknown"), expected));
        }
    };
    match bytes.len() {
        ..=xml::LARGEST => Ok(bytes),
        size => Err(Refusal::new("size", size, format_args!("at most {} bytes", xml::LARGEST))),
    }
}

/// The attributes of a beam that are read, or that say nothing of its light.
const ATTRIBUTES: &str = "Name Model Position LampType PowerConsumption LuminousFlux ColorTemperature BeamAngle FieldAngle \
                          ThrowRatio RectangleRatio BeamRadius BeamType ColorRenderingIndex";

/// Returns the light of a beam, with both ends of the zoom.
fn lamp(node: Node, name: String, zoom: Option<(f64, f64)>) -> Result<Lamp, Refusal> {
    let mut notes = Vec::new();
    let mut standard = |key, value| {
        let assumed = || format!("{key} is not in the file: {value}, the value of the standard");
        notes.extend((!node.has_attribute(key)).then(assumed));
        number(node, key, value)
    };
    let angles = [standard("BeamAngle", 25.0)?, standard("FieldAngle", 25.0)?];
    let lumens = Some(standard("LuminousFlux", 10_000.0)?).filter(|lumens| *lumens != 0.0);
    let kelvin = Some(standard("ColorTemperature", 6_000.0)?);
    let kind = node.attribute("BeamType").unwrap_or("Wash");
    let edge = match kind {
        "Wash" | "Fresnel" | "PC" => Edge::Soft,
        "Spot" | "Rectangle" => Edge::Hard,
        _ => return Err(Refusal::new("BeamType", kind, "Wash, Fresnel, PC, Spot, Rectangle, None or Glow")),
    };
    notes.extend((kind == "Rectangle").then(|| "the pyramid of the type Rectangle is read as a cone".into()));
    let others = node.attributes().map(|own| own.name()).filter(|own| !among(ATTRIBUTES, own));
    notes.extend(others.take(20).map(|own| format!("`{own:.80}` is not read")));
    let [beam, field] = angles.map(|angle| Some(angle).filter(|angle| *angle != 0.0));
    let sheet = Sheet { name, beam, field, lumens, kelvin, edge, notes, ..Sheet::default() };
    let Some((least, most)) = zoom else { return sheet.lamp() };
    let zoomed = |ratio: Option<f64>, note: Option<String>| {
        let end = |beam| [Some(beam), ratio.map(|ratio| beam * ratio)];
        let ([beam, field], widest) = (end(least), Some(end(most)));
        let own = format!("the beam angle is that of Zoom, {least} to {most}, not {} degrees", angles[0]);
        let notes = sheet.notes.iter().cloned().chain([own]).chain(note).collect();
        Sheet { beam, field, widest, notes, ..sheet.clone() }.lamp()
    };
    // A field angle of another zoom, or of none, says nothing of this one.
    let note = || {
        Some(format!("the field angle, {} degrees, is left out: no cone has it beside this beam", angles[1]))
    };
    zoomed(field.zip(beam).map(|(field, beam)| field / beam), None).or_else(|_| zoomed(None, note()))
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
    use std::io::{self, Write};

    use luminaire::dynamic::AnyLight;
    use miniz_oxide::deflate::compress_to_vec;
    use rawzip::ZipArchiveWriter;

    use super::*;

    const DESCRIPTION: &str = include_str!("../../tests/files/description.xml");

    fn zipped(description: &str) -> Vec<u8> {
        packed(description, CompressionMethod::DEFLATE, &compress_to_vec(description.as_bytes(), 6))
    }

    /// Returns a zip whose `description.xml` is packed by a method.
    fn packed(description: &str, method: CompressionMethod, packed: &[u8]) -> Vec<u8> {
        let mut archive = ZipArchiveWriter::new(Vec::new());
        let entry = archive.new_file("description.xml").compression_method(method);
        let (mut entry, config) = entry.start().expect("a name");
        let mut text = config.wrap(io::sink());
        text.write_all(description.as_bytes()).expect("a sink");
        let (_, declared) = text.finish().expect("a sink");
        entry.write_all(packed).expect("memory");
        entry.finish(declared).expect("memory");
        archive.finish().expect("memory")
    }

    #[test]
    fn every_beam_is_a_light_with_the_angles_of_the_zoom() {
        let lamps = read(&zipped(DESCRIPTION)).expect("a fixture");
        let left_out = "Two Beams: Tip is left out: a beam of the type Glow lights nothing";
        let again = "`GeometryReference` is not read (3 of them): each beam is read once";
        assert_eq!(lamps.notes, ["gobos: Leaves, Bars", left_out, again]);
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
    fn what_is_stored_or_deflated_is_read_and_another_method_named() {
        let stored = packed(DESCRIPTION, CompressionMethod::STORE, DESCRIPTION.as_bytes());
        assert_eq!(read(&stored), read(&zipped(DESCRIPTION)));
        let refusal = read(include_bytes!("../../tests/files/bzip2.gdtf")).unwrap_err().to_string();
        assert_eq!(
            refusal,
            "description.xml: compression method = BZIP2: expected STORE or DEFLATE: unpack the file, and zip what was \
             in it by one of these"
        );
    }

    #[test]
    fn refusals_have_the_path_of_the_element() {
        for (from, to) in [("\"10\"", "\"ten\""), ("\"Wash\"", "\"Wish\"")] {
            let lamps = read(&zipped(&DESCRIPTION.replace(from, to))).expect("the other beam");
            assert_eq!(lamps.refused[0].place, "Geometries/Geometry[Base]/Axis[Yoke]/Axis[Head]/Beam[Main]");
        }
    }

    /// Beside a zoom the angles of the beam need not be those of a cone; without one they must be.
    #[test]
    fn zoom_is_the_attribute_of_that_name_and_enough_for_a_beam() {
        let speed = "<ChannelFunction Attribute=\"ZoomMSpeed\" PhysicalFrom=\"0.1\" PhysicalTo=\"25.5\"/></LogicalChannel>";
        let file = DESCRIPTION.replace("</LogicalChannel>", speed).replace("\"15\"", "\"1\"");
        let lamps = read(&zipped(&file)).expect("a fixture");
        let note = "the field angle, 1 degrees, is left out: no cone has it beside this beam";
        assert!(lamps.refused.is_empty() && lamps.lamps[0].notes.iter().any(|own| own == note), "{lamps:?}");
        let Some(AnyLight::Spot(widest)) = lamps.lamps[0].widest else { panic!("expected a zoom") };
        assert_eq!(widest.cone().beam().to_degrees().round(), 40.0);
        let numbered = read(&zipped(&file.replace("\"Zoom\"", "\"Zoom2\""))).expect("a fixture");
        assert_eq!(numbered.lamps[0].light, lamps.lamps[0].light);
        let none = read(&zipped(&file.replace("\"Zoom\"", "\"Zoomed\""))).expect("a fixture");
        assert_eq!(none.refused[0].parameter, "field angle", "{none:?}");
    }

    /// What a file has and is not read is noted, and a globe is a point light.
    #[test]
    fn beams_have_notes_of_what_is_not_read() {
        let moved = "Position=\"{1,0,0,0.1}{0,1,0,0}{0,0,1,0}{0,0,0,1}\" LightDistribution=\"a\" BeamType";
        let file = DESCRIPTION.replace("BeamType", moved).replace("\"Zoom\"", "\"Pan\"");
        let lamps = read(&zipped(&file.replace("\"20\"", "\"360\""))).expect("a fixture");
        assert!(
            lamps.notes.iter().any(|note| note.starts_with("positions in the fixture")),
            "{:?}",
            lamps.notes
        );
        assert!(lamps.lamps[0].notes.iter().any(|note| note == "`LightDistribution` is not read"));
        let AnyLight::Point(globe) = lamps.lamps[1].light else { panic!("expected a point light") };
        let candela = 10_000.0 / (4.0 * std::f64::consts::PI);
        assert!((lamps.lamps[1].own_intensity() - candela).abs() < 0.01, "{globe:?}");
        let still = read(&zipped(&file.replace("0.1}", "0}"))).expect("a fixture");
        assert!(!still.notes.iter().any(|note| note.starts_with("positions")), "{:?}", still.notes);
        let none = read(&zipped(&file.replace("<Beam", "<Geometry"))).expect("a fixture");
        assert!(
            none.lamps.is_empty()
                && none.notes.iter().any(|note| note.contains("no geometry of the type Beam"))
        );
        let beams = |count: usize| {
            DESCRIPTION.replace("<Beam Name=\"Tip\"", &("<Beam/>".repeat(count - 3) + "<Beam"))
        };
        assert!(read(&zipped(&beams(1_000))).is_ok() && read(&zipped(&beams(1_001))).is_err());
    }

    #[test]
    fn bombs_and_pieces_are_refused() {
        let whole = zipped(DESCRIPTION);
        assert!((0..whole.len()).all(|end| read(&whole[..end]).is_err()));
        // The checksum and the size that the directory declares are 16 and 24 bytes after its signature.
        let declare = |zip: &mut [u8], at, number: u32| {
            let directory = zip.windows(4).rposition(|four| four == b"PK\x01\x02").expect("a directory");
            zip[directory + at..][..4].copy_from_slice(&number.to_le_bytes());
        };
        let refused = |zip: &[u8], word| {
            let refusal = read(zip).unwrap_err().to_string();
            assert!(refusal.contains(word), "expected {word}, found {refusal}");
        };
        for (at, word) in [(16, "checksum"), (24, "size")] {
            let mut false_one = whole.clone();
            declare(&mut false_one, at, 100);
            refused(&false_one, word);
        }
        refused(&packed(DESCRIPTION, CompressionMethod::DEFLATE, &[0xff]), "deflated data = Invalid");
        let mut bomb = zipped(&"a".repeat(20 << 20));
        assert!(bomb.len() < 100_000);
        for declared in [20 << 20, 100, u32::MAX - 1] {
            declare(&mut bomb, 24, declared);
            refused(&bomb, "size = 16777217");
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
