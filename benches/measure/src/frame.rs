//! A picture that a microcontroller lights pixel by pixel, and what a pixel costs.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};

use luminaire_stage::STAGES;

use crate::counted::Firmware;
use crate::program::Program;
use crate::record::{Group, Line, Record};
use crate::target::Board;
use tools::progress::Progress;
use tools::project;

/// The PNG of the picture, below the project's folder.
const PNG: &str = "docs/frame.png";

/// Width and height of a pixel, in pixels of the PNG. The PNG is magnified because a small display
/// is looked at from near.
const SCALE: usize = 4;

/// What the program prints: how many pixels the light reaches, and the picture in RGB565.
struct Output {
    counts: Group,
    width: usize,
    pixels: Vec<u16>,
}

impl Output {
    fn parse(text: &str) -> Result<Self> {
        let mut output = Self { counts: Group::default(), width: 0, pixels: Vec::new() };
        for Line { name, value, unit } in Line::all(text)? {
            match name.as_str() {
                "row" => {
                    ensure!(value.len() % 4 == 0, "row {value}: expected four digits a pixel");
                    for digits in value.as_bytes().chunks(4) {
                        output.pixels.push(u16::from_str_radix(str::from_utf8(digits)?, 16)?);
                    }
                }
                name => {
                    let count: u64 = value.parse().with_context(|| format!("no number: {value}"))?;
                    output.counts.add(name, &unit, count);
                }
            }
        }
        output.width = output.counts.number("width", "pixels").context("the picture has no width")? as usize;
        let height = output.counts.number("height", "pixels").context("the picture has no height")? as usize;
        ensure!(output.pixels.len() == output.width * height, "{} pixels", output.pixels.len());
        Ok(output)
    }

    /// The picture as a PNG, magnified.
    fn png(&self) -> Result<Vec<u8>> {
        let (width, height) = (self.width * SCALE, self.pixels.len() / self.width * SCALE);
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, width as u32, height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x / SCALE, y / SCALE)));
        let data: Vec<u8> = places.flat_map(|(x, y)| codes(self.pixels[y * self.width + x])).collect();
        writer.write_image_data(&data)?;
        writer.finish()?;
        Ok(bytes)
    }
}

/// Expands RGB565 to the nearest codes of 8 bits per channel.
fn codes(pixel: u16) -> [u8; 3] {
    let widened = |code: u16, last: u16| ((code * 255 + last / 2) / last) as u8;
    [widened(pixel >> 11, 31), widened(pixel >> 5 & 63, 63), widened(pixel & 31, 31)]
}

/// Draws on a board. The picture must be the host's, and the program may not contain soft-float functions.
/// Adds the costs of the stages to the board's group, writes the PNG or compares it, and returns what the
/// light reaches.
pub(crate) fn draw(
    board: &'static Board,
    group: &mut Group,
    check: bool,
    progress: &Progress,
) -> Result<Group> {
    let mut run = Firmware::new("frame", &[]).run(board, progress)?;
    let output = Output::parse(&run.text)?;
    let program = Program::read(&run.file)?;
    program.has_no_float()?;
    let cycles = run.cycles(board, progress)?;
    let stages: Vec<_> = STAGES.split(' ').collect();
    for (number, stage) in stages.iter().enumerate() {
        let name = format!("frame.{stage}");
        let of_stage = run.regions.iter().skip(number).step_by(stages.len());
        group.add(&name, "instructions", of_stage.flat_map(|region| region.values()).sum::<u64>());
        if let Some(cycles) = &cycles {
            let of_stage = cycles.iter().skip(number).step_by(stages.len());
            group.add(&name, "cycles", of_stage.sum::<u64>());
        }
    }
    // Rounded up: panic messages embed the path of the checkout, so the exact size differs between
    // checkouts.
    group.add("frame", "kibibytes", program.bytes().div_ceil(1024));
    let (file, png) = (project::root().join(PNG), output.png()?);
    if check {
        ensure!(fs::read(file).context(PNG)? == png, "{PNG} is not the picture of the host");
    } else {
        fs::write(file, png).context(PNG)?;
    }
    Ok(output.counts)
}

/// Fails if another program draws the picture on a Cortex-M0 in clearly another number of instructions
/// than on record, and both are by the same compiler. The compiler inlines differently in a program
/// that also draws another picture.
pub(crate) fn agrees(program: &Path, instructions: u64) -> Result<()> {
    let recorded = Record::load()?.group("cortex-m0");
    let stages = recorded.figures.keys().filter(|name| name.starts_with("frame."));
    let expected: f64 = stages.filter_map(|name| recorded.number(name, "instructions")).sum();
    let is_same = (instructions as f64 - expected).abs() * 50.0 <= expected;
    let is_comparable = is_of_record(program)?;
    ensure!(is_same || !is_comparable, "expected {expected} instructions, found {instructions}");
    Ok(())
}

/// Whether a program for a Cortex-M0 is by the compiler of the record.
pub(crate) fn is_of_record(program: &Path) -> Result<bool> {
    let recorded = Record::load()?.group("cortex-m0");
    Ok(recorded.about.get("compiler") == Some(&Program::read(program)?.compiler))
}
