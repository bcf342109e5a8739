//! The JavaScript class of the stage.

mod changes;
mod lights;

use crate::{
    address, fixture,
    format::Format,
    job::{self, Load},
    map::{Map, Subject},
    panic,
    parameter::{self, PARAMETERS, Value},
    refusal::Refusal,
    rig::Rig,
    scene_state,
    setting::Setting,
    state::{SWITCHABLE, State},
    viewpoint::Viewpoint,
};
use luminaire::dynamic::Effect;
use luminaire_fixtures::FIXTURES;
use luminaire_render::{Camera, LARGEST, scenes::Example};
use wasm_bindgen::{Clamped, prelude::*};

/// The scene that the page opens with.
const FIRST: Example = Example::Show;

/// Largest number of pixels of a picture at rest. The painters need about 70 bytes for each.
const REST: u32 = 8_000_000;

/// Largest number of pixels of a picture at rest with four for each of the screen: mixed by the browser,
/// they smooth the edges of shadows and gobos.
const SMOOTH: u32 = 3_500_000;

/// Largest number of pixels that an address can ask for: 7680 x 4320.
const PIXELS: u32 = 33_177_600;

/// A scene that is composed for fewer columns shows a small display, whose pixels should be seen.
const SMALL: u32 = 320;

/// A scene under the visitor's settings, whose picture painters draw. Every setter either takes its
/// value, or changes nothing and throws a string that names the parameter, its value and the remedy.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Stage {
    state: State,
    rig: Rig,
    /// Earlier states, the last of which is marked as one to return to.
    past: Vec<State>,
    /// States that were undone, the last of which comes next.
    future: Vec<State>,
    /// The lights as they were when the visitor's gesture began: its values are computed from them, and
    /// not from those that it has passed.
    grip: Option<Vec<Setting>>,
    /// The lights of the turntable, for measuring.
    load: Option<Load>,
    /// The size of all pictures; `None` for the size that a scene is composed for.
    fixed: Option<(u32, u32)>,
    /// The size of pictures while nothing moves; `None` while something does.
    rest: Option<(u32, u32)>,
    map: Map,
    /// The scene of the map's scale, and whether everything was evaluated.
    mapped: Option<(Example, bool)>,
}

#[wasm_bindgen]
impl Stage {
    /// Opens the first scene. Its pictures have this width and height or, without these, the size
    /// that a scene is composed for.
    ///
    /// # Errors
    /// A width or a height that a picture cannot have.
    #[wasm_bindgen(constructor)]
    pub fn new(width: Option<u32>, height: Option<u32>) -> Result<Self, Refusal> {
        panic::tell_the_page();
        let fixed = width.zip(height);
        if (width, height) != (None, None) {
            // One without the other has no pixels.
            let [width, height] = [width, height].map(Option::unwrap_or_default);
            let largest = LARGEST as u32;
            for (name, side, most) in
                [("width", width, largest), ("height", height, largest.min(PIXELS / width.max(1)))]
            {
                if !(1..=most).contains(&side) {
                    return Err(Refusal::outside(name, side as f32, [1.0, most as f32], "pixels"));
                }
            }
        }
        Ok(Self { fixed, ..Self::of(FIRST)? })
    }

    /// The scenes to choose from.
    #[wasm_bindgen(unchecked_return_type = "ExampleState[]")]
    pub fn examples() -> Vec<JsValue> {
        Example::ALL.iter().copied().map(scene_state::example).collect()
    }

    /// The name of the scene.
    #[wasm_bindgen(getter)]
    pub fn scene(&self) -> String {
        self.state.scene.name().to_owned()
    }

    /// Opens the turntable under this many spotlights, for measuring. `shadow_side` is the side of
    /// the lights' shadow maps in texels; without it there are no shadow maps.
    #[wasm_bindgen(js_name = openTurntable)]
    pub fn open_turntable(&mut self, spots: usize, shadow_side: Option<u16>) -> Result<(), Refusal> {
        let load = Some((spots, shadow_side));
        let mut stage = Self::with_rig(Example::Turntable, job::rig(Example::Turntable, load, None)?);
        if shadow_side.is_some() {
            stage.switch(Effect::Shadow.name(), true)?;
        }
        self.take(Self { load, ..stage });
        Ok(())
    }

    /// The state as part of an address.
    pub fn address(&self) -> String {
        address::write(&self.state, self.rig.lights())
    }

    /// Whether the lights of the scene can move.
    #[wasm_bindgen(getter, js_name = lightsMove)]
    pub fn lights_move(&self) -> bool {
        self.rig.moves()[0]
    }

    /// Whether the camera of the scene can move.
    #[wasm_bindgen(getter, js_name = cameraMoves)]
    pub fn camera_moves(&self) -> bool {
        self.rig.moves()[1]
    }

    /// Whether the lights move now.
    #[wasm_bindgen(getter, js_name = lightsPlay)]
    pub fn lights_play(&self) -> bool {
        self.plays()[0]
    }

    /// Whether the camera moves now.
    #[wasm_bindgen(getter, js_name = cameraPlays)]
    pub fn camera_plays(&self) -> bool {
        self.plays()[1]
    }

    /// Lets lights and camera move or stand still.
    pub fn play(&mut self, lights: bool, camera: bool) -> Result<(), Refusal> {
        self.change(|state| state.plays = [lights, camera])
    }

    /// Moves the lights to their state at one time and the camera to its state at another, both in
    /// seconds.
    pub fn seek(&mut self, lights: f32, camera: f32) -> Result<(), Refusal> {
        self.change(|state| state.seconds = [lights, camera])
    }

    /// Moves the camera back to that of the scene.
    #[wasm_bindgen(js_name = resetCamera)]
    pub fn reset_camera(&mut self) -> Result<(), Refusal> {
        self.change(|state| state.viewpoint = Viewpoint::ORIGINAL)
    }

    /// Sets the size of pictures at rest, for a screen with this width in pixels: twice the width if there
    /// are at most `SMOOTH` pixels and the display has all codes, else the width, or less if there would be
    /// more than `REST` pixels. Without a width pictures have the size of those that move. Returns whether the
    /// size has changed: the size that the page was opened with stays, and so does that of a scene
    /// for a small display.
    pub fn rest(&mut self, width: Option<u32>) -> bool {
        let (before, (wide, high)) = (self.size(), self.composed());
        let of = |width: u32| {
            let doubled = 4.0 * f64::from(width).powi(2) * f64::from(high) / f64::from(wide);
            let is_smooth = doubled <= f64::from(SMOOTH) && self.state.output.has_all_codes();
            let width = if is_smooth { 2 * width } else { width };
            let most = (f64::from(REST) * f64::from(wide) / f64::from(high)).sqrt() as u32;
            let width = width.clamp(1, most);
            (width, (f64::from(width) * f64::from(high) / f64::from(wide)).round().max(1.0) as u32)
        };
        self.rest = width.filter(|_| !self.shows_pixels()).map(of);
        before != self.size()
    }

    /// Whether pictures have the size of those at rest.
    #[wasm_bindgen(getter, js_name = isAtRest)]
    pub fn is_at_rest(&self) -> bool {
        self.fixed.is_none() && self.rest.is_some()
    }

    /// Whether each pixel of the picture is to be seen as a square.
    #[wasm_bindgen(getter, js_name = showsPixels)]
    pub fn shows_pixels(&self) -> bool {
        self.composed().0 < SMALL
    }

    /// The picture of the state, as a text that painters take. Equal texts have equal pictures.
    pub fn job(&self) -> String {
        job::write(self.size(), self.load, &self.state, self.rig.lights())
    }

    /// The picture of the state in the format of the other half; nothing if the picture is whole.
    #[wasm_bindgen(js_name = otherJob)]
    pub fn other_job(&self) -> Option<String> {
        Some(self.plain_job(self.state.other?))
    }

    /// The picture of the state in another number format.
    #[wasm_bindgen(js_name = jobIn)]
    pub fn job_in(&self, format: &str) -> Result<String, Refusal> {
        Format::named(format).map(|format| self.plain_job(format))
    }

    /// Pixels in a row.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.size().0
    }

    /// Rows of pixels.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.size().1
    }

    /// Draws the map of a picture of this width in pixels from the counts of all its painters, row by
    /// row. Returns RGBA, which is empty if there is no map.
    #[wasm_bindgen(js_name = drawMap)]
    pub fn draw_map(&mut self, counts: &[u16], width: usize) -> Clamped<Vec<u8>> {
        let state = &self.state;
        let mapped = Some((state.scene, state.is_everything));
        if std::mem::replace(&mut self.mapped, mapped) != mapped {
            self.map.begin();
        }
        Clamped(self.map.draw(state.map, counts, width).unwrap_or_default().to_vec())
    }

    /// Returns the sum of the last map of costs over all pixels, in milliseconds of a core.
    #[wasm_bindgen(getter, js_name = mapTotal)]
    pub fn map_total(&self) -> f64 {
        self.map.total
    }

    /// Returns how many lights, or nanoseconds, the last colour of the map stands for.
    #[wasm_bindgen(getter, js_name = mapEnd)]
    pub fn map_end(&self) -> f64 {
        self.map.end
    }

    /// The colours of the map, from no light to the end of its scale: red, green and blue of each.
    pub fn palette(&self) -> Clamped<Vec<u8>> {
        Clamped(self.map.palette.colours().concat())
    }

    /// The colours of re-lit and of kept tiles: red, green, blue of each.
    #[wasm_bindgen(js_name = tileColours)]
    pub fn tile_colours(&self) -> Clamped<Vec<u8>> {
        Clamped(self.map.tile_colours().concat())
    }

    /// The effects that have a switch.
    #[wasm_bindgen(unchecked_return_type = "SwitchState[]")]
    pub fn switches(&self) -> Vec<JsValue> {
        let (rig, state) = (&self.rig, &self.state);
        let switch = |(effect, label)| {
            scene_state::switch(effect, label, rig.offers(state, effect), rig.has(state, effect))
        };
        SWITCHABLE.map(switch).into()
    }

    /// The parameters of the state, with what their controls offer.
    #[wasm_bindgen(unchecked_return_type = "ParameterState[]")]
    pub fn parameters() -> Vec<JsValue> {
        PARAMETERS.iter().map(parameter::offer).collect()
    }

    /// Returns the value of a parameter: a boolean, a number or a text, by its kind.
    pub fn get(&self, name: &str) -> Result<JsValue, Refusal> {
        Ok(match parameter::named(name)?.get(&self.state) {
            Value::Nothing => JsValue::UNDEFINED,
            Value::Flag(on) => on.into(),
            Value::Number(number) => number.into(),
            Value::Text(text) => text.into(),
        })
    }

    /// Sets a parameter to a value of the kind that `get` returns.
    pub fn set(&mut self, name: &str, value: &JsValue) -> Result<(), Refusal> {
        let flag = || value.as_bool().map(Value::Flag);
        let number = || value.as_f64().map(|number| Value::Number(number as f32));
        let value = flag().or_else(number).or_else(|| value.as_string().map(Value::Text));
        self.put(name, value.unwrap_or(Value::Nothing))
    }

    /// The fixtures to choose from.
    #[wasm_bindgen(unchecked_return_type = "FixtureState[]")]
    pub fn fixtures() -> Vec<JsValue> {
        FIXTURES.iter().map(fixture::state).collect()
    }
}

impl Stage {
    /// Opens a scene. Its pictures have the size that it is composed for.
    pub(crate) fn of(scene: Example) -> Result<Self, Refusal> {
        Ok(Self::with_rig(scene, Rig::new(scene.setup()?)?))
    }

    /// Opens a scene with other lights than its own.
    pub(crate) fn with_rig(scene: Example, rig: Rig) -> Self {
        let state = State::of(scene, rig.lights());
        Self {
            past: vec![state.clone()],
            state,
            rig,
            future: Vec::new(),
            grip: None,
            load: None,
            fixed: None,
            rest: None,
            map: Map::new(),
            mapped: None,
        }
    }

    /// Takes the scene of another stage and its changes, for pictures of the same size.
    fn take(&mut self, Self { state, rig, past, future, grip, load, .. }: Self) {
        (self.state, self.rig, self.load) = (state, rig, load);
        (self.past, self.future, self.grip) = (past, future, grip);
    }

    pub(crate) fn state(&self) -> &State {
        &self.state
    }

    /// The scene and its lights.
    pub(crate) fn rig(&self) -> &Rig {
        &self.rig
    }

    /// The camera of the picture.
    pub(crate) fn camera(&self) -> Camera {
        self.rig.camera_of(&self.state)
    }

    /// The scene's own camera.
    fn own_camera(&self) -> Camera {
        self.rig.camera_at(self.state.seconds[1])
    }

    /// The picture of the state in a number format, without a map.
    fn plain_job(&self, format: Format) -> String {
        let state = State { format, map: Subject::Nothing, ..self.state.clone() };
        job::write(self.size(), self.load, &state, self.rig.lights())
    }

    fn size(&self) -> (u32, u32) {
        self.fixed.or(self.rest).unwrap_or(self.composed())
    }

    /// The size that the scene is composed for.
    fn composed(&self) -> (u32, u32) {
        let (width, height) = self.state.scene.size();
        (width as u32, height as u32)
    }
}
