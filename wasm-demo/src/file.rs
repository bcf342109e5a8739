//! The JavaScript class of a file of another tool: its lights, for the page.

use crate::{light::hex_of, own_cone, plain::plain, refusal::Refusal};
use luminaire::{Angle, Cone, dynamic::AnyLight, falloff::AnyFalloff, projector::Projection};
use luminaire_exchange::{self as exchange, Curve, Definition, Lamp, Lamps, Residual, Use, share};
use wasm_bindgen::prelude::*;
use web_sys::js_sys::{Array, Float32Array};

/// Largest difference of a cheaper cone from a measured light, in linear codes: that of the command.
const TOLERANCE: f64 = 1.0;

/// Samples of the curve of a light.
const SAMPLES: u16 = 240;

/// A file of another tool with its lights.
#[wasm_bindgen]
#[derive(Debug)]
pub struct LightFile {
    lamps: Lamps,
    usage: Use,
}

#[wasm_bindgen]
impl LightFile {
    /// Reads a file. `throw` is the distance in metres of the surface that counts.
    ///
    /// # Errors
    /// What the reader does not accept, in its words.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str, bytes: &[u8], throw: f64) -> Result<Self, Refusal> {
        let lamps = exchange::read(name, bytes, None, TOLERANCE)?;
        Ok(Self { usage: lamps.usage(throw), lamps })
    }

    /// The lights, in the order of the file.
    #[wasm_bindgen(unchecked_return_type = "FileLight[]")]
    pub fn lights(&self) -> Vec<JsValue> {
        self.lamps.lamps.iter().map(|lamp| light(lamp, self.usage, lamp.curve().as_ref())).collect()
    }

    /// The lights of the file that could not be read, in the words of the reader.
    pub fn refused(&self) -> Vec<String> {
        self.lamps.refused.iter().map(ToString::to_string).collect()
    }

    /// What holds for the whole file, a sentence each.
    pub fn notes(&self) -> Vec<String> {
        self.lamps.notes.clone()
    }

    /// Returns the parameters of a light in a tool, a line each, and then sentences about their difference and
    /// about the tool.
    ///
    /// # Errors
    /// A light or a tool that does not have them.
    pub fn parameters(&self, light: usize, tool: &str) -> Result<Vec<String>, Refusal> {
        let lamps = &self.lamps.lamps;
        let lamp = lamps.get(light).ok_or_else(|| Refusal::light(light, lamps.len()))?;
        let found = exchange::parameters(lamp, tool.parse()?, self.usage)?;
        let Residual { bound, degrees, .. } = found.angle;
        let lines = found.values.iter().map(|(key, value)| format!("{key}={value}\n"));
        let lines = format!("# system: {tool}\n{}", lines.collect::<String>());
        let angle =
            format!("Within {bound:.2} of 255 codes over the angle, most at {degrees:.1}° off the axis.");
        let distance = format!("Within {:.2} of 255 codes over the distance.", found.distance);
        Ok([lines, angle, distance].into_iter().chain(found.notes.into_iter().map(String::from)).collect())
    }
}

plain! {
    /// A light of a file. Angles are in degrees and differences in linear codes; curves are pairs of an
    /// angle off the axis and a share of the largest intensity. `cone` is empty unless it is a spotlight,
    /// and `fit` unless it was measured. `residual` has the bound of the difference and, of a fit, the
    /// largest one that was found, its angle and both shares there.
    fn light(lamp: &Lamp, usage: Use, curve: Option<&Curve>) -> FileLight {
        "name": "string" = lamp.name.clone(),
        "cone": "string" = staged(lamp, curve).map_or(String::new(), |cone| own_cone::write(&cone)),
        "color": "string" = hex_of(lamp.light.color()),
        "intensity": "number" = lamp.light.intensity(),
        "isCandela": "boolean" = usage.is_photometric,
        "lumens": "number | undefined" = curve.map(Curve::lumens),
        "throw": "number" = usage.throw,
        "lux": "number" = lamp.at(usage.throw) * curve.map_or(1.0, |curve| curve.at(0.0) / curve.peak().0),
        "angles": "Float32Array" = numbers(curve.into_iter().flat_map(angles)),
        "fit": "string" = lamp.fits.last().map_or("", |fit| fit.name),
        "residual": "Float32Array" = numbers(residual(lamp)),
        "distance": "number" = lamp.difference.distance,
        "measured": "Float32Array" = numbers(lamp.measured.iter().flat_map(shares)),
        "fitted": "Float32Array" = numbers(fitted(lamp, curve)),
        "notes": "string[]" = notes(lamp, curve),
    }
}

/// The cone of a spotlight.
fn cone(lamp: &Lamp) -> Option<Cone<AnyFalloff>> {
    if let AnyLight::Spot(spot) = &lamp.light { Some(spot.cone()) } else { None }
}

/// The cone for a light of the stage, whose shadow map and gobo span all of it: a table ends where it is half
/// a code, and no cone is wider than a map can be.
fn staged(lamp: &Lamp, curve: Option<&Curve>) -> Option<Cone<AnyFalloff>> {
    let cone = cone(lamp)?;
    let table = curve.filter(|_| matches!(cone.falloff(), AnyFalloff::Table(_)));
    let faint = table.and_then(|curve| curve.angle(0.5 / 255.0, Definition::Ies));
    let faint = faint.map(|full| Angle::degrees(full as f32)).filter(|full| *full < Projection::WIDEST);
    let end = faint.unwrap_or(Projection::WIDEST);
    if end < cone.outer() { cone.with_cutoff(end).ok() } else { Some(cone) }
}

/// What was assumed or left out, with what the stage leaves out.
fn notes(lamp: &Lamp, curve: Option<&Curve>) -> Array {
    let cut = staged(lamp, curve).filter(|staged| cone(lamp).is_some_and(|cone| cone != *staged));
    let end = cut.map(|cut| {
        format!("On the stage the light ends {:.1}° off the axis.", cut.outer().to_degrees() / 2.0)
    });
    lamp.notes.iter().chain(&end).map(JsValue::from).collect()
}

/// The beam angle and the field angle.
fn angles(curve: &Curve) -> Vec<f64> {
    [0.5, 0.1].iter().filter_map(|share| curve.angle(*share, Definition::Ies)).collect()
}

fn residual(lamp: &Lamp) -> Vec<f64> {
    let Some(Residual { found, bound, degrees, measured, fitted }) = lamp.fits.last().map(|fit| fit.residual)
    else {
        return vec![255.0 * f64::from(lamp.difference.angle)];
    };
    vec![bound, found, degrees, measured, fitted]
}

/// The points of measured intensities.
fn shares(curve: &Curve) -> impl Iterator<Item = f64> {
    curve.points().iter().flat_map(|&(degrees, candela)| [degrees, candela / curve.peak().0])
}

/// Points of the cone, to a little farther than its light and the measured one, but not far beyond the
/// field angle unless the largest difference is there.
fn fitted(lamp: &Lamp, curve: Option<&Curve>) -> Vec<f64> {
    let (Some(cone), Some(curve)) = (cone(lamp), curve) else { return Vec::new() };
    let worst = lamp.fits.last().map_or(0.0, |fit| fit.residual.degrees);
    let field = angles(curve).last().copied().unwrap_or_default();
    let end = curve.end().max(f64::from(cone.outer().to_degrees()) / 2.0).min(field).max(worst);
    let angle = |i: u16| 1.05 * end * f64::from(i) / f64::from(SAMPLES);
    (0..=SAMPLES).map(angle).flat_map(|degrees| [degrees, share(&cone, degrees)]).collect()
}

fn numbers(values: impl IntoIterator<Item = f64>) -> Float32Array {
    values.into_iter().map(|value| value as f32).collect::<Vec<_>>().as_slice().into()
}
