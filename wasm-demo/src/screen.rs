//! The screen: draws the picture of a desk, and its map, into two canvases.

use crate::{
    canvas::Canvas,
    clock::Clock,
    desk::Desk,
    equality::Equality,
    format::{Draw, Format},
    map::Map,
    refusal::Refusal,
    state::State,
    times::Times,
};
use luminaire_render::{Account, scenes::Example};
use std::fmt;
use web_sys::HtmlCanvasElement;

/// Two canvases of one size, and the renderer of their pictures.
pub(crate) struct Screen {
    /// The canvas elements of the picture and of the map.
    elements: [HtmlCanvasElement; 2],
    /// The size of all pictures; `None` for the size that a scene is composed for.
    fixed: Option<(u32, u32)>,
    size: (u32, u32),
    format: Format,
    renderer: Box<dyn Draw>,
    canvas: Canvas,
    map_canvas: Canvas,
    map: Map,
    clock: Clock,
    /// What the last picture shows besides its scene, camera and lights; `None` if the canvas has
    /// refused it.
    shown: Option<(Example, bool, bool)>,
    times: Times,
}

impl Screen {
    /// Takes two canvases. Nothing is drawn yet.
    pub(crate) fn new(
        elements: [HtmlCanvasElement; 2],
        fixed: Option<(u32, u32)>,
        state: &State,
    ) -> Result<Self, Refusal> {
        let size = fixed.unwrap_or(composed(state.scene));
        let [canvas, map_canvas] = canvases(&elements, size)?;
        Ok(Self {
            elements,
            fixed,
            size,
            format: state.format,
            renderer: state.format.renderer(size.0, size.1)?,
            canvas,
            map_canvas,
            map: Map::new(),
            clock: Clock::new(),
            shown: None,
            times: Times::default(),
        })
    }

    /// Draws what has changed since the last picture. Returns whether anything was drawn.
    pub(crate) fn draw(&mut self, desk: &Desk) -> Result<bool, Refusal> {
        self.fit(desk.state())?;
        let clock = self.clock.clone();
        let (frame, times) = clock.time(|| self.draw_changes(desk));
        let Some(times) = times? else { return Ok(false) };
        self.times = Times { frame, ..times };
        Ok(true)
    }

    /// Returns the times of the passes; `None` if there was nothing to draw.
    fn draw_changes(&mut self, desk: &Desk) -> Result<Option<Times>, Refusal> {
        let (state, rig, camera) = (desk.state(), desk.rig(), desk.camera());
        let fixtures = rig.fixtures_at(state.seconds[0])?;
        let display = rig.display(state);
        let shown = Some((state.scene, state.is_everything, display.is_dithered()));
        let Self { renderer, canvas, clock, .. } = self;
        let (geometry, moved) = clock.time(|| renderer.draw_geometry(rig.scene(), &camera));
        let (shadows, cast) = clock.time(|| renderer.draw_shadows(rig.scene(), &fixtures));
        let shadows = cast?.then_some(shadows);
        let (lighting, lit) = clock.time(|| match state.is_everything {
            true => renderer.draw_everything(&fixtures).map(|()| true),
            false => renderer.draw_light(&fixtures),
        });
        if !lit? && self.shown == shown {
            return Ok(None);
        }
        // Set only once the canvas shows the picture: if the canvas rejected it, the next draw
        // passes it again.
        self.shown = None;
        renderer.set_display(display);
        let (encode, pixels) = clock.time(|| renderer.encode());
        let (show, passed) = clock.time(|| canvas.show(pixels));
        passed?;
        self.shown = shown;
        Ok(Some(Times { geometry: moved.then_some(geometry), shadows, lighting, encode, show, frame: 0.0 }))
    }

    /// Changes format and size to those of a state.
    fn fit(&mut self, state: &State) -> Result<(), Refusal> {
        let size = self.fixed.unwrap_or(composed(state.scene));
        if (state.format, size) != (self.format, self.size) {
            self.renderer = state.format.renderer(size.0, size.1)?;
        }
        if size != self.size {
            [self.canvas, self.map_canvas] = canvases(&self.elements, size)?;
            self.shown = None;
        }
        if self
            .shown
            .is_some_and(|(scene, everything, _)| (scene, everything) != (state.scene, state.is_everything))
        {
            self.map.begin();
        }
        (self.format, self.size) = (state.format, size);
        Ok(())
    }

    /// Shows the map of the last picture. Returns whether there is one.
    pub(crate) fn draw_map(&mut self, state: &State) -> Result<bool, Refusal> {
        let size = (self.size.0 as usize, self.size.1 as usize);
        self.map.draw(state.map, &*self.renderer, size).map_or(Ok(false), |pixels| {
            self.map_canvas.show(pixels)?;
            Ok(true)
        })
    }

    /// Lights the picture in both modes and compares the two results bit for bit.
    pub(crate) fn compare(&self, desk: &Desk) -> Result<Equality, Refusal> {
        let (state, rig) = (desk.state(), desk.rig());
        let fixtures = rig.fixtures_at(state.seconds[0])?;
        let mut renderer = state.format.renderer(self.size.0, self.size.1)?;
        renderer.set_display(rig.display(state));
        Equality::new(renderer, self.size.0 as usize, &self.clock, (rig.scene(), &desk.camera(), &fixtures))
    }

    /// The map.
    pub(crate) fn map(&self) -> &Map {
        &self.map
    }

    /// The last picture: RGBA, sRGB, eight bits.
    pub(crate) fn pixels(&self) -> &[u8] {
        self.renderer.pixels()
    }

    /// The width and the height in pixels.
    pub(crate) fn size(&self) -> (u32, u32) {
        self.size
    }

    /// The times of the last picture.
    pub(crate) fn times(&self) -> Times {
        self.times
    }

    /// The counts of the work for the last picture.
    pub(crate) fn account(&self) -> Account {
        self.renderer.account()
    }
}

impl fmt::Debug for Screen {
    /// The output omits the renderer, which would print every pixel and make the module larger.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Screen").field("size", &self.size).finish_non_exhaustive()
    }
}

/// Draws a small picture of a scene as it opens: RGBA.
pub(crate) fn thumbnail(scene: Example, width: u32, height: u32) -> Result<Vec<u8>, Refusal> {
    let desk = Desk::new(scene)?;
    let fixtures = desk.rig().fixtures_at(0.0)?;
    let mut renderer = Format::F32.renderer(width, height)?;
    renderer.draw_geometry(desk.rig().scene(), &desk.camera());
    renderer.draw_shadows(desk.rig().scene(), &fixtures)?;
    renderer.draw_light(&fixtures)?;
    Ok(renderer.encode().to_vec())
}

fn canvases(elements: &[HtmlCanvasElement; 2], (width, height): (u32, u32)) -> Result<[Canvas; 2], Refusal> {
    Ok([Canvas::new(&elements[0], width, height)?, Canvas::new(&elements[1], width, height)?])
}

/// The width and height that a scene is composed for.
fn composed(scene: Example) -> (u32, u32) {
    let (width, height) = scene.size();
    (width as u32, height as u32)
}
