//! The lights of the stage, for JavaScript.

use super::Stage;
use crate::{curve, model, photometry, refusal::Refusal};
use luminaire::{Cone, Vec3, attenuation::AnyAttenuation, dynamic::AnyLight, falloff::AnyFalloff};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Stage {
    /// How many lights there are.
    #[wasm_bindgen(getter, js_name = lightCount)]
    pub fn light_count(&self) -> usize {
        self.state.lights.len()
    }

    /// Moves a light to a position in metres.
    #[wasm_bindgen(js_name = placeLight)]
    pub fn place_light(&mut self, light: usize, x: f32, y: f32, z: f32) -> Result<(), Refusal> {
        self.place(light, self.point("position", [x, y, z])?)
    }

    /// Aims a light at a point in metres. This ends a sweep.
    #[wasm_bindgen(js_name = aimLight)]
    pub fn aim_light(&mut self, light: usize, x: f32, y: f32, z: f32) -> Result<(), Refusal> {
        let target = self.point("aim", [x, y, z])?;
        let refused = self.aim(light, target);
        let is_own = self.light_state(light)?.position == [x, y, z];
        let told = |_| Refusal("aim = the position of the light: expected another point".to_owned());
        if is_own { refused.map_err(told) } else { refused }
    }

    /// Returns where the lights are in the picture, and the points that they aim at: x and y of each,
    /// as shares of the width and of the height. NaN for what the picture does not have.
    #[wasm_bindgen(js_name = places)]
    pub fn flat_places(&self, aspect: f32) -> Result<Vec<f32>, Refusal> {
        Ok(flat(self.places(aspect)?.concat()))
    }

    /// Returns the pool of a light in the picture: x and y of each point, as shares. The first two
    /// points are the ends of the lines from the light that enclose the pool, NaN if the light is not
    /// before the camera, and the others the corners of its outline: closed, or with NaN after each of its
    /// pieces. Empty without a pool.
    #[wasm_bindgen(js_name = pool)]
    pub fn flat_pool(&self, light: usize, aspect: f32) -> Result<Vec<f32>, Refusal> {
        Ok(flat(self.pool(light, aspect)?))
    }

    /// The edges to choose from: the falloffs of the library.
    #[wasm_bindgen(unchecked_return_type = "ModelState[]")]
    pub fn edges() -> Vec<JsValue> {
        model::listed::<AnyFalloff>()
    }

    /// The laws of distance to choose from.
    #[wasm_bindgen(unchecked_return_type = "ModelState[]")]
    pub fn laws() -> Vec<JsValue> {
        model::listed::<AnyAttenuation>()
    }

    /// The largest coordinate of a place in the current number format, in metres, of either sign.
    #[wasm_bindgen(getter)]
    pub fn farthest(&self) -> f32 {
        self.state.format.farthest()
    }

    /// The illuminance in lux that is shown as full scale at the current exposure, on a white surface.
    #[wasm_bindgen(getter, js_name = fullScale)]
    pub fn full_scale(&self) -> f32 {
        photometry::full_scale(self.state.scene) / self.state.exposure.exp2()
    }

    /// Evaluates the intensity of a spotlight across its beam, from one side to the other, in the
    /// current number format. Returns pairs of the angle off axis in degrees and the intensity, for
    /// 2 to 10,000 samples, as far as `reach` off the axis or else a little farther than the light;
    /// nothing for another kind of light.
    pub fn curve(&self, light: usize, samples: usize, reach: Option<f32>) -> Result<Vec<f32>, Refusal> {
        let Some(cone) = self.cone(light)? else { return Ok(Vec::new()) };
        let angles = curve::angles(reach.unwrap_or_else(|| curve::reach(&cone)), samples)?;
        Ok(paired(&angles, &self.state.format.intensities(&cone, &angles)?))
    }
}

impl Stage {
    /// A point with these coordinates in metres, as far as the number format holds it. The kernel would name what follows
    /// from it, such as an axis.
    fn point(&self, name: &str, coordinates: [f32; 3]) -> Result<Vec3<f32>, Refusal> {
        let most = self.state.format.farthest();
        for (axis, value) in ["x", "y", "z"].into_iter().zip(coordinates) {
            if !(-most..=most).contains(&value) {
                return Err(Refusal::outside(&format!("{name} {axis}"), value, [-most, most], "metres"));
            }
        }
        Ok(coordinates.into())
    }

    /// The cone of a spotlight.
    fn cone(&self, light: usize) -> Result<Option<Cone<AnyFalloff>>, Refusal> {
        let light = self.rig.described(&self.state, light)?;
        Ok(if let AnyLight::Spot(spot) = light { Some(spot.cone()) } else { None })
    }
}

fn flat(places: Vec<Option<[f32; 2]>>) -> Vec<f32> {
    places.into_iter().flat_map(|place| place.unwrap_or([f32::NAN; 2])).collect()
}

fn paired(angles: &[f32], intensities: &[f32]) -> Vec<f32> {
    angles.iter().zip(intensities).flat_map(|(&angle, &intensity)| [angle, intensity]).collect()
}
