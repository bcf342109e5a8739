//! C-Chads' TinyGL: a distance that is never computed.

use luminaire::attenuation::Polynomial;

use super::{micromath_power::opengl, *};

/// The cutoff in degrees, and the exponent.
const CUTOFF: f32 = 90.0;
const EXPONENT: f32 = 16.0;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "tinygl",
    label: "A distance of zero",
    title: "The light does not decrease with the distance, because a faster root leaves the distance at \
        zero.",
    source: Source {
        project: "TinyGL of C-Chads with TGL_FEATURE_FISR",
        file: "src/light.c, gl_shade_vertex",
        version: "with this option",
        licence: "zlib",
        thread: "",
    },
    code: "GLfloat dist = 0, tmp;\n\
        tmp = fastInvSqrt(d.X * d.X + d.Y * d.Y + d.Z * d.Z); // dist is set in the other branch only\n\
        att = 1.0f / (attenuation[0] + dist * (attenuation[1] + dist * attenuation[2]));",
    cause: "The option replaces the root by an estimate of its reciprocal. The branch that it replaces \
        also set the distance, which the attenuation still reads.",
    no_better: "Without the option the library is right. With a quadratic coefficient of 0, OpenGL’s \
        default, only the estimate’s own error is left, which is a few codes.",
    agrees_at: None,
    control: Control::linear("Quadratic attenuation", "", [0.0, 1.0, 4.0]),
    bounds: Bounds { faulty: 230.0, ours: 0.6 },
    beam,
};

/// The project's estimate of a reciprocal root.
fn fast_inverse_root(x: f32) -> f32 {
    let estimate = f32::from_bits(0x5F1F_FFF9 - (x.to_bits() >> 1));
    estimate * (0.703_952_25 * (2.389_244_6 - x * estimate * estimate))
}

fn beam(quadratic: f32) -> Result<Beam, Error> {
    let view = View::Side(0.5, 4.5);
    let exact = oracle::Cone::opengl(EXPONENT.into(), oracle::versine(CUTOFF.into()));
    let cos_cutoff = libm::cosf(CUTOFF.to_radians());
    Ok(Beam {
        view,
        ours: opengl(view, CUTOFF, EXPONENT, Polynomial::new(1.0, 0.0, quadratic)?)?,
        exact: Box::new(move |versine, distance| {
            exact.falloff(versine) / (1.0 + f64::from(quadratic) * distance * distance)
        }),
        faulty: Box::new(move |seen| {
            let dist = 0.0;
            let cosine = seen.cosine_at(1.0 / fast_inverse_root(seen.squared_distance()));
            let attenuation = 1.0 / (1.0 + dist * (0.0 + dist * quadratic));
            if cosine < cos_cutoff { 0.0 } else { attenuation * libm::powf(cosine, EXPONENT) }
        }),
    })
}
