//! The functions of the headers of C.

use luminaire_export::C_HEADERS;

/// The words that begin a function.
const HEADS: [&str; 4] = ["static inline ", "LUMINAIRE_HOT ", "LUMINAIRE_PART ", "LUMINAIRE_RARE "];

/// Returns the names of the functions.
pub(crate) fn functions() -> impl Iterator<Item = &'static str> {
    let lines = C_HEADERS.iter().flat_map(|(_, text)| text.lines());
    let begins = |line: &&str| HEADS.iter().any(|head| line.starts_with(head));
    lines.filter(begins).filter_map(|line| line.split_once('(')?.0.rsplit([' ', '*']).next())
}
