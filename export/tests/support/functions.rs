//! The functions of the headers of C.

use luminaire_export::C_HEADERS;

/// The words that begin a function.
const HEADS: [&str; 4] = ["static inline ", "LUMINAIRE_HOT ", "LUMINAIRE_PART ", "LUMINAIRE_RARE "];

/// Returns the functions by their names, with their parameters, such as `const int32_t point[3]`.
pub(crate) fn functions() -> impl Iterator<Item = (&'static str, Vec<&'static str>)> {
    let lines =
        C_HEADERS.iter().flat_map(|(_, text)| text.match_indices('\n').map(|(at, _)| &text[at + 1..]));
    let begins = |text: &&str| HEADS.iter().any(|head| text.starts_with(head));
    lines.filter(begins).filter_map(|text| {
        let (head, rest) = text.split_once('(')?;
        let (parameters, _) = rest.split_once(')')?;
        Some((head.rsplit([' ', '*']).next()?, parameters.split(',').map(str::trim).collect()))
    })
}
