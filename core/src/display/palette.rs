//! Palettes: the nearest of a few colours, by a table.

use core::array;

use super::{
    dither::threshold,
    pixel::{Pixel as _, Rgb444},
    srgb::encode_srgb,
};
use crate::{
    color::Rgb,
    error::{Error, Expected, Parameter},
    number::Scalar,
};

/// A palette of 1 to 256 sRGB colours, with the nearest of them for each of 4,096 cells.
///
/// A cell has the colours of one [`Rgb444`] pixel, 17 codes wide in each channel, and the index of
/// the colour nearest to the middle of the cell. So a pixel costs three encodings of four bits and a
/// look-up.
///
/// The distance is "redmean" (T. Riemersma, *Colour metric*, CompuPhase): the root of
/// `(2 + r/256) R^2 + 4 G^2 + (2 + (255 - r)/256) B^2` with the differences `R`, `G`, `B` of sRGB
/// codes and the mean `r` of the two reds. It takes integers only; black and white are three times 255 apart.
/// Of equally near colours, the first counts.
///
/// The colour of a cell need not be the nearest to every colour in the cell. If the nearest is `d`
/// away, the colour of the cell is at most `1.009 d + 52` away (derived: twice the 25.5 from the
/// middle to a corner of a cell, and the change of the weights with `r`; 49.7 found).
///
/// ```
/// use luminaire::{Rgb, display::Palette};
/// const COLORS: [Rgb<u8>; 3] = [Rgb::new(0, 0, 0), Rgb::new(255, 255, 255), Rgb::new(255, 0, 0)];
/// let palette = Palette::new(&COLORS)?;
/// let index = palette.nearest(Rgb::new(0.9, 0.1, 0.0_f32));
/// assert_eq!((index, palette.color(index)), (2, COLORS[2]));
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Palette<'a> {
    colors: &'a [Rgb<u8>],
    /// The index of the colour of each cell.
    cells: [u8; CELLS],
    /// The range of the dither in sRGB codes.
    spacing: u8,
}

/// The number of cells, of a byte each.
const CELLS: usize = 4_096;

impl<'a> Palette<'a> {
    /// Computes the cells, by 4,096 distances for each colour, and the spacing: the mean distance of
    /// a colour from the nearest other one, by the channel that differs most.
    ///
    /// # Errors
    /// No colour, or more than 256.
    pub fn new(colors: &'a [Rgb<u8>]) -> Result<Self, Error> {
        let accepted = Expected::WholeBetween(1, 256);
        if !(1..=256).contains(&colors.len()) {
            return Err(Error { parameter: Parameter::ColorCount, value: colors.len() as f32, accepted });
        }
        let cells = array::from_fn(|cell| {
            let middle = Rgb444(cell as u16).to_codes();
            let nearest = (0..=u8::MAX).zip(colors).min_by_key(|(_, color)| distance(middle, **color));
            nearest.map_or(0, |(index, _)| index)
        });
        let gaps = colors.iter().filter_map(|a| colors.iter().filter(|b| a != *b).map(|b| gap(*a, *b)).min());
        let (sum, count) = gaps.fold((0, 0), |(sum, count), gap| (sum + u32::from(gap), count + 1));
        Ok(Self::from_cells(colors, cells, (sum / count.max(1)) as u8))
    }

    /// Creates a palette from its [cells](Self::cells), as [`new`](Self::new) computed them in a build
    /// script, and a [spacing](Self::spacing): 0 switches the dither off.
    pub const fn from_cells(colors: &'a [Rgb<u8>], cells: [u8; CELLS], spacing: u8) -> Self {
        Self { colors, cells, spacing }
    }

    /// Returns the cells: the index of the colour for each [`Rgb444`] pixel.
    pub const fn cells(&self) -> &[u8; CELLS] {
        &self.cells
    }

    /// Returns the range of the dither in sRGB codes.
    pub const fn spacing(&self) -> u8 {
        self.spacing
    }

    /// Returns the colour of an index; black for an index past the last colour.
    #[inline]
    pub fn color(&self, index: u8) -> Rgb<u8> {
        self.colors.get(usize::from(index)).copied().unwrap_or_default()
    }

    /// Returns the index of the palette's colour for a linear colour clipped to `[0, 1]`.
    #[inline]
    pub fn nearest<S: Scalar>(&self, color: Rgb<S>) -> u8 {
        self.index(Rgb444::nearest(color))
    }

    /// Returns the index of the palette's colour for a linear colour at `(x, y)`, with ordered
    /// dither.
    ///
    /// The dither moves the sRGB codes of all channels by up to half of the [spacing](Self::spacing)
    /// up or down before the look-up. It hides bands, but does not keep the light, because it is even
    /// in codes and not in light, and because no palette is evenly spaced in all directions: with
    /// black and white alone, the code 128, a light of 0.216, turns half of the pixels white, a light
    /// of 0.5. The grey and RGB pixels keep the light.
    #[inline]
    pub fn dithered<S: Scalar>(&self, color: Rgb<S>, x: u32, y: u32) -> u8 {
        let offset = (64 - i32::from(threshold(x, y))) * i32::from(self.spacing) / 128;
        let moved = color.map(|channel| (i32::from(encode_srgb(channel)) + offset).clamp(0, 255) as u8);
        self.index(Rgb444::from_codes(moved))
    }

    #[inline]
    fn index(&self, cell: Rgb444) -> u8 {
        // The remainder changes no index. It shows the compiler that the index is in bounds.
        self.cells[usize::from(cell.0) % CELLS]
    }
}

/// Returns the squared distance of two colours, in units of 1/512.
fn distance(a: Rgb<u8>, b: Rgb<u8>) -> u32 {
    let reds = u32::from(a.red) + u32::from(b.red);
    let square = a.zip(b, |a, b| u32::from(a.abs_diff(b)).pow(2));
    (1_024 + reds) * square.red + 2_048 * square.green + (1_534 - reds) * square.blue
}

/// Returns the largest difference of a channel.
fn gap(a: Rgb<u8>, b: Rgb<u8>) -> u8 {
    let Rgb { red, green, blue } = a.zip(b, u8::abs_diff);
    red.max(green).max(blue)
}
