//! Pictures: linear light averaged over each pixel, then encoded.

use luminaire::{Rgb, Vec3, display::encode_srgb};
use luminaire_render::Renderer;

/// Samples per pixel in each direction. They smooth the edges of solids; edges of light would not
/// need them.
const SAMPLES: usize = 3;

/// A picture in sRGB: three bytes per pixel, rows from top to bottom.
#[derive(Debug, PartialEq)]
pub(crate) struct Picture {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) codes: Vec<u8>,
}

/// Creates a renderer for pictures of this size in pixels.
pub(crate) fn renderer(width: usize, height: usize) -> Result<Renderer<f32>, luminaire_render::SizeError> {
    Renderer::new(width * SAMPLES, height * SAMPLES)
}

/// Returns a function that computes the linear light of a sample: ambient light plus white light,
/// whose irradiance `arriving` computes from point and normal.
pub(crate) fn lit(
    renderer: &Renderer<f32>,
    ambient: Rgb<f32>,
    arriving: impl Fn(Vec3<f32>, Vec3<f32>) -> f32,
) -> impl Fn(usize, usize) -> Rgb<f32> {
    move |x, y| {
        renderer.surface(x, y).map_or_else(Rgb::default, |(point, normal, material)| {
            let light = arriving(point, normal);
            ambient.map(|ambient| ambient + light).zip(material.albedo(), |light, albedo| light * albedo)
        })
    }
}

impl Picture {
    /// Averages the linear light of the samples of each pixel, and encodes it. `linear` returns the
    /// light of a sample by column and row.
    pub(crate) fn develop(renderer: &Renderer<f32>, linear: impl Fn(usize, usize) -> Rgb<f32>) -> Self {
        let (width, height) = renderer.size();
        let (width, height) = (width / SAMPLES, height / SAMPLES);
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let codes = pixels.flat_map(|(x, y)| {
            let samples =
                (0..SAMPLES * SAMPLES).map(|i| (x * SAMPLES + i % SAMPLES, y * SAMPLES + i / SAMPLES));
            let sum =
                samples.fold(Rgb::default(), |sum: Rgb<f32>, (x, y)| sum.zip(linear(x, y), |a, b| a + b));
            let Rgb { red, green, blue } = sum.map(|sum| encode_srgb(sum / (SAMPLES * SAMPLES) as f32));
            [red, green, blue]
        });
        Self { width, height, codes: codes.collect() }
    }

    /// Pictures of the same height side by side, with a white gap between them.
    pub(crate) fn beside(pictures: &[&Self], gap: usize) -> Self {
        let height = pictures[0].height;
        let width = pictures.iter().map(|picture| picture.width + gap).sum::<usize>() - gap;
        let mut codes = Vec::with_capacity(3 * width * height);
        for y in 0..height {
            for (i, picture) in pictures.iter().enumerate() {
                codes.extend(std::iter::repeat_n(u8::MAX, if i > 0 { 3 * gap } else { 0 }));
                codes.extend(&picture.codes[3 * y * picture.width..][..3 * picture.width]);
            }
        }
        Self { width, height, codes }
    }

    /// The picture as a PNG.
    pub(crate) fn png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        encoder.set_compression(png::Compression::High);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.codes)?;
        writer.finish()?;
        Ok(file)
    }
}
