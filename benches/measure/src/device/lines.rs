//! The lines that the firmware prints, one for each picture, and the row of the table of boards.

use anyhow::{Context, Result, ensure};
use luminaire_stage::Shown;

/// The page with the table of boards.
pub(super) const PAGE: &str = "examples/boards/README.md";
/// The clock of the firmware's processor, in MHz.
const MHZ: f64 = 133.0;

/// A line such as `frame 0: 19200 pixels, checksum 564e2a8e, 2080715 cycles`.
#[derive(Debug)]
pub(super) struct Line {
    pub(super) name: String,
    pixels: usize,
    checksum: u32,
    /// The cycles that passed while both cores drew.
    cycles: u64,
}

impl Line {
    pub(super) fn parse(text: &str) -> Result<Self> {
        let parsed = || {
            let (name, rest) = text.split_once(": ")?;
            let mut parts = rest.split(", ");
            let pixels = parts.next()?.strip_suffix(" pixels")?.parse().ok()?;
            let checksum = u32::from_str_radix(parts.next()?.strip_prefix("checksum ")?, 16).ok()?;
            let cycles = parts.next()?.strip_suffix(" cycles")?.parse().ok()?;
            parts.next().is_none().then(|| Self { name: name.to_owned(), pixels, checksum, cycles })
        };
        parsed().with_context(|| format!("`{text}`: expected `NAME: N pixels, checksum HEX, N cycles`"))
    }

    /// Fails if the line is of another picture, or of other pixels.
    pub(super) fn is_of(&self, expected: &Shown) -> Result<()> {
        let (name, pixels, checksum) = (&expected.name, expected.pixels.len(), expected.checksum());
        let same = (&self.name, self.pixels, self.checksum) == (name, pixels, checksum);
        let Self { name: found, pixels: count, checksum: other, .. } = self;
        ensure!(
            same,
            "expected {name}, {pixels} pixels, checksum {checksum:08x}; found {found}, {count} pixels, {other:08x}"
        );
        Ok(())
    }

    /// The cycles that passed while both cores drew a pixel.
    pub(super) fn cycles_a_pixel(&self) -> f64 {
        self.cycles as f64 / self.pixels as f64
    }
}

/// The row of a board in the table: the still, the black display and the first frame are the first of its lines.
/// None if it has fewer.
pub(super) fn row(board: &str, lines: &[Line]) -> Option<String> {
    let [still, _, frame, ..] = lines else { return None };
    let count = lines.len();
    let [of_still, of_frame] = [still, frame].map(Line::cycles_a_pixel);
    let rate = MHZ * 1e6 / frame.cycles as f64;
    Some(format!("| {board} | {count} | {of_still:.1} | {of_frame:.1} | {rate:.1} |"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: &str = "frame 0: 19200 pixels, checksum 564e2a8e, 1920000 cycles";

    #[test]
    fn a_line_is_of_one_picture_alone() {
        let expected = Shown::numbered(2);
        let is_of = |text: &str| Line::parse(text).and_then(|line| line.is_of(&expected)).is_ok();
        let line = LINE.replace("564e2a8e", &format!("{:08x}", expected.checksum()));
        assert!(is_of(&line), "{line}");
        for (part, other) in
            [("frame 0", "frame 1"), ("19200", "19201"), (", checksum ", ", checksum 1"), (" cycles", "")]
        {
            assert!(!is_of(&line.replace(part, other)), "{part}");
        }
    }

    #[test]
    fn a_row_has_cycles_a_pixel_and_pictures_a_second() {
        let lines = [LINE; 3].map(|line| Line::parse(line).unwrap());
        assert_eq!(row("this", &lines).unwrap(), "| this | 3 | 100.0 | 100.0 | 69.3 |");
        assert_eq!(row("this", &lines[1..]), None);
    }
}
