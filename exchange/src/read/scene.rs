//! What the readers of text scenes share: tokens, numbers, and lights below their parents.

use glam::{DAffine3, DMat4, DVec3, DVec4};

use super::Found;
use crate::record::{Kind, Record, Value, linear};
use crate::refusal::Refusal;

/// What is text and what is a comment in a language: everything else has structure.
pub(crate) struct Syntax {
    /// What begins and what ends a text, whether a backslash escapes what follows it, and whether the text
    /// may have several lines.
    texts: &'static [(&'static str, &'static str, bool, bool)],
    comments: &'static [(&'static str, &'static str)],
    /// What ends a word, beside spaces and `=()[]{}`.
    marks: &'static str,
}

const HASH: &[(&str, &str)] = &[("#", "\n")];
/// VRML97 and X3D as text.
pub(crate) const WORLD: Syntax = Syntax { texts: &[("\"", "\"", true, true)], comments: HASH, marks: "\"#" };
pub(crate) const PBRT: Syntax = Syntax { texts: &[("\"", "\"", true, false)], ..WORLD };
/// The heading of a node of Godot or of an object of Unreal.
const HEADING: Syntax = Syntax { comments: &[], marks: "\"", ..WORLD };
/// USD: texts, asset paths and paths of prims.
pub(crate) const USD: Syntax = Syntax {
    texts: &[
        ("\"\"\"", "\"\"\"", true, true),
        ("'''", "'''", true, true),
        ("\"", "\"", true, false),
        ("'", "'", true, false),
        ("@@@", "@@@", true, false),
        ("@", "@", false, false),
        ("<", ">", false, false),
    ],
    comments: &[("#", "\n"), ("//", "\n"), ("/*", "*/")],
    marks: "\"#'@<",
};

/// Returns whether a token is a text.
pub(crate) fn is_text(token: &str) -> bool {
    token.starts_with(['"', '\'', '@', '<'])
}

/// Returns a token without the marks around a text.
pub(crate) fn unquoted(token: &str) -> &str {
    let marks = ["\"\"\"", "'''", "@@@", "\"", "'", "@"];
    let inner = |mark| token.strip_prefix(mark).and_then(|rest| rest.strip_suffix(mark));
    marks.into_iter().find_map(inner).unwrap_or(token)
}

/// The tokens of a language: names, numbers, texts, and each of `=()[]{}`.
#[derive(Clone)]
pub(crate) struct Scan<'a> {
    rest: &'a str,
    counted: &'a str,
    line: usize,
    syntax: &'static Syntax,
    /// Whether the file ended within a text or a bracket.
    cut: bool,
}

impl<'a> Scan<'a> {
    pub(crate) fn new(text: &'a str, syntax: &'static Syntax) -> Self {
        Self { rest: text, counted: text, line: 1, syntax, cut: false }
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
        self.group(0)
    }

    /// Returns what follows up to the end of `depth` brackets that are open.
    pub(crate) fn group(&mut self, mut depth: usize) -> &'a str {
        let start = self.rest;
        loop {
            match self.next() {
                Some("(" | "[" | "{") => depth += 1,
                Some(")" | "]" | "}") => depth = depth.saturating_sub(1),
                Some(_) => {}
                None => self.cut = true,
            }
            if depth == 0 || self.cut {
                return start[..start.len() - self.rest.len()].trim();
            }
        }
    }

    /// Returns the numbers that follow, with or without square brackets.
    pub(crate) fn numbers(&mut self) -> &'a str {
        let (start, mut open) = (self.rest, 0_usize);
        while let Some(token) = self.peek() {
            match token {
                "[" => open += 1,
                "]" => open = open.saturating_sub(1),
                _ if is_text(token) || numbers(token).is_empty() => break,
                _ => {}
            }
            self.next();
        }
        self.cut |= open > 0 && self.peek().is_none();
        &start[..start.len() - self.rest.len()]
    }

    /// Returns the error of a file whose brackets or texts do not end.
    pub(crate) fn unmatched(&mut self) -> Refusal {
        unmatched(self.line())
    }

    /// Returns an error if the file ended within a text or a bracket.
    pub(crate) fn whole(mut self) -> Result<(), Refusal> {
        if self.cut { Err(self.unmatched()) } else { Ok(()) }
    }
}

/// Returns the error of a file that is cut off.
pub(crate) fn unmatched(line: usize) -> Refusal {
    Refusal::new("brackets", "unmatched", "a complete file").at(format_args!("line {line}"))
}

/// Returns the bytes of a text that begins here, and whether it ends as the language has it.
pub(crate) fn length(text: &str, close: &str, escapes: bool, has_lines: bool) -> (usize, bool) {
    let mut escaped = false;
    for (at, c) in text.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' if escapes => escaped = true,
            '\n' if !has_lines => return (at, false),
            _ if text[at..].starts_with(close) => return (at + close.len(), true),
            _ => {}
        }
    }
    (text.len(), false)
}

impl<'a> Iterator for Scan<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let space = |c: char| c.is_whitespace() || ",;".contains(c);
        let Syntax { texts, comments, marks } = self.syntax;
        let mut rest = self.rest.trim_start_matches(space);
        while let Some((open, close)) = comments.iter().find(|(open, _)| rest.starts_with(open)) {
            rest =
                rest[open.len()..].split_once(close).map_or("", |(_, rest)| rest.trim_start_matches(space));
        }
        let opened = texts.iter().find(|(open, ..)| rest.starts_with(open));
        let end = match (opened, rest.chars().next()?) {
            (Some(&(open, close, escapes, has_lines)), _) => {
                let (length, ends) = length(&rest[open.len()..], close, escapes, has_lines);
                self.cut |= !ends;
                open.len() + length
            }
            (_, first) if "=()[]{}".contains(first) => 1,
            _ => {
                let ends = |c| space(c) || "=()[]{}".contains(c) || marks.contains(c);
                // The first character belongs to the word, whatever it is.
                rest.char_indices().skip(1).find(|(_, c)| ends(*c)).map_or(rest.len(), |(at, _)| at)
            }
        };
        let (token, rest) = rest.split_at(end);
        self.rest = rest;
        Some(token)
    }
}

/// The lines of a text with their numbers. A line goes on while a text in `"` is open, or with `brackets`
/// a bracket; then `;` begins a comment, too.
pub(crate) struct Lines<'a> {
    rest: &'a str,
    line: usize,
    brackets: bool,
}

impl<'a> Lines<'a> {
    pub(crate) fn new(text: &'a str, brackets: bool) -> Self {
        Self { rest: text, line: 1, brackets }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Result<(usize, &'a str), Refusal>;

    fn next(&mut self) -> Option<Self::Item> {
        let (text, first) = (self.rest, self.line);
        let (mut depth, mut quoted, mut escaped, mut comment) = (0_usize, false, false, false);
        let mut end = text.len();
        for (at, byte) in text.bytes().enumerate() {
            self.line += usize::from(byte == b'\n');
            match byte {
                b'\n' if !quoted && depth == 0 => {
                    end = at;
                    break;
                }
                b'\n' => (comment, escaped) = (false, false),
                _ if comment || escaped => escaped = false,
                b'\\' => escaped = quoted,
                b'"' => quoted = !quoted,
                b'[' | b'(' | b'{' if self.brackets && !quoted => depth += 1,
                b']' | b')' | b'}' if self.brackets && !quoted => depth = depth.saturating_sub(1),
                b';' => comment = self.brackets && !quoted,
                _ => {}
            }
        }
        self.rest = text.get(end + 1..).unwrap_or("");
        match (quoted || depth > 0, text) {
            (true, _) => Some(Err(unmatched(first))),
            (false, "") => None,
            _ => Some(Ok((first, text[..end].trim()))),
        }
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

/// Returns the value of `key=value` in a heading, with its quotation marks.
pub(crate) fn attribute<'a>(heading: &'a str, key: &str) -> &'a str {
    let mut scan = Scan::new(heading, &HEADING);
    while let Some(token) = scan.next() {
        if token == key && scan.peek() == Some("=") {
            return scan.nth(1).unwrap_or("");
        }
    }
    ""
}

/// Returns the texts in a value of USD.
pub(crate) fn texts(value: &str) -> impl Iterator<Item = &str> {
    Scan::new(value, &USD).filter(|token| is_text(token)).map(unquoted)
}

/// Returns the begin of a name, without the marks around a text and without its escapes.
fn plain(name: &str) -> String {
    // Many lights may have one name of any length.
    let cut = |text: &str| text.chars().take(1_000).collect::<String>();
    let inner = |mark| name.strip_prefix(mark).and_then(|rest| rest.strip_suffix(mark)).map(cut);
    match (inner('"'), inner('\'')) {
        // The escapes of Godot, Unity and Unreal are among those of JSON, but for a few without a meaning in names.
        (Some(text), _) => serde_json::from_str(&format!("\"{text}\"")).unwrap_or(text),
        (_, Some(text)) => text.replace("''", "'"),
        _ => cut(name),
    }
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
    /// Whether the file says that the node is none: a class of USD.
    pub(crate) off: bool,
    pub(crate) values: Values<'a>,
}

/// Values by name. The last one of a name counts. Most nodes have one or two, for which a map takes five
/// times the memory.
#[derive(Default)]
pub(crate) struct Values<'a> {
    list: Vec<(&'a str, &'a str)>,
    is_sorted: bool,
}

impl<'a> Values<'a> {
    pub(crate) fn insert(&mut self, name: &'a str, value: &'a str) {
        self.list.push((name, value));
        self.is_sorted = false;
    }

    /// Sorts the values, after which a look takes a time that does not grow with them.
    pub(crate) fn sort(&mut self) {
        self.list.sort_by_key(|value| value.0);
        self.is_sorted = true;
    }

    pub(crate) fn get(&self, name: &str) -> Option<&'a str> {
        let near =
            if self.is_sorted { self.list.partition_point(|value| value.0 <= name) } else { self.list.len() };
        let last = if self.is_sorted { near.saturating_sub(1) } else { 0 };
        self.list[last..near].iter().rfind(|value| value.0 == name).map(|value| value.1)
    }

    /// Returns the names, in any order.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'a str> {
        self.list.iter().map(|value| value.0)
    }
}

/// A parent that is not in the file.
pub(crate) const OUTSIDE: usize = usize::MAX;

impl<'a> Block<'a> {
    /// Returns a value without quotation marks.
    pub(crate) fn get(&self, key: &str) -> &'a str {
        unquoted(self.values.get(key).unwrap_or("").trim())
    }

    pub(crate) fn has(&self, key: &str) -> bool {
        self.values.get(key).is_some()
    }

    pub(crate) fn refused(&self, key: &str, expected: &str) -> Refusal {
        Refusal::new(key, self.get(key), expected)
    }

    /// Returns the numbers of a value, or the default of a value that is not there.
    pub(crate) fn numbers<const N: usize>(&self, key: &str, default: [f64; N]) -> Result<[f64; N], Refusal> {
        let value = self.values.get(key).map_or(default.to_vec(), numbers);
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
    /// The kinds of lights: spot, point, directional, ambient, and those that are refused.
    pub(crate) kinds: [&'static str; 5],
    pub(crate) axis: DVec3,
    /// The values of a light that are read.
    pub(crate) keys: &'static str,
    /// `key=number,number`: values that change a light and are not read, unless they have these numbers.
    pub(crate) others: &'static str,
    /// `key=value`: a light that is none, or takes light away.
    pub(crate) never: &'static str,
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

/// Returns whether a node has one of the values of a list `key=value`.
fn has_any(pairs: &str, block: &Block) -> bool {
    pairs.split(' ').filter_map(|pair| pair.split_once('=')).any(|(key, value)| block.get(key) == value)
}

/// The transform of a node to its parents, or `None` of one that is off.
type Own = Option<Result<DAffine3, Refusal>>;

/// Returns the lights among the nodes, in the world. `local` returns the transform of a node to its
/// parents, and `light` completes a record.
pub(crate) fn lights(
    system: &System,
    blocks: &[Block],
    local: impl Fn(&Block) -> Result<DAffine3, Refusal>,
    light: impl Fn(&Block, &mut Record) -> Result<(), Refusal>,
) -> Result<Found, Refusal> {
    let (mut found, mut steps, mut hidden) = (Found::default(), 0, 0);
    // The text of a node is read once, however many lights are below it.
    let mut nodes: Vec<Option<Box<Own>>> = vec![None; blocks.len()];
    for (index, block) in blocks.iter().enumerate().filter(|(_, block)| !block.kind.is_empty()) {
        let Some(kind) = system.kinds.iter().position(|kinds| among(kinds, block.kind)) else { continue };
        let kind = [Kind::Spot, Kind::Point, Kind::Directional, Kind::Ambient].get(kind);
        let expected = "a spot, point, directional or ambient light";
        let refusal = || Refusal::new(block.kind, plain(block.name), expected);
        let record = kind.ok_or_else(refusal).and_then(|&kind| {
            let mut record = record(system, block, kind)?;
            light(block, &mut record).map(|()| record)
        });
        let mut paths = vec![(index, DAffine3::IDENTITY, 0)];
        while let Some((at, below, depth)) = paths.pop() {
            steps += 1;
            if steps > 4 * MOST {
                return Err(Refusal::new("parents", "of lights", "at most 1048576"));
            }
            let outside =
                || Refusal::new("parent", "not in the file, or in a cycle", "all parents in one file");
            let node = blocks.get(at).filter(|_| depth < blocks.len());
            let own = match node {
                None => Err(outside()),
                Some(node) => {
                    let read = || Box::new((!(node.off || has_any(system.off, node))).then(|| local(node)));
                    let Some(own) = &**nodes[at].get_or_insert_with(read) else {
                        hidden += 1;
                        continue;
                    };
                    own.clone()
                }
            };
            match (own, node.map(|node| &*node.parents)) {
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
    found.hide(hidden);
    let used =
        |word: &&str| !word.is_empty() && blocks.iter().any(|block| block.kind == *word || block.has(word));
    let outside = system.outside.split(' ').filter(used);
    found.notes.extend(outside.map(|word| format!("what `{word}` adds or changes is not read")));
    Ok(found)
}

/// Returns the record of a light, at the origin of its node.
///
/// # Errors
/// A light that takes light away or is none.
fn record(system: &System, block: &Block, kind: Kind) -> Result<Record, Refusal> {
    for (key, value) in system.never.split(' ').filter_map(|pair| pair.split_once('=')) {
        if block.get(key) == value {
            return Err(
                block.refused(key, "a light that adds light to the scene: remove this value or the light")
            );
        }
    }
    let mut record = Record::new(&plain(block.name), kind, format_args!("line {}", block.line));
    record.axis = system.axis;
    for key in system.keys.split(' ').filter(|key| block.has(key)) {
        let numbers = numbers(block.get(key));
        // What has no numbers is a name.
        let word = || Value::Word(block.get(key).chars().take(200).collect());
        let value = if numbers.is_empty() { word() } else { Value::Numbers(numbers) };
        record.set(key.strip_prefix("inputs:").unwrap_or(key), value);
    }
    for (key, neutral) in system.others.split(' ').filter_map(|pair| pair.split_once('=')) {
        if block.has(key) && (neutral.is_empty() || numbers(block.get(key)) != numbers(neutral)) {
            record.note(format!("`{}` is not read", key.strip_prefix("inputs:").unwrap_or(key)));
        }
    }
    Ok(record)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    /// The text of a parent is read once, however many lights it has.
    #[test]
    fn transforms_are_read_once_a_node() {
        let system = System {
            kinds: ["spot", "", "", "", ""],
            axis: DVec3::Z,
            keys: "",
            others: "",
            never: "",
            off: "",
            outside: "",
        };
        let light = || Block { kind: "spot", parents: vec![1], ..Block::default() };
        let blocks: Vec<_> =
            [Block::default(), Block::default()].into_iter().chain((0..100).map(|_| light())).collect();
        let calls = Cell::new(0);
        let local = |_: &Block| {
            calls.set(calls.get() + 1);
            Ok(DAffine3::IDENTITY)
        };
        let found = lights(&system, &blocks, local, |_, _| Ok(())).unwrap();
        assert_eq!((found.records.len(), calls.get()), (100, 101));
    }
}
