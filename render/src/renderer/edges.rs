//! Anti-aliasing: mixes the pixels beside visible edges.

use crate::{
    raster::silhouette::Mark,
    renderer::display::{CHANNELS, Display, Encoder},
};
use alloc::{boxed::Box, vec::Vec};
use luminaire::{Rgb, display::decode_srgb};

/// Anti-aliasing of a picture: the pixels beside visible edges, and how much of each pixel lies
/// beyond the edge.
///
/// A pixel at an edge has the light of one point: of the surface on one side of the edge. [`mix`]
/// gives it the mean light of both sides. The light of the other side is that of the neighbouring
/// pixel. The shares are exact areas of the pixel, for one straight edge and rounded to 1/256. The
/// light is mixed as displayed: linear, clipped at full scale.
///
/// Edges are silhouettes, borders of open meshes, and creases. Lines where two meshes penetrate
/// each other, and edges of shadows and gobos, are not found. Surfaces that are narrower than a
/// pixel are found only at pixels whose centre they cover.
///
/// A [`Renderer`] of a whole picture, with [`set_antialiased`], does everything by itself. If several
/// renderers share a picture, mix it after their [`Stripes`](crate::Stripes) are put together. The
/// picture is bit-identical to that of one renderer.
///
/// ```
/// use luminaire_render::{Display, Edges, Renderer, Stripes, scenes::stage};
/// let (mut edges, mut marks, mut picture) = (Edges::new(), Vec::new(), vec![0; 4 * 320 * 180]);
/// for share in 0..2 {
///     let stripes = Stripes::new(share, 2)?;
///     let mut renderer = Renderer::<f32>::of_stripes(320, 180, stripes)?;
///     renderer.set_antialiased(true);
///     renderer.draw_geometry(&stage::scene()?, &stage::camera());
///     renderer.draw_light(&stage::lights()?)?;
///     marks.extend(renderer.edge_marks());
///     for (row, pixels) in stripes.rows(180).flatten().zip(renderer.encode().chunks(4 * 320)) {
///         picture[4 * 320 * row..][..4 * 320].copy_from_slice(pixels);
///     }
/// }
/// edges.take(marks);
/// edges.mix(Display::default(), 320, &mut picture);
/// assert!(edges.count() > 1000);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// [`Renderer`]: crate::Renderer
/// [`set_antialiased`]: crate::Renderer::set_antialiased
/// [`mix`]: Self::mix
#[derive(Clone, Debug)]
pub struct Edges {
    marks: Vec<Mark>,
    pixels: Vec<Pixel>,
    /// Each mixed pixel and its codes before mixing.
    replaced: Vec<(usize, [u8; CHANNELS])>,
    /// The linear light of each sRGB code.
    light: Box<[f32; 256]>,
}

/// The shares that a pixel gives to its neighbours on one axis, in 256ths.
#[derive(Clone, Copy, Debug)]
struct Pixel {
    index: u32,
    /// Whether the neighbours are those above and below, not those to the left and right.
    is_column: bool,
    shares: [u16; 2],
}

impl Edges {
    /// Creates an empty list of edges, which mixes nothing.
    pub fn new() -> Self {
        let light = core::array::from_fn(|code| decode_srgb(code as u8));
        Self { marks: Vec::new(), pixels: Vec::new(), replaced: Vec::new(), light: light.into() }
    }

    /// Takes the edges of a picture: the [`edge_marks`](crate::Renderer::edge_marks) of a renderer,
    /// or of all renderers that draw stripes of the picture, in any order.
    pub fn take(&mut self, marks: impl IntoIterator<Item = u64>) {
        self.marks.clear();
        self.marks.extend(marks.into_iter().map(Mark));
        self.marks.sort_unstable();
        self.pixels.clear();
        self.pixels.extend(self.marks.chunk_by(|a, b| a.pixel() == b.pixel()).map(Pixel::new));
    }

    /// Returns the number of pixels that are mixed.
    pub fn count(&self) -> usize {
        self.pixels.len()
    }

    /// Mixes the pixels beside edges. `pixels` is a picture of this width as
    /// [`encode`](crate::Renderer::encode) returns it for this display. Marks of pixels outside the
    /// picture have no effect.
    ///
    /// A second call mixes again, so call [`restore`](Self::restore) before it, unless all pixels
    /// are new.
    pub fn mix(&mut self, display: Display, width: usize, pixels: &mut [u8]) {
        self.mix_by(&Encoder::new(display), width, pixels);
    }

    pub(crate) fn mix_by(&mut self, encoder: &Encoder, width: usize, pixels: &mut [u8]) {
        self.replaced.clear();
        // All pixels are mixed before the first one is replaced.
        for pixel in &self.pixels {
            let Some(codes) = self.mixed(pixel, encoder, width, pixels) else { continue };
            self.replaced.push((pixel.index as usize, codes));
        }
        self.swap(pixels);
    }

    /// Sets the pixels that the last [`mix`](Self::mix) changed to their codes before it.
    pub fn restore(&mut self, pixels: &mut [u8]) {
        self.swap(pixels);
        self.replaced.clear();
    }

    fn swap(&mut self, pixels: &mut [u8]) {
        for (index, codes) in &mut self.replaced {
            if let Some(pixel) = pixels.get_mut(*index * CHANNELS..).and_then(<[u8]>::first_chunk_mut) {
                core::mem::swap(pixel, codes);
            }
        }
    }

    fn mixed(&self, pixel: &Pixel, encoder: &Encoder, width: usize, pixels: &[u8]) -> Option<[u8; CHANNELS]> {
        let index = pixel.index as usize;
        let codes = |index: usize| pixels.get(index.checked_mul(CHANNELS)?..)?.first_chunk::<CHANNELS>();
        let step = if pixel.is_column { width } else { 1 };
        let [before, after] = pixel.shares;
        let own = 256_u16.saturating_sub(before + after);
        let parts = [
            (codes(index)?, own),
            (index.checked_sub(step).and_then(codes).unwrap_or(&[0; CHANNELS]), before),
            (index.checked_add(step).and_then(codes).unwrap_or(&[0; CHANNELS]), after),
        ];
        let mean = |channel: usize| {
            let light = |(codes, share): &(&[u8; 4], u16)| {
                self.light[usize::from(codes[channel])] * f32::from(*share)
            };
            parts.iter().map(light).sum::<f32>() / 256.0
        };
        let Rgb { red, green, blue } = encoder.code(Rgb::new(mean(0), mean(1), mean(2)));
        Some([red, green, blue, u8::MAX])
    }
}

impl Default for Edges {
    fn default() -> Self {
        Self::new()
    }
}

impl Pixel {
    /// Merges the marks of one pixel, which are sorted.
    ///
    /// Two edges in the same direction are parts of one outline that bends: the larger share
    /// counts. Two edges in opposite directions bound a narrow surface: both shares count. Of the
    /// two axes, the one with the larger share counts.
    fn new(marks: &[Mark]) -> Self {
        let mut shares = [0_u16; 4];
        for mark in marks {
            let share = &mut shares[mark.direction()];
            *share = (*share).max(mark.share());
        }
        let [left, right, up, down] = shares;
        let is_column = up + down > left + right;
        let shares = if is_column { [up, down] } else { [left, right] };
        Self { index: marks[0].pixel(), is_column, shares }
    }
}
