//! The copy of the workspace with all mutants in it, and its tests.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;
use tools::{command, project};

use crate::find::Mutant;
use crate::rewrite::{Part, Rewritten, Source};

/// The features of the kernel in the copy: all but `defmt`, whose tests link a logger of their own.
const FEATURES: &str = "luminaire/std,luminaire/libm,luminaire/fixed,luminaire/glam,luminaire/arithmetic,\
    luminaire/bytemuck,luminaire/embedded-graphics-core,luminaire/micromath,luminaire/mint,luminaire/serde";

/// What holds the tests, beside the kernel's own.
const PACKAGES: [&str; 6] =
    ["--package", "suite", "--package", "luminaire", "--package", "luminaire-conform"];

/// The targets with tests: the vectors, the kernel's own tests and the quick suite.
const TARGETS: [&str; 6] = ["--lib", "--bins", "--test", "golden", "--test", "suite"];

/// What is not copied.
const NOT_COPIED: [&str; 3] = [".git", "target", "node_modules"];

/// Source that has no mutants: the lists of models with their samples are what tests are made of,
/// and `interop/defmt.rs` is not built.
const LEFT_OUT: [&str; 2] = ["models.rs", "interop/defmt.rs"];

/// The sources of the kernel, with their mutants.
pub(crate) fn sources(root: &Path) -> Result<Vec<Source>> {
    let files = project::files(&root.join("core/src"), &[])?;
    let is_source = |path: &Path| {
        path.extension().is_some_and(|extension| extension == "rs")
            && !LEFT_OUT.iter().any(|name| path == *name)
    };
    let sources = files.into_iter().filter(|(path, _)| is_source(path));
    sources
        .map(|(path, bytes)| {
            let name = path.to_str().context("a path is text")?;
            Source::new(name, String::from_utf8(bytes)?).with_context(|| format!("cannot parse {name}"))
        })
        .collect()
}

/// A test program of the copy.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    /// What it is called, such as `suite`.
    pub(crate) name: String,
    /// The file.
    pub(crate) file: PathBuf,
    /// Where it runs.
    pub(crate) folder: PathBuf,
}

/// The copy, with those mutants that compile.
#[derive(Debug)]
pub(crate) struct Tree {
    folder: PathBuf,
    target: PathBuf,
    /// The mutants; a mutant's number is its position.
    pub(crate) mutants: Vec<Mutant>,
    /// Each mutant's site, by the number of the site's first mutant.
    pub(crate) sites: Vec<usize>,
    /// Mutants that do not compile.
    pub(crate) refused: usize,
    /// Macros of which a body could not be parsed, and so has no mutants.
    pub(crate) unparsed: Vec<String>,
}

impl Tree {
    /// Copies the workspace below a folder and puts the mutants in. `tell` receives what is done.
    pub(crate) fn new(root: &Path, below: &Path, tell: &dyn Fn(&str)) -> Result<Self> {
        let mut sources = sources(root)?;
        let all = sources.iter().flat_map(Source::mutants).count();
        let mut tree = Self {
            folder: below.join("tree"),
            target: below.join("build"),
            mutants: Vec::new(),
            sites: Vec::new(),
            refused: 0,
            unparsed: sources.iter().flat_map(|source| source.found.unparsed.clone()).collect(),
        };
        let mut files = project::files(root, &NOT_COPIED)?;
        let lib = PathBuf::from("core/src/lib.rs");
        loop {
            let mut rewritten = BTreeMap::new();
            let mut first = 0;
            for source in &sources {
                let text = source.rewritten(first);
                first += source.mutants().count();
                rewritten.insert(format!("core/src/{}", source.file), text);
            }
            for (path, text) in &rewritten {
                files.insert(path.into(), text.text.clone().into_bytes());
            }
            let head = "#![feature(core_intrinsics, const_eval_select)]\n#![allow(internal_features)]\n";
            let text = rewritten.get("core/src/lib.rs").map_or("", |text| text.text.as_str());
            let text = text.replacen("#![no_std]", &format!("#![no_std] {}", head.replace('\n', " ")), 1);
            let module = "\n#[doc(hidden)]\n#[allow(missing_docs, clippy::all)]\npub mod mutant;\n";
            files.insert(lib.clone(), (text + module).into_bytes());
            let count = format!("const COUNT: usize = {first};\n");
            let runtime = include_str!("runtime.rs").to_owned() + &count;
            files.insert("core/src/mutant.rs".into(), runtime.into_bytes());
            project::mirror(&files, &tree.folder, &NOT_COPIED)?;
            tell(&format!("checking {first} mutants"));
            let errors = tree.errors()?;
            if errors.is_empty() {
                break;
            }
            let taken = take_out(&mut sources, &rewritten, &errors);
            tell(&format!("{} errors, {taken} parts taken out", errors.len()));
            ensure!(taken > 0, "the copy does not compile:\n{}", errors[0].message);
        }
        for site in sources.iter_mut().flat_map(|source| &mut source.found.sites) {
            let first = tree.mutants.len();
            tree.sites.extend(site.mutants.iter().map(|_| first));
            tree.mutants.append(&mut site.mutants);
        }
        tree.refused = all - tree.mutants.len();
        Ok(tree)
    }

    fn cargo(&self, subcommand: &str, words: &[&str]) -> Command {
        let mut cargo = command::cargo(subcommand);
        cargo.args(words).args(["--features", FEATURES, "--message-format", "json"]);
        cargo.current_dir(&self.folder).env("CARGO_TARGET_DIR", &self.target);
        // The choice at run time in functions that are `const` is not stable.
        cargo.env("RUSTC_BOOTSTRAP", "luminaire").env("RUSTFLAGS", "--cap-lints=allow");
        cargo.env("CARGO_PROFILE_TEST_DEBUG", "0");
        cargo.stdin(Stdio::null()).stderr(Stdio::inherit());
        cargo
    }

    /// What the compiler refuses of the kernel.
    fn errors(&self) -> Result<Vec<Refusal>> {
        let output = self.cargo("check", &["--quiet", "--package", "luminaire", "--lib"]).output()?;
        let messages = output
            .stdout
            .split(|byte| *byte == b'\n')
            .filter_map(|line| serde_json::from_slice::<Value>(line).ok());
        let errors = messages.filter(|line| line["message"]["level"] == "error");
        let errors: Vec<_> = errors.map(|line| Refusal::new(&line["message"])).collect();
        ensure!(
            output.status.success() || !errors.is_empty(),
            "cargo check failed in {}",
            self.folder.display()
        );
        Ok(errors)
    }

    /// Builds the tests.
    pub(crate) fn build(&self) -> Result<Vec<Program>> {
        let words = [&["--no-run", "--quiet"], &PACKAGES[..], &TARGETS].concat();
        let output = self.cargo("test", &words).output()?;
        if !output.status.success() {
            bail!("the tests of the copy in {} do not compile", self.folder.display());
        }
        let messages = output
            .stdout
            .split(|byte| *byte == b'\n')
            .filter_map(|line| serde_json::from_slice::<Value>(line).ok());
        let programs = messages.filter(|line| line["profile"]["test"] == true).filter_map(|line| {
            let text = |value: &Value| value.as_str().map(str::to_owned);
            let kind = text(&line["target"]["kind"][0])?;
            let name = text(&line["target"]["name"])?;
            let folder = PathBuf::from(text(&line["manifest_path"])?).parent()?.to_owned();
            Some(Program {
                name: if kind == "lib" { "unit".into() } else { name },
                file: text(&line["executable"])?.into(),
                folder,
            })
        });
        Ok(programs.collect())
    }
}

/// An error of the compiler: its text, and where it points in which file, the main place first.
struct Refusal {
    message: String,
    places: Vec<(String, usize)>,
}

impl Refusal {
    fn new(message: &Value) -> Self {
        let mut spans: Vec<_> = message["spans"].as_array().into_iter().flatten().collect();
        spans.sort_by_key(|span| span["is_primary"] != true);
        let mut places = Vec::new();
        for mut span in spans {
            while let (Some(file), Some(start)) = (span["file_name"].as_str(), span["byte_start"].as_u64()) {
                places.push((file.to_owned(), start as usize));
                span = &span["expansion"]["span"];
            }
        }
        Self { message: message["rendered"].as_str().unwrap_or_default().to_owned(), places }
    }
}

/// Takes out what the errors point to, preferably a mutant. Returns how many parts these were.
fn take_out(sources: &mut [Source], rewritten: &BTreeMap<String, Rewritten>, errors: &[Refusal]) -> usize {
    let mut parts: BTreeMap<&str, BTreeSet<Part>> = BTreeMap::new();
    for error in errors {
        let around = |(file, start): &(String, usize)| {
            let (file, text) = rewritten.get_key_value(file)?;
            Some((file.as_str(), text.part(*start)?))
        };
        let mut found = error.places.iter().filter_map(around);
        let is_mutant = |(_, part): &(&str, Part)| matches!(part, Part::Mutant(..));
        if let Some((file, part)) = found.clone().find(is_mutant).or_else(|| found.next()) {
            parts.entry(file).or_default().insert(part);
        }
    }
    let count = parts.values().map(BTreeSet::len).sum();
    for source in sources {
        if let Some(parts) = parts.remove(format!("core/src/{}", source.file).as_str()) {
            source.take_out(parts);
        }
    }
    count
}
