//! What a display receives, and what is printed.

use std::cell::Cell;
use std::fmt;
use std::sync::mpsc;
use std::thread;

use luminaire_stage::{CHECKSUM, checksum};

use super::{Alone, Job, Panel, Rows, Second, Words, show};

/// A display that keeps each window with its pixels.
#[derive(Default)]
struct Display {
    command: u16,
    /// The columns and the rows of the window.
    window: [Vec<u16>; 2],
    pictures: Vec<([Vec<u16>; 2], Vec<u16>)>,
}

impl Panel for Display {
    fn write(&mut self, is_data: bool, words: &[u16]) -> Option<()> {
        match (is_data, self.command) {
            (false, _) => self.command = words[0],
            (true, 0x2a) => self.window[0] = words.to_vec(), // CASET
            (true, 0x2b) => self.window[1] = words.to_vec(), // RASET
            (true, 0x2c) if words.is_empty() => self.pictures.push((self.window.clone(), Vec::new())), // RAMWR
            (true, other) => panic!("command {other:#x} with {words:?}"),
        }
        Some(())
    }

    fn send<const COUNT: usize>(
        &mut self,
        pixels: Words<COUNT>,
        meanwhile: impl FnOnce(),
    ) -> Option<Words<COUNT>> {
        meanwhile();
        self.pictures.last_mut()?.1.extend(&*pixels);
        Some(pixels)
    }
}

/// Keeps lines, and refuses more than four.
#[derive(Default)]
struct Lines(String);

impl fmt::Write for Lines {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 += text;
        if self.0.ends_with('\n') && self.0.lines().count() == 4 { Err(fmt::Error) } else { Ok(()) }
    }
}

/// A second thread.
struct Thread(mpsc::Sender<Job>, mpsc::Receiver<Job>);

impl Thread {
    fn start() -> Self {
        let ((jobs, orders), (finished, done)) = (mpsc::channel::<Job>(), mpsc::channel());
        thread::spawn(move || {
            for mut job in orders {
                job.run();
                if finished.send(job).is_err() {
                    break;
                }
            }
        });
        Self(jobs, done)
    }
}

impl Second for Thread {
    fn start(&mut self, job: Job) -> Option<()> {
        self.0.send(job).ok()
    }

    fn finish(&mut self) -> Option<Job> {
        self.1.recv().ok()
    }
}

/// What a display receives and what is printed, until four lines are printed. Each two rows seem to take 7 cycles.
fn shown(second: &mut impl Second) -> (Display, Lines) {
    let (mut display, mut lines) = (Display::default(), Lines::default());
    // A counter of 24 bits wraps.
    let time = Cell::new(0xff_fff9_u32);
    let now = || time.replace(time.get() + 7) & 0xff_ffff;
    let rows = Box::leak(Box::<Rows<()>>::default());
    assert!(show(&mut display, second, rows, now, &mut lines).is_none());
    (display, lines)
}

#[test]
fn a_second_thread_draws_the_same_pixels() {
    let [(alone, one), (together, two)] = [shown(&mut Alone::default()), shown(&mut Thread::start())];
    assert!(alone.pictures == together.pictures, "the pixels differ");
    assert_eq!(one.0, two.0);
}

#[test]
fn pictures_fill_their_windows_and_are_reported() {
    let (display, lines) = shown(&mut Alone::default());
    let windows: Vec<_> = display.pictures.iter().map(|(window, _)| window.concat()).collect();
    assert_eq!(windows, [[0, 239, 0, 239], [0, 239, 0, 239], [40, 199, 60, 179], [40, 199, 60, 179]]);
    let names = ["still", "black", "frame 0", "frame 1"];
    for (((window, pixels), line), name) in display.pictures.iter().zip(lines.0.lines()).zip(names) {
        let rows = u32::from(window[1][1] - window[1][0]) + 1;
        assert_eq!(pixels.len() as u32, rows * (u32::from(window[0][1] - window[0][0]) + 1));
        let cycles = if name == "black" { 0 } else { 7 * rows / 2 };
        let (count, sum) = (pixels.len(), checksum(CHECKSUM, pixels));
        assert_eq!(line, format!("{name}: {count} pixels, checksum {sum:08x}, {cycles} cycles"));
    }
    assert!(display.pictures[1].1.iter().all(|&pixel| pixel == 0), "the display is not black");
    assert_ne!(display.pictures[2].1, display.pictures[3].1, "the light moves");
}
