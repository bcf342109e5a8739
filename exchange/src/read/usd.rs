//! Stages of USD as text: `.usda`, with the lights of UsdLux.

use glam::{DAffine3, DQuat, DVec3};

use super::Found;
use super::scene::{
    Block, Scan, System, USD, add, among, is_text, lights, numbers, rotation, texts, unquoted,
};
use crate::record::{Kind, Profile, Record};
use crate::refusal::Refusal;

const SYSTEM: System = System {
    kinds: ["DiskLight", "SphereLight", "DistantLight", "DomeLight DomeLight_1", OTHERS],
    axis: DVec3::NEG_Z,
    keys: "inputs:intensity inputs:exposure inputs:color inputs:radius inputs:angle inputs:normalize treatAsPoint \
           inputs:shaping:focus inputs:shaping:cone:angle inputs:shaping:cone:softness inputs:enableColorTemperature \
           inputs:colorTemperature",
    others: "inputs:diffuse=1 inputs:specular=1 inputs:shaping:focusTint=0,0,0 \
             collection:lightLink:includes= collection:lightLink:excludes=",
    never: "",
    off: "active=false visibility=invisible",
    outside: "references payload inherits specializes subLayers variantSet",
};
/// The photometric file of a light.
const PROFILE: &str = "inputs:shaping:ies:file";
/// The values beside those of lights and transforms whose samples are read.
const OWN: &str = "visibility inputs:shaping:ies:file";
const OTHERS: &str = "RectLight CylinderLight GeometryLight PortalLight MeshLightAPI";

/// Returns the lights, with the names of UsdLux without `inputs:` as keys, and `displayName` as the name of a prim that
/// has it.
///
/// A `SphereLight` with a cone of less than 180 degrees is a spotlight, as is a `DiskLight`, which has
/// the key `disk` = 1. Of a value that changes over time the default is read, and without one the first
/// sample.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    if !text.starts_with("#usda") {
        return Err(Refusal::new("file", "not #usda", "text: `usdcat -o file.usda` and the file write it"));
    }
    let (mut scan, mut blocks, mut open) = (Scan::new(text, &USD), vec![Block::default()], vec![0]);
    // Whether the metadata are those of a prim, which has not yet begun, and not those of an attribute.
    let (mut name, mut is_heading) = ("", false);
    while let Some(token) = scan.next() {
        let above = *open.last().ok_or_else(|| scan.unmatched())?;
        match token {
            "def" | "over" | "class" => {
                let (line, mut kind, mut name) = (scan.line(), "", scan.next());
                while let Some(word) = name.filter(|word| !is_text(word)) {
                    (kind, name) = (word, scan.next());
                }
                let (name, off, parents) = (unquoted(name.unwrap_or("")), token != "def", vec![above]);
                open.push(add(&mut blocks, Block { kind, name, line, parents, off, ..Block::default() })?);
                is_heading = true;
            }
            // The metadata of a prim has values, too.
            "=" => blocks[above].values.insert(name, scan.value()),
            "(" if above != 0 && !is_heading => drop(scan.group(1)),
            "{" => is_heading = false,
            "}" => drop(open.pop()),
            word if !is_text(word) => name = word,
            _ => {}
        }
    }
    if open.len() != 1 {
        return Err(scan.unmatched());
    }
    scan.whole()?;
    let mut animated = None;
    for block in &mut blocks {
        for name in block.values.names().collect::<Vec<_>>() {
            let is_read =
                |key: &&str| among(SYSTEM.keys, key) || key.starts_with("xformOp:") || among(OWN, key);
            let Some(key) = name.strip_suffix(".timeSamples").filter(is_read) else { continue };
            animated = Some(key.strip_prefix("inputs:").unwrap_or(key));
            if !block.has(key) {
                // `{ time: value, ... }`
                let mut samples = Scan::new(block.get(name), &USD);
                samples.find(|token| token.ends_with(':'));
                block.values.insert(key, samples.value());
            }
        }
        block.values.sort();
        block.name = block.values.get("displayName").unwrap_or(block.name);
        if texts(block.get("xformOpOrder")).any(|op| op == "!resetXformStack!") {
            block.parents.clear();
        }
        if texts(block.get("apiSchemas")).any(|schema| schema == "MeshLightAPI") {
            block.kind = "MeshLightAPI";
        }
    }
    let mut found = lights(&SYSTEM, &blocks, local, |block, record| {
        if record.kind == Kind::Ambient && !block.get("inputs:texture:file").is_empty() {
            return Err(block.refused("inputs:texture:file", "a dome of one colour, without a texture"));
        }
        if block.kind == "DiskLight" {
            record.number("disk", 1.0);
        }
        let is_shaped = texts(block.get("apiSchemas")).any(|schema| schema == "ShapingAPI");
        if is_shaped && !record.has("shaping:cone:angle") {
            record.number("shaping:cone:angle", 90.0);
        }
        let cone = record.clone().get("shaping:cone:angle", 180.0)?;
        if record.kind == Kind::Point && cone < 180.0 {
            record.kind = Kind::Spot;
        }
        for key in
            SYSTEM.keys.split(' ').filter(|key| block.values.names().any(|name| is_connection(name, key)))
        {
            let own = key.strip_prefix("inputs:").unwrap_or(key);
            record.note(format!("`{own}` is connected: its default is read"));
            if !record.has(own) {
                return Err(block.refused(own, "a default value"));
            }
        }
        let bare = SYSTEM.keys.split(' ').filter_map(|key| key.strip_prefix("inputs:"));
        for key in bare.filter(|key| block.has(key)) {
            record.note(format!("`{key}` without `inputs:` is left out, as by USD from 21.02 on"));
        }
        shape(block, record)
    })?;
    found.notes.extend(animated.map(|key| {
        format!("values change over time, such as `{key}`: the default of each is read, or the first sample")
    }));
    for key in ["metersPerUnit", "upAxis"].into_iter().filter(|key| blocks[0].has(key)) {
        found.notes.push(format!("positions are those of the stage, with {key} = {}", blocks[0].get(key)));
    }
    Ok(found)
}

/// Sets the profile of a light. What renderers make of a scale of its angles differs.
fn shape(block: &Block, record: &mut Record) -> Result<(), Refusal> {
    let file = block.get(PROFILE);
    if file.is_empty() {
        return Ok(());
    }
    let [scale] = block.numbers("inputs:shaping:ies:angleScale", [0.0])?;
    let [normalize] = block.numbers("inputs:shaping:ies:normalize", [0.0])?;
    if matches!(record.kind, Kind::Directional | Kind::Ambient) || scale != 0.0 {
        let why = if scale == 0.0 { "the light has no place" } else { "`shaping:ies:angleScale` is not 0" };
        record.note(format!("its IES profile {file:?} is left out: {why}"));
        return Ok(());
    }
    let profile = Profile {
        file: file.to_owned(),
        content: None,
        part: None,
        is_normalized: normalize != 0.0,
        without: Some(record.clone()),
    };
    record.profile = Some(Box::new(profile));
    if normalize != 0.0 {
        record.note("`shaping:ies:normalize`: the flux is that of the light without its profile");
    }
    Ok(())
}

fn is_connection(name: &str, key: &str) -> bool {
    name.strip_prefix(key).is_some_and(|rest| rest.starts_with('.') && rest != ".timeSamples")
}

/// Returns the transform of a prim.
fn local(block: &Block) -> Result<DAffine3, Refusal> {
    let order = block.get("xformOpOrder");
    let arc = |key: &&str| among("references payload inherits specializes", key);
    if block.kind == "PointInstancer" || order.is_empty() && block.values.names().any(|name| arc(&name)) {
        return Err(
            block.refused("xformOpOrder", "a transform in this file, not in a reference or instancer")
        );
    }
    let mut local = DAffine3::IDENTITY;
    for op in texts(order).filter(|op| *op != "!resetXformStack!") {
        let name = op.strip_prefix("!invert!").unwrap_or(op);
        let (kind, angles) = (name.split(':').nth(1).unwrap_or(""), numbers(block.get(name)));
        let refused = || block.refused(name, "the numbers of a known transform");
        let step = match (kind, &*angles) {
            ("translate", &[x, y, z]) => DAffine3::from_translation(DVec3::new(x, y, z)),
            ("scale", &[x, y, z]) => DAffine3::from_scale(DVec3::new(x, y, z)),
            ("orient", &[w, x, y, z]) => DAffine3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize()),
            ("transform", [_, ..]) => block.matrix(name)?,
            // The angles are those of x, y and z; the first letter turns first.
            (_, [angle]) | (_, [angle, _, _]) if kind.len() == "rotate".len() + angles.len() => {
                let mut turned = DAffine3::IDENTITY;
                for letter in kind.strip_prefix("rotate").ok_or_else(refused)?.chars() {
                    let axis = "XYZ".find(letter).ok_or_else(refused)?;
                    let angle = angles.get(axis).unwrap_or(angle).to_radians();
                    turned = rotation(DVec3::AXES[axis], angle) * turned;
                }
                turned
            }
            _ => return Err(refused()),
        };
        local *= if name == op { step } else { step.inverse() };
    }
    Ok(local)
}
