//! Draws the example scenes as PNGs into a folder:
//! `cargo run --release --example scenes -- folder [seconds]`.

use luminaire_render::{Renderer, scenes::Example};
use std::{error::Error, fs::File, io::BufWriter, path::Path};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().unwrap_or_else(|| ".".into());
    let seconds: f32 = arguments.next().map_or(Ok(0.0), |seconds| seconds.parse())?;
    for &example in Example::ALL {
        let setup = example.setup()?;
        let (width, height) = example.size();
        let mut renderer = Renderer::<f32>::new(width, height)?;
        renderer.draw_geometry(&setup.scene, &setup.camera_at(seconds));
        renderer.set_display(setup.display);
        let fixtures = setup.fixtures_at(seconds)?;
        renderer.draw_shadows(&setup.scene, &fixtures)?;
        renderer.draw_light(&fixtures)?;
        let path = Path::new(&folder).join(example.name()).with_extension("png");
        let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), width as u32, height as u32);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        encoder.write_header()?.write_image_data(renderer.encode())?;
    }
    Ok(())
}
