//! Bitwise comparison of two pictures: one lit with only the needed effects, the other with all
//! effects.

use crate::{clock::Clock, format::Draw, refusal::Refusal};
use luminaire::projector::Fixture;
use luminaire_render::{Camera, Scene};
use wasm_bindgen::prelude::*;

/// Result of lighting a picture twice: with only the needed effects, and with all effects.
#[wasm_bindgen]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Equality {
    /// The pixels of each picture.
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
    /// Draws both pictures, of this width in pixels, and compares them.
    pub(crate) fn new(
        mut renderer: Box<dyn Draw>,
        width: usize,
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
        let (everything, pairs) = (bits(&mut *renderer, width), renderer.account().evaluated);
        let (lighting_ms, lit) = clock.time(|| renderer.draw_light(fixtures));
        lit?;
        let (called_for, account) = (bits(&mut *renderer, width), renderer.account());
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
fn bits(renderer: &mut dyn Draw, width: usize) -> Vec<([u32; 3], [u8; 4])> {
    renderer.encode();
    let codes = renderer.pixels().as_chunks().0.iter().enumerate();
    let pixel = |(place, &codes): (usize, &[u8; 4])| {
        let light = renderer.linear(place % width, place / width).unwrap_or_default();
        ([light.red, light.green, light.blue].map(f32::to_bits), codes)
    };
    codes.map(pixel).collect()
}
