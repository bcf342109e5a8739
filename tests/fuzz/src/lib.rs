//! From the bytes of the fuzzer to the words of a law.

/// A law of `tests/laws`: it panics where raw words break it.
pub type Law = fn(&[u32]);

/// Holds one of the laws, chosen by the first byte, on the words that the rest is made of.
pub fn hold(laws: &[Law], bytes: &[u8]) {
    let Some((first, rest)) = bytes.split_first() else { return };
    let law = laws[usize::from(*first) % laws.len()];
    let words = rest.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
    law(&words.collect::<Vec<_>>());
}
