//! Bevy: a span of cosines of at least a ten-thousandth.

use super::{gltf::cone, *};

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "bevy",
    label: "Bevy’s clamp",
    title: "A cone with a half angle of half a degree keeps 15 % of its light, because its span of cosines is \
        replaced by a ten-thousandth.",
    source: Source {
        project: "Bevy",
        file: "crates/bevy_pbr/src/render/light.rs",
        version: "current",
        licence: "MIT or Apache-2.0",
        thread: "",
    },
    code: "let spot_scale = 1.0 / f32::max(inner.cos() - cos_outer, 1e-4);",
    cause: "The same clamp as in glTF’s code with a smaller number. It takes the light of cones with a \
        half angle under 0.81 degrees. In f32 a span that small has 1,700 steps, so the clamp hides \
        rather than cures the loss of precision.",
    no_better: "From 0.81 degrees on the clamp does nothing, and the formula is within a code of the truth.",
    agrees_at: Some(2.0),
    control: Control::logarithmic("Half angle", "°", [0.05, 0.5, 10.0]),
    bounds: Bounds { faulty: 210.0, ours: 0.5 },
    beam: |degrees| cone(degrees, 1e-4),
};
