//! Checking the file line by line.

use core::fmt::{self, Write};

use crate::case::{Case, Evaluate, Input, Inputs};
use crate::model::find;
use crate::text::Text;

/// Maximum number of differing cases that are reported.
const TOLD: u32 = 5;

/// A check that is given the lines of the file in order. Its `Display` is `123 cases, 4 differ`.
#[derive(Clone, Copy, Default, Debug)]
pub struct Check {
    section: Option<Evaluate>,
    line: u32,
    cases: u32,
    differ: u32,
}

impl Check {
    /// Whether there were cases, and all had the outputs that the file states.
    pub fn is_passed(&self) -> bool {
        self.cases > 0 && self.differ == 0
    }

    /// Checks the next line of the file. If the outputs of its case differ, the case is reported
    /// with the outputs found. A case of an unknown section, or with too few or too many inputs, is
    /// reported as not understood.
    ///
    /// # Errors
    /// Returns the errors of writing to `report`.
    pub fn take(&mut self, line: &str, report: &mut impl Write) -> fmt::Result {
        self.line += 1;
        let case = line.split('#').next().unwrap_or_default().trim_end();
        if case.is_empty() {
            return Ok(());
        }
        if let Some(header) = case.strip_prefix('[') {
            self.section = header.split_once(']').and_then(|(section, _)| find(section));
            return Ok(());
        }
        self.cases += 1;
        let found = self.found(case);
        let expected = case.split_once(" -> ").map(|(_, expected)| expected);
        if found.as_ref().map(Text::as_str) == expected && expected.is_some() {
            return Ok(());
        }
        self.differ += 1;
        if self.differ > TOLD {
            return Ok(());
        }
        let found = found.as_ref().map_or("not understood", Text::as_str);
        writeln!(report, "line {}: {case}, found {found}", self.line)
    }

    /// Returns the outputs that this implementation computes for a case.
    fn found(&self, case: &str) -> Option<Text> {
        let (inputs, _) = case.split_once(" -> ")?;
        let mut words = Words { words: inputs.split(' ') };
        let found = Case::run(self.section?, &mut words)?;
        words.words.next().is_none().then_some(found)
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} cases, {} differ", self.cases, self.differ)
    }
}

/// The inputs of a line.
struct Words<'a> {
    words: core::str::Split<'a, char>,
}

impl Inputs for Words<'_> {
    fn word(&mut self, input: Input) -> Option<u64> {
        let word = self.words.next().filter(|word| word.len() == input.digits)?;
        u64::from_str_radix(word, 16).ok()
    }
}
