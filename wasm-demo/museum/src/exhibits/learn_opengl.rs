//! LearnOpenGL: a division by the difference of two equal cosines.

use super::*;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "equal-angles",
    label: "Inner = outer",
    title: "A hard edge gets a ring of pixels that are not numbers, because zero is divided by zero.",
    source: Source {
        project: "LearnOpenGL, Light casters",
        file: "src/2.lighting/5.4.light_casters_spot_soft/5.4.light_casters.fs",
        version: "current",
        licence: "CC BY-NC 4.0",
        thread: "",
    },
    code: "float epsilon = light.cutOff - light.outerCutOff;\n\
        float intensity = clamp((theta - light.outerCutOff) / epsilon, 0.0, 1.0);",
    cause: "Equal angles make a hard edge. Then epsilon is 0, and where theta has the \
        cosine of the edge the quotient is 0/0. A beam of 0.1 degrees has only 26 cosines, so that \
        this one belongs to a whole ring of pixels. The clamp leaves NaN undefined.",
    no_better: "Away from the ring the formula is right. At 1 degree it is exact, and the crate’s 16 \
        bits put a pixel at the edge on the wrong side: no format bounds an error at a step.",
    agrees_at: Some(1.0),
    control: Control::logarithmic("Half angle", "°", [0.05, 0.1, 20.0]),
    bounds: Bounds { faulty: f64::INFINITY, ours: 0.5 },
    beam,
};

fn beam(degrees: f32) -> Result<Beam, Error> {
    let view = View::spot_on_wall(degrees.into());
    let [cut_off, outer_cut_off] = [degrees, degrees].map(|degrees| libm::cosf(degrees.to_radians()));
    let exact = oracle::Cone::new(step, oracle::versine(degrees.into()));
    Beam::of_cone(view, Cone::from_outer(Step, HalfAngle::degrees(degrees))?, exact, move |seen| {
        let epsilon = cut_off - outer_cut_off;
        ((seen.cosine() - outer_cut_off) / epsilon).clamp(0.0, 1.0)
    })
}
