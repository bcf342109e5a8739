//! Godot: a floor under the argument of a power.

use luminaire::falloff::InvertedRealPower;

use super::*;

/// The half angle of the light in degrees.
const HALF: f32 = 30.0;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "godot-rim",
    label: "Godot’s rim",
    title: "The middle of a pointed beam is cut off: an angle attenuation of 4 costs a tenth of its light.",
    source: Source {
        project: "Godot",
        file: "servers/rendering/renderer_rd/shaders/scene_forward_lights_inc.glsl",
        version: "4.0 and later",
        licence: "MIT",
        thread: "godotengine/godot #69985",
    },
    code: "float spot_rim = max(1e-4, float(half(1.0) - scos) / float(half(1.0) - cone_angle));\n\
        spot_attenuation *= half(1.0 - pow(spot_rim, cone_attenuation));",
    cause: "The floor of 1e-4 keeps pow(0, 0) away. The exponent is the reciprocal of the angle \
        attenuation; for a small exponent 1e-4 is far from zero: the axis has 1 - 1e-4^(1/4) = 0.9 of \
        its light.",
    no_better: "Outside of this middle twentieth both are the same. In its very point the crate’s 16 bits \
        lose up to 16 codes, too: the slope there is infinite, and no format bounds the error.",
    agrees_at: Some(1.0),
    control: Control::logarithmic("Angle attenuation", "", [1.0, 4.0, 10.0]),
    bounds: Bounds { faulty: 15.0, ours: 17.0 },
    beam,
};

fn beam(attenuation: f32) -> Result<Beam, Error> {
    // Only the middle: a twentieth of the radius of the spot.
    let view = View::Wall(HALF.into(), 0.05);
    let exponent = 1.0 / attenuation;
    let outer = oracle::versine(HALF.into());
    let cone_angle = libm::cosf(HALF.to_radians());
    Ok(Beam {
        view,
        ours: view.spot(Cone::from_outer(InvertedRealPower::new(exponent)?, HalfAngle::degrees(HALF))?)?,
        exact: Box::new(move |versine, _| 1.0 - libm::pow((versine / outer).min(1.0), exponent.into())),
        faulty: Box::new(move |seen| {
            let scos = seen.cosine().max(cone_angle);
            let rim = ((1.0 - scos) / (1.0 - cone_angle)).max(1e-4);
            1.0 - glsl_pow(rim, exponent)
        }),
    })
}
