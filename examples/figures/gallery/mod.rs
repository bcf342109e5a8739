//! The figures, and the files that they are kept in.
//!
//! The pictures are the renderer's geometry lit by the kernel in f32, or by Warn's model over the
//! same geometry. The pictures are bit-identical on every machine, so that tests can compare them
//! exactly.

mod curves;
mod gradient;
mod mach_bands;
mod picture;
mod preview;
mod region;
mod scene;
mod screens;
mod svg;
mod warn;

use std::error::Error;

pub(crate) use picture::Picture;

/// A figure and the name of its file.
pub(crate) struct Figure {
    pub(crate) name: &'static str,
    pub(crate) content: Content,
}

/// The content of a figure.
pub(crate) enum Content {
    /// Pixels, kept as a PNG.
    Picture(Picture),
    /// A drawing, kept as an SVG.
    Drawing(String),
}

impl Figure {
    /// The figure's file content.
    pub(crate) fn file(self) -> Result<Vec<u8>, png::EncodingError> {
        match self.content {
            Content::Picture(picture) => picture.png(),
            Content::Drawing(svg) => Ok(svg.into_bytes()),
        }
    }
}

/// Every figure, in the order of the page, the demo's picture for links, and a figure of NUMERICS.md.
pub(crate) fn figures() -> Result<Vec<Figure>, Box<dyn Error>> {
    let [warn, soft, hard] = scene::pictures()?;
    let bands = mach_bands::MachBands::draw()?;
    let curves = bands.curves();
    let [banded, dithered, error] = gradient::pictures()?;
    let picture = |name, picture| Figure { name, content: Content::Picture(picture) };
    let drawing = |name, svg| Figure { name, content: Content::Drawing(svg) };
    Ok(vec![
        picture("warn.png", warn),
        picture("soft.png", soft),
        picture("hard.png", hard),
        drawing("intensity.svg", curves::svg()?),
        picture("mach-bands.png", bands.picture),
        drawing("mach-bands.svg", curves),
        picture("gradient-banded.png", banded),
        picture("gradient-dithered.png", dithered),
        picture("gradient-error.png", error),
        picture("screens.png", screens::picture()?),
        picture("preview.png", preview::picture()?),
        drawing("feasible-region.svg", region::svg()),
    ])
}
