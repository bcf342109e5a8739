//! Readers of files: each finds the lights, in the words of its system.

pub(crate) mod babylon;
pub(crate) mod eulumdat;
pub(crate) mod gdtf;
pub(crate) mod gltf;
pub(crate) mod godot;
pub(crate) mod ies;
mod json;
pub(crate) mod mvr;
pub(crate) mod ofl;
pub(crate) mod pbrt;
pub(crate) mod photometry;
mod scene;
#[cfg(test)]
mod tests;
pub(crate) mod three;
pub(crate) mod unity;
pub(crate) mod unreal;
mod uri;
pub(crate) mod usd;
pub(crate) mod x3d;
mod xml;
mod zip;

pub(crate) use self::json::members;

use std::fmt::Display;

use glam::{DAffine3, DMat3, DVec3};

use crate::record::{Kind, Record};
use crate::refusal::Refusal;

/// The most lights of a file, which bounds the time and the memory.
const LIGHTS: usize = 10_000;

/// What a reader of scenes finds. A light that cannot be read does not hide the others.
#[derive(Debug, Default)]
pub(crate) struct Found {
    pub(crate) records: Vec<Record>,
    pub(crate) refused: Vec<Refusal>,
    /// What holds for the whole file: what was left out.
    pub(crate) notes: Vec<String>,
}

impl Found {
    /// Notes how many lights are left out because the file does not show them.
    pub(crate) fn hide(&mut self, count: usize) {
        let note = || format!("lights that are off or hidden are left out: {count}");
        self.notes.extend((count > 0).then(note));
    }

    /// Notes that lights move or change, if the file has an animation.
    pub(crate) fn rest(&mut self, is_animated: bool) {
        let note = || "the animations are not read: lights are as the file has them at rest".to_owned();
        self.notes.extend(is_animated.then(note));
    }

    /// Adds a light of a node, moved by the transform from the node to the world, or its refusal.
    ///
    /// # Errors
    /// More than 10,000 lights.
    pub(crate) fn add(
        &mut self,
        place: impl Display,
        light: Result<(Record, DAffine3), Refusal>,
    ) -> Result<(), Refusal> {
        if self.records.len() + self.refused.len() >= LIGHTS {
            let expected = format_args!("at most {LIGHTS}: export a part of the scene");
            return Err(Refusal::new("lights", "more", expected));
        }
        let placed = light.and_then(|(mut record, world)| {
            record.position = world.transform_point3(record.position);
            let axis = world.transform_vector3(record.axis);
            let has_axis = match record.kind {
                Kind::Spot | Kind::Directional => true,
                Kind::Point => record.profile.is_some(),
                Kind::Ambient => false,
            };
            // Not normalized: its square may overflow. A point light may have none, but for its profile.
            record.axis = if !has_axis { DVec3::NEG_Z } else { axis / axis.abs().max_element() };
            if !(record.position.is_finite() && record.axis.is_finite()) {
                let value = format_args!("{} along {}", record.position, record.axis);
                return Err(Refusal::new("position", value, "finite numbers, and an axis that is not 0"));
            }
            if !(world.matrix3.transpose() * world.matrix3).abs_diff_eq(DMat3::IDENTITY, 1e-4) {
                record.note("its nodes scale: lengths such as a radius or a range are those of the file");
            }
            Ok(record)
        });
        match placed {
            Ok(record) => self.records.push(record),
            Err(refusal) => self.refused.push(refusal.at(place)),
        }
        Ok(())
    }
}
