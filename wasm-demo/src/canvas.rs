//! The canvas on the page.

use crate::refusal::Refusal;
use wasm_bindgen::{Clamped, JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, ImageData};

/// A canvas that shows square pictures of one size.
#[derive(Debug)]
pub(crate) struct Canvas {
    context: CanvasRenderingContext2d,
    size: u32,
}

impl Canvas {
    /// A picture and its errors for each of two sides, each a square of at most `largest` pixels a side.
    pub(crate) fn pairs(
        elements: [[&HtmlCanvasElement; 2]; 2],
        size: u32,
        largest: u32,
    ) -> Result<[[Self; 2]; 2], Refusal> {
        if !(1..=largest).contains(&size) {
            return Err(Refusal::outside("size", size as f32, [1.0, largest as f32], "pixels"));
        }
        let canvas = |element| Self::new(element, size);
        let [[one, one_errors], [other, other_errors]] = elements;
        Ok([[canvas(one)?, canvas(one_errors)?], [canvas(other)?, canvas(other_errors)?]])
    }

    /// Sets the canvas to the size of the picture, so that each pixel of the picture is one pixel
    /// of the canvas.
    fn new(element: &HtmlCanvasElement, size: u32) -> Result<Self, Refusal> {
        element.set_width(size);
        element.set_height(size);
        let context = element.get_context("2d").map_err(refused)?;
        let lack =
            "the canvas: the browser gives no 2d context: allow canvas for this page, or use another browser";
        let context = context.and_then(|context| context.dyn_into().ok());
        Ok(Self { context: context.ok_or_else(|| Refusal(lack.to_owned()))?, size })
    }

    /// Shows a picture of RGBA bytes. The `ImageData` is a view of the module's memory and is
    /// dropped before this function returns, so that the pixels are copied only once, into the
    /// canvas.
    pub(crate) fn show(&self, pixels: &[u8]) -> Result<(), Refusal> {
        ImageData::new_with_u8_clamped_array_and_sh(Clamped(pixels), self.size, self.size)
            .and_then(|image| self.context.put_image_data(&image, 0.0, 0.0))
            .map_err(refused)
    }
}

fn refused(reason: JsValue) -> Refusal {
    Refusal(format!("the canvas: {reason:?}"))
}
