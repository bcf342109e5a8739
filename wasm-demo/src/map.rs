//! A map that is drawn over the picture: of the number of evaluated lights, or of the re-lit tiles.

use crate::{
    false_colour::{Palette, Scale},
    refusal::Refusal,
};
use luminaire_render::LANES;

/// Opacity of a map of lights, out of 255. At this value the eye can match its colours to the
/// legend, and the picture is still visible. A map of tiles needs less, because it has only two
/// colours.
const COVER: u8 = 215;
const TILE_COVER: u8 = 120;

/// Positions on the palette of the colours for re-lit and for kept tiles.
const RELIT: (f32, f32) = (0.7, 0.0);

/// Subject of a map.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Subject {
    /// No map.
    Nothing,
    /// How many lights were evaluated at each pixel.
    Lights,
    /// Which tiles were lit again.
    Tiles,
}

/// A map of a picture in false colours.
#[derive(Clone, Debug)]
pub(crate) struct Map {
    palette: Palette,
    /// Largest number of lights at a pixel since the scale was reset. The scale never shrinks;
    /// otherwise the meaning of a colour would change from picture to picture.
    most: u16,
    pixels: Vec<u8>,
}

impl Subject {
    /// The subject of this name.
    pub(crate) fn named(name: &str) -> Result<Self, Refusal> {
        match name {
            "nothing" => Ok(Self::Nothing),
            "lights" => Ok(Self::Lights),
            "tiles" => Ok(Self::Tiles),
            _ => Err(Refusal::name("subject of the map", name, "nothing, lights or tiles")),
        }
    }

    /// The name that [`Self::named`] accepts.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::Lights => "lights",
            Self::Tiles => "tiles",
        }
    }
}

impl Map {
    /// Returns no map.
    pub(crate) fn new() -> Self {
        Self { palette: Palette::new(), most: 0, pixels: Vec::new() }
    }

    /// Resets the scale, for a picture of another scene.
    pub(crate) fn begin(&mut self) {
        self.most = 0;
    }

    /// The colours of the map's scale: red, green, blue in sRGB.
    pub(crate) fn colours(&self) -> &[[u8; 3]] {
        self.palette.colours()
    }

    /// Returns how many lights the last colour stands for.
    pub(crate) fn end(&self) -> f64 {
        self.scale().end()
    }

    /// The colours of re-lit and of kept tiles.
    pub(crate) fn tile_colours(&self) -> [[u8; 3]; 2] {
        let of_all = Scale::to(1.0);
        [RELIT.0, RELIT.1].map(|place| self.palette.colour(of_all, place))
    }

    /// Draws the map of a picture of this width in pixels: RGBA, sRGB. `counts` are those of each
    /// block of pixels, row by row. Returns `None` if there is no map.
    pub(crate) fn draw(&mut self, subject: Subject, counts: &[u16], width: usize) -> Option<&[u8]> {
        let most = counts.iter().copied().fold(self.most, u16::max);
        self.most = if subject == Subject::Lights { most } else { self.most };
        let ([relit, kept], scale) = (self.tile_colours(), self.scale());
        self.pixels.clear();
        for row in counts.chunks(width.div_ceil(LANES)) {
            for (column, &count) in row.iter().enumerate() {
                let ([red, green, blue], cover) = match subject {
                    Subject::Nothing => return None,
                    Subject::Lights => (self.palette.colour(scale, count.into()), COVER),
                    Subject::Tiles => (if count > 0 { relit } else { kept }, TILE_COVER),
                };
                let pixels = LANES.min(width - column * LANES);
                self.pixels.extend([red, green, blue, cover].repeat(pixels));
            }
        }
        (subject != Subject::Nothing).then_some(&self.pixels)
    }

    /// The scale ends at one light or more, so that pixels without a light have the first colour.
    fn scale(&self) -> Scale {
        Scale::to(self.most.max(1).into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::{Draw, Format};
    use luminaire_render::{Stripes, scenes::Example};

    /// The last block of a row is not a whole one.
    const SIZE: (usize, usize) = (90, 54);

    fn renderer() -> Box<dyn Draw> {
        Format::F32.renderer((SIZE.0 as u32, SIZE.1 as u32), Stripes::ALL).unwrap()
    }

    fn counts(count: impl Fn(usize, usize) -> u16) -> Vec<u16> {
        (0..SIZE.1)
            .flat_map(|y| (0..SIZE.0).step_by(LANES).map(|x| count(x, y)).collect::<Vec<_>>())
            .collect()
    }

    #[test]
    fn the_map_has_the_colour_of_each_count() {
        let setup = Example::Grid.setup().unwrap();
        let mut renderer = renderer();
        renderer.draw_geometry(&setup.scene, &setup.camera);
        renderer.draw_light(&setup.fixtures_at(0.0).unwrap()).unwrap();
        let mut map = Map::new();
        let lights = counts(|x, y| renderer.lights_evaluated(x, y).unwrap());
        assert!(map.draw(Subject::Nothing, &lights, SIZE.0).is_none());
        let pixels = map.draw(Subject::Lights, &lights, SIZE.0).unwrap().to_vec();
        assert_eq!(pixels.len(), 4 * SIZE.0 * SIZE.1);
        let mut counts = Vec::new();
        for (place, pixel) in pixels.chunks(4).enumerate() {
            let count = renderer.lights_evaluated(place % SIZE.0, place / SIZE.0).unwrap();
            let colour = map.palette.colour(map.scale(), count.into());
            assert_eq!(*pixel, [colour[0], colour[1], colour[2], COVER], "{count} lights");
            counts.push(count);
        }
        let (least, most) = (counts.iter().min().unwrap(), counts.iter().max().unwrap());
        assert!(least < most && f64::from(*most) <= map.end(), "from {least} to {most} lights");
    }

    #[test]
    fn the_map_of_tiles_tells_what_was_lit_again() {
        let setup = Example::Grid.setup().unwrap();
        let mut renderer = renderer();
        let mut map = Map::new();
        let [relit, kept] = map.tile_colours();
        renderer.draw_geometry(&setup.scene, &setup.camera);
        let mut share = |seconds| {
            assert!(renderer.draw_light(&setup.fixtures_at(seconds).unwrap()).unwrap());
            let relit_blocks = counts(|x, y| renderer.is_relit(x, y).unwrap().into());
            let pixels = map.draw(Subject::Tiles, &relit_blocks, SIZE.0).unwrap();
            let count = |colour: [u8; 3]| pixels.chunks(4).filter(|pixel| pixel[..3] == colour).count();
            assert_eq!(count(relit) + count(kept), SIZE.0 * SIZE.1);
            count(relit) as f64 / (SIZE.0 * SIZE.1) as f64
        };
        assert_eq!(share(0.0), 1.0);
        let some = share(0.3);
        assert!(some > 0.0 && some < 0.5, "a share of {some} is lit again for two lights of 64");
    }

    #[test]
    fn the_scale_does_not_shrink_until_the_map_is_begun_anew() {
        let mut map = Map::new();
        assert_eq!(map.end(), 1.0);
        map.most = 7;
        assert_eq!(map.end(), 7.0);
        map.begin();
        assert_eq!(map.end(), 1.0);
        assert!(Subject::named("heat").unwrap_err().to_string().contains("lights or tiles"));
    }
}
