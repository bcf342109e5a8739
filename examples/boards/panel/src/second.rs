//! Rows that a second core draws.

use core::fmt;
use core::marker::PhantomData;

use luminaire_stage::{Markers, Stage};

/// A row of pixels, and the stage that draws it.
pub trait Strip: Send {
    /// Draws a row of a frame.
    fn draw(&mut self, frame: u32, row: i32);
    /// The pixels of the row that was drawn last.
    fn pixels(&self) -> &[u16];
}

#[derive(Debug)]
pub(crate) struct Drawn<const WIDTH: usize, M> {
    stage: Stage<WIDTH>,
    /// The frame to which the stage is turned.
    frame: u32,
    pixels: [u16; WIDTH],
    markers: PhantomData<fn() -> M>,
}

impl<const WIDTH: usize, M> Default for Drawn<WIDTH, M> {
    fn default() -> Self {
        Self { stage: Stage::default(), frame: 0, pixels: [0; WIDTH], markers: PhantomData }
    }
}

impl<const WIDTH: usize, M: Markers> Strip for Drawn<WIDTH, M> {
    fn draw(&mut self, frame: u32, row: i32) {
        if frame != self.frame {
            self.frame = frame;
            self.stage.turn_to(frame);
        }
        self.stage.draw::<M>(row, &mut self.pixels);
    }

    fn pixels(&self) -> &[u16] {
        &self.pixels
    }
}

/// A row to be drawn.
pub struct Job {
    pub(crate) frame: u32,
    pub(crate) row: i32,
    pub(crate) strip: &'static mut dyn Strip,
}

/// Without the stage of the strip: the firmware would hold what writes every number of it, 35 kB.
impl fmt::Debug for Job {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Job").field("frame", &self.frame).field("row", &self.row).finish_non_exhaustive()
    }
}

impl Job {
    /// Draws the row.
    pub fn run(&mut self) {
        self.strip.draw(self.frame, self.row);
    }
}

/// A second core, which draws one row at a time.
pub trait Second {
    /// Lets it start with a row. `None` if it has not finished another.
    fn start(&mut self, job: Job) -> Option<()>;
    /// Waits until the row is drawn. `None` if it has none.
    fn finish(&mut self) -> Option<Job>;
}
