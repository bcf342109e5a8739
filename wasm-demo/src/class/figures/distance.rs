//! What the distance does to light.

use super::*;
use luminaire::attenuation::{Attenuation, Polynomial};
use std::f64::consts::PI;

pub(super) const ATTENUATION: Figure = Figure {
    name: "attenuation",
    title: "Attenuation that looks good",
    text: "A light fades with the distance d, and three constants choose how. The result is capped at 1, because a surface can’t receive more light than left the lamp. The strip is a floor whose every point faces the lamp at its left end.",
    formula: "f(d) = min(1, 1 / (a + b d + c d²))",
    source: "Lecture CPSC 424, “Attenuation”",
    parameters: &[
        Choice("which", "Constant", &[("a", "a, constant"), ("b", "b, linear"), ("c", "c, quadratic")]),
        Dial(CONSTANT, 0.5),
        Dial(LINEAR, 0.0),
        Dial(QUADRATIC, 0.25),
    ],
    question: "Set a = b = 0 and c = 1, the inverse square. Up to which distance does the cap hold, and what is left at 2 m?",
    answer: || {
        let [cap, left] =
            [capped([0.0, 0.0, 1.0]), arriving(Polynomial::new(0.0, 0.0, 1.0)?)?(2.0)].map(tidy);
        Ok(format!("Up to {cap} m. At 2 m {left} of the light is left."))
    },
    draw: attenuation,
};

const LONGEST: f64 = 8.0;

/// The light of intensity 1 on a surface that faces it, over the distance.
fn arriving<A: Attenuation>(attenuation: A) -> Result<impl Fn(f64) -> f64, Refusal> {
    let light = PointLight::new([0.0; 3])?.with_attenuation(attenuation).compile::<f32>()?;
    Ok(move |d: f64| light.irradiance([d as f32, 0.0, 0.0].into(), [-1.0, 0.0, 0.0].into()).into())
}

/// The polynomial under the light.
fn polynomial([a, b, c]: [f32; 3], d: f64) -> f64 {
    f64::from(a) + d * (f64::from(b) + d * f64::from(c))
}

/// The distance up to which the law is capped: where the polynomial is 1, in a form that loses no digits. It may be
/// infinite.
fn capped(constants: [f32; 3]) -> f64 {
    let [below, b, c] = [1.0 - f64::from(constants[0]), constants[1].into(), constants[2].into()];
    if below <= 0.0 { 0.0 } else { 2.0 * below / (b + (b * b + 4.0 * c * below).sqrt()) }
}

fn attenuation(values: &Values) -> Result<Drawing, Refusal> {
    let constants = values.numbers([CONSTANT, LINEAR, QUADRATIC]);
    let [a, b, c] = constants;
    let law = arriving(Polynomial::new(a, b, c)?)?;
    let seen = format!("A strip of floor, {LONGEST} m long, lit from the left");
    let uncapped = sampled([0.01, LONGEST], |d| (1.0 / polynomial(constants, d)).min(2.0));
    Ok(Drawing {
        pictures: vec![picture("The floor", seen, [640, 60], |x, _, _| law(LONGEST * (x + 1.0) / 2.0))],
        numbers: vec![
            ("f(1 m)", law(1.0), ""),
            ("f(4 m)", law(4.0), ""),
            ("Capped up to", capped(constants), " m"),
        ],
        graph: Some(Graph {
            across: ("distance d, m", [0.0, LONGEST]),
            up: ("light", 2.0),
            curves: vec![("f(d)", sampled([0.01, LONGEST], &law)), ("without the cap", uncapped)],
            marks: Vec::new(),
        }),
        ..Drawing::default()
    })
}

pub(super) const SPHERE: Figure = Figure {
    name: "sphere",
    title: "Why the square of the distance",
    text: "Around a lamp that shines alike in all directions, the same light crosses every sphere. The sphere’s area grows as d², so each square metre of it gets 1/d² of the light. The patch is lit by the same bundle of rays at every distance, and covers one square metre at 1 m.",
    formula: "E = I / d²,   4π d² · E = 4π I",
    source: "Lecture CPSC 424, “Attenuation”: a patch of area A gets A / 4πr²",
    parameters: &[Dial(DISTANCE, 2.0)],
    question: "The lamp puts out one unit of light. Which part of it crosses one square metre of the sphere at 2 m?",
    answer: || {
        let part = arriving(luminaire::attenuation::InverseSquare)?(2.0) / (4.0 * PI);
        Ok(format!("{} of it: 1 m² of {} m².", tidy(part), tidy(16.0 * PI)))
    },
    draw: |values| {
        let light = arriving(luminaire::attenuation::InverseSquare)?;
        let (d, ends) = (f64::from(values.numbers([DISTANCE])[0]), DISTANCE.ends.map(f64::from));
        let (lit, area) = (light(d), 4.0 * PI * d * d);
        // The picture is a bit wider than the largest patch, which is a part of the sphere laid flat.
        let patch = |x: f64, y: f64, _| {
            let places = [x, y].map(|c| 2.1 * c + d / 2.0);
            let is_lit = places.iter().all(|c| (0.0..d).contains(c) && *c % 1.0 > 0.014);
            if is_lit { light(d) } else { 0.0 }
        };
        let curve = sampled(ends, &light);
        let flux = curve.iter().map(|[d, e]| [*d, e * d * d]).collect();
        let seen = format!(
            "A square patch, {} m on a side, ruled in square metres, of even light {}",
            tidy(d),
            tidy(lit)
        );
        Ok(Drawing {
            pictures: vec![picture("The lit patch, ruled in square metres", seen, [360; 2], patch)],
            graph: Some(Graph {
                across: ("distance d, m", ends),
                up: ("share", 1.2),
                curves: vec![("E / I", curve), ("light through the sphere / 4π I", flux)],
                marks: vec![([d, lit], format!("E = {} I", tidy(lit)))],
            }),
            numbers: vec![
                ("E", lit, " I"),
                ("Area of the sphere", area, " m²"),
                ("Area times E", area * lit, " I"),
            ],
            ..Drawing::default()
        })
    },
};
