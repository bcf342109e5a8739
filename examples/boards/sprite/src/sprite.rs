//! The sprite: its opaque pixels, row by row.

use crate::{shown::Shown, word::Word};

include!(concat!(env!("OUT_DIR"), "/sprite.rs"));

/// Neighbouring opaque pixels of a row: from `start` to before `end`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(C)]
pub struct Span {
    /// The row.
    pub y: u8,
    /// The first column.
    pub start: u8,
    /// The column after the last.
    pub end: u8,
}

/// A sprite and its tables, which firmware puts where it has room.
#[derive(Clone, Copy, Debug)]
pub struct Sprite<'a> {
    /// The opaque pixels.
    pub words: &'a [Word],
    /// Where they are, in the same order.
    pub spans: &'a [Span],
    /// The tables of what is shown.
    pub shown: Shown<'a>,
}

impl Sprite<'static> {
    /// Returns the sprite of the pictures in `art`, with its tables.
    pub fn new() -> Self {
        Self { words: &WORDS, spans: &SPANS, shown: Shown::new() }
    }
}

impl Default for Sprite<'static> {
    fn default() -> Self {
        Self::new()
    }
}
