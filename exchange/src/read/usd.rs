//! Stages of USD as text: `.usda`, with the lights of UsdLux.

use glam::{DAffine3, DQuat, DVec3};

use super::Found;
use super::scene::{Block, Scan, System, add, among, lights, numbers, rotation};
use crate::record::Kind;
use crate::refusal::Refusal;

const SYSTEM: System = System {
    kinds: ["DiskLight", "SphereLight", "DistantLight", OTHERS],
    axis: DVec3::NEG_Z,
    keys: "intensity exposure color radius angle normalize treatAsPoint shaping:focus shaping:cone:angle \
           shaping:cone:softness",
    others: "diffuse=1 specular=1 enableColorTemperature=0 shaping:focusTint=0 shaping:ies:file=",
    off: "active=false visibility=invisible specifier=class specifier=over",
    outside: "references payload inherits specializes subLayers variantSet",
};
const OTHERS: &str = "RectLight CylinderLight DomeLight DomeLight_1 GeometryLight PortalLight MeshLightAPI";

/// Returns the lights, with the names of UsdLux without `inputs:` as keys.
///
/// A `SphereLight` with a cone of less than 180 degrees is a spotlight, as is a `DiskLight`, which has
/// the key `disk` = 1.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    if !text.starts_with("#usda") {
        return Err(Refusal::new("file", "not #usda", "text: `usdcat -o file.usda` and the file write it"));
    }
    let (mut scan, mut blocks, mut open, mut name) = (Scan::new(text), vec![Block::default()], vec![0], "");
    while let Some(token) = scan.next() {
        let above = *open.last().ok_or_else(|| scan.unmatched())?;
        match token {
            "def" | "over" | "class" => {
                let (line, mut kind, mut name) = (scan.line(), "", scan.next());
                while let Some(word) = name.filter(|word| !word.starts_with('"')) {
                    (kind, name) = (word, scan.next());
                }
                let name = name.unwrap_or("").trim_matches('"');
                let mut block = Block { kind, name, line, parents: vec![above], ..Block::default() };
                block.values.insert("specifier", token);
                open.push(add(&mut blocks, block)?);
            }
            // The metadata of a prim has values, too.
            "=" => drop(blocks[above].values.insert(name, scan.value())),
            "}" => drop(open.pop()),
            word if !word.starts_with('"') => name = word.strip_prefix("inputs:").unwrap_or(word),
            _ => {}
        }
    }
    if open.len() != 1 {
        return Err(scan.unmatched());
    }
    for block in &mut blocks {
        if block.get("xformOpOrder").contains("!resetXformStack!") {
            block.parents.clear();
        }
        if block.get("apiSchemas").contains("\"MeshLightAPI\"") {
            block.kind = "MeshLightAPI";
        }
    }
    let mut found = lights(&SYSTEM, &blocks, local, |block, record| {
        if block.kind == "DiskLight" {
            record.number("disk", 1.0);
        }
        if block.get("apiSchemas").contains("\"ShapingAPI\"") && !record.has("shaping:cone:angle") {
            record.number("shaping:cone:angle", 90.0);
        }
        let cone = record.clone().get("shaping:cone:angle", 180.0)?;
        if record.kind == Kind::Point && cone < 180.0 {
            record.kind = Kind::Spot;
        }
        // Time samples and connections are values of a name with a suffix.
        let varying = block.values.keys().filter_map(|key| key.split_once('.'));
        for (key, _) in varying.filter(|(key, _)| among(SYSTEM.keys, key)) {
            record.note(format!("`{key}` changes or is connected: its default is read"));
            if !record.has(key) {
                return Err(block.refused(key, "a default value"));
            }
        }
        Ok(())
    })?;
    for key in ["metersPerUnit", "upAxis"].into_iter().filter(|key| blocks[0].has(key)) {
        found.notes.push(format!("positions are those of the stage, with {key} = {}", blocks[0].get(key)));
    }
    Ok(found)
}

/// Returns the transform of a prim.
fn local(block: &Block) -> Result<DAffine3, Refusal> {
    let order = block.get("xformOpOrder");
    let arc = |key: &&str| among("references payload inherits specializes", key);
    if block.kind == "PointInstancer" || order.is_empty() && block.values.keys().any(arc) {
        return Err(
            block.refused("xformOpOrder", "a transform in this file, not in a reference or instancer")
        );
    }
    let mut local = DAffine3::IDENTITY;
    for op in order.split('"').skip(1).step_by(2).filter(|op| *op != "!resetXformStack!") {
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
