//! Babylon.js: the JSON of `SceneSerializer`, `.babylon`.

use std::collections::HashMap;

use glam::{DAffine3, DQuat, EulerRot};
use serde::de::IgnoredAny;

use super::Found;
use super::json::{Member, Worlds, fill, list, named, objects, parse, vector, word};
use crate::record::{Kind, Record};
use crate::refusal::Refusal;

objects! {
    File: useRightHandedSystem bool, lights Vec<Light>, transformNodes Vec<Node>, meshes Vec<Node>,
        animationGroups Vec<IgnoredAny>;
    Node: id Id, uniqueId Id, parentId Id, parentInstanceIndex IgnoredAny, position [f64; 3],
        rotation [f64; 3], rotationQuaternion [f64; 4], scaling [f64; 3], scalingDeterminant f64, isEnabled bool,
        animations Vec<IgnoredAny>;
    Light: name String, r#type f64, parentId Id, parentInstanceIndex IgnoredAny, position [f64; 3],
        direction [f64; 3], diffuse [f64; 3], intensity f64, intensityMode f64, range f64, falloffType f64,
        angle f64, innerAngle f64, exponent f64, isEnabled bool, projectedLightTexture IgnoredAny,
        includedOnlyMeshesIds Vec<IgnoredAny>, excludedMeshesIds Vec<IgnoredAny>, includeOnlyWithLayerMask f64,
        excludeWithLayerMask f64, animations Vec<IgnoredAny>;
}

/// The number of a node, or in older files its name.
#[derive(PartialEq, Eq, Hash, serde::Deserialize)]
#[serde(untagged)]
enum Id {
    Number(i64),
    Name(String),
}

/// Finds the lights.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    let file: File = parse(text)?;
    let Some(lights) = &file.lights else {
        return Err(Refusal::new("lights", "none", "the lights of a scene that SceneSerializer wrote"));
    };
    let mut found = Found::default();
    if file.useRightHandedSystem.as_deref() != Some(&true) {
        found.notes.push("left-handed: positions and axes are as in the file; negate their z".to_owned());
    }
    let nodes: Vec<_> = list(&file.transformNodes).iter().chain(list(&file.meshes)).collect();
    let mut indices = HashMap::new();
    for (at, node) in nodes.iter().enumerate() {
        // Of the nodes of a name, the last counts.
        indices.extend([(node.id.as_ref(), at), (node.uniqueId.as_ref(), at)]);
    }
    let (mut worlds, mut hidden) = (Worlds::new(nodes.len()), 0);
    for (at, light) in lights.iter().enumerate() {
        let kind = match light.r#type.as_deref().copied().unwrap_or(f64::NAN) {
            0.0 => Ok(Kind::Point),
            1.0 => Ok(Kind::Directional),
            2.0 => Ok(Kind::Spot),
            3.0 | 4.0 | 5.0 => {
                let name = word(&light.name);
                found.notes.push(format!("{name} is left out: hemispheric, area or clustered"));
                continue;
            }
            other => Err(Refusal::new("type", other, "0, 1 or 2")),
        };
        let place = format!("lights[{at}]");
        let mut is_off = light.isEnabled.as_deref() == Some(&false);
        let record = kind.and_then(|kind| {
            let parent = |parent: &Member<Id>, instance: &Member<IgnoredAny>| {
                let own = parent.as_ref().filter(|_| instance.is_none());
                own.and_then(|own| indices.get(&Some(own)).copied())
            };
            let above = parent(&light.parentId, &light.parentInstanceIndex);
            let parent = |at: usize| parent(&nodes[at].parentId, &nodes[at].parentInstanceIndex);
            let marks = |at: usize| {
                [
                    nodes[at].isEnabled.as_deref() == Some(&false),
                    nodes[at].parentId.is_some() && parent(at).is_none(),
                ]
            };
            let own = |above| worlds.of(above, |at| (nodes[at].local(), marks(at)), parent);
            let (world, [is_below_off, is_unknown]) =
                above.map_or(Ok((DAffine3::IDENTITY, [false, light.parentId.is_some()])), own)?;
            is_off |= is_below_off;
            let masks = [&light.includeOnlyWithLayerMask, &light.excludeWithLayerMask];
            let meshes = [&light.includedOnlyMeshesIds, &light.excludedMeshesIds];
            let is_choosy = masks.iter().any(|mask| mask.as_deref().is_some_and(|mask| *mask != 0.0))
                || meshes.iter().any(|meshes| !list(meshes).is_empty());
            let notes = [
                (is_unknown, "its parent is not a node of the file: position and axis are relative to it"),
                (light.parentId.is_some(), "pivots of its parents are left out"),
                (is_choosy, "in the file it lights some of the meshes alone"),
                (light.projectedLightTexture.is_some(), "its projected texture is left out"),
            ];
            let mut record = Record::new(word(&light.name), kind, &place);
            (record.position, record.axis) = (vector(&light.position, 0.0), vector(&light.direction, 0.0));
            let values = named!(light, intensity intensityMode range falloffType angle innerAngle exponent);
            Ok((fill(record, &notes, light.diffuse.as_deref().copied(), &values, [4, 2])?, world))
        });
        if is_off {
            hidden += 1;
        } else {
            found.add(place, record)?;
        }
    }
    found.hide(hidden);
    let moves = |animations: &Member<Vec<IgnoredAny>>| !list(animations).is_empty();
    found.rest(
        moves(&file.animationGroups)
            || lights.iter().any(|light| moves(&light.animations))
            || nodes.iter().any(|node| moves(&node.animations)),
    );
    Ok(found)
}

impl Node {
    fn local(&self) -> DAffine3 {
        let [x, y, z] = vector(&self.rotation, 0.0).to_array();
        let euler = || DQuat::from_euler(EulerRot::YXZ, y, x, z);
        let rotation = self.rotationQuaternion.as_deref().map_or_else(euler, |own| DQuat::from_array(*own));
        let scale = vector(&self.scaling, 1.0) * self.scalingDeterminant.as_deref().unwrap_or(&1.0);
        let position = vector(&self.position, 0.0);
        DAffine3::from_scale_rotation_translation(scale, rotation.normalize(), position)
    }
}
