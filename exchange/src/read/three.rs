//! three.js: the JSON of `Object3D.toJSON()`, which `ObjectLoader` reads, and projects of its editor.

use std::collections::HashMap;
use std::slice;

use glam::{DAffine3, DVec3};
use serde::de::IgnoredAny;

use super::Found;
use super::json::{fill, index, list, matrix, named, objects, parse, word};
use crate::record::{Kind, Record, linear};
use crate::refusal::Refusal;

objects! {
    File: metadata Metadata, object Object, animations Vec<IgnoredAny>, scene File, scripts HashMap<String, IgnoredAny>;
    Metadata: r#type String;
    Object: uuid String, r#type String, name String, visible bool, layers f64, matrix [f64; 16], children Vec<Object>,
        color f64, intensity f64, distance f64, decay f64, angle f64, penumbra f64, target String, map IgnoredAny;
}

/// Finds the lights of a scene, an object, or the scene of a project: what the editor saves, and `app.json` of what
/// it publishes. A project's camera is none of the scene.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    let mut found = Found::default();
    let mut file: File = parse(text)?;
    if let (None, Some(scene)) = (&file.object, file.scene.take()) {
        let scripts = file.scripts.is_some_and(|scripts| !scripts.is_empty());
        found
            .notes
            .extend(scripts.then(|| "the project's scripts are not run: they may change lights".to_owned()));
        file = *scene;
    }
    let kind = file.metadata.unwrap_or_default().r#type;
    let (Some(root), "Object") = (&file.object, word(&kind)) else {
        let expected = "Object, and an object: what Object3D.toJSON() writes, or a project of the editor";
        return Err(Refusal::new("metadata.type", word(&kind), expected));
    };
    let (mut lights, mut positions) = (Vec::new(), HashMap::new());
    // Not deeper than the JSON. What is below an invisible object is not drawn either.
    let mut stack = vec![(slice::from_ref(&**root).iter(), DAffine3::IDENTITY, true)];
    let mut hidden = 0;
    while let Some((siblings, parent, is_shown)) = stack.last_mut() {
        let Some(object) = siblings.next() else {
            stack.pop();
            continue;
        };
        let world = *parent * matrix(&object.matrix);
        let is_shown = *is_shown && object.visible.as_deref() != Some(&false);
        positions.entry(object.uuid.as_ref()).or_insert(world.translation);
        match word(&object.r#type) {
            "SpotLight" | "PointLight" | "DirectionalLight" | "AmbientLight" if !is_shown => hidden += 1,
            "SpotLight" => lights.push((object, Kind::Spot, world)),
            "PointLight" => lights.push((object, Kind::Point, world)),
            "DirectionalLight" => lights.push((object, Kind::Directional, world)),
            "AmbientLight" => lights.push((object, Kind::Ambient, world)),
            other if other.ends_with("Light") || other == "LightProbe" => {
                found.notes.push(format!("{} is left out: {other}", word(&object.name)));
            }
            _ => {}
        }
        stack.push((list(&object.children).iter(), world, is_shown));
    }
    found.hide(hidden);
    found.rest(!list(&file.animations).is_empty());
    for (light, kind, world) in lights {
        let place = format!("object {}", word(&light.uuid));
        let mut record = Record::new(word(&light.name), kind, &place);
        // A target that the file does not have is a new object, at the origin.
        let target = light.target.as_ref().and_then(|target| positions.get(&Some(target)));
        record.axis = target.unwrap_or(&DVec3::ZERO) - world.translation;
        let notes = [
            (
                matches!(kind, Kind::Spot | Kind::Directional) && target.is_none(),
                "its target is not in the file, and so at the origin",
            ),
            (light.layers.as_deref().is_some_and(|own| *own != 1.0), "`layers` is not read"),
            (light.map.is_some(), "its projected texture is left out"),
        ];
        let color = light.color.as_ref().map(|color| index("color", **color, 1 << 24)).transpose();
        let filled = color.and_then(|color| {
            let rgb = color.map(|color| [16, 8, 0].map(|low| linear((color >> low & 255) as f64 / 255.0)));
            fill(record, &notes, rgb, &named!(light, intensity distance decay angle penumbra), [3, 1])
        });
        // The axis is in the world already.
        let world = DAffine3::from_translation(world.translation);
        found.add(place, filled.map(|record| (record, world)))?;
    }
    Ok(found)
}
