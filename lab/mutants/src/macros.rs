//! The bodies of `macro_rules`, parsed as if their parameters were names.

use std::ops::Range;

use proc_macro2::{TokenStream, TokenTree};

/// Where the bodies of a macro's rules are, without their braces.
pub(crate) fn bodies(rules: TokenStream) -> Vec<Range<usize>> {
    let groups = rules.into_iter().filter_map(|token| match token {
        TokenTree::Group(group) => Some(group.span().byte_range()),
        _ => None,
    });
    // A pattern, then a body.
    groups.skip(1).step_by(2).map(|range| range.start + 1..range.end - 1).collect()
}

/// A body as items, as the content of a function or as that of an `impl`, and how far its text was
/// moved by what was put before it.
pub(crate) fn parsed(body: &str) -> Option<(syn::File, usize)> {
    let plain = plain(body);
    [("", ""), ("fn __() {", "}"), ("impl __ {", "}")].into_iter().find_map(|(before, after)| {
        let file = syn::parse_file(&format!("{before}{plain}{after}")).ok()?;
        Some((file, before.len()))
    })
}

/// The text with the same length where `$name` is a name, and `$(..)*` is what it repeats.
fn plain(body: &str) -> String {
    let mut bytes = body.as_bytes().to_vec();
    let (mut open, mut at) = (Vec::new(), 0);
    while at < bytes.len() {
        match bytes[at] {
            b'$' if bytes.get(at + 1) == Some(&b'(') => {
                bytes[at..at + 2].fill(b' ');
                open.push(true);
                at += 1;
            }
            b'$' => bytes[at] = b'_',
            b'(' => open.push(false),
            b')' if open.pop() == Some(true) => {
                let length = bytes[at..].iter().take_while(|byte| !b"*+?".contains(byte)).count();
                bytes[at..(at + length + 1).min(body.len())].fill(b' ');
                at += length;
            }
            _ => {}
        }
        at += 1;
    }
    String::from_utf8(bytes).unwrap_or_default()
}
