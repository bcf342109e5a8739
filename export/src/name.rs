//! Names of lights: text from data never becomes source.

use std::collections::{HashMap, HashSet};

use crate::error::ExportError;
use crate::language::Language;

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

/// Returns the identifier that a text becomes in a language: lower-case letters, digits and single
/// underscores between them. A text that is one already stays as it is.
///
/// A name that cannot begin so gets `light_` in front, and one that the language has taken `_light`
/// behind.
pub fn identifier(text: &str, language: Language) -> String {
    let lower = text.to_ascii_lowercase();
    let words = lower.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let name = words.collect::<Vec<_>>().join("_");
    let begins = name.starts_with(|c: char| c.is_ascii_lowercase()) && !name.starts_with("luminaire");
    match language {
        _ if name.is_empty() => "light".to_owned(),
        _ if !begins => format!("light_{name}"),
        Language::Glsl | Language::GlslUniforms if name.starts_with("gl_") => format!("light_{name}"),
        Language::CFixed if C.contains(&&*name) => format!("{name}_light"),
        Language::RustBuild
        | Language::RustProgram
        | Language::RustFloat
        | Language::RustFixed32
        | Language::RustFixed16
            if RUST.contains(&&*name) =>
        {
            format!("{name}_light")
        }
        _ => name,
    }
}

/// Returns the [`identifier`] of each text. One that another light has already gets a number:
/// `key`, `key_2`.
pub fn names<'a>(texts: impl IntoIterator<Item = &'a str>, language: Language) -> Vec<String> {
    let (mut taken, mut counts) = (HashSet::new(), HashMap::new());
    let numbered = |text| {
        let own = identifier(text, language);
        let mut name = own.clone();
        // The count of a name goes on where it was, so that many equal names take linear time.
        while !taken.insert(name.clone()) {
            let count = counts.entry(own.clone()).or_insert(1_usize);
            *count += 1;
            name = format!("{own}_{count}");
        }
        name
    };
    texts.into_iter().map(numbered).collect()
}

/// Returns an error unless a name is its own [`identifier`]: what it accepts, [`check_text`]
/// accepts, too.
pub(crate) fn check_identifier(name: &str, language: Language) -> Result<(), ExportError> {
    let own = identifier(name, language);
    if own == name {
        return Ok(());
    }
    let expected = format!(
        "lower-case letters, digits and single underscores between them, beginning with a letter, without \
         luminaire in front, and no name that {language} has taken; such as {own}"
    );
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

/// The keywords of C and C++, and names that are macros of their compilers or of common headers: none of them can name a
/// member of a structure.
const C: [&str; 97] = [
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "class",
    "compl",
    "const",
    "const_cast",
    "constexpr",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "errno",
    "explicit",
    "export",
    "extern",
    "false",
    "far",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "inline",
    "int",
    "interface",
    "linux",
    "long",
    "mutable",
    "namespace",
    "near",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "small",
    "static",
    "static_assert",
    "static_cast",
    "stderr",
    "stdin",
    "stdout",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "typeof",
    "union",
    "unix",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
    "arm",
    "unreachable",
    "complex",
];

/// The keywords of Rust, which cannot name a module, its crates, which a module would hide, and the
/// function of a program.
const RUST: [&str; 53] = [
    "abstract", "alloc", "as", "async", "await", "become", "box", "break", "const", "continue", "core",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in",
    "let", "loop", "macro", "main", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "self", "static", "std", "struct", "super", "trait", "true", "try", "type", "typeof", "unsafe",
    "unsized", "use", "virtual", "while",
];
