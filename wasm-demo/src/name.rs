//! The name of a light of a file.

use std::fmt;

/// Largest number of signs.
const LONGEST: usize = 24;

/// A name of at most 24 signs that an address has as they are: letters and digits of ASCII, and single hyphens
/// between them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Name {
    signs: [u8; LONGEST],
    length: u8,
}

impl Name {
    /// The beginning of a text, with a hyphen for other signs; `None` if nothing of it is left.
    pub(crate) fn of(text: &str) -> Option<Self> {
        let (mut signs, mut length) = ([0; LONGEST], 0);
        for word in text.split(|sign: char| !sign.is_ascii_alphanumeric()).filter(|word| !word.is_empty()) {
            let hyphen = if length == 0 { "" } else { "-" };
            for (place, sign) in signs[length..].iter_mut().zip(hyphen.bytes().chain(word.bytes())) {
                *place = sign;
                length += 1;
            }
        }
        while length > 0 && signs[length - 1] == b'-' {
            length -= 1;
            signs[length] = 0;
        }
        (length > 0).then_some(Self { signs, length: length as u8 })
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(std::str::from_utf8(&self.signs[..usize::from(self.length)]).unwrap_or_default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_shortened_to_signs_of_addresses_and_comes_back() {
        for (text, name) in [
            ("Spot 12", "Spot-12"),
            ("  LED: 10\u{b0} (3000 K) ", "LED-10-3000-K"),
            ("-a--b-", "a-b"),
            ("abcdefghijklmnopqrstuvw xyz", "abcdefghijklmnopqrstuvw"),
            ("abcdefghijklmnopqrstuvwxyz", "abcdefghijklmnopqrstuvwx"),
        ] {
            let found = Name::of(text).unwrap();
            assert_eq!((found.to_string().as_str(), Name::of(name)), (name, Some(found)));
        }
        assert_eq!([Name::of(""), Name::of("\u{8857}\u{706f} _")], [None; 2]);
    }
}
