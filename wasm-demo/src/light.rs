//! A light for the page: plain values, as the kernel computed them.

use luminaire::{Rgb, Vec3, display::encode_srgb, dynamic::AnyLight};
use wasm_bindgen::prelude::*;

/// State of a light for the page, with the values that the kernel computed and not those that the
/// visitor typed. Only a spotlight has angles; those of other lights are 0.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, PartialEq, Default, Debug)]
pub struct LightState {
    /// The stage-lighting name of this kind of fixture.
    pub name: String,
    /// The kind: `spot`, `point` or `directional`, or `own` for that of the scene.
    pub kind: String,
    /// The law of distance that the visitor has chosen, or `own`.
    pub law: String,
    /// The numbers of this law; empty for `own`.
    #[wasm_bindgen(js_name = lawNumbers)]
    pub law_numbers: Vec<f32>,
    /// Whether it is a spotlight.
    #[wasm_bindgen(js_name = isSpot)]
    pub is_spot: bool,
    /// The full beam angle in degrees.
    pub beam: f32,
    /// The full field angle in degrees.
    pub field: f32,
    /// The full outer angle in degrees.
    pub outer: f32,
    /// The least and the largest beam angle with this field angle, and the least and the largest
    /// field angle with this beam angle, over all edges, in degrees. Empty if there are none.
    pub reach: Vec<f32>,
    /// The name of the falloff that the visitor has chosen, that of both angles, or `own`.
    pub edge: String,
    /// The numbers of the falloff that the visitor has chosen; empty for that of both angles and `own`.
    #[wasm_bindgen(js_name = edgeNumbers)]
    pub edge_numbers: Vec<f32>,
    /// The name of the scene's own falloff of the light.
    #[wasm_bindgen(js_name = ownEdge)]
    pub own_edge: String,
    /// The colour as `#rrggbb`, sRGB.
    pub color: String,
    /// The colour temperature in kelvin that the visitor has chosen.
    pub kelvin: Option<f32>,
    /// The intensity on the axis in `unit`.
    pub intensity: f32,
    /// The same of the strongest channel: more, if the colour is that of a temperature.
    pub strongest: f32,
    /// `cd`, or `lx` for a directional light.
    pub unit: String,
    /// The luminous flux in lumens; nothing for a directional light.
    pub lumens: Option<f32>,
    /// The distance in metres to the surface that the light aims at; nothing without one.
    pub throw: Option<f32>,
    /// The illuminance in lux there, of a surface that faces the light.
    pub lux: Option<f32>,
    /// The position: x, y and z in metres. Empty for a directional light.
    pub position: Vec<f32>,
    /// The point that the light aims at: x, y and z in metres. Empty unless it is a spotlight.
    pub aim: Vec<f32>,
    /// Whether the scene moves the aim of the light.
    pub sweeps: bool,
    /// Whether the visitor has moved or aimed the light.
    pub moved: bool,
    /// Whether the light is switched on.
    pub on: bool,
    /// The name of the fixture whose angle the light has; empty if it has none.
    pub fixture: String,
    /// How a published angle is interpreted: as `beam` or `field` angle.
    pub reading: String,
    /// The fixture's published angle; nothing without a fixture.
    pub zoom: Option<f32>,
}

/// The ends of the dials of a light: the least and the largest value of each, both of which are
/// accepted. Empty for a dial that the light does not have.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, PartialEq, Default, Debug)]
pub struct DialEnds {
    /// Of the full beam angle in degrees.
    pub beam: Vec<f32>,
    /// Of the full field angle in degrees.
    pub field: Vec<f32>,
    /// Of the fixture's published angle in degrees.
    pub zoom: Vec<f32>,
    /// Of the intensity on the axis, in the unit of the light.
    pub intensity: Vec<f32>,
    /// Of the colour temperature in kelvin.
    pub kelvin: Vec<f32>,
    /// Of each number of the law of distance, one after the other.
    pub law: Vec<f32>,
    /// Of each number of the edge.
    pub edge: Vec<f32>,
}

/// The position of a light; `None` for a directional light.
pub(crate) fn position_of(light: &AnyLight) -> Option<Vec3<f32>> {
    match light {
        AnyLight::Spot(spot) => Some(spot.position()),
        AnyLight::Point(point) => Some(point.position()),
        AnyLight::Measured(light) => Some(light.position()),
        AnyLight::Directional(_) => None,
    }
}

/// The luminous flux of an intensity in candela; `None` for a measured or a directional light.
pub(crate) fn lumens_of(light: &AnyLight, candela: f32) -> Option<f32> {
    match light {
        AnyLight::Spot(spot) => Some(spot.cone().lumens(candela)),
        AnyLight::Point(point) => Some(point.lumens(candela)),
        AnyLight::Measured(_) | AnyLight::Directional(_) => None,
    }
}

/// A colour as `#rrggbb` in sRGB.
pub(crate) fn hex_of(color: Rgb<f32>) -> String {
    let Rgb { red, green, blue } = color.map(encode_srgb);
    format!("#{red:02x}{green:02x}{blue:02x}")
}
