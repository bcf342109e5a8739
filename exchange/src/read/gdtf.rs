//! GDTF files (DIN SPEC 15800): zips with a `description.xml`, whose `Beam` geometries are lights.

mod geometry;
mod patch;

use roxmltree::Node;

use self::geometry::{Geometries, Placed, number, path, short};
pub(super) use self::geometry::{rows, upright};
use self::patch::Channels;
use super::scene::among;
use super::xml;
use super::zip::Zip;
use crate::lamp::{Lamp, Lamps};
use crate::refusal::Refusal;
use crate::sheet::{Edge, Sheet};
use crate::system::System;
use crate::text::decode;

/// Reads the lights of a GDTF file: the beams of its first mode that has any, at the origin of the fixture, each with
/// both ends of its zoom.
///
/// # Errors
/// Those of [`description`] and [`beams`].
pub(crate) fn read(bytes: &[u8]) -> Result<Lamps, Refusal> {
    beams(&description(bytes, xml::LARGEST)?, None)
}

/// Returns the text of `description.xml`, of at most `most` bytes.
///
/// # Errors
/// No zip with such a file, or one over the limit.
pub(super) fn description(bytes: &[u8], most: usize) -> Result<String, Refusal> {
    let zip = Zip::open(["GDTF file", "a zip with a description.xml"], bytes)?;
    let text = zip.unpack(zip.file("description.xml")?, most).and_then(|text| decode(&text));
    text.map_err(|refusal| refusal.at("description.xml"))
}

/// Returns the lights of a description, y up in metres: each `Beam` geometry of a mode, as often as it is referred to.
///
/// `rig` is the mode of a fixture in a rig, whose lights have one zoom: the beam angle of the file, or else the narrowest.
/// Else the mode is the first one that has a beam.
///
/// Angles are full and without percentages in the standard: `BeamAngle` is the 50 % angle here and
/// `FieldAngle` the 10 % angle. `Zoom` is the beam angle, because it "is used to adjust the beam angle
/// of the light source" (attribute definitions); the field angle keeps its ratio to it. `ZoomMSpeed` and the
/// like are other attributes.
///
/// # Errors
/// A text that is not well-formed, has a DTD or is over the limits, more than 1000 beams, or a zoom without numbers.
pub(super) fn beams(text: &str, rig: Option<&str>) -> Result<Lamps, Refusal> {
    let document = xml::document(text).map_err(|refusal| refusal.at("description.xml"))?;
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

    let mut geometries = Geometries::new(fixture);
    let modes: Vec<_> = elements("DMXMode").collect();
    let own = rig.and_then(|name| modes.iter().position(|mode| mode.attribute("Name") == Some(name)));
    if let (Some(name), None) = (rig.filter(|name| !name.is_empty()), own) {
        let first = modes.first().map_or_else(|| "none".to_owned(), |mode| short(*mode, "Name"));
        lamps.notes.push(format!("there is no mode `{name:.80}`: the one that is read is {first}"));
    }
    let mut mode = modes.get(own.unwrap_or(0)).copied();
    let mut found = geometries.beams(mode)?;
    if rig.is_none() {
        for other in modes.iter().skip(1) {
            if !found.placed.is_empty() {
                break;
            }
            mode = Some(*other);
            found = geometries.beams(mode)?;
        }
    }
    let channels = mode.filter(|_| rig.is_none()).map(Channels::of);
    for Placed { beam, name, world } in found.placed {
        let is_own = name == short(beam, "Name");
        let name = if rig.is_some() { name } else { format!("{}: {name}", short(fixture, "Name")) };
        if let Some(kind @ ("None" | "Glow")) = beam.attribute("BeamType") {
            lamps.notes.push(format!("{name} is left out: a beam of the type {kind} lights nothing"));
            continue;
        }
        let lamp = lamp(beam, name, zoom, rig.is_some()).and_then(|lamp| lamp.moved(upright(world)));
        match lamp {
            Ok(lamp) => {
                // The pixels that references place have slots of their own, which are not read.
                let patch = channels.as_ref().filter(|_| is_own).and_then(|own| own.patch(beam, zoom));
                lamps.lamps.push(Lamp { patch, ..lamp });
            }
            Err(refusal) => lamps.refused.push(refusal.at(path(beam))),
        }
    }
    lamps.refused.extend(found.refused);
    if !geometries.has_beams() {
        let none = "the fixture has no geometry of the type Beam, which has the light of a fixture";
        lamps.notes.push(none.into());
    } else if lamps.is_empty() && lamps.notes.is_empty() {
        lamps.notes.push("its mode has no geometry of the type Beam".into());
    }
    let again = || format!("a `GeometryReference` within what it refers to is left out: {}", found.loops);
    lamps.notes.extend((found.loops > 0).then(again));
    Ok(lamps)
}

/// The attributes of a beam that are read, or that say nothing of its light.
const ATTRIBUTES: &str = "Name Model Position LampType PowerConsumption LuminousFlux ColorTemperature BeamAngle FieldAngle \
                          ThrowRatio RectangleRatio BeamRadius BeamType ColorRenderingIndex";

/// Returns the light of a beam, with both ends of the zoom, or in a rig with one.
fn lamp(node: Node, name: String, zoom: Option<(f64, f64)>, is_rig: bool) -> Result<Lamp, Refusal> {
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
    let is_own = is_rig && (least..=most).contains(&angles[0]) && angles[0] > 0.0;
    let [from, to] = if is_own { [angles[0]; 2] } else { [least, most] };
    let own = match is_own {
        true => format!("the zoom, {least} to {most} degrees, is at the beam angle of the file, {from}"),
        false => format!("the beam angle is that of Zoom, {least} to {most}, not {} degrees", angles[0]),
    };
    let zoomed = |ratio: Option<f64>, note: Option<String>| {
        let end = |beam| [Some(beam), ratio.map(|ratio| beam * ratio)];
        let ([beam, field], widest) = (end(from), Some(end(to)));
        let notes = sheet.notes.iter().cloned().chain([own.clone()]).chain(note).collect();
        Sheet { beam, field, widest, notes, ..sheet.clone() }.lamp()
    };
    // A field angle of another zoom, or of none, says nothing of this one.
    let note = || {
        Some(format!("the field angle, {} degrees, is left out: no cone has it beside this beam", angles[1]))
    };
    zoomed(field.zip(beam).map(|(field, beam)| field / beam), None).or_else(|_| zoomed(None, note()))
}

#[cfg(test)]
mod tests {
    use luminaire::dynamic::AnyLight;
    use rawzip::CompressionMethod;

    use super::super::zip::tests as zips;
    use super::*;

    const DESCRIPTION: &str = include_str!("../../tests/files/description.xml");

    fn zipped(description: &str) -> Vec<u8> {
        zips::zipped(&[("description.xml", description.as_bytes())])
    }

    /// Returns a zip whose `description.xml` is packed by a method.
    fn packed(description: &str, method: CompressionMethod, packed: &[u8]) -> Vec<u8> {
        zips::packed(&[("description.xml", description.as_bytes(), method, packed)])
    }

    #[test]
    fn every_beam_is_a_light_with_the_angles_of_the_zoom() {
        let lamps = read(&zipped(DESCRIPTION)).expect("a fixture");
        let left_out =
            |ring| format!("Two Beams: Ring {ring}: Tip is left out: a beam of the type Glow lights nothing");
        let again = "a `GeometryReference` within what it refers to is left out: 2";
        assert_eq!(lamps.notes, ["gobos: Leaves, Bars", &left_out(1), &left_out(2), again]);
        let [main, dot, other] = &lamps.lamps[..] else { panic!("expected three lights, found {lamps:?}") };
        let names = ["Two Beams: Main", "Two Beams: Ring 1: Dot", "Two Beams: Ring 2: Dot"];
        assert_eq!(([&*main.name, &dot.name, &other.name], dot.light), (names, other.light));
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
        let file = DESCRIPTION
            .replace("BeamType", "LightDistribution=\"a\" BeamType")
            .replace("\"Zoom\"", "\"Pan\"");
        let lamps = read(&zipped(&file.replace("\"20\"", "\"360\""))).expect("a fixture");
        assert!(lamps.lamps[0].notes.iter().any(|note| note == "`LightDistribution` is not read"));
        let AnyLight::Point(globe) = lamps.lamps[1].light else { panic!("expected a point light") };
        let candela = 10_000.0 / (4.0 * std::f64::consts::PI);
        assert!((lamps.lamps[1].own_intensity() - candela).abs() < 0.01, "{globe:?}");
        let none = read(&zipped(&file.replace("<Beam", "<Geometry"))).expect("a fixture");
        assert!(
            none.lamps.is_empty()
                && none.notes.iter().any(|note| note.contains("no geometry of the type Beam"))
        );
    }

    /// Returns the position and the axis of each light of a description.
    fn places(lamps: &Lamps) -> Vec<[[f32; 3]; 2]> {
        let place = |lamp: &Lamp| match &lamp.light {
            AnyLight::Spot(spot) => {
                let axis = <[f32; 3]>::from(spot.given_axis());
                // Of a given axis the direction counts.
                let longest = axis.into_iter().fold(0.0, |longest: f32, x| longest.max(x.abs()));
                [spot.position().into(), axis.map(|x| x / longest + 0.0)]
            }
            other => panic!("expected a spotlight, found {other:?}"),
        };
        lamps.lamps.iter().map(place).collect()
    }

    const MOVED: &str = "Position=\"{1,0,0,0.5}{0,1,0,0.25}{0,0,1,-2}{0,0,0,1}\"";
    /// A turn by 90 degrees about x, which takes the beam, along -z, to y.
    const TURNED: &str = "Position=\"{1,0,0,0}{0,0,-1,0}{0,1,0,1}{0,0,0,1}\"";

    /// The matrices above a beam are multiplied, and z, which is up in the file, is y.
    #[test]
    fn beams_are_where_their_geometries_are() {
        let at = |change: &[(&str, String)]| {
            let file =
                change.iter().fold(DESCRIPTION.to_owned(), |file, (from, to)| file.replacen(from, to, 1));
            places(&read(&zipped(&file)).expect("a fixture"))
        };
        let down = [0.0, -1.0, 0.0];
        assert_eq!(at(&[]), [[[0.0; 3], down]; 3]);
        let [yoke, head, ring, pixel, dot] =
            ["\"Yoke\"", "\"Head\"", "\"Ring 2\"", "Name=\"Pixel\"", "\"Dot\""]
                .map(|name| move |own: &str| (name, format!("{name} {own}")));
        // The turned head is moved with its parent, and its 1 m up stays up.
        let along = [0.0, 0.0, -1.0];
        assert_eq!(at(&[yoke(MOVED), head(TURNED)]), [[[0.5, -1.0, -0.25], along]; 3]);
        // What is within it is moved in its axes.
        assert_eq!(at(&[yoke(TURNED), head(MOVED)]), [[[0.5, 1.25, -2.0], along]; 3]);
        // A reference moves what it refers to, and takes the place of the position of the tree.
        let moved = [[0.5, -2.0, -0.25], down];
        assert_eq!(at(&[ring(MOVED)]), [[[0.0; 3], down], [[0.0; 3], down], moved]);
        assert_eq!(at(&[ring(MOVED), pixel(TURNED)])[2], moved);
        assert_eq!(at(&[ring(MOVED), dot(MOVED)])[2], [[1.0, -4.0, -0.5], down]);
        for text in [
            "",
            "{1,0,0}",
            "{1,0,0,0}{0,1,0,0}{0,0,1,inf}{0,0,0,1}",
            "{1,0,0,0}{0,1,0,0}{0,0,1,0}{0,0,0,1}{1}",
        ] {
            let file = DESCRIPTION.replace("\"Head\"", &format!("\"Head\" Position=\"{text}\""));
            let lamps = read(&zipped(&file)).expect("a fixture");
            let refusal = &lamps.refused[0];
            assert!(lamps.lamps.is_empty() && refusal.parameter == "Position", "{lamps:?}");
            assert!(refusal.place.ends_with("Axis[Head]"), "{refusal}");
        }
        let flat =
            DESCRIPTION.replace("\"Head\"", "\"Head\" Position=\"{1,0,0,0}{0,1,0,0}{0,0,0,0}{0,0,0,1}\"");
        assert_eq!(read(&zipped(&flat)).expect("a fixture").refused.len(), 3);
    }

    /// A mode has the beams of its own geometry, and a rig one zoom of each.
    #[test]
    fn modes_have_their_own_beams() {
        let modes = "<DMXMode Name=\"Empty\" Geometry=\"Bare\"/><DMXMode Name=\"One\" Geometry=\"Pixel\"/><DMXMode Name=\"All\">";
        let file = DESCRIPTION
            .replace("<DMXMode>", modes)
            .replace("</Geometries>", "<Geometry Name=\"Bare\"/></Geometries>");
        let names = |rig| {
            let lamps = beams(&file, rig).expect("a fixture");
            (lamps.lamps.iter().map(|lamp| lamp.name.clone()).collect::<Vec<_>>(), lamps.notes)
        };
        assert_eq!(names(None).0, ["Two Beams: Dot"], "the first mode with a beam");
        assert_eq!(names(Some("One")).0, ["Dot"]);
        assert_eq!(names(Some("All")).0, ["Main", "Ring 1: Dot", "Ring 2: Dot"]);
        assert!(names(Some("")).0.is_empty() && names(Some("Empty")).0.is_empty());
        let (none, notes) = names(Some("Other"));
        assert!(
            none.is_empty()
                && notes.iter().any(|note| note.contains("mode `Other`: the one that is read is Empty")),
            "{notes:?}"
        );
        let main = |text: &str| beams(text, Some("All")).expect("a fixture").lamps.swap_remove(0);
        for (angle, zoom) in [("10", 10.0), ("8", 8.0), ("40", 40.0), ("41", 8.0), ("0", 8.0)] {
            let lamp = main(&file.replace("BeamAngle=\"10\"", &format!("BeamAngle=\"{angle}\"")));
            let AnyLight::Spot(spot) = lamp.light else { panic!("expected a spotlight") };
            assert_eq!(spot.cone().beam().to_degrees().round(), zoom, "{angle}");
        }
    }

    #[test]
    fn references_and_beams_are_bounded() {
        let unknown = DESCRIPTION.replace("Ring 1\" Geometry=\"Pixel\"", "Ring 1\" Geometry=\"Pixels\"");
        let lamps = read(&zipped(&unknown)).expect("a fixture");
        assert_eq!((lamps.lamps.len(), &*lamps.refused[0].value), (2, "Pixels"));
        // Of three beams two are those of Pixel, which is there twice.
        let more = |count: usize| {
            DESCRIPTION.replace("<Beam Name=\"Main\"", &("<Beam/>".repeat(count) + "<Beam Name=\"Main\""))
        };
        assert!(read(&zipped(&more(995))).is_ok());
        assert_eq!(read(&zipped(&more(996))).unwrap_err().expected, "at most 1000");
        // Each tree refers twice to the next one.
        let tree = |i: usize| {
            format!(
                "<Geometry Name=\"{i}\">{}</Geometry>",
                format!("<GeometryReference Geometry=\"{}\"/>", i + 1).repeat(2)
            )
        };
        let trees: String = (0..40).map(tree).collect();
        let file = format!(
            "<GDTF><FixtureType><Geometries>{trees}<Geometry Name=\"40\"/></Geometries></FixtureType></GDTF>"
        );
        assert_eq!(read(&zipped(&file)).unwrap_err().parameter, "geometries");
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
        assert_eq!(read(&zipped(&deep)).map(|lamps| lamps.lamps.len()), Ok(3));
        let texts = ["<a>".repeat(10_000), "<a/>".repeat(200_001), format!("<a{}/>", " b=''".repeat(257))];
        let entity = "<!DOCTYPE a [<!ENTITY b \"c\">]><a>&b;</a>".to_owned();
        for (text, word) in texts.iter().chain([&entity]).zip(["well-formed", "200000", "256", "at most 0"]) {
            assert!(read(&zipped(text)).is_err_and(|refusal| refusal.expected.contains(word)), "{word}");
        }
    }
}
