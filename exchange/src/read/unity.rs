//! Scenes and prefabs of Unity as text: `.unity` and `.prefab`.

use std::collections::HashMap;

use glam::{DAffine3, DQuat, DVec3};

use super::Found;
use super::scene::{Block, OUTSIDE, System, Values, add, among, color, length, lights, unmatched};
use crate::record::Kind;
use crate::refusal::Refusal;

const SYSTEM: System = System {
    kinds: ["spot", "point", "directional", "ambient", "area"],
    axis: DVec3::Z,
    keys: "m_Intensity m_Range m_SpotAngle m_InnerSpotAngle m_LightUnit m_UseColorTemperature m_ColorTemperature",
    others: "m_Cookie=0 m_Shape=0 m_CullingMask=2,4294967295 m_RenderingLayerMask=1",
    never: "",
    off: "m_IsActive=0 m_Enabled=0",
    outside: "m_SourcePrefab Animator Animation",
};

/// Returns the lights, with the keys of the file, and `color`, which is linear.
pub(crate) fn read(text: &str) -> Result<Found, Refusal> {
    let (mut blocks, mut indices, mut places, mut line) = (Vec::new(), HashMap::new(), HashMap::new(), 1);
    // A document begins a line; in a text, lines are indented.
    for document in text.split("\n--- !u!") {
        let document = document.strip_prefix("--- !u!").unwrap_or(document);
        let mut words = document.split_whitespace();
        let (kind, name) = (words.next().unwrap_or(""), words.next().unwrap_or("").trim_start_matches('&'));
        if among("1 4 104 108 1001", kind) {
            let values = fields(document).ok_or_else(|| unmatched(line))?;
            let block = Block { kind, name, line, values, ..Block::default() };
            if kind == "4" {
                places.insert(id(&block, "m_GameObject"), blocks.len());
            }
            indices.insert(name, add(&mut blocks, block)?);
        } else if let Some((_, kind)) =
            [("95", "Animator"), ("111", "Animation")].iter().find(|own| own.0 == kind)
        {
            add(&mut blocks, Block { kind, ..Block::default() })?;
        }
        line += document.matches('\n').count() + 1;
    }
    if places.is_empty() {
        let expected = "text: Project Settings, Editor, Asset Serialization, Force Text";
        return Err(Refusal::new("file", "without transforms", expected));
    }
    let mut is_sky = false;
    // Light, its object, its transform, the object of the transform above.
    for index in 0..blocks.len() {
        let (block, father) = (&blocks[index], id(&blocks[index], "m_Father"));
        let above = match block.kind {
            "1" => places.get(block.name),
            "104" => None,
            "4" => indices.get(father).and_then(|&father| indices.get(id(&blocks[father], "m_GameObject"))),
            _ => indices.get(id(block, "m_GameObject")),
        };
        let (above, name) = (above.copied(), above.map(|&above| blocks[above].values.get("m_Name")));
        let block = &mut blocks[index];
        if block.kind == "104" {
            // The settings of a scene. 3 is one colour, and the others are a sky or a gradient.
            let mode = block.get("m_AmbientMode");
            is_sky = is_sky || mode != "3";
            (block.kind, block.name) = (if mode == "3" { "ambient" } else { "" }, "ambient");
            continue;
        }
        if block.kind != "4" || father != "0" {
            block.parents.push(above.unwrap_or(OUTSIDE));
        }
        if block.kind == "108" {
            let kinds = [("0", "spot"), ("1", "directional"), ("2", "point")];
            let kind = kinds.iter().find(|(number, _)| *number == block.get("m_Type"));
            (block.kind, block.name) =
                (kind.map_or("area", |(_, kind)| kind), name.flatten().unwrap_or("").trim());
        }
    }
    let mut found = lights(&SYSTEM, &blocks, local, |block, record| {
        let (key, default) = if record.kind == Kind::Ambient {
            ("m_AmbientSkyColor", [0.212, 0.227, 0.259, 1.0])
        } else {
            ("m_Color", [1.0; 4])
        };
        record.set("color", color(block.numbers(key, default)?));
        Ok(())
    })?;
    found.notes.extend(is_sky.then(|| "ambient light of a sky or a gradient is left out".to_owned()));
    found.notes.push("positions and axes are in the left-handed system of Unity, with y up".to_owned());
    Ok(found)
}

/// Returns the fields of a document, at two spaces. A value goes on in lines with more, and a text to its end;
/// `None` if it has none.
fn fields(document: &str) -> Option<Values<'_>> {
    let (mut values, mut rest) = (Values::default(), document);
    while let Some((_, field)) = rest.split_once("\n  ") {
        rest = field;
        let Some(colon) = field.find([':', '\n']).filter(|&at| field[at..].starts_with(':')) else {
            continue;
        };
        if field.starts_with([' ', '-']) {
            continue;
        }
        let value = field[colon + 1..].trim_start_matches(' ');
        let end = match value.chars().next() {
            Some(quote @ ('"' | '\'')) => {
                let mut end = 0;
                loop {
                    let (length, ends) = length(&value[end + 1..], &value[..1], quote == '"', true);
                    end += 1 + length;
                    if !ends {
                        return None;
                    }
                    // In a text of one quote, two are one.
                    if quote == '"' || !value[end..].starts_with('\'') {
                        break end;
                    }
                }
            }
            _ => {
                let goes_on = |at: usize| ["   ", "  -"].iter().any(|deep| value[at + 1..].starts_with(deep));
                value.match_indices('\n').map(|(at, _)| at).find(|&at| !goes_on(at)).unwrap_or(value.len())
            }
        };
        values.insert(&field[..colon], &value[..end]);
        rest = &value[end..];
    }
    values.sort();
    Some(values)
}

/// Returns the identifier of another document; 0 is none.
fn id<'a>(block: &Block<'a>, key: &str) -> &'a str {
    let id = block.get(key).split_once("fileID:").map_or("0", |(_, id)| id.trim());
    &id[..id.find([',', '}']).unwrap_or(id.len())]
}

/// Returns the transform of a `Transform`.
fn local(block: &Block) -> Result<DAffine3, Refusal> {
    if block.kind != "4" {
        return Ok(DAffine3::IDENTITY);
    }
    if !block.has("m_LocalPosition") {
        return Err(block.refused("m_LocalPosition", "a transform in this file, not in a prefab"));
    }
    let turn = DQuat::from_array(block.numbers("m_LocalRotation", [0.0, 0.0, 0.0, 1.0])?).normalize();
    let (scale, position) = (block.vector("m_LocalScale", 1.0)?, block.vector("m_LocalPosition", 0.0)?);
    Ok(DAffine3::from_scale_rotation_translation(scale, turn, position))
}
