//! Babylon.js: the JSON of `SceneSerializer`, `.babylon`.

use std::collections::HashMap;

use glam::{DAffine3, DQuat, EulerRot};
use serde::de::IgnoredAny;

use super::Found;
use super::json::{Member, add, fill, list, named, objects, parse, vector, word, world};
use crate::record::{Kind, Record};
use crate::refusal::Refusal;

objects! {
    File: useRightHandedSystem bool, lights Vec<Light>, transformNodes Vec<Node>, meshes Vec<Node>;
    Node: id Id, uniqueId Id, parentId Id, parentInstanceIndex IgnoredAny, position [f64; 3],
        rotation [f64; 3], rotationQuaternion [f64; 4], scaling [f64; 3], scalingDeterminant f64;
    Light: name String, r#type f64, parentId Id, parentInstanceIndex IgnoredAny, position [f64; 3],
        direction [f64; 3], diffuse [f64; 3], intensity f64, intensityMode f64, range f64, falloffType f64,
        angle f64, innerAngle f64, exponent f64, isEnabled bool, projectedLightTexture IgnoredAny;
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
        let record = kind.and_then(|kind| {
            let mut unknown = false;
            let mut parent = |parent: &Member<Id>, instance: &Member<IgnoredAny>| {
                let own = parent.as_ref().filter(|_| instance.is_none());
                let found = own.and_then(|own| indices.get(&Some(own)).copied());
                unknown |= parent.is_some() && found.is_none();
                found
            };
            let mut world = match parent(&light.parentId, &light.parentInstanceIndex) {
                None => DAffine3::IDENTITY,
                Some(above) => world(above, |at| {
                    (nodes[at].local(), parent(&nodes[at].parentId, &nodes[at].parentInstanceIndex))
                })?,
            };
            world.translation = world.transform_point3(vector(&light.position, 0.0));
            let notes = [
                (unknown, "its parent is not a node of the file: position and axis are relative to it"),
                (light.parentId.is_some(), "pivots of its parents are left out"),
                (light.isEnabled.as_deref() == Some(&false), "it is off in the file"),
                (light.projectedLightTexture.is_some(), "its projected texture is left out"),
            ];
            let record = Record::new(word(&light.name), kind, &place);
            let values = named!(light, intensity intensityMode range falloffType angle innerAngle exponent);
            let record = fill(record, &notes, light.diffuse.as_deref().copied(), &values, [4, 2])?;
            Ok((record, world, world.transform_vector3(vector(&light.direction, 0.0))))
        });
        add(&mut found, place, record)?;
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn file_of_babylon_js_has_the_light_that_babylon_js_has() {
        let file = include_str!("../../tests/files/babylon.babylon");
        let mut found = read(file).unwrap();
        let spot = &mut found.records[0];
        let position = DVec3::new(1.014_047_313, 3.894_275_755, -0.980_066_597);
        assert!(spot.position.abs_diff_eq(position, 1e-6), "expected {position}, found {}", spot.position);
        let axis = DVec3::new(-1.074_607_581, -1.714_102_685, -0.396_321_058).normalize();
        assert!(spot.axis.normalize().abs_diff_eq(axis, 1e-6), "expected {axis}, found {}", spot.axis);
        assert_eq!((spot.kind, spot.get("innerAngle", 0.0)), (Kind::Spot, Ok(0.4)));
        assert_eq!(spot.triple("color", [0.0; 3]), Ok([1.0, 0.5, 0.25]));
        assert!(found.notes[0].contains("left-handed") && found.notes[1].contains("hemi is left out"));
        assert!((0..file.len()).all(|length| read(&file[..length]).is_err()));
    }

    #[test]
    fn read_refuses_wrong_lights_and_keeps_the_others() {
        let file = r#"{"lights": [{"type":1,"direction":[0,0,2],"parentId":"turn","range":5},
            {"type":0,"parentId":7,"angle":1}, {"type":0,"parentId":1,"parentInstanceIndex":"0","isEnabled":false},
            {"type":2}, {"type":9}, {"type":0,"parentId":1}, {"type":0,"intensity":-1},
            {"type":0,"parentId":3,"position":[1e200,0,0]}],
            "meshes": [{"id":"turn","rotationQuaternion":[0,1,0,1],"scalingDeterminant":-1}],
            "transformNodes": [{"uniqueId":1,"parentId":2}, {"uniqueId":2,"parentId":1},
                {"uniqueId":3,"scaling":[1e200,1,1]}]}"#;
        let found = read(file).unwrap();
        let refused: Vec<_> = found.refused.iter().map(|own| (&*own.place, &*own.parameter)).collect();
        assert_eq!(refused[..2], [("lights[3]", "position"), ("lights[4]", "type")]);
        assert_eq!(refused[2..4], [("lights[5]", "parents"), ("lights[6]", "intensity")]);
        assert_eq!(refused[4..], [("lights[7]", "position")]);
        let [sun, point, off] = &found.records[..] else { panic!("found {found:?}") };
        assert!(sun.axis.abs_diff_eq(DVec3::NEG_X, 1e-12) && !sun.has("range"), "found {sun:?}");
        assert!(
            point.notes[0].contains("its parent is not a node") && !point.has("angle"),
            "found {point:?}"
        );
        assert_eq!(off.notes.len(), 3, "found {off:?}");
        let many = format!("{{\"lights\":[{}{{\"type\":0}}]}}", "{\"type\":0},".repeat(10_000));
        assert!(read(&many).unwrap_err().expected.starts_with("at most 10000"));
    }
}
