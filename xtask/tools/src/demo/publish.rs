//! The demo as a folder for any static host, under any path and without special headers.
//!
//! Every file but the page is in a folder that is named by a checksum of all. A host may therefore let
//! browsers keep these files for ever. Scripts find other files beside themselves; what a text of HTML
//! names is found from the page.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use super::site::PREVIEW;
use crate::progress::Progress;
use crate::{install, project};

/// The page. Its name is the address that visitors use, so it has no checksum.
const PAGE: &str = "index.html";

/// The files by their names, and their contents.
type Files = Vec<(String, Vec<u8>)>;

/// Writes the demo of the folder `site` into the folder `to`, which must be absent or empty, with scripts
/// and styles without comments, indentation and long names, and pages without indentation: a quarter of the
/// compressed page. `address` is where
/// the demo will be, as in `https://example.org/demo/`; link previews need it. `repository` is where its source is,
/// to which it then links. Returns the paths below `to` of the
/// files that a browser loads for the first picture.
pub fn publish(
    site: &Path,
    to: &Path,
    [address, repository]: [Option<&str>; 2],
    progress: &Progress,
) -> Result<BTreeSet<String>> {
    let first = place(site, to, [address, repository])?;
    let is_code = |path: &PathBuf| path.extension().is_some_and(|end| end == "js" || end == "css");
    let code = project::files(to, &[])?.into_keys().filter(is_code).map(|path| to.join(path));
    let mut minify = install::npm_program("esbuild", "esbuild", progress)?;
    minify.args(["--minify", "--format=esm", "--allow-overwrite", "--log-level=error"]);
    minify.arg(format!("--outdir={}", to.display())).arg(format!("--outbase={}", to.display())).args(code);
    progress.run(minify)?;
    Ok(first)
}

/// Writes the files as they are, but for their addresses in the page.
fn place(site: &Path, to: &Path, links: [Option<&str>; 2]) -> Result<BTreeSet<String>> {
    let is_free = to.read_dir().map_or(!to.exists(), |mut entries| entries.next().is_none());
    ensure!(
        is_free,
        "folder = \"{}\": expected a folder that is absent or empty; name another or remove it first",
        to.display()
    );
    let files = project::files(site, &[])?;
    let folder = format!("{:08x}/", project::checksum(&files));
    let files = files.into_iter().map(|(path, content)| (path.to_string_lossy().replace('\\', "/"), content));
    // Types are for tests of the scripts alone.
    let files: Files = files.filter(|(name, _)| !name.ends_with(".d.ts")).collect();
    let first = first(&files)?;
    let placed = |name: &str| if name == PAGE { PAGE.to_owned() } else { format!("{folder}{name}") };
    for (name, content) in &files {
        let file = to.join(placed(name));
        fs::create_dir_all(file.parent().unwrap_or(to))?;
        let written = if name.ends_with(".html") {
            // No text of the pages depends on its indentation.
            let mut text: String = String::from_utf8_lossy(content)
                .lines()
                .map(|line| line.trim_start().to_owned() + "\n")
                .collect();
            for (other, _) in &files {
                let prefix = if other == PREVIEW { links[0].unwrap_or_default() } else { "" };
                text = text.replace(&format!("\"{other}\""), &format!("\"{prefix}{folder}{other}\""));
            }
            if name == PAGE { with_addresses(&text, links)? } else { text }.into_bytes()
        } else {
            content.clone()
        };
        fs::write(&file, written).with_context(|| format!("cannot write {}", file.display()))?;
    }
    Ok(first.iter().map(|name| placed(name)).collect())
}

/// The names of the files that the first picture needs: the page, what it names, and what these
/// modules import.
fn first(files: &Files) -> Result<BTreeSet<String>> {
    let text = |name: &str| {
        let found = files.iter().find(|(other, _)| other == name);
        found.map(|(_, content)| String::from_utf8_lossy(content)).context(format!("the demo has no {name}"))
    };
    let mut first = BTreeSet::from([PAGE.to_owned()]);
    let mut left = vec![PAGE.to_owned()];
    while let Some(name) = left.pop() {
        if name != PAGE && !name.ends_with(".js") {
            continue;
        }
        let text = text(&name)?;
        // An import begins with `./`; a module that is loaded later is named without it, and a type by
        // `import(` in a comment.
        let dot = if name == PAGE { "" } else { "./" };
        let is_named = |path: &str| {
            let named = format!("\"{dot}{path}\"");
            text.match_indices(&named).any(|(at, _)| !text[..at].ends_with("import("))
        };
        let folder = name.rfind('/').map_or("", |slash| &name[..=slash]);
        for (other, _) in files.iter().filter(|(other, _)| other != PREVIEW) {
            let Some(path) = other.strip_prefix(folder) else { continue };
            if is_named(path) && first.insert(other.clone()) {
                left.push(other.clone());
            }
        }
    }
    Ok(first)
}

/// The page, which also states where it is and where its source is.
fn with_addresses(page: &str, [address, repository]: [Option<&str>; 2]) -> Result<String> {
    let named = [("property=\"og:url\"", address), ("name=\"repository\"", repository)];
    let meta = |(name, url): (&str, Option<&str>)| Some(format!("  <meta {name} content=\"{}\">\n", url?));
    let metas: String = named.into_iter().filter_map(meta).collect();
    let (head, body) = page.split_once("</head>").context("the page has no head")?;
    Ok(format!("{head}{metas}</head>{body}"))
}

#[test]
fn folder_with_a_file_is_refused() {
    let to = tempfile::tempdir().unwrap();
    fs::write(to.path().join("mine.txt"), "").unwrap();
    let refusal = place(to.path(), to.path(), [None; 2]).unwrap_err().to_string();
    assert!(refusal.contains("absent or empty"), "{refusal}");
}
