//! Bitwise comparison of two pictures: one lit with only the needed effects, the other with all
//! effects.

use crate::{clock::Clock, format::Draw, refusal::Refusal};
use luminaire::projector::Fixture;
use luminaire_render::{Camera, Scene, Stripes};
use wasm_bindgen::prelude::*;

/// Result of lighting stripes of a picture twice: with only the needed effects, and with all
/// effects.
#[wasm_bindgen]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Equality {
    /// The compared pixels.
    pub pixels: usize,
    /// The pixels whose light or displayed code differs in any bit.
    pub differing: usize,
    /// The (light, pixel) pairs that were evaluated with the needed effects only.
    pub evaluated: f64,
    /// The number of all pairs, each of which was evaluated for the other picture.
    pub pairs: f64,
    /// Time of the lighting with the needed effects, in milliseconds.
    #[wasm_bindgen(js_name = lightingMs)]
    pub lighting_ms: f64,
    /// Time of the lighting with all effects, in milliseconds.
    #[wasm_bindgen(js_name = everythingMs)]
    pub everything_ms: f64,
}

impl Equality {
    /// Draws these stripes of both pictures, of this width and height in pixels, and compares them.
    pub(crate) fn new(
        mut renderer: Box<dyn Draw>,
        size: (u32, u32),
        stripes: Stripes,
        clock: &Clock,
        (scene, camera, fixtures): (&Scene, &Camera, &[Fixture]),
    ) -> Result<Self, Refusal> {
        renderer.draw_geometry(scene, camera);
        renderer.draw_shadows(scene, fixtures)?;
        // The first draw touches its memory for the first time, which costs extra, so it is not
        // timed.
        renderer.draw_light(fixtures)?;
        let (everything_ms, lit) = clock.time(|| renderer.draw_everything(fixtures));
        lit?;
        let (everything, pairs) = (bits(&mut *renderer, stripes, size), renderer.account().evaluated);
        let (lighting_ms, lit) = clock.time(|| renderer.draw_light(fixtures));
        lit?;
        let (called_for, account) = (bits(&mut *renderer, stripes, size), renderer.account());
        let differing = called_for.iter().zip(&everything).filter(|(one, other)| one != other).count();
        Ok(Self {
            pixels: everything.len(),
            differing,
            evaluated: account.evaluated as f64,
            pairs: pairs as f64,
            lighting_ms,
            everything_ms,
        })
    }
}

/// Returns the bits of each pixel: its light and its displayed code.
fn bits(renderer: &mut dyn Draw, stripes: Stripes, (width, height): (u32, u32)) -> Vec<([u32; 3], [u8; 4])> {
    renderer.encode();
    let mut bits = Vec::new();
    let mut codes = renderer.pixels().as_chunks().0.iter();
    for y in stripes.rows(height as usize).flatten() {
        for x in 0..width as usize {
            let light = renderer.linear(x, y).unwrap_or_default();
            let codes = codes.next().copied().unwrap_or_default();
            bits.push(([light.red, light.green, light.blue].map(f32::to_bits), codes));
        }
    }
    bits
}
