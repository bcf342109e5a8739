//! The lights of the stage, for JavaScript.

use super::Stage;
use crate::{
    curve, edge,
    light::{DialEnds, LightState},
    photometry,
    refusal::Refusal,
};
use luminaire::{Cone, Vec3, dynamic::AnyLight, falloff::AnyFalloff};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Stage {
    /// How many lights there are.
    #[wasm_bindgen(getter, js_name = lightCount)]
    pub fn light_count(&self) -> usize {
        self.desk.state().lights.len()
    }

    /// The lights, each with its name, its colour, its position and whether it is on, and nothing
    /// else.
    pub fn lights(&self) -> Result<Vec<LightState>, JsValue> {
        Ok(self.desk.listed_lights()?)
    }

    /// Returns the state of a light.
    pub fn light(&self, light: usize) -> Result<LightState, JsValue> {
        Ok(self.desk.light_state(light)?)
    }

    /// Returns the ends of the dials of a light.
    #[wasm_bindgen(js_name = dialEnds)]
    pub fn dial_ends(&self, light: usize) -> Result<DialEnds, JsValue> {
        Ok(self.desk.dial_ends(light)?)
    }

    /// Begins a gesture, such as the drag of a slider. Until the next one begins, numbers and drags of a
    /// light are computed from the light as it is now.
    pub fn grip(&mut self) {
        self.desk.grip();
    }

    /// Switches a light on or off.
    #[wasm_bindgen(js_name = setOn)]
    pub fn set_on(&mut self, light: usize, on: bool) -> Result<(), JsValue> {
        Ok(self.desk.change_light(light, |setting| setting.is_on = on)?)
    }

    /// Sets a number of a light: its `beam`, `field` or `zoom` angle in degrees; `fit-beam` or
    /// `fit-field`, which keep the other angle; or its `intensity` in candela, or in lux for a
    /// directional light. Angles conserve the flux.
    #[wasm_bindgen(js_name = setNumber)]
    pub fn set_number(&mut self, light: usize, name: &str, value: f32) -> Result<(), JsValue> {
        Ok(self.desk.set_number(light, name, value)?)
    }

    /// Sets a choice of a light: its `edge`, `color`, `fixture`, or the `reading` of its angle.
    #[wasm_bindgen(js_name = setChoice)]
    pub fn set_choice(&mut self, light: usize, name: &str, value: &str) -> Result<(), JsValue> {
        Ok(self.desk.set_choice(light, name, value)?)
    }

    /// Multiplies the angles of a light by a factor and conserves its flux.
    #[wasm_bindgen(js_name = zoomLight)]
    pub fn zoom_light(&mut self, light: usize, factor: f32) -> Result<(), JsValue> {
        Ok(self.desk.zoom_light(light, factor)?)
    }

    /// Moves a light to a position in metres.
    #[wasm_bindgen(js_name = placeLight)]
    pub fn place_light(&mut self, light: usize, x: f32, y: f32, z: f32) -> Result<(), JsValue> {
        Ok(self.desk.place_light(light, Vec3::new(x, y, z))?)
    }

    /// Aims a light at a point in metres. This ends a sweep.
    #[wasm_bindgen(js_name = aimLight)]
    pub fn aim_light(&mut self, light: usize, x: f32, y: f32, z: f32) -> Result<(), JsValue> {
        Ok(self.desk.aim_light(light, Vec3::new(x, y, z))?)
    }

    /// Moves a light and its aim back to where the scene has them.
    #[wasm_bindgen(js_name = putBack)]
    pub fn put_back(&mut self, light: usize) -> Result<(), JsValue> {
        Ok(self.desk.put_back(light)?)
    }

    /// Moves a light to a place of the picture, whose width is `aspect` times its height: parallel to
    /// the screen, or level. `x` and `y` are shares of the width and of the height.
    #[wasm_bindgen(js_name = dragLight)]
    pub fn drag_light(
        &mut self,
        light: usize,
        x: f32,
        y: f32,
        aspect: f32,
        is_level: bool,
    ) -> Result<(), JsValue> {
        Ok(self.desk.drag_light(light, [x, y], aspect, is_level)?)
    }

    /// Aims a light at what is seen at a place of the picture. This ends a sweep.
    #[wasm_bindgen(js_name = dragAim)]
    pub fn drag_aim(&mut self, light: usize, x: f32, y: f32, aspect: f32) -> Result<(), JsValue> {
        Ok(self.desk.drag_aim(light, [x, y], aspect)?)
    }

    /// Returns where the lights are in the picture, and the points that they aim at: x and y of each,
    /// as shares of the width and of the height. NaN for what the picture does not have.
    pub fn places(&self, aspect: f32) -> Result<Vec<f32>, JsValue> {
        Ok(flat(self.desk.places(aspect)?.concat()))
    }

    /// Returns the pool of a light in the picture: x and y of each point, as shares. The first two
    /// points are the ends of the lines from the light that enclose the pool, NaN if the light is not
    /// before the camera, and the others the corners of its closed outline. Empty without a pool.
    pub fn pool(&self, light: usize, aspect: f32) -> Result<Vec<f32>, JsValue> {
        Ok(flat(self.desk.pool(light, aspect)?))
    }

    /// Adds a spotlight behind the others, which is in view and lights a surface in view.
    #[wasm_bindgen(js_name = addLight)]
    pub fn add_light(&mut self) -> Result<(), JsValue> {
        Ok(self.desk.add_light()?)
    }

    /// Adds a copy of a light behind it.
    #[wasm_bindgen(js_name = copyLight)]
    pub fn copy_light(&mut self, light: usize) -> Result<(), JsValue> {
        Ok(self.desk.copy_light(light)?)
    }

    /// Removes a light.
    #[wasm_bindgen(js_name = removeLight)]
    pub fn remove_light(&mut self, light: usize) -> Result<(), JsValue> {
        Ok(self.desk.remove_light(light)?)
    }

    /// The edges to choose from: the falloffs of the library, by name.
    pub fn edges() -> Vec<String> {
        edge::all().map(|falloff| falloff.effect().name().to_owned()).collect()
    }

    /// The illuminance in lux that is shown as full scale at the current exposure, on a white surface.
    #[wasm_bindgen(getter, js_name = fullScale)]
    pub fn full_scale(&self) -> f32 {
        photometry::full_scale(self.desk.state().scene) / self.desk.state().exposure.exp2()
    }

    /// Sets the exposure, within its range, so that the middle of a light's pool is shown as full
    /// scale on a white surface.
    #[wasm_bindgen(js_name = exposeFor)]
    pub fn expose_for(&mut self, light: usize) -> Result<(), JsValue> {
        Ok(self.desk.expose_for(light)?)
    }

    /// Evaluates the intensity of a spotlight across its beam, from one side to the other, in the
    /// current number format. Returns pairs of the angle off axis in degrees and the intensity, for
    /// 2 to 10,000 samples, as far as `reach` off the axis or else a little farther than the light;
    /// nothing for another kind of light.
    pub fn curve(&self, light: usize, samples: usize, reach: Option<f32>) -> Result<Vec<f32>, JsValue> {
        Ok(self.trace(light, samples, reach)?)
    }

    /// Evaluates another falloff with the beam angle of a light: `power` of the cosine, `smooth` for
    /// smoothstep or `linear` over the cosine. Returns the same pairs as `curve`; nothing if there is no
    /// such falloff.
    #[wasm_bindgen(js_name = otherCurve)]
    pub fn other_curve(
        &self,
        light: usize,
        samples: usize,
        reach: f32,
        name: &str,
    ) -> Result<Vec<f32>, JsValue> {
        let angles = curve::angles(reach, samples)?;
        let Some(cone) = self.cone(light)? else { return Ok(Vec::new()) };
        Ok(paired(&angles, &curve::other(name, cone.beam().to_degrees(), &angles)?))
    }
}

impl Stage {
    /// The cone of a spotlight.
    fn cone(&self, light: usize) -> Result<Option<Cone<AnyFalloff>>, Refusal> {
        let light = self.desk.rig().described(self.desk.state(), light)?;
        Ok(if let AnyLight::Spot(spot) = light { Some(spot.cone()) } else { None })
    }

    fn trace(&self, light: usize, samples: usize, reach: Option<f32>) -> Result<Vec<f32>, Refusal> {
        let Some(cone) = self.cone(light)? else { return Ok(Vec::new()) };
        let angles = curve::angles(reach.unwrap_or_else(|| curve::reach(&cone)), samples)?;
        Ok(paired(&angles, &self.desk.state().format.intensities(&cone, &angles)?))
    }
}

fn flat(places: Vec<Option<[f32; 2]>>) -> Vec<f32> {
    places.into_iter().flat_map(|place| place.unwrap_or([f32::NAN; 2])).collect()
}

fn paired(angles: &[f32], intensities: &[f32]) -> Vec<f32> {
    angles.iter().zip(intensities).flat_map(|(&angle, &intensity)| [angle, intensity]).collect()
}
