//! Spotlights of OpenGL, of a shader and of Direct3D.

use super::*;
use luminaire::{
    attenuation::NoAttenuation,
    falloff::{AnyFalloff, Linear, Smooth, Step},
};

/// A spotlight that keeps its light over the distance, like those of old pipelines.
pub(super) type Steady = SpotLight<AnyFalloff, NoAttenuation>;

fn steady(cone: Cone<AnyFalloff>) -> Result<Steady, Refusal> {
    Ok(SpotLight::new([0.0; 3], single(AXIS), cone)?.with_attenuation(NoAttenuation))
}

pub(super) const POWER: Figure = Figure {
    name: "power",
    title: "A power of the cosine",
    text: "OpenGL concentrates a spotlight by a power of the cosine of the angle off its axis, and cuts it at an angle δ. A larger exponent gives a smaller pool, but no sharper edge. At the cutoff the light jumps to 0.",
    formula: "spot = (−L·d)^p where −L·d ≥ cos δ, else 0",
    source: "Lecture CPSC 424, “Spotlights”; Hast 2004, equation 1",
    parameters: &[Dial(EXPONENT, 20.0), Dial(CUTOFF, 30.0)],
    question: "Which exponent leaves half of the light at 10° off the axis?",
    answer: || {
        let exponent = 0.5_f64.ln() / 10_f64.to_radians().cos().ln();
        let light = Beam::spot("", opengl(exponent as f32, 90.0)?)?.at(10.0);
        Ok(format!("p = ln 0.5 / ln cos 10° = {}: with it the kernel gives {}.", tidy(exponent), tidy(light)))
    },
    draw: |values| {
        let [exponent, cutoff] = values.numbers([EXPONENT, CUTOFF]);
        let spot = opengl(exponent, cutoff)?;
        let beam = Beam::spot("cosᵖ, cut off at δ", spot)?;
        let inside = beam.at(0.999 * f64::from(cutoff));
        let whole = Beam::spot("cosᵖ", opengl(exponent, 90.0)?)?;
        let numbers = vec![
            ("Beam angle, at 50 %", spot.cone().beam().to_degrees().into(), "°"),
            ("Light just within the cutoff", inside, ""),
        ];
        Ok(Drawing { numbers, ..beams(&[beam, whole], 90.0, &[]) })
    },
};

/// Returns the light of a power of the cosine, cut off at a half angle in degrees.
pub(super) fn opengl(exponent: f32, cutoff: f32) -> Result<Steady, Refusal> {
    let cone = Cone::from_outer(AnyFalloff::power(exponent)?, Angle::degrees(180.0))?;
    steady(cone.with_cutoff(HalfAngle::degrees(cutoff))?)
}

pub(super) const CONES: Figure = Figure {
    name: "cones",
    title: "An inner and an outer cone",
    text: "Full light up to the inner angle, none from the outer angle on, and smoothstep between their cosines. The range fades the light with the distance by the same curve. The picture is a cut through the beam, with the lamp at the left.",
    formula: "smoothstep(cos outer, cos inner, cos a) · smoothstep(range, 0, d)",
    source: "The article on the dual-cone spotlight, “Implementation”; linear: Peng Engine’s blog, “Soft Spotlights”",
    parameters: &[
        Choice(
            "which",
            "Quantity",
            &[("inner", "Inner angle"), ("outer", "Outer angle"), ("range", "Range")],
        ),
        Dial(INNER, 10.0),
        Dial(OUTER, 20.0),
        Dial(RANGE, 12.0),
    ],
    question: "How bright is the axis at half the range?",
    answer: || {
        let light =
            SpotLight::between([0.0; 3], [12.0, 0.0, 0.0], dual(Smooth, 10.0, 20.0)?)?.compile::<f32>()?;
        Ok(format!(
            "{}: smoothstep of a half is a half.",
            tidy(light.irradiance_facing([6.0, 0.0, 0.0].into()))
        ))
    },
    draw: |values| {
        let [inner, outer, range] = values.numbers([INNER, OUTER, RANGE]);
        let cone = dual(Smooth, inner, outer)?;
        let spot = SpotLight::between([0.0; 3], [range, 0.0, 0.0], cone)?.compile::<f32>()?;
        let light =
            |x: f64, y: f64| spot.irradiance_facing([6.0 * x as f32, 6.0 * y as f32, 0.0].into()).into();
        let seen = format!("A cone of light from the left, {outer} degrees to each side of its axis");
        let both = [Beam::of("smoothstep", cone)?, Beam::of("linear", dual(Linear, inner, outer)?)?];
        let half = cone.beam().to_degrees() / 2.0;
        Ok(Drawing {
            pictures: vec![picture("A cut through the beam, 12 m long", seen, [640, 320], |x, y, _| {
                light(x + 1.0, y)
            })],
            numbers: vec![
                ("Half of the light at", half.into(), "°"),
                ("Light on the axis at 6 m", light(1.0, 0.0), ""),
            ],
            ..beams(&both, 1.2 * f64::from(outer), &[(inner.into(), "inner"), (outer.into(), "outer")])
        })
    },
};

fn dual<P: Falloff>(falloff: P, inner: f32, outer: f32) -> Result<Cone<P>, Refusal> {
    if inner > outer {
        return Err(Refusal::outside(INNER.label, inner, [0.0, outer], "degrees"));
    }
    Ok(Cone::from_outer(falloff, HalfAngle::degrees(outer))?.with_inner(HalfAngle::degrees(inner))?)
}

pub(super) const DIRECT3D: Figure = Figure {
    name: "direct3d",
    title: "Direct3D’s falloff",
    text: "Theta and Phi are whole angles, so the formula halves them. Between the two cones, the place among the cosines is raised to a power. With p = 1 it is the straight ramp from umbra to penumbra.",
    formula: "I = ((cos a − cos φ/2) / (cos θ/2 − cos φ/2))^p",
    source: "Microsoft DirectX 9.0, “Spotlight Model”; p = 1: Peng Engine’s blog, “Soft Spotlights”",
    parameters: &[
        Choice("which", "Quantity", &[("theta", "Theta"), ("phi", "Phi"), ("falloff", "Falloff")]),
        Dial(THETA, 20.0),
        Dial(PHI, 40.0),
        Dial(FALLOFF, 1.0),
    ],
    question: "Which Theta and Falloff make Hast’s soft spotlight, and how bright is it 15° off the axis with a Phi of 40°?",
    answer: || {
        let light = Beam::spot("", direct3d(0.0, 40.0, 2.0)?)?.at(15.0);
        Ok(format!("0 and 2 give ((cos a − τ) / (1 − τ))². At 15° it is {}.", tidy(light)))
    },
    draw: |values| {
        let [theta, phi, falloff] = values.numbers([THETA, PHI, FALLOFF]);
        let spot = direct3d(theta, phi, falloff)?;
        let beam = Beam::spot("Direct3D", spot)?;
        let [inner, outer] = [theta, phi].map(|angle| f64::from(angle) / 2.0);
        let middle = ("Light in the middle of the ramp", beam.at(f64::midpoint(inner, outer)), "");
        let numbers = vec![("Beam angle, at 50 %", spot.cone().beam().to_degrees().into(), "°"), middle];
        Ok(Drawing { numbers, ..beams(&[beam], 1.2 * outer, &[(inner, "θ/2"), (outer, "φ/2")]) })
    },
};

fn direct3d(theta: f32, phi: f32, falloff: f32) -> Result<Steady, Refusal> {
    if theta > phi {
        return Err(Refusal::outside(THETA.label, theta, [0.0, phi], "degrees"));
    }
    let (theta, phi) = (Angle::degrees(theta), Angle::degrees(phi));
    if theta == phi {
        return steady(Cone::from_outer(Step.into(), phi)?);
    }
    steady(Cone::from_outer(AnyFalloff::power(falloff)?, phi)?.with_inner(theta)?)
}
