//! The examples are unchanged: every pixel of their pictures has the codes stored in
//! `tests/pictures/`.
//!
//! `LUMINAIRE_BLESS=1 cargo test -p luminaire-render --test renderer pictures` stores the current pictures.

use luminaire::Fx16;
use luminaire_render::{Format, Renderer, scenes::Example};
use std::{
    env,
    error::Error,
    fs::{self, File},
    io::BufWriter,
    path::{Path, PathBuf},
};

/// Codes of red, green and blue, rows from top to bottom.
#[derive(PartialEq)]
struct Picture {
    size: (usize, usize),
    codes: Vec<u8>,
}

impl Picture {
    /// The picture of an example at second 0, at half the size that it is composed for. That for a
    /// microcontroller is drawn at its full size, with 16 bits.
    fn of(example: Example) -> Result<Self, Box<dyn Error>> {
        let (width, height) = example.size();
        match example {
            Example::Pocket => Self::drawn::<Fx16>(example, (width, height)),
            _ => Self::drawn::<f32>(example, (width / 2, height / 2)),
        }
    }

    fn drawn<S: Format>(example: Example, size: (usize, usize)) -> Result<Self, Box<dyn Error>> {
        let setup = example.setup()?;
        let mut renderer = Renderer::<S>::new(size.0, size.1)?;
        renderer.draw_geometry(&setup.scene, &setup.camera);
        renderer.set_display(setup.display);
        let fixtures = setup.fixtures_at(0.0)?;
        renderer.draw_shadows(&setup.scene, &fixtures)?;
        renderer.draw_light(&fixtures)?;
        let codes = renderer.encode().chunks_exact(4).flat_map(|pixel| &pixel[..3]).copied().collect();
        Ok(Self { size, codes })
    }

    fn kept(path: &Path) -> Result<Self, Box<dyn Error>> {
        let mut reader = png::Decoder::new(std::io::BufReader::new(File::open(path)?)).read_info()?;
        let (width, height) = reader.info().size();
        let size = (width as usize, height as usize);
        let mut codes = vec![0; 3 * size.0 * size.1];
        reader.next_frame(&mut codes)?;
        Ok(Self { size, codes })
    }

    fn keep(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        let file = BufWriter::new(File::create(path)?);
        let mut encoder = png::Encoder::new(file, self.size.0 as u32, self.size.1 as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        encoder.set_compression(png::Compression::High);
        encoder.write_header()?.write_image_data(&self.codes)?;
        Ok(())
    }

    /// Describes how many codes differ, and the largest difference.
    fn difference(&self, other: &Self) -> String {
        if self.size != other.size {
            return format!("a size of {:?} instead of {:?}", self.size, other.size);
        }
        let by = self.codes.iter().zip(&other.codes).map(|(a, b)| a.abs_diff(*b)).filter(|by| *by > 0);
        format!(
            "{} of {} codes differ, by up to {}",
            by.clone().count(),
            self.codes.len(),
            by.max().unwrap_or(0)
        )
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/pictures")
}

fn file(example: Example) -> String {
    format!("{}.png", example.name())
}

#[test]
fn the_examples_look_as_they_did() -> Result<(), Box<dyn Error>> {
    let mut wrong = Vec::new();
    for &example in Example::ALL {
        let (picture, path) = (Picture::of(example)?, folder().join(file(example)));
        if env::var_os("LUMINAIRE_BLESS").is_some() {
            picture.keep(&path)?;
        }
        match Picture::kept(&path) {
            Ok(kept) if kept == picture => {}
            Ok(kept) => wrong.push(format!("{}: {}", path.display(), picture.difference(&kept))),
            Err(error) => wrong.push(format!("{}: {error}", path.display())),
        }
    }
    assert!(
        wrong.is_empty(),
        "{}\nIf that is meant: LUMINAIRE_BLESS=1 keeps the new ones.",
        wrong.join("\n")
    );
    Ok(())
}

/// The folder contains no picture of an example that was removed or renamed.
#[test]
fn no_picture_is_left_over() -> Result<(), Box<dyn Error>> {
    let mut drawn: Vec<_> = Example::ALL.iter().copied().map(file).collect();
    let files = fs::read_dir(folder())?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut files = files.collect::<Result<Vec<_>, std::io::Error>>()?;
    drawn.sort();
    files.sort();
    assert_eq!(files, drawn);
    Ok(())
}
