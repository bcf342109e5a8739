//! three.js: the JSON of `Object3D.toJSON()`, which `ObjectLoader` reads.

use std::collections::HashMap;
use std::slice;

use glam::{DAffine3, DVec3};
use serde::de::IgnoredAny;

use super::Found;
use super::json::{add, fill, index, list, matrix, named, objects, parse, word};
use crate::record::{Kind, Record, linear};
use crate::refusal::Refusal;

objects! {
    File: metadata Metadata, object Object;
    Metadata: r#type String;
    Object: uuid String, r#type String, name String, visible bool, matrix [f64; 16], children Vec<Object>,
        color f64, intensity f64, distance f64, decay f64, angle f64, penumbra f64, target String, map IgnoredAny;
}

/// Finds the lights of a scene or an object.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    let file: File = parse(text)?;
    let kind = file.metadata.unwrap_or_default().r#type;
    let (Some(root), "Object") = (&file.object, word(&kind)) else {
        let expected = "Object, and an object: what Object3D.toJSON() writes";
        return Err(Refusal::new("metadata.type", word(&kind), expected));
    };
    let (mut found, mut lights, mut positions) = (Found::default(), Vec::new(), HashMap::new());
    // Not deeper than the JSON.
    let mut stack = vec![(slice::from_ref(&**root).iter(), DAffine3::IDENTITY)];
    while let Some((siblings, parent)) = stack.last_mut() {
        let Some(object) = siblings.next() else {
            stack.pop();
            continue;
        };
        let world = *parent * matrix(&object.matrix);
        positions.entry(object.uuid.as_ref()).or_insert(world.translation);
        match word(&object.r#type) {
            "SpotLight" => lights.push((object, Kind::Spot, world)),
            "PointLight" => lights.push((object, Kind::Point, world)),
            "DirectionalLight" => lights.push((object, Kind::Directional, world)),
            other if other.ends_with("Light") || other == "LightProbe" => {
                found.notes.push(format!("{} is left out: {other}", word(&object.name)));
            }
            _ => {}
        }
        stack.push((list(&object.children).iter(), world));
    }
    for (light, kind, world) in lights {
        let place = format!("object {}", word(&light.uuid));
        let record = Record::new(word(&light.name), kind, &place);
        // A target that the file does not have is a new object, at the origin.
        let target = light.target.as_ref().and_then(|target| positions.get(&Some(target)));
        let axis = target.unwrap_or(&DVec3::ZERO) - world.translation;
        let notes = [
            (kind != Kind::Point && target.is_none(), "its target is not in the file, and so at the origin"),
            (light.visible.as_deref() == Some(&false), "it is invisible in the file"),
            (light.map.is_some(), "its projected texture is left out"),
        ];
        let color = light.color.as_ref().map(|color| index("color", **color, 1 << 24)).transpose();
        let filled = color.and_then(|color| {
            let rgb = color.map(|color| [16, 8, 0].map(|low| linear((color >> low & 255) as f64 / 255.0)));
            fill(record, &notes, rgb, &named!(light, intensity distance decay angle penumbra), [3, 1])
        });
        add(&mut found, place, filled.map(|record| (record, world, axis)))?;
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_of_three_js_has_the_light_that_three_js_has() {
        let file = include_str!("../../tests/files/three.json");
        let mut found = read(file).unwrap();
        let spot = &mut found.records[0];
        assert!(spot.position.abs_diff_eq(DVec3::new(0.0, 4.0, -1.0), 1e-9), "found {}", spot.position);
        let axis = DVec3::new(0.0, -0.970_142_500_145, -0.242_535_625_036);
        assert!(spot.axis.normalize().abs_diff_eq(axis, 1e-9), "expected {axis}, found {}", spot.axis);
        assert_eq!((spot.kind, spot.get("penumbra", 0.0), spot.notes.len()), (Kind::Spot, Ok(0.25), 0));
        let color = DVec3::from(spot.triple("color", [0.0; 3]).unwrap());
        assert!(color.abs_diff_eq(DVec3::new(1.0, 0.215_860_500_103, 0.0), 1e-9), "found {color}");
        assert_eq!(found.notes, ["ambient is left out: AmbientLight"]);
        assert!((0..file.len()).all(|length| read(&file[..length]).is_err()));
    }

    #[test]
    fn read_refuses_other_files_and_wrong_lights_and_keeps_the_others() {
        let file = |kind: &str, children: &str| {
            format!(r#"{{"metadata":{{"type":"{kind}"}},"object":{{"children":[{children}]}}}}"#)
        };
        let deep = [r#"{"children":["#, r#"{"type":"PointLight"}"#, "]}"];
        let deep = |depth| [deep[0].repeat(depth), deep[1].to_owned(), deep[2].repeat(depth)].concat();
        assert_eq!(read(&file("Object", &deep(60))).unwrap().records.len(), 1);
        assert!(read(&file("Object", &deep(200))).unwrap_err().to_string().contains("recursion limit"));
        assert_eq!(read(&file("Geometry", "")).unwrap_err().parameter, "metadata.type");
        let lights = r#"{"type":"SpotLight"},{"type":"PointLight","color":-1},{"type":"DirectionalLight",
            "visible":false,"map":"","matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,2,1],"distance":3}"#;
        let found = read(&file("Object", lights)).unwrap();
        let refused: Vec<_> = found.refused.iter().map(|refusal| refusal.parameter.as_str()).collect();
        assert_eq!(refused, ["position", "color"]);
        let sun = &found.records[0];
        assert_eq!((sun.axis, sun.notes.len(), sun.has("distance")), (DVec3::NEG_Z, 3, false));
    }
}
