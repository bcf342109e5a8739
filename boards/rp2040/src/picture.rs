//! Drawing a picture, row by row, while the display receives the row before.

use core::arch::asm;
use core::fmt;
use core::ops::Range;

use luminaire_stage::{Markers, Stage};

use crate::clock::Counter;
use crate::panel::{Panel, Row};

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
    pub(crate) fn draw(
        &mut self,
        frame: u32,
        rows: Range<i32>,
        panel: &mut Panel,
        counter: &Counter,
    ) -> Option<Report> {
        let Self { stage, rows: buffers } = self;
        stage.turn_to(frame);
        let mut report = Report::default();
        let mut draw = |row, pixels: &mut [u16; WIDTH]| {
            report.cycles += counter.cycles(|| stage.draw::<Marked>(row, pixels));
            report.add(pixels);
        };
        panel.open(WIDTH as u16, rows.len() as u16)?;
        let [mut drawn, mut free] = buffers.take()?;
        draw(rows.start, drawn);
        for row in rows.start + 1..rows.end {
            let sent = panel.send(drawn, || draw(row, free))?;
            (drawn, free) = (free, sent);
        }
        *buffers = Some([panel.send(drawn, || {})?, free]);
        Some(report)
    }
}

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

/// The markers by which emulators count instructions: they do nothing.
struct Marked;

impl Markers for Marked {
    #[inline(always)]
    fn begin() {
        // SAFETY: a move of a register to itself changes nothing.
        unsafe { asm!("mov r10, r10", options(nostack, preserves_flags)) };
    }

    #[inline(always)]
    fn end() {
        // SAFETY: a move of a register to itself changes nothing.
        unsafe { asm!("mov r11, r11", options(nostack, preserves_flags)) };
    }
}
