//! `cargo xtask pictures`: the documents' pictures of the demo, and the fingerprint of the page
//! that they show.

use std::fs;

use anyhow::Result;

use tools::browser::check;
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::project;
use tools::server::Server;

/// The pictures, each with the view that it shows.
const PICTURES: [(&str, &str); 3] =
    [("demo.png", "stage"), ("comparison.png", "compare"), ("scenes.png", "stage?scene=three-point")];

/// The file with the page's fingerprint at the time when the pictures were taken.
const FINGERPRINT: &str = "docs/pictures.txt";

/// Builds the demo, takes the pictures and writes the fingerprint.
pub(crate) fn run() -> Result<()> {
    let progress = Progress::Live;
    let server = Server::start(&site::build(Build::Small, &progress)?)?;
    for (file, view) in PICTURES {
        let file = project::root().join("docs").join(file);
        check(&format!("{}#{view}", server.address()), Some(&file), &progress)?;
        progress.say("Written", project::shown(&file));
    }
    fs::write(project::root().join(FINGERPRINT), fingerprint()?)?;
    progress.say("Written", FINGERPRINT);
    Ok(())
}

/// The fingerprint of the page: a checksum of its files and their names.
fn fingerprint() -> Result<String> {
    let checksum = project::checksum(&project::files(&project::root().join("wasm-demo/web"), &[])?);
    Ok(format!("{checksum:08x}: the CRC-32 of wasm-demo/web, by `cargo xtask pictures`\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pictures_are_of_this_page() {
        let recorded = fs::read_to_string(project::root().join(FINGERPRINT)).unwrap();
        assert_eq!(recorded, fingerprint().unwrap(), "the page has changed: run `cargo xtask pictures`");
    }
}
