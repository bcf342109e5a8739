//! The spotlight that the options of a command describe, with any falloff and any attenuation.

use luminaire::attenuation::AnyAttenuation;
use luminaire::falloff::AnyFalloff;
use luminaire::{Angle, Rgb, SpotLight};
use luminaire_export::{ExportError, json, words};

use crate::source::Spot;

/// Returns the light, of a linear colour or a colour temperature; without either it is white.
pub(crate) fn light(
    spot: &Spot,
    color: Option<[f32; 3]>,
    kelvin: Option<f32>,
) -> Result<SpotLight<AnyFalloff, AnyAttenuation>, ExportError> {
    let (law, numbers) =
        spot.attenuation.as_ref().map_or(("inverse-square", &[][..]), |law| (&law.name, &law.numbers));
    let window = spot.window.as_deref().unwrap_or("cut");
    let attenuation = words::attenuation(law, numbers, window, spot.range)?;
    let intensity = if law == "none" { 1.0 } else { 16.0 };
    let mut angles = [spot.beam, spot.field, spot.outer].map(|angle| angle.map(Angle::degrees));
    if angles.iter().all(Option::is_none) {
        angles[1] = Some(Angle::degrees(36.0));
    }
    let cone = json::from_angles(spot.falloff, angles, spot.inner, spot.cutoff)?;
    let [red, green, blue] = color.unwrap_or([1.0; 3]);
    let (position, axis) = (spot.position.unwrap_or([0.0; 3]), spot.axis.unwrap_or([0.0, -1.0, 0.0]));
    let light = SpotLight::new(position, axis, cone)?.with_color(Rgb::new(red, green, blue))?;
    let light = light.with_intensity(spot.intensity.unwrap_or(intensity))?.with_attenuation(attenuation);
    Ok(kelvin.map_or(Ok(light), |kelvin| light.with_kelvin(kelvin))?)
}
