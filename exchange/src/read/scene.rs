//! What the readers of text scenes share: tokens, numbers, and lights below their parents.

use std::collections::BTreeMap;

use glam::{DAffine3, DMat4, DVec3, DVec4};

use super::Found;
use crate::record::{Kind, Record, Value, linear};
use crate::refusal::Refusal;

/// Tokens of USD, VRML and pbrt: names, numbers, texts in `"`, and each of `=()[]{}`.
#[derive(Clone)]
pub(crate) struct Scan<'a> {
    rest: &'a str,
    counted: &'a str,
    line: usize,
}

impl<'a> Scan<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Self { rest: text, counted: text, line: 1 }
    }

    /// Returns the line of the last token.
    pub(crate) fn line(&mut self) -> usize {
        self.line += self.counted[..self.counted.len() - self.rest.len()].matches('\n').count();
        self.counted = self.rest;
        self.line
    }

    pub(crate) fn peek(&self) -> Option<&'a str> {
        self.clone().next()
    }

    /// Returns the next token, or all from a bracket to the one that closes it.
    pub(crate) fn value(&mut self) -> &'a str {
        let (start, mut depth) = (self.rest, 0_usize);
        for token in self.by_ref() {
            match token {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
        start[..start.len() - self.rest.len()].trim()
    }

    /// Returns the numbers that follow, with or without square brackets.
    pub(crate) fn numbers(&mut self) -> &'a str {
        let start = self.rest;
        while self.peek().is_some_and(|token| "[]".contains(token) || !numbers(token).is_empty()) {
            self.next();
        }
        &start[..start.len() - self.rest.len()]
    }

    /// Returns the error of a file whose brackets do not match.
    pub(crate) fn unmatched(&mut self) -> Refusal {
        Refusal::new("brackets", "unmatched", "a complete file").at(format_args!("line {}", self.line()))
    }
}

impl<'a> Iterator for Scan<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let space = |c: char| c.is_whitespace() || ",;".contains(c);
        let mut rest = self.rest.trim_start_matches(space);
        while rest.starts_with('#') {
            rest = rest.split_once('\n').map_or("", |(_, rest)| rest.trim_start_matches(space));
        }
        let mut escaped = false;
        let mut closes = |c| (c == '"' && !escaped, escaped = c == '\\' && !escaped).0;
        let length = match rest.chars().next()? {
            '"' if rest.starts_with("\"\"\"") => rest[3..].find("\"\"\"").map(|end| end + 6),
            '"' => rest[1..].find(&mut closes).map(|end| end + 2),
            first if "=()[]{}".contains(first) => Some(1),
            _ => rest.find(|c| space(c) || "#\"=()[]{}".contains(c)),
        };
        let (token, rest) = rest.split_at(length.unwrap_or(rest.len()));
        self.rest = rest;
        Some(token)
    }
}

/// Returns the numbers in a text, at most 16; true is 1 and false 0.
pub(crate) fn numbers(text: &str) -> Vec<f64> {
    let lines = text.lines().filter_map(|line| line.split('#').next());
    let words = lines.flat_map(|line| line.split(|c: char| c.is_whitespace() || "()[]{},;:=".contains(c)));
    let number = |word: &str| match word {
        "true" | "True" | "TRUE" => Some(1.0),
        "false" | "False" | "FALSE" => Some(0.0),
        // Not `inf` and `nan`, which are names in most languages.
        _ => word.parse().ok().filter(|_| !word.ends_with(char::is_alphabetic)),
    };
    words.filter_map(number).take(16).collect()
}

/// Returns whether a word is in a list with spaces between.
pub(crate) fn among(list: &str, word: &str) -> bool {
    list.split(' ').any(|own| own == word)
}

/// Returns the linear colour of components in sRGB.
pub(crate) fn color(components: impl IntoIterator<Item = f64>) -> Value {
    Value::Numbers(components.into_iter().take(3).map(linear).collect())
}

/// Returns the value of ` key=value` in a heading, without quotation marks.
pub(crate) fn attribute<'a>(heading: &'a str, key: &str) -> &'a str {
    let value = heading.split_once(&format!(" {key}=")).map_or("", |(_, value)| value);
    let quoted = value.strip_prefix('"').map(|value| value.split('"'));
    quoted.map_or_else(|| value.split([' ', ']']).next(), |mut parts| parts.next()).unwrap_or("")
}

/// Returns the rotation by an angle in radians about an axis of any length.
pub(crate) fn rotation(axis: DVec3, angle: f64) -> DAffine3 {
    DAffine3::from_axis_angle(axis.normalize_or(DVec3::Z), angle)
}

/// A node of a scene in the words of its file.
#[derive(Default)]
pub(crate) struct Block<'a> {
    pub(crate) kind: &'a str,
    pub(crate) name: &'a str,
    pub(crate) line: usize,
    /// The nodes above: `OUTSIDE`, or several for a node that is used again.
    pub(crate) parents: Vec<usize>,
    pub(crate) values: BTreeMap<&'a str, &'a str>,
}

/// A parent that is not in the file.
pub(crate) const OUTSIDE: usize = usize::MAX;

impl<'a> Block<'a> {
    /// Returns a value without quotation marks.
    pub(crate) fn get(&self, key: &str) -> &'a str {
        self.values.get(key).map_or("", |value| value.trim().trim_matches('"'))
    }

    pub(crate) fn has(&self, key: &str) -> bool {
        self.values.contains_key(key)
    }

    pub(crate) fn refused(&self, key: &str, expected: &str) -> Refusal {
        Refusal::new(key, self.get(key), expected)
    }

    /// Returns the numbers of a value, or the default of a value that is not there.
    pub(crate) fn numbers<const N: usize>(&self, key: &str, default: [f64; N]) -> Result<[f64; N], Refusal> {
        let value = self.values.get(key).map_or(default.to_vec(), |value| numbers(value));
        value.try_into().map_err(|_| self.refused(key, &format!("{N} numbers")))
    }

    pub(crate) fn vector(&self, key: &str, default: f64) -> Result<DVec3, Refusal> {
        self.numbers(key, [default; 3]).map(DVec3::from)
    }

    /// Returns the transform of 16 numbers, of which the last four are the translation and 1.
    pub(crate) fn matrix(&self, key: &str) -> Result<DAffine3, Refusal> {
        let matrix = DMat4::from_cols_array(&self.numbers(key, [0.0; 16])?);
        let affine = (matrix.row(3) == DVec4::W).then(|| DAffine3::from_mat4(matrix));
        affine.ok_or_else(|| self.refused(key, "an affine transform"))
    }
}

/// The words of a system, in lists with spaces between.
pub(crate) struct System {
    /// The kinds of lights: spot, point, directional, and those that are refused.
    pub(crate) kinds: [&'static str; 4],
    pub(crate) axis: DVec3,
    /// The values of a light that are read.
    pub(crate) keys: &'static str,
    /// `key=number`: values that change a light and are not read, unless they have this number.
    pub(crate) others: &'static str,
    /// `key=value`: a node and those below it are off.
    pub(crate) off: &'static str,
    /// Kinds and values of any node by which a file refers to what is not read.
    pub(crate) outside: &'static str,
}

/// The most nodes of a file.
const MOST: usize = 1 << 18;

/// Adds a node and returns its index.
pub(crate) fn add<'a>(blocks: &mut Vec<Block<'a>>, block: Block<'a>) -> Result<usize, Refusal> {
    blocks.push(block);
    let index = blocks.len() - 1;
    (index < MOST).then_some(index).ok_or_else(|| Refusal::new("nodes", "more", "at most 262144"))
}

/// Returns the lights among the nodes, in the world. `local` returns the transform of a node to its
/// parents, and `light` completes a record.
pub(crate) fn lights(
    system: &System,
    blocks: &[Block],
    local: impl Fn(&Block) -> Result<DAffine3, Refusal>,
    light: impl Fn(&Block, &mut Record) -> Result<(), Refusal>,
) -> Result<Found, Refusal> {
    let (mut found, mut steps, mut hidden) = (Found::default(), 0, 0);
    for (index, block) in blocks.iter().enumerate().filter(|(_, block)| !block.kind.is_empty()) {
        let Some(kind) = system.kinds.iter().position(|kinds| among(kinds, block.kind)) else { continue };
        let kind = [Kind::Spot, Kind::Point, Kind::Directional].get(kind);
        let refusal = || Refusal::new(block.kind, block.name, "a spot, point or directional light");
        let record = kind.ok_or_else(refusal).and_then(|&kind| {
            let mut record = record(system, block, kind);
            light(block, &mut record).map(|()| record)
        });
        let mut paths = vec![(index, DAffine3::IDENTITY, 0)];
        while let Some((at, below, depth)) = paths.pop() {
            steps += 1;
            if steps > 4 * MOST {
                return Err(Refusal::new("parents", "of lights", "at most 1048576"));
            }
            let node = blocks.get(at).filter(|_| depth < blocks.len());
            let is = |(key, value): (&str, &str)| node.is_some_and(|node| node.get(key) == value);
            if system.off.split(' ').filter_map(|pair| pair.split_once('=')).any(is) {
                hidden += 1;
                continue;
            }
            let outside =
                || Refusal::new("parent", "not in the file, or in a cycle", "all parents in one file");
            match (node.ok_or_else(outside).and_then(&local), node.map(|node| &*node.parents)) {
                (Ok(own), Some(parents @ [_, ..])) => {
                    paths.extend(parents.iter().rev().map(|&parent| (parent, own * below, depth + 1)));
                }
                (own, _) => {
                    let light = own.and_then(|own| Ok((record.clone()?, own * below)));
                    found.add(format_args!("line {}", block.line), light)?;
                }
            }
        }
    }
    if hidden > 0 {
        found.notes.push(format!("lights that are off or hidden are left out: {hidden}"));
    }
    let used =
        |word: &&str| !word.is_empty() && blocks.iter().any(|block| block.kind == *word || block.has(word));
    let outside = system.outside.split(' ').filter(used);
    found.notes.extend(outside.map(|word| format!("what `{word}` adds or changes is not read")));
    Ok(found)
}

/// Returns the record of a light, at the origin of its node.
fn record(system: &System, block: &Block, kind: Kind) -> Record {
    let mut record = Record::new(block.name, kind, format_args!("line {}", block.line));
    record.axis = system.axis;
    for key in system.keys.split(' ').filter(|key| block.has(key)) {
        let numbers = numbers(block.get(key));
        let word = Value::Word(block.get(key).to_owned());
        record.set(key, if numbers.is_empty() { word } else { Value::Numbers(numbers) });
    }
    for (key, neutral) in system.others.split(' ').filter_map(|pair| pair.split_once('=')) {
        let numbers = numbers(block.get(key));
        let neutral = numbers.iter().any(|number| neutral.parse() == Ok(*number));
        if block.has(key) && !neutral {
            record.note(format!("`{key}` is not read"));
        }
    }
    record
}
