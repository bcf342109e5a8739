//! micromath: a power that magnifies the error of its logarithm.

use luminaire::{
    dynamic::AnyLight,
    import::{OpenGl, OpenGlLight},
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
        ours: opengl(view, 90.0, exponent, [1.0, 0.0, 0.0])?,
        exact: Box::new(move |versine, _| exact.falloff(versine)),
        faulty: Box::new(move |seen| F32(seen.cosine().max(0.0)).powf(F32(exponent)).0),
    })
}

/// OpenGL's spotlight with a cutoff in degrees, an exponent and the coefficients of its attenuation.
pub(super) fn opengl(
    view: View,
    spot_cutoff: f32,
    spot_exponent: f32,
    [constant, linear, quadratic]: [f32; 3],
) -> Result<AnyLight, Error> {
    let light = OpenGl {
        spot_cutoff,
        spot_exponent,
        constant_attenuation: constant,
        linear_attenuation: linear,
        quadratic_attenuation: quadratic,
        intensity: 1.0,
    };
    let [position, axis] = view.light();
    Ok(match light.import(position, axis)?.light {
        OpenGlLight::Spot(light) => light.into(),
        OpenGlLight::Point(light) => light.into(),
    })
}
