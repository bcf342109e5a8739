//! The picture that other sites show beside a link to the demo.

use std::fs::File;
use std::path::Path;

use anyhow::{Context, Result};
use luminaire_render::{Renderer, scenes::Example};

/// The file in the demo's folder.
pub const FILE: &str = "preview.png";

/// Width and height in pixels, as most sites show link previews. The page states the same size.
pub const SIZE: (u32, u32) = (1200, 630);

/// The time within the scene, in seconds, at which the beams are spread over the stage.
const SECOND: f32 = 3.0;

/// Draws the scene with which the demo opens. Returns RGBA bytes.
fn draw() -> Result<Vec<u8>> {
    let setup = Example::Show.setup()?;
    let fixtures = setup.fixtures_at(SECOND)?;
    let mut renderer = Renderer::<f32>::new(SIZE.0 as usize, SIZE.1 as usize)?;
    renderer.draw_geometry(&setup.scene, &setup.camera);
    renderer.draw_shadows(&setup.scene, &fixtures)?;
    renderer.draw_light(&fixtures)?;
    Ok(renderer.encode().to_vec())
}

/// Draws the picture into `folder`.
pub(super) fn write(folder: &Path) -> Result<()> {
    let pixels: Vec<u8> = draw()?.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    let file = folder.join(FILE);
    let created = File::create(&file).with_context(|| format!("cannot write {}", file.display()))?;
    let mut encoder = png::Encoder::new(created, SIZE.0, SIZE.1);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_is_the_renderers_picture() {
        let folder = tempfile::tempdir().unwrap();
        write(folder.path()).unwrap();
        let file = std::io::BufReader::new(File::open(folder.path().join(FILE)).unwrap());
        let mut reader = png::Decoder::new(file).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), SIZE);
        let drawn = draw().unwrap();
        assert!(drawn.chunks_exact(4).zip(pixels.chunks_exact(3)).all(|(drawn, read)| drawn[..3] == *read));
        let bright = pixels.iter().filter(|code| **code > 128).count();
        assert!(bright > pixels.len() / 50, "the picture has only {bright} bright channels");
    }
}
