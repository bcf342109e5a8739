//! Godot 3: zero to the power of zero beyond the range of a light.

use luminaire::{
    SpotLight,
    attenuation::{CutAt, NoAttenuation},
};

use super::*;

/// The half angle in degrees.
const HALF: f32 = 20.0;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "pow-zero",
    label: "0 to the power of 0",
    title: "Beyond its range the light is not a number, because zero is raised to the power of zero.",
    source: Source {
        project: "Godot, GLES3",
        file: "drivers/gles3/shaders/scene.glsl",
        version: "until December 2019",
        licence: "MIT",
        thread: "godotengine/godot #34467, #34527; in highlights mrdoob/three.js #5222, OpenMW/openmw #2265",
    },
    code: "float omni_attenuation = pow(max(1.0 - normalized_distance, 0.0), attenuation);",
    cause: "An attenuation of 0 means the same light up to the range. Beyond the range the base is 0, \
        too, and GLSL leaves pow(0, 0) undefined: exp2(0 * log2(0)) is NaN. Any sum with NaN is NaN, so \
        every other light on these pixels is lost as well.",
    no_better: "Any attenuation over 0 is safe in both. Some drivers define the power as 1, and then the \
        light has no range; some as 0, and then it is right by luck.",
    agrees_at: None,
    control: Control::linear("Range", "m", [1.0, 3.0, 4.4]),
    bounds: Bounds { faulty: f64::INFINITY, ours: 0.5 },
    beam,
};

fn beam(range: f32) -> Result<Beam, Error> {
    let view = View::Side(0.5, 4.5);
    let cone = Cone::from_outer(Linear, HalfAngle::degrees(HALF))?;
    let [position, axis] = view.light();
    let ours = SpotLight::new(position, axis, cone)?;
    let exact = oracle::Cone::new(linear, oracle::versine(HALF.into()));
    let cone_angle = libm::cosf(HALF.to_radians());
    Ok(Beam {
        view,
        ours: ours.with_attenuation(CutAt::new(NoAttenuation, Some(range))?).into(),
        exact: Box::new(
            move |versine, distance| {
                if distance < f64::from(range) { exact.falloff(versine) } else { 0.0 }
            },
        ),
        faulty: Box::new(move |seen| {
            let normalized_distance = seen.distance() / range;
            let omni_attenuation = glsl_pow((1.0 - normalized_distance).max(0.0), 0.0);
            let rim = (1.0 - seen.cosine().max(cone_angle)) / (1.0 - cone_angle);
            omni_attenuation * (1.0 - rim.max(1e-4))
        }),
    })
}
