//! The JavaScript class of the scenes. It shows one scene at a time, lit with only the effects that
//! the scene needs.

use crate::{
    canvas::Canvas,
    clock::Clock,
    equality::Equality,
    format::{Draw, Format},
    map::{Map, Subject},
    panic,
    refusal::Refusal,
    rig::Rig,
    scene_state::{AccountState, EffectState, ExampleState, SceneLightState, SwitchState},
    times::Times,
    viewpoint::Viewpoint,
};
use luminaire::{dynamic::Effect, projector::Fixture};
use luminaire_render::{
    Camera,
    scenes::{Example, turntable},
};
use std::fmt;
use wasm_bindgen::{Clamped, prelude::*};
use web_sys::HtmlCanvasElement;

/// The number format at start: the one that can hold the lights of every scene.
const FIRST: Format = Format::F32;

/// A scene that plays over time. Every setter either takes its value, or changes nothing and throws
/// a string that names the parameter, its value and the remedy.
#[wasm_bindgen]
pub struct Scenes {
    example: Example,
    rig: Rig,
    viewpoint: Viewpoint,
    /// The time to which the lights have moved, and the time to which the camera has moved, in
    /// seconds.
    seconds: [f32; 2],
    /// Whether every effect is evaluated for every light at every pixel.
    is_everything: bool,
    format: Format,
    renderer: Box<dyn Draw>,
    size: (u32, u32),
    /// The canvas elements of the picture and of the map; both have the size of the scene.
    elements: [HtmlCanvasElement; 2],
    canvas: Canvas,
    map_canvas: Canvas,
    map: Map,
    clock: Clock,
    /// Whether the canvas shows the last picture.
    is_shown: bool,
    times: Times,
    /// Total time of the last picture in milliseconds, from setting the lights until the canvas has
    /// taken the picture.
    frame: f64,
}

#[wasm_bindgen]
impl Scenes {
    /// Opens the first scene on two canvases, one for the picture and one for the map. Nothing is
    /// drawn yet.
    #[wasm_bindgen(constructor)]
    pub fn new(canvas: HtmlCanvasElement, map: HtmlCanvasElement) -> Result<Self, JsValue> {
        panic::tell_the_page();
        Ok(Self::begin([canvas, map])?)
    }

    /// The scenes to choose from.
    pub fn examples() -> Vec<ExampleState> {
        Example::ALL.map(ExampleState::from).into()
    }

    /// The name of the scene.
    #[wasm_bindgen(getter)]
    pub fn example(&self) -> String {
        self.example.name().to_owned()
    }

    /// Opens a scene in its original state. Its pictures have this width and height or, without
    /// these, the size that the scene is composed for.
    pub fn open(&mut self, name: &str, width: Option<u32>, height: Option<u32>) -> Result<(), JsValue> {
        Ok(self.open_example(name, [width, height])?)
    }

    /// Opens the turntable under this many spotlights, for measuring. `shadow_side` is the side of
    /// the lights' shadow maps in texels; without it there are no shadow maps.
    #[wasm_bindgen(js_name = openTurntable)]
    pub fn open_turntable(
        &mut self,
        spots: usize,
        shadow_side: Option<u16>,
        width: u32,
        height: u32,
    ) -> Result<(), JsValue> {
        let mut rig = Rig::new(turntable(spots).map_err(Refusal::from)?).map_err(Refusal::from)?;
        shadow_side.map_or(Ok(()), |side| rig.add_shadows(side)).map_err(Refusal::from)?;
        Ok(self.change(Example::Turntable, rig, (width, height))?)
    }

    /// Returns whether anything in the scene moves by itself.
    pub fn moves(&self) -> bool {
        self.rig.moves()
    }

    /// Whether the scene's camera moves by itself.
    #[wasm_bindgen(js_name = cameraMoves)]
    pub fn camera_moves(&self) -> bool {
        self.rig.camera_moves()
    }

    /// Moves the lights to their state at one time and the camera to its state at another, both in
    /// seconds.
    pub fn seek(&mut self, lights: f32, camera: f32) {
        self.seconds = [lights, camera];
    }

    /// Moves the camera around its target, by angles in radians.
    pub fn orbit(&mut self, yaw: f32, pitch: f32) {
        self.viewpoint.orbit(self.rig.camera_at(self.seconds[1]), yaw, pitch);
    }

    /// Moves the camera to `factor` times its distance.
    pub fn zoom(&mut self, factor: f32) {
        self.viewpoint.zoom(self.rig.camera_at(self.seconds[1]), factor);
    }

    /// Draws what has changed since the last picture. Returns whether anything was drawn.
    pub fn draw(&mut self) -> Result<bool, JsValue> {
        let clock = self.clock.clone();
        let (frame, drawn) = clock.time(|| self.draw_changes());
        let Some(times) = drawn? else { return Ok(false) };
        (self.times, self.frame) = (times, frame);
        Ok(true)
    }

    /// Shows the map of the last picture. Returns whether there is one.
    #[wasm_bindgen(js_name = drawMap)]
    pub fn draw_map(&mut self) -> Result<bool, JsValue> {
        let (width, height) = self.size;
        match self.map.draw(&*self.renderer, width as usize, height as usize) {
            Some(pixels) => self.map_canvas.show(pixels).map(|()| true).map_err(JsValue::from),
            None => Ok(false),
        }
    }

    /// Sets the subject of the map: `nothing`, `lights` or `tiles`.
    #[wasm_bindgen(js_name = setMap)]
    pub fn set_map(&mut self, subject: &str) -> Result<(), JsValue> {
        self.map.set_subject(Subject::named(subject)?);
        Ok(())
    }

    /// Returns how many lights the last colour of the map stands for.
    #[wasm_bindgen(getter, js_name = mapEnd)]
    pub fn map_end(&self) -> f64 {
        self.map.end()
    }

    /// The colours of the map, from no light to the end of its scale: red, green and blue of each.
    pub fn palette(&self) -> Clamped<Vec<u8>> {
        Clamped(self.map.colours().concat())
    }

    /// The colours of re-lit and of kept tiles: red, green, blue of each.
    #[wasm_bindgen(js_name = tileColours)]
    pub fn tile_colours(&self) -> Clamped<Vec<u8>> {
        Clamped(self.map.tile_colours().concat())
    }

    /// A copy of the last picture: RGBA, sRGB, eight bits.
    pub fn pixels(&self) -> Clamped<Vec<u8>> {
        Clamped(self.renderer.pixels().to_vec())
    }

    /// Pixels in a row.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.size.0
    }

    /// Rows of pixels.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.size.1
    }

    /// Time of the last picture's geometry pass in milliseconds; nothing if the geometry was kept.
    #[wasm_bindgen(getter, js_name = geometryMs)]
    pub fn geometry_ms(&self) -> Option<f64> {
        self.times.geometry
    }

    /// Time of the last picture's shadow maps in milliseconds; nothing if all were kept.
    #[wasm_bindgen(getter, js_name = shadowsMs)]
    pub fn shadows_ms(&self) -> Option<f64> {
        self.times.shadows
    }

    /// The time of the last picture's lighting pass, in milliseconds.
    #[wasm_bindgen(getter, js_name = lightingMs)]
    pub fn lighting_ms(&self) -> f64 {
        self.times.lighting
    }

    /// The time of the last picture's display encoding, in milliseconds.
    #[wasm_bindgen(getter, js_name = encodeMs)]
    pub fn encode_ms(&self) -> f64 {
        self.times.encode
    }

    /// The time to pass the last picture to the canvas, in milliseconds.
    #[wasm_bindgen(getter, js_name = showMs)]
    pub fn show_ms(&self) -> f64 {
        self.times.show
    }

    /// The total time of the last picture in milliseconds, from setting the lights until the canvas
    /// has taken the picture.
    #[wasm_bindgen(getter, js_name = frameMs)]
    pub fn frame_ms(&self) -> f64 {
        self.frame
    }

    /// Returns the counts of the work for the last picture.
    pub fn account(&self) -> AccountState {
        self.renderer.account().into()
    }

    /// The effects of the library, and whether the picture needs them.
    pub fn effects(&self) -> Result<Vec<EffectState>, JsValue> {
        let plan = self.rig.plan(&self.fixtures()?);
        let state = |&effect: &Effect| EffectState {
            name: effect.name().to_owned(),
            is_called_for: plan.requires(effect),
        };
        Ok(Effect::ALL.iter().map(state).collect())
    }

    /// The effects that have a switch.
    pub fn switches(&self) -> Vec<SwitchState> {
        self.rig.switches()
    }

    /// Switches an effect on or off.
    #[wasm_bindgen(js_name = setEffect)]
    pub fn set_effect(&mut self, name: &str, on: bool) -> Result<(), JsValue> {
        Ok(self.switch_effect(name, on)?)
    }

    /// The lights with their switches.
    pub fn lights(&self) -> Result<Vec<SceneLightState>, JsValue> {
        Ok(self.rig.lights().map_err(Refusal::from)?)
    }

    /// Switches a light on or off.
    #[wasm_bindgen(js_name = setOn)]
    pub fn set_on(&mut self, light: usize, on: bool) -> Result<(), JsValue> {
        Ok(self.rig.switch_light(light, on)?)
    }

    /// Switches between two modes: every effect of every light is evaluated at every pixel, or only
    /// the needed ones are.
    #[wasm_bindgen(js_name = setEverything)]
    pub fn set_everything(&mut self, everything: bool) {
        self.is_everything = everything;
        self.map.begin();
    }

    /// Lights the picture in both modes and compares the two results bit for bit.
    pub fn compare(&self) -> Result<Equality, JsValue> {
        Ok(self.compare_pictures()?)
    }

    /// The name of the current number format.
    #[wasm_bindgen(getter)]
    pub fn format(&self) -> String {
        self.format.name().to_owned()
    }

    /// Changes the number format to `fx16`, `fx32` or `f32`. The next `draw` redraws the picture.
    #[wasm_bindgen(js_name = setFormat)]
    pub fn set_format(&mut self, name: &str) -> Result<(), JsValue> {
        Ok(self.change_format(Format::named(name)?)?)
    }
}

impl fmt::Debug for Scenes {
    /// The output omits the renderer, which would print every pixel and make the module larger.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { example, format, size, .. } = self;
        let mut scenes = f.debug_struct("Scenes");
        scenes.field("example", example).field("format", format).field("size", size).finish_non_exhaustive()
    }
}

impl Scenes {
    fn begin(elements: [HtmlCanvasElement; 2]) -> Result<Self, Refusal> {
        let [example, ..] = Example::ALL;
        let (width, height) = composed(example);
        let canvas = |element| Canvas::new(element, width, height);
        Ok(Self {
            example,
            rig: Rig::new(example.setup()?)?,
            viewpoint: Viewpoint::ORIGINAL,
            seconds: [0.0; 2],
            is_everything: false,
            format: FIRST,
            renderer: FIRST.renderer(width, height)?,
            size: (width, height),
            canvas: canvas(&elements[0])?,
            map_canvas: canvas(&elements[1])?,
            elements,
            map: Map::new(),
            clock: Clock::new(),
            is_shown: false,
            times: Times::default(),
            frame: 0.0,
        })
    }

    fn open_example(&mut self, name: &str, size: [Option<u32>; 2]) -> Result<(), Refusal> {
        let example = Example::named(name).ok_or_else(|| Refusal::Name {
            parameter: "scene",
            value: name.to_owned(),
            expected: "one of those on the list",
        })?;
        let (width, height) = composed(example);
        let size = (size[0].unwrap_or(width), size[1].unwrap_or(height));
        self.change(example, Rig::new(example.setup()?)?, size)
    }

    fn switch_effect(&mut self, name: &str, on: bool) -> Result<(), Refusal> {
        let mut rig = self.rig.clone();
        rig.switch_effect(name, on)?;
        rig.check(self.format, self.seconds[0])?;
        (self.rig, self.is_shown) = (rig, false);
        Ok(())
    }

    fn compare_pictures(&self) -> Result<Equality, Refusal> {
        let (width, height) = self.size;
        let picture = (self.rig.scene(), &self.camera(), &*self.fixtures()?);
        let mut renderer = self.format.renderer(width, height)?;
        renderer.set_display(self.rig.display());
        Equality::new(renderer, width as usize, &self.clock, picture)
    }

    fn change_format(&mut self, format: Format) -> Result<(), Refusal> {
        self.rig.check(format, self.seconds[0])?;
        self.renderer = format.renderer(self.size.0, self.size.1)?;
        self.format = format;
        Ok(())
    }

    /// If the new scene is refused, the current one stays unchanged.
    fn change(&mut self, example: Example, rig: Rig, size: (u32, u32)) -> Result<(), Refusal> {
        let (width, height) = size;
        rig.check(self.format, 0.0)?;
        self.renderer = self.format.renderer(width, height)?;
        self.canvas = Canvas::new(&self.elements[0], width, height)?;
        self.map_canvas = Canvas::new(&self.elements[1], width, height)?;
        (self.example, self.rig, self.size, self.is_shown) = (example, rig, size, false);
        (self.viewpoint, self.seconds) = (Viewpoint::ORIGINAL, [0.0; 2]);
        self.map.begin();
        Ok(())
    }

    fn fixtures(&self) -> Result<Vec<Fixture>, Refusal> {
        Ok(self.rig.fixtures_at(self.seconds[0])?)
    }

    fn camera(&self) -> Camera {
        self.viewpoint.of(self.rig.camera_at(self.seconds[1]))
    }

    /// Returns the times of the passes; `None` if there was nothing to draw.
    fn draw_changes(&mut self) -> Result<Option<Times>, Refusal> {
        let (fixtures, camera) = (self.fixtures()?, self.camera());
        let Self { renderer, rig, canvas, clock, is_everything, .. } = self;
        let (geometry, moved) = clock.time(|| renderer.draw_geometry(rig.scene(), &camera));
        let (shadows, cast) = clock.time(|| renderer.draw_shadows(rig.scene(), &fixtures));
        let shadows = cast?.then_some(shadows);
        let (lighting, lit) = clock.time(|| match *is_everything {
            true => renderer.draw_everything(&fixtures).map(|()| true),
            false => renderer.draw_light(&fixtures),
        });
        if !lit? && self.is_shown {
            return Ok(None);
        }
        // Set only once the canvas shows the picture: if the canvas rejected it, the next draw
        // passes it again.
        self.is_shown = false;
        renderer.set_display(rig.display());
        let (encode, pixels) = clock.time(|| renderer.encode());
        let (show, shown) = clock.time(|| canvas.show(pixels));
        shown?;
        self.is_shown = true;
        Ok(Some(Times { geometry: moved.then_some(geometry), shadows, lighting, encode, show }))
    }
}

/// The width and height that a scene is composed for.
fn composed(example: Example) -> (u32, u32) {
    let (width, height) = example.size();
    (width as u32, height as u32)
}
