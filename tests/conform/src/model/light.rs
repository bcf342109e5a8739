//! Lights of every kind, from their description to the light that arrives.

use luminaire::{
    AmbientLight, Cone, DirectionalLight, Error, MeasuredLight, PointLight, SpotLight,
    attenuation::{Attenuation, NoAttenuation},
    falloff::{Falloff, Soft},
    light::{Distribution, Symmetry},
    number::Quick,
};

use super::falloff::Description;
use crate::case::{Case, Outcome};
use crate::word::Format;

/// The falloff and the light at a point.
pub(super) fn spot<S: Format, P: Falloff>(
    case: &mut Case<'_>,
    falloff: impl Fn(&mut Case<'_>) -> Result<P, Error>,
) -> Outcome {
    let description = Description::of(case, falloff);
    let (position, axis, intensity) =
        (case.vector("position"), case.vector("axis"), case.number("intensity"));
    let (point, normal) = (case.point::<S>("point"), case.normal::<S>("normal"));
    let spot = SpotLight::new(position, axis, description.cone()?)?.with_intensity(intensity)?;
    let light = spot.compile::<S>()?;
    case.give(light.falloff_at(point));
    case.give(light.irradiance(point, normal));
    Ok(())
}

/// The light at a point by the quick evaluation, level and attenuated.
pub(super) fn quick<S: Format + Quick, P: Falloff>(case: &mut Case<'_>, falloff: P) -> Outcome {
    let description = Description::of(case, |_| Ok(falloff));
    let (position, axis, intensity) =
        (case.vector("position"), case.vector("axis"), case.number("intensity"));
    let (point, normal) = (case.point::<S>("point"), case.normal::<S>("normal"));
    let spot = SpotLight::new(position, axis, description.cone()?)?.with_intensity(intensity)?;
    case.give(spot.with_attenuation(NoAttenuation).compile_quick::<S>()?.irradiance(point, normal));
    case.give(spot.compile_quick::<S>()?.irradiance(point, normal));
    Ok(())
}

/// The light at a point of a spotlight with a soft edge that ends smoothly at its end point.
pub(super) fn between<S: Format>(case: &mut Case<'_>) -> Outcome {
    let description = Description::of(case, |_| Ok(Soft));
    let (position, end) = (case.vector("position"), case.vector("end"));
    let (point, normal) = (case.point::<S>("point"), case.normal::<S>("normal"));
    let cone: Cone<Soft> = description.cone()?;
    let light = SpotLight::between(position, end, cone)?.compile::<S>()?;
    case.give(light.irradiance(point, normal));
    Ok(())
}

/// The light at a point.
pub(super) fn point<S: Format, A: Attenuation>(
    case: &mut Case<'_>,
    attenuation: impl Fn(&mut Case<'_>) -> Result<A, Error>,
) -> Outcome {
    let attenuation = attenuation(case);
    let (position, intensity) = (case.vector("position"), case.number("intensity"));
    let (point, normal) = (case.point::<S>("point"), case.normal::<S>("normal"));
    let light = PointLight::new(position)?.with_intensity(intensity)?.with_attenuation(attenuation?);
    case.give(light.compile::<S>()?.irradiance(point, normal));
    Ok(())
}

/// The samples of a distribution of size 5 about one plane: of steep cells, and of level ones.
pub(super) static STEEP: [u16; 15] = [65_535, 3, 40_000, 0, 7, 9, 1, 40_000, 0, 7, 65_535, 3, 1, 3, 65_535];
pub(super) static LEVEL: [u16; 15] = [
    60_001, 61_002, 65_535, 62_003, 59_004, 60_005, 61_006, 62_007, 61_008, 60_009, 58_010, 57_011, 57_012,
    57_011, 58_010,
];

/// The light at a point of a measured light.
pub(super) fn measured<S: Format>(case: &mut Case<'_>, samples: &'static [u16; 15]) -> Outcome {
    let (position, axis, side) = (case.vector("position"), case.vector("axis"), case.vector("side"));
    let intensity = case.number("intensity");
    let (point, normal) = (case.point::<S>("point"), case.normal::<S>("normal"));
    let distribution = Distribution::new(samples, 5, Symmetry::Bilateral)?;
    let light = MeasuredLight::new(position, axis, side, distribution)?.with_intensity(intensity)?;
    case.give(light.compile::<S>()?.irradiance(point, normal));
    Ok(())
}

/// The light on a surface.
pub(super) fn directional<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (direction, intensity) = (case.vector("axis"), case.number("intensity"));
    let normal = case.normal::<S>("normal");
    let light = DirectionalLight::new(direction)?.with_intensity(intensity)?.compile::<S>();
    case.give(light.irradiance(normal));
    Ok(())
}

/// The light everywhere.
pub(super) fn ambient<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (color, intensity) = (case.color("color"), case.number("intensity"));
    let light = AmbientLight::new(color)?.with_intensity(intensity)?;
    case.give_color(light.compile::<S>());
    Ok(())
}
