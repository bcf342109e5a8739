//! Scenes of X3D as XML (`.x3d`), and of VRML97 and X3D as text (`.wrl`, `.x3dv`).

use std::collections::HashMap;

use super::scene::{Block, Scan, System, WORLD, add, among, lights, numbers, rotation};
use super::{Found, xml};
use crate::record::{Kind, Record, Value};
use crate::refusal::Refusal;
use glam::{DAffine3, DVec3};

const SYSTEM: System = System {
    kinds: ["SpotLight", "PointLight", "DirectionalLight", "", "EnvironmentLight"],
    axis: DVec3::NEG_Z,
    keys: "color intensity ambientIntensity attenuation radius beamWidth cutOffAngle",
    others: "",
    never: "",
    off: "on=FALSE on=false on=0",
    outside: "Inline PROTO EXTERNPROTO ProtoInstance ROUTE USE",
};
const FIELDS: &str = "color intensity ambientIntensity attenuation radius beamWidth cutOffAngle location direction \
                      on global translation rotation scale scaleOrientation center";

/// Returns the lights, with the names of their fields as keys, but for `location`, `direction` and `on`.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    let header = text.trim_start().lines().next().unwrap_or("");
    match header.get(..7).unwrap_or(header) {
        _ if header.starts_with('<') => from_xml(text),
        "#VRML V" | "#X3D V3" | "#X3D V4" if !header.starts_with("#VRML V1") => {
            let version = header.split_once(" V").and_then(|(_, rest)| rest.get(..3)?.parse().ok());
            classic(text, version.unwrap_or(4.0))
        }
        _ => Err(Refusal::new("file", header, "#VRML V2.0 utf8, #X3D, or XML")),
    }
}

/// The nodes of a world, and those that are not complete.
struct World<'a> {
    blocks: Vec<Block<'a>>,
    open: Vec<usize>,
    named: HashMap<&'a str, usize>,
}

impl<'a> World<'a> {
    fn new() -> Self {
        Self { blocks: vec![Block::default()], open: vec![0], named: HashMap::new() }
    }

    fn begin(&mut self, kind: &'a str, name: &'a str, line: usize) -> Result<(), Refusal> {
        let parents = self.open.last().copied().into_iter().collect();
        self.open.push(add(&mut self.blocks, Block { kind, name, line, parents, ..Block::default() })?);
        Ok(())
    }

    /// Ends a node. Only complete ones have a name, so that there are no cycles.
    fn end(&mut self) {
        if let Some(index) = self.open.pop() {
            self.named.insert(self.blocks[index].name, index);
        }
    }

    fn again(&mut self, name: &str) {
        match (self.named.get(name), self.open.last()) {
            (Some(&index), Some(&above)) => self.blocks[index].parents.push(above),
            _ => self.blocks[0].values.insert("USE", ""),
        }
    }

    fn set(&mut self, field: &'a str, value: &'a str) {
        if let Some(&index) = self.open.last() {
            self.blocks[index].values.insert(field, value);
        }
    }

    /// Returns the lights of a version, by which the defaults differ; VRML97 is version 2.
    fn lights(mut self, version: f64) -> Result<Found, Refusal> {
        self.blocks.iter_mut().for_each(|block| block.values.sort());
        // A light that is not global lights the nodes of its group alone.
        let is_local = |block: &Block| {
            let own = numbers(block.get("global"));
            let is_global = own.first().map_or(block.kind != "DirectionalLight", |own| *own != 0.0);
            let above = block.parents.first().map_or("", |&above| self.blocks[above].kind);
            !is_global && !among(" X3D Scene", above)
        };
        let mut found = lights(&SYSTEM, &self.blocks, local, |block, record| {
            record.position = block.vector("location", 0.0)?;
            record.axis = block.numbers("direction", [0.0, 0.0, -1.0])?.into();
            record.number("version", version);
            if is_local(block) {
                record.note("`global` is not read: in the file it lights its own group alone");
            }
            Ok(())
        })?;
        // Only of a directional light, the ambient part is the same everywhere.
        let mut surrounding = Vec::new();
        for record in found.records.iter_mut().filter(|record| record.kind == Kind::Directional) {
            let Some(strength) = record.take("ambientIntensity") else { continue };
            let mut own = Record::new(&format!("{} ambient", record.name), Kind::Ambient, &record.place);
            own.set("color", Value::Numbers(record.triple("color", [1.0; 3])?.to_vec()));
            own.set("ambientIntensity", strength);
            own.note("X3D multiplies it by the `ambientIntensity` of each material, 0.2 by default");
            surrounding.push(own);
        }
        found.records.extend(surrounding);
        Ok(found)
    }
}

/// Reads a file in XML.
fn from_xml(text: &str) -> Result<Found, Refusal> {
    let document = xml::document(text)?;
    let root = document.root_element();
    if root.tag_name().name() != "X3D" {
        return Err(Refusal::new("file", root.tag_name().name(), "the element X3D"));
    }
    let (mut world, mut open) = (World::new(), Vec::new());
    let (mut line, mut before) = (1, 0);
    for element in root.descendants().filter(|node| node.is_element()) {
        while !open.is_empty() && element.parent().map(|parent| parent.id()) != open.last().copied() {
            open.pop();
            world.end();
        }
        open.push(element.id());
        let start = element.range().start.max(before);
        line += text[before..start].matches('\n').count();
        before = start;
        match (element.attribute("USE"), element.tag_name().name()) {
            (Some(name), _) => {
                world.again(name);
                world.begin("Group", "", line)?;
            }
            (None, kind) => {
                world.begin(kind, element.attribute("DEF").unwrap_or(""), line)?;
                for field in element.attributes().filter(|field| among(FIELDS, field.name())) {
                    world.set(field.name(), field.value());
                }
            }
        }
    }
    let version = root.attribute("version").and_then(|text| text.parse().ok());
    world.lights(version.unwrap_or(4.0))
}

/// Reads a file as text.
fn classic(text: &str, version: f64) -> Result<Found, Refusal> {
    let (mut scan, mut world, mut name) = (Scan::new(text, &WORLD), World::new(), "");
    while let Some(token) = scan.next() {
        match token {
            "DEF" => name = scan.next().unwrap_or(""),
            "USE" => world.again(scan.next().unwrap_or("")),
            "ROUTE" | "PROTO" | "EXTERNPROTO" => {
                world.blocks[0].values.insert(token, "");
                // From, `TO` and to, or the name, the interface and the body of a prototype.
                for _ in 0..if token == "EXTERNPROTO" { 2 } else { 3 } {
                    scan.value();
                }
            }
            "}" => {
                world.end();
                if world.open.is_empty() {
                    return Err(scan.unmatched());
                }
            }
            "{" | "[" | "]" => {}
            kind if scan.peek() == Some("{") => {
                world.begin(kind, std::mem::take(&mut name), scan.line())?;
                // The brace that is this node's.
                scan.next();
            }
            field => world.set(field, scan.numbers()),
        }
    }
    if world.open.len() != 1 {
        return Err(scan.unmatched());
    }
    scan.whole()?;
    world.lights(version)
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
