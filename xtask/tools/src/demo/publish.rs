//! The demo as a folder for any static host, under any path and without special headers.
//!
//! Every file but the page is in a folder that is named by a checksum of all. A host may therefore let
//! browsers keep these files for ever. Scripts find other files beside themselves; what a text of HTML
//! names is found from the page.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use flate2::write::GzEncoder;
use flate2::{Compression, Crc};

use super::site::PREVIEW;
use crate::{command, project};

/// The page. Its name is the address that visitors use, so it has no checksum.
const PAGE: &str = "index.html";

/// Prints the sum of the sizes of files, each compressed by brotli.
const BROTLI: &str = "const { readFileSync } = require('fs'), { brotliCompressSync } = require('zlib'); \
    console.log(process.argv.slice(1).reduce((sum, file) => sum + brotliCompressSync(readFileSync(file)).length, 0))";

/// The files that a browser loads for the first picture.
#[derive(Debug)]
pub struct FirstPicture {
    /// Their paths below the folder.
    pub files: BTreeSet<String>,
    /// The sum of their sizes in bytes.
    pub plain: usize,
    /// The sum of their sizes in bytes, each compressed by gzip.
    pub gzip: usize,
    /// The sum of their sizes in bytes, each compressed by brotli; `None` without Node.js, which
    /// compresses them.
    pub brotli: Option<usize>,
}

impl fmt::Display for FirstPicture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kilobytes = |bytes: usize| bytes as f64 / 1000.0;
        write!(
            f,
            "the first picture takes {} files of {:.1} kB: {:.1} kB by gzip",
            self.files.len(),
            kilobytes(self.plain),
            kilobytes(self.gzip)
        )?;
        match self.brotli {
            Some(bytes) => write!(f, ", {:.1} kB by brotli", kilobytes(bytes)),
            None => write!(f, " (brotli not measured: no node)"),
        }
    }
}

/// Writes the demo of the folder `site` into the folder `to`, which must be absent or empty.
/// `address` is where the demo will be, as in `https://example.org/demo/`; link previews need it.
pub fn publish(site: &Path, to: &Path, address: Option<&str>) -> Result<FirstPicture> {
    let is_free = to.read_dir().map_or(!to.exists(), |mut entries| entries.next().is_none());
    ensure!(
        is_free,
        "folder = \"{}\": expected a folder that is absent or empty; name another or remove it first",
        to.display()
    );
    let files = project::files(site, &[])?.into_iter().map(|(path, content)| {
        let name = path.to_string_lossy().replace('\\', "/");
        let content = if is_code(&name) { without_comments(&content) } else { content };
        (name, content)
    });
    let mut files: Files = files.collect();
    let mut crc = Crc::new();
    for (name, content) in &files {
        crc.update(name.as_bytes());
        crc.update(content);
    }
    let folder = format!("{:08x}/", crc.sum());
    let first = first(&files)?;
    let names: Vec<_> = files.keys().cloned().collect();
    for (name, content) in files.iter_mut().filter(|(name, _)| name.ends_with(".html")) {
        let mut text = String::from_utf8_lossy(content).into_owned();
        for other in &names {
            let prefix = if other == PREVIEW { address.unwrap_or_default() } else { "" };
            text = text.replace(&format!("\"{other}\""), &format!("\"{prefix}{folder}{other}\""));
        }
        *content =
            if name == PAGE { with_links(&text, &folder, &first, address)? } else { text }.into_bytes();
    }
    let placed = |name: &str| if name == PAGE { PAGE.to_owned() } else { format!("{folder}{name}") };
    for (name, content) in &files {
        let file = to.join(placed(name));
        let folder = file.parent().unwrap_or(to);
        fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
        fs::write(&file, content).with_context(|| format!("cannot write {}", file.display()))?;
    }
    let contents = || first.iter().map(|name| &files[name]);
    let written: BTreeSet<_> = first.iter().map(|name| placed(name)).collect();
    let node = command::on_path(&["node"]);
    Ok(FirstPicture {
        plain: contents().map(Vec::len).sum(),
        gzip: contents().map(|content| gzip(content)).sum::<Result<usize>>()?,
        brotli: node.map(|node| brotli(&node, written.iter().map(|name| to.join(name)))).transpose()?,
        files: written,
    })
}

/// The files by their names, and their contents.
type Files = BTreeMap<String, Vec<u8>>;

/// The names of the files that the first picture needs: the page, what it names, and what these
/// modules import.
fn first(files: &Files) -> Result<BTreeSet<String>> {
    ensure!(files.contains_key(PAGE), "the demo has no {PAGE}");
    let mut first = BTreeSet::from([PAGE.to_owned()]);
    let mut left = vec![PAGE.to_owned()];
    while let Some(name) = left.pop() {
        let text = String::from_utf8_lossy(&files[&name]);
        // An import begins with `./`; a module that is loaded later is named without it.
        let dot = if name == PAGE { "" } else { "./" };
        let folder = name.rfind('/').map_or("", |slash| &name[..=slash]);
        for other in files.keys().filter(|other| *other != PREVIEW) {
            let Some(path) = other.strip_prefix(folder) else { continue };
            if (name == PAGE || name.ends_with(".js"))
                && text.contains(&format!("\"{dot}{path}\""))
                && first.insert(other.clone())
            {
                left.push(other.clone());
            }
        }
    }
    Ok(first)
}

/// The page, which also preloads the modules that its own modules import.
fn with_links(page: &str, folder: &str, first: &BTreeSet<String>, address: Option<&str>) -> Result<String> {
    let is_linked = |name: &&String| *name == PAGE || page.contains(&format!("\"{folder}{name}\""));
    let preload = |name: &String| format!("  <link rel=\"modulepreload\" href=\"{folder}{name}\">\n");
    let mut links: String = first.iter().filter(|name| !is_linked(name)).map(preload).collect();
    if let Some(address) = address {
        links += &format!("  <meta property=\"og:url\" content=\"{address}\">\n");
    }
    let (head, body) = page.split_once("</head>").context("the page has no head")?;
    Ok(format!("{head}{links}</head>{body}"))
}

/// Whether a file is a script or a style sheet.
fn is_code(name: &str) -> bool {
    [".js", ".css"].iter().any(|extension| name.ends_with(extension))
}

/// The lines of a script or style sheet without indentation, and without the lines that are
/// comments: a quarter of the compressed page. A line with code after its comment is kept whole.
fn without_comments(content: &[u8]) -> Vec<u8> {
    let text = String::from_utf8_lossy(content);
    let (mut kept, mut is_comment) = (String::new(), false);
    for line in text.lines().map(str::trim) {
        let begins = !is_comment && line.starts_with("/*") && (line.ends_with("*/") || !line.contains("*/"));
        if !is_comment && !begins && !line.is_empty() && !line.starts_with("//") {
            kept.extend([line, "\n"]);
        }
        is_comment = (is_comment || begins) && !line.ends_with("*/");
    }
    kept.into_bytes()
}

/// The size of a file after compression by gzip.
pub fn gzip(content: &[u8]) -> Result<usize> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(content)?;
    Ok(encoder.finish()?.len())
}

fn brotli(node: &Path, files: impl Iterator<Item = PathBuf>) -> Result<usize> {
    let answer = command::answer(Command::new(node).args(["-e", BROTLI]).args(files))?;
    answer.trim().parse().with_context(|| format!("node answers {answer:?} in place of a size"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SITE: [(&str, &str); 8] = [
        (
            "index.html",
            "<head><meta content=\"preview.png\"><link href=\"icon.svg\"><script src=\"main.js\"></head>",
        ),
        ("main.js", "import { words } from \"./words.js\"; load(\"later.js\");"),
        ("words.js", "import init from \"./pkg/glue.js\";"),
        ("later.js", "import { words } from \"./words.js\"; fetch(\"part.html\");"),
        ("part.html", "<img src=\"icon.svg\">"),
        ("icon.svg", "<svg/>"),
        ("preview.png", "pixels"),
        ("pkg/glue.js", "new URL(\"module.wasm\", import.meta.url)"),
    ];

    /// Publishes the site, with another script, and returns the files, and those of the first picture.
    fn published(script: &str, address: Option<&str>) -> (BTreeMap<String, String>, FirstPicture) {
        let (site, to) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        fs::create_dir(site.path().join("pkg")).unwrap();
        for (name, content) in SITE.iter().chain(&[("pkg/module.wasm", "wasm"), ("words.js", script)]) {
            fs::write(site.path().join(name), content).unwrap();
        }
        let first = publish(site.path(), to.path(), address).unwrap();
        let files = project::files(to.path(), &[]).unwrap().into_iter();
        let files = files.map(|(path, content)| {
            (path.to_string_lossy().into_owned(), String::from_utf8(content).unwrap())
        });
        (files.collect(), first)
    }

    const WORDS: &str = "import init from \"./pkg/glue.js\";";

    #[test]
    fn all_but_the_page_is_in_a_folder_named_by_its_content() {
        let (files, first) = published(WORDS, None);
        let folder = files.keys().next().unwrap().split_once('/').unwrap().0.to_owned();
        assert!(folder.len() == 8 && u32::from_str_radix(&folder, 16).is_ok(), "{folder}");
        assert!(files.keys().all(|name| name == PAGE || name.starts_with(&folder)), "{files:?}");
        assert_eq!(files.len(), SITE.len() + 1);
        let needed =
            ["icon.svg", "main.js", "pkg/glue.js", "words.js"].map(|name| format!("{folder}/{name}"));
        assert_eq!(first.files, needed.into_iter().chain([PAGE.to_owned()]).collect());
        assert!(files[PAGE].contains(&format!("<script src=\"{folder}/main.js\">")), "{}", files[PAGE]);
        assert!(files[PAGE].contains(&format!("modulepreload\" href=\"{folder}/words.js\"")));
        assert!(!files[PAGE].contains("later."), "a module that is loaded later is preloaded");
        assert_eq!(files[&format!("{folder}/part.html")], format!("<img src=\"{folder}/icon.svg\">"));
        let (changed, _) = published(&format!("{WORDS};"), None);
        assert!(!changed.keys().any(|name| name.starts_with(&folder)), "{changed:?}");
    }

    #[test]
    fn only_comments_are_left_out() {
        let text = "/** A\n * b. */\n  /* c */\n// d\n  call(); // e\n\n  a = `//\n`;\n/* f */ g;\nh;\n";
        assert_eq!(
            String::from_utf8(without_comments(text.as_bytes())).unwrap(),
            "call(); // e\na = `//\n`;\n/* f */ g;\nh;\n"
        );
    }

    #[test]
    fn an_address_makes_the_preview_absolute() {
        let (files, _) = published(WORDS, Some("https://example.org/demo/"));
        let folder = files.keys().next().unwrap().split_once('/').unwrap().0;
        let page = &files[PAGE];
        assert!(
            page.contains(&format!("content=\"https://example.org/demo/{folder}/preview.png\"")),
            "{page}"
        );
        assert!(page.contains("og:url") && page.contains(&format!("href=\"{folder}/icon.svg\"")), "{page}");
    }

    #[test]
    fn a_folder_in_use_is_refused() {
        let (site, to) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        fs::write(site.path().join(PAGE), "<head></head>").unwrap();
        publish(site.path(), to.path(), None).unwrap();
        let refusal = publish(site.path(), to.path(), None).unwrap_err().to_string();
        assert!(refusal.contains("absent or empty"), "{refusal}");
    }
}
