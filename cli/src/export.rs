//! `luminaire export`: lights as source, as JSON, or as the parameters of a tool.

use std::fmt::Write;

use luminaire_exchange::{Lamp, Place, Refusal, Residual, System, Use, parameters, placed, write};
use luminaire_export::{Language, json};

use crate::arguments::Export;
use crate::model;
use crate::source::Loaded;
use crate::text::short;
use crate::words::Target;

/// Returns the text of all lights.
pub(crate) fn export(options: &Export) -> Result<String, Refusal> {
    let (lamps, usage) = match options.source.load(&options.spot)? {
        None => {
            let name = options.name.as_deref().unwrap_or("light");
            let throw = options.source.throw.unwrap_or(4.0);
            let usage = Use { throw, full_scale: 1.0, is_photometric: false };
            (vec![Lamp::new(name, model::light(options)?)], usage)
        }
        Some(Loaded { lamps, usage }) => match lamps.refused.into_iter().next() {
            None => (lamps.lamps, usage),
            Some(refusal) => {
                let expected = format!("{}; --light chooses one of the other lights", refusal.expected);
                return Err(Refusal { expected, ..refusal });
            }
        },
    };
    let mut names: Vec<String> = Vec::new();
    let mut lights = Vec::new();
    for lamp in &lamps {
        names.push(match (&options.name, lamps.len()) {
            (Some(name), 1) => name.clone(),
            (Some(name), _) => format!("{name}_{}", names.len() + 1),
            (None, 1) => "light".to_owned(),
            (None, _) => identifier(&lamp.name, &names),
        });
        let mut named = lamp.named(usage)?;
        named.light = placed(named.light, Place { color: options.color, ..Place::default() })?;
        lights.push(named);
    }
    match options.to {
        Target::Language(Language::Json) => {
            if let ([light], Some(name)) = (&mut lights[..], &options.name) {
                light.name.clone_from(name);
            }
            Ok(json::write(&lights)?)
        }
        Target::Language(language) => {
            let sources = lights.iter().zip(&names).map(|(light, name)| {
                let refused = |error| match Refusal::from(error) {
                    refusal if lights.len() > 1 => refusal.at(&light.name),
                    refusal => refusal,
                };
                luminaire_export::export(light.light, name, language).map_err(refused)
            });
            Ok(sources.collect::<Result<Vec<_>, _>>()?.join("\n"))
        }
        Target::Tool(tool) => {
            let mut text = String::new();
            for lamp in &lamps {
                tell(&mut text, lamp, tool, usage).map_err(|refusal| refusal.at(&lamp.name))?;
            }
            Ok(text)
        }
        Target::Ies => match &lamps[..] {
            [lamp] => write::ies(lamp),
            _ => Err(Refusal::new("lights", lamps.len(), "one light: choose it by --light")),
        },
    }
}

/// Returns a name as an identifier that none of the others has.
fn identifier(name: &str, others: &[String]) -> String {
    let mut own: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect();
    while own.contains("__") {
        own = own.replace("__", "_");
    }
    let own = own.trim_matches('_').to_owned();
    let is_letter = own.starts_with(|c: char| c.is_ascii_lowercase()) && !own.starts_with("luminaire");
    let own = if is_letter { own } else { format!("light_{own}").trim_end_matches('_').to_owned() };
    let numbered = (2..).map(|number| format!("{own}_{number}"));
    std::iter::once(own.clone()).chain(numbered).find(|name| !others.contains(name)).unwrap_or(own)
}

/// Writes the parameters of a light in a tool, with what differs.
fn tell(text: &mut String, lamp: &Lamp, tool: System, usage: Use) -> Result<(), Refusal> {
    let found = parameters(lamp, tool, usage)?;
    let name = luminaire_export::printable(&lamp.name);
    let _ = writeln!(text, "# {name} in {tool}: key=value in its own names and units");
    for (key, value) in &found.values {
        let _ = writeln!(text, "{key}={value}");
    }
    let Residual { found: most, bound, degrees, measured, fitted } = found.angle;
    let [most, bound, degrees, measured, fitted] = [most, bound, degrees, measured, fitted].map(short);
    let _ = writeln!(
        text,
        "# over the angle: within {bound} of 255 codes (found {most} at {degrees} degrees off the axis: {fitted} for \
         {measured} of full scale)"
    );
    let (codes, throw) = (short(found.distance), usage.throw);
    let _ = writeln!(text, "# over the distance: {codes} codes found from {throw} to {}", 16.0 * throw);
    for note in found.notes.iter().copied().chain(lamp.notes.iter().map(String::as_str)) {
        let _ = writeln!(text, "# {note}");
    }
    Ok(())
}
