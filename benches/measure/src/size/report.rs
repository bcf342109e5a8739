//! The table of bytes.

use std::fmt;

use serde_json::{Map, Value};

/// The bytes of the same effects in several formats on several targets.
#[derive(Debug, Default)]
pub(crate) struct Report {
    columns: Vec<Column>,
}

#[derive(Debug)]
struct Column {
    target: &'static str,
    format: &'static str,
    effects: Vec<(String, u64)>,
}

impl Report {
    /// Adds what the effects take in a format on a target.
    pub(crate) fn add(&mut self, target: &'static str, format: &'static str, effects: Vec<(String, u64)>) {
        self.columns.push(Column { target, format, effects });
    }

    /// The bytes by target, format and effect.
    pub(crate) fn json(&self) -> Value {
        let mut targets = Map::new();
        for Column { target, format, effects } in &self.columns {
            let effects: Map<_, _> =
                effects.iter().map(|(name, bytes)| (name.clone(), (*bytes).into())).collect();
            let formats = targets.entry(*target).or_insert_with(|| Map::new().into());
            formats[*format] = effects.into();
        }
        targets.into()
    }
}

/// A line for each effect, with a column for each target and format.
impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(out, "bytes of flash over an empty program, opt-level = \"s\"")?;
        let row = |out: &mut fmt::Formatter<'_>, name: &str, cell: &dyn Fn(&Column) -> String| {
            write!(out, "{name:34}")?;
            for column in &self.columns {
                write!(out, " {:>10}", cell(column))?;
            }
            writeln!(out)
        };
        row(out, "", &|column| column.target.to_owned())?;
        row(out, "", &|column| column.format.to_owned())?;
        let Some(first) = self.columns.first() else { return Ok(()) };
        for (index, (name, _)) in first.effects.iter().enumerate() {
            let bytes = |column: &Column| column.effects.get(index).map(|(_, bytes)| bytes.to_string());
            row(out, name, &|column| bytes(column).unwrap_or_default())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report() -> Report {
        let mut report = Report::default();
        report.add("cortex-m0", "fx16", vec![("ambient".to_owned(), 48), ("point".to_owned(), 908)]);
        report.add("cortex-m0", "f32", vec![("ambient".to_owned(), 40), ("point".to_owned(), 4000)]);
        report
    }

    #[test]
    fn json_goes_by_target_format_and_effect() {
        let expected =
            r#"{"cortex-m0":{"f32":{"ambient":40,"point":4000},"fx16":{"ambient":48,"point":908}}}"#;
        assert_eq!(report().json().to_string(), expected);
    }

    #[test]
    fn the_table_has_a_line_for_each_effect() {
        let table = report().to_string();
        let lines: Vec<Vec<_>> =
            table.lines().skip(1).map(|line| line.split_whitespace().collect()).collect();
        assert_eq!(lines[1], ["fx16", "f32"]);
        assert_eq!(lines[3], ["point", "908", "4000"]);
    }
}
