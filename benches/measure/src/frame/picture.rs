//! The picture, as the program prints it and as a PNG.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use anyhow::{Context, Result, ensure};

/// Width and height of a pixel, in pixels of the PNG. The PNG is magnified because a small display
/// is looked at from near.
const SCALE: u32 = 4;

/// A picture in RGB565.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Picture {
    width: u32,
    pixels: Vec<u16>,
}

impl Picture {
    /// Reads rows of hexadecimal digits, four for each pixel.
    pub(super) fn of_rows(width: u32, height: u32, rows: &[String]) -> Result<Self> {
        ensure!(rows.len() == height as usize, "{} rows, not {height}", rows.len());
        let mut pixels = Vec::new();
        for row in rows {
            ensure!(row.len() == 4 * width as usize && row.is_ascii(), "not {width} pixels: {row}");
            for start in (0..row.len()).step_by(4) {
                let pixel = u16::from_str_radix(&row[start..start + 4], 16);
                pixels.push(pixel.with_context(|| format!("not pixels: {row}"))?);
            }
        }
        Ok(Self { width, pixels })
    }

    /// The rows of the picture in hexadecimal digits.
    pub(super) fn rows(&self) -> impl Iterator<Item = String> {
        let rows = self.pixels.chunks(self.width.max(1) as usize);
        rows.map(|row| row.iter().map(|pixel| format!("{pixel:04x}")).collect())
    }

    /// The number of rows.
    pub(super) fn height(&self) -> u32 {
        self.pixels.len() as u32 / self.width
    }

    /// The number of pixels.
    pub(super) fn pixels(&self) -> usize {
        self.pixels.len()
    }

    /// Column and row of the first pixel that differs from another picture's.
    pub(super) fn first_difference(&self, other: &Self) -> Option<(usize, usize)> {
        let index = self.pixels.iter().zip(&other.pixels).position(|(pixel, other)| pixel != other)?;
        Some((index % self.width as usize, index / self.width as usize))
    }

    /// The picture as a PNG, magnified.
    pub(super) fn png(&self) -> Result<Vec<u8>> {
        let (width, height) = (self.width * SCALE, self.height() * SCALE);
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x / SCALE, y / SCALE)));
        let data: Vec<u8> =
            places.flat_map(|(x, y)| codes(self.pixels[(y * self.width + x) as usize])).collect();
        writer.write_image_data(&data)?;
        writer.finish()?;
        Ok(bytes)
    }

    /// Reads a PNG that [`png`](Self::png) has written.
    pub(super) fn read(file: &Path) -> Result<Self> {
        let file = File::open(file).with_context(|| format!("cannot open {}", file.display()))?;
        Self::decode(BufReader::new(file))
    }

    fn decode(png: impl std::io::BufRead + std::io::Seek) -> Result<Self> {
        let mut reader = png::Decoder::new(png).read_info()?;
        let mut data = vec![0; reader.output_buffer_size().context("a picture of no size")?];
        let info = reader.next_frame(&mut data)?;
        ensure!(info.color_type == png::ColorType::Rgb && info.bit_depth == png::BitDepth::Eight, "not RGB");
        let line = info.width as usize * 3 * SCALE as usize;
        let pixels = data.chunks_exact(line).flat_map(|lines| {
            let pixels = lines[..info.width as usize * 3].chunks_exact(3 * SCALE as usize);
            pixels.map(|pixel| packed([pixel[0], pixel[1], pixel[2]]))
        });
        Ok(Self { width: info.width / SCALE, pixels: pixels.collect() })
    }
}

/// Expands RGB565 to the nearest codes of 8 bits per channel.
fn codes(pixel: u16) -> [u8; 3] {
    let widened = |code: u16, last: u16| ((code * 255 + last / 2) / last) as u8;
    [widened(pixel >> 11, 31), widened(pixel >> 5 & 63, 63), widened(pixel & 31, 31)]
}

/// Returns the RGB565 pixel nearest to codes of 8 bits.
fn packed([red, green, blue]: [u8; 3]) -> u16 {
    let nearest = |code: u8, last: u16| (u16::from(code) * last + 127) / 255;
    nearest(red, 31) << 11 | nearest(green, 63) << 5 | nearest(blue, 31)
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    #[test]
    fn every_pixel_comes_back_from_a_png() {
        let picture = Picture { width: 256, pixels: (0..=u16::MAX).collect() };
        let read = Picture::decode(Cursor::new(picture.png().unwrap())).unwrap();
        assert_eq!((read.height(), read.first_difference(&picture)), (256, None));
        assert!(read == picture);
    }

    #[test]
    fn the_first_pixel_that_differs_is_found() {
        let rows = |text: &str| Picture::of_rows(2, 2, &["00001111".to_owned(), text.to_owned()]).unwrap();
        assert_eq!(rows("2222ffff").first_difference(&rows("2222fffe")), Some((1, 1)));
    }
}
