//! The kind of a light in place of that of the scene, and the intensity that keeps what arrives.

use luminaire::{
    Error, SpotLight,
    attenuation::{AnyAttenuation, Attenuation, InverseSquare},
    dynamic::{AnyLight, Effect},
    falloff::AnyFalloff,
};

/// A spotlight of any falloff and attenuation.
pub(crate) type AnySpot = SpotLight<AnyFalloff, AnyAttenuation>;

/// The largest intensity that the kernel accepts.
pub(crate) const BRIGHTEST: f32 = 1e9;

/// The kinds of light to choose from.
pub(crate) const KINDS: [Effect; 3] = [Effect::Spot, Effect::Point, Effect::Directional];

/// Returns a light with the colours and the intensity of another one.
pub(crate) fn as_bright(light: AnyLight, other: &AnyLight) -> Result<AnyLight, Error> {
    let light = light.with_color(other.color())?.with_specular_color(other.specular_color())?;
    light.with_intensity(other.intensity())
}

/// Returns the intensity by which a light has the irradiance of `before` at a distance in metres, or
/// the largest that the kernel accepts.
pub(crate) fn kept(before: &AnyLight, after: &AnyLight, distance: f32) -> f32 {
    let factor = arriving(before, distance) / arriving(after, distance);
    (before.intensity() * factor as f32).min(BRIGHTEST)
}

/// Returns what arrives at a distance in metres, as a share of the intensity. A light that ends before it, or so
/// little behind it that no sensible intensity makes up for its loss, counts as one with the inverse square.
pub(crate) fn arriving(light: &AnyLight, distance: f32) -> f64 {
    let attenuation = match light {
        AnyLight::Spot(spot) => spot.attenuation(),
        AnyLight::Point(point) => point.attenuation(),
        AnyLight::Measured(light) => light.attenuation(),
        AnyLight::Directional(_) => return 1.0,
    };
    let is_near_end = attenuation.range().is_some_and(|range| distance > 0.9 * range);
    let share = if is_near_end { 0.0 } else { attenuation.exact(distance.into()) };
    if share > 0.0 { share } else { InverseSquare.exact(distance.into()) }
}
