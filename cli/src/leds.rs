//! `luminaire leds`: a program that lights a strip of LEDs at the places of a map.

mod c;
mod options;
mod program;
mod reached;
mod rust;

use std::fs;

use luminaire_exchange::Refusal;
use luminaire_exchange::leds::{Facing, LedMap, PlacedLeds};
use luminaire_export::{Scene, export_scene, identifier, names};

use crate::model;
use crate::source::{Found, save, shown};
use crate::text::say;
pub(crate) use options::Leds;
use options::Target;
use program::{File, Program};
use reached::{check_turn, lit};

/// Writes the program. Returns whether no light was refused.
pub(crate) fn leds(options: &Leds) -> Result<bool, Refusal> {
    if !(0.0..=1.0).contains(&options.brightness) {
        return Err(Refusal::new("brightness", options.brightness, "a share from 0 to 1"));
    }
    let Found { lamps, ambient, is_scene, mut is_whole } = match options.source.load(&options.spot, false)? {
        Some(found) => found,
        None => options.source.own(model::light(&options.spot, None, options.source.kelvin)?)?,
    };
    if !is_scene && lamps.len() > 1 {
        let expected = "one end of a zoom: choose it by --light";
        return Err(Refusal::new("lights", lamps.len(), expected));
    }
    let language = options.to.language();
    let stem = options.output.file_name().map(shown).unwrap_or_default();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-.".contains(c);
    if !stem.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_') || !stem.chars().all(is_plain) {
        let expected =
            "a folder whose name is that of a sketch: letters, digits, and behind the first also _, - and .";
        return Err(Refusal::new("output", shown(options.output.as_os_str()), expected));
    }
    let file = shown(options.map.as_os_str());
    let text = fs::read_to_string(&options.map).map_err(|error| {
        Refusal::new("map", &file, format_args!("a file of text that can be read: {error}"))
    })?;
    let map = LedMap::read(&text).map_err(|refusal| refusal.at(&file))?;
    let facing = options.facing.into();
    if map.facing.is_none() && facing == Facing::Map {
        say(
            "note",
            "the map has no ways that the LEDs face: each takes the light of the side away from the upright axis through \
             their middle; --facing all takes that of all sides",
        );
    }
    let placed = PlacedLeds::new(map, options.up.into(), facing, options.height)?;
    let count = placed.places.len();
    if let Some(limit) = options.limit.filter(|limit| *limit as usize <= count) {
        let expected = format_args!("more than {count} mA, which {count} dark LEDs take");
        return Err(Refusal::new("limit", limit, expected));
    }

    let name = match options.to {
        Target::Arduino | Target::EspIdf => identifier(&stem, language),
        Target::Rust => rust::crate_name(&stem),
    };
    let mut lights = Vec::new();
    for (lamp, usage) in &lamps {
        match lamp.named(*usage) {
            Ok(named) => lights.push((lamp.name.as_str(), named.light)),
            Err(refusal) => {
                say("error", refusal.at(&lamp.name));
                is_whole = false;
            }
        }
    }
    let own = names(lights.iter().map(|(name, _)| *name), language);
    let named = own.iter().map(String::as_str).zip(lights.iter().map(|(_, light)| *light));
    let ambient: Vec<_> = ambient.iter().map(|ambient| ambient.light).collect();
    let (text, refused) = export_scene(&Scene { name: &name, ambient: &ambient }, named.clone(), language)?;
    for (number, error) in &refused {
        say("error", Refusal::from(error.clone()).at(lights[*number].0));
        is_whole = false;
    }
    let kept = (0..).zip(named).filter(|(number, _)| refused.iter().all(|(other, _)| other != number));
    let kept: Vec<_> = kept.collect();
    if options.turn > 0 {
        kept.iter().try_for_each(|(number, (_, light))| {
            check_turn(&placed, light).map_err(|refusal| refusal.at(lights[*number].0))
        })?;
    }
    let kept: Vec<_> = kept.into_iter().map(|(_, light)| light).collect();
    let lit = lit(&placed, kept.iter().map(|(_, light)| light))?;
    // The scene has another name than each light.
    let taken = kept.iter().map(|(name, _)| *name).chain([name.as_str()]);
    let name = names(taken, language).pop().unwrap_or(name);
    let program = Program { options, name: &name, stem: &stem, placed: &placed, lights: &kept };
    let files = match options.to {
        Target::Arduino => c::sketch(&program, &text),
        Target::EspIdf => c::project(&program, &text),
        Target::Rust => rust::files(&program, &text),
    };
    let folder = &options.output;
    // People change some of them, such as the pin of a sketch.
    let other = files.iter().find(|File { path, text, stays }| {
        *stays && fs::read(folder.join(path)).is_ok_and(|found| found != text.as_bytes())
    });
    if let Some(File { path, .. }) = other {
        let expected =
            format_args!("a folder without another {path}: move that away, or give --output another name");
        return Err(Refusal::new("output", shown(folder.as_os_str()), expected));
    }
    for File { path, text, .. } in &files {
        let path = folder.join(path);
        let parent = path.parent().unwrap_or(folder);
        fs::create_dir_all(parent).map_err(|error| {
            let expected = format_args!("a folder that can be made: {error}");
            Refusal::new("output", shown(parent.as_os_str()), expected)
        })?;
        save("output", &path, text)?;
    }
    let (flash, memory) = program.bytes();
    say(
        "note",
        format_args!(
            "{count} LEDs take {flash} bytes of flash and {memory} of memory; lights reach {lit} at first"
        ),
    );
    if lit == 0 {
        say(
            "note",
            "no light reaches an LED at first: --height 2 scales the map to lights in metres, and --position and --axis \
             place one light",
        );
    }
    Ok(is_whole)
}
