//! What comments and documents must contain, and must not.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::listing::{ROOT, crates, dependencies, files};

/// A phrase for which the field has a plainer word, and what to write instead.
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

/// Files whose wording is historical or is this list itself.
const EXEMPT: [&str; 2] = ["CHANGELOG.md", "documents.rs"];

/// The listed phrases in the comments of a Rust file or in the text of a document, each with file, line
/// number and replacement.
fn phrases(path: &Path, text: &str) -> Vec<String> {
    let extension = path.extension().unwrap_or_default();
    let mut found = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let prose = match line.split_once("//") {
            Some((_, comment)) if extension == "rs" => comment,
            _ if extension == "md" => line,
            _ => continue,
        };
        let prose = format!(" {} ", prose.to_lowercase());
        let prose = QUOTED.iter().fold(prose, |prose, quoted| prose.replace(quoted, ""));
        for (phrase, instead) in PHRASES.iter().filter(|(phrase, _)| prose.contains(phrase)) {
            found.push(format!("{}:{number}: `{}`: expected {instead}", path.display(), phrase.trim()));
        }
    }
    found
}

#[test]
fn comments_and_documents_have_none_of_the_phrases() {
    assert_eq!(phrases(Path::new("a.rs"), "let a = \" is told \"; // It is told anew.").len(), 2);
    let files =
        files(&["*.rs", "*.md"]).into_iter().filter(|file| !EXEMPT.iter().any(|name| file.ends_with(name)));
    let lines: Vec<_> = files.flat_map(|file| phrases(&file, &fs::read_to_string(&file).unwrap())).collect();
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}

#[test]
fn the_program_of_the_readme_is_the_example_that_it_names() {
    let text = |file: &str| fs::read_to_string(Path::new(ROOT).join(file)).unwrap();
    let (readme, hello) = (text("README.md"), text("core/examples/hello.rs"));
    assert!(readme.contains("`cargo run -p luminaire --example hello`"));
    let (_, rest) = readme.split_once("\n```rust\n").unwrap();
    let (program, _) = rest.split_once("```").unwrap();
    assert!(hello.ends_with(program), "expected {hello}");
}

#[test]
fn the_guide_lists_every_example_of_the_kernel() {
    let guide = fs::read_to_string(Path::new(ROOT).join("core/src/guide.rs")).unwrap();
    let listed: BTreeSet<_> = guide
        .lines()
        .skip_while(|line| !line.starts_with("//! | example"))
        .map_while(|line| line.strip_prefix("//! |"))
        .filter_map(|row| row.split('`').nth(1))
        .collect();
    let found = files(&["core/examples/*.rs"]);
    let found: BTreeSet<_> = found.iter().map(|file| file.file_stem().unwrap().to_str().unwrap()).collect();
    assert_eq!(listed, found);
}

/// The table of ARCHITECTURE.md has a row for each folder, whose last cell names the folders that it may use.
#[test]
fn no_folder_uses_one_that_its_row_does_not_name() {
    let page = fs::read_to_string(Path::new(ROOT).join("docs/ARCHITECTURE.md")).unwrap();
    let rows: Vec<(&Path, &str)> = page
        .lines()
        .filter_map(|line| {
            let (folder, rest) = line.strip_prefix("| `")?.split_once("/` | ")?;
            Some((Path::new(folder), rest.strip_suffix("|")?.rsplit_once("| ")?.1))
        })
        .collect();
    let row_of = |path: &Path| {
        let path = path.strip_prefix(ROOT).expect("a folder of the repository");
        // The root package owns the tests.
        let path = if path == Path::new("") { Path::new("tests") } else { path };
        let rows = rows.iter().filter(|(folder, _)| path.starts_with(folder));
        rows.max_by_key(|(folder, _)| folder.as_os_str().len())
            .unwrap_or_else(|| panic!("{path:?} has no row"))
    };
    let mut missing = BTreeSet::new();
    for (folder, needed) in dependencies() {
        let (own, uses) = row_of(&folder);
        let others = needed.iter().map(|needed| row_of(needed).0);
        let is_missing = |other: &&Path| {
            other != own && !["`", "/"].iter().any(|end| uses.contains(&format!("`{}{end}", other.display())))
        };
        missing.extend(others.filter(is_missing).map(|other| format!("{own:?} uses {other:?}")));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// A page that is read before anything is tried.
#[test]
fn the_readme_has_at_most_a_thousand_words() {
    let readme = fs::read_to_string(Path::new(ROOT).join("README.md")).unwrap();
    let words = readme.split_whitespace().count();
    assert!(words <= 1_000, "expected at most 1000 words, found {words}");
}

/// On Windows git writes a symbolic link as a file with the path that it leads to, so what every crate
/// is packed with is there as a copy.
#[test]
fn every_published_crate_has_the_licences_as_files() {
    let crates = crates();
    assert!(crates.len() >= 5, "{crates:?}");
    for (_, folder) in crates {
        for license in ["LICENSE-APACHE", "LICENSE-MIT"] {
            let (copy, original) = (folder.join(license), Path::new(ROOT).join(license));
            let text =
                |file: &Path| fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            assert!(text(&copy) == text(&original), "{}: not the text of {license}", copy.display());
        }
    }
    let link = files(&[]).into_iter().find(|file| file.is_symlink());
    assert_eq!(link, None, "a symbolic link");
}

/// A tag of an action can be moved to other code, a commit cannot.
#[test]
fn workflows_name_actions_by_commit() {
    let mut found = 0;
    for file in [".github/workflows/ci.yml", "docs/PUBLISHING.md"] {
        let text = fs::read_to_string(Path::new(ROOT).join(file)).unwrap();
        for action in text.lines().filter_map(|line| Some(line.split_once("uses: ")?.1)) {
            let commit = action.split_once('@').and_then(|(_, at)| at.split_once(" # v"));
            let is_commit =
                |commit: &str| commit.len() == 40 && commit.bytes().all(|byte| byte.is_ascii_hexdigit());
            assert!(
                commit.is_some_and(|(commit, _)| is_commit(commit)),
                "{file}: uses = {action}: expected a commit, and its version in a comment"
            );
            found += 1;
        }
    }
    assert!(found >= 5, "{found}");
}
