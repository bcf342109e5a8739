//! `luminaire leds`: a program that lights a strip of LEDs at the places of a map.

mod map;
mod program;
mod rust;

use std::fs;
use std::path::PathBuf;

use luminaire::dynamic::AnyLight;
use luminaire::{Fx16, Scalar, Vec3};
use luminaire_exchange::Refusal;
use luminaire_export::{Language, Scene, export_scene, identifier, names};

use crate::model;
use crate::source::{Found, Source, Spot, save, shown};
use crate::text::say;
use map::Map;
use program::{File, Program};

/// The options of `leds`.
#[derive(Debug, clap::Args)]
pub(crate) struct Leds {
    /// The places of the LEDs: a table of x,y,z, as of GIFT trees and marimapper, or a map of Pixelblaze or WLED
    #[arg(long, value_name = "FILE")]
    map: PathBuf,
    /// The folder of the program, which names it
    #[arg(long, value_name = "FOLDER")]
    output: PathBuf,
    /// What is written: a sketch of Arduino, a project of ESP-IDF or a crate of Rust
    #[arg(long, value_name = "TARGET", default_value = "arduino")]
    to: Target,
    /// The family of the chips
    #[arg(long, default_value = "ws2812")]
    chip: Family,
    /// The order of the channels [default: grb, of apa102 bgr]
    #[arg(long)]
    order: Option<Order>,
    /// The axis of the map that points up
    #[arg(long, default_value = "z")]
    up: Up,
    /// The side from which an LED takes light: as the map says, or without that away from the upright axis (map), always
    /// away from that axis (out), or all sides, where a light counts in full whatever its direction (all)
    #[arg(long, value_name = "SIDE", default_value = "map")]
    facing: Facing,
    /// The height to which the map is scaled, its lowest LED at 0 and its middle above 0,0,0 [default: as it is]
    #[arg(long)]
    height: Option<f64>,
    /// The current of the supply in milliamperes [default: no limit]
    #[arg(long, value_name = "MA")]
    limit: Option<u32>,
    /// The current of a channel at full duty in milliamperes
    #[arg(long, value_name = "MA", default_value = "20", requires = "limit",
        value_parser = clap::value_parser!(u16).range(1..))]
    channel: u16,
    /// The share of all light that is shown, which keeps the hue of dim light
    #[arg(long, value_name = "SHARE", default_value = "1")]
    brightness: f64,
    /// The seconds in which the lights turn about the LEDs; 0 for lights that stand still
    #[arg(long, value_name = "SECONDS", default_value = "20")]
    turn: u16,
    #[command(flatten)]
    spot: Spot,
    #[command(flatten)]
    source: Source,
}

/// What a program is for.
#[derive(Clone, Copy, PartialEq, Debug, clap::ValueEnum)]
enum Target {
    Arduino,
    EspIdf,
    Rust,
}

impl Target {
    /// The language of the lights.
    fn language(self) -> Language {
        match self {
            Self::Arduino | Self::EspIdf => Language::CFixed,
            Self::Rust => Language::RustFixed16,
        }
    }
}

/// The side from which an LED takes light.
#[derive(Clone, Copy, PartialEq, Debug, clap::ValueEnum)]
enum Facing {
    Map,
    Out,
    All,
}

/// A family of chips.
#[derive(Clone, Copy, PartialEq, Debug, clap::ValueEnum)]
enum Family {
    Ws2812,
    Sk6812Rgbw,
    Apa102,
    Hd108,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Order {
    Grb,
    Rgb,
    Bgr,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Up {
    Y,
    Z,
}

/// LEDs in the lights' coordinates, whose y axis points up.
struct Placed {
    places: Vec<[f64; 3]>,
    /// The side from which they take light: `map` only if the map says so.
    side: Facing,
    /// Unit vectors; none for LEDs that take light from all sides.
    facing: Option<Vec<[f64; 3]>>,
    /// The middle from above: x and z.
    middle: [f64; 2],
}

impl Placed {
    fn new(map: Map, up: Up, facing: Facing, height: Option<f64>) -> Result<Self, Refusal> {
        let upright = |[x, y, z]: [f64; 3]| match up {
            Up::Y => [x, y, z],
            Up::Z => [x, z, 0.0 - y],
        };
        let mut places: Vec<_> = map.places.into_iter().map(upright).collect();
        let ends = |axis: usize, places: &[[f64; 3]]| {
            let all = places.iter().map(|place| place[axis]);
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], own| [least.min(own), most.max(own)])
        };
        let middle = |places: &[[f64; 3]]| [0, 2].map(|axis| ends(axis, places).iter().sum::<f64>() / 2.0);
        if let Some(height) = height {
            let ([low, high], [x, z]) = (ends(1, &places), middle(&places));
            let scale = height / (high - low);
            if !(scale.is_finite() && scale > 0.0) {
                let expected = "a height over 0, and LEDs at more than one: --up chooses the axis";
                return Err(Refusal::new("height", height, expected));
            }
            for place in &mut places {
                *place = [(place[0] - x) * scale, (place[1] - low) * scale, (place[2] - z) * scale];
            }
        }
        let farthest = f64::from(Fx16::FARTHEST);
        if let Some((led, place)) =
            (0..).zip(&places).find(|(_, place)| place.iter().any(|c| c.abs() > farthest))
        {
            let expected = format_args!("coordinates up to {farthest}: scale the map by --height");
            return Err(
                Refusal::new("place", format_args!("{place:?}"), expected).at(format_args!("LED {led}"))
            );
        }
        let middle = middle(&places);
        let outward = |[x, _, z]: &[f64; 3]| [x - middle[0], 0.0, z - middle[1]];
        let (side, facing): (_, Option<Vec<_>>) = match (facing, map.facing) {
            (Facing::All, _) => (Facing::All, None),
            (Facing::Map, Some(facing)) => (Facing::Map, Some(facing.into_iter().map(upright).collect())),
            (Facing::Map | Facing::Out, _) => (Facing::Out, Some(places.iter().map(outward).collect())),
        };
        // An LED on the axis itself faces up.
        let unit = |way: [f64; 3]| {
            let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
            if length > 1e-9 && length.is_finite() { way.map(|c| c / length) } else { [0.0, 1.0, 0.0] }
        };
        let facing = facing.map(|facing| facing.into_iter().map(unit).collect());
        Ok(Self { places, side, facing, middle })
    }

    /// Returns how many LEDs have light other than the ambient one.
    fn lit<'a>(&self, lights: impl Iterator<Item = &'a AnyLight>) -> Result<usize, Refusal> {
        let lights = lights.map(AnyLight::compile::<f32>).collect::<Result<Vec<_>, _>>()?;
        let vector = |own: [f64; 3]| Vec3::from(own.map(|c| c as f32));
        let is_lit = |led: &usize| {
            let place = vector(self.places[*led]);
            let facing = self.facing.as_ref().map(|facing| vector(facing[*led]));
            lights.iter().any(|light| {
                let facing = facing.map(|facing| light.irradiance(place, facing));
                facing.unwrap_or_else(|| light.irradiance_facing(place)) > 0.0
            })
        };
        Ok((0..self.places.len()).filter(is_lit).count())
    }

    /// Refuses a light whose position would leave the coordinates of the format as it turns about the LEDs.
    fn check_turn(&self, light: &AnyLight) -> Result<(), Refusal> {
        let position = match light {
            AnyLight::Spot(light) => light.position(),
            AnyLight::Point(light) => light.position(),
            AnyLight::Measured(light) => light.position(),
            AnyLight::Directional(_) => return Ok(()),
        };
        let [x, z] = self.middle;
        let distance = (f64::from(position.x) - x).hypot(f64::from(position.z) - z);
        let most = f64::from(Fx16::FARTHEST) - x.abs().max(z.abs());
        if distance <= most {
            return Ok(());
        }
        let expected = format_args!(
            "at most {most} for a light that turns about them: --turn 0 lets it stand still, or place it nearer"
        );
        Err(Refusal::new("distance from the middle of the LEDs", distance, expected))
    }
}

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
    let map = Map::read(&text).map_err(|refusal| refusal.at(&file))?;
    if map.facing.is_none() && options.facing == Facing::Map {
        say(
            "note",
            "the map has no ways that the LEDs face: each takes the light of the side away from the upright axis through \
             their middle; --facing all takes that of all sides",
        );
    }
    let placed = Placed::new(map, options.up, options.facing, options.height)?;
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
            placed.check_turn(light).map_err(|refusal| refusal.at(lights[*number].0))
        })?;
    }
    let kept: Vec<_> = kept.into_iter().map(|(_, light)| light).collect();
    let lit = placed.lit(kept.iter().map(|(_, light)| light))?;
    // The scene has another name than each light.
    let taken = kept.iter().map(|(name, _)| *name).chain([name.as_str()]);
    let name = names(taken, language).pop().unwrap_or(name);
    let program = Program { options, name: &name, stem: &stem, placed: &placed, lights: &kept };
    let files = program.files(&text);
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
