//! Gobos, shadow maps and haze in the beam of a spotlight.

use luminaire::{
    Angle, Error, Fx16, SpotLight, Vec3,
    falloff::Soft,
    haze::{Haze, ViewRay},
    projector::{CompiledProjection, Gobo, Projection, Shadow},
};

use super::falloff::Description;
use crate::case::{Case, Outcome};
use crate::word::Format;

/// The transmissions of the gobo.
const GOBO: Gobo<'static> = Gobo::of(&[0, 255, 128, 1, 254, 60, 90, 200, 17, 17, 255, 255, 3, 180, 0, 99]);

/// The depths of the shadow map, in metres: nine texels.
const DEPTHS: [f32; 9] = [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 3.0, 0.0, 32.0];

/// The inputs that all these models share: the projection of a soft spotlight, and a point.
fn square<S: Format>(case: &mut Case<'_>) -> (Result<CompiledProjection<S>, Error>, Vec3<S::Length>) {
    let description = Description::of(case, |_| Ok(Soft));
    let (position, axis, roll) = (case.vector("position"), case.vector("axis"), case.number("roll"));
    let point = case.point::<S>("point");
    let square = || {
        let spot = SpotLight::new(position, axis, description.cone()?)?;
        Projection::of(&spot)?.turned(Angle::degrees(roll))?.compile::<S>()
    };
    (square(), point)
}

/// Column, row and depth of a point in the projection.
pub(super) fn place<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (square, point) = square::<S>(case);
    let place = square?.project(point);
    case.give(place.column.cast_unsigned());
    case.give(place.row.cast_unsigned());
    case.give(place.depth);
    Ok(())
}

/// The transmittance of a gobo.
pub(super) fn gobo<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (square, point) = square::<S>(case);
    case.give(GOBO.on(square?).at(point));
    Ok(())
}

/// The visibility through a shadow map.
pub(super) fn shadow<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (square, point) = square::<S>(case);
    let depths = DEPTHS.map(S::length);
    case.give(Shadow::new(square?, 3, &depths)?.visibility(point));
    Ok(())
}

/// In-scattering from a beam along the view ray from an eye to a surface, and along the whole ray
/// in that direction; both in f32. If `Fx16` holds the light, also the former in 16 bits.
pub(super) fn in_scattering(case: &mut Case<'_>) -> Outcome {
    let description = Description::of(case, |_| Ok(Soft));
    let (position, axis, intensity) =
        (case.vector("position"), case.vector("axis"), case.number("intensity"));
    let (eye, surface, density) = (case.vector("eye"), case.vector("point"), case.number("density"));
    let spot = SpotLight::new(position, axis, description.cone()?)?.with_intensity(intensity)?;
    let beam = spot.compile::<f32>()?.in_haze(&Haze::new(density)?);
    let ray = ViewRay::between(eye, surface);
    case.give(beam.in_scattering(&ray));
    case.give(beam.in_scattering(&ViewRay::endless(eye, ray.direction)));
    let [near, far] = [eye, surface].map(|point| Fx16::point(point.into()));
    case.give(spot.compile::<Fx16>()?.in_haze(&Haze::new(density)?).in_scattering(near, far));
    Ok(())
}
