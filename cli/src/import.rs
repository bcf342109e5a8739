//! `luminaire import`: what files and numbers of other tools say, as lights.

use std::fmt::Write;

use luminaire::dynamic::AnyLight;
use luminaire_exchange::{Definition, Difference, Lamp, Lamps, Refusal, Residual, Use};
use luminaire_export::json::{self, NamedAmbient};
use luminaire_export::printable;
use serde_json::Value;

use crate::arguments::Import;
use crate::chart;
use crate::source::{Input, Loaded, save};
use crate::text::short;

/// Returns the text of the lights, and whether no file and no light was refused.
pub(crate) fn import(options: &Import) -> Result<(String, bool), Refusal> {
    let inputs = options.source.inputs(&options.spot)?;
    if inputs.is_empty() {
        let expected =
            "a file, a folder, --from with a tool and its numbers, --fixture, or --lumens and angles";
        return Err(Refusal::new("files", "none", expected));
    }
    options.source.say_idle(&options.spot, false, &inputs);
    if let Some(file) = &options.svg {
        let loaded = inputs.iter().filter_map(|input| input.loaded.as_ref().ok());
        let lamps: Vec<_> = loaded.flat_map(|loaded| &loaded.lamps.lamps).collect();
        save("svg", file, chart::svg(&lamps))?;
    }
    let (mut text, [mut files, mut lights, mut refused]) = (String::new(), [0; 3]);
    for Input { name, is_file, loaded } in &inputs {
        match loaded {
            Err(refusal) => {
                refused += 1;
                let _ = writeln!(text, "{}: refused\n  {refusal}", shown(name));
            }
            Ok(Loaded { lamps, usage }) => {
                files += 1;
                lights += lamps.lamps.len() + lamps.ambient.len();
                refused += lamps.refused.len();
                let system = if *is_file { format!(" ({})", lamps.system) } else { String::new() };
                tell(&mut text, &(shown(name) + &system), lamps, *usage);
            }
        }
    }
    if inputs.len() > 1 {
        let _ = writeln!(text, "{files} files with {lights} lights, {refused} refused");
    }
    Ok((if options.json { document(&inputs)? } else { text }, refused == 0))
}

/// Returns the lights as a document, with their files and what was refused.
fn document(inputs: &[Input]) -> Result<String, Refusal> {
    let (mut all, mut refused) = (json::Lights::default(), Vec::new());
    for Input { name, loaded, .. } in inputs {
        let own = match loaded {
            Err(refusal) => std::slice::from_ref(refusal),
            Ok(Loaded { lamps, usage }) => {
                for lamp in &lamps.lamps {
                    let mut light = lamp.named(*usage)?;
                    light.about.get_or_insert_default()["from"] = name.as_str().into();
                    all.lights.push(light);
                }
                for ambient in &lamps.ambient {
                    all.ambient.push(usage.ambient(ambient)?);
                }
                &lamps.refused
            }
        };
        refused.extend(own.iter().map(|Refusal { place, parameter, value, expected }| {
            serde_json::json!({ "file": name, "place": place, "parameter": parameter, "value": value, "expected": expected })
        }));
    }
    let refused = (!refused.is_empty()).then_some(Value::Array(refused));
    Ok(json::write_with(&all, refused)?)
}

fn tell(text: &mut String, name: &str, lamps: &Lamps, usage: Use) {
    let count = lamps.lamps.len() + lamps.ambient.len();
    let _ = writeln!(text, "{name}: {count} light{}", if count == 1 { "" } else { "s" });
    for lamp in &lamps.lamps {
        describe(text, lamp, usage);
    }
    for NamedAmbient { name, light } in &lamps.ambient {
        let unit = if usage.is_photometric { " lux" } else { "" };
        let (name, intensity) = (shown(name), short(light.intensity().into()));
        let _ = writeln!(text, "  {name}: {}, intensity {intensity}{unit}\n    exact", json::AMBIENT);
    }
    for note in &lamps.notes {
        let _ = writeln!(text, "  note: {}", printable(note));
    }
    for refusal in &lamps.refused {
        let _ = writeln!(text, "  refused: {refusal}");
    }
}

fn describe(text: &mut String, lamp: &Lamp, usage: Use) {
    let light = &lamp.light;
    let unit = if matches!(light, AnyLight::Directional(_)) { " lux" } else { " cd" };
    let (unit, intensity) = (if usage.is_photometric { unit } else { "" }, short(lamp.own_intensity()));
    let (name, kind) = (shown(&lamp.name), json::kind(light));
    let _ = write!(text, "  {name}: {kind}, intensity {intensity}{unit}");
    if let Some(kelvin) = lamp.kelvin {
        let _ = write!(text, ", {} K", short(kelvin.into()));
    }
    if let AnyLight::Spot(spot) = light {
        let cone = spot.cone();
        let [beam, field, outer] =
            [cone.beam(), cone.field(), cone.outer()].map(|angle| short(angle.to_degrees().into()));
        let name = cone.falloff().effect().name();
        let _ = write!(text, ", beam {beam}, field {field}, ends at {outer} degrees, {name}");
    }
    if let Some(range) = lamp.attenuation().and_then(|attenuation| attenuation.range()) {
        let _ = write!(text, ", range {}", short(range.into()));
    }
    let Difference { angle, distance, .. } = lamp.difference;
    let [codes, percent] = [255.0 * angle, 100.0 * distance].map(|part| short(part.into()));
    let _ = if lamp.difference == Difference::default() {
        let open = ", with an assumed edge: two angles would determine it";
        writeln!(text, "\n    exact{}", if lamp.is_assumed { open } else { "" })
    } else {
        writeln!(
            text,
            "\n    differs by up to {codes} of 255 codes over the angle and {percent} % over the distance"
        )
    };
    if let Some(curve) = &lamp.measured {
        let angles = |definition| {
            let angle = |share| curve.angle(share, definition).map_or_else(|| "none".to_owned(), short);
            [angle(0.5), angle(0.1)]
        };
        let ([beam, field], cie, (peak, at)) =
            (angles(Definition::Ies), angles(Definition::Cie), curve.peak());
        let (peak, at, lumens, throw) = (short(peak), short(at), short(curve.lumens()), usage.throw);
        let _ = writeln!(
            text,
            "    measured: {peak} cd at {at} degrees off the axis, {lumens} lm, beam {beam} and field {field} degrees \
             (of the axis: {}), {} lux at {throw}",
            cie.join(" and "),
            short(curve.at(0.0) / throw.powi(2))
        );
    }
    if let Some((chosen, others)) = lamp.fits.split_last() {
        let Residual { found, bound, degrees, .. } = chosen.residual;
        let ([bound, found, degrees], name) = ([bound, found, degrees].map(short), chosen.name);
        let _ = writeln!(
            text,
            "    {name}: within {bound} of 255 codes (found {found} at {degrees} degrees off the axis)"
        );
        if let Some(best) = others.iter().min_by(|a, b| a.residual.bound.total_cmp(&b.residual.bound)) {
            let bound = short(best.residual.bound);
            let _ = writeln!(text, "    the best that is cheaper, {}: within {bound}", best.name);
        }
    }
    for note in &lamp.notes {
        let _ = writeln!(text, "    note: {}", printable(note));
    }
}

/// Returns a name of a file or a light as a terminal shows it, cut after 160 characters.
fn shown(name: &str) -> String {
    printable(name).chars().take(160).collect()
}
