//! The JavaScript class of the stage: a scene, a camera, three lights, and their renderer.

use crate::{
    canvas::Canvas,
    clock::Clock,
    fixture,
    format::{Draw, Format},
    light::{self, Light, LightState, Mark},
    panic,
    refusal::Refusal,
    sweep,
    times::Times,
};
use luminaire::{Vec3, projector::Fixture};
use luminaire_render::{Camera, Scene, scenes::stage};
use std::fmt;
use wasm_bindgen::{Clamped, prelude::*};
use web_sys::HtmlCanvasElement;

const NAMES: [&str; 3] = ["key", "fill", "back"];

/// The number format that the page starts with: the one that can hold every fixture of the table.
const FIRST: Format = Format::F32;

/// Largest number of samples of a curve: a few samples for each pixel of a wide screen.
const SAMPLES: usize = 10_000;

/// The demo. Every setter either takes its value, or changes nothing and throws a string that names
/// the parameter, its value and the remedy.
#[wasm_bindgen]
pub struct Demo {
    scene: Scene,
    camera: Camera,
    lights: [Light; 3],
    /// The axis of each light when it is at rest.
    rest: [Vec3<f32>; 3],
    format: Format,
    renderer: Box<dyn Draw>,
    canvas: Canvas,
    clock: Clock,
    /// Whether the canvas shows the last picture.
    is_shown: bool,
    times: Times,
    width: u32,
    height: u32,
}

#[wasm_bindgen]
impl Demo {
    /// Opens the stage on this canvas. Nothing is drawn yet.
    #[wasm_bindgen(constructor)]
    pub fn new(canvas: &HtmlCanvasElement, width: u32, height: u32) -> Result<Self, JsValue> {
        panic::tell_the_page();
        Ok(Self::open(canvas, width, height)?)
    }

    /// Draws what has changed since the last picture. Returns whether anything was drawn.
    pub fn draw(&mut self) -> Result<bool, JsValue> {
        Ok(self.draw_changes()?)
    }

    /// Draws everything again, whether it has changed or not, to measure the time.
    pub fn redraw(&mut self) -> Result<(), JsValue> {
        // The renderer repeats only work whose input has changed. Drawing the geometry from another
        // camera first, without timing it, makes everything change.
        let mut elsewhere = self.camera;
        elsewhere.orbit(0.01, 0.0);
        self.renderer.draw_geometry(&self.scene, &elsewhere);
        self.draw_changes()?;
        Ok(())
    }

    /// A copy of the last picture: RGBA, sRGB, eight bits.
    pub fn pixels(&self) -> Clamped<Vec<u8>> {
        Clamped(self.renderer.pixels().to_vec())
    }

    /// Pixels in a row.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows of pixels.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The time of the last picture's geometry pass, in milliseconds; nothing if the geometry was
    /// kept.
    #[wasm_bindgen(getter, js_name = geometryMs)]
    pub fn geometry_ms(&self) -> Option<f64> {
        self.times.geometry
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

    /// The total time of the passes of the last picture, in milliseconds.
    #[wasm_bindgen(getter, js_name = frameMs)]
    pub fn frame_ms(&self) -> f64 {
        let Times { geometry, lighting, encode, show, .. } = self.times;
        geometry.unwrap_or(0.0) + lighting + encode + show
    }

    /// Moves the camera around the stage, by angles in radians.
    pub fn orbit(&mut self, yaw: f32, pitch: f32) {
        self.camera.orbit(yaw, pitch);
    }

    /// Moves the camera to `factor` times its distance.
    pub fn zoom(&mut self, factor: f32) {
        self.camera.zoom(factor);
    }

    /// Points the lights in their directions at a time of the sweep, in seconds.
    pub fn sweep(&mut self, seconds: f32) -> Result<(), JsValue> {
        for (i, (light, rest)) in self.lights.iter_mut().zip(self.rest).enumerate() {
            light.aim(sweep::axis(i, rest, seconds), self.format)?;
        }
        Ok(())
    }

    /// How many lights there are.
    #[wasm_bindgen(getter)]
    pub fn lights(&self) -> usize {
        self.lights.len()
    }

    /// How many lights are switched on.
    #[wasm_bindgen(getter, js_name = lightsOn)]
    pub fn lights_on(&self) -> usize {
        self.lights.iter().filter(|light| light.is_on()).count()
    }

    /// Returns the state of a light.
    pub fn light(&self, light: usize) -> Result<LightState, JsValue> {
        Ok(self.lit(light)?.state(self.format))
    }

    /// Sets the full beam angle of a light in degrees, which determines its field and outer angle.
    #[wasm_bindgen(js_name = setBeam)]
    pub fn set_beam(&mut self, light: usize, degrees: f32) -> Result<(), JsValue> {
        Ok(self.set(light, |light, format| light.set_angle(Mark::Beam, degrees, format))?)
    }

    /// Sets the full field angle of a light in degrees, which determines its beam and outer angle.
    #[wasm_bindgen(js_name = setField)]
    pub fn set_field(&mut self, light: usize, degrees: f32) -> Result<(), JsValue> {
        Ok(self.set(light, |light, format| light.set_angle(Mark::Field, degrees, format))?)
    }

    /// Sets the edge of a light: `soft` or `hard`.
    #[wasm_bindgen(js_name = setEdge)]
    pub fn set_edge(&mut self, light: usize, name: &str) -> Result<(), JsValue> {
        Ok(self.set(light, |light, format| light.set_edge(light::edge_named(name)?, format))?)
    }

    /// Sets the colour of a light, as `#rrggbb` in sRGB.
    #[wasm_bindgen(js_name = setColor)]
    pub fn set_color(&mut self, light: usize, hex: &str) -> Result<(), JsValue> {
        Ok(self.set(light, |light, format| light.set_color(light::color_of(hex)?, format))?)
    }

    /// Sets the intensity of a light: 1 lights a facing surface at distance 1 to full scale.
    #[wasm_bindgen(js_name = setIntensity)]
    pub fn set_intensity(&mut self, light: usize, intensity: f32) -> Result<(), JsValue> {
        Ok(self.set(light, |light, format| light.set_intensity(intensity, format))?)
    }

    /// Switches a light on or off.
    #[wasm_bindgen(js_name = setOn)]
    pub fn set_on(&mut self, light: usize, on: bool) -> Result<(), JsValue> {
        Ok(self.set(light, |light, _| {
            light.switch(on);
            Ok(())
        })?)
    }

    /// Sets the fixture of a light by name; an empty name removes it.
    #[wasm_bindgen(js_name = setFixture)]
    pub fn set_fixture(&mut self, light: usize, name: &str) -> Result<(), JsValue> {
        Ok(self.set(light, |light, format| light.set_fixture(name, format))?)
    }

    /// Sets whether the published angle of a light's fixture is interpreted as the `beam` or the
    /// `field` angle.
    #[wasm_bindgen(js_name = setReading)]
    pub fn set_reading(&mut self, light: usize, name: &str) -> Result<(), JsValue> {
        Ok(self.set(light, |light, format| light.set_reading(Mark::named(name)?, format))?)
    }

    /// Zooms a light's fixture to a published angle, in degrees.
    #[wasm_bindgen(js_name = setZoom)]
    pub fn set_zoom(&mut self, light: usize, degrees: f32) -> Result<(), JsValue> {
        Ok(self.set(light, |light, format| light.set_zoom(degrees, format))?)
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

    /// Returns why a format can't hold a light in its current state; nothing if it can.
    pub fn objection(&self, format: &str, light: usize) -> Result<Option<String>, JsValue> {
        let objection = Format::named(format)?.check(self.lit(light)?.spot()).err();
        Ok(objection.map(|error| error.to_string()))
    }

    /// Returns the largest difference between a picture in this format and one in `f32`, in
    /// displayed codes.
    #[wasm_bindgen(js_name = statedError)]
    pub fn stated_error(format: &str) -> Result<u8, JsValue> {
        Ok(Format::named(format)?.stated_error())
    }

    /// Evaluates the intensity of a light across its beam, from one side to the other, in the
    /// current number format. Returns pairs of the angle off axis in degrees and the intensity, for
    /// 2 to 10,000 samples.
    pub fn curve(&self, light: usize, samples: usize) -> Result<Vec<f32>, JsValue> {
        Ok(self.trace(self.lit(light)?, samples)?)
    }

    /// The fixtures to choose from.
    pub fn fixtures() -> Vec<fixture::Fixture> {
        fixture::all().to_vec()
    }
}

impl fmt::Debug for Demo {
    /// The output omits the renderer, which would print every pixel and make the module larger.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { lights, format, width, height, .. } = self;
        let mut demo = f.debug_struct("Demo");
        demo.field("lights", lights).field("format", format).field("width", width).field("height", height);
        demo.finish_non_exhaustive()
    }
}

impl Demo {
    fn open(canvas: &HtmlCanvasElement, width: u32, height: u32) -> Result<Self, Refusal> {
        let spots = stage::lights()?;
        let mut names = NAMES.iter();
        Ok(Self {
            renderer: FIRST.renderer(width, height)?,
            scene: stage::scene()?,
            camera: stage::camera(),
            lights: spots.map(|spot| Light::new(names.next().copied().unwrap_or_default(), spot)),
            rest: spots.map(|spot| spot.axis()),
            format: FIRST,
            canvas: Canvas::new(canvas, width, height)?,
            clock: Clock::new(),
            is_shown: false,
            times: Times::default(),
            width,
            height,
        })
    }

    fn draw_changes(&mut self) -> Result<bool, Refusal> {
        let Self { renderer, scene, camera, canvas, clock, .. } = self;
        let fixtures: Vec<Fixture> =
            self.lights.iter().filter(|light| light.is_on()).map(|light| (*light.spot()).into()).collect();
        let (geometry, moved) = clock.time(|| renderer.draw_geometry(scene, camera));
        let (lighting, lit) = clock.time(|| renderer.draw_light(&fixtures));
        let changed = lit?;
        if !changed && self.is_shown {
            return Ok(false);
        }
        // Set only once the canvas shows the picture: if the canvas rejected it, the next draw
        // passes it again.
        self.is_shown = false;
        let (encode, pixels) = clock.time(|| renderer.encode());
        let (show, shown) = clock.time(|| canvas.show(pixels));
        shown?;
        self.is_shown = true;
        self.times = Times { geometry: moved.then_some(geometry), shadows: None, lighting, encode, show };
        Ok(true)
    }

    /// If the new format cannot hold every light, the format is not changed.
    fn change_format(&mut self, format: Format) -> Result<(), Refusal> {
        if format == self.format {
            return Ok(());
        }
        for light in &self.lights {
            format.check(light.spot()).map_err(|error| Refusal::Format {
                format,
                light: light.name(),
                error,
            })?;
        }
        self.renderer = format.renderer(self.width, self.height)?;
        self.format = format;
        Ok(())
    }

    fn trace(&self, light: &Light, samples: usize) -> Result<Vec<f32>, Refusal> {
        if !(2..=SAMPLES).contains(&samples) {
            return Err(Refusal::Outside {
                parameter: "number of samples",
                value: samples as f32,
                least: 2.0,
                most: SAMPLES as f32,
                unit: "samples",
            });
        }
        let cone = light.spot().cone();
        // The curve has a dark margin at each side, so that the end of the light is visible.
        let reach = (cone.outer().to_degrees() / 2.0 * 1.12).min(180.0);
        let last = (samples - 1) as f32;
        let angles: Vec<f32> = (0..samples).map(|i| reach * (2.0 * i as f32 / last - 1.0)).collect();
        let intensities = self.format.intensities(&cone, &angles)?;
        Ok(angles.into_iter().zip(intensities).flat_map(|(angle, intensity)| [angle, intensity]).collect())
    }

    fn lit(&self, light: usize) -> Result<&Light, Refusal> {
        self.lights.get(light).ok_or(Refusal::Number { value: light, count: NAMES.len() })
    }

    fn set(
        &mut self,
        light: usize,
        change: impl FnOnce(&mut Light, Format) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let format = self.format;
        let light = self.lights.get_mut(light).ok_or(Refusal::Number { value: light, count: NAMES.len() })?;
        change(light, format)
    }
}
