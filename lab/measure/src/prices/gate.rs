//! Comparing what was measured with the list that is checked in: errors and counts, never times.

use super::clocked::is_platforms_own;
use super::list::{Cost, PriceList, Row};

/// How far counts may be from those of another compiler.
const LEEWAY: f64 = 0.05;

/// What came of a comparison.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Verdict {
    /// What differs, each with the name of its row.
    pub(crate) differences: Vec<String>,
    /// Remarks for the reader. They do not fail the check.
    pub(crate) remarks: Vec<String>,
}

/// Compares a list with a new one: rows that are gone or new, errors, and the counts of the targets
/// `counted`.
pub(crate) fn compare(old: &PriceList, new: &PriceList, counted: &[&str]) -> Verdict {
    let mut verdict = Verdict::default();
    let mut leeway = Vec::new();
    for &target in counted {
        let compiler = |list: &PriceList| list.meta.targets.get(target).map(|meta| meta.compiler.clone());
        if let (Some(before), Some(now)) = (compiler(old), compiler(new))
            && before != now
        {
            verdict.remarks.push(format!(
                "{target}: {now}, the list is of {before}: its counts may differ by {:.0} %",
                100.0 * LEEWAY
            ));
            leeway.push(target);
        }
    }
    for row in &old.rows {
        match new.row(&row.name()) {
            None => verdict.differences.push(format!("{}: is no longer measured", row.name())),
            Some(now) => {
                verdict.errors(row, now);
                for &target in counted {
                    verdict.counts(row, now, target, if leeway.contains(&target) { LEEWAY } else { 0.0 });
                }
            }
        }
    }
    let is_new = |row: &&Row| old.row(&row.name()).is_none();
    verdict
        .differences
        .extend(new.rows.iter().filter(is_new).map(|row| format!("{}: is not on the list", row.name())));
    verdict
}

impl Verdict {
    fn differ(&mut self, row: &Row, what: &str, before: f64, now: f64) {
        let word = if now > before { "worse" } else { "better" };
        self.differences.push(format!("{}: {word}: {what} {now}, the list has {before}", row.name()));
    }

    /// The errors in every cone.
    fn errors(&mut self, before: &Row, now: &Row) {
        if is_platforms_own(&before.name()) || (before.error == now.error && before.narrower == now.narrower)
        {
            return;
        }
        let errors = |row: &Row| {
            let narrower = row.narrower.iter().map(|cone| (cone.half_angle, cone.error.clone()));
            let mut all = vec![(0.0, row.error.clone())];
            all.extend(narrower);
            all
        };
        let before_now = errors(before).into_iter().zip(errors(now));
        let found = self.differences.len();
        for ((half_angle, before_error), (_, now_error)) in before_now {
            if let (Some(b), Some(n)) = (before_error, now_error) {
                let cone = if half_angle > 0.0 { format!(" at {half_angle} degrees") } else { String::new() };
                for (what, b, n) in [
                    ("largest error in codes", b.codes, n.codes),
                    ("mean error in codes", b.mean_codes, n.mean_codes),
                    ("99.9th percentile in codes", b.p999_codes, n.p999_codes),
                ] {
                    if b != n {
                        self.differ(before, &format!("{what}{cone}"), b, n);
                    }
                }
            }
        }
        if self.differences.len() == found {
            self.differences.push(format!("{}: other cones, or the error is elsewhere", before.name()));
        }
    }

    /// Instructions and bytes on a target.
    fn counts(&mut self, before: &Row, now: &Row, target: &str, leeway: f64) {
        let figures = |row: &Row| match row.cost.get(target) {
            Some(Cost::Counted { instructions, .. }) => Some((*instructions, row.bytes.get(target).copied())),
            _ => None,
        };
        let (Some((before_count, before_bytes)), Some((count, bytes))) = (figures(before), figures(now))
        else {
            if figures(before).is_some() != figures(now).is_some() {
                self.differences.push(format!("{}: is counted on {target} in one list only", before.name()));
            }
            return;
        };
        if (count - before_count).abs() > leeway * before_count {
            self.differ(before, &format!("instructions on {target}"), before_count, count);
        }
        if leeway == 0.0 && bytes != before_bytes {
            let number = |bytes: Option<u64>| bytes.unwrap_or_default() as f64;
            self.differ(before, &format!("bytes on {target}"), number(before_bytes), number(bytes));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::list::{Error, TargetMeta};
    use super::*;

    const TARGET: &str = "cortex-m0";

    fn row(kernel: &str, codes: f64, instructions: f64) -> Row {
        let error = Error {
            codes,
            lsb: 1.0,
            at: None,
            mean_codes: 0.01,
            p999_codes: 0.02,
            kind: "searched".to_owned(),
        };
        Row {
            kernel: kernel.to_owned(),
            stage: "falloff".to_owned(),
            format: "fx16".to_owned(),
            error: Some(error),
            narrower: Vec::new(),
            cost: [(TARGET.to_owned(), Cost::Counted { instructions, ratio_to_powf: 1.0 })].into(),
            bytes: [(TARGET.to_owned(), 80)].into(),
        }
    }

    fn list(compiler: &str, rows: &[Row]) -> PriceList {
        let mut list = PriceList { rows: rows.to_vec(), ..PriceList::default() };
        let meta = TargetMeta { compiler: compiler.to_owned(), ..TargetMeta::default() };
        list.meta.targets.insert(TARGET.to_owned(), meta);
        list
    }

    fn differences(old: &PriceList, new: &PriceList) -> Vec<String> {
        compare(old, new, &[TARGET]).differences
    }

    #[test]
    fn the_same_figures_pass() {
        let same = list("rustc 1.96.0", &[row("soft", 0.02, 20.0)]);
        assert_eq!(compare(&same, &same, &[TARGET]), Verdict::default());
    }

    #[test]
    fn one_instruction_in_a_thousand_is_told_with_its_row() {
        let old = list("rustc 1.96.0", &[row("soft", 0.02, 20.0)]);
        let new = list("rustc 1.96.0", &[row("soft", 0.02, 20.02)]);
        let told = differences(&old, &new);
        assert_eq!(told, ["soft.fx16: worse: instructions on cortex-m0 20.02, the list has 20"]);
        assert!(differences(&new, &old)[0].contains("better"), "an improvement has to be accepted too");
    }

    #[test]
    fn another_compiler_has_five_percent_and_is_told_of() {
        let old = list("rustc 1.96.0", &[row("soft", 0.02, 100.0)]);
        let within = list("rustc 1.97.0", &[row("soft", 0.02, 104.9)]);
        let verdict = compare(&old, &within, &[TARGET]);
        assert!(verdict.differences.is_empty(), "{:?}", verdict.differences);
        assert!(
            verdict.remarks[0].contains("1.97.0") && verdict.remarks[0].contains("5 %"),
            "{:?}",
            verdict.remarks
        );
        let over = list("rustc 1.97.0", &[row("soft", 0.02, 105.1)]);
        assert_eq!(differences(&old, &over).len(), 1);
        let fewer = list("rustc 1.97.0", &[row("soft", 0.02, 94.9)]);
        assert_eq!(differences(&old, &fewer).len(), 1);
    }

    #[test]
    fn errors_have_no_leeway_whatever_the_compiler() {
        let old = list("rustc 1.96.0", &[row("soft", 0.02, 20.0)]);
        let new = list("rustc 1.97.0", &[row("soft", 0.020_01, 20.0)]);
        assert!(differences(&old, &new)[0].contains("soft.fx16: worse: largest error"));
    }

    #[test]
    fn a_row_that_is_gone_or_new_is_named() {
        let old = list("rustc 1.96.0", &[row("soft", 0.02, 20.0), row("hard", 0.02, 30.0)]);
        let new = list("rustc 1.96.0", &[row("soft", 0.02, 20.0), row("inverted-power-4", 0.02, 30.0)]);
        let told = differences(&old, &new).join("\n");
        assert!(told.contains("hard.fx16") && told.contains("inverted-power-4.fx16"), "{told}");
        let mut uncounted = old.clone();
        uncounted.rows[0].cost.clear();
        assert!(differences(&old, &uncounted)[0].contains("in one list only"));
    }

    #[test]
    fn other_bytes_are_told_for_the_same_compiler() {
        let old = list("rustc 1.96.0", &[row("soft", 0.02, 20.0)]);
        let mut new = old.clone();
        new.rows[0].bytes.insert(TARGET.to_owned(), 84);
        assert!(differences(&old, &new)[0].contains("bytes on cortex-m0 84"));
    }
}
