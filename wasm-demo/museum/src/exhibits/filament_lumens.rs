//! Filament and QLC+: lumens spread evenly over a cone that is not even.

use luminaire::{SpotLight, attenuation::NoAttenuation};

use super::*;

/// The outer half angle in degrees.
const OUTER: f32 = 20.0;
/// The intensity of a level cone with the flux of the light.
const LEVEL: f64 = 0.3;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "level-cone",
    label: "Lumens of a level cone",
    title: "Two thirds of the light is lost: lumens are spread over the whole cone, but the falloff then \
        darkens most of it.",
    source: Source {
        project: "Filament, FOCUSED_SPOT; the same formula in QLC+",
        file: "filament/src/components/LightManager.cpp, setIntensity",
        version: "current",
        licence: "Apache-2.0",
        thread: "mcallegari/qlcplus #2077, #2129",
    },
    code: "luminousIntensity = luminousPower / (f::TAU * (1.0f - cosOuter));",
    cause: "The lumens are divided by the solid angle of the outer cone, as if the intensity were level. \
        With the falloff t^2 from the axis on the cone has a third of that flux, so the light is three \
        times too dark. The crate divides by the integral of the falloff.",
    no_better: "With inner = outer the cone is level, and both are right. A data sheet’s lumens are \
        seldom known to 10 %.",
    agrees_at: None,
    control: Control::linear("Inner angle, share of the outer", "%", [0.0, 0.0, 95.0]),
    bounds: Bounds { faulty: 150.0, ours: 0.6 },
    beam,
};

fn beam(share: f32) -> Result<Beam, Error> {
    let view = View::spot_on_wall(OUTER.into());
    let inner = OUTER * share / 100.0;
    let [inner_versine, outer] = [inner, OUTER].map(|degrees| oracle::versine(degrees.into()));
    let lumens = LEVEL * core::f64::consts::TAU * outer;
    // The integral of t^2 over the versine is a third of the span.
    let solid_angle = core::f64::consts::TAU * (inner_versine + (outer - inner_versine) / 3.0);
    let exact = oracle::Cone { inner: inner_versine, ..oracle::Cone::new(soft, outer) };
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(OUTER))?.with_inner(HalfAngle::degrees(inner))?;
    let [position, axis] = view.light();
    let light = SpotLight::new(position, axis, cone)?.with_attenuation(NoAttenuation);
    let falloff = clamped_span(1.0 / 1024.0, inner.to_radians(), OUTER.to_radians());
    let luminous_intensity =
        lumens as f32 / (core::f32::consts::TAU * (1.0 - libm::cosf(OUTER.to_radians())));
    Ok(Beam {
        view,
        ours: light.with_intensity(cone.candela(lumens as f32))?.into(),
        exact: Box::new(move |versine, _| lumens / solid_angle * exact.falloff(versine)),
        faulty: Box::new(move |seen| luminous_intensity * falloff(seen.cosine())),
    })
}
