//! Figures on record: files under version control. New measurements are compared with them, or
//! replace them together with the documents that show them.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::{fs, io};

use anyhow::{Context, Result, bail, ensure};
use tools::progress::Progress;
use tools::project;

/// Relative difference that instructions may have if another compiler is used.
const LEEWAY: f64 = 0.05;

/// Largest number of differences that are listed for a group.
const SHOWN: usize = 20;

/// The content of a file with figures on record.
pub(crate) trait Record: Sized {
    /// The file, below the project's folder.
    const FILE: &'static str;
    /// The command that writes it.
    const COMMAND: &'static str;

    /// Reads the file's text.
    fn read(text: &str) -> Result<Self>;

    /// The text of the file.
    fn text(&self) -> Result<String>;

    /// The figures that are compared, by group.
    fn figures(&self) -> BTreeMap<String, Group>;

    /// The documents that show the figures, each with its content.
    fn documents(&self) -> Result<Vec<(PathBuf, Vec<u8>)>>;
}

/// Figures that are measured together: the figures of one target, or those that depend on no
/// target.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Group {
    compiler: Option<String>,
    figures: BTreeMap<String, Figure>,
}

/// A figure. Its variant says when a measured figure counts as different from the recorded one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Figure {
    /// A number that no compiler changes.
    Exact(f64),
    /// A text that no compiler changes.
    Text(String),
    /// Another compiler may give 5 % more or fewer.
    Instructions(f64),
    /// Compared only if the compiler is the same.
    Bytes(u64),
}

impl Group {
    /// Figures that no compiler changes.
    pub(crate) fn exact() -> Self {
        Self::default()
    }

    /// Figures that depend on the compiler.
    pub(crate) fn of(compiler: &str) -> Self {
        Self { compiler: Some(compiler.to_owned()), ..Self::default() }
    }

    /// Adds a figure by its name.
    pub(crate) fn add(&mut self, name: impl Into<String>, figure: Figure) {
        self.figures.insert(name.into(), figure);
    }

    /// Returns whether the group has no figure. A group that was not measured is not compared.
    pub(crate) fn is_empty(&self) -> bool {
        self.figures.is_empty()
    }

    fn differences(&self, now: &Self) -> Vec<String> {
        let is_same = self.compiler == now.compiler;
        let mut found = Vec::new();
        for (name, before) in &self.figures {
            match now.figures.get(name) {
                Some(now) => {
                    found.extend(before.difference(now, is_same).map(|told| format!("{name}{told}")))
                }
                None => found.push(format!("{name}: is no longer measured")),
            }
        }
        let is_new = |name: &&String| !self.figures.contains_key(*name);
        found.extend(now.figures.keys().filter(is_new).map(|name| format!("{name}: is not on record")));
        found
    }
}

impl Figure {
    fn difference(&self, now: &Self, is_same: bool) -> Option<String> {
        let leeway = if is_same { 0.0 } else { LEEWAY };
        let number = |before: f64, now: f64, leeway: f64| {
            let word = if now > before { "worse" } else { "better" };
            ((now - before).abs() > leeway * before).then(|| format!(": {word}: {now}, {before} on record"))
        };
        match (self, now) {
            (Self::Exact(before), Self::Exact(now)) => number(*before, *now, 0.0),
            (Self::Instructions(before), Self::Instructions(now)) => number(*before, *now, leeway),
            (Self::Bytes(_), Self::Bytes(_)) if !is_same => None,
            (Self::Bytes(before), Self::Bytes(now)) => number(*before as f64, *now as f64, 0.0),
            (Self::Text(before), Self::Text(now)) => {
                (before != now).then(|| format!(": {now}, {before} on record"))
            }
            _ => Some(format!(": {now:?}, {self:?} on record")),
        }
    }
}

/// The result of a comparison.
#[derive(Debug, Default, PartialEq)]
struct Verdict {
    differences: Vec<String>,
    /// Remarks for the reader, which do not make the comparison fail.
    remarks: Vec<String>,
}

/// Compares the groups that were measured now with those on record.
fn compare(old: &impl Record, new: &impl Record) -> Verdict {
    let (old, mut verdict) = (old.figures(), Verdict::default());
    for (name, now) in new.figures() {
        let Some(before) = old.get(&name) else {
            verdict.differences.push(format!("{name}: is not on record"));
            continue;
        };
        if let (Some(before), Some(now)) = (&before.compiler, &now.compiler)
            && before != now
        {
            verdict.remarks.push(format!(
                "{name}: {now}, the record is of {before}: instructions may differ by {:.0} %",
                100.0 * LEEWAY
            ));
        }
        let found = before.differences(&now);
        let more = found.len().saturating_sub(SHOWN);
        verdict.differences.extend(found.into_iter().take(SHOWN).map(|told| format!("{name}: {told}")));
        if more > 0 {
            verdict.differences.push(format!("{name}: {more} more"));
        }
    }
    verdict
}

/// Reads the record, or returns `None` if there is no file.
pub(crate) fn load<R: Record>() -> Result<Option<R>> {
    let failed = || format!("cannot read {}", R::FILE);
    match fs::read_to_string(project::root().join(R::FILE)) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        text => R::read(&text.with_context(failed)?).with_context(failed).map(Some),
    }
}

/// Fails if a measured figure differs from the record, or if a document is not the one that the
/// record gives. Otherwise returns the remarks of the comparison.
pub(crate) fn check<R: Record>(new: &R) -> Result<Vec<String>> {
    let (file, command) = (R::FILE, R::COMMAND);
    let old: R = load()?.with_context(|| format!("there is no {file}: `{command}` writes it"))?;
    let verdict = compare(&old, new);
    if !verdict.differences.is_empty() {
        let told = verdict.differences.join("\n    ");
        bail!("{file} is not what is measured: `{command} --bless` accepts it\n    {told}");
    }
    check_documents(&old)?;
    Ok(verdict.remarks)
}

/// Fails if a document is not the one that the record gives.
pub(crate) fn check_documents<R: Record>(record: &R) -> Result<()> {
    for (path, content) in files(record)? {
        let shown = project::shown(&path);
        let found = fs::read(&path).with_context(|| format!("cannot read {shown}"))?;
        ensure!(found == content, "{shown} is not what {} says: `{}` writes it", R::FILE, R::COMMAND);
    }
    Ok(())
}

/// Writes the measured figures and their documents. Differences from the record are printed, and
/// without `bless` they are an error and nothing is written.
pub(crate) fn write<R: Record>(new: &R, bless: bool, progress: &Progress) -> Result<()> {
    if let Some(old) = load::<R>()? {
        let Verdict { differences, remarks } = compare(&old, new);
        remarks.iter().chain(&differences).for_each(|line| println!("{line}"));
        ensure!(
            differences.is_empty() || bless,
            "{} is not what is measured: `{} --bless` accepts it",
            R::FILE,
            R::COMMAND
        );
    }
    for (path, content) in files(new)? {
        fs::write(&path, content).with_context(|| format!("cannot write {}", project::shown(&path)))?;
        progress.say("Written", project::shown(&path));
    }
    Ok(())
}

/// Every file with the content that it should have.
fn files(record: &impl Record) -> Result<Vec<(PathBuf, Vec<u8>)>> {
    fn file<R: Record>(_: &R) -> PathBuf {
        project::root().join(R::FILE)
    }
    let mut files = record.documents()?;
    files.push((file(record), record.text()?.into_bytes()));
    Ok(files)
}

/// Returns a document with the part between two lines replaced.
pub(crate) fn replaced(document: &str, [begin, end]: [&str; 2], part: &str) -> Result<String> {
    let missing = |line: &str| format!("the line is missing: {}", line.trim_end());
    let (before, rest) = document.split_once(begin).with_context(|| missing(begin))?;
    let (_, after) = rest.split_once(end).with_context(|| missing(end))?;
    Ok(format!("{before}{begin}{part}{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug)]
    struct Sample(&'static str, Figure);

    impl Record for Sample {
        const FILE: &'static str = "no such file";
        const COMMAND: &'static str = "cargo xtask sample";

        fn read(_: &str) -> Result<Self> {
            unreachable!("there is no file")
        }

        fn text(&self) -> Result<String> {
            Ok(String::new())
        }

        fn figures(&self) -> BTreeMap<String, Group> {
            let mut group = Group::of(self.0);
            group.add("soft.fx16", self.1.clone());
            BTreeMap::from([("cortex-m0".to_owned(), group)])
        }

        fn documents(&self) -> Result<Vec<(PathBuf, Vec<u8>)>> {
            Ok(Vec::new())
        }
    }

    const COMPILER: &str = "rustc 1.96.0";

    fn verdict(compiler: &'static str, before: Figure, now: Figure) -> Verdict {
        compare(&Sample(COMPILER, before), &Sample(compiler, now))
    }

    #[test]
    fn the_same_compiler_has_no_leeway() {
        use Figure::{Bytes, Exact, Instructions, Text};
        let text = |words: &str| Text(words.to_owned());
        for (before, now, told) in [
            (Exact(0.5), Exact(0.25), "better: 0.25, 0.5 on record"),
            (Instructions(20.0), Instructions(20.02), "worse: 20.02, 20 on record"),
            (Bytes(400), Bytes(402), "worse: 402, 400 on record"),
            (text("f32"), text("fx16"), "fx16, f32 on record"),
        ] {
            assert_eq!(verdict(COMPILER, before.clone(), before.clone()), Verdict::default());
            let differences = verdict(COMPILER, before, now).differences;
            assert_eq!(differences, [format!("cortex-m0: soft.fx16: {told}")]);
        }
    }

    #[test]
    fn another_compiler_has_five_percent_and_a_remark() {
        let of_another = |before, now| verdict("rustc 1.97.0", before, now);
        let within = of_another(Figure::Instructions(100.0), Figure::Instructions(104.9));
        assert!(within.differences.is_empty(), "{within:?}");
        assert!(within.remarks[0].contains("1.97.0") && within.remarks[0].contains("5 %"), "{within:?}");
        for now in [94.9, 105.1] {
            let beyond = of_another(Figure::Instructions(100.0), Figure::Instructions(now));
            assert_eq!(beyond.differences.len(), 1);
        }
        assert!(of_another(Figure::Bytes(400), Figure::Bytes(500)).differences.is_empty());
        assert_eq!(of_another(Figure::Exact(0.5), Figure::Exact(0.51)).differences.len(), 1);
    }

    #[test]
    fn a_figure_that_is_gone_or_new_is_a_difference() {
        let [mut before, mut now] = [Group::exact(), Group::exact()];
        before.add("hard.fx16", Figure::Exact(0.0));
        now.add("bell.fx16", Figure::Exact(0.0));
        assert_eq!(
            before.differences(&now),
            ["hard.fx16: is no longer measured", "bell.fx16: is not on record"]
        );
    }

    #[test]
    fn only_what_is_between_the_lines_is_replaced() {
        let lines = ["<!-- begin -->\n", "<!-- end -->\n"];
        let document = "# Before\n<!-- begin -->\nold\n<!-- end -->\nafter\n";
        let new = replaced(document, lines, "new\n").unwrap();
        assert_eq!(new, "# Before\n<!-- begin -->\nnew\n<!-- end -->\nafter\n");
        assert!(replaced("# Before\n", lines, "").unwrap_err().to_string().contains("begin"));
    }
}
