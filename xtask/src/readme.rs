//! The README's programs are files of the repository, which are compiled.

use std::fs;

use tools::project;

/// The firmware to copy, whose parts the README shows.
const TEMPLATE: &str = "boards/template";

/// Where the template has the kernel.
const KERNEL: &str = "path = \"../../core\"";

/// The text of the README's block whose first line names the file.
fn block<'a>(readme: &'a str, first_line: &str) -> Option<&'a str> {
    let (_, rest) = readme.split_once(&format!("\n{first_line}\n"))?;
    Some(rest.split_once("```")?.0)
}

#[test]
fn a_block_of_the_readme_is_the_file_that_it_names() {
    let text = |file: &str| fs::read_to_string(project::root().join(file)).unwrap();
    let readme = text("README.md");
    for file in ["build.rs", "src/lib.rs"] {
        let block = block(&readme, &format!("// {file}"));
        assert_eq!(block, Some(&*text(&format!("{TEMPLATE}/{file}"))), "{file}");
    }
    let hello = text("core/examples/hello.rs");
    assert!(hello.ends_with(block(&readme, "```rust").unwrap()), "expected {hello}");
    // The README shows the manifest from its dependencies on, as in the folder of the project.
    let manifest = text(&format!("{TEMPLATE}/Cargo.toml")).replace(KERNEL, "path = \"core\"");
    let shown = block(&readme, "# Cargo.toml").unwrap();
    assert!(shown.starts_with("[dependencies]") && manifest.ends_with(shown), "expected {manifest}");
}
