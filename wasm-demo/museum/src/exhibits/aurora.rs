//! aurora: a coefficient without its divisor.

use super::*;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "aurora",
    label: "A forgotten division",
    title: "A cone of 30 degrees becomes a flood that is more than 50 times too bright, because one of three \
        coefficients is not divided.",
    source: Source {
        project: "aurora, the GameCube’s graphics library rebuilt",
        file: "lib/dolphin/gx/GXLighting.cpp, GX_SP_SHARP",
        version: "current, and its forks",
        licence: "MIT",
        thread: "",
    },
    code: "const float d = (1.f - cr) * (1.f - cr);\n\
        a0 = cr * (cr - 2.f); // not / d\n\
        a1 = 2.f / d;\n\
        a2 = -1.f / d;",
    cause: "The sharp spotlight is the parabola 1 - ((1 - c) / (1 - cr))^2 in the cosine c, which is the \
        hard edge of the crate. Two of its coefficients are divided by (1 - cr)^2, the first is not.",
    no_better: "With the division both pictures are the same.",
    agrees_at: None,
    control: Control::linear("Half angle", "°", [10.0, 30.0, 75.0]),
    bounds: Bounds { faulty: 13_000.0, ours: 0.5 },
    beam,
};

fn beam(degrees: f32) -> Result<Beam, Error> {
    let view = View::spot_on_wall(degrees.into());
    let cr = libm::cosf(degrees.to_radians());
    let d = (1.0 - cr) * (1.0 - cr);
    let [a0, a1, a2] = [cr * (cr - 2.0), 2.0 / d, -1.0 / d];
    let exact = oracle::Cone::new(hard, oracle::versine(degrees.into()));
    Beam::of_cone(view, Cone::from_outer(Hard, HalfAngle::degrees(degrees))?, exact, move |seen| {
        let cosine = seen.cosine();
        (a0 + a1 * cosine + a2 * cosine * cosine).max(0.0)
    })
}
