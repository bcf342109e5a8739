//! Scenes of X3D as XML (`.x3d`), and of VRML97 and X3D as text (`.wrl`, `.x3dv`).

use std::collections::HashMap;

use super::scene::{Block, Scan, System, add, among, lights, numbers, rotation};
use super::{Found, xml};
use crate::refusal::Refusal;
use glam::{DAffine3, DVec3};

const SYSTEM: System = System {
    kinds: ["SpotLight", "PointLight", "DirectionalLight", "EnvironmentLight"],
    axis: DVec3::NEG_Z,
    keys: "color intensity ambientIntensity attenuation radius beamWidth cutOffAngle",
    others: "",
    off: "on=FALSE on=0",
    outside: "Inline PROTO EXTERNPROTO ProtoInstance ROUTE USE",
};
const FIELDS: &str = "color intensity ambientIntensity attenuation radius beamWidth cutOffAngle location direction \
                      on translation rotation scale scaleOrientation center";

/// Returns the lights, with the names of their fields as keys, but for `location`, `direction` and `on`.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    let header = text.trim_start().lines().next().unwrap_or("");
    match header.get(..7).unwrap_or(header) {
        _ if header.starts_with('<') => {
            let (text, version) = from_xml(text)?;
            classic(&text, version)
        }
        "#VRML V" | "#X3D V3" | "#X3D V4" if !header.contains("V1.0") => {
            let version = header.split_once(" V").and_then(|(_, rest)| rest.get(..3)?.parse().ok());
            classic(text, version.unwrap_or(4.0))
        }
        _ => Err(Refusal::new("file", header, "#VRML V2.0 utf8, #X3D, or XML")),
    }
}

/// Returns a file in XML as text, with the nodes on the same lines, and its version.
fn from_xml(text: &str) -> Result<(String, f64), Refusal> {
    let document = xml::document(text)?;
    let (mut classic, mut open, mut before) = (String::new(), Vec::new(), 0);
    for element in document.root().descendants().filter(|node| node.is_element()) {
        while !open.is_empty() && element.parent().map(|parent| parent.id()) != open.last().copied() {
            open.pop();
            classic.push('}');
        }
        open.push(element.id());
        let start = element.range().start;
        classic.extend(text.get(before..start).unwrap_or("").matches('\n'));
        before = start.max(before);
        let quoted = |key| format!("{key} \"{}\"", element.attribute(key).unwrap_or("").replace('"', "'"));
        classic += &match element.has_attribute("USE") {
            true => format!(" Group {{ {}", quoted("USE")),
            false => format!(" {} {} {{", quoted("DEF"), element.tag_name().name()),
        };
        for field in element.attributes().filter(|field| among(FIELDS, field.name())) {
            let numbers: Vec<String> = numbers(field.value()).iter().map(f64::to_string).collect();
            classic += &format!(" {} {}", field.name(), numbers.join(" "));
        }
    }
    classic.extend(open.iter().map(|_| '}'));
    match document.root_element().tag_name().name() {
        "X3D" => {
            let version = document.root_element().attribute("version").and_then(|text| text.parse().ok());
            Ok((classic, version.unwrap_or(4.0)))
        }
        root => Err(Refusal::new("file", root, "the element X3D")),
    }
}

/// Reads a text of a version, by which the defaults differ; VRML97 is version 2.
fn classic(text: &str, version: f64) -> Result<Found, Refusal> {
    let (mut scan, mut blocks, mut open) = (Scan::new(text), vec![Block::default()], vec![0]);
    let (mut name, mut named) = ("", HashMap::<_, usize>::new());
    while let Some(token) = scan.next() {
        let above = *open.last().ok_or_else(|| scan.unmatched())?;
        match token {
            "DEF" => name = scan.next().unwrap_or("").trim_matches('"'),
            // Only nodes that are complete have a name, so that there are no cycles.
            "USE" => match scan.next().and_then(|name| named.get(name.trim_matches('"'))) {
                Some(&index) => blocks[index].parents.push(above),
                None => drop(blocks[0].values.insert(token, "")),
            },
            "ROUTE" | "PROTO" | "EXTERNPROTO" => {
                blocks[0].values.insert(token, "");
                // The name, the interface and the body of a prototype.
                for _ in 0..if token == "PROTO" { 3 } else { 2 } {
                    scan.value();
                }
            }
            "}" => drop(open.pop().map(|index| named.insert(blocks[index].name, index))),
            "{" | "[" | "]" => {}
            kind if scan.peek() == Some("{") => {
                let (name, line, parents) = (std::mem::take(&mut name), scan.line(), vec![above]);
                open.push(add(&mut blocks, Block { kind, name, line, parents, ..Block::default() })?);
            }
            field => drop(blocks[above].values.insert(field, scan.numbers())),
        }
    }
    if open.len() != 1 {
        return Err(scan.unmatched());
    }
    lights(&SYSTEM, &blocks, local, |block, record| {
        record.position = block.vector("location", 0.0)?;
        record.axis = block.numbers("direction", [0.0, 0.0, -1.0])?.into();
        record.number("version", version);
        Ok(())
    })
}

/// Returns the transform of a node (X3D, 10.4.4).
fn local(block: &Block) -> Result<DAffine3, Refusal> {
    let turn = |name| {
        let [x, y, z, angle] = block.numbers(name, [0.0, 0.0, 1.0, 0.0])?;
        Ok::<_, Refusal>(rotation(DVec3::new(x, y, z), angle))
    };
    match block.kind {
        "Transform" => {
            let (center, to) = (block.vector("center", 0.0)?, block.vector("translation", 0.0)?);
            let (turned, stretched) = (turn("rotation")?, turn("scaleOrientation")?);
            let scale = stretched * DAffine3::from_scale(block.vector("scale", 1.0)?) * stretched.inverse();
            let moved = DAffine3::from_translation(to + center);
            Ok(moved * turned * scale * DAffine3::from_translation(-center))
        }
        "" | "X3D" | "Scene" | "Group" | "StaticGroup" | "Anchor" | "Collision" | "Layer" | "LayerSet"
        | "SpotLight" | "PointLight" | "DirectionalLight" => Ok(DAffine3::IDENTITY),
        other => Err(Refusal::new("parent", other, "Transform, Group, Anchor or Collision")),
    }
}
