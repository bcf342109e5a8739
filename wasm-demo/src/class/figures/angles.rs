//! Hast's two quadratics, and the angles of stage lighting.

use super::{
    cones::{Steady, opengl},
    *,
};
use luminaire::{
    error::Expected,
    falloff::{FittedFalloff, Hard, Soft},
};

pub(super) const EDGES: Figure = Figure {
    name: "edges",
    title: "A soft and a hard edge",
    text: "Two quadratics replace the power: the soft one flattens out before it ends, the hard one ends steeply. All three beams have the same field angle, at which a tenth of the light is left. Cut off earlier, as by an iris, even the soft edge is sharp.",
    formula: "soft: ((ρ − τ) / (1 − τ))²,   hard: 1 − ((1 − ρ) / (1 − τ))²,   Warn: ρ^C,   with ρ = cos a",
    source: "Hast 2004, sections 2 and 3, figure 7; the cutoff: section 5",
    parameters: &[Dial(FIELD, 15.0), Dial(CUT, 100.0)],
    question: "At a field angle of 15°, which beam angles have the soft, the hard and Warn’s distribution?",
    answer: || {
        let [soft, hard, warn] = beam_angles(15.0)?.map(tidy);
        Ok(format!(
            "{soft}°, {hard}° and {warn}°: the soft quadratic is close to the power, the hard one is not."
        ))
    },
    draw: |values| {
        let [field, cut] = values.numbers([FIELD, CUT]);
        let (soft, hard) = (Cone::soft(Angle::degrees(field))?, Cone::hard(Angle::degrees(field))?);
        let all = [
            Beam::of("soft", iris(soft, cut)?)?,
            Beam::of("hard", iris(hard, cut)?)?,
            Beam::spot("Warn, a power", warn(field)?)?,
        ];
        let [soft_beam, hard_beam, warn_beam] = beam_angles(field)?;
        let numbers = vec![
            ("Beam angle, soft", soft_beam, "°"),
            ("Beam angle, hard", hard_beam, "°"),
            ("Beam angle, Warn", warn_beam, "°"),
        ];
        let reach = f64::from(soft.outer().to_degrees()) * 0.55;
        Ok(Drawing { numbers, ..beams(&all, reach, &[(f64::from(field) / 2.0, "field")]) })
    },
};

/// The cone, cut off at a part of its outer angle in percent.
fn iris<P: Falloff>(cone: Cone<P>, part: f32) -> Result<Cone<P>, Refusal> {
    let cutoff = Angle::degrees(part / 100.0 * cone.outer().to_degrees());
    if part == 100.0 { Ok(cone) } else { Ok(cone.with_cutoff(cutoff)?) }
}

/// Warn's power of the cosine with this field angle.
fn warn(field: f32) -> Result<Steady, Refusal> {
    opengl((0.1_f64.ln() / (f64::from(field) / 2.0).to_radians().cos().ln()) as f32, 90.0)
}

/// The beam angles of soft, hard and Warn's light with this field angle.
fn beam_angles(field: f32) -> Result<[f64; 3], Refusal> {
    let angle = Angle::degrees(field);
    Ok([Cone::soft(angle)?.beam(), Cone::hard(angle)?.beam(), warn(field)?.cone().beam()]
        .map(|beam| beam.to_degrees().into()))
}

pub(super) const BEAM_FIELD: Figure = Figure {
    name: "beam-field",
    title: "Beam or field: one gives the other",
    text: "Stage lighting names two whole angles: at the beam angle half of the light is left, at the field angle a tenth. A quadratic has one free number, the cosine τ of half its outer angle, so that one angle determines the other. The kernel computes with 1 − cos, the versine, which keeps its digits in thin beams.",
    formula: "soft: δ = (1 − τ)/√2 + τ,  σ = (1 − τ)/√10 + τ;   hard: 1 − δ = (1 − τ)/√2,  1 − σ = (1 − τ) · 3/√10",
    source: "Hast 2004, equations 9, 11, 15 and 16: δ, σ and τ are cosines of half the beam, field and outer angle",
    parameters: &[
        Choice(
            "given",
            "Given",
            &[
                ("soft-field", "Soft, field angle"),
                ("soft-beam", "Soft, beam angle"),
                ("hard-field", "Hard, field angle"),
                ("hard-beam", "Hard, beam angle"),
            ],
        ),
        Dial(GIVEN, 15.0),
    ],
    question: "Why is there no soft beam of 120°?",
    answer: || {
        let refused = Cone::from_beam(Soft, Angle::degrees(120.0))
            .map_or_else(|error| error.to_string(), |_| String::new());
        let widest = tidy(Cone::from_outer(Soft, Angle::degrees(180.0))?.beam().to_degrees());
        Ok(format!(
            "At an outer angle of 180°, the widest, the beam angle is {widest}°. The kernel says: {refused}."
        ))
    },
    draw: |values| {
        let angle = Angle::degrees(values.numbers([GIVEN])[0]);
        match values.choice().as_str() {
            "soft-field" => angles("soft", Cone::from_field(Soft, angle)?),
            "soft-beam" => angles("soft", Cone::from_beam(Soft, angle)?),
            "hard-field" => angles("hard", Cone::from_field(Hard, angle)?),
            _ => angles("hard", Cone::from_beam(Hard, angle)?),
        }
    },
};

fn angles<P: Falloff + 'static>(label: &'static str, cone: Cone<P>) -> Result<Drawing, Refusal> {
    let [beam, field, outer] =
        [cone.beam(), cone.field(), cone.outer()].map(|angle| f64::from(angle.to_degrees()));
    Ok(Drawing {
        numbers: vec![
            ("Beam angle, at 50 %", beam, "°"),
            ("Field angle, at 10 %", field, "°"),
            ("Outer angle, at 0", outer, "°"),
        ],
        ..beams(&[Beam::of(label, cone)?], outer * 0.55, &[(beam / 2.0, "beam"), (field / 2.0, "field")])
    })
}

pub(super) const BOTH: Figure = Figure {
    name: "both",
    title: "Both angles at once",
    text: "A data sheet gives both angles, but a quadratic of Hast has only one. The kernel fits a falloff to both: a quadratic between hard and soft, a hard one with a bright core, or a cubic. The ratio r of the two versines decides which, and far ratios are refused; a soft edge, as a Fresnel has, ends farther out and has them, too.",
    formula: "r = (1 − cos field/2) / (1 − cos beam/2)",
    source: "Hast 2004, section 5, “Discussion”: a Fresnel of 15° field and 7° beam",
    parameters: &[Dial(BEAM, 7.0), Dial(FIELD, 15.0)],
    question: "How far is the paper’s soft quadratic from its Fresnel of 15° and 7°, and what does the kernel do?",
    answer: || {
        let [soft, _, _] = beam_angles(15.0)?.map(tidy);
        let cone = Cone::from_beam_and_field(Angle::degrees(7.0), Angle::degrees(15.0))?;
        let [beam, field] = [cone.beam(), cone.field()].map(|angle| tidy(angle.to_degrees()));
        Ok(format!(
            "With a field angle of {field}° its beam angle is {soft}°. The kernel has {beam}°, too, by {} that ends at \
             {}°, or by a soft edge that ends at {}°.",
            kind(&cone),
            tidy(cone.outer().to_degrees()),
            tidy(Cone::soft_from_beam_and_field(cone.beam(), cone.field())?.outer().to_degrees())
        ))
    },
    draw: |values| {
        let [beam, field] = values.numbers([BEAM, FIELD]).map(Angle::degrees);
        let nearest = match Cone::from_beam_and_field(beam, field).map_err(|error| error.accepted) {
            Err(Expected::AngleBetween(least, most)) => Angle::degrees(field.to_degrees().clamp(least, most)),
            _ => field,
        };
        let pair = [beam, nearest].map(|angle| tidy(angle.to_degrees()));
        let told = |error| format!("{error}. Drawn is the nearest pair, {}° and {}°.", pair[0], pair[1]);
        let refused = Cone::from_beam_and_field(beam, field).map_or_else(told, |_| String::new());
        let cone = Cone::from_beam_and_field(beam, nearest)?;
        let mut numbers = angles(kind(&cone), cone)?.numbers;
        numbers.push(("Ratio r of the chosen pair", (field.versine() / beam.versine()).into(), ""));
        let (mut curves, mut outer) = (vec![Beam::of(kind(&cone), cone)?], cone.outer());
        if let Ok(soft) = Cone::soft_from_beam_and_field(beam, nearest) {
            outer = soft.outer();
            numbers.push(("Outer angle of a soft edge", outer.to_degrees().into(), "°"));
            curves.push(Beam::of("a soft edge", soft)?);
        }
        let [beam, field, outer] =
            [cone.beam(), cone.field(), outer].map(|angle| f64::from(angle.to_degrees()) / 2.0);
        Ok(Drawing { refused, numbers, ..beams(&curves, outer * 1.1, &[(beam, "beam"), (field, "field")]) })
    },
};

/// The falloff that the kernel has fitted, in words.
fn kind(cone: &Cone<FittedFalloff>) -> &'static str {
    match cone.falloff() {
        FittedFalloff::Cubic(_) => "a cubic",
        FittedFalloff::Quadratic(_) if cone.has_hotspot() => "the hard quadratic with a bright core",
        FittedFalloff::Quadratic(_) => "a quadratic between hard and soft",
    }
}
