//! `luminaire export`: lights as source, as JSON, or as the parameters of a tool.

use std::path::Path;

use luminaire::Rgb;
use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire_exchange::{Lamp, Parameters, Patched, Refusal, Residual, System, Use, parameters, write};
use luminaire_export::json::{self, Lights};
use luminaire_export::{Language, export_all, export_patch, export_scene, identifier, names, printable};

use crate::arguments::Export;
use crate::model;
use crate::source::{Found, save, shown};
use crate::text::{say, short};
use crate::words::Target;

/// Returns the text of the lights, and whether none was refused. Those are said.
pub(crate) fn export(options: &Export) -> Result<(String, bool), Refusal> {
    let has_channels = matches!(options.to, Target::Language(language) if language.has_channels());
    if let Some(address) = options.address.filter(|_| !has_channels) {
        let expected =
            format_args!("none in {}: c-fx16, rust-f32, rust-fx32 and rust-fx16 have channels", options.to);
        return Err(Refusal::new("address", address, expected));
    }
    let has_throw = matches!(options.to, Target::Tool(_));
    let found = match options.source.load(&options.spot, has_throw)? {
        Some(found) => found,
        None => {
            let light = model::light(&options.spot, options.color, options.source.kelvin)?;
            options.source.own(light)?
        }
    };
    let Found { mut lamps, ambient, is_scene, mut is_whole } = found;
    let is_one = lamps.len() + ambient.len() == 1;
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
    let mut refuse = |name: &str, refusal: Refusal| {
        say("error", if is_one { refusal } else { refusal.at(name) });
        is_whole = false;
    };
    let is_alone = !is_scene || lamps.len() < 2 && ambient.is_empty();
    let scene_name = scene_name(options, is_alone)?.filter(|_| !(lamps.is_empty() && ambient.is_empty()));
    if scene_name.is_none() && !matches!(options.to, Target::Language(Language::Json)) {
        for own in &ambient {
            let expected = format_args!("a spot, point or directional light in {}", options.to);
            refuse(&own.name, Refusal::new("light", json::AMBIENT, expected));
        }
    }
    let mut text = String::new();
    let scene = match (options.to, &options.output) {
        (Target::Tool(tool), Some(file)) => write::extension(tool)
            .map(|extension| Ok::<_, Refusal>((tool, Scene::new(extension, file)?)))
            .transpose()?,
        _ => None,
    };
    let mut entries = Vec::new();
    match options.to {
        Target::Language(language) => {
            let mut lights = Vec::new();
            for (lamp, usage) in &lamps {
                match lamp.named(*usage) {
                    Ok(named) => lights.push((lamp, named)),
                    Err(refusal) => refuse(&lamp.name, refusal),
                }
            }
            if language == Language::Json {
                let lights: Vec<_> = lights.into_iter().map(|(_, named)| named).collect();
                if !lights.is_empty() || !ambient.is_empty() {
                    text = json::write(&Lights { lights, ambient })?;
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
                let (written, refused) = match &scene_name {
                    Some(name) => {
                        let ambient: Vec<_> = ambient.iter().map(|ambient| ambient.light).collect();
                        export_scene(&luminaire_export::Scene { name, ambient: &ambient }, named, language)?
                    }
                    None => export_all(named, language),
                };
                text = written;
                if let Some(address) = options.address {
                    let kept = |number: usize| refused.iter().all(|(other, _)| *other != number);
                    let lamps: Vec<_> = lights.iter().map(|(lamp, _)| *lamp).collect();
                    text += &patches(&lamps, &names, kept, address, language)?;
                }
                for (number, error) in refused {
                    refuse(&lights[number].0.name, error.into());
                }
            }
        }
        Target::Tool(tool) => {
            for (lamp, usage) in &lamps {
                let usage = if options.source.throw.is_some() { *usage } else { usage.within(lamp) };
                let found = match parameters(lamp, tool, usage) {
                    Ok(found) => found,
                    Err(refusal) => {
                        refuse(&lamp.name, refusal);
                        continue;
                    }
                };
                let mut lines = told(lamp, &found, usage);
                if scene.is_some() {
                    entries.push(write::Entry { lamp, found, usage, lines });
                    continue;
                }
                lines.extend(found.profile.map(|profile| format!("note: {profile}")));
                text += &found.text(lamp);
                lines.iter().for_each(|line| text += &format!("# {line}\n"));
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
    match (scene, &options.output) {
        (Some((tool, scene)), _) if !entries.is_empty() => {
            scene.write(tool, &write::scene(tool, &scene.stem, &entries)?)?
        }
        (None, Some(file)) if !text.is_empty() => save("output", file, std::mem::take(&mut text))?,
        _ => {}
    }
    Ok((text, is_whole))
}

/// Returns the name of the scene in a source that has one: that of lights which shine together, or of any if the user
/// names it.
fn scene_name(options: &Export, is_alone: bool) -> Result<Option<String>, Refusal> {
    let language = match options.to {
        Target::Language(language) if language.has_scenes() => language,
        _ => {
            let expected = format_args!("none in {}, which has each light alone", options.to);
            return options
                .scene
                .as_ref()
                .map_or(Ok(None), |name| Err(Refusal::new("scene", name, expected)));
        }
    };
    if options.scene.is_some() || is_alone {
        return Ok(options.scene.clone());
    }
    let source = &options.source;
    let files: Vec<_> = source.from.iter().chain(&source.values).collect();
    let stem = if let [file] = files[..] { Path::new(file).file_stem() } else { None };
    let stem = stem.map_or_else(|| "scene".to_owned(), shown);
    Ok(Some(identifier(&stem, language)))
}

/// A scene to write.
struct Scene<'a> {
    folder: &'a Path,
    /// The name of its file without the extension.
    stem: String,
}

impl<'a> Scene<'a> {
    fn new(extension: &str, file: &'a Path) -> Result<Self, Refusal> {
        let stem = file.file_stem().and_then(|stem| stem.to_str());
        // What ends a path in a stage, and what has no place in one.
        let stem = stem.filter(|stem| printable(stem) == **stem && !stem.contains("@@@"));
        match (file.parent(), stem) {
            (Some(folder), Some(stem)) if file.extension().is_some_and(|own| own == extension) => {
                Ok(Self { folder, stem: stem.to_owned() })
            }
            _ => {
                let expected = format_args!("a name that ends with .{extension}, printable and without @@@");
                Err(Refusal::new("output", shown(file.as_os_str()), expected))
            }
        }
    }

    /// Writes the files, the scene first, and says which profiles are beside it.
    ///
    /// # Errors
    /// A profile in place of a photometric file that this command did not write; nothing is written then.
    fn write(&self, tool: System, files: &[(String, String)]) -> Result<(), Refusal> {
        for (name, text) in files.iter().skip(1) {
            let own: usize = text.lines().take(3).map(|line| line.len() + 2).sum();
            let path = self.folder.join(name);
            if std::fs::read(&path).is_ok_and(|bytes| !bytes.starts_with(&text.as_bytes()[..own])) {
                let expected = "no file, or one that luminaire wrote: give --output another name";
                return Err(Refusal::new("output", shown(path.as_os_str()), expected));
            }
        }
        files.iter().try_for_each(|(name, text)| save("output", &self.folder.join(name), text))?;
        let profiles: Vec<_> = files.iter().skip(1).map(|(name, _)| name.as_str()).collect();
        if !profiles.is_empty() {
            let which = match tool {
                System::Usd => "for a tool that reads no IES profile, take the numbers of its comments",
                _ => "its second scene has the lights by IES profiles, its first one by their numbers",
            };
            say("note", format_args!("{} names {}; {which}", files[0].0, profiles.join(", ")));
        }
        Ok(())
    }
}

/// Returns what differs of a light in a tool, and what to know, a line each.
fn told(lamp: &Lamp, found: &Parameters, usage: Use) -> Vec<String> {
    let mut lines = Vec::new();
    let Residual { found: most, bound, degrees, measured, fitted } = found.angle;
    let [most, bound, degrees, measured, fitted] = [most, bound, degrees, measured, fitted].map(short);
    if lamp.curve().is_some() {
        lines.push(format!(
            "over the angle: within {bound} of 255 codes (found {most} at {degrees} degrees off the axis: {fitted} \
             for {measured} of full scale)"
        ));
    }
    if lamp.attenuation().is_some() {
        let (codes, throw) = (short(found.distance), usage.throw);
        lines.push(format!("over the distance: {codes} of 255 codes found from {throw} to {}", 16.0 * throw));
    }
    let notes = found.notes.iter().copied().chain(lamp.notes.iter().map(String::as_str));
    lines.extend(notes.map(|note| format!("note: {}", printable(note))));
    lines
}

/// Returns the channels of the fixtures at an address, each of the lights of a zoom once.
fn patches(
    lamps: &[&Lamp],
    names: &[String],
    kept: impl Fn(usize) -> bool,
    address: u16,
    language: Language,
) -> Result<String, Refusal> {
    let mut text = String::new();
    for (number, lamp) in lamps.iter().enumerate().filter(|(number, _)| kept(*number)) {
        let Some(Patched { patch, mode, notes }) = &lamp.patch else { continue };
        let patch = patch.at_address(address).map_err(|error| {
            let refusal = Refusal::from(error);
            refusal.at(format!("{} at address {address}", lamp.name))
        })?;
        // Behind the narrowest zoom is the widest, if it was chosen and taken.
        let cone = |light: AnyLight| if let AnyLight::Spot(spot) = light { Some(spot.cone()) } else { None };
        let is_widest = |next: &&Lamp| lamp.widest.is_some_and(|widest| cone(widest) == cone(next.light));
        let next = lamps.get(number + 1).copied().filter(|next| is_widest(next) && kept(number + 1));
        let narrow = names[number].as_str();
        let wide = next.map_or(narrow, |_| &names[number + 1]);
        say("note", format_args!("{}: the channels are those of its mode {mode}", lamp.name));
        notes.iter().for_each(|note| say("note", format_args!("{}: {note}", lamp.name)));
        text += "\n";
        text += &export_patch([narrow, wide], &patch, language)?;
    }
    if text.is_empty() {
        let expected = "a GDTF fixture whose mode has channels for pan, tilt, zoom, dimmer or a colour";
        return Err(Refusal::new("address", address, expected));
    }
    Ok(text)
}
