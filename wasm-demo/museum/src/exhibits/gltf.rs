//! glTF: a span of cosines of at least a thousandth.

use super::*;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "gltf",
    label: "glTF’s clamp",
    title: "A cone with a half angle of one degree keeps 2 % of its light, because its span of cosines is \
        replaced by a thousandth.",
    source: Source {
        project: "glTF, KHR_lights_punctual",
        file: "extensions/2.0/Khronos/KHR_lights_punctual/README.md, reference code",
        version: "current",
        licence: "CC BY 4.0",
        thread: "",
    },
    code: "float lightAngleScale = 1.0f / max(0.001f, cos(innerConeAngle) - cos(outerConeAngle));",
    cause: "The clamp avoids a division by zero. A cone with a half angle under 2.6 degrees has a \
        smaller span of cosines than 0.001, so its edge is divided by too much and its axis never \
        reaches full intensity.",
    no_better: "From 2.6 degrees on the formula is right, and errs as little as the crate’s 16 bits.",
    agrees_at: Some(5.0),
    control: Control::logarithmic("Half angle", "°", [0.1, 1.0, 20.0]),
    bounds: Bounds { faulty: 240.0, ours: 0.5 },
    beam,
};

fn beam(degrees: f32) -> Result<Beam, Error> {
    let view = View::spot_on_wall(degrees.into());
    let faulty = clamped_span(0.001, 0.0, degrees.to_radians());
    let exact = oracle::Cone::new(soft, oracle::versine(degrees.into()));
    Beam::of_cone(view, Cone::from_outer(Soft, HalfAngle::degrees(degrees))?, exact, move |seen| {
        faulty(seen.cosine())
    })
}
