//! Scenes and fixtures in JSON: bounded parsing, the values of lights, and the transforms of nodes.

use glam::{DAffine3, DMat4, DVec3};
use serde::de::DeserializeOwned;

use crate::record::{Kind, Record, Value};
use crate::refusal::Refusal;

/// The most objects and arrays of a file. The two bytes of an empty one become up to 128 of memory in
/// a list, whose growth needs 50 MB (measured).
const OBJECTS: usize = 250_000;
/// The most parents of a node, which bounds the time.
const PARENTS: usize = 512;

/// Reads a file.
///
/// # Errors
/// What is not JSON of this shape, over 250,000 objects and arrays, or over 128 levels of them.
pub(crate) fn parse<T: DeserializeOwned>(text: &str) -> Result<T, Refusal> {
    let (mut objects, mut string, mut escaped) = (0, false, false);
    for byte in text.bytes() {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = string,
            b'"' => string = !string,
            b'{' | b'[' if !string => objects += 1,
            _ => {}
        }
    }
    if objects > OBJECTS {
        let expected = format_args!("at most {OBJECTS}: export the lights without the meshes");
        return Err(Refusal::new("objects and arrays", objects, expected));
    }
    serde_json::from_str(text).map_err(|error| {
        let expected =
            "a scene or a fixture in JSON, with at most 128 levels of objects and arrays: export it again";
        let place = format_args!("line {}, column {}", error.line(), error.column());
        Refusal::new("JSON", error.to_string().split(" at line ").next().unwrap_or_default(), expected)
            .at(place)
    })
}

/// A member of an object. Boxed, because most objects have few of the members of their struct.
pub(crate) type Member<T> = Option<Box<T>>;

/// Declares objects of a file by the names and the types of the members that are read. All other
/// members, such as meshes, are skipped without memory.
macro_rules! objects {
    ($($object:ident: $($member:ident $type:ty),+;)+) => {$(
        #[allow(non_snake_case, reason = "the names of the files")]
        #[derive(Default, serde::Deserialize)]
        struct $object { $($member: $crate::read::json::Member<$type>),+ }
    )+};
}
/// Lists the named members of an object.
macro_rules! named {
    ($object:expr, $($member:ident)+) => { [$((stringify!($member), &$object.$member)),+] };
}
pub(crate) use {named, objects};

pub(crate) fn list<T>(member: &Member<Vec<T>>) -> &[T] {
    member.as_deref().map_or(&[], Vec::as_slice)
}

pub(crate) fn word(member: &Member<String>) -> &str {
    member.as_deref().map_or("", String::as_str)
}

pub(crate) fn vector(member: &Member<[f64; 3]>, default: f64) -> DVec3 {
    member.as_deref().map_or(DVec3::splat(default), |own| DVec3::from_array(*own))
}

/// Returns the transform of a matrix, column by column.
pub(crate) fn matrix(columns: &Member<[f64; 16]>) -> DAffine3 {
    DAffine3::from_mat4(columns.as_deref().map_or(DMat4::IDENTITY, DMat4::from_cols_array))
}

/// Returns the index of an element that is there.
pub(crate) fn index(name: &str, index: f64, length: usize) -> Result<usize, Refusal> {
    let whole = index.fract() == 0.0 && (0.0..length as f64).contains(&index);
    let refusal = || Refusal::new(name, index, format_args!("a whole number from 0, below {length}"));
    whole.then_some(index as usize).ok_or_else(refusal)
}

/// Adds to a light the notes that hold and the values that the file has. A point light has the first
/// `point` of them, and directional and ambient light the first `directional`.
pub(crate) fn fill(
    mut record: Record,
    notes: &[(bool, &str)],
    color: Option<[f64; 3]>,
    values: &[(&str, &Member<f64>)],
    [point, directional]: [usize; 2],
) -> Result<Record, Refusal> {
    record.notes.extend(notes.iter().filter(|(holds, _)| *holds).map(|(_, note)| (*note).to_owned()));
    let count = match record.kind {
        Kind::Spot => values.len(),
        Kind::Point => point,
        Kind::Directional | Kind::Ambient => directional,
    };
    let numbers = values[..count].iter().filter_map(|(name, value)| Some((*name, vec![*value.as_deref()?])));
    for (name, numbers) in color.map(|color| ("color", color.to_vec())).into_iter().chain(numbers) {
        if let Some(negative) = numbers.iter().find(|number| **number < 0.0) {
            return Err(Refusal::new(name, negative, "at least 0"));
        }
        record.set(name, Value::Numbers(numbers));
    }
    Ok(record)
}

/// The transform from a node to the world, and two marks, which hold if they do for a node above it, too.
type World = (DAffine3, [bool; 2]);

/// The transforms from nodes to the world, each of which is computed once. Boxed, because few nodes have
/// lights. The second part is the nodes from a light up to one that is known.
pub(crate) struct Worlds(Vec<Option<Box<World>>>, Vec<usize>);

impl Worlds {
    pub(crate) fn new(nodes: usize) -> Self {
        Self(vec![None; nodes], Vec::new())
    }

    /// Returns the transform and the marks of a node, from those of each node to its parent.
    ///
    /// # Errors
    /// More than 512 parents, as in a cycle.
    pub(crate) fn of(
        &mut self,
        node: usize,
        local: impl Fn(usize) -> World,
        parent: impl Fn(usize) -> Option<usize>,
    ) -> Result<World, Refusal> {
        let Self(known, chain) = self;
        let (mut next, mut world) = (Some(node), (DAffine3::IDENTITY, [false; 2]));
        chain.clear();
        while let Some(at) = next {
            if let Some(known) = &known[at] {
                world = **known;
                break;
            }
            if chain.len() > PARENTS {
                let expected = format_args!("at most {PARENTS}, one each, and no cycle");
                return Err(Refusal::new("parents", "no end", expected));
            }
            chain.push(at);
            next = parent(at);
        }
        for &at in chain.iter().rev() {
            let (own, [a, b]) = local(at);
            world = (world.0 * own, [world.1[0] | a, world.1[1] | b]);
            known[at] = Some(Box::new(world));
        }
        Ok(world)
    }
}

/// Returns the names of the members of the outermost object, whatever their order and what follows a mistake.
pub(crate) fn members(text: &str) -> Vec<&str> {
    let (mut found, mut depth, mut string, mut escaped) = (Vec::new(), 0_usize, None, false);
    let mut last = "";
    for (at, byte) in text.bytes().enumerate() {
        match (byte, string) {
            _ if escaped => escaped = false,
            (b'\\', Some(_)) => escaped = true,
            (b'"', None) => string = Some(at + 1),
            (b'"', Some(start)) => (last, string) = (&text[start..at], None),
            (b'{' | b'[', None) => depth += 1,
            (b'}' | b']', None) => depth = depth.saturating_sub(1),
            (b':', None) if depth == 1 => found.push(last),
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    /// Of a chain of 400 nodes, each transform is computed once for 400 lights.
    #[test]
    fn worlds_are_computed_once_a_node() {
        let (mut worlds, calls) = (Worlds::new(400), Cell::new(0));
        let local = |at: usize| {
            calls.set(calls.get() + 1);
            (DAffine3::from_translation(DVec3::X), [at == 3, at == 500])
        };
        for node in (0..400).rev() {
            let (world, marks) = worlds.of(node, local, |at| at.checked_sub(1)).unwrap();
            assert_eq!((world.translation.x, marks), ((node + 1) as f64, [node >= 3, false]));
        }
        assert_eq!(calls.get(), 400);
    }
}
