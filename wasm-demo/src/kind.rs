//! The kind of a light and its law of distance, in place of those of the scene.

use crate::{
    plain::plain,
    quantity::{CONSTANT, LINEAR, QUADRATIC, Quantity},
    refusal::Refusal,
};
use luminaire::{
    Error, SpotLight,
    attenuation::{AnyAttenuation, Attenuation, InverseSquare, NoAttenuation, Polynomial},
    dynamic::{AnyLight, Effect},
    falloff::AnyFalloff,
};

/// A spotlight of any falloff and attenuation.
pub(crate) type AnySpot = SpotLight<AnyFalloff, AnyAttenuation>;

/// The largest intensity that the kernel accepts.
pub(crate) const BRIGHTEST: f32 = 1e9;

/// The kinds of light to choose from.
pub(crate) const KINDS: [Effect; 3] = [Effect::Spot, Effect::Point, Effect::Directional];

/// The constants of the polynomial of the distance.
pub(crate) const CONSTANTS: [Quantity; 3] = [CONSTANT, LINEAR, QUADRATIC];

/// Returns the law of distance of this name; `None` for that of the scene. The polynomial begins as
/// the inverse square, capped at 1.
pub(crate) fn law_named(name: &str) -> Result<Option<AnyAttenuation>, Refusal> {
    Ok(Some(match name {
        "own" => return Ok(None),
        "unattenuated" => NoAttenuation.into(),
        "inverse-square" => InverseSquare.into(),
        "polynomial" => polynomial([0.0, 0.0, 1.0])?,
        _ => return Err(Refusal::name("law", name, "own, unattenuated, inverse-square or polynomial")),
    }))
}

/// The name that [`law_named`] accepts.
pub(crate) fn law_name(law: Option<AnyAttenuation>) -> &'static str {
    law.and_then(|law| law.effects().iter().next()).map_or("own", Effect::name)
}

/// Returns `1 / (a + b d + c d^2)`, capped at 1. Each constant is within the ends of its dial.
pub(crate) fn polynomial(constants: [f32; 3]) -> Result<AnyAttenuation, Refusal> {
    for (Quantity { label, ends, .. }, value) in CONSTANTS.iter().zip(constants) {
        if !(ends[0]..=ends[1]).contains(&value) {
            return Err(Refusal::outside(label, value, *ends, "in 1/(a + b d + c d²)"));
        }
    }
    let [a, b, c] = constants;
    Ok(Polynomial::new(a, b, c)?.into())
}

/// The constants of a polynomial; `None` for another law.
pub(crate) fn constants_of(law: Option<AnyAttenuation>) -> Option<[f32; 3]> {
    if let AnyAttenuation::Polynomial(law) = law? { Some(law.attenuation().coefficients()) } else { None }
}

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

/// Returns what arrives at a distance in metres, as a share of the intensity. A light that ends before
/// counts as one without an end.
pub(crate) fn arriving(light: &AnyLight, distance: f32) -> f64 {
    let attenuation = match light {
        AnyLight::Spot(spot) => spot.attenuation(),
        AnyLight::Point(point) => point.attenuation(),
        AnyLight::Directional(_) => return 1.0,
    };
    let share = attenuation.exact(distance.into());
    if share > 0.0 { share } else { InverseSquare.exact(distance.into()) }
}

plain! {
    /// The dial of a constant of the law of distance, which accepts both ends: see [`Quantity`].
    fn constant(quantity: Quantity) -> ConstantState {
        "name": "string" = quantity.name,
        "label": "string" = quantity.label,
        "unit": "string" = quantity.unit,
        "least": "number" = quantity.ends[0],
        "most": "number" = quantity.ends[1],
        "isLogarithmic": "boolean" = quantity.is_logarithmic,
    }
}
