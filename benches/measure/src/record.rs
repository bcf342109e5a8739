//! Figures on record: a JSON file under version control, with which new measurements are compared.

use std::{fs, io};

use anyhow::{Context, Result};
use indexmap::{IndexMap, IndexSet};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use tools::project;

/// The file, below the project's folder.
pub(crate) const FILE: &str = "docs/prices.json";

/// The unit of the most instructions of a call that a search has found.
pub(crate) const MOST: &str = "most";

/// Relative difference that counts may have if another compiler is used.
const LEEWAY: f64 = 0.05;
/// Largest number of differences that are listed for a group.
const SHOWN: usize = 20;

/// The groups of figures: those of one target, or those that depend on no target.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub(crate) struct Record(pub(crate) IndexMap<String, Group>);

/// Figures that are measured together.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Group {
    /// What the figures depend on, such as the compiler.
    pub(crate) about: IndexMap<String, String>,
    /// Numbers or texts by name, such as `soft.fx16`, and unit.
    pub(crate) figures: IndexMap<String, IndexMap<String, Value>>,
}

/// A line that a measured program prints: `name value unit`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    pub(crate) name: String,
    pub(crate) value: String,
    pub(crate) unit: String,
}

impl Line {
    /// Reads the lines that a program has printed.
    pub(crate) fn all(text: &str) -> Result<Vec<Self>> {
        let read = |line: &str| {
            let words: Vec<_> = line.split(' ').map(str::to_owned).collect();
            let [name, value, unit] = <[String; 3]>::try_from(words).ok()?;
            Some(Self { name, value, unit })
        };
        text.lines()
            .map(|line| read(line).with_context(|| format!("not `name value unit`: {line}")))
            .collect()
    }
}

impl Group {
    /// A group that depends on a compiler, an emulator and more.
    pub(crate) fn about(facts: &[(&str, String)]) -> Self {
        let about = facts.iter().map(|(name, fact)| ((*name).to_owned(), fact.clone())).collect();
        Self { about, figures: IndexMap::new() }
    }

    /// Adds a figure.
    pub(crate) fn add(&mut self, name: &str, unit: &str, value: impl Into<Value>) {
        self.figures.entry(name.to_owned()).or_default().insert(unit.to_owned(), value.into());
    }

    /// Adds the figures that a program has printed. A value that is no number is a text.
    pub(crate) fn add_lines(&mut self, text: &str) -> Result<()> {
        for Line { name, value, unit } in Line::all(text)? {
            let value = value.parse::<serde_json::Number>().map_or_else(|_| value.into(), Value::from);
            self.add(&name, &unit, value);
        }
        Ok(())
    }

    /// The number of a name and a unit.
    pub(crate) fn number(&self, name: &str, unit: &str) -> Option<f64> {
        self.figures.get(name)?.get(unit)?.as_f64()
    }

    /// The text of a name and a unit.
    pub(crate) fn text(&self, name: &str, unit: &str) -> Option<&str> {
        self.figures.get(name)?.get(unit)?.as_str()
    }

    fn differences(&self, now: &Self) -> Vec<String> {
        let compiler = |group: &Self| group.about.get("compiler").cloned();
        let is_same = compiler(self) == compiler(now);
        let (old, new) = (self.flat(), now.flat());
        let names: IndexSet<_> = old.keys().chain(new.keys()).collect();
        let found = names.into_iter().filter_map(|name @ &(kernel, unit)| {
            let leeway = leeway(unit, is_same)?;
            let told = match (old.get(name), new.get(name)) {
                (Some(old), Some(new)) => difference(old, new, leeway)?,
                (Some(_), None) => "is no longer measured".to_owned(),
                _ => "is not on record".to_owned(),
            };
            Some(format!("{kernel}, {unit}: {told}"))
        });
        found.collect()
    }

    /// The figures by name and unit.
    fn flat(&self) -> IndexMap<(&str, &str), &Value> {
        let units = |(name, units)| {
            let units: &IndexMap<String, Value> = units;
            units.iter().map(move |(unit, value)| ((name, unit.as_str()), value))
        };
        self.figures.iter().map(|(name, units)| (name.as_str(), units)).flat_map(units).collect()
    }
}

/// The relative difference that figures of a unit may have; none if they are not compared.
fn leeway(unit: &str, is_same_compiler: bool) -> Option<f64> {
    match unit {
        _ if unit.starts_with("ns") || unit.starts_with("ms") => None,
        "instructions" | "instructions_at_o2" | "instructions_for_size" | "cycles" if !is_same_compiler => {
            Some(LEEWAY)
        }
        "bytes" | "flash" | "kibibytes" | "stack" if !is_same_compiler => None,
        _ => Some(0.0),
    }
}

fn difference(before: &Value, now: &Value, leeway: f64) -> Option<String> {
    match (before.as_f64(), now.as_f64()) {
        (Some(old), Some(new)) => {
            let word = if new > old { "worse" } else { "better" };
            ((new - old).abs() > leeway * old).then(|| format!("{word}: {new}, {old} on record"))
        }
        _ => (before != now).then(|| format!("{now}, {before} on record")),
    }
}

impl Record {
    /// Reads the record. It is empty if there is no file.
    pub(crate) fn load() -> Result<Self> {
        match fs::read_to_string(project::root().join(FILE)) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Self::default()),
            text => serde_json::from_str(&text?).context(FILE),
        }
    }

    /// A group, or an empty one.
    pub(crate) fn group(&self, name: &str) -> Group {
        self.0.get(name).cloned().unwrap_or_default()
    }

    /// Replaces the most instructions of a call by those on record, if these are more and the code is as it was: its counts and
    /// bytes are equal. A search finds a part of the worst inputs, and another part each time that its order changes.
    pub(crate) fn keep_most(&mut self, record: &Self) {
        for (group, now) in &mut self.0 {
            let Some(before) = record.0.get(group).filter(|before| before.about == now.about) else {
                continue;
            };
            for (name, units) in &mut now.figures {
                let Some(old) = before.figures.get(name) else { continue };
                let is_same = ["instructions", "bytes"].iter().all(|unit| old.get(*unit) == units.get(*unit));
                let most = |units: &IndexMap<String, Value>| units.get(MOST).and_then(Value::as_f64);
                if is_same && most(old) > most(units) && units.contains_key(MOST) {
                    units.insert(MOST.to_owned(), old[MOST].clone());
                }
            }
        }
    }

    /// The text of the file, with one line for each name, so that a `diff` shows which figures changed.
    pub(crate) fn text(&self) -> Result<String> {
        let groups = self.0.iter().map(|(name, Group { about, figures })| {
            let figures = figures
                .iter()
                .map(|(name, units)| Ok(format!("\"{name}\": {}", serde_json::to_string(units)?)));
            let figures = figures.collect::<Result<Vec<_>>>()?.join(",\n");
            Ok(format!(
                "\"{name}\": {{\n\"about\": {},\n\"figures\": {{\n{figures}\n}}}}",
                serde_json::to_string(about)?
            ))
        });
        Ok(format!("{{\n{}\n}}\n", groups.collect::<Result<Vec<_>>>()?.join(",\n")))
    }

    /// Compares groups that were measured now with those on record: the differences, and remarks that
    /// are no differences.
    pub(crate) fn compare(&self, now: &Self) -> [Vec<String>; 2] {
        let [mut differences, mut remarks] = [(); 2].map(|()| Vec::new());
        for (name, now) in &now.0 {
            let Some(before) = self.0.get(name) else {
                differences.push(format!("{name}: is not on record"));
                continue;
            };
            if let (Some(old), Some(new)) = (before.about.get("compiler"), now.about.get("compiler"))
                && old != new
            {
                let percent = 100.0 * LEEWAY;
                remarks
                    .push(format!("{name}: {new}, the record is of {old}: counts may differ by {percent} %"));
            }
            let found = before.differences(now);
            let more = found.len().saturating_sub(SHOWN);
            differences.extend(found.into_iter().take(SHOWN).map(|told| format!("{name}: {told}")));
            differences.extend((more > 0).then(|| format!("{name}: {more} more")));
        }
        [differences, remarks]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(compiler: &str, unit: &str, value: f64) -> Record {
        let mut group = Group::about(&[("compiler", compiler.to_owned())]);
        group.add("soft.fx16", unit, value);
        Record([("cortex-m0".to_owned(), group)].into())
    }

    #[test]
    fn record_with_one_compiler_has_no_leeway_but_for_times() {
        for unit in ["instructions", "cycles", "bytes", "codes"] {
            let [differences, _] = group("rustc 1", unit, 20.0).compare(&group("rustc 1", unit, 20.02));
            assert_eq!(differences, [format!("cortex-m0: soft.fx16, {unit}: worse: 20.02, 20 on record")]);
        }
        assert_eq!(
            group("rustc 1", "ns", 1.0).compare(&group("rustc 1", "ns", 9.0)),
            [(); 2].map(|()| Vec::<String>::new())
        );
    }

    #[test]
    fn record_with_another_compiler_has_five_percent_and_a_remark() {
        let [differences, remarks] =
            group("rustc 1", "instructions", 100.0).compare(&group("rustc 2", "instructions", 104.9));
        assert!(differences.is_empty() && remarks[0].contains("5 %"), "{differences:?} {remarks:?}");
        for (unit, value, count) in [("instructions", 105.1, 1), ("bytes", 500.0, 0), ("codes", 100.1, 1)] {
            let [differences, _] = group("rustc 1", unit, 100.0).compare(&group("rustc 2", unit, value));
            assert_eq!(differences.len(), count, "{differences:?}");
        }
    }

    #[test]
    fn record_with_a_figure_that_is_gone_or_new_differs() {
        let [differences, _] = group("rustc 1", "bytes", 1.0).compare(&group("rustc 1", "flash", 1.0));
        let told = ["bytes: is no longer measured", "flash: is not on record"];
        assert_eq!(differences, told.map(|told| format!("cortex-m0: soft.fx16, {told}")));
    }

    #[test]
    fn line_has_three_words() {
        let mut group = Group::default();
        group.add_lines("soft.fx16 0.021 codes\nsoft.fx16 exhaustive kind\n").unwrap();
        assert_eq!(group.number("soft.fx16", "codes"), Some(0.021));
        assert_eq!(group.text("soft.fx16", "kind"), Some("exhaustive"));
        assert!(group.add_lines("soft.fx16 0.021").unwrap_err().to_string().contains("soft.fx16"));
    }

    #[test]
    fn most_that_was_found_is_kept_while_the_code_is_the_same() {
        let record = |bytes: u64, most: u64| {
            let mut record = group("rustc 1", "bytes", bytes as f64);
            record.0["cortex-m0"].add("soft.fx16", MOST, most);
            record
        };
        for (now, kept) in [(record(10, 80), 90.0), (record(10, 95), 95.0), (record(12, 80), 80.0)] {
            let mut now = now;
            now.keep_most(&record(10, 90));
            assert_eq!(now.group("cortex-m0").number("soft.fx16", MOST), Some(kept));
        }
    }
}
