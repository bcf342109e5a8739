//! The parameters of a light.

use luminaire::attenuation::{AnyAttenuation, Attenuation, Describe};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff, Formula};
use luminaire::{Cone, Rgb, Vec3};
use serde::Serialize;
use serde_json::{Map, Value};

use crate::error::ExportError;

/// A light as JSON has it: the crate's documentation lists the members.
#[derive(Debug, Serialize)]
struct Light<'a> {
    format: &'static str,
    name: &'a str,
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<[f32; 3]>,
    /// The axis of a spotlight, or the direction of a directional light.
    #[serde(skip_serializing_if = "Option::is_none")]
    axis: Option<[f32; 3]>,
    color: [f32; 3],
    specular_color: [f32; 3],
    intensity: f32,
    #[serde(skip_serializing_if = "Option::is_none")]
    cone: Option<Shape>,
    #[serde(skip_serializing_if = "Option::is_none")]
    attenuation: Option<Description>,
}

#[derive(Debug, Serialize)]
struct Shape {
    beam_degrees: f32,
    field_degrees: f32,
    outer_degrees: f32,
    inner_degrees: f32,
    inner_versine: f32,
    outer_versine: f32,
    #[serde(skip_serializing_if = "Option::is_none")]
    cutoff_versine: Option<f32>,
    falloff: Profile,
}

#[derive(Debug, Serialize)]
struct Profile {
    name: &'static str,
    #[serde(flatten)]
    parameters: Parameters,
}

/// The parameters of a formula; the formulas are those of [`Formula`].
#[derive(Debug, Serialize)]
#[serde(tag = "formula", rename_all = "kebab-case")]
enum Parameters {
    Step,
    Polynomial {
        coefficients: [f32; 3],
    },
    Power {
        exponent: f32,
    },
    InvertedPower {
        exponent: f32,
        floor: f32,
    },
    Samples {
        samples: Vec<u16>,
    },
    Knots {
        knots: Vec<(u16, u16, i32)>,
    },
    /// A function without parameters: its name says which.
    Named,
}

/// An attenuation as JSON has it.
#[derive(Clone, Debug, Default, Serialize)]
struct Description {
    /// The law without a window.
    law: String,
    /// The parameters of the law by name: a number, or an array.
    #[serde(flatten)]
    parameters: Map<String, Value>,
    /// The window that ends the law at the range.
    #[serde(skip_serializing_if = "Option::is_none")]
    window: Option<String>,
    /// The range of the window.
    #[serde(skip_serializing_if = "Option::is_none")]
    range: Option<f32>,
}

impl Description {
    fn of(attenuation: AnyAttenuation) -> Self {
        let mut description = Self::default();
        attenuation.describe(&mut description);
        description
    }
}

/// Returns the number with the digits that an `f32` needs.
fn shortest(value: f32) -> Value {
    format!("{value:?}").parse::<f64>().unwrap_or(value.into()).into()
}

impl Describe for Description {
    fn law(&mut self, _: &str, law: &str, arguments: &[(&str, &[f32])]) {
        law.clone_into(&mut self.law);
        for &(name, values) in arguments {
            let mut values: Vec<_> = values.iter().map(|&value| shortest(value)).collect();
            let value = if values.len() == 1 { values.remove(0) } else { values.into() };
            self.parameters.insert(name.to_owned(), value);
        }
    }

    fn window(&mut self, _: &str, window: &str, range: Option<f32>) {
        if range.is_some() {
            (self.window, self.range) = (Some(window.to_owned()), range);
        }
    }
}

/// Returns a light as JSON.
pub(crate) fn export(light: &AnyLight, name: &str) -> Result<String, ExportError> {
    let triple = |color: Rgb<f32>| [color.red, color.green, color.blue];
    let xyz = |vector: Vec3<f32>| -> Option<[f32; 3]> { Some(vector.into()) };
    let mut described = Light {
        format: "luminaire-light-1",
        name,
        kind: "spot",
        position: None,
        axis: None,
        color: triple(light.color()),
        specular_color: triple(light.specular_color()),
        intensity: light.intensity(),
        cone: None,
        attenuation: None,
    };
    match light {
        AnyLight::Spot(spot) => {
            described.position = xyz(spot.position());
            described.axis = xyz(spot.axis());
            described.cone = Some(shape(&spot.cone()));
            described.attenuation = Some(Description::of(spot.attenuation()));
        }
        AnyLight::Point(point) => {
            described.kind = "point";
            described.position = xyz(point.position());
            described.attenuation = Some(Description::of(point.attenuation()));
        }
        AnyLight::Directional(directional) => {
            described.kind = "directional";
            described.axis = xyz(directional.direction());
        }
    }
    let json = serde_json::to_string_pretty(&described);
    json.map(|text| text + "\n").map_err(|error| ExportError::new("light", name, error.to_string()))
}

fn shape(cone: &Cone<AnyFalloff>) -> Shape {
    let [inner_versine, outer_versine, limit] = cone.versines();
    Shape {
        beam_degrees: cone.beam().to_degrees(),
        field_degrees: cone.field().to_degrees(),
        outer_degrees: cone.outer().to_degrees(),
        inner_degrees: cone.inner().to_degrees(),
        inner_versine,
        outer_versine,
        cutoff_versine: cone.has_cutoff().then_some(limit),
        falloff: Profile { name: cone.falloff().effect().name(), parameters: parameters(cone.falloff()) },
    }
}

fn parameters(falloff: AnyFalloff) -> Parameters {
    match falloff.formula() {
        Formula::Step => Parameters::Step,
        Formula::Polynomial(coefficients) => Parameters::Polynomial { coefficients },
        Formula::Power(exponent) => Parameters::Power { exponent },
        Formula::InvertedPower(exponent, floor) => Parameters::InvertedPower { exponent, floor },
        Formula::Samples(samples) => Parameters::Samples { samples: samples.to_vec() },
        Formula::Knots(knots) => {
            Parameters::Knots { knots: knots.iter().map(|knot| knot.to_bits()).collect() }
        }
        _ => Parameters::Named,
    }
}
