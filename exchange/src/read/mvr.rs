//! MVR files (DIN SPEC 15801): zips with a `GeneralSceneDescription.xml`, whose fixtures have the beams of GDTF files
//! in the zip.

use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use glam::{DAffine3, DMat3, DVec3};
use luminaire::Rgb;
use roxmltree::Node;

use super::gdtf::{self, rows, upright};
use super::zip::{Entry, Zip};
use super::{LIGHTS, xml};
use crate::lamp::{Lamp, Lamps};
use crate::refusal::Refusal;
use crate::system::System;
use crate::text::decode;

/// The most bytes of a GDTF file that is packed, which bounds the memory.
const PACKED: usize = 32 << 20;
/// The most bytes that are unpacked of all files, and the most files and modes, which bound the time.
const UNPACKED: usize = 256 << 20;
const TYPES: usize = 256;

/// A fixture of a rig.
#[derive(Clone)]
struct Fixture {
    name: String,
    /// The path of its GDTF file, and the mode.
    file: String,
    mode: String,
    /// From the fixture to the world, z up in metres.
    world: DAffine3,
    /// The identifier of the point at which it is aimed.
    focus: String,
    /// The part of each channel of linear sRGB that its gel passes.
    gel: Rgb<f32>,
}

impl Fixture {
    /// Returns the file and the mode, for notes.
    fn label(&self) -> String {
        let mode = if self.mode.is_empty() { String::new() } else { format!(" ({})", self.mode) };
        format!("{}{mode}", self.file)
    }
}

/// What a scene has.
#[derive(Default)]
struct Scene {
    fixtures: Vec<Fixture>,
    /// Places by their identifiers.
    points: HashMap<String, DVec3>,
    refused: Vec<Refusal>,
    /// How many fixtures have something that is not read.
    unread: BTreeMap<&'static str, usize>,
}

/// Reads the lights of a rig, y up in metres: of each fixture the beams of its mode.
///
/// A matrix is that of DIN SPEC 15801: `{u}{v}{w}{o}`, right-handed with z up, in millimetres, from an object to the
/// one around it. A fixture that has no light is left out with a note.
///
/// # Errors
/// No zip with a scene, a scene that is not well-formed, has a DTD or is over the limits, or more than 10,000 lights.
pub(crate) fn read(bytes: &[u8]) -> Result<Lamps, Refusal> {
    const SCENE: &str = "GeneralSceneDescription.xml";
    let zip = Zip::open(["MVR file", "a zip with a GeneralSceneDescription.xml"], bytes)?;
    let text = zip.unpack(zip.file(SCENE)?, xml::LARGEST).and_then(|text| decode(&text));
    // The tree is dropped before a fixture is read.
    let scene = text.and_then(|text| Scene::new(xml::document(&text)?.root_element()));
    let Scene { fixtures, points, refused, unread } = scene.map_err(|refusal| refusal.at(SCENE))?;
    let mut lamps = Lamps { refused, ..Lamps::new(System::Mvr) };
    let mut types = Types::new(&zip)?;
    let [mut fixture_names, mut names] = [HashMap::new(), HashMap::new()];
    let mut left_out: BTreeMap<String, (usize, Vec<String>)> = BTreeMap::new();
    for fixture in fixtures {
        let (found, mut notes) = match types.lamps(&fixture, &mut lamps) {
            Ok(found) => found,
            Err(why) => {
                let (count, few) = left_out.entry(why).or_default();
                *count += 1;
                few.extend((*count <= 3).then_some(fixture.name));
                continue;
            }
        };
        if lamps.lamps.len() + lamps.refused.len() + found.len() > LIGHTS {
            let expected = format_args!("at most {LIGHTS}: export a part of the rig");
            return Err(Refusal::new("lights", "more", expected));
        }
        let focus = points.get(&fixture.focus).copied().map(above);
        let name = unique(&fixture.name, &mut fixture_names);
        for lamp in found.iter() {
            let own = if found.len() == 1 { name.clone() } else { format!("{name}: {}", lamp.name) };
            let own =
                Lamp { name: unique(&own, &mut names), notes: std::mem::take(&mut notes), ..lamp.clone() };
            let own = own.moved(upright(fixture.world)).and_then(|own| own.aimed(focus));
            match own.and_then(|own| own.behind(fixture.gel)) {
                Ok(own) => lamps.lamps.push(own),
                Err(refusal) => lamps.refused.push(refusal.at(&name)),
            }
        }
    }
    for (why, (count, few)) in left_out {
        let (few, more) = (few.join(", "), if count > 3 { ", ..." } else { "" });
        lamps.notes.push(format!("fixtures left out: {count} ({few}{more}), because {why}"));
    }
    let unread = unread.iter().map(|(what, count)| format!("fixtures whose {what}: {count}"));
    lamps.notes.extend(unread);
    Ok(lamps)
}

/// Returns a place with z up as one with y up.
fn above(place: DVec3) -> DVec3 {
    DVec3::new(place.x, place.z, -place.y)
}

/// Returns a name that no other light has. `names` are those that are taken, with the last number behind each.
fn unique(name: &str, names: &mut HashMap<String, usize>) -> String {
    let Some(last) = names.get(name).copied() else {
        names.insert(name.to_owned(), 1);
        return name.to_owned();
    };
    let mut number = last + 1;
    while names.contains_key(&format!("{name} {number}")) {
        number += 1;
    }
    let own = format!("{name} {number}");
    names.extend([(name.to_owned(), number), (own.clone(), 1)]);
    own
}

/// The lights of a type, or why it has none.
type Own = Result<Rc<[Lamp]>, String>;

/// The GDTF files of a rig, each of whose modes is read once.
struct Types<'a> {
    zip: &'a Zip<'a>,
    files: HashMap<String, Entry>,
    known: HashMap<(String, String), Own>,
    /// How many bytes may still be unpacked.
    left: usize,
}

impl<'a> Types<'a> {
    fn new(zip: &'a Zip<'a>) -> Result<Self, Refusal> {
        let mut files = HashMap::new();
        zip.each(|path, entry| {
            let path = String::from_utf8_lossy(path).to_lowercase();
            if path.ends_with(".gdtf") {
                files.insert(path, entry);
            }
        })?;
        Ok(Self { zip, files, known: HashMap::new(), left: UNPACKED })
    }

    /// Returns the lights of a fixture in its own axes, and with the first fixture of a type what is to note of it; or why
    /// there is no light.
    fn lamps(&mut self, fixture: &Fixture, all: &mut Lamps) -> Result<(Rc<[Lamp]>, Vec<String>), String> {
        if fixture.file.is_empty() {
            return Err("no GDTF file is named".to_owned());
        }
        let file = fixture.file.to_lowercase();
        let path =
            [file.clone(), format!("{file}.gdtf")].into_iter().find(|path| self.files.contains_key(path));
        let none = || format!("the zip has no file `{file:.80}`: export the rig with its GDTF files");
        let key = (path.ok_or_else(none)?, fixture.mode.clone());
        if let Some(known) = self.known.get(&key) {
            return known.clone().map(|lamps| (lamps, Vec::new()));
        }
        if self.known.len() >= TYPES {
            return Err(format!("a rig has at most {TYPES} types and modes: export a part of it"));
        }
        let entry = self.files[&key.0];
        let found = self.unpack(entry).and_then(|text| gdtf::beams(&text, Some(&fixture.mode)));
        let (found, notes) = match found {
            Ok(mut found) => {
                all.refused.extend(found.refused.drain(..).map(|refusal| refusal.at(fixture.label())));
                noted(&fixture.label(), found)
            }
            Err(refusal) => {
                // That of another mode is the same.
                let refusal = refusal.at(&key.0);
                let is_known = all.refused.contains(&refusal);
                all.refused.extend((!is_known).then_some(refusal));
                Default::default()
            }
        };
        let lamps: Own = if found.is_empty() {
            all.notes.extend(notes.iter().cloned());
            Err(format!("{} has no light", fixture.label()))
        } else {
            Ok(found.into())
        };
        self.known.insert(key, lamps.clone());
        lamps.map(|lamps| (lamps, notes))
    }

    /// Returns the description of a GDTF file. What is not packed is not copied.
    fn unpack(&mut self, entry: Entry) -> Result<String, Refusal> {
        let packed =
            self.zip.unpack(entry, if entry.is_stored() { usize::MAX } else { PACKED.min(self.left) })?;
        let copied = if entry.is_stored() { 0 } else { packed.len() };
        let text = gdtf::description(&packed, xml::LARGEST.min(self.left))?;
        self.left = self.left.saturating_sub(copied + text.len());
        Ok(text)
    }
}

/// Returns the lights of a type, and what is to note of it and of them, once for all lights of which it holds.
fn noted(label: &str, found: Lamps) -> (Vec<Lamp>, Vec<String>) {
    let (mut lamps, mut notes) = (found.lamps, Vec::<(String, &str, usize)>::new());
    let mut places = HashMap::new();
    let own: Vec<_> = lamps.iter_mut().map(|lamp| std::mem::take(&mut lamp.notes)).collect();
    for (lamp, note) in
        lamps.iter().zip(own).flat_map(|(lamp, own)| own.into_iter().map(move |own| (lamp, own)))
    {
        let place = *places.entry(note.clone()).or_insert(notes.len());
        match notes.get_mut(place) {
            Some((.., count)) => *count += 1,
            None => notes.push((note, &lamp.name, 1)),
        }
    }
    let own = notes.into_iter().map(|(note, name, count)| match count {
        1 => format!("{label}: {name}: {note}"),
        _ => format!("{label}: {name} and {} more: {note}", count - 1),
    });
    let all = found.notes.iter().map(|note| format!("{label}: {note}")).chain(own).collect();
    lamps.iter_mut().for_each(|lamp| lamp.widest = None);
    (lamps, all)
}

impl Scene {
    /// Finds the fixtures of a scene and the points at which they are aimed.
    fn new(root: Node) -> Result<Self, Refusal> {
        let mut scene = Self::default();
        if !root.has_tag_name("GeneralSceneDescription") {
            let name = format!("{:.80}", root.tag_name().name());
            return Err(Refusal::new("root element", name, "GeneralSceneDescription"));
        }
        let layers = root.children().filter(|node| node.has_tag_name("Scene"));
        let layers = layers.flat_map(|node| node.children()).filter(|node| node.has_tag_name("Layers"));
        // A refusal is that of everything below, and shared.
        let world = || Ok::<_, Rc<Refusal>>(DAffine3::IDENTITY);
        let mut waiting: Vec<_> = layers.map(|node| (node, world())).collect();
        waiting.reverse();
        while let Some((node, above)) = waiting.pop() {
            let world = above.and_then(|above| Ok(above * matrix(node)?));
            match (node.tag_name().name(), &world) {
                ("Fixture", Ok(world)) => scene.fixture(node, *world),
                ("Fixture", Err(refusal)) => {
                    scene.refused.push(Refusal::clone(refusal).at(named(node)));
                }
                ("FocusPoint", Ok(world)) => {
                    let own = node.attribute("uuid").unwrap_or_default().to_lowercase();
                    // A fixture without a focus names none.
                    if !own.is_empty() {
                        scene.points.insert(own, world.translation);
                    }
                }
                _ => {}
            }
            if scene.fixtures.len() + scene.refused.len() > LIGHTS {
                let expected = format_args!("at most {LIGHTS}: export a part of the rig");
                return Err(Refusal::new("fixtures", "more", expected));
            }
            let below = node.children().rev().filter(Node::is_element);
            waiting.extend(below.map(|node| (node, world.clone())));
        }
        Ok(scene)
    }

    fn fixture(&mut self, node: Node, world: DAffine3) {
        let text = |key| child(node, key).and_then(|node| node.text()).unwrap_or_default().trim();
        let cut = |key| text(key).chars().take(200).collect::<String>();
        let [file, mode] = ["GDTFSpec", "GDTFMode"].map(cut);
        let (focus, gel) = (cut("Focus").to_lowercase(), gel(text("Color")));
        let has_commands = child(node, "CustomCommands").is_some_and(|node| node.has_children());
        for (what, is_there) in [
            ("colour is not read", gel.is_none()),
            ("gobo is not read", !text("Gobo").is_empty()),
            ("commands, such as pan and tilt, are not read", has_commands),
        ] {
            if is_there {
                *self.unread.entry(what).or_default() += 1;
            }
        }
        let gel = gel.unwrap_or(WHITE);
        self.fixtures.push(Fixture { name: named(node), file, mode, world, focus, gel });
    }
}

/// Returns the name of a fixture, or its number.
fn named(node: Node) -> String {
    let number = child(node, "FixtureID").and_then(|node| node.text());
    let name = node.attribute("name").map(str::trim).filter(|name| !name.is_empty());
    let name = name.or_else(|| number.map(str::trim)).unwrap_or("fixture");
    name.chars().take(80).collect()
}

fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    node.children().find(|node| node.has_tag_name(name))
}

/// What no gel passes of each channel.
const WHITE: Rgb<f32> = Rgb::new(1.0, 1.0, 1.0);

/// Returns what a gel passes of each channel, by its colour in CIE xyY, such as `0.3127, 0.3290, 100.0`, the white of D65
/// of a fixture without a gel; `None` if the text is no such colour.
fn gel(text: &str) -> Option<Rgb<f32>> {
    if text.is_empty() {
        return Some(WHITE);
    }
    let numbers: Vec<f32> = text.split(',').map_while(|word| word.trim().parse().ok()).collect();
    let [x, y, percent] = numbers[..] else { return None };
    let color = Rgb::from_chromaticity(x, y).ok()?;
    let is_near = |(own, white): (f32, f32)| (own - white).abs() <= 1e-3;
    if [(x, 0.3127), (y, 0.329), (percent, 100.0)].into_iter().all(is_near) {
        return Some(WHITE);
    }
    (0.0..=100.0).contains(&percent).then(|| color.map(|channel| channel * percent / 100.0))
}

/// Returns the transform from an object to the one around it, in metres; without one, they are at one place.
fn matrix(node: Node) -> Result<DAffine3, Refusal> {
    let Some(text) = child(node, "Matrix").map(|node| node.text().unwrap_or_default()) else {
        return Ok(DAffine3::IDENTITY);
    };
    let expected = "12 finite numbers, such as {1,0,0}{0,1,0}{0,0,1}{0,0,0}";
    let rows = rows::<3, 4>(text).ok_or_else(|| Refusal::new("Matrix", text, expected))?;
    let [u, v, w, origin] = rows.map(DVec3::from);
    Ok(DAffine3 { matrix3: DMat3::from_cols(u, v, w), translation: origin / 1_000.0 })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use luminaire::dynamic::AnyLight;

    use super::super::zip::tests::{packed, zipped};
    use super::*;

    const SCENE: &str = include_str!("../../tests/files/GeneralSceneDescription.xml");
    const DESCRIPTION: &str = include_str!("../../tests/files/description.xml");
    const NAME: &str = "GeneralSceneDescription.xml";
    const TWO: &str = "Ours@Two Beams.gdtf";

    fn gdtf(description: &str) -> Vec<u8> {
        zipped(&[("description.xml", description.as_bytes())])
    }

    /// Returns a rig with a fixture that has a mode of one beam, and one without a beam.
    fn rig(scene: &str) -> Vec<u8> {
        let modes = "<DMXMode Name=\"All\"/><DMXMode Name=\"One\" Geometry=\"Pixel\">";
        let two = gdtf(&DESCRIPTION.replace("<DMXMode>", modes));
        let hazer = gdtf("<GDTF><FixtureType Name=\"Hazer\"/></GDTF>");
        zipped(&[(NAME, scene.as_bytes()), (TWO, &two), ("Ours@Hazer.gdtf", &hazer)])
    }

    /// Returns the name, the position and the axis of each light, to a thousandth.
    fn places(lamps: &Lamps) -> Vec<(&str, [f64; 3], [f64; 3])> {
        let round = |v: [f32; 3]| v.map(|x| (1e3 * f64::from(x)).round() / 1e3 + 0.0);
        let place = |lamp: &'_ Lamp| {
            let AnyLight::Spot(spot) = &lamp.light else { panic!("expected a spotlight, found {lamp:?}") };
            let axis = DVec3::from(<[f32; 3]>::from(spot.given_axis()).map(f64::from)).normalize();
            (round(spot.position().into()), round(axis.as_vec3().to_array()))
        };
        lamps.lamps.iter().map(|lamp| (&*lamp.name, place(lamp).0, place(lamp).1)).collect()
    }

    /// The places that a person computes of the matrices, and what has no light.
    #[test]
    fn fixtures_are_where_their_layers_and_groups_have_them() {
        let lamps = read(&rig(SCENE)).expect("a rig");
        let (spot, aim) = ([0.0, 4.0, 0.0], [0.8, -0.6, 0.0]);
        let expected = [
            ("Wash", [1.0, 6.0, -5.0], [0.0, -1.0, 0.0]),
            ("Wash 2", [1.0, 6.0, -2.0], [-1.0, 0.0, 0.0]),
            ("Spot: Main", spot, aim),
            ("Spot: Ring 1: Dot", spot, aim),
            ("Spot: Ring 2: Dot", spot, aim),
        ];
        assert_eq!(places(&lamps), expected);
        assert!(
            lamps.refused.is_empty() && lamps.lamps.iter().all(|lamp| lamp.widest.is_none()),
            "{lamps:?}"
        );
        let own = lamps.lamps.iter().flat_map(|lamp| &lamp.notes);
        let notes: Vec<_> = own.chain(&lamps.notes).cloned().collect();
        let notes = notes.join("\n");
        assert!(lamps.lamps[1].notes.is_empty() && lamps.notes.len() == 4, "{:?}", lamps.notes);
        for note in [
            "Ours@Hazer.gdtf: the fixture has no geometry of the type Beam",
            "ours@two beams.GDTF (Other): there is no mode `Other`: the one that is read is All",
            "ours@two beams.GDTF (Other): Ring 1: Dot and 1 more: LuminousFlux",
            "Ours@Two Beams.gdtf (One): Dot: the zoom, 8 to 40 degrees, is at the beam angle of the file, 20",
            "fixtures left out: 1 (7), because no GDTF file is named",
            "fixtures left out: 1 (Guest), because the zip has no file `guest.gdtf`: export the rig with",
            "fixtures left out: 1 (Hazer), because Ours@Hazer.gdtf has no light",
        ] {
            assert!(notes.contains(note), "expected {note}, found\n{notes}");
        }
    }

    /// The colour of a fixture is a gel before its light, whose white it filters.
    #[test]
    fn colours_are_gels() {
        let of = |color: &str| {
            let scene = SCENE.replace("0.64,0.33,21", color);
            let lamps = read(&rig(&scene)).expect("a rig");
            let is_unread = lamps.notes.iter().any(|note| note == "fixtures whose colour is not read: 1");
            let own = &lamps.lamps[1];
            (
                <[f32; 3]>::from(own.light.color()),
                own.light.intensity(),
                own.kelvin,
                is_unread,
                lamps.refused.len(),
            )
        };
        let (white, intensity, kelvin, ..) = of("");
        assert_eq!(kelvin, Some(6_000.0));
        assert_eq!(of("0.3127, 0.3290, 100.0"), (white, intensity, kelvin, false, 0));
        // The red primary of sRGB of luminance 0.21 passes 98.8 % of red alone.
        let (red, of_red, none, is_unread, _) = of("0.64,0.33,21");
        assert!(red[0] == 1.0 && red[1] + red[2] < 2e-3 && none.is_none() && !is_unread, "{red:?}");
        assert!((of_red / (intensity * white[0]) - 0.21 / 0.2126).abs() < 1e-3, "{of_red} of {intensity}");
        // A grey gel dims.
        let (grey, of_grey, ..) = of("0.3127,0.3290,50");
        assert!((of_grey / intensity - 0.5).abs() < 1e-3 && (grey[2] - white[2]).abs() < 2e-3, "{grey:?}");
        for unread in ["0.3,0.3", "0.3,0,100", "0.3,0.3,101", "red", "0.3,0.3,1,1", "NaN,0.3,1"] {
            let (color, .., is_unread, _) = of(unread);
            assert!(is_unread && color == white, "{unread}");
        }
        assert_eq!(of("0.64,0.33,0").4, 1);
    }

    /// A part of a matrix that cannot be read refuses what is below it, by its name.
    #[test]
    fn bad_matrices_and_files_refuse_their_fixtures() {
        let refused = |from: &str, to: &str| read(&rig(&SCENE.replacen(from, to, 1))).expect("a rig");
        let lamps = refused("{0,1,0}{-1,0,0}", "{0,1,0}{-1,0}");
        assert_eq!(places(&lamps)[0].0, "Spot: Main");
        let refusals: Vec<_> = lamps.refused.iter().map(ToString::to_string).collect();
        assert!(
            refusals.len() == 2 && refusals[0].starts_with("Wash: Matrix = {0,1,0}{-1,0}{0,0,1}"),
            "{refusals:?}"
        );
        let flat = refused("<Matrix>{1,0,0}{0,1,0}{0,0,1}{3000", "<Matrix>{1,0,0}{0,1,0}{0,0,0}{3000");
        assert_eq!((flat.lamps.len(), &*flat.refused[0].place), (4, "Wash"));
        let scaled = refused("<Matrix>{1,0,0}{0,1,0}{0,0,1}{3000", "<Matrix>{2,0,0}{0,2,0}{0,0,2}{3000");
        assert!(
            places(&scaled)[0].2 == [0.0, -1.0, 0.0]
                && scaled.lamps[0].notes.last().is_some_and(|note| note.contains("scale")),
            "{scaled:?}"
        );
        // A damaged fixture is refused once.
        let broken = zipped(&[(NAME, SCENE.as_bytes()), (TWO, b"no zip")]);
        let lamps = read(&broken).expect("a rig");
        let refusals: Vec<_> = lamps.refused.iter().map(ToString::to_string).collect();
        let notes = lamps.notes.join("\n");
        assert!(
            refusals.len() == 1 && refusals[0].starts_with("ours@two beams.gdtf: GDTF file = "),
            "{refusals:?}"
        );
        assert!(notes.contains("fixtures left out: 2 (Wash, Wash), because"), "{notes}");
    }

    #[test]
    fn pieces_and_bombs_are_refused() {
        let whole = rig(SCENE);
        assert!((0..whole.len()).step_by(7).all(|end| read(&whole[..end]).is_err()));
        let none = zipped(&[(TWO, b"")]);
        assert_eq!(
            read(&none).unwrap_err().to_string(),
            "MVR file = a zip without it: expected a zip with a GeneralSceneDescription.xml"
        );
        let entity = "<!DOCTYPE a [<!ENTITY b \"c\">]><GeneralSceneDescription>&b;</GeneralSceneDescription>";
        for (scene, told) in [
            (entity.to_owned(), "GeneralSceneDescription.xml: entities = 1: expected at most 0"),
            ("<a/>".to_owned(), "root element = a: expected GeneralSceneDescription"),
            (" ".repeat(17 << 20), "size = 16777217: expected at most 16777216 bytes"),
            (
                SCENE.replace(
                    "<Fixture uuid=\"7\"><FixtureID>7</FixtureID></Fixture>",
                    &"<Fixture/>".repeat(LIGHTS),
                ),
                "fixtures = more: expected at most 10000",
            ),
            (
                SCENE.replace(
                    "<FocusPoint",
                    &("<Fixture><GDTFSpec>Ours@Two Beams.gdtf</GDTFSpec></Fixture>".repeat(3_334)
                        + "<FocusPoint"),
                ),
                "lights = more: expected at most 10000",
            ),
        ] {
            let refusal = read(&rig(&scene)).unwrap_err().to_string();
            assert!(refusal.contains(told), "expected {told}, found {refusal}");
        }
        // A fixture of 33 MB is refused when it is packed, and read when it is not.
        let mut large = gdtf(DESCRIPTION);
        large.splice(0..0, vec![0; PACKED]);
        let refused = read(&zipped(&[(NAME, SCENE.as_bytes()), (TWO, &large)])).expect("a rig");
        assert!(refused.refused[0].to_string().contains("size = 33554433: expected at most 33554432 bytes"));
        const STORE: rawzip::CompressionMethod = rawzip::CompressionMethod::STORE;
        let stored =
            packed(&[(NAME, SCENE.as_bytes(), STORE, SCENE.as_bytes()), (TWO, &large, STORE, &large)]);
        assert_eq!(read(&stored).expect("a rig").lamps.len(), 9);
    }

    /// A point without an identifier is that of no fixture, and without a mode the first one is read.
    #[test]
    fn fixtures_without_a_focus_or_a_mode_are_at_rest() {
        let scene = SCENE
            .replace("uuid=\"6f\"", "")
            .replace("<Focus>6F</Focus>", "")
            .replace("<GDTFMode>Other", "<GDTFMode>");
        let lamps = read(&rig(&scene)).expect("a rig");
        assert_eq!(places(&lamps)[2], ("Spot: Main", [0.0, 4.0, 0.0], [0.0, -1.0, 0.0]));
        assert!(
            !lamps.lamps.iter().flat_map(|lamp| &lamp.notes).any(|note| note.contains("no mode")),
            "{lamps:?}"
        );
    }

    /// Equal names get numbers, none of which is taken.
    #[test]
    fn names_are_unique() {
        let mut names = HashMap::new();
        let own = ["a", "a 2", "a", "a", "a 2"].map(|name| unique(name, &mut names));
        assert_eq!(own, ["a", "a 2", "a 3", "a 4", "a 2 2"]);
    }

    /// `rig.mvr` is the scene beside it with `fixture.gdtf`: `LUMINAIRE_BLESS=1` writes it.
    #[test]
    fn rig_is_the_zip_of_its_parts() {
        let (files, gdtf) = (
            concat!(env!("CARGO_MANIFEST_DIR"), "/tests/files/"),
            include_bytes!("../../tests/files/fixture.gdtf"),
        );
        let (file, expected) = (format!("{files}rig.mvr"), zipped(&[(NAME, SCENE.as_bytes()), (TWO, gdtf)]));
        if std::env::var_os("LUMINAIRE_BLESS").is_some() {
            fs::write(&file, &expected).expect("a file");
        }
        let lamps = read(&expected).expect("a rig");
        assert_eq!(read(&fs::read(&file).expect("a file")), Ok(lamps.clone()));
        assert_eq!((lamps.lamps.len(), lamps.refused.len()), (9, 0));
    }
}
