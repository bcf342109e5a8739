//! The check of the console's program: every picture that its screen has, against the host's pixels.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use luminaire_sprite::{Lights, Sprite, WORDS, cells, measures::SIDE, points};
use tools::progress::Progress;
use tools::{board, command, project};

use super::lines::PAGE;
use crate::frame;

/// The refreshes of the screen that are run, and that at which A is pressed: five seconds of each mode.
const REFRESHES: u32 = 600;
const PRESS: u32 = 300;
/// Processor cycles a second, and to a refresh.
const CLOCK: f64 = 16_777_216.0;
const CYCLES: f64 = 280_896.0;
/// The refresh of a screenshot, in the first mode, and the side of a pixel in it.
const SHOWN: u32 = 93;
const SCALE: usize = 3;

/// The two modes, as the program's mailbox has them.
const MODES: [&str; 2] = ["by cells", "point by point"];

/// A picture that the screen has had.
#[derive(Debug, Clone, PartialEq)]
struct Picture {
    /// The refresh after which it was there.
    refresh: u32,
    /// Its number, from 1 on.
    number: u32,
    /// The refreshes since the start at which its lights are.
    time: u32,
    /// The mode's place in [`MODES`].
    mode: usize,
    /// The cycles of drawing.
    cycles: u32,
    pixels: Vec<u16>,
}

impl Picture {
    /// Reads a line such as `picture 5 1 0 0 313444 7fff...`.
    fn parse(line: &str) -> Result<Self> {
        let parsed = || {
            let mut words = line.strip_prefix("picture ")?.split(' ');
            let mut number = || words.next()?.parse::<u32>().ok();
            let [refresh, count, time, mode, cycles] =
                [number()?, number()?, number()?, number()?, number()?];
            let pixels = words.next()?.as_bytes().as_chunks::<4>().0.iter();
            let pixels = pixels.map(|digits| u16::from_str_radix(str::from_utf8(digits).ok()?, 16).ok());
            let pixels: Vec<_> = pixels.collect::<Option<_>>()?;
            let is_whole = pixels.len() == SIDE * SIDE && (mode as usize) < MODES.len();
            is_whole.then_some(Self { refresh, number: count, time, mode: mode as usize, cycles, pixels })
        };
        let start = line.get(..60).unwrap_or(line);
        parsed().with_context(|| {
            format!("`{start}`: expected `picture`, five numbers and {SIDE} x {SIDE} pixels")
        })
    }

    /// The number of pixels that differ from the host's.
    fn differ(&self) -> usize {
        self.pixels
            .iter()
            .zip(drawn(self.time, self.mode))
            .filter(|(pixel, expected)| *pixel != expected)
            .count()
    }
}

/// The host's picture at a time, in a mode.
fn drawn(time: u32, mode: usize) -> [u16; SIDE * SIDE] {
    let mut pixels = [0; SIDE * SIDE];
    let (sprite, lights) = (Sprite::new(), Lights::at(time));
    match mode {
        0 => cells::draw::<4>(&sprite, &lights, &mut pixels, cells::run),
        _ => points::draw(&sprite, &lights, &mut pixels),
    }
    pixels
}

/// Runs a cartridge in mGBA for ten seconds, in the middle of which A is pressed. Returns a line for each mode, and one
/// for all pictures. An error if a pixel differs from the host's, or if the page lacks the last line and the program is by
/// the compiler of the record.
pub(super) fn check(
    program: &Path,
    cartridge: &Path,
    screenshot: Option<&Path>,
    progress: &Progress,
) -> Result<Vec<String>> {
    let mut run = Command::new(board::console(progress)?);
    run.arg(cartridge).args([REFRESHES, PRESS].map(|count| count.to_string()));
    let screen = project::target().join("gba.ppm");
    if screenshot.is_some() {
        run.arg(&screen).arg(SHOWN.to_string());
    }
    let text = command::answer(&mut run)?;
    let pictures = text.lines().map(Picture::parse).collect::<Result<Vec<_>>>()?;
    let lines = remarks(&pictures)?;
    if let Some(file) = screenshot {
        fs::write(file, png(&screen)?).with_context(|| format!("cannot write {}", file.display()))?;
    }
    if frame::is_of_record(program)? {
        let page = fs::read_to_string(project::root().join(PAGE)).context(PAGE)?;
        let missing: Vec<_> = lines.iter().map(String::as_str).filter(|line| !page.contains(line)).collect();
        ensure!(missing.is_empty(), "{PAGE} lacks these lines:\n{}", missing.join("\n"));
    }
    Ok(lines)
}

/// Compares the pictures of a run with the host's. Returns a line for each mode, and one for all pictures.
fn remarks(pictures: &[Picture]) -> Result<Vec<String>> {
    for (picture, number) in pictures.iter().zip(1..) {
        let (found, mode) = (picture.number, MODES[picture.mode]);
        ensure!(found == number, "picture {found}: expected {number}, as the screen shows each");
        let differ = picture.differ();
        ensure!(differ == 0, "picture {number}, {mode}: {} pixels, {differ} differ", SIDE * SIDE);
    }
    ensure!(pictures.is_sorted_by_key(|picture| picture.mode), "expected A to change the mode once");
    let (mut lines, mut last) =
        (Vec::new(), format!("gba: {} pixels, 0 differ", pictures.len() * SIDE * SIDE));
    for (mode, name) in MODES.iter().enumerate() {
        let of_mode: Vec<_> = pictures.iter().filter(|picture| picture.mode == mode).collect();
        let [first, .., end] = of_mode[..] else { anyhow::bail!("{name}: expected pictures") };
        let each =
            of_mode.iter().map(|picture| f64::from(picture.cycles)).sum::<f64>() / of_mode.len() as f64;
        let rate = (of_mode.len() - 1) as f64 / f64::from(end.refresh - first.refresh) * CLOCK / CYCLES;
        // Of the opaque ones: the others take none.
        let pixel = each / WORDS.len() as f64;
        lines.push(format!("{name}: {pixel:.1} cycles a pixel, {rate:.1} pictures a second"));
        last += &format!(", {pixel:.1} cycles a pixel {name}");
    }
    lines.push(last);
    Ok(lines)
}

/// Magnifies a PPM, as the runner writes it, to a PNG.
fn png(file: &PathBuf) -> Result<Vec<u8>> {
    let content = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    let (width, height) = (240, 160);
    let start = content.len().checked_sub(3 * width * height).context("the screen is not whole")?;
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, (SCALE * width) as u32, (SCALE * height) as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    let places = (0..SCALE * height).flat_map(|y| (0..SCALE * width).map(move |x| (x / SCALE, y / SCALE)));
    let data: Vec<u8> =
        places.flat_map(|(x, y)| content[start + 3 * (width * y + x)..][..3].to_vec()).collect();
    writer.write_image_data(&data)?;
    writer.finish()?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The host's pictures as the runner prints them, with modes and refreshes.
    fn pictures() -> Vec<Picture> {
        let picture = |(number, mode): (u32, usize)| Picture {
            refresh: 2 * number,
            number,
            time: number,
            mode,
            cycles: 263_100,
            pixels: drawn(number, mode).to_vec(),
        };
        [(1, 0), (2, 0), (3, 1), (4, 1)].map(picture).to_vec()
    }

    #[test]
    fn a_line_is_of_one_whole_picture() {
        let line = format!("picture 5 1 0 1 313444 {}", "7fff".repeat(SIDE * SIDE));
        let picture = Picture::parse(&line).unwrap();
        assert_eq!((picture.refresh, picture.number, picture.mode, picture.cycles), (5, 1, 1, 313_444));
        assert!(picture.pixels.iter().all(|pixel| *pixel == 0x7fff));
        for line in [&line[1..], &line[..line.len() - 4], &line.replace(" 1 31", " 2 31"), "picture 5 1"] {
            assert!(Picture::parse(line).unwrap_err().to_string().contains("expected `picture`"), "{line}");
        }
    }

    #[test]
    fn a_picture_that_differs_or_is_missing_is_refused() {
        let all = pictures();
        let lines = remarks(&all).unwrap();
        assert_eq!(lines[0], "by cells: 100.0 cycles a pixel, 29.9 pictures a second");
        let mut other = all.clone();
        other[1].pixels[SIDE * 32 + 32] ^= 1;
        let error = remarks(&other).unwrap_err().to_string();
        assert_eq!(error, "picture 2, by cells: 4096 pixels, 1 differ");
        let mut swapped = all.clone();
        swapped[3].mode = 0;
        for other in [&all[..2], &all[2..], &all[1..], &swapped, &[]] {
            assert!(remarks(other).is_err());
        }
    }
}
