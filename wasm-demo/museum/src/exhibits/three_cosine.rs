//! three.js: a smoothstep over cosines in f32.

use super::*;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "three-cosine",
    label: "The cosine in f32",
    title: "A narrow beam turns to noise, because f32 has few numbers near a cosine of one.",
    source: Source {
        project: "three.js, and nearly every shader",
        file: "src/renderers/shaders/ShaderChunk/lights_pars_begin.glsl.js",
        version: "all with a penumbra",
        licence: "MIT",
        thread: "",
    },
    code: "smoothstep( spotLight.coneCos, spotLight.penumbraCos, angleCos )",
    cause: "Below one, f32 has steps of 6e-8. A cone of 0.05 degrees spans only six of them, so the \
        intensity has six values, and rounding picks one of them. The crate takes half the squared \
        difference of two directions, which is small and keeps its digits.",
    no_better: "From 1.5 degrees on the crate’s 16 bits err as much as the cosine in f32: both by less than \
        a quarter of a code, which nobody sees.",
    agrees_at: Some(3.0),
    control: Control::logarithmic("Half angle", "°", [0.02, 0.05, 20.0]),
    bounds: Bounds { faulty: 150.0, ours: 0.5 },
    beam,
};

fn beam(degrees: f32) -> Result<Beam, Error> {
    let view = View::spot_on_wall(degrees.into());
    // JavaScript computes the cosine in f64, the shader receives it in f32.
    let cone_cosine = libm::cos(f64::from(degrees).to_radians()) as f32;
    let exact = oracle::Cone::new(smooth, oracle::versine(degrees.into()));
    Beam::of_cone(view, Cone::from_outer(Smooth, HalfAngle::degrees(degrees))?, exact, move |seen| {
        smoothstep(cone_cosine, 1.0, seen.cosine())
    })
}
