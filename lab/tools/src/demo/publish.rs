//! The demo as a folder for any static host, under any path and without special headers.
//!
//! The name of every file but the page contains a checksum of its content. A host may therefore let
//! browsers keep these files for ever.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use flate2::write::GzEncoder;
use flate2::{Compression, Crc};

use super::site::PREVIEW;
use crate::{command, project};

/// The page. Its name is the address that visitors use, so it has no checksum.
const PAGE: &str = "index.html";

/// Extensions of the files that may refer to other files.
const TEXTS: [&str; 3] = ["css", "html", "js"];

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
    let files = project::files(site, &[])?;
    let names = files.into_iter().map(|(path, content)| {
        let name = path.to_string_lossy().replace('\\', "/");
        let content = if is_code(&name) { without_comments(&content) } else { content };
        (name, content)
    });
    let bundle = Bundle::new(names.collect(), address)?;
    for (name, content) in bundle.files.values() {
        let file = to.join(name);
        let folder = file.parent().unwrap_or(to);
        fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
        fs::write(&file, content).with_context(|| format!("cannot write {}", file.display()))?;
    }
    bundle.first_picture(to)
}

/// The files under their old names, each with its new name and its new content.
struct Bundle {
    files: BTreeMap<String, (String, Vec<u8>)>,
    /// The old names of the files that the first picture needs.
    first: BTreeSet<String>,
}

impl Bundle {
    fn new(old: BTreeMap<String, Vec<u8>>, address: Option<&str>) -> Result<Self> {
        let page = old.get(PAGE).with_context(|| format!("the demo has no {PAGE}"))?;
        let mut first: BTreeSet<String> = references(PAGE, page, &old).map(|(name, _)| name).collect();
        first.remove(PREVIEW);
        while let Some(more) = imports(&first, &old) {
            first.extend(more);
        }
        let mut bundle = Self { files: BTreeMap::new(), first };
        for name in old.keys().filter(|name| *name != PAGE) {
            bundle.add(name, &old, &mut Vec::new())?;
        }
        let page = bundle.page(page, &old, address)?;
        bundle.files.insert(PAGE.to_owned(), (PAGE.to_owned(), page));
        bundle.first.insert(PAGE.to_owned());
        Ok(bundle)
    }

    /// Adds a file and, before it, the files that it refers to: their names change its content.
    fn add(&mut self, name: &str, old: &BTreeMap<String, Vec<u8>>, within: &mut Vec<String>) -> Result<()> {
        if self.files.contains_key(name) {
            return Ok(());
        }
        if within.iter().any(|outer| outer == name) {
            bail!("{name} refers to itself by way of {}: no checksum can be in its name", within.join(", "));
        }
        within.push(name.to_owned());
        for (other, _) in references(name, &old[name], old) {
            self.add(&other, old, within)?;
        }
        within.pop();
        let content = self.renamed(name, &old[name], old, "");
        let mut crc = Crc::new();
        crc.update(&content);
        let (stem, extension) = name.rsplit_once('.').with_context(|| format!("{name} has no extension"))?;
        self.files.insert(name.to_owned(), (format!("{stem}.{:08x}.{extension}", crc.sum()), content));
        Ok(())
    }

    /// The content of a file with the new names of the files that it refers to. The name of the
    /// preview gets a prefix.
    fn renamed(&self, name: &str, content: &[u8], old: &BTreeMap<String, Vec<u8>>, prefix: &str) -> Vec<u8> {
        let mut text = String::from_utf8_lossy(content).into_owned();
        let mut is_changed = false;
        for (other, spelled) in references(name, content, old) {
            let (new, _) = &self.files[&other];
            let prefix = if other == PREVIEW { prefix } else { "" };
            let path = new.strip_prefix(folder(name)).unwrap_or(new);
            let dot = if spelled.starts_with("./") { "./" } else { "" };
            for quote in ['"', '\''] {
                let [from, to] = [spelled.clone(), format!("{prefix}{dot}{path}")]
                    .map(|word| format!("{quote}{word}{quote}"));
                text = text.replace(&from, &to);
            }
            is_changed = true;
        }
        if is_changed { text.into_bytes() } else { content.to_vec() }
    }

    /// The page: it also preloads the modules that its own modules import.
    fn page(&self, page: &[u8], old: &BTreeMap<String, Vec<u8>>, address: Option<&str>) -> Result<Vec<u8>> {
        let linked: BTreeSet<_> = references(PAGE, page, old).map(|(name, _)| name).collect();
        let preload =
            |name: &String| format!("  <link rel=\"modulepreload\" href=\"{}\">\n", self.files[name].0);
        let mut links: String = self.first.difference(&linked).map(preload).collect();
        if let Some(address) = address {
            links += &format!("  <meta property=\"og:url\" content=\"{address}\">\n");
        }
        let page = String::from_utf8(self.renamed(PAGE, page, old, address.unwrap_or_default()))?;
        let (head, body) = page.split_once("</head>").context("the page has no head")?;
        Ok(format!("{head}{links}</head>{body}").into_bytes())
    }

    fn first_picture(&self, folder: &Path) -> Result<FirstPicture> {
        let files: Vec<_> = self.first.iter().map(|name| &self.files[name]).collect();
        let sum = |size: &dyn Fn(&[u8]) -> Result<usize>| {
            files.iter().map(|(_, content)| size(content)).sum::<Result<usize>>()
        };
        let node = command::on_path(&["node"]);
        Ok(FirstPicture {
            files: files.iter().map(|(name, _)| name.clone()).collect(),
            plain: sum(&|content| Ok(content.len()))?,
            gzip: sum(&gzip)?,
            brotli: node
                .map(|node| brotli(&node, files.iter().map(|(name, _)| folder.join(name))))
                .transpose()?,
        })
    }
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

/// The folder of a file, with a slash at its end; empty for the folder of the page.
fn folder(name: &str) -> &str {
    name.rfind('/').map_or("", |slash| &name[..=slash])
}

/// The files that a file refers to by a text in quotes, and that text: the path from the file's own
/// folder, with or without `./` before it.
fn references<'a>(
    name: &'a str,
    content: &'a [u8],
    files: &'a BTreeMap<String, Vec<u8>>,
) -> impl Iterator<Item = (String, String)> + 'a {
    let is_text = name.rsplit_once('.').is_some_and(|(_, extension)| TEXTS.contains(&extension));
    let text = if is_text { str::from_utf8(content).unwrap_or_default() } else { "" };
    files.keys().filter(move |other| *other != name).flat_map(move |other| {
        let path = other.strip_prefix(folder(name)).unwrap_or(other);
        let spelled = [path.to_owned(), format!("./{path}")].into_iter();
        let is_quoted =
            |word: &String| ['"', '\''].iter().any(|quote| text.contains(&format!("{quote}{word}{quote}")));
        spelled.filter(is_quoted).map(|word| (other.clone(), word)).collect::<Vec<_>>()
    })
}

/// The modules that these modules import, if any of them is not among them. An import begins with
/// `./`; a module that is loaded later is named without it.
fn imports(modules: &BTreeSet<String>, files: &BTreeMap<String, Vec<u8>>) -> Option<BTreeSet<String>> {
    let of = |name: &String| {
        references(name, &files[name], files)
            .filter(|(_, word)| word.starts_with("./"))
            .map(|(other, _)| other)
            .collect::<Vec<_>>()
    };
    let all: BTreeSet<_> = modules.iter().filter(|name| name.ends_with(".js")).flat_map(of).collect();
    (!all.is_subset(modules)).then_some(all)
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
        ("later.js", "import { words } from \"./words.js\"; fetch(\"list.json\");"),
        ("list.json", "null"),
        ("icon.svg", "<svg/>"),
        ("preview.png", "pixels"),
        ("pkg/glue.js", "new URL('module.wasm', import.meta.url)"),
    ];

    fn site(change: impl Fn(&str, &str) -> String) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("pkg")).unwrap();
        for (name, content) in SITE.iter().chain(&[("pkg/module.wasm", "wasm")]) {
            fs::write(folder.path().join(name), change(name, content)).unwrap();
        }
        folder
    }

    fn names(
        change: impl Fn(&str, &str) -> String,
    ) -> (tempfile::TempDir, BTreeMap<String, String>, FirstPicture) {
        let (site, to) = (site(change), tempfile::tempdir().unwrap());
        let first = publish(site.path(), to.path(), None).unwrap();
        let files = project::files(to.path(), &[]).unwrap();
        let text = |(path, content): (std::path::PathBuf, Vec<u8>)| {
            (path.to_string_lossy().into_owned(), String::from_utf8(content).unwrap())
        };
        (to, files.into_iter().map(text).collect(), first)
    }

    fn starting<'a>(files: &'a BTreeMap<String, String>, start: &str) -> &'a str {
        files.keys().find(|name| name.starts_with(start)).unwrap()
    }

    #[test]
    fn every_file_but_the_page_is_named_by_its_content() {
        let (_to, files, _) = names(|_, content| content.to_owned());
        assert_eq!(files.len(), SITE.len() + 1);
        for name in files.keys().filter(|name| *name != PAGE) {
            let checksum = name.rsplit('.').nth(1).unwrap();
            assert!(checksum.len() == 8 && u32::from_str_radix(checksum, 16).is_ok(), "{name}");
        }
        // A change of one file renames it and every file that leads to it, and no others.
        let (_to, changed, _) =
            names(|name, content| format!("{content}{}", if name == "words.js" { ";" } else { "" }));
        for (start, stays) in
            [("icon.", true), ("pkg/glue.", true), ("words.", false), ("main.", false), ("later.", false)]
        {
            assert_eq!(starting(&files, start) == starting(&changed, start), stays, "{start}");
        }
        assert!(changed[PAGE].contains(starting(&changed, "main.")));
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
    fn references_lead_to_the_new_names() {
        let (_to, files, first) = names(|_, content| content.to_owned());
        for (from, to) in
            [("main.", "words."), ("main.", "later."), ("words.", "pkg/glue."), ("later.", "list.")]
        {
            assert!(
                files[starting(&files, from)].contains(starting(&files, to)),
                "{from} does not lead to {to}"
            );
        }
        let module = starting(&files, "pkg/module.").strip_prefix("pkg/").unwrap();
        assert!(files[starting(&files, "pkg/glue.")].contains(&format!("'{module}'")));
        let needed = ["icon.", "index.", "main.", "pkg/glue.", "words."]
            .map(|start| starting(&files, start).to_owned());
        assert_eq!(first.files, needed.into());
        assert!(files[PAGE].contains(&format!("modulepreload\" href=\"{}\"", starting(&files, "words."))));
        assert!(!files[PAGE].contains("later."), "a module that is loaded later is preloaded");
    }

    #[test]
    fn an_address_makes_the_preview_absolute() {
        let (site, to) = (site(|_, content| content.to_owned()), tempfile::tempdir().unwrap());
        publish(site.path(), to.path(), Some("https://example.org/demo/")).unwrap();
        let page = fs::read_to_string(to.path().join(PAGE)).unwrap();
        assert!(page.contains("content=\"https://example.org/demo/preview."), "{page}");
        assert!(page.contains("href=\"icon."), "{page}");
    }

    #[test]
    fn a_folder_in_use_is_refused() {
        let (site, to) = (site(|_, content| content.to_owned()), tempfile::tempdir().unwrap());
        publish(site.path(), to.path(), None).unwrap();
        let refusal = publish(site.path(), to.path(), None).unwrap_err().to_string();
        assert!(refusal.contains("absent or empty"), "{refusal}");
    }

    #[test]
    fn a_circle_of_imports_is_named() {
        let site = site(
            |name, content| if name == "words.js" { "\"./main.js\"".into() } else { content.to_owned() },
        );
        let error = publish(site.path(), &site.path().join("to"), None).unwrap_err().to_string();
        assert!(error.contains("main.js"), "{error}");
    }
}
