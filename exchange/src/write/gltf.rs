//! Scenes of glTF 2.0 with `KHR_lights_punctual`, and with `EXT_lights_ies` for the lights that have a profile.

use luminaire_export::json::kind;
use luminaire_export::printable;
use serde_json::{Map, Value, json};

use super::node::{Node, Profile};

/// Returns a scene as JSON.
///
/// A node of both extensions would be two lights. So the scene has all lights by their numbers, for the many tools that
/// do not read profiles, and if there are any profiles a second one has the lights by these.
pub(super) fn text(nodes: &[Node]) -> String {
    let (mut written, mut files, mut scenes) = (Vec::new(), Vec::new(), [Vec::new(), Vec::new()]);
    for (light, node) in nodes.iter().enumerate() {
        if let Some(profile) = &node.profile {
            scenes[1].push(written.len());
            let [red, green, blue] = <[f32; 3]>::from(node.entry.lamp.light.color());
            let shaped =
                json!({ "light": files.len(), "multiplier": profile.factor, "color": [red, green, blue] });
            written.push(placed(node, "EXT_lights_ies", &shaped));
            files.push(json!({ "name": node.name, "uri": uri(profile) }));
        } else {
            scenes[1].push(written.len());
        }
        scenes[0].push(written.len());
        written.push(placed(node, "KHR_lights_punctual", &json!({ "light": light })));
    }
    let lights: Vec<_> = nodes.iter().map(punctual).collect();
    let (mut used, mut extensions) =
        (vec!["KHR_lights_punctual"], json!({ "KHR_lights_punctual": { "lights": lights } }));
    let [first, second] = scenes;
    let mut scenes = vec![json!({ "name": "lights", "nodes": first })];
    if !files.is_empty() {
        used.push("EXT_lights_ies");
        extensions["EXT_lights_ies"] = json!({ "lights": files });
        scenes.push(json!({ "name": "lights by IES profiles", "nodes": second }));
    }
    let file = json!({
        "asset": { "version": "2.0", "generator": "luminaire" },
        "extensionsUsed": used,
        "extensions": extensions,
        "scene": 0,
        "scenes": scenes,
        "nodes": written,
    });
    format!("{file:#}\n")
}

fn placed(node: &Node, extension: &str, own: &Value) -> Value {
    let (position, turn) = (node.position.to_array(), node.rotation.to_array());
    let mut placed = json!({
        "name": printable(&node.entry.lamp.name),
        "translation": position,
        "rotation": turn,
        "extensions": { extension: own },
    });
    if !node.lines.is_empty() {
        placed["extras"] = json!({ "notes": node.lines });
    }
    placed
}

fn punctual(node: &Node) -> Value {
    let light = &node.entry.lamp.light;
    let (mut own, mut spot) = (Map::new(), Map::new());
    own.insert("name".to_owned(), printable(&node.entry.lamp.name).into());
    own.insert("type".to_owned(), kind(light).into());
    own.insert("color".to_owned(), <[f32; 3]>::from(light.color()).to_vec().into());
    for (key, value) in &node.entry.found.values {
        let part = if key.ends_with("ConeAngle") { &mut spot } else { &mut own };
        part.insert((*key).to_owned(), value.parse::<f64>().unwrap_or_default().into());
    }
    if !spot.is_empty() {
        let angle = |key: &str| spot.get(key).and_then(Value::as_f64).unwrap_or_default();
        let [inner, outer] = ["innerConeAngle", "outerConeAngle"].map(angle);
        // The extension has no step: the inner angle is less than the outer one.
        spot.insert("innerConeAngle".to_owned(), inner.min(outer.next_down()).into());
        own.insert("spot".to_owned(), spot.into());
    }
    own.into()
}

/// Returns the name of a file as a relative URI: what is no unreserved character is escaped (RFC 3986, 2.3).
fn uri(profile: &Profile) -> String {
    let escaped = |byte: u8| match char::from(byte) {
        own if own.is_ascii_alphanumeric() || "-._~".contains(own) => own.to_string(),
        _ => format!("%{byte:02X}"),
    };
    profile.file.bytes().map(escaped).collect()
}
