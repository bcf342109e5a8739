//! The README's programs are files of the repository, which are compiled.

use std::fs;

use tools::project;

/// The text of the README's block whose first line names the file.
fn block<'a>(readme: &'a str, first_line: &str) -> Option<&'a str> {
    let (_, rest) = readme.split_once(&format!("\n{first_line}\n"))?;
    Some(rest.split_once("```")?.0)
}

#[test]
fn a_block_of_the_readme_is_the_file_that_it_names() {
    let text = |file: &str| fs::read_to_string(project::root().join(file)).unwrap();
    let readme = text("README.md");
    assert_eq!(block(&readme, "// src/lib.rs"), Some(&*text("examples/boards/template/src/lib.rs")));
    let hello = text("core/examples/hello.rs");
    assert!(hello.ends_with(block(&readme, "```rust").unwrap()), "expected {hello}");
}
