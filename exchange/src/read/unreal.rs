//! Actors and components of Unreal Engine 4 and 5 as text: what its editor copies, and `.t3d`.

use std::collections::HashMap;

use glam::{DAffine3, DQuat, DVec3, EulerRot};

use super::Found;
use super::scene::{Block, Lines, OUTSIDE, System, add, attribute, color, lights, unmatched, unquoted};
use crate::refusal::Refusal;

const SYSTEM: System = System {
    kinds: ["SpotLightComponent", "PointLightComponent", "DirectionalLightComponent", "", OTHERS],
    axis: DVec3::X,
    keys: "InnerConeAngle OuterConeAngle Intensity IntensityUnits AttenuationRadius bUseInverseSquaredFalloff \
           LightFalloffExponent bUseTemperature Temperature",
    others: "IESTexture= LightFunctionMaterial= LightingChannels= MaxDrawDistance=0",
    never: "",
    off: "bHidden=True bVisible=False bAffectsWorld=False",
    outside: "",
};
const OTHERS: &str = "RectLightComponent SkyLightComponent";

/// Returns the lights, with the keys of the file, and `color`, which is linear. Positions are in metres,
/// all other lengths in centimetres.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    let (mut blocks, mut indices) = (vec![Block::default()], HashMap::new());
    let (mut open, mut actor) = (Vec::new(), 0);
    for line in Lines::new(text, false) {
        let (line, text) = line?;
        if text.starts_with("Begin ") {
            // Components are twice in their actor: with their class, and with their values.
            let kind = unquoted(attribute(text, "Class")).rsplit('.').next().unwrap_or("");
            let above = if text.starts_with("Begin Object") { actor } else { 0 };
            let (name, next) = (attribute(text, "Name"), blocks.len());
            let key = (above, unquoted(name));
            let index = *indices.get(&key).filter(|_| kind.is_empty()).unwrap_or(&next);
            if index == next {
                indices.insert(key, next);
                add(&mut blocks, Block { kind, name, line, parents: vec![above], ..Block::default() })?;
            }
            actor = if text.starts_with("Begin Actor") { index } else { actor };
            open.push(index);
        } else if text.starts_with("End ") {
            open.pop().ok_or_else(|| unmatched(line))?;
            actor = if text == "End Actor" { 0 } else { actor };
        } else if let (Some((key, value)), Some(&index)) = (text.split_once('='), open.last()) {
            // What is attached to a hidden component may be visible.
            if key != "bVisible" || blocks[index].kind.contains("Light") {
                blocks[index].values.insert(key, value);
            }
        }
    }
    if blocks.len() == 1 {
        return Err(Refusal::new("file", "without `Begin Object`", "text that the editor of Unreal copies"));
    }
    if let Some(&begun) = open.last() {
        return Err(unmatched(blocks[begun].line));
    }
    blocks.iter_mut().for_each(|block| block.values.sort());
    for index in 1..blocks.len() {
        let actor = blocks[index].parents[0];
        let root = blocks[actor].get("RootComponent");
        let label = blocks[actor].values.get("ActorLabel").unwrap_or("");
        let names = [label, blocks[actor].name, blocks[index].name];
        let block = &mut blocks[index];
        block.name = names.into_iter().find(|name| !name.is_empty()).unwrap_or("");
        // `Class'"Component"'`, or without the class. Components of other actors have their name, too.
        let above = if block.has("AttachParent") { block.get("AttachParent") } else { root };
        let above = above.trim_matches('\'').rsplit('\'').next().unwrap_or("").trim_matches('"');
        let parent = indices.get(&(actor, above)).copied().unwrap_or(OUTSIDE);
        if !above.is_empty() && above != "None" && parent != index {
            block.parents = vec![parent];
        }
    }
    let mut found = lights(&SYSTEM, &blocks, local, |block, record| {
        if block.has("Brightness") {
            return Err(block.refused("Brightness", "the Intensity of Unreal Engine 4 or 5"));
        }
        let components = parts(block, "LightColor", ["R", "G", "B"], 255.0)? / 255.0;
        record.set("color", color(components.to_array()));
        Ok(())
    })?;
    found.records.iter_mut().for_each(|record| record.position *= 0.01);
    found.notes.push("positions and axes are in the left-handed system of Unreal, with z up".to_owned());
    Ok(found)
}

/// Returns the named parts of a value such as `(X=1.0,Y=2.0,Z=3.0)`.
fn parts(block: &Block, key: &str, names: [&str; 3], default: f64) -> Result<DVec3, Refusal> {
    let mut parts = DVec3::splat(default);
    for part in block.get(key).split(['(', ',', ')']) {
        let (name, number) = part.split_once('=').unwrap_or_default();
        if let Some(index) = names.iter().position(|own| *own == name) {
            parts[index] = number.parse().map_err(|_| block.refused(key, "numbers"))?;
        }
    }
    Ok(parts)
}

/// Returns the transform of a component (`FRotationMatrix`, in columns).
fn local(block: &Block) -> Result<DAffine3, Refusal> {
    for key in ["bAbsoluteLocation", "bAbsoluteRotation", "bAbsoluteScale"] {
        if block.get(key) == "True" {
            return Err(block.refused(key, "a component that follows its parent"));
        }
    }
    let angles = parts(block, "RelativeRotation", ["Yaw", "Pitch", "Roll"], 0.0)?.map(f64::to_radians);
    let turn = DQuat::from_euler(EulerRot::ZYX, angles.x, -angles.y, -angles.z);
    let scale = parts(block, "RelativeScale3D", ["X", "Y", "Z"], 1.0)?;
    let location = parts(block, "RelativeLocation", ["X", "Y", "Z"], 0.0)?;
    Ok(DAffine3::from_scale_rotation_translation(scale, turn, location))
}
