//! Numbers and answers of `pick` as text.

use std::fmt::{Display, Write};
use std::io::Write as _;

use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire_export::printable;
use luminaire_pick::{Answer, Counted, Farther, Light, SceneAnswer, Tolerance};

/// Writes a line to the standard error. Nothing can be done if that fails.
pub(crate) fn say(word: &str, text: impl Display) {
    let _ = writeln!(std::io::stderr(), "{word}: {}", printable(&text.to_string()));
}

/// Returns an answer as text, with all parameters of its request, including defaults.
pub(crate) fn answer(answer: &Answer, farther: &[Farther]) -> String {
    let Answer { light, chip, display, evaluation, price, bound, .. } = answer;
    let at = bound.at;
    let unit = unit(answer);
    let fine = match price.fine_share {
        0.0 => String::new(),
        share => format!(", {:.0} % of the points by the fine evaluation", 100.0 * share),
    };
    let cycles = match price.cycles {
        Some(cycles) => format!("{cycles} on an RP2040 without wait states"),
        None => "not counted for this processor".to_owned(),
    };
    let worst = match price.worst {
        Some(worst) => format!("{worst} instructions, the most that a search finds"),
        None => "not counted for this evaluation on this processor".to_owned(),
    };
    let counted = match price.counted {
        Counted::Whole => "counted as a whole",
        Counted::Parts => "the sum of counted parts",
    };
    let mut excepted = String::new();
    if bound.edge_degrees > 0.0 {
        let _ = write!(excepted, "; but within {} degrees of its edge", digits(bound.edge_degrees.into()));
    }
    if bound.range > 0.0 {
        let _ = write!(excepted, "; but within {} of its range", digits(bound.range.into()));
    }
    let cheaper = answer.cheaper.map_or_else(String::new, |cheaper| {
        let (evaluation, bound) = (cheaper.evaluation, digits(cheaper.bound));
        format!("cheaper      {evaluation}: {} instructions, at most {bound} {unit}\n", cheaper.instructions)
    });
    format!(
        "light        {}\n\
         target       {chip}, {display}, at most {} {unit}\n\
         evaluation   {evaluation}\n\
         instructions {} a lit point, {counted}{fine}\n\
         worst case   {worst}\n\
         cycles       {cycles}\n\
         code         {} bytes\n\
         error        at most {} {unit} ({}; largest found {}){excepted}\n\
         \x20            largest {:.3} degrees off axis, distance {:.3}, cosine of incidence {:.3}\n\
         {cheaper}{}\n\
         {}",
        described(light, answer.outer),
        answer.tolerance.amount(),
        price.instructions,
        price.bytes,
        digits(bound.value),
        bound.label,
        digits(bound.found),
        at.degrees_off_axis,
        at.distance,
        at.cosine,
        farther.iter().map(|own| format!("farther      {}\n", beyond(own))).collect::<String>(),
        answer.code,
    )
}

/// Returns from which distance on an evaluation is good enough.
fn beyond(Farther { evaluation, instructions, from }: &Farther) -> String {
    format!("{evaluation}: {instructions:.1} instructions, with surfaces from {} on", short((*from).into()))
}

/// Returns what a light is and where its surfaces are.
fn described(light: &Light, outer: Option<f32>) -> String {
    let distances = format!("distances {} to {}", light.near, light.far);
    match light.any() {
        Ok(AnyLight::Spot(spot)) => format!(
            "{} edge, ends at {:.2} degrees; attenuation {}, intensity {}, {distances}",
            falloff(light),
            outer.unwrap_or_default(),
            attenuation(light, &spot.attenuation()),
            spot.intensity()
        ),
        Ok(AnyLight::Point(point)) => format!(
            "point light; attenuation {}, intensity {}, {distances}",
            attenuation(light, &point.attenuation()),
            point.intensity()
        ),
        Ok(AnyLight::Measured(measured)) => format!(
            "measured light; attenuation {}, intensity {}, {distances}",
            attenuation(light, &measured.attenuation()),
            measured.intensity()
        ),
        Ok(AnyLight::Directional(sun)) => format!("directional light; intensity {}", sun.intensity()),
        Err(refusal) => refusal.to_string(),
    }
}

/// Returns the name of the falloff of a light, or of its kind if it has none.
fn falloff(light: &Light) -> &'static str {
    match light.any() {
        _ if light.light.is_none() && light.beam.is_some() && light.field.is_some() => "fitted",
        Ok(AnyLight::Spot(spot)) => spot.cone().falloff().row().name,
        Ok(AnyLight::Point(_)) => "point",
        Ok(AnyLight::Measured(_)) => "measured",
        Ok(AnyLight::Directional(_)) => "directional",
        Err(_) => light.edge.name(),
    }
}

/// Returns the name of an attenuation, and how it ends.
fn attenuation(light: &Light, law: &AnyAttenuation) -> String {
    let row = law.row();
    // By its own name in the options.
    let name = if light.light.is_none() { light.attenuation.name() } else { row.law };
    match (law.range(), row.window) {
        (Some(range), Some(window)) => format!("{name} to {range} ({window})"),
        (Some(range), None) => format!("{name} to {range}"),
        (None, _) => name.to_owned(),
    }
}

/// Returns a number with three decimals, or below 0.001 with two significant digits and an
/// exponent.
fn digits(value: f64) -> String {
    if value == 0.0 || value >= 1e-3 { format!("{value:.3}") } else { format!("{value:.1e}") }
}

fn unit(answer: &Answer) -> &'static str {
    match answer.tolerance {
        Tolerance::Steps(_) => "steps",
        Tolerance::Codes(_) => "linear codes",
    }
}

/// Returns a line for each answer, and the sum of the instructions.
pub(crate) fn lights(answers: &[Answer], farther: &[Vec<Farther>]) -> String {
    let mut text = String::new();
    for (answer, farther) in answers.iter().zip(farther) {
        let Answer { light, outer, evaluation, price, bound, .. } = answer;
        let (edge, instructions) = (falloff(light), price.instructions);
        let outer = outer.map_or_else(String::new, |outer| format!("{outer:.2} degrees"));
        let worst = price.worst.map_or_else(String::new, |worst| format!("{worst} at worst, "));
        let _ = writeln!(
            text,
            "{:24} {edge:12} {outer:14}  {evaluation:10} {instructions:8.1} instructions, {worst}at most {} {}",
            light.name,
            digits(bound.value),
            unit(answer)
        );
        for own in farther {
            let _ = writeln!(text, "{:24} {}", "", beyond(own));
        }
    }
    let sum: f64 = answers.iter().map(|answer| answer.price.instructions).sum();
    let _ = writeln!(text, "sum {sum:.1} instructions");
    text
}

/// Returns the lights and the error budget of a scene as text.
pub(crate) fn scene(answer: &SceneAnswer, farther: &[Vec<Farther>]) -> String {
    let budget = answer.budget;
    let mut text = lights(&answer.lights, farther);
    if let Some(fx16) = answer.instructions_fx16 {
        let _ = writeln!(text, "by fx16 everywhere {fx16:.1} instructions");
    }
    let _ = writeln!(
        text,
        "error of the picture: lights {:.3} + materials {:.3} = {:.3}; the display rounds by {} of a step more",
        budget.lights, budget.materials, budget.total, budget.display_rounding
    );
    text
}

/// Returns a number with four significant digits, and large numbers whole.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = (3.0 - value.abs().log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
