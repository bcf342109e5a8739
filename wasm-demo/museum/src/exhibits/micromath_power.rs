//! micromath: a power that magnifies the error of its logarithm.

use luminaire::{
    Angle, SpotLight,
    attenuation::{AnyAttenuation, NoAttenuation},
    dynamic::AnyLight,
    falloff::AnyFalloff,
};
use micromath::F32;

use super::*;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "micromath-power",
    label: "micromath’s power",
    title: "The beam is much too narrow: a cosine to the power of 32 is off by a quarter of full scale.",
    source: Source {
        project: "micromath, which is run as published",
        file: "src/float/powf.rs",
        version: "2.1.0",
        licence: "MIT or Apache-2.0",
        thread: "",
    },
    code: "(n * self.ln()).exp()",
    cause: "The exponent multiplies the error of the logarithm. The logarithm is an approximation with \
        a fixed error, fit for exponents near one; those of spotlights go to 128.",
    no_better: "micromath promises an approximation, which is small and fast. At an exponent of 1, where \
        the error is 18 codes, it may do; an integer exponent needs no power function at all.",
    agrees_at: None,
    control: Control::logarithmic("Exponent", "", [1.0, 32.0, 128.0]),
    bounds: Bounds { faulty: 55.0, ours: 0.5 },
    beam,
};

fn beam(exponent: f32) -> Result<Beam, Error> {
    let view = View::spot_on_wall(40.0);
    let exact = oracle::Cone::opengl(exponent.into(), 1.0);
    Ok(Beam {
        view,
        ours: opengl(view, 90.0, exponent, NoAttenuation)?,
        exact: Box::new(move |versine, _| exact.falloff(versine)),
        faulty: Box::new(move |seen| F32(seen.cosine().max(0.0)).powf(F32(exponent)).0),
    })
}

/// OpenGL's spotlight with a cutoff in degrees, an exponent and an attenuation.
pub(super) fn opengl(
    view: View,
    cutoff: f32,
    exponent: f32,
    attenuation: impl Into<AnyAttenuation>,
) -> Result<AnyLight, Error> {
    let cone = Cone::from_outer(AnyFalloff::power(exponent)?, Angle::degrees(180.0))?;
    let [position, axis] = view.light();
    let light = SpotLight::new(position, axis, cone.with_cutoff(HalfAngle::degrees(cutoff))?)?;
    Ok(light.with_attenuation(attenuation.into()).into())
}
