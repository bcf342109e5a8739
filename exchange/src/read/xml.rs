//! XML of bounded size.

use roxmltree::{Document, ParsingOptions};

use crate::refusal::Refusal;

/// The most bytes of a text.
pub(crate) const LARGEST: usize = 16 << 20;

/// Parses a text whose tree takes at most 60 MB: a node or an attribute takes 88 bytes, and the parser
/// reserves memory for each `<` and `=`. An attribute is compared with all before it.
///
/// # Errors
/// A text over the limits, with entities, which can be of any size, or not well-formed.
pub(crate) fn document(text: &str) -> Result<Document<'_>, Refusal> {
    let marks = text.bytes().filter(|byte| matches!(byte, b'<' | b'=')).count();
    let attributes = text.split('<').map(|tag| tag.matches('=').count()).max().unwrap_or(0);
    let limits = [
        ("bytes of XML", text.len(), LARGEST),
        ("tags and attributes", marks, 200_000),
        ("attributes of one tag", attributes, 256),
        ("namespaces", text.matches("xmlns").count(), 64),
        ("CDATA sections", text.matches("<![").count(), 64),
        ("entities", text.matches("<!ENTITY").count(), 0),
    ];
    if let Some((what, count, most)) = limits.iter().find(|(_, count, most)| count > most) {
        return Err(Refusal::new(what, count, format_args!("at most {most}")));
    }
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        Refusal::new("XML", &error, "well-formed XML").at(format_args!("line {}", error.pos().row))
    })
}
