//! Draws the stage as a PNG: `cargo run --release --example still -- still.png`.

use luminaire_render::{Renderer, scenes::stage};
use std::{error::Error, fs::File, io::BufWriter};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "still.png".into());
    let mut renderer = Renderer::<f32>::new(960, 540)?;
    renderer.draw_geometry(&stage::scene()?, &stage::camera());
    renderer.draw_light(&stage::lights()?)?;
    let (width, height) = renderer.size();
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.write_header()?.write_image_data(renderer.encode())?;
    Ok(())
}
