//! The JavaScript class that draws a share of each picture.
//!
//! Each worker has an instance of the module with one painter. The painters of a picture have the
//! same job and different stripes, and pass shadow maps to one another.

use crate::{
    clock::{self, Clock},
    equality::Equality,
    format::{Draw, Format},
    job::{self, Task},
    map::{self, PASSES, Subject},
    panic,
    refusal::Refusal,
    scene_state,
};
use luminaire::projector::Fixture;
use luminaire_render::{Display, LANES, Stripes, scenes::Example};
use std::fmt;
use wasm_bindgen::{Clamped, prelude::*};
use web_sys::js_sys::{Uint8ClampedArray, Uint32Array};

/// Draws every n-th stripe of pictures. For each picture call, in this order: `take`,
/// `drawShadows`, `drawGeometry`, `takeShadowMap` for each map of another painter, and `drawLight`.
#[wasm_bindgen]
pub struct Painter {
    stripes: Stripes,
    clock: Clock,
    task: Option<Task>,
    fixtures: Vec<Fixture>,
    renderer: Option<Renderer>,
    /// The renderer of the size before: pictures alternate between motion and rest.
    other: Option<Renderer>,
    /// What a pixel of each block has taken in nanoseconds, in each pass for the map of costs.
    costs: Vec<[f64; PASSES]>,
    times: Times,
}

/// The time of each pass in milliseconds, by the browser's clock.
#[wasm_bindgen]
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Times {
    /// Nothing if the geometry was kept.
    pub geometry: Option<f64>,
    /// Nothing if the painter has drawn no shadow map.
    pub shadows: Option<f64>,
    /// The lighting pass.
    pub lighting: f64,
    /// The encoding for the display.
    pub encode: f64,
}

/// A renderer of pictures of one size in one format.
struct Renderer {
    draw: Box<dyn Draw>,
    kind: (Format, (u32, u32)),
    /// What the last picture shows besides its scene, camera and lights; `None` if it was not
    /// drawn to the end.
    shown: Option<(Example, bool, Display)>,
}

#[wasm_bindgen]
impl Painter {
    /// A painter of the share with this index, of `count` shares.
    #[wasm_bindgen(constructor)]
    pub fn new(share: usize, count: usize) -> Result<Self, Refusal> {
        panic::tell_the_page();
        Ok(Self {
            stripes: Stripes::new(share, count)?,
            clock: Clock::new(),
            task: None,
            fixtures: Vec::new(),
            renderer: None,
            other: None,
            costs: Vec::new(),
            times: Times::default(),
        })
    }

    /// Rows of pixels in a stripe.
    #[wasm_bindgen(js_name = stripeRows)]
    pub fn stripe_rows() -> usize {
        Stripes::ROWS
    }

    /// Whether this module draws a job of the stage: one in 16 bits by the first module, and one in 32 by
    /// another.
    pub fn draws(job: &str) -> Result<bool, Refusal> {
        Ok(job::format_of(job)?.is_drawn_here())
    }

    /// Forgets all pictures, so that the next one depends on no earlier one.
    pub fn forget(&mut self) {
        (self.task, self.renderer, self.other) = (None, None, None);
    }

    /// Takes the job that `Stage.job` has written.
    pub fn take(&mut self, job: &str) -> Result<(), Refusal> {
        self.times = Times::default();
        let task = Task::read(job, self.task.take())?;
        let kind = (task.job.state.format, task.job.size);
        let fits = |renderer: &Renderer| renderer.kind == kind;
        if !self.renderer.as_ref().is_some_and(fits) {
            std::mem::swap(&mut self.renderer, &mut self.other);
            // What the canvas shows is from the renderer that has just drawn.
            if let Some(renderer) = &mut self.renderer {
                renderer.shown = None;
            }
        }
        if !self.renderer.as_ref().is_some_and(fits) {
            // The old one is freed first: both may not fit into memory.
            self.renderer = None;
            let draw = kind.0.renderer(kind.1, self.stripes)?;
            self.renderer = Some(Renderer { draw, kind, shown: None });
        }
        if let Some(renderer) = &mut self.renderer {
            // A mixed pixel has none of the few codes of a smaller display, or not its dither.
            renderer.draw.set_antialiased(task.job.state.output.has_all_codes());
        }
        self.fixtures = task.rig.fixtures_at(task.job.state.seconds[0])?;
        self.task = Some(task);
        Ok(())
    }

    /// Whether any light casts shadows: if so, the painters of all shares pass maps on.
    #[wasm_bindgen(getter, js_name = castsShadows)]
    pub fn casts_shadows(&self) -> bool {
        let casts = |fixture: &Fixture| fixture.shadow().is_some() && !fixture.light().is_dark();
        self.fixtures.iter().any(casts)
    }

    /// Draws the shadow maps that this painter draws for all. Returns the numbers of their lights.
    #[wasm_bindgen(js_name = drawShadows)]
    pub fn draw_shadows(&mut self) -> Result<Vec<u32>, Refusal> {
        let Self { clock, fixtures, times, .. } = self;
        let (Some(task), Some(renderer)) = (&self.task, &mut self.renderer) else { return Ok(Vec::new()) };
        let (time, drawn) = clock.time(|| renderer.draw.draw_own_shadows(task.rig.scene(), fixtures));
        let drawn = drawn?;
        times.shadows = (!drawn.is_empty()).then_some(time);
        Ok(drawn.into_iter().map(|number| number as u32).collect())
    }

    /// The shadow map of a light, in the array `spare` if that has the right length.
    #[wasm_bindgen(js_name = shadowMap)]
    pub fn shadow_map(&self, light: usize, spare: Option<Uint32Array>) -> Uint32Array {
        let depths = self.renderer.as_ref().map_or(Vec::new(), |renderer| renderer.draw.shadow_map(light));
        let length = depths.len() as u32;
        let array = spare.filter(|spare| spare.length() == length);
        let array = array.unwrap_or_else(|| Uint32Array::new_with_length(length));
        array.copy_from(&depths);
        array
    }

    /// Takes the shadow map of a light from another painter.
    #[wasm_bindgen(js_name = takeShadowMap)]
    pub fn take_shadow_map(&mut self, light: usize, depths: &[u32]) -> Result<(), Refusal> {
        let (Some(task), Some(renderer)) = (&self.task, &mut self.renderer) else { return Ok(()) };
        Ok(renderer.draw.take_shadow_map(task.rig.scene(), &self.fixtures, light, depths)?)
    }

    /// Draws the geometry of the stripes.
    #[wasm_bindgen(js_name = drawGeometry)]
    pub fn draw_geometry(&mut self) {
        let (Some(task), Some(renderer)) = (&self.task, &mut self.renderer) else { return };
        let camera = task.rig.camera_of(&task.job.state);
        let (time, moved) = self.clock.time(|| renderer.draw.draw_geometry(task.rig.scene(), &camera));
        self.times.geometry = moved.then_some(time);
    }

    /// Lights the stripes and encodes them. Returns whether they differ from the last picture.
    #[wasm_bindgen(js_name = drawLight)]
    pub fn draw_light(&mut self) -> Result<bool, Refusal> {
        let (Some(task), Some(renderer)) = (&self.task, &mut self.renderer) else { return Ok(false) };
        let (state, display) = (&task.job.state, task.rig.display(&task.job.state));
        let Renderer { draw, shown, .. } = renderer;
        let (clock, fixtures) = (&self.clock, &self.fixtures);
        let light = |draw: &mut dyn Draw| match state.is_everything {
            true => draw.draw_everything(fixtures).map(|()| true),
            false => draw.draw_light(fixtures),
        };
        let (lighting, lit) = clock.time(|| light(&mut **draw));
        let is_lit = lit?;
        if state.map == Subject::Cost {
            self.costs = blocks(self.stripes, task.job.size).map(|_| [0.0; PASSES]).collect();
            for pass in 0..PASSES {
                // After a new clock all is lit again.
                draw.set_clock(None);
                draw.set_clock(Some(clock::nanoseconds));
                light(&mut **draw)?;
                for (costs, (x, y)) in self.costs.iter_mut().zip(blocks(self.stripes, task.job.size)) {
                    costs[pass] = draw.cost(x, y).unwrap_or(0.0);
                }
            }
            draw.set_clock(None);
        }
        let showing = Some((state.scene, state.is_everything, display));
        let is_drawn = std::mem::replace(shown, showing) != showing || is_lit;
        if is_drawn {
            draw.set_display(display);
            let (encode, _) = self.clock.time(|| draw.encode().len());
            (self.times.lighting, self.times.encode) = (lighting, encode);
        }
        Ok(is_drawn)
    }

    /// A copy of the stripes, from top to bottom: RGBA, sRGB, eight bits. It is in the array `spare`
    /// if that has the right length.
    pub fn pixels(&self, spare: Option<Uint8ClampedArray>) -> Uint8ClampedArray {
        let pixels = self.renderer.as_ref().map_or(&[][..], |renderer| renderer.draw.pixels());
        let length = pixels.len() as u32;
        let array = spare.filter(|spare| spare.length() == length);
        let array = array.unwrap_or_else(|| Uint8ClampedArray::new_with_length(length));
        array.copy_from(pixels);
        array
    }

    /// The marks of the edges in the stripes, for `Composite.put`. Empty for a whole picture, which
    /// is mixed already.
    #[wasm_bindgen(js_name = edgeMarks)]
    pub fn edge_marks(&self) -> Vec<u64> {
        let renderer = self.renderer.as_ref().filter(|_| self.stripes != Stripes::ALL);
        renderer.map_or(Vec::new(), |renderer| renderer.draw.edge_marks())
    }

    /// What the job's map shows of each block of pixels, row by row: the number of evaluated lights,
    /// the time that a pixel has taken, or 1 where the block was lit again and else 0. Empty if the job
    /// has no map.
    pub fn counts(&self) -> Vec<u16> {
        let (Some(task), Some(renderer)) = (&self.task, &self.renderer) else { return Vec::new() };
        let (draw, places) = (&renderer.draw, blocks(self.stripes, task.job.size));
        match task.job.state.map {
            Subject::Nothing => Vec::new(),
            Subject::Lights => places.filter_map(|(x, y)| draw.lights_evaluated(x, y)).collect(),
            Subject::Cost => map::counts_of_nanoseconds(&self.costs),
            Subject::Tiles => places.filter_map(|(x, y)| draw.is_relit(x, y)).map(u16::from).collect(),
        }
    }

    /// The counts of the work for the stripes of the last picture.
    #[wasm_bindgen(unchecked_return_type = "AccountState | undefined")]
    pub fn account(&self) -> Option<JsValue> {
        Some(scene_state::account(self.renderer.as_ref()?.draw.account()))
    }

    /// The times of the last picture's passes.
    pub fn times(&self) -> Times {
        self.times
    }

    /// Lights the stripes of a job in both modes and compares the results bit for bit.
    pub fn compare(&self, job: &str) -> Result<Equality, Refusal> {
        let task = Task::read(job, self.task.clone())?;
        let state = &task.job.state;
        let fixtures = task.rig.fixtures_at(state.seconds[0])?;
        let mut draw = state.format.renderer(task.job.size, self.stripes)?;
        draw.set_display(task.rig.display(state));
        let of = (task.rig.scene(), &task.rig.camera_of(state), &*fixtures);
        Equality::new(draw, task.job.size, self.stripes, &self.clock, of)
    }

    /// Draws a small picture of a scene as it opens: RGBA, sRGB, eight bits.
    pub fn thumbnail(scene: &str, width: u32, height: u32) -> Result<Clamped<Vec<u8>>, Refusal> {
        let address = job::write_opened(crate::address::scene_named(scene)?, (width, height));
        let mut painter = Self::new(0, 1)?;
        painter.take(&address)?;
        painter.draw_shadows()?;
        painter.draw_geometry();
        painter.draw_light()?;
        let pixels = painter.renderer.as_ref().map_or(Vec::new(), |renderer| renderer.draw.pixels().to_vec());
        Ok(Clamped(pixels))
    }
}

/// The first pixel of each block in the stripes of a picture of this size, row by row.
fn blocks(stripes: Stripes, (width, height): (u32, u32)) -> impl Iterator<Item = (usize, usize)> {
    let columns = (0..width as usize).step_by(LANES);
    stripes.rows(height as usize).flatten().flat_map(move |y| columns.clone().map(move |x| (x, y)))
}

impl fmt::Debug for Painter {
    /// The output omits the renderer, which would print every pixel and make the module larger.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Painter").field("stripes", &self.stripes).finish_non_exhaustive()
    }
}
