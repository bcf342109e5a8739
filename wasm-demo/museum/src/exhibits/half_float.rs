//! PlayCanvas: cosines of cone angles in half floats.

use super::*;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "half-float",
    label: "Cosines in half floats",
    title: "A cone with a half angle of 1.3 degrees is drawn with 1.8 degrees, and below 1.27 degrees it is gone.",
    source: Source {
        project: "PlayCanvas, clustered lighting",
        file: "src/scene/lighting/lights-buffer.js",
        version: "until November 2025",
        licence: "MIT",
        thread: "playcanvas/engine #8108",
    },
    code: "smoothstep(half(cos(outer)), half(cos(inner)), cosAngle)",
    cause: "A half float has steps of 1/2048 below one. The cosine of an angle is rounded to such a \
        step, and from 1.27 degrees down that step is one itself. The project’s remedy is the \
        crate’s own: it now stores one minus the cosine of small angles.",
    no_better: "The size of a wide cone is right: from 10 degrees on the error is under a code.",
    agrees_at: Some(30.0),
    control: Control::logarithmic("Half angle", "°", [0.5, 1.3, 30.0]),
    bounds: Bounds { faulty: 100.0, ours: 0.5 },
    beam,
};

/// Rounds a cosine from a half to one to the 11 fraction bits that a half float has there.
fn half(cosine: f32) -> f32 {
    (cosine * 2048.0).round() / 2048.0
}

fn beam(degrees: f32) -> Result<Beam, Error> {
    let view = View::spot_on_wall(degrees.into());
    let [outer, inner] = [degrees, 0.0].map(|degrees| half(libm::cosf(degrees.to_radians())));
    let exact = oracle::Cone::new(smooth, oracle::versine(degrees.into()));
    // An edge of no width is undefined. Processors give 0 for the points inside.
    Beam::of_cone(view, Cone::from_outer(Smooth, HalfAngle::degrees(degrees))?, exact, move |seen| {
        if outer == inner { 0.0 } else { smoothstep(outer, inner, seen.cosine()) }
    })
}
