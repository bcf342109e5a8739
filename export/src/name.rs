//! Names of lights: text from data never becomes source.

use crate::error::ExportError;

/// Returns an error unless a text is letters, digits, spaces and `-_.,:()#'` alone.
///
/// Such a text ends no comment and no string of any language, has no line break and none of the
/// characters that reorder a line or steer a terminal.
///
/// # Errors
/// The text, with its other characters escaped.
pub fn check_text(parameter: &str, text: &str) -> Result<(), ExportError> {
    if text.chars().all(|c| c.is_alphanumeric() || " -_.,:()#'".contains(c)) {
        return Ok(());
    }
    Err(ExportError::new(parameter, text, "letters, digits, spaces and - _ . , : ( ) # ' alone"))
}

/// Returns an error if a name is not an identifier in every language, or one of the library: what it
/// accepts, [`check_text`] accepts, too.
pub(crate) fn check_identifier(name: &str) -> Result<(), ExportError> {
    let is_word = |word: &str| {
        !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
    };
    let begins = name.bytes().next().is_some_and(|byte| byte.is_ascii_lowercase());
    let is_taken = name.starts_with("gl_") || name.starts_with("luminaire") || RUST.contains(&name);
    if begins && name.split('_').all(is_word) && !is_taken {
        return Ok(());
    }
    let expected = "lower-case letters, digits and single underscores between them, beginning with a letter; \
                    no keyword of Rust, not main, and not gl_ or luminaire in front";
    Err(ExportError::new("name", name, expected))
}

/// Returns the global name of a part of a light: `key_irradiance`, and `luminaire_key_FineCurve` of
/// what is not for users.
///
/// The part is one word in capitals and small letters, which neither the name of a light nor a name of
/// the library has: so no two lights clash, and none clashes with the library.
pub(crate) fn global(light: &str, part: &str) -> String {
    if ["irradiance", "falloff", "color", "spot"].contains(&part) {
        return format!("{light}_{part}");
    }
    let capital = |word: &str| word[..1].to_ascii_uppercase() + &word[1..];
    format!("luminaire_{light}_{}", part.split('_').map(capital).collect::<String>())
}

/// The keywords of Rust, which cannot name a module, and the function of a build script.
const RUST: [&str; 50] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop",
    "macro", "main", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self",
    "static", "struct", "super", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use",
    "virtual", "while",
];
