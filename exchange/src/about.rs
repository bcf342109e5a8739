//! What is known of a light beside it: the member `about` of a document.

use luminaire::Rgb;
use luminaire_export::json::{AMBIENT, NamedAmbient, NamedLight};
use serde::de::{Deserializer, Error as _};
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use crate::curve::{Curve, Definition};
use crate::difference::Difference;
use crate::fit::Fit;
use crate::lamp::{Lamp, Use};
use crate::refusal::Refusal;
use crate::residual::Residual;

/// What a document has of a light beside it. The measured intensities are not in it, so that a reader has no use for
/// what follows from them.
#[derive(Debug, Serialize, Deserialize)]
#[serde(default)]
struct About {
    difference: Difference,
    #[serde(deserialize_with = "exact")]
    full_scale: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    kelvin: Option<f32>,
    #[serde(skip_serializing_if = "is_false")]
    is_assumed: bool,
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    photometry: Option<Photometry>,
    #[serde(skip_deserializing, skip_serializing_if = "Vec::is_empty")]
    fits: Vec<Tried>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
}

#[derive(Debug, Serialize)]
struct Photometry {
    peak_candela: f64,
    lumens: f64,
    ies_degrees: [Option<f64>; 2],
    cie_degrees: [Option<f64>; 2],
}

/// A cone that was tried for measured intensities.
#[derive(Debug, Serialize)]
struct Tried {
    name: &'static str,
    found_codes: f64,
    bound_codes: f64,
    half_degrees: f64,
}

impl Default for About {
    fn default() -> Self {
        Self {
            difference: Difference::default(),
            full_scale: 1.0,
            kelvin: None,
            is_assumed: false,
            photometry: None,
            fits: Vec::new(),
            notes: Vec::new(),
        }
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it with a reference")]
fn is_false(value: &bool) -> bool {
    !value
}

/// Reads a number with all its bits, of which serde's own reader may lose the last.
fn exact<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    let number = <&RawValue>::deserialize(from)?.get().parse().map_err(D::Error::custom)?;
    let is_scale = number > 0.0 && number <= 1e18;
    is_scale.then_some(number).ok_or_else(|| D::Error::custom("expected a number over 0 and at most 1e18"))
}

/// Reads what another program may have written in any other shape, which says nothing then.
fn any_shape<'de, D: Deserializer<'de>>(from: D) -> Result<Option<About>, D::Error> {
    Ok(serde_json::from_str(<&RawValue>::deserialize(from)?.get()).ok())
}

impl About {
    /// Returns what is known of a light that is written in the unit of full scale of a use.
    fn of(lamp: &Lamp, usage: Use) -> Self {
        let photometry = |curve: &Curve| {
            let angles = |definition| [0.5, 0.1].map(|share| curve.angle(share, definition));
            Photometry {
                peak_candela: curve.peak().0,
                lumens: curve.lumens(),
                ies_degrees: angles(Definition::Ies),
                cie_degrees: angles(Definition::Cie),
            }
        };
        let tried = |fit: &Fit| {
            let Residual { found, bound, degrees, .. } = fit.residual;
            Tried { name: fit.name, found_codes: found, bound_codes: bound, half_degrees: degrees }
        };
        Self {
            difference: lamp.difference,
            full_scale: lamp.full_scale * usage.full_scale,
            kelvin: lamp.kelvin,
            is_assumed: lamp.is_assumed,
            photometry: lamp.measured.as_ref().map(photometry),
            fits: lamp.fits.iter().map(tried).collect(),
            notes: lamp.notes.clone(),
        }
    }

    /// Returns a light of a document with what is known of it. The colour is that of the light: a temperature of a
    /// different white is left out, with a note.
    fn lamp(self, named: NamedLight) -> Lamp {
        let Self { difference, full_scale, kelvin, is_assumed, notes, .. } = self;
        let Difference { angle, place, distance } = difference;
        let is_part = [angle, place, distance].iter().all(|part| (0.0..=1.0).contains(part));
        let mut lamp = Lamp { full_scale, is_assumed, notes, ..Lamp::new(named.name, named.light) };
        lamp.surfaces = named.surfaces;
        if is_part {
            lamp.difference = difference;
        }
        if let Some(kelvin) = kelvin {
            if is_white(lamp.light.color(), kelvin) {
                lamp.kelvin = Some(kelvin);
            } else {
                lamp.notes.push(format!("the light's color is not the white of about.kelvin = {kelvin}"));
            }
        }
        lamp
    }
}

impl Lamp {
    /// Returns the light in the unit of full scale, with what is known of it as JSON has it: the
    /// differences, the notes, and of a measured light its photometry.
    ///
    /// # Errors
    /// An intensity outside [0, 1e9] in that unit.
    pub fn named(&self, usage: Use) -> Result<NamedLight, Refusal> {
        let intensity = (f64::from(self.light.intensity()) / usage.full_scale) as f32;
        let light = self.light.with_intensity(intensity)?;
        let about = serde_json::to_value(About::of(self, usage)).ok();
        Ok(NamedLight { name: self.name.clone(), light, surfaces: self.surfaces, about })
    }
}

impl Use {
    /// Returns ambient light in the unit of full scale.
    ///
    /// # Errors
    /// An intensity outside [0, 1e9] in that unit.
    pub fn ambient(self, NamedAmbient { name, light }: &NamedAmbient) -> Result<NamedAmbient, Refusal> {
        let intensity = (f64::from(light.intensity()) / self.full_scale) as f32;
        Ok(NamedAmbient { name: name.clone(), light: light.with_intensity(intensity)? })
    }
}

/// Returns whether a colour is the white of a temperature, with its strongest channel at 1.
fn is_white(color: Rgb<f32>, kelvin: f32) -> bool {
    let Ok(white) = Rgb::from_kelvin(kelvin) else { return false };
    let apart = color.zip(white.map(|channel| channel / white.strongest()), |own, white| (own - white).abs());
    apart.strongest() < 1e-3
}

/// Returns the lights of a document but for its ambient light, which [`json::read`](luminaire_export::json::read) has
/// read, with what the text has of each beside it.
pub(crate) fn lamps(text: &str, lights: Vec<NamedLight>) -> Vec<Lamp> {
    #[derive(Deserialize)]
    struct Document {
        lights: Vec<Light>,
    }
    #[derive(Default, Deserialize)]
    #[serde(default)]
    struct Light {
        kind: String,
        #[serde(deserialize_with = "any_shape")]
        about: Option<About>,
    }
    let known = serde_json::from_str(text).map_or_else(|_| Vec::new(), |Document { lights }| lights);
    let known = known.into_iter().filter(|light| light.kind != AMBIENT);
    let known = known.map(|light| light.about.unwrap_or_default());
    let known = known.chain(std::iter::repeat_with(About::default));
    lights.into_iter().zip(known).map(|(named, about)| about.lamp(named)).collect()
}
