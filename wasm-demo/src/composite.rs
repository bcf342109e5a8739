//! The JavaScript class that puts the shares of a picture together.

use luminaire_render::{Display, Edges, Stripes};
use wasm_bindgen::{Clamped, prelude::*};
use web_sys::{CanvasRenderingContext2d, ImageData, js_sys::Uint8ClampedArray};

/// A whole picture from the stripes of several painters, with the pixels beside edges mixed. For
/// each picture call, in this order: `begin`, `put` for each share that has changed, and `mix`.
#[wasm_bindgen]
#[derive(Default, Debug)]
pub struct Composite {
    size: (usize, usize),
    /// RGBA, sRGB, eight bits, row by row.
    pixels: Vec<u8>,
    /// The marks of each share's edges.
    marks: Vec<Vec<u64>>,
    edges: Edges,
}

#[wasm_bindgen]
impl Composite {
    /// An empty picture.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Begins a picture of this size from this number of shares. Shares of the same size that are
    /// not put stay as they were.
    pub fn begin(&mut self, width: usize, height: usize, shares: usize) {
        if self.size == (width, height) && self.marks.len() == shares {
            return self.edges.restore(&mut self.pixels);
        }
        (self.size, self.pixels) = ((width, height), vec![0; 4 * width * height]);
        (self.marks, self.edges) = (vec![Vec::new(); shares], Edges::new());
    }

    /// Puts the stripes of a share at their places.
    pub fn put(&mut self, share: usize, stripes: &Uint8ClampedArray, marks: Vec<u64>) {
        let (width, height) = self.size;
        let Ok(places) = Stripes::new(share, self.marks.len()) else { return };
        self.marks[share] = marks;
        let mut start = 0;
        for rows in places.rows(height) {
            let place = &mut self.pixels[4 * width * rows.start..4 * width * rows.end];
            let end = start + place.len() as u32;
            // Less only if the share is of a picture of another size.
            if end > stripes.length() {
                return;
            }
            stripes.subarray(start, end).copy_to(place);
            start = end;
        }
    }

    /// Mixes the pixels beside edges.
    pub fn mix(&mut self) {
        self.edges.take(self.marks.iter().flatten().copied());
        self.edges.mix(Display::default(), self.size.0, &mut self.pixels);
    }

    /// Shows the picture in a canvas of its size. The `ImageData` is a view of the module's memory,
    /// so that the pixels are copied only once.
    pub fn show(&self, context: &CanvasRenderingContext2d) -> Result<(), JsValue> {
        let (width, height) = (self.size.0 as u32, self.size.1 as u32);
        let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(&self.pixels), width, height)?;
        context.put_image_data(&image, 0.0, 0.0)
    }

    /// A copy of the picture: RGBA, sRGB, eight bits.
    pub fn pixels(&self) -> Clamped<Vec<u8>> {
        Clamped(self.pixels.clone())
    }
}
