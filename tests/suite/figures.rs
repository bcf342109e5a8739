//! The figures of the documentation are those that the code draws. The code's own tests check what
//! the figures show.

#[path = "../../examples/figures/gallery/mod.rs"]
#[allow(dead_code, reason = "the example uses the rest")]
mod gallery;

use gallery::{Content, Figure, Picture};
use std::{error::Error, fs, path::Path};

const REMEDY: &str = "cargo run --release -p suite --example figures";

fn kept(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures").join(name);
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}; {REMEDY}", path.display()))
}

fn decoded(file: &[u8]) -> Result<Picture, png::DecodingError> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info()?;
    let (width, height) = reader.info().size();
    let mut codes = vec![0; 3 * width as usize * height as usize];
    reader.next_frame(&mut codes)?;
    Ok(Picture { width: width as usize, height: height as usize, codes })
}

/// Pictures are compared pixel by pixel, because another version of the PNG library may compress
/// differently. Drawings are compared as text. The folder has exactly the figures that are drawn,
/// and none of an earlier name.
#[test]
fn the_documented_figures_are_up_to_date() -> Result<(), Box<dyn Error>> {
    let mut drawn = Vec::new();
    for Figure { name, content } in gallery::figures()? {
        let file = kept(name);
        let is_current = match content {
            Content::Picture(picture) => decoded(&file)? == picture,
            Content::Drawing(svg) => file == svg.as_bytes(),
        };
        assert!(is_current, "{name} is out of date: {REMEDY}");
        drawn.push(name.to_owned());
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures");
    let files = fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut files = files.collect::<Result<Vec<_>, std::io::Error>>()?;
    drawn.sort();
    files.sort();
    assert_eq!(files, drawn);
    Ok(())
}
