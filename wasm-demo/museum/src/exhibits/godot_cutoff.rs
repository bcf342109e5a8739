//! Godot 4.4 betas: an early-out at a thousandth of a light.

use luminaire::{
    SpotLight,
    attenuation::{FilamentRange, InverseSquare},
};
use luminaire_oracle::Attenuation;

use super::*;

/// The range of the light in metres.
const RANGE: f32 = 5.0;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "godot-cutoff",
    label: "Godot’s early-out",
    title: "The end of a very bright light is an edge, because the last thousandth of it is skipped.",
    source: Source {
        project: "Godot",
        file: "servers/rendering/renderer_rd/shaders/scene_forward_lights_inc.glsl",
        version: "4.4 dev7 to beta2, corrected in beta3",
        licence: "MIT",
        thread: "godotengine/godot #102241, #102272",
    },
    code: "const float EPSILON = 1e-3f; // a light whose attenuation is less is skipped",
    cause: "An early-out saves the shadow look-up of a dark pixel. Dark is a matter of the energy: at \
        200 times full scale a thousandth of the light is a fifth of what the display shows.",
    no_better: "The crate skips exact zeros only, which saves less. At an energy of 1 the edge is a \
        quarter of a code, and nobody sees it.",
    agrees_at: Some(1.0),
    control: Control::logarithmic("Energy", "", [1.0, 200.0, 1000.0]),
    bounds: Bounds { faulty: 45.0, ours: 1.0 },
    beam,
};

fn beam(energy: f32) -> Result<Beam, Error> {
    let view = View::Side(4.5, 5.1);
    let [position, axis] = view.light();
    // A spot angle of 45 degrees, an angle attenuation of 1 and an attenuation of 2.
    let light = SpotLight::new(position, axis, Cone::from_outer(Linear, HalfAngle::degrees(45.0))?)?;
    let light =
        light.with_attenuation(FilamentRange::new(InverseSquare, Some(RANGE))?).with_intensity(energy)?;
    let outer = oracle::versine(45.0);
    let range = Attenuation::FilamentRange(RANGE.into());
    let cone_angle = libm::cosf(45_f32.to_radians());
    Ok(Beam {
        view,
        ours: light.into(),
        exact: Box::new(move |versine, distance| {
            f64::from(energy) * (1.0 - versine / outer).max(0.0) * range.at(distance)
        }),
        faulty: Box::new(move |seen| {
            const EPSILON: f32 = 1e-3;
            let distance = seen.distance();
            let nd = distance / RANGE;
            let nd = (1.0 - nd * nd * nd * nd).max(0.0);
            let omni = nd * nd / (distance.max(1e-4) * distance.max(1e-4));
            let rim = (1.0 - seen.cosine().max(cone_angle)) / (1.0 - cone_angle);
            let attenuation = omni * (1.0 - rim.max(1e-4));
            if attenuation > EPSILON { attenuation * energy } else { 0.0 }
        }),
    })
}
