//! `cargo xtask pictures`: the documents' pictures of the demo, and what page they are of.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use flate2::Crc;

use crate::browser::Chromium;
use crate::progress::Progress;
use crate::server::{self, Server};
use crate::{demo, project, site};

/// The pictures, with the view that each is of.
const PICTURES: [(&str, &str); 3] =
    [("demo.png", "stage"), ("comparison.png", "compare"), ("scenes.png", "scenes?scene=show")];

/// Where the page's fingerprint is, as it was when the pictures were taken.
const FINGERPRINT: &str = "docs/pictures.txt";

/// Builds the demo, takes the pictures and writes the fingerprint.
pub(crate) fn run() -> Result<()> {
    let progress = Progress::Live;
    let server = Server::start(server::listen(0)?, &site::build(&progress)?)?;
    let mut chromium = Chromium::start(&progress)?;
    for (file, view) in PICTURES {
        let file = project::root().join("docs").join(file);
        demo::check(&mut chromium, &format!("{}#{view}", server.address()), Some(&file))?;
        progress.say("Written", project::shown(&file));
    }
    fs::write(project::root().join(FINGERPRINT), fingerprint()?)?;
    progress.say("Written", FINGERPRINT);
    Ok(())
}

/// The text that tells one page from another: a checksum of its files with their names.
fn fingerprint() -> Result<String> {
    let web = project::root().join("wasm-demo/web");
    let mut files = Vec::new();
    list(&web, &mut files)?;
    files.sort();
    let mut crc = Crc::new();
    for file in files {
        crc.update(file.strip_prefix(&web)?.to_string_lossy().as_bytes());
        crc.update(&fs::read(&file)?);
    }
    Ok(format!("{:08x}: the CRC-32 of wasm-demo/web, by `cargo xtask pictures`\n", crc.sum()))
}

fn list(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    for entry in fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            list(&entry.path(), files)?;
        } else {
            files.push(entry.path());
        }
    }
    Ok(())
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
