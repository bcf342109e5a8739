//! The price list, as `docs/accuracy-vs-cost.json` has it. The page made of it documents the keys.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use tools::project;

use super::clocked::is_platforms_own;
use super::ladder::{self, Rung};
use super::target::Target;
use super::{page, plot, summary};
use crate::record::{Figure, Group, Record, replaced};

/// The price list: errors and costs of every kernel, and what the costs depend on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct PriceList {
    pub(crate) meta: Meta,
    pub(crate) rows: Vec<Row>,
    /// The errors of lit points by each evaluation.
    #[serde(default)]
    pub(crate) ladder: Vec<Rung>,
}

#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Meta {
    /// The outer half angle, in degrees, of the cone that `error` and `cost` are measured in.
    pub(crate) half_angle: f64,
    pub(crate) targets: BTreeMap<String, TargetMeta>,
}

/// What the costs of a target depend on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct TargetMeta {
    pub(crate) compiler: String,
    pub(crate) flags: String,
    pub(crate) runs_on: String,
    /// The power function that `ratio_to_powf` compares with.
    pub(crate) reference: String,
    /// The day, as in 2026-01-31.
    pub(crate) measured: String,
}

/// A kernel in a format.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) kernel: String,
    pub(crate) stage: String,
    pub(crate) format: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) error: Option<Error>,
    /// The errors in narrower cones, the widest first.
    pub(crate) narrower: Vec<Cone>,
    pub(crate) cost: BTreeMap<String, Cost>,
    /// Bytes of code, by target.
    pub(crate) bytes: BTreeMap<String, u64>,
}

/// The errors of a kernel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Error {
    pub(crate) codes: f64,
    pub(crate) lsb: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) at: Option<Place>,
    pub(crate) mean_codes: f64,
    pub(crate) p999_codes: f64,
    /// `exhaustive` or `searched`.
    pub(crate) kind: String,
}

/// The input with the largest error of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Place {
    pub(crate) degrees_off_axis: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) distance: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) degrees_of_incidence: Option<f64>,
}

/// The errors of a kernel in a cone, or that its format refuses the cone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Cone {
    pub(crate) half_angle: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) error: Option<Error>,
    /// The narrowest half angle that the format supports, if it does not support this one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) narrowest: Option<f64>,
}

/// What a call costs on a target.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub(crate) enum Cost {
    Counted {
        instructions: f64,
        /// On the core of an RP2040, without wait states.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        cycles: Option<f64>,
        ratio_to_powf: f64,
    },
    Timed {
        ns: f64,
        /// The lower and the upper quartile.
        ns_quartiles: [f64; 2],
        ratio_to_powf: f64,
    },
}

impl Cost {
    /// Instructions or nanoseconds.
    pub(crate) fn amount(&self) -> f64 {
        match *self {
            Self::Counted { instructions, .. } => instructions,
            Self::Timed { ns, .. } => ns,
        }
    }

    pub(crate) fn ratio(&mut self) -> &mut f64 {
        match self {
            Self::Counted { ratio_to_powf, .. } | Self::Timed { ratio_to_powf, .. } => ratio_to_powf,
        }
    }
}

impl Row {
    /// The name of the kernel in its format, such as `soft.fx16`.
    pub(crate) fn name(&self) -> String {
        format!("{}.{}", self.kernel, self.format)
    }
}

impl PriceList {
    /// The row of this name.
    pub(crate) fn row(&self, name: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.name() == name)
    }

    /// The row of this name, to be changed.
    pub(crate) fn row_mut(&mut self, name: &str) -> Result<&mut Row> {
        let found = self.rows.iter_mut().find(|row| row.name() == name);
        found.with_context(|| format!("{name} has a cost but no error"))
    }

    /// The targets whose costs are on the list, in the order of the page.
    pub(super) fn targets(&self) -> impl Iterator<Item = Target> {
        Target::all().into_iter().filter(|target| self.meta.targets.contains_key(target.name()))
    }
}

impl Row {
    /// Adds the errors in every cone to a group of figures.
    fn errors(&self, half_angle: f64, group: &mut Group) {
        let widest = Cone { half_angle, error: self.error.clone(), narrowest: None };
        for cone in [&widest].into_iter().chain(&self.narrower) {
            let name = |what: &str| format!("{}, {what} at {} degrees", self.name(), cone.half_angle);
            if let Some(error) = &cone.error {
                for (what, codes) in [
                    ("largest error", error.codes),
                    ("mean error", error.mean_codes),
                    ("99.9th percentile", error.p999_codes),
                    ("units in the last place", error.lsb),
                ] {
                    group.add(name(what), Figure::Exact(codes));
                }
                group.add(name("place"), Figure::Text(format!("{:?} {}", error.at, error.kind)));
            } else if let Some(narrowest) = cone.narrowest {
                group.add(name("narrowest half angle"), Figure::Exact(narrowest));
            }
        }
    }
}

impl Record for PriceList {
    const FILE: &'static str = "docs/accuracy-vs-cost.json";
    const COMMAND: &'static str = "cargo xtask measure";

    fn read(text: &str) -> Result<Self> {
        Ok(serde_json::from_str(text)?)
    }

    /// The text has one line for each row, so that a `diff` shows which rows changed.
    fn text(&self) -> Result<String> {
        let rows: Result<Vec<_>, _> = self.rows.iter().map(serde_json::to_string).collect();
        let meta = serde_json::to_string_pretty(&self.meta)?;
        let ladder: Result<Vec<_>, _> = self.ladder.iter().map(serde_json::to_string).collect();
        let [rows, ladder] = [rows?, ladder?].map(|lines| lines.join(",\n"));
        Ok(format!("{{\"meta\": {meta},\n\"rows\": [\n{rows}\n],\n\"ladder\": [\n{ladder}\n]}}\n"))
    }

    /// Errors and counts; times are not compared.
    fn figures(&self) -> BTreeMap<String, Group> {
        let mut errors = Group::exact();
        for row in self.rows.iter().filter(|row| !is_platforms_own(&row.name())) {
            row.errors(self.meta.half_angle, &mut errors);
        }
        ladder::errors(&self.ladder, &mut errors);
        let mut figures = BTreeMap::from([("errors".to_owned(), errors)]);
        for (target, meta) in &self.meta.targets {
            let [mut group, mut cycles] = [(); 2].map(|()| Group::of(&meta.compiler));
            for row in &self.rows {
                let Some(Cost::Counted { instructions, cycles: counted, .. }) = row.cost.get(target) else {
                    continue;
                };
                let bytes = row.bytes.get(target).copied().unwrap_or_default();
                group.add(format!("{}, instructions", row.name()), Figure::Instructions(*instructions));
                group.add(format!("{}, bytes", row.name()), Figure::Bytes(bytes));
                if let Some(counted) = counted {
                    cycles.add(format!("{}, cycles", row.name()), Figure::Instructions(*counted));
                }
            }
            if !cycles.is_empty() {
                figures.insert(format!("{target} by rp2040js"), cycles);
            }
            figures.insert(target.clone(), group);
        }
        figures
    }

    fn documents(&self) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        let docs = project::root().join("docs");
        let readme = project::root().join("README.md");
        let text = fs::read_to_string(&readme).context("cannot read README.md")?;
        let text = replaced(&text, summary::LINES, &summary::write(self)).context("README.md")?;
        let mut files = vec![
            (docs.join("ACCURACY-VS-COST.md"), page::write(self).into_bytes()),
            (readme, text.into_bytes()),
        ];
        for target in self.targets() {
            files.push((docs.join(target.picture()), plot::draw(self, &target)?.into_bytes()));
        }
        Ok(files)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{check_documents, load};

    #[test]
    fn documents_are_those_that_the_record_gives() {
        check_documents(&load::<PriceList>().unwrap().expect("a record")).unwrap();
    }

    #[test]
    fn what_is_written_is_read_and_all_but_times_compared() {
        let error = Error {
            codes: 0.5,
            lsb: 1.5,
            at: Some(Place { degrees_off_axis: 3.25, distance: None, degrees_of_incidence: None }),
            mean_codes: 0.1,
            p999_codes: 0.4,
            kind: "searched".to_owned(),
        };
        let counted = Cost::Counted { instructions: 20.5, cycles: Some(28.0), ratio_to_powf: 500.0 };
        let timed = Cost::Timed { ns: 0.5, ns_quartiles: [0.4, 0.6], ratio_to_powf: 10.0 };
        let row = Row {
            kernel: "soft".to_owned(),
            stage: "falloff".to_owned(),
            format: "fx16".to_owned(),
            error: Some(error),
            narrower: vec![Cone { half_angle: 1.0, error: None, narrowest: Some(1.4) }],
            cost: [("cortex-m0".to_owned(), counted), ("host".to_owned(), timed)].into(),
            bytes: [("cortex-m0".to_owned(), 84)].into(),
        };
        let mut list = PriceList {
            meta: Meta { half_angle: 15.0, ..Meta::default() },
            rows: vec![row],
            ..PriceList::default()
        };
        for target in ["cortex-m0", "host"] {
            list.meta.targets.insert(target.to_owned(), TargetMeta::default());
        }
        assert_eq!(PriceList::read(&list.text().unwrap()).unwrap(), list);
        let figures = list.figures();
        let names: Vec<_> = figures.keys().map(String::as_str).collect();
        assert_eq!(names, ["cortex-m0", "cortex-m0 by rp2040js", "errors", "host"]);
        let mut counted = Group::of("");
        counted.add("soft.fx16, instructions", Figure::Instructions(20.5));
        counted.add("soft.fx16, bytes", Figure::Bytes(84));
        let mut cycles = Group::of("");
        cycles.add("soft.fx16, cycles", Figure::Instructions(28.0));
        assert_eq!(figures["cortex-m0 by rp2040js"], cycles);
        assert_eq!((&figures["cortex-m0"], &figures["host"]), (&counted, &Group::of("")));
        let mut errors = Group::exact();
        list.rows[0].errors(15.0, &mut errors);
        assert_eq!(figures["errors"], errors);
    }
}
