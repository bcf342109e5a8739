//! The light that reaches LEDs at their places.

use luminaire::dynamic::AnyLight;
use luminaire::{Fx16, Scalar, Vec3};
use luminaire_exchange::Refusal;
use luminaire_exchange::leds::PlacedLeds;

/// Returns how many LEDs have light other than the ambient one.
pub(super) fn lit<'a>(
    leds: &PlacedLeds,
    lights: impl Iterator<Item = &'a AnyLight>,
) -> Result<usize, Refusal> {
    let lights = lights.map(AnyLight::compile::<f32>).collect::<Result<Vec<_>, _>>()?;
    let vector = |own: [f64; 3]| Vec3::from(own.map(|c| c as f32));
    let is_lit = |led: &usize| {
        let place = vector(leds.places[*led]);
        let facing = leds.facing.as_ref().map(|facing| vector(facing[*led]));
        lights.iter().any(|light| {
            let facing = facing.map(|facing| light.irradiance(place, facing));
            facing.unwrap_or_else(|| light.irradiance_facing(place)) > 0.0
        })
    };
    Ok((0..leds.places.len()).filter(is_lit).count())
}

/// Refuses a light whose position would leave the coordinates of the format as it turns about the LEDs.
pub(super) fn check_turn(leds: &PlacedLeds, light: &AnyLight) -> Result<(), Refusal> {
    let position = match light {
        AnyLight::Spot(light) => light.position(),
        AnyLight::Point(light) => light.position(),
        AnyLight::Measured(light) => light.position(),
        AnyLight::Directional(_) => return Ok(()),
    };
    let [x, z] = leds.middle;
    let distance = (f64::from(position.x) - x).hypot(f64::from(position.z) - z);
    let most = f64::from(Fx16::FARTHEST) - x.abs().max(z.abs());
    if distance <= most {
        return Ok(());
    }
    let expected = format_args!(
        "at most {most} for a light that turns about them: --turn 0 lets it stand still, or place it nearer"
    );
    Err(Refusal::new("distance from the middle of the LEDs", distance, expected))
}
