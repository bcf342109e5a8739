//! `luminaire import`: what files and numbers of other tools say, as lights.

use std::fmt::Write as _;
use std::io::{IsTerminal, Write as _, stderr};

use luminaire::dynamic::AnyLight;
use luminaire_exchange::{Definition, Lamp, Lamps, Refusal, Residual, System, Use};
use luminaire_export::json;
use serde_json::{Value, json};

use crate::arguments::Import;
use crate::chart;
use crate::source::open;

/// A file with its lights.
struct Input {
    name: String,
    lamps: Result<Lamps, Refusal>,
}

/// Returns the text of the lights, and whether no file and no light was refused.
pub(crate) fn import(options: &Import) -> Result<(String, bool), Refusal> {
    let inputs = inputs(options)?;
    let is_good = |input: &Input| input.lamps.as_ref().is_ok_and(|lamps| lamps.refused.is_empty());
    let done = inputs.iter().all(is_good);
    let mut all = Vec::new();
    for Input { lamps, .. } in &inputs {
        let Ok(lamps) = lamps else { continue };
        let usage = options.source.usage(lamps)?;
        all.extend(lamps.lamps.iter().map(|lamp| (lamp, usage)));
    }
    if let Some(file) = &options.svg {
        let lamps: Vec<_> = all.iter().map(|(lamp, _)| *lamp).collect();
        let written = std::fs::write(file, chart::svg(&lamps));
        written.map_err(|error| {
            Refusal::new("svg", file, format_args!("a file that can be written: {error}"))
        })?;
    }
    if options.json {
        return Ok((document(&inputs, &all)?, done));
    }
    let mut text = String::new();
    let mut counts = [0; 3];
    for Input { name, lamps } in &inputs {
        match lamps {
            Err(refusal) => {
                counts[2] += 1;
                let _ = writeln!(text, "{}: refused\n  {refusal}", shown(name));
            }
            Ok(lamps) => {
                counts[0] += 1;
                counts[1] += lamps.lamps.len();
                counts[2] += lamps.refused.len();
                let usage = options.source.usage(lamps)?;
                tell(&mut text, name, lamps, usage);
            }
        }
    }
    let [files, lights, refused] = counts;
    if inputs.len() > 1 {
        let _ = writeln!(text, "{files} files with {lights} lights, {refused} refused");
    }
    Ok((text, done))
}

fn inputs(options: &Import) -> Result<Vec<Input>, Refusal> {
    let source = &options.source;
    let system = source.from.as_ref().map(|from| from.parse::<System>());
    // With a tool, words with `=` are its numbers. A sheet needs neither.
    let is_numbers = matches!(system, Some(Ok(_))) && source.values.iter().all(|word| word.contains('='));
    if is_numbers || source.values.is_empty() {
        let Some(loaded) = source.load(&options.spot)? else {
            return Err(Refusal::new(
                "files",
                "none",
                "a file, --from with a tool and its numbers, --fixture, or --lumens and angles",
            ));
        };
        let name = source.from.clone().or(source.fixture.clone()).unwrap_or_else(|| "data sheet".to_owned());
        return Ok(vec![Input { name, lamps: Ok(loaded.lamps) }]);
    }
    let system = system.transpose()?;
    let (count, mut inputs) = (source.values.len(), Vec::new());
    let shows_progress = count > 20 && stderr().is_terminal();
    for (done, file) in source.values.iter().enumerate() {
        if shows_progress && done % 16 == 0 {
            let _ = write!(stderr(), "\r{done} of {count} files");
        }
        inputs.push(Input { name: file.clone(), lamps: open(file, system, source.fit) });
    }
    if shows_progress {
        let _ = write!(stderr(), "\r\x1b[K");
    }
    Ok(inputs)
}

/// Returns the lights as a document, with what was refused.
fn document(inputs: &[Input], lamps: &[(&Lamp, Use)]) -> Result<String, Refusal> {
    let mut lights = Vec::new();
    for (lamp, usage) in lamps {
        lights.push(lamp.named(*usage)?);
    }
    let mut refused = Vec::new();
    for Input { name, lamps } in inputs {
        let own: &[Refusal] = lamps.as_ref().map_or_else(std::slice::from_ref, |lamps| &lamps.refused);
        refused.extend(own.iter().map(|refusal| {
            json!({ "file": name, "place": refusal.place, "parameter": refusal.parameter, "value": refusal.value, "expected": refusal.expected })
        }));
    }
    let refused = (!refused.is_empty()).then_some(Value::Array(refused));
    json::write_with(&lights, refused)
        .map_err(|error| Refusal::new(error.parameter, error.value, error.expected))
}

fn tell(text: &mut String, name: &str, lamps: &Lamps, usage: Use) {
    let count = lamps.lamps.len();
    let _ = writeln!(
        text,
        "{} ({}): {count} light{}",
        shown(name),
        lamps.system,
        if count == 1 { "" } else { "s" }
    );
    for lamp in &lamps.lamps {
        describe(text, lamp, usage);
    }
    for note in &lamps.notes {
        let _ = writeln!(text, "  note: {note}");
    }
    for refusal in &lamps.refused {
        let _ = writeln!(text, "  refused: {refusal}");
    }
}

fn describe(text: &mut String, lamp: &Lamp, usage: Use) {
    let light = &lamp.light;
    let kind = match light {
        AnyLight::Spot(_) => "spot",
        AnyLight::Point(_) => "point",
        AnyLight::Directional(_) => "directional",
    };
    let unit = match (usage.is_photometric, light) {
        (true, AnyLight::Directional(_)) => " lux",
        (true, _) => " cd",
        (false, _) => "",
    };
    let _ =
        write!(text, "  {}: {kind}, intensity {}{unit}", shown(&lamp.name), short(light.intensity().into()));
    if let AnyLight::Spot(spot) = light {
        let cone = spot.cone();
        let [beam, field, outer] =
            [cone.beam(), cone.field(), cone.outer()].map(|angle| short(angle.to_degrees().into()));
        let _ = write!(
            text,
            ", beam {beam}, field {field}, ends at {outer} degrees, {}",
            cone.falloff().effect().name()
        );
    }
    let range = match light {
        AnyLight::Spot(spot) => spot.attenuation().range(),
        AnyLight::Point(point) => point.attenuation().range(),
        AnyLight::Directional(_) => None,
    };
    if let Some(range) = range {
        let _ = write!(text, ", range {}", short(range.into()));
    }
    let difference = lamp.difference;
    let told = if difference == luminaire::import::Difference::default() {
        "exact".to_owned()
    } else {
        let angle = short((255.0 * difference.angle).into());
        format!(
            "differs by up to {angle} of 255 codes over the angle and {} % over the distance",
            short((100.0 * difference.distance).into())
        )
    };
    let _ = writeln!(text, "\n    {told}");
    if let Some(curve) = &lamp.measured {
        let angle =
            |share, definition| curve.angle(share, definition).map_or_else(|| "none".to_owned(), short);
        let [ies, cie] = [Definition::Ies, Definition::Cie].map(|own| [angle(0.5, own), angle(0.1, own)]);
        let (peak, at) = curve.peak();
        let _ = writeln!(
            text,
            "    measured: {} cd at {} degrees off the axis, {} lm, beam {} and field {} degrees (of the axis: {} and {}), {} lux at {}",
            short(peak),
            short(at),
            short(curve.lumens()),
            ies[0],
            ies[1],
            cie[0],
            cie[1],
            short(curve.at(0.0) / usage.throw.powi(2)),
            usage.throw
        );
    }
    if let Some((chosen, others)) = lamp.fits.split_last() {
        let Residual { found, bound, degrees, .. } = chosen.residual;
        let _ = writeln!(
            text,
            "    {}: within {} of 255 codes (found {} at {} degrees off the axis)",
            chosen.name,
            short(bound),
            short(found),
            short(degrees)
        );
        let best = others.iter().min_by(|a, b| a.residual.bound.total_cmp(&b.residual.bound));
        if let Some(best) = best {
            let _ = writeln!(
                text,
                "    the best that is cheaper, {}: within {}",
                best.name,
                short(best.residual.bound)
            );
        }
    }
    for note in &lamp.notes {
        let _ = writeln!(text, "    note: {note}");
    }
}

/// Returns a name of a file or a light as a terminal shows it, cut after 160 characters.
fn shown(name: &str) -> String {
    luminaire_export::printable(name).chars().take(160).collect()
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
