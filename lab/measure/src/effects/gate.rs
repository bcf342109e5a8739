//! Compares the counts with the record.

use super::record::{Price, Prices, Record};

/// How far instructions may be from those of another compiler.
const LEEWAY: f64 = 0.05;

/// What came of a comparison.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Verdict {
    /// What differs, each with its board and its program.
    pub(super) differences: Vec<String>,
    /// Remarks for the reader. They do not fail the check.
    pub(super) remarks: Vec<String>,
}

/// Compares a record with a new one, on the boards of the new one.
pub(super) fn compare(old: &Record, new: &Record) -> Verdict {
    let mut verdict = Verdict::default();
    for (board, now) in &new.boards {
        match old.boards.get(board) {
            Some(before) => verdict.board(board, before, now),
            None => verdict.differences.push(format!("{board} is not recorded")),
        }
    }
    verdict
}

impl Verdict {
    fn board(&mut self, board: &str, before: &Prices, now: &Prices) {
        let is_same = before.compiler == now.compiler;
        if !is_same {
            let (now, before, percent) = (&now.compiler, &before.compiler, 100.0 * LEEWAY);
            self.remarks.push(format!(
                "{board}: {now}, recorded by {before}: its instructions may differ by {percent:.0} %"
            ));
        }
        if before.format != now.format {
            self.differences.push(format!("{board}: in {}, recorded in {}", now.format, before.format));
        }
        for (program, price) in &now.prices {
            match before.prices.get(program) {
                Some(recorded) => self.price(&format!("{board}: {program}"), *recorded, *price, is_same),
                None => self.differences.push(format!("{board}: {program} is not recorded")),
            }
        }
        let gone = before.prices.keys().filter(|program| !now.prices.contains_key(*program));
        self.differences.extend(gone.map(|program| format!("{board}: {program} is no longer counted")));
    }

    /// Of the same compiler everything must be the same.
    fn price(&mut self, name: &str, before: Price, now: Price, is_same: bool) {
        let leeway = if is_same { 0.0 } else { LEEWAY };
        if (now.instructions - before.instructions).abs() > leeway * before.instructions {
            self.differ(name, "instructions", before.instructions, now.instructions);
        }
        if is_same && now.bytes != before.bytes {
            self.differ(name, "bytes", before.bytes as f64, now.bytes as f64);
        }
    }

    fn differ(&mut self, name: &str, what: &str, before: f64, now: f64) {
        let word = if now > before { "worse" } else { "better" };
        self.differences.push(format!("{name}: {word}: {now} {what}, recorded {before}"));
    }
}

#[cfg(test)]
mod tests {
    use super::super::record::tests::record;
    use super::*;

    const COMPILER: &str = "rustc 1.96.0";

    fn differences(old: &Record, new: &Record) -> Vec<String> {
        compare(old, new).differences
    }

    #[test]
    fn the_same_prices_pass() {
        let same = record(COMPILER, "phong", 100.0, 400);
        assert_eq!(compare(&same, &same), Verdict::default());
    }

    #[test]
    fn an_instruction_or_a_byte_more_or_less_is_told() {
        let old = record(COMPILER, "phong", 100.0, 400);
        let slower = record(COMPILER, "phong", 100.00390625, 400);
        assert_eq!(
            differences(&old, &slower),
            ["cortex-m0: phong: worse: 100.00390625 instructions, recorded 100"]
        );
        assert!(differences(&slower, &old)[0].contains("better"));
        let larger = record(COMPILER, "phong", 100.0, 402);
        assert_eq!(differences(&old, &larger), ["cortex-m0: phong: worse: 402 bytes, recorded 400"]);
    }

    #[test]
    fn another_compiler_has_five_percent_and_is_told_of() {
        let old = record(COMPILER, "phong", 100.0, 400);
        let verdict = compare(&old, &record("rustc 1.97.0", "phong", 104.9, 420));
        assert!(verdict.differences.is_empty(), "{:?}", verdict.differences);
        assert!(verdict.remarks[0].contains("1.97.0"), "{:?}", verdict.remarks);
        assert_eq!(differences(&old, &record("rustc 1.97.0", "phong", 94.9, 400)).len(), 1);
    }

    #[test]
    fn a_program_that_is_gone_or_new_is_told() {
        let old = record(COMPILER, "phong", 100.0, 400);
        let told = differences(&old, &record(COMPILER, "difference-form", 100.0, 400)).join("\n");
        assert!(
            told.contains("phong is no longer") && told.contains("difference-form is not recorded"),
            "{told}"
        );
        assert_eq!(differences(&Record::default(), &old), ["cortex-m0 is not recorded"]);
        let mut other = old.clone();
        other.boards.get_mut("cortex-m0").unwrap().format = "f32".to_owned();
        assert!(differences(&old, &other)[0].contains("f32"));
    }
}
