//! Drawing a picture, two rows at a time, while the display receives the two rows before.

use core::fmt;
use core::ops::Range;

use luminaire_stage::{Markers, Stage};

use crate::display::{Panel, Words, open};
use crate::second::{Job, Second, Strip};

/// The stage in a picture of `WIDTH` pixels, with two pairs of rows: one pair is drawn, the other is sent. `PAIR`
/// is twice the width.
///
/// The second core draws the second row of a pair: no row needs more of the one before than a hint.
pub(crate) struct Picture<const WIDTH: usize, const PAIR: usize> {
    stage: Stage<WIDTH>,
    pairs: Option<[Words<PAIR>; 2]>,
    strip: Option<&'static mut dyn Strip>,
}

impl<const WIDTH: usize, const PAIR: usize> Picture<WIDTH, PAIR> {
    pub(crate) fn new(pairs: &'static mut [[u16; PAIR]; 2], strip: &'static mut dyn Strip) -> Self {
        const { assert!(PAIR == 2 * WIDTH) };
        let [first, second] = pairs;
        Self { stage: Stage::default(), pairs: Some([first, second]), strip: Some(strip) }
    }

    /// Draws the rows of a frame, an even number.
    pub(crate) fn draw<M: Markers>(
        &mut self,
        frame: u32,
        rows: Range<i32>,
        panel: &mut impl Panel,
        second: &mut impl Second,
        now: impl Fn() -> u32,
    ) -> Option<Report> {
        let Self { stage, pairs, strip } = self;
        stage.turn_to(frame);
        let mut report = Report::default();
        let mut draw = |row, pair: &mut [u16; PAIR]| {
            let start = now();
            second.start(Job { frame, row: row + 1, strip: strip.take()? })?;
            let (first, other) = pair.split_first_chunk_mut()?;
            stage.draw::<M>(row, first);
            let job = second.finish()?;
            other.copy_from_slice(job.strip.pixels());
            *strip = Some(job.strip);
            report.cycles += now().wrapping_sub(start) & CYCLES;
            report.add(pair);
            Some(())
        };
        open(panel, WIDTH as u16, rows.len() as u16)?;
        let [mut drawn, mut free] = pairs.take()?;
        draw(rows.start, drawn)?;
        for row in (rows.start + 2..rows.end).step_by(2) {
            let mut done = None;
            let sent = panel.send(drawn, || done = draw(row, free))?;
            done?;
            (drawn, free) = (free, sent);
        }
        *pairs = Some([panel.send(drawn, || {})?, free]);
        Some(report)
    }

    /// Sends a black square in place of a picture.
    pub(crate) fn blacken(&mut self, panel: &mut impl Panel) -> Option<Report> {
        let mut report = Report::default();
        open(panel, WIDTH as u16, WIDTH as u16)?;
        let [mut pair, other] = self.pairs.take()?;
        pair.fill(0);
        for _ in 0..WIDTH / 2 {
            report.add(pair);
            pair = panel.send(pair, || {})?;
        }
        self.pairs = Some([pair, other]);
        Some(report)
    }
}

/// The largest number of cycles between two looks at the counter: two rows take fewer.
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
