//! `luminaire export`: lights as source, as JSON, or as the parameters of a tool.

use std::fmt::Write;

use luminaire::Rgb;
use luminaire::attenuation::AnyAttenuation;
use luminaire_exchange::{Lamp, Refusal, Residual, System, Use, parameters, write};
use luminaire_export::{Language, export_all, json, names, printable};

use crate::arguments::Export;
use crate::model;
use crate::source::Found;
use crate::text::{say, short};
use crate::words::Target;

/// Returns the text of the lights, and whether none was refused. Those are said.
pub(crate) fn export(options: &Export) -> Result<(String, bool), Refusal> {
    let has_throw = matches!(options.to, Target::Tool(_));
    let found = match options.source.load(&options.spot, has_throw)? {
        Some(found) => found,
        None => {
            let throw = options.source.throw.unwrap_or(4.0);
            let usage = Use { throw, full_scale: 1.0, is_photometric: false };
            Found { lamps: vec![(Lamp::new("light", model::light(options)?), usage)], is_whole: true }
        }
    };
    let Found { mut lamps, mut is_whole } = found;
    let is_one = lamps.len() == 1;
    for (number, (lamp, _)) in (1..).zip(&mut lamps) {
        match &options.name {
            Some(name) if is_one => lamp.name.clone_from(name),
            Some(name) => lamp.name = format!("{name}_{number}"),
            None => {}
        }
        if let Some(color) = options.color {
            lamp.set_color(color)?;
        }
    }
    let mut refuse = |lamp: &Lamp, refusal: Refusal| {
        say("error", if is_one { refusal } else { refusal.at(&lamp.name) });
        is_whole = false;
    };
    let mut text = String::new();
    match options.to {
        Target::Language(language) => {
            let mut lights = Vec::new();
            for (lamp, usage) in &lamps {
                match lamp.named(*usage) {
                    Ok(named) => lights.push((lamp, named)),
                    Err(refusal) => refuse(lamp, refusal),
                }
            }
            if language == Language::Json {
                let lights: Vec<_> = lights.into_iter().map(|(_, named)| named).collect();
                if !lights.is_empty() {
                    text = json::write(&lights)?;
                }
            } else {
                let own = lights.iter().map(|(lamp, _)| lamp.name.as_str());
                // A name of the user is accepted or refused, and not changed.
                let names = if options.name.is_some() {
                    own.map(str::to_owned).collect()
                } else {
                    names(own, language)
                };
                let named = names.iter().map(String::as_str).zip(lights.iter().map(|(_, named)| named.light));
                let (written, refused) = export_all(named, language);
                text = written;
                for (number, error) in refused {
                    refuse(lights[number].0, error.into());
                }
            }
        }
        Target::Tool(tool) => {
            for (lamp, usage) in &lamps {
                let usage = if options.source.throw.is_some() { *usage } else { usage.within(lamp) };
                if let Err(refusal) = tell(&mut text, lamp, tool, usage) {
                    refuse(lamp, refusal);
                }
            }
        }
        Target::Ies => match &lamps[..] {
            [] => {}
            [(lamp, _)] => {
                text = write::ies(lamp)?;
                let is_white = lamp.light.color() == Rgb::new(1.0, 1.0, 1.0);
                if !is_white || !matches!(lamp.attenuation(), Some(AnyAttenuation::InverseSquare(_))) {
                    say(
                        "note",
                        "ies has intensities over the angle alone: no colour, and no law of the distance",
                    );
                }
            }
            lamps => {
                return Err(Refusal::new("lights", lamps.len(), "one light in ies: choose it by --light"));
            }
        },
    }
    Ok((text, is_whole))
}

/// Writes the parameters of a light in a tool, with what differs.
fn tell(text: &mut String, lamp: &Lamp, tool: System, usage: Use) -> Result<(), Refusal> {
    let found = parameters(lamp, tool, usage)?;
    *text += &found.text(lamp);
    let Residual { found: most, bound, degrees, measured, fitted } = found.angle;
    let [most, bound, degrees, measured, fitted] = [most, bound, degrees, measured, fitted].map(short);
    if lamp.curve().is_some() {
        let _ = writeln!(
            text,
            "# over the angle: within {bound} of 255 codes (found {most} at {degrees} degrees off the axis: {fitted} \
             for {measured} of full scale)"
        );
    }
    if lamp.attenuation().is_some() {
        let (codes, throw) = (short(found.distance), usage.throw);
        let _ = writeln!(
            text,
            "# over the distance: {codes} of 255 codes found from {throw} to {}",
            16.0 * throw
        );
    }
    for note in found.notes.iter().copied().chain(lamp.notes.iter().map(String::as_str)) {
        let _ = writeln!(text, "# note: {}", printable(note));
    }
    Ok(())
}
