//! Filament: angles of at least half a degree, and a span of cosines of at least 1/1024.

use super::{gltf::cone, *};

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "filament-clamp",
    label: "Filament’s half degree",
    title: "A narrow beam goes black: its angle is raised to half a degree, its light lowered to 0.15 %.",
    source: Source {
        project: "Filament",
        file: "filament/src/components/LightManager.cpp, setSpotLightCone",
        version: "since October 2021",
        licence: "Apache-2.0",
        thread: "google/filament #4785",
    },
    code: "float outerClamped = clamp(abs(outer), 0.5f * f::DEG_TO_RAD, f::PI_2);\n\
        float scale = 1 / max(1.0f / 1024.0f, cosInner - cosOuter);",
    cause: "The falloff failed in f32 for very narrow cones, so both half angles are silently raised to \
        half a degree. The span of the cosines is then clamped to 1/1024, which is 26 times the span \
        of that cone.",
    no_better: "From 14 degrees on both pictures are within a code. Before, the inner angle of at least \
        half a degree is to be seen.",
    agrees_at: Some(20.0),
    control: Control::logarithmic("Half angle", "°", [0.1, 0.5, 20.0]),
    bounds: Bounds { faulty: 250.0, ours: 0.5 },
    beam,
};

fn beam(degrees: f32) -> Result<Beam, Error> {
    const LEAST: f32 = 0.5;
    let outer = degrees.max(LEAST).to_radians();
    let inner = LEAST.to_radians().min(outer);
    let faulty = clamped_span(1.0 / 1024.0, inner, outer);
    Ok(Beam { faulty: Box::new(move |seen| faulty(seen.cosine())), ..cone(degrees, 0.0)? })
}
