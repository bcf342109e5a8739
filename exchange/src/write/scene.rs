//! Scenes of lights, and beside each an IES profile of every light whose intensities its numbers do not hold.

use luminaire_export::{Language, names};

use super::node::{Entry, Node, node};
use super::{gltf, usd};
use crate::refusal::Refusal;
use crate::system::System;

/// What writes a scene.
type Writer = fn(&[Node]) -> String;

/// Returns what a scene of a tool is called behind its name, and what writes it; `None` for a tool without one.
fn kind(tool: System) -> Option<(&'static str, Writer)> {
    match tool {
        System::Usd => Some(("usda", usd::text)),
        System::Gltf => Some(("gltf", gltf::text)),
        _ => None,
    }
}

/// Returns the extension of a scene of a tool; `None` for a tool without one that is written.
pub fn extension(tool: System) -> Option<&'static str> {
    kind(tool).map(|(extension, _)| extension)
}

/// Returns the files of a scene by their names: a stage of USD or a scene of glTF, and its profiles.
///
/// `stem` is the name of the scene without its extension; a profile is `stem-name.ies`, with the light's name as an
/// identifier. A light has a profile if its parameters are not [exact](Parameters::is_exact).
///
/// # Errors
/// A tool without a scene to write.
pub fn scene(tool: System, stem: &str, lights: &[Entry]) -> Result<Vec<(String, String)>, Refusal> {
    let refused = || Refusal::new("tool", tool, "usd or gltf, whose scenes are written");
    let (extension, write) = kind(tool).ok_or_else(refused)?;
    let names = names(lights.iter().map(|entry| entry.lamp.name.as_str()), Language::Json);
    let nodes: Vec<_> = lights.iter().zip(names).map(|(entry, name)| node(entry, name, stem)).collect();
    let files = nodes.iter().filter_map(|node| node.profile.as_ref());
    let files = files.map(|profile| (profile.file.clone(), profile.text.clone()));
    Ok([(format!("{stem}.{extension}"), write(&nodes))].into_iter().chain(files).collect())
}
