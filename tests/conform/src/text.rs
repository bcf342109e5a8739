//! A line of text that needs no heap.

use core::fmt;

/// Room for the longest list of outputs, in bytes.
const LONGEST: usize = 128;

/// A short text. Bytes that do not fit are dropped.
#[derive(Clone, Debug)]
pub struct Text {
    bytes: [u8; LONGEST],
    length: usize,
}

impl Default for Text {
    fn default() -> Self {
        Self { bytes: [0; LONGEST], length: 0 }
    }
}

impl Text {
    /// The text so far.
    pub fn as_str(&self) -> &str {
        let bytes = self.bytes.get(..self.length).unwrap_or_default();
        core::str::from_utf8(bytes).unwrap_or_default()
    }

    /// Appends a word in hexadecimal digits, separated from an earlier word by a space.
    pub(crate) fn push_word(&mut self, word: u64, digits: usize) {
        if self.length > 0 {
            self.push(b' ');
        }
        for place in (0..digits).rev() {
            let digit = (word >> (4 * place) & 15) as u8;
            self.push(if digit < 10 { b'0' + digit } else { b'a' + digit - 10 });
        }
    }

    fn push(&mut self, byte: u8) {
        if let Some(place) = self.bytes.get_mut(self.length) {
            *place = byte;
            self.length += 1;
        }
    }
}

impl fmt::Write for Text {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.bytes().for_each(|byte| self.push(byte));
        Ok(())
    }
}
