//! Drawing a picture, row by row, while the display receives the row before.

use core::fmt;
use core::ops::Range;

use luminaire_stage::{Markers, Stage};

use crate::display::{Panel, Row, open};

/// The stage in a picture of `WIDTH` pixels, with two rows: one is drawn, the other is sent.
pub(crate) struct Picture<const WIDTH: usize> {
    stage: Stage<WIDTH>,
    rows: Option<[Row<WIDTH>; 2]>,
}

impl<const WIDTH: usize> Picture<WIDTH> {
    pub(crate) fn new(rows: &'static mut [[u16; WIDTH]; 2]) -> Self {
        let [first, second] = rows;
        Self { stage: Stage::default(), rows: Some([first, second]) }
    }

    /// Draws the rows of a frame.
    pub(crate) fn draw<M: Markers>(
        &mut self,
        frame: u32,
        rows: Range<i32>,
        panel: &mut impl Panel,
        now: impl Fn() -> u32,
    ) -> Option<Report> {
        let Self { stage, rows: buffers } = self;
        stage.turn_to(frame);
        let mut report = Report::default();
        let mut draw = |row, pixels: &mut [u16; WIDTH]| {
            let start = now();
            stage.draw::<M>(row, pixels);
            report.cycles += now().wrapping_sub(start) & CYCLES;
            report.add(pixels);
        };
        open(panel, WIDTH as u16, rows.len() as u16)?;
        let [mut drawn, mut free] = buffers.take()?;
        draw(rows.start, drawn);
        for row in rows.start + 1..rows.end {
            let sent = panel.send(drawn, || draw(row, free))?;
            (drawn, free) = (free, sent);
        }
        *buffers = Some([panel.send(drawn, || {})?, free]);
        Some(report)
    }

    /// Sends a black square in place of a picture.
    pub(crate) fn blacken(&mut self, panel: &mut impl Panel) -> Option<Report> {
        let mut report = Report::default();
        open(panel, WIDTH as u16, WIDTH as u16)?;
        let [mut row, other] = self.rows.take()?;
        row.fill(0);
        for _ in 0..WIDTH {
            report.add(row);
            row = panel.send(row, || {})?;
        }
        self.rows = Some([row, other]);
        Some(report)
    }
}

/// The largest number of cycles between two looks at the counter: a row takes fewer.
const CYCLES: u32 = (1 << 24) - 1;

/// What was drawn, and in how many cycles.
pub(crate) struct Report {
    pixels: u32,
    checksum: u32,
    cycles: u32,
}

impl Default for Report {
    fn default() -> Self {
        Self { pixels: 0, checksum: luminaire_stage::CHECKSUM, cycles: 0 }
    }
}

impl Report {
    fn add(&mut self, pixels: &[u16]) {
        self.pixels += pixels.len() as u32;
        self.checksum = luminaire_stage::checksum(self.checksum, pixels);
    }
}

impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixels, checksum, cycles } = self;
        write!(out, "{pixels} pixels, checksum {checksum:08x}, {cycles} cycles")
    }
}
