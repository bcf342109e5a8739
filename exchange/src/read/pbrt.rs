//! Scenes of pbrt: `.pbrt` of versions 3 and 4.

use std::collections::HashMap;

use glam::{DAffine3, DMat3, DVec3};

use super::Found;
use super::scene::{Block, PBRT, Scan, System, add, among, is_text, lights, rotation, unquoted};
use crate::record::Kind;
use crate::refusal::Refusal;

const SYSTEM: System = System {
    kinds: ["spot", "point", "distant", "infinite", "LightSource"],
    axis: DVec3::Z,
    keys: "coneangle conedeltaangle scale power illuminance I L blackbody",
    others: "",
    never: "",
    off: "",
    outside: "Include Import Attribute AreaLightSource",
};
/// The name of a directive that is inverted.
const INVERSE: &str = "inverse";

/// Returns the lights, with the names of their parameters as keys, in the left-handed world of pbrt.
/// `version` = 3 if the file has a word that version 4 rejects.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    // The nodes are the directives: the parent of each is the one before, as transforms go.
    let (mut scan, mut blocks) = (Scan::new(text, &PBRT), vec![Block::default()]);
    let (mut stack, mut current) = (Vec::new(), 0);
    let mut named = HashMap::from([("world", 0)]);
    while let Some(token) = scan.next() {
        let mut block = Block { kind: token, line: scan.line(), parents: vec![current], ..Block::default() };
        match token {
            "Identity" | "WorldBegin" => current = 0,
            "AttributeBegin" | "TransformBegin" | "ObjectBegin" => stack.push(current),
            "AttributeEnd" | "TransformEnd" | "ObjectEnd" => {
                current = stack.pop().ok_or_else(|| scan.unmatched())?;
            }
            "Translate" | "Scale" | "Rotate" | "LookAt" | "ConcatTransform" | "Transform" => {
                block.values.insert(token, scan.numbers());
                block.parents = vec![if token == "Transform" { 0 } else { current }];
                current = add(&mut blocks, block)?;
            }
            "CoordinateSystem" => drop(named.insert(unquoted(scan.value()), current)),
            "Camera" => {
                // From the camera to the world: the directives from the last to the first, each inverted.
                let (mut next, mut camera) = (current, 0);
                while next != 0 {
                    let Block { kind, line, .. } = blocks[next];
                    let name = if blocks[next].name == INVERSE { "" } else { INVERSE };
                    let mut step = Block { kind, line, name, parents: vec![camera], ..Block::default() };
                    step.values.insert(kind, blocks[next].values.get(kind).unwrap_or(""));
                    camera = add(&mut blocks, step)?;
                    next = blocks[next].parents[0];
                }
                named.insert("camera", camera);
            }
            "CoordSysTransform" if scan.peek().is_some_and(|name| named.contains_key(unquoted(name))) => {
                current = named[unquoted(scan.value())];
            }
            "CoordSysTransform" | "ActiveTransform" => {
                block.values.insert(token, scan.value());
                current = add(&mut blocks, block)?;
            }
            "LightSource" => {
                block.name = unquoted(scan.value());
                block.kind = if SYSTEM.kinds.contains(&block.name) { block.name } else { token };
                while scan.peek().is_some_and(is_text) {
                    let declaration = unquoted(scan.value());
                    let name = match declaration.split_once(' ').unwrap_or_default() {
                        ("float" | "rgb" | "color" | "point" | "point3", name) => name.trim(),
                        ("blackbody", "I" | "L") => "blackbody",
                        _ => declaration,
                    };
                    block.values.insert(name, scan.value());
                }
                add(&mut blocks, block)?;
            }
            // Version 4 rejects the end of the world.
            word if among("Include Import Attribute AreaLightSource WorldEnd", word) => {
                blocks[0].values.insert(word, "");
            }
            _ => {}
        }
    }
    if !stack.is_empty() {
        return Err(scan.unmatched());
    }
    scan.whole()?;
    blocks.iter_mut().for_each(|block| block.values.sort());
    let three = blocks[0].has("WorldEnd");
    lights(&SYSTEM, &blocks, local, |block, record| {
        if three {
            record.number("version", 3.0);
        }
        let read = |key: &str| among(SYSTEM.keys, key) || among("from to", key);
        for key in block.values.names().filter(|key| !read(key)) {
            record.note(format!("`{key}` is not read"));
        }
        let image =
            block.values.names().find(|name| among("filename mapname", name.trim_start_matches("string ")));
        if let (Kind::Ambient, Some(image)) = (record.kind, image) {
            return Err(block.refused(image, "light of one colour from everywhere, without an image"));
        }
        record.position = block.vector("from", 0.0)?;
        record.axis = DVec3::from(block.numbers("to", [0.0, 0.0, 1.0])?) - record.position;
        Ok(())
    })
}

/// Returns the transform of a node.
fn local(block: &Block) -> Result<DAffine3, Refusal> {
    let step = directive(block)?;
    Ok(if block.name == INVERSE { step.inverse() } else { step })
}

/// Returns the transform of a directive (`transform.cpp` of version 3).
fn directive(block: &Block) -> Result<DAffine3, Refusal> {
    match block.kind {
        "Translate" => Ok(DAffine3::from_translation(block.vector(block.kind, 0.0)?)),
        "Scale" => Ok(DAffine3::from_scale(block.vector(block.kind, 1.0)?)),
        "Rotate" => {
            let [angle, x, y, z] = block.numbers(block.kind, [0.0; 4])?;
            Ok(rotation(DVec3::new(x, y, z), angle.to_radians()))
        }
        "LookAt" => {
            let [a, b, c, d, e, f, g, h, i] = block.numbers(block.kind, [0.0; 9])?;
            let [eye, at, up] = [[a, b, c], [d, e, f], [g, h, i]].map(DVec3::from);
            // From the world to a left-handed camera that looks along +z.
            let ahead = (at - eye).normalize();
            let right = up.cross(ahead).normalize();
            let camera = DMat3::from_cols(right, ahead.cross(right), ahead);
            Ok(DAffine3::from_mat3_translation(camera, eye).inverse())
        }
        "Transform" | "ConcatTransform" => block.matrix(block.kind),
        "CoordSysTransform" => {
            Err(block.refused(block.kind, "camera, world, or a name that CoordinateSystem gives, above it"))
        }
        "ActiveTransform" => Err(block.refused(block.kind, "transforms by numbers")),
        _ => Ok(DAffine3::IDENTITY),
    }
}
