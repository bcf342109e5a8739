//! glTF 2.0, as JSON and as GLB: the lights of `KHR_lights_punctual`.

use glam::{DAffine3, DQuat};
use serde::de::IgnoredAny;

use super::Found;
use super::json::{Worlds, fill, index, list, matrix, named, objects, parse, vector, word};
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::text::decode;

objects! {
    File: asset Asset, scene f64, scenes Vec<Scene>, nodes Vec<Node>, extensions Extensions, animations Vec<IgnoredAny>;
    Asset: version String;
    Scene: nodes Vec<f64>;
    Node: name String, children Vec<f64>, extensions Extensions,
        matrix [f64; 16], translation [f64; 3], rotation [f64; 4], scale [f64; 3];
    Extensions: KHR_lights_punctual Punctual, KHR_node_visibility Visibility, EXT_lights_ies IgnoredAny, EXT_lights_image_based IgnoredAny;
    Visibility: visible bool;
    Punctual: light f64, lights Vec<Light>;
    Light: name String, r#type String, color [f64; 3], intensity f64, range f64, spot Spot;
    Spot: innerConeAngle f64, outerConeAngle f64;
}

/// Finds the lights of the default scene, or of all scenes, and those that no node of them uses.
pub(crate) fn read(bytes: &[u8]) -> Result<Found, Refusal> {
    let file: File = parse(&decode(json(bytes)?)?)?;
    let (version, mut found) = (file.asset.unwrap_or_default().version, Found::default());
    if !word(&version).starts_with("2.") {
        return Err(Refusal::new("asset.version", word(&version), "2.0: export the scene as glTF 2.0"));
    }
    let extensions = file.extensions.unwrap_or_default();
    if extensions.EXT_lights_ies.or(extensions.EXT_lights_image_based).is_some() {
        found.notes.push("the lights of EXT_lights_ies and EXT_lights_image_based are left out".to_owned());
    }
    let (nodes, scenes) = (list(&file.nodes), list(&file.scenes));
    let mut parents = vec![None; nodes.len()];
    for (parent, node) in nodes.iter().enumerate() {
        for child in list(&node.children) {
            match index("children", *child, nodes.len()) {
                // With a second parent, a node becomes its own parent: a cycle, which `world` refuses.
                Ok(child) => parents[child] = Some(if parents[child].is_none() { parent } else { child }),
                Err(refusal) => found.add(format_args!("nodes[{parent}]"), Err(refusal))?,
            }
        }
    }
    let mut shown = scenes;
    match file.scene.map(|scene| index("scene", *scene, scenes.len())) {
        Some(Ok(scene)) => shown = &scenes[scene..=scene],
        Some(Err(refusal)) => found.add("file", Err(refusal))?,
        None => {}
    }
    let mut roots = vec![scenes.is_empty(); nodes.len()];
    for root in shown.iter().flat_map(|scene| list(&scene.nodes)) {
        match index("nodes", *root, nodes.len()) {
            Ok(root) => roots[root] = true,
            Err(refusal) => found.add("scenes", Err(refusal))?,
        }
    }
    let punctual = extensions.KHR_lights_punctual.unwrap_or_default();
    let lights = list(&punctual.lights);
    let (mut used, mut worlds, mut hidden) = (vec![false; lights.len()], Worlds::new(nodes.len()), 0);
    for (at, node) in nodes.iter().enumerate() {
        let own = node.extensions.as_ref().and_then(|own| own.KHR_lights_punctual.as_ref()?.light.as_deref());
        let Some(own) = own else { continue };
        let local = |node: usize| (nodes[node].local(), [roots[node], nodes[node].is_hidden()]);
        let world = worlds.of(at, local, |node| parents[node]);
        if matches!(world, Ok((_, [false, _]))) {
            continue;
        }
        let record = index("light", *own, lights.len()).and_then(|own| {
            used[own] = true;
            Ok((lights[own].record(node.name.as_deref(), own)?, world.clone()?.0))
        });
        if matches!(world, Ok((_, [_, true]))) {
            hidden += 1;
        } else {
            found.add(format_args!("nodes[{at}]"), record)?;
        }
    }
    found.hide(hidden);
    found.rest(!list(&file.animations).is_empty());
    for (at, light) in lights.iter().enumerate().filter(|(at, _)| !used[*at]) {
        let record = light.record(None, at).map(|mut record| {
            record.note("no node of the scene uses it: it is at the origin and shines along -z");
            (record, DAffine3::IDENTITY)
        });
        found.add("no node", record)?;
    }
    Ok(found)
}

impl Node {
    fn is_hidden(&self) -> bool {
        let own =
            self.extensions.as_ref().and_then(|own| own.KHR_node_visibility.as_ref()?.visible.as_deref());
        own == Some(&false)
    }

    fn local(&self) -> DAffine3 {
        let rotation = self.rotation.as_deref().map_or(DQuat::IDENTITY, |own| DQuat::from_array(*own));
        let [scale, translation] = [vector(&self.scale, 1.0), vector(&self.translation, 0.0)];
        // A node has either a matrix or the other three.
        matrix(&self.matrix)
            * DAffine3::from_scale_rotation_translation(scale, rotation.normalize(), translation)
    }
}

impl Light {
    fn record(&self, name: Option<&String>, at: usize) -> Result<Record, Refusal> {
        let place = format!("lights[{at}]");
        let kind = match word(&self.r#type) {
            "spot" => Kind::Spot,
            "point" => Kind::Point,
            "directional" => Kind::Directional,
            other => return Err(Refusal::new("type", other, "spot, point or directional").at(place)),
        };
        let record = Record::new(name.map_or(word(&self.name), String::as_str), kind, &place);
        let spot = self.spot.as_deref().unwrap_or(&Spot { innerConeAngle: None, outerConeAngle: None });
        let values = [named!(self, intensity range), named!(spot, innerConeAngle outerConeAngle)].concat();
        fill(record, &[], self.color.as_deref().copied(), &values, [2, 1])
            .map_err(|refusal| refusal.at(place))
    }
}

/// Returns the JSON: the file, or the first chunk of a GLB.
fn json(bytes: &[u8]) -> Result<&[u8], Refusal> {
    const JSON: u32 = u32::from_le_bytes(*b"JSON");
    let Some(header) = bytes.strip_prefix(b"glTF") else { return Ok(bytes) };
    let words: Vec<_> = header.as_chunks().0.iter().take(4).map(|word| u32::from_le_bytes(*word)).collect();
    match words[..] {
        [2, all, own, JSON] if all as usize <= bytes.len() && all.checked_sub(20) >= Some(own) => {
            Ok(&bytes[20..][..own as usize])
        }
        _ => Err(Refusal::new("header", format_args!("{words:?}"), "that of a whole GLB 2: export it again")),
    }
}
