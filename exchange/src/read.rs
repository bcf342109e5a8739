//! Readers of files: each finds the lights, in the words of its system.

pub(crate) mod babylon;
pub(crate) mod eulumdat;
pub(crate) mod gdtf;
pub(crate) mod gltf;
pub(crate) mod godot;
pub(crate) mod ies;
mod json;
pub(crate) mod ofl;
pub(crate) mod pbrt;
pub(crate) mod photometry;
mod scene;
#[cfg(test)]
mod tests;
pub(crate) mod three;
pub(crate) mod unity;
pub(crate) mod unreal;
pub(crate) mod usd;
pub(crate) mod x3d;
mod xml;

use crate::record::Record;
use crate::refusal::Refusal;

/// What a reader of scenes finds. A light that cannot be read does not hide the others.
#[derive(Debug, Default)]
pub(crate) struct Found {
    pub(crate) records: Vec<Record>,
    pub(crate) refused: Vec<Refusal>,
    /// What holds for the whole file: what was left out.
    pub(crate) notes: Vec<String>,
}
