//! Scenes and fixtures in JSON: bounded parsing, the values of lights, and the transforms of nodes.

use glam::{DAffine3, DMat4, DVec3};
use serde::de::DeserializeOwned;

use crate::record::{Record, Value};
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
/// `point` of them, and a directional light the first `directional`.
pub(crate) fn fill(
    mut record: Record,
    notes: &[(bool, &str)],
    color: Option<[f64; 3]>,
    values: &[(&str, &Member<f64>)],
    [point, directional]: [usize; 2],
) -> Result<Record, Refusal> {
    record.notes.extend(notes.iter().filter(|(holds, _)| *holds).map(|(_, note)| (*note).to_owned()));
    let count = [values.len(), point, directional][record.kind as usize];
    let numbers = values[..count].iter().filter_map(|(name, value)| Some((*name, vec![*value.as_deref()?])));
    for (name, numbers) in color.map(|color| ("color", color.to_vec())).into_iter().chain(numbers) {
        if let Some(negative) = numbers.iter().find(|number| **number < 0.0) {
            return Err(Refusal::new(name, negative, "at least 0"));
        }
        record.set(name, Value::Numbers(numbers));
    }
    Ok(record)
}

/// Returns the transform from a node to the world, from the transform and the parent of each node.
pub(crate) fn world(
    mut node: usize,
    mut look: impl FnMut(usize) -> (DAffine3, Option<usize>),
) -> Result<DAffine3, Refusal> {
    let mut world = DAffine3::IDENTITY;
    for _ in 0..=PARENTS {
        let (local, parent) = look(node);
        world = local * world;
        let Some(parent) = parent else { return Ok(world) };
        node = parent;
    }
    Err(Refusal::new("parents", "no end", format_args!("at most {PARENTS}, one each, and no cycle")))
}
