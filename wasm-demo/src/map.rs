//! A map that is drawn over the picture: of the number of evaluated lights, of the time that they
//! took, or of the re-lit tiles.

use crate::{
    false_colour::{Palette, Scale},
    refusal::{Refusal, choose},
};
use luminaire_render::LANES;

/// Opacity of a map of lights, out of 255. At this value the eye can match its colours to the
/// legend, and the picture is still visible. A map of tiles needs less, because it has only two
/// colours.
const COVER: u8 = 215;
const TILE_COVER: u8 = 120;

/// Positions on the palette of the colours for re-lit and for kept tiles.
const RELIT: (f32, f32) = (0.7, 0.0);

/// Share of the blocks that the scale of costs holds. A block may take much longer because the
/// system has interrupted its worker.
const HELD: f64 = 0.99;

/// Lighting passes for a map of costs, which shows their medians: the system may interrupt a worker in
/// any block, but seldom twice in the same.
pub(crate) const PASSES: usize = 3;

/// Returns the counts of blocks for their medians of times in nanoseconds: at most 65,535. Each takes up
/// what rounding has left of those before, so that the counts of a picture have the sum of its times.
pub(crate) fn counts_of_nanoseconds(times: &[[f64; PASSES]]) -> Vec<u16> {
    let mut rest = 0.0;
    let count = |&[a, b, c]: &[f64; PASSES]| {
        let time = rest + a.min(b).max(a.max(b).min(c));
        let count = time.round() as u16;
        rest = (time - f64::from(count)).clamp(-0.5, 0.5);
        count
    };
    times.iter().map(count).collect()
}

/// Subject of a map.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Subject {
    /// No map.
    Nothing,
    /// How many lights were evaluated at each pixel.
    Lights,
    /// What lighting took at each pixel, haze included.
    Cost,
    /// Which tiles were lit again.
    Tiles,
}

/// A map of a picture in false colours.
#[derive(Clone, Debug)]
pub(crate) struct Map {
    pub(crate) palette: Palette,
    /// Largest number of lights at a pixel since the scale was reset. The scale never shrinks;
    /// otherwise the meaning of a colour would change from picture to picture.
    most: u16,
    /// What the last colour of the last map stands for: lights, or nanoseconds.
    pub(crate) end: f64,
    /// The sum of the last map of costs over all pixels, in milliseconds.
    pub(crate) total: f64,
    pixels: Vec<u8>,
}

impl Subject {
    pub(crate) const ALL: [Self; 4] = [Self::Nothing, Self::Lights, Self::Cost, Self::Tiles];

    /// The subject of this name.
    pub(crate) fn named(name: &str) -> Result<Self, Refusal> {
        choose("subject of the map", name, &Self::ALL, Self::name)
    }

    /// The name that [`Self::named`] accepts.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::Lights => "lights",
            Self::Cost => "cost",
            Self::Tiles => "tiles",
        }
    }
}

impl Map {
    /// Returns no map.
    pub(crate) fn new() -> Self {
        Self { palette: Palette::new(), most: 0, end: 1.0, total: 0.0, pixels: Vec::new() }
    }

    /// Resets the scale, for a picture of another scene.
    pub(crate) fn begin(&mut self) {
        self.most = 0;
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
        let scale = match subject {
            Subject::Cost => scale_of_costs(counts),
            _ => self.scale(),
        };
        self.end = scale.end;
        let [relit, kept] = self.tile_colours();
        self.pixels.clear();
        self.total = 0.0;
        for row in counts.chunks(width.div_ceil(LANES)) {
            for (column, &count) in row.iter().enumerate() {
                let ([red, green, blue], cover) = match subject {
                    Subject::Nothing => return None,
                    Subject::Lights | Subject::Cost => (self.palette.colour(scale, count.into()), COVER),
                    Subject::Tiles => (if count > 0 { relit } else { kept }, TILE_COVER),
                };
                let pixels = LANES.min(width - column * LANES);
                self.total += f64::from(count) * pixels as f64 / 1e6;
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

/// The scale of costs: 1, 2 or 5 times a power of ten.
fn scale_of_costs(counts: &[u16]) -> Scale {
    let held = ((HELD * counts.len() as f64) as usize + 1).min(counts.len());
    let holds = |&end: &u32| counts.iter().filter(|&&count| u32::from(count) <= end).count() >= held;
    let mut ends = (0..5).flat_map(|power| [1, 2, 5].map(|factor| factor * 10_u32.pow(power)));
    Scale::to(ends.find(holds).unwrap_or(100_000).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_block_has_the_colour_of_its_count() {
        let mut map = Map::new();
        // Two rows of two blocks, the second of which has 8 pixels.
        let (counts, width) = ([0, 5, 64, 2], LANES + 8);
        assert!(map.draw(Subject::Nothing, &counts, width).is_none());
        let [relit, kept] = map.tile_colours();
        for subject in [Subject::Lights, Subject::Tiles] {
            let pixels = map.draw(subject, &counts, width).unwrap().to_vec();
            assert_eq!(pixels.len(), 4 * 2 * width);
            for (place, pixel) in pixels.chunks(4).enumerate() {
                let count = counts[2 * (place / width) + place % width / LANES];
                let ([red, green, blue], cover) = match subject {
                    Subject::Tiles => (if count > 0 { relit } else { kept }, TILE_COVER),
                    _ => (map.palette.colour(Scale::to(64.0), count.into()), COVER),
                };
                assert_eq!(*pixel, [red, green, blue, cover], "{subject:?}: {count} lights");
            }
        }
    }

    #[test]
    fn the_scale_does_not_shrink_until_the_map_is_begun_anew() {
        let mut map = Map::new();
        let end = |map: &mut Map, count| {
            map.draw(Subject::Lights, &[count], LANES);
            map.end
        };
        assert_eq!([0, 7, 2].map(|count| end(&mut map, count)), [1.0, 7.0, 7.0]);
        map.begin();
        assert_eq!(end(&mut map, 0), 1.0);
        assert!(Subject::named("heat").unwrap_err().to_string().contains("cost or tiles"));
    }

    #[test]
    fn the_map_of_costs_adds_up() {
        // Two rows of two blocks, the second of which has 8 pixels. Three blocks were interrupted, the last twice.
        let times = [[3.4, 1.0, 90.0], [1e9, 6.4, 2.0], [1.2, 1.3, 0.0], [99_999.0, 1e9, 2.0]];
        let counts = counts_of_nanoseconds(&times);
        assert_eq!(counts, [3, 7, 1, u16::MAX]);
        let mut map = Map::new();
        let pixels = map.draw(Subject::Cost, &counts, LANES + 8).unwrap();
        assert_eq!(pixels.len(), 4 * 2 * (LANES + 8));
        let nanoseconds = 3.0 * LANES as f64 + 7.0 * 8.0 + LANES as f64 + 65_535.0 * 8.0;
        assert!((map.total - nanoseconds / 1e6).abs() < 1e-12);
        let many: Vec<_> = [3; 200].into_iter().chain([u16::MAX]).collect();
        map.draw(Subject::Cost, &many, LANES);
        assert_eq!(map.end, 5.0);
        map.draw(Subject::Lights, &[0, 3], LANES);
        assert_eq!(map.end, 3.0);
    }
}
