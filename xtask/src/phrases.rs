//! Phrases that comments and documents must not contain, because the field has a plainer word.

use std::path::{Path, PathBuf};

use tools::project;

/// A phrase, and what to write instead.
const PHRASES: [(&str, &str); 18] = [
    (" is told ", "returns, states"),
    (" are told ", "return, state"),
    (" is asked ", "is tested, is required"),
    (" are asked ", "are tested, are required"),
    (" asks for ", "requires"),
    (" asked for ", "required"),
    (" paid for", "computed, costs"),
    (" held to ", "bounded by"),
    (" leaves of ", "transmits"),
    (" so many ", "N"),
    (" is another ", "has changed"),
    (" not a number", "NaN"),
    (" the dearest", "the most expensive"),
    (" anew", "again"),
    (" a house", "a layout"),
    (" calls for ", "needs"),
    (" call for ", "need"),
    (" called for ", "needed"),
];

/// The title of the request that started the project, and a quotation of it. Both may contain a
/// listed phrase.
const QUOTED: [&str; 2] = ["only what a scene calls for", "effects called for"];

/// Build folders, and files whose wording is historical or is this list itself.
const EXEMPT: [&str; 5] = [".git", "target", "node_modules", "CHANGELOG.md", "phrases.rs"];

/// The lines of a file's comments or text that contain a listed phrase, each with file, line number
/// and replacement.
fn of_text(path: &Path, text: &str) -> Vec<String> {
    let is_document = path.extension().is_some_and(|extension| extension == "md");
    let is_source = path.extension().is_some_and(|extension| extension == "rs");
    let prose = |line: &str| match line.split_once("//") {
        Some((_, comment)) if is_source => format!(" {} ", comment.to_lowercase()),
        None if is_source => String::new(),
        _ if is_document => format!(" {} ", line.to_lowercase()),
        _ => String::new(),
    };
    let mut found = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let prose = QUOTED.iter().fold(prose(line), |prose, quoted| prose.replace(quoted, ""));
        for (phrase, instead) in PHRASES.iter().filter(|(phrase, _)| prose.contains(phrase)) {
            found.push(format!("{}:{number}: `{}`: expected {instead}", path.display(), phrase.trim()));
        }
    }
    found
}

#[test]
fn comments_and_documents_have_none_of_the_phrases() {
    let files = project::files(project::root(), &EXEMPT).unwrap();
    let texts = files.iter().filter_map(|(path, content)| Some((path, str::from_utf8(content).ok()?)));
    let lines: Vec<_> = texts.flat_map(|(path, text)| of_text(path, text)).collect();
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}

#[test]
fn a_phrase_is_found_in_a_comment_and_not_in_code() {
    let (source, page) = (PathBuf::from("a.rs"), PathBuf::from("a.md"));
    assert_eq!(of_text(&source, "// It is told anew.").len(), 2);
    assert!(of_text(&source, "let text = \" is told \";").is_empty());
    assert_eq!(of_text(&page, "It calls for more.").len(), 1);
    assert!(of_text(&page, "## Only what a scene calls for").is_empty());
}
