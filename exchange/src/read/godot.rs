//! Scenes of Godot as text: `.tscn`, and `.scn` that was saved as text.

use std::collections::HashMap;

use glam::{DAffine3, DVec3};

use super::Found;
use super::scene::{Block, Lines, OUTSIDE, System, Values, add, among, attribute, color, lights, unquoted};
use crate::record::Kind;
use crate::refusal::Refusal;

const SYSTEM: System = System {
    kinds: ["SpotLight3D SpotLight", "OmniLight3D OmniLight", SUN, AMBIENT, "AreaLight3D"],
    axis: DVec3::NEG_Z,
    keys: "light_energy omni_range omni_attenuation spot_range spot_attenuation spot_angle spot_angle_attenuation \
           light_temperature light_intensity_lumens light_intensity_lux ambient_light_energy",
    others: "light_projector= \
             light_cull_mask=4294967295 distance_fade_enabled=0",
    never: "light_negative=true sky_mode=2",
    off: "visible=false editor_only=true",
    outside: "instance AnimationPlayer",
};
const SUN: &str = "DirectionalLight3D DirectionalLight";
/// The kind that the reader gives to a node whose environment has ambient light of one colour.
const AMBIENT: &str = "ambient-light";

/// Returns the lights, with their properties as keys, and `color`, which is linear. `version` = 3 for
/// lights of Godot 3.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    let (mut blocks, mut paths, mut node) = (Vec::new(), HashMap::new(), None);
    let (mut environments, mut environment) = (HashMap::new(), None);
    for line in Lines::new(text, true) {
        let (line, text) = line?;
        if text.starts_with('[') {
            let kind = attribute(text, "type");
            environment = (text.starts_with("[sub_resource ") && unquoted(kind) == "Environment")
                .then(|| unquoted(attribute(text, "id")));
            environments.extend(environment.map(|id| (id, Values::default())));
        }
        if text.starts_with("[node ") {
            let [own, kind, parent] = ["name", "type", "parent"].map(|key| attribute(text, key));
            let [name, kind, parent] = [own, kind, parent].map(unquoted);
            let path = match parent {
                "" => ".".to_owned(),
                "." => name.to_owned(),
                _ => format!("{parent}/{name}"),
            };
            let mut block = Block { kind, name: own, line, ..Block::default() };
            // A transform does not go through nodes without one.
            if !parent.is_empty() && !among("Node Control CanvasLayer SubViewport Viewport Window", kind) {
                block.parents.push(paths.get(parent).copied().unwrap_or(OUTSIDE));
            }
            // A node without a type is one of an instance.
            if kind.is_empty() {
                block.values.insert("instance", name);
            }
            node = Some(blocks.len());
            paths.insert(path, add(&mut blocks, block)?);
        } else if text.starts_with('[') {
            node = None;
        } else if let (Some(id), Some((key, value))) = (environment, text.split_once(" = ")) {
            environments.entry(id).or_default().insert(key, value);
        } else if let (Some(node), Some((key, value))) = (node, text.split_once(" = ")) {
            blocks[node].values.insert(key, value);
            if key == "top_level" && value == "true" {
                blocks[node].parents.clear();
            }
        }
    }
    environments.values_mut().for_each(Values::sort);
    let mut is_sky = false;
    for block in &mut blocks {
        block.values.sort();
        // `environment = SubResource("id")`
        let id = block.get("environment").strip_prefix("SubResource(").and_then(|id| id.strip_suffix(')'));
        if let Some(own) = id.and_then(|id| environments.get(unquoted(id))) {
            match ambient(own) {
                Some(light) => {
                    block.kind = AMBIENT;
                    light.into_iter().for_each(|(key, value)| block.values.insert(key, value));
                    block.values.sort();
                }
                // Without a source it is disabled.
                None => is_sky |= own.get("ambient_light_source") != Some("1"),
            }
        }
    }
    let mut found = lights(&SYSTEM, &blocks, local, |block, record| {
        if record.kind == Kind::Ambient {
            record.set("color", color(block.numbers("color", [0.0, 0.0, 0.0, 1.0])?));
            return Ok(());
        }
        record.set("color", color(block.numbers("light_color", [1.0; 4])?));
        if !block.kind.ends_with("3D") {
            record.number("version", 3.0);
            record.note("a light of Godot 3, whose attenuation differs from that of Godot 4");
        }
        Ok(())
    })?;
    let note = "ambient light of a sky, of the project's background or of Godot 3 is left out";
    found.notes.extend(is_sky.then(|| note.to_owned()));
    Ok(found)
}

/// Returns the colour and the energy of the ambient light of an environment, if it has one colour: its own, or that of
/// the background (the uniforms of a scene in `render_scene_data_rd.cpp`).
fn ambient<'a>(environment: &Values<'a>) -> Option<[(&'static str, &'a str); 2]> {
    let get = |key, default| environment.get(key).unwrap_or(default);
    let keys = match (get("ambient_light_source", "0"), get("background_mode", "0")) {
        ("2", _) => ["ambient_light_color", "ambient_light_energy"],
        ("0", "1") => ["background_color", "background_energy_multiplier"],
        _ => return None,
    };
    let [color, energy] = keys;
    Some([("color", get(color, "Color(0, 0, 0, 1)")), ("ambient_light_energy", get(energy, "1.0"))])
}

/// Returns the transform of a node: the rows of the basis, then the origin (`variant_parser.cpp`).
fn local(block: &Block) -> Result<DAffine3, Refusal> {
    let parts = "position translation rotation rotation_degrees scale quaternion basis";
    let part = parts.split(' ').chain(["instance"]).find(|part| block.has(part));
    if let Some(part) = part.filter(|part| *part != "instance" || !block.has("transform")) {
        return Err(block.refused(part, "a `transform` in this file, as the editor writes it"));
    }
    let identity = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let [xx, xy, xz, yx, yy, yz, zx, zy, zz, x, y, z] = block.numbers("transform", identity)?;
    Ok(DAffine3::from_cols_array(&[xx, yx, zx, xy, yy, zy, xz, yz, zz, x, y, z]))
}
