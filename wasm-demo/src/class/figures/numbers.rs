//! What numbers do to light: bits, cancellation, and the codes of a display.

use super::*;
use luminaire::{Fx16, attenuation::NoAttenuation, display::threshold, falloff::Soft};
use luminaire_oracle::{srgb_code, srgb_linear, versine, versine_between};

pub(super) const BITS_FIGURE: Figure = Figure {
    name: "bits",
    title: "How many bits does light need?",
    text: "The soft quadratic, whose place t and square are rounded to n bits: a sign, one bit before the point, and n − 2 behind it. With few bits the pool gets rings. With 16 it has the steps of the kernel’s 16-bit format, 2⁻¹⁴.",
    formula: "t = round((ρ − τ) / (1 − τ)),   light = round(t · t)",
    source: "Hast 2004, section 2, in the arithmetic of a chip without floats",
    parameters: &[Dial(BITS, 8.0)],
    question: "Rounding t and rounding the square cost half a step each. Why is the error more than one step?",
    answer: || {
        let [few, many] = [8.0, 16.0].map(|bits| tidy(rounding(bits)));
        Ok(format!(
            "The square doubles the error of t near 1: 2t · ½ + ½ is up to 1.5 steps. Found over the beam: {few} with 8 bits, {many} with 16."
        ))
    },
    draw: |values| {
        let [bits] = values.numbers([BITS]);
        let cone = Cone::soft(Angle::degrees(30.0))?;
        let spot = SpotLight::new([0.0; 3], single(AXIS), cone)?
            .with_attenuation(NoAttenuation)
            .compile::<Fx16>()?;
        let (steps, outer) = (steps(bits), f64::from(cone.outer_versine()));
        let few = Beam::by("in n bits", move |place| {
            let versine = versine_between(DVec3::from(place.map(f64::from)), AXIS);
            rounded((1.0 - versine / outer).max(0.0), steps) as f32
        });
        let fx16 =
            Beam::by("the kernel’s 16 bits", move |place| spot.falloff_at(Fx16::point(place)).to_f32());
        Ok(Drawing {
            numbers: vec![
                ("Largest error", rounding(bits), " steps"),
                ("A step", 255.0 / steps, " of 255 codes"),
                ("Levels from 0 to 1", steps + 1.0, ""),
            ],
            ..beams(&[few, fx16], f64::from(cone.outer().to_degrees()) * 0.55, &[])
        })
    },
};

/// The steps from 0 to 1 in n bits.
fn steps(bits: f32) -> f64 {
    (f64::from(bits) - 2.0).exp2()
}

fn rounded(t: f64, steps: f64) -> f64 {
    let round = |value: f64| (value * steps).round() / steps;
    round(round(t) * round(t))
}

/// The largest error over the beam, in steps.
fn rounding(bits: f32) -> f64 {
    let places = (0..=65_536).map(|i| f64::from(i) / 65_536.0);
    places.map(|t| (rounded(t, steps(bits)) - t * t).abs() * steps(bits)).fold(0.0, f64::max)
}

pub(super) const VERSINE: Figure = Figure {
    name: "versine",
    title: "Thin beams lose their digits",
    text: "In a thin beam all cosines are nearly 1, and their difference loses its digits. Half the squared distance of the two unit vectors is the same number, but it is small from the start. Both pictures are the soft quadratic in 32-bit floats.",
    formula: "1 − l·s  =  |l − s|² / 2",
    source: "Hast 2004, section 2: ρ as a dot product; the second form is the kernel’s",
    parameters: &[Dial(THIN, 0.05)],
    question: "Floats just below 1 have steps of 6·10⁻⁸. How many of them does 1 − cos have in a beam of 0.05°?",
    answer: || {
        let versine = Angle::from(HalfAngle::degrees(0.05)).versine();
        Ok(format!(
            "1 − cos 0.05° = {versine:.2e}: {} steps, so the light has hardly more levels.",
            (versine / (f32::EPSILON / 2.0)).floor()
        ))
    },
    draw: |values| {
        let [half] = values.numbers([THIN]);
        let (axis, tau, reach) = (single(AXIS), half.to_radians().cos(), 1.2 * f64::from(half));
        let naive = Beam::by("1 − l·s", move |[x, y, z]| {
            let rho = x * axis[0] + y * axis[1] + z * axis[2];
            ((rho - tau) / (1.0 - tau)).clamp(0.0, 1.0).powi(2)
        });
        let ours = Beam::of("|l − s|²/2, the kernel", Cone::from_outer(Soft, HalfAngle::degrees(half))?)?;
        let error =
            |beam: &Beam| beam.error(reach, |found| (1.0 - found / versine(half.into())).max(0.0).powi(2));
        let numbers = vec![
            ("Largest error of 1 − l·s", error(&naive), " of 255 codes"),
            ("Of |l − s|²/2", error(&ours), " of 255 codes"),
        ];
        let refused = if tau < 1.0 {
            String::new()
        } else {
            format!(
                "half angle = {half}: expected over 0.014°, below which a cosine is 1 in 32-bit floats. By 1 − l·s the light is 0 / 0."
            )
        };
        Ok(Drawing { numbers, refused, ..beams(&[naive, ours], reach, &[]) })
    },
};

pub(super) const BANDS: Figure = Figure {
    name: "bands",
    title: "Bands, and how dither hides them",
    text: "A display has few codes, and a soft gradient between two of them becomes a band. sRGB spends more codes on dark light, where eyes see steps best. Dither shows the upper of two codes in as many pixels as the mean light needs.",
    formula: "code = round((2^n − 1) · light),   or of the light after sRGB’s curve",
    source: "IEC 61966-2-1 for sRGB; the kernel’s ordered dither, after Bayer 1973",
    parameters: &[
        Choice(
            "coding",
            "Coding",
            &[
                ("linear", "Linear"),
                ("srgb", "sRGB"),
                ("linear-dithered", "Linear, dithered"),
                ("srgb-dithered", "sRGB, dithered"),
            ],
        ),
        Dial(CODE_BITS, 4.0),
    ],
    question: "With 4 bits, how many codes are there for light up to a tenth?",
    answer: || {
        Ok(format!(
            "{} of 16 if the codes are linear, {} in sRGB.",
            dark_codes(4.0, false),
            dark_codes(4.0, true)
        ))
    },
    draw: |values| {
        let ([bits], coding) = (values.numbers([CODE_BITS]), values.choice());
        let (is_srgb, is_dithered) = (coding.starts_with("srgb"), coding.ends_with("dithered"));
        let shown =
            |light, place| light_of(code(light, bits, is_srgb, is_dithered.then_some(place)), bits, is_srgb);
        let beam = Beam::of("", Cone::soft(Angle::degrees(60.0))?)?;
        let pool = |x: f64, y: f64, place| shown(beam.at(38.0 * x.hypot(y)), place);
        let words = |what| format!("{what} in {bits} bits, {coding}");
        Ok(Drawing {
            pictures: vec![
                picture("A soft pool", words("A soft pool of light"), [360; 2], pool),
                picture("Light from 0 to 1", words("A ramp from dark to light"), [640, 60], |x, _, place| {
                    shown((x + 1.0) / 2.0, place)
                }),
            ],
            numbers: vec![
                ("Codes", f64::from(bits).exp2(), ""),
                ("Codes for light up to 0.1", dark_codes(bits, is_srgb) as f64, ""),
                ("The first light above 0", light_of(1.0, bits, is_srgb), ""),
            ],
            ..Drawing::default()
        })
    },
};

/// The light of a code of n bits.
fn light_of(code: f64, bits: f32, is_srgb: bool) -> f64 {
    let share = code / (f64::from(bits).exp2() - 1.0);
    if is_srgb { srgb_linear(255.0 * share) } else { share }
}

/// The code of light in n bits: the nearest, or that of the kernel's dither at a pixel.
pub(crate) fn code(light: f64, bits: f32, is_srgb: bool, dithered: Option<[u32; 2]>) -> f64 {
    let last = f64::from(bits).exp2() - 1.0;
    let exact = last * if is_srgb { srgb_code(light) / 255.0 } else { light };
    let Some([x, y]) = dithered else { return exact.round() };
    let lower = exact.floor().min(last - 1.0);
    let [below, above] = [lower, lower + 1.0].map(|code| light_of(code, bits, is_srgb));
    lower + f64::from((light - below) * 128.0 > (above - below) * f64::from(threshold(x, y)))
}

/// How many codes have at most a tenth of the light.
fn dark_codes(bits: f32, is_srgb: bool) -> usize {
    (0..1 << bits as u32).filter(|code| light_of((*code).into(), bits, is_srgb) <= 0.1).count()
}
