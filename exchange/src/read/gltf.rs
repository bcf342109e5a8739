//! glTF 2.0, as JSON and as GLB: the lights of `KHR_lights_punctual` and of `EXT_lights_ies`.

mod profiles;

use std::collections::HashMap;

use glam::{DAffine3, DQuat};
use serde::de::IgnoredAny;

use self::profiles::{Profiles, Source};
use super::Found;
use super::json::{Member, Worlds, fill, index, list, matrix, named, objects, parse, vector, word};
use crate::record::{Kind, Profile, Record};
use crate::refusal::Refusal;
use crate::text::decode;

objects! {
    File: asset Asset, scene f64, scenes Vec<Scene>, nodes Vec<Node>, extensions Extensions, animations Vec<IgnoredAny>,
        buffers Vec<Buffer>, bufferViews Vec<View>;
    Buffer: uri String;
    View: buffer f64, byteOffset f64, byteLength f64;
    Asset: version String;
    Scene: nodes Vec<f64>;
    Node: name String, children Vec<f64>, extensions Extensions,
        matrix [f64; 16], translation [f64; 3], rotation [f64; 4], scale [f64; 3];
    Extensions: KHR_lights_punctual Punctual, KHR_node_visibility Visibility, EXT_lights_ies Measured, EXT_lights_image_based IgnoredAny;
    Visibility: visible bool;
    Punctual: light f64, lights Vec<Light>;
    Light: name String, r#type String, color [f64; 3], intensity f64, range f64, spot Spot;
    Spot: innerConeAngle f64, outerConeAngle f64;
    Measured: light f64, multiplier f64, color [f64; 3], lights Vec<Photometry>;
    Photometry: name String, uri String, bufferView f64;
}

/// Finds the lights of the default scene, or of one with IES profiles in its place, or of all scenes, and those that no
/// node of them uses.
pub(crate) fn read(bytes: &[u8]) -> Result<Found, Refusal> {
    let [json, chunk] = chunks(bytes)?;
    let file: File = parse(&decode(json)?)?;
    let (version, mut found) = (file.asset.unwrap_or_default().version, Found::default());
    if !word(&version).starts_with("2.") {
        return Err(Refusal::new("asset.version", word(&version), "2.0: export the scene as glTF 2.0"));
    }
    let extensions = file.extensions.unwrap_or_default();
    if extensions.EXT_lights_image_based.is_some() {
        found.notes.push("the lights of EXT_lights_image_based are left out".to_owned());
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
    let (mut shown, mut replaced) = (scenes, None);
    match file.scene.map(|scene| index("scene", *scene, scenes.len())) {
        Some(Ok(scene)) => shown = &scenes[scene..=scene],
        Some(Err(refusal)) => found.add("file", Err(refusal))?,
        None => {}
    }
    // A second scene may have the same lights by their profiles, because a node of both extensions is two lights.
    let is_measured = |root: &f64| {
        let node = index("nodes", *root, nodes.len()).ok().and_then(|node| nodes[node].extensions.as_ref());
        node.is_some_and(|own| own.EXT_lights_ies.is_some())
    };
    let has_profiles = |scene: &&Scene| list(&scene.nodes).iter().any(is_measured);
    if let [only] = shown
        && !has_profiles(&only)
        && let Some(other) = scenes.iter().position(|scene| has_profiles(&scene))
    {
        found.notes.push(format!("scenes[{other}] is read, which has IES profiles, and not the default one"));
        (shown, replaced) = (&scenes[other..=other], Some(Found::default()));
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
    let measured = extensions.EXT_lights_ies.unwrap_or_default();
    let files = list(&measured.lights);
    let (mut used, mut worlds, mut hidden) = (vec![false; lights.len()], Worlds::new(nodes.len()), 0);
    let or = |member: &Member<f64>, default: f64| member.as_deref().copied().unwrap_or(default);
    let sources =
        files.iter().map(|own| Source { uri: word(&own.uri), view: own.bufferView.as_deref().copied() });
    let views = list(&file.bufferViews).iter().map(|own| profiles::View {
        buffer: or(&own.buffer, -1.0),
        start: or(&own.byteOffset, 0.0),
        length: or(&own.byteLength, 0.0),
    });
    let buffers = list(&file.buffers).iter().map(|own| word(&own.uri));
    let mut profiles = Profiles::new(sources.collect(), views.collect(), buffers.collect(), chunk);
    let mut elsewhere = 0;
    for (at, node) in nodes.iter().enumerate() {
        let Some(extensions) = &node.extensions else { continue };
        let own = extensions.KHR_lights_punctual.as_ref().and_then(|own| own.light.as_deref());
        let shaped = extensions.EXT_lights_ies.as_ref().filter(|own| own.light.is_some());
        if own.is_none() && shaped.is_none() {
            continue;
        }
        let local = |node: usize| (nodes[node].local(), [roots[node], nodes[node].is_hidden()]);
        let world = worlds.of(at, local, |node| parents[node]);
        let name = node.name.as_deref();
        let punctual = own.map(|own| {
            let own = index("light", *own, lights.len())?;
            used[own] = true;
            lights[own].record(name, own)
        });
        let shaped = shaped.map(|own| {
            let file = index("light", *own.light.as_deref().unwrap_or(&-1.0), files.len())?;
            own.record(name, (&files[file], file), profiles.get(file), punctual.clone().transpose()?)
        });
        if matches!(world, Ok((_, [false, _]))) {
            elsewhere += 1;
            if let (Some(others), Some(Ok(record)), Ok((world, _))) = (&mut replaced, punctual, world) {
                // The limit of lights is that of those that are shown.
                let _ = others.add("", Ok((record, world)));
            }
            continue;
        }
        let record = shaped.or(punctual).unwrap_or_else(|| Err(Refusal::new("light", "none", "an index")));
        let record = record.and_then(|record| Ok((record, world.clone()?.0)));
        if matches!(world, Ok((_, [_, true]))) {
            hidden += 1;
        } else {
            found.add(format_args!("nodes[{at}]"), record)?;
        }
    }
    if let Some(others) = replaced {
        by_numbers(&mut found.records, others.records);
    }
    found.hide(hidden);
    let unused = (profiles.unused(), "IES profiles that no node uses");
    for (count, what) in [(elsewhere, "lights of other scenes"), unused] {
        found.notes.extend((count > 0).then(|| format!("{what} are left out: {count}")));
    }
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

/// Gives the lights with profiles the numbers that another scene has of them: those of a light of the same name at the
/// same place.
fn by_numbers(records: &mut [Record], others: Vec<Record>) {
    let key = |record: &Record| (record.name.clone(), record.position.to_array().map(f64::to_bits));
    let others: HashMap<_, _> = others.into_iter().map(|other| (key(&other), other)).collect();
    for record in records {
        let other = others.get(&key(record)).filter(|other| other.kind != Kind::Directional);
        if let Some(profile) = record.profile.as_mut().filter(|profile| profile.without.is_none()) {
            profile.without = other.cloned();
        }
    }
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

impl Measured {
    /// Returns the light of a node by a file of the extension, whose colour is clamped and whose law is the inverse
    /// square. A node has one light, as Unreal's exporter writes both extensions: `without` is that by its numbers.
    fn record(
        &self,
        name: Option<&String>,
        (file, at): (&Photometry, usize),
        profile: Result<Profile, Refusal>,
        without: Option<Record>,
    ) -> Result<Record, Refusal> {
        let place = format!("EXT_lights_ies.lights[{at}]");
        let profile = profile.map_err(|refusal| refusal.at(&place))?;
        let mut record = Record::new(name.map_or(word(&file.name), String::as_str), Kind::Point, &place);
        record.profile = Some(Box::new(Profile { without: without.clone(), ..profile }));
        if without.is_some() {
            record.note("its node has numbers of KHR_lights_punctual, too: they are taken as the same light");
        }
        let own = without.and_then(|mut own| own.triple("color", [1.0; 3]).ok());
        let color = self.color.as_deref().copied().or(own).map(|color| color.map(|channel| channel.min(1.0)));
        fill(record, &[], color, &[("intensity", &self.multiplier)], [1, 1]).map_err(|mut refusal| {
            if refusal.parameter == "intensity" {
                "multiplier".clone_into(&mut refusal.parameter);
            }
            refusal.at(place)
        })
    }
}

/// Returns the JSON and the first buffer: the file, or the chunks of a GLB, whose second may be missing.
fn chunks(bytes: &[u8]) -> Result<[&[u8]; 2], Refusal> {
    const JSON: u32 = u32::from_le_bytes(*b"JSON");
    const BIN: u32 = u32::from_le_bytes(*b"BIN\0");
    let Some(header) = bytes.strip_prefix(b"glTF") else { return Ok([bytes, &[]]) };
    let words = |bytes: &[u8], count| -> Vec<_> {
        bytes.as_chunks().0.iter().take(count).map(|word| u32::from_le_bytes(*word)).collect()
    };
    let words_of_header = words(header, 4);
    match words_of_header[..] {
        [2, all, own, JSON] if all as usize <= bytes.len() && all.checked_sub(20) >= Some(own) => {
            let (json, rest) = bytes[20..all as usize].split_at(own as usize);
            let chunk = match words(rest, 2)[..] {
                [length, BIN] => rest[8..].get(..length as usize),
                _ => None,
            };
            Ok([json, chunk.unwrap_or_default()])
        }
        _ => {
            let value = format_args!("{words_of_header:?}");
            Err(Refusal::new("header", value, "that of a whole GLB 2: export it again"))
        }
    }
}
