//! `luminaire export`: lights as source, as JSON, or as the parameters of a tool.

use std::fmt::Write;

use luminaire_exchange::{Lamp, Place, Refusal, System, Use, parameters, write};
use luminaire_export::json::{self, NamedLight};
use luminaire_export::{ExportError, Language};

use crate::arguments::Export;
use crate::import::short;
use crate::model;
use crate::words::Target;

fn told(ExportError { parameter, value, expected }: ExportError) -> Refusal {
    Refusal::new(parameter, value, expected)
}

/// Returns the text of all lights.
pub(crate) fn export(options: &Export) -> Result<String, Refusal> {
    let own = |name: &str| options.name.clone().unwrap_or_else(|| name.to_owned());
    let Some(loaded) = options.source.load(&options.spot)? else {
        let light = model::light(options).map_err(told)?;
        let lamp = Lamp::new(own("light"), light);
        let throw = options.source.throw.unwrap_or(4.0);
        return written(&[lamp], Use { throw, full_scale: 1.0, is_photometric: false }, options);
    };
    if let Some(refusal) = loaded.lamps.refused.first() {
        return Err(refusal.clone());
    }
    written(&loaded.lamps.lamps, loaded.usage, options)
}

fn written(lamps: &[Lamp], usage: Use, options: &Export) -> Result<String, Refusal> {
    let mut names: Vec<String> = Vec::new();
    for lamp in lamps {
        let name = match (&options.name, lamps.len()) {
            (Some(name), 1) => name.clone(),
            (Some(name), _) => format!("{name}_{}", names.len() + 1),
            (None, 1) if !matches!(options.to, Target::Tool(_)) => "light".to_owned(),
            (None, _) => identifier(&lamp.name, &names),
        };
        names.push(name);
    }
    let mut lights = Vec::new();
    for lamp in lamps {
        lights.push(placed(lamp.named(usage)?, options)?);
    }
    match options.to {
        Target::Language(Language::Json) => {
            if let ([light], Some(name)) = (&mut lights[..], &options.name) {
                light.name.clone_from(name);
            }
            json::write(&lights).map_err(told)
        }
        Target::Language(language) => {
            let sources = lights.iter().zip(&names).map(|(light, name)| {
                let refused = |error| {
                    if lights.len() > 1 { told(error).at(&light.name) } else { told(error) }
                };
                luminaire_export::export(light.light, name, language).map_err(refused)
            });
            Ok(sources.collect::<Result<Vec<_>, _>>()?.join("\n"))
        }
        Target::Tool(tool) => {
            let mut text = String::new();
            for lamp in lamps {
                tell(&mut text, lamp, tool, usage).map_err(|refusal| refusal.at(&lamp.name))?;
            }
            Ok(text)
        }
        Target::Ies => match lamps {
            [lamp] => {
                let curve = lamp.curve().ok_or_else(|| Refusal::new("light", &lamp.name, "a spotlight"))?;
                Ok(write::ies(&lamp.name, &curve))
            }
            _ => Err(Refusal::new("lights", lamps.len(), "one light: choose it by --light")),
        },
    }
}

/// Returns a light at the position, with the axis, the intensity and the colour of the options.
fn placed(mut named: NamedLight, options: &Export) -> Result<NamedLight, Refusal> {
    let spot = &options.spot;
    let place =
        Place { position: spot.position, axis: spot.axis, intensity: spot.intensity, color: options.color };
    named.light = luminaire_exchange::placed(named.light, place)?;
    Ok(named)
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
    let angle = found.angle;
    let _ = writeln!(
        text,
        "# over the angle: within {} of 255 codes (found {} at {} degrees off the axis: {} for {} of full scale)",
        short(angle.bound),
        short(angle.found),
        short(angle.degrees),
        short(angle.fitted),
        short(angle.measured)
    );
    let _ = writeln!(
        text,
        "# over the distance: {} codes found from {} to {}",
        short(found.distance),
        usage.throw,
        16.0 * usage.throw
    );
    for note in found.notes.iter().copied().chain(lamp.notes.iter().map(String::as_str)) {
        let _ = writeln!(text, "# {note}");
    }
    Ok(())
}
