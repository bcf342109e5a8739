//! The output of the program.

use anyhow::{Context, Result, ensure};

use super::picture::Picture;

/// The output: a line with the size and the stages, a line for each row, and a line that states how
/// many pixels the light reaches.
#[derive(Debug, PartialEq)]
pub(super) struct Output {
    /// The stages that are counted in each row, in their order.
    pub(super) stages: Vec<String>,
    pub(super) picture: Picture,
    pub(super) tally: String,
}

impl Output {
    /// Parses the lines that the program prints.
    pub(super) fn parse(lines: &[String]) -> Result<Self> {
        let [head, rows @ .., tally] = lines else { anyhow::bail!("the firmware has printed nothing") };
        let mut words = head.split(' ');
        let mut number = || words.next().and_then(|word| word.parse().ok());
        let (width, height) = (number(), number());
        let (width, height): (u32, u32) = width.zip(height).with_context(|| format!("not a size: {head}"))?;
        let stages: Vec<_> = words.map(str::to_owned).collect();
        ensure!(!stages.is_empty(), "there are no stages: {head}");
        let picture = Picture::of_rows(width, height, rows)?;
        Ok(Self { stages, picture, tally: tally.clone() })
    }

    /// The number of counted regions: one for each stage of each row.
    pub(super) fn regions(&self) -> usize {
        self.stages.len() * self.picture.height() as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Output> {
        Output::parse(&text.lines().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn size_stages_rows_and_tally_are_read() {
        let output = parse("2 3 geometry light\n00001111\n22223333\n44445555\n6 lit").unwrap();
        assert_eq!((output.regions(), output.tally.as_str()), (6, "6 lit"));
        assert_eq!(output.stages, ["geometry", "light"]);
    }

    #[test]
    fn a_line_that_is_missing_or_broken_is_an_error() {
        for text in [
            "",
            "2 1 light",
            "2 1\n00001111\n2 lit",
            "2 1 light\n0000111\n2 lit",
            "2 1 light\n0000xyz1\n2 lit",
            "2 2 light\n00001111\n2 lit",
        ] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
