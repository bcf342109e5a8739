//! `luminaire leds`: a sketch that lights a strip of LEDs at the places of a map.

mod map;

use std::fmt::Write;
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

/// The texts of a program: words in capitals are replaced.
const LEDS: &str = include_str!("leds/leds.h");
const WIRE: &str = include_str!("leds/wire.ino");
const SPI: &str = include_str!("leds/spi.ino");

/// The options of `leds`.
#[derive(Debug, clap::Args)]
pub(crate) struct Leds {
    /// The places of the LEDs: a table of x,y,z, as of GIFT trees and marimapper, or a map of Pixelblaze or WLED
    #[arg(long, value_name = "FILE")]
    map: PathBuf,
    /// The folder of the sketch, which names it
    #[arg(long, value_name = "FOLDER")]
    output: PathBuf,
    /// The family of the chips
    #[arg(long, default_value = "ws2812")]
    chip: Family,
    /// The order of the channels [default: grb, of apa102 bgr]
    #[arg(long)]
    order: Option<Order>,
    /// The axis of the map that points up
    #[arg(long, default_value = "z")]
    up: Up,
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

impl Family {
    /// What people call it, its constant in C, and the bytes of an LED.
    fn words(self) -> (&'static str, &'static str, usize) {
        match self {
            Self::Ws2812 => ("WS2812", "", 3),
            Self::Sk6812Rgbw => ("SK6812 RGBW", " + LUMINAIRE_LED_RGBW", 4),
            Self::Apa102 => ("APA102", " + LUMINAIRE_LED_APA102", 4),
            Self::Hd108 => ("HD108", " + LUMINAIRE_LED_HD108", 8),
        }
    }

    /// The bytes of memory of an LED: those on the wire for a library that sends all at once, or the carries of three
    /// channels.
    fn memory(self) -> usize {
        match self {
            Self::Ws2812 | Self::Sk6812Rgbw => self.words().2,
            Self::Apa102 => 6,
            Self::Hd108 => 0,
        }
    }
}

/// LEDs in the lights' coordinates, whose y axis points up.
struct Placed {
    places: Vec<[f64; 3]>,
    /// Unit vectors.
    facing: Vec<[f64; 3]>,
    /// The middle from above: x and z.
    middle: [f64; 2],
}

impl Placed {
    fn new(map: Map, up: Up, height: Option<f64>) -> Result<Self, Refusal> {
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
        let facing: Vec<_> = match map.facing {
            Some(facing) => facing.into_iter().map(upright).collect(),
            None => places.iter().map(outward).collect(),
        };
        // An LED on the axis itself faces up.
        let unit = |way: [f64; 3]| {
            let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
            if length > 1e-9 && length.is_finite() { way.map(|c| c / length) } else { [0.0, 1.0, 0.0] }
        };
        Ok(Self { places, facing: facing.into_iter().map(unit).collect(), middle })
    }

    /// Returns how many LEDs have light other than the ambient one.
    fn lit<'a>(&self, lights: impl Iterator<Item = &'a AnyLight>) -> Result<usize, Refusal> {
        let lights = lights.map(AnyLight::compile::<f32>).collect::<Result<Vec<_>, _>>()?;
        let vector = |own: [f64; 3]| Vec3::from(own.map(|c| c as f32));
        let is_lit = |(place, facing): &(&[f64; 3], &[f64; 3])| {
            lights.iter().any(|light| light.irradiance(vector(**place), vector(**facing)) > 0.0)
        };
        Ok(self.places.iter().zip(&self.facing).filter(is_lit).count())
    }
}

/// Writes the sketch. Returns whether no light was refused.
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
    let language = Language::CFixed;
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
    if map.facing.is_none() {
        say(
            "note",
            "the map has no ways that the LEDs face: each faces away from the upright axis through their middle",
        );
    }
    let placed = Placed::new(map, options.up, options.height)?;
    let count = placed.places.len();
    if let Some(limit) = options.limit.filter(|limit| *limit as usize <= count) {
        let expected = format_args!("more than {count} mA, which {count} dark LEDs take");
        return Err(Refusal::new("limit", limit, expected));
    }

    let name = identifier(&stem, language);
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
    let kept: Vec<_> = kept.map(|(_, light)| light).collect();
    let lit = placed.lit(kept.iter().map(|(_, light)| light))?;
    let turns = turns(&name, kept.into_iter());
    let words = words(options, &name, &placed, &turns);
    let sketch = if matches!(options.chip, Family::Ws2812 | Family::Sk6812Rgbw) { WIRE } else { SPI };
    let folder = &options.output;
    fs::create_dir_all(folder).map_err(|error| {
        Refusal::new("output", shown(folder.as_os_str()), format_args!("a folder that can be made: {error}"))
    })?;
    let write = |file: &str, text: &str| save("output", &folder.join(file), text);
    // The builder of Arduino takes the sketch of the folder's own name. People change it, such as its pin.
    let (file, sketch) = (format!("{stem}.ino"), replaced(sketch, &words));
    if fs::read(folder.join(&file)).is_ok_and(|found| found != sketch.as_bytes()) {
        let expected =
            format_args!("a folder without another {file}: move that away, or give --output another name");
        return Err(Refusal::new("output", shown(folder.as_os_str()), expected));
    }
    write(&file, &sketch)?;
    write("leds.h", &replaced(LEDS, &words))?;
    write(&format!("{name}_lights.h"), &text)?;
    let (flash, memory) = (18 * count, options.chip.memory() * count);
    say(
        "note",
        format_args!(
            "{count} LEDs take {flash} bytes of flash and {memory} of memory; lights reach {lit} at first"
        ),
    );
    Ok(is_whole)
}

/// Returns the statements that turn each light that has a place.
fn turns<'a>(name: &str, lights: impl Iterator<Item = (&'a str, AnyLight)>) -> String {
    let mut text = String::new();
    let placed = lights.filter(|(_, light)| !matches!(light, AnyLight::Directional(_)));
    for (number, (light, own)) in placed.enumerate() {
        let way = if number % 2 == 0 { "turn" } else { "0 - turn" };
        let (function, aims) = match own {
            AnyLight::Measured(_) => ("measured_turned", ""),
            AnyLight::Spot(_) => ("light_turned", " 1,"),
            AnyLight::Point(_) | AnyLight::Directional(_) => ("light_turned", " 0,"),
        };
        let _ = writeln!(text, "    {name}_{function}(&scene->{light}, &{name}_start.{light},{aims} {way});");
    }
    text
}

/// What is put in place of each word of the texts.
fn words(options: &Leds, name: &str, placed: &Placed, turns: &str) -> Vec<(&'static str, String)> {
    let Leds { chip, order, limit, channel, brightness, turn, .. } = options;
    let (chip_words, family, bytes) = chip.words();
    let (count, guard) = (placed.places.len(), name.to_ascii_uppercase());
    let steps = |value: f64, bits: i32| (value * 2_f64.powi(bits)).round() as i64;
    let lines = |rows: &[[f64; 3]], bits| {
        let mut text = String::new();
        for row in rows {
            let [x, y, z] = row.map(|c| steps(c, bits));
            let _ = writeln!(text, "    {{ {x}, {y}, {z} }},");
        }
        text
    };
    let standard = if *chip == Family::Apa102 { Order::Bgr } else { Order::Grb };
    let order = match order.unwrap_or(standard) {
        Order::Grb => "GRB",
        Order::Rgb => "RGB",
        Order::Bgr => "BGR",
    };
    let (most, channel) = limit.map_or((0, 0), |limit| (limit, *channel));
    let dimmed = 65_536 - steps(*brightness, 16);
    let strip = format!("{most}, {channel}, 1, LUMINAIRE_LED_{order}{family}, {dimmed}");
    // An APA102 changes its current with the light, so that its carries need memory.
    let carries = if *chip == Family::Apa102 {
        format!(
            "    static uint16_t all[{guard}_COUNT][3];\n    uint16_t *carries = all[led];\n    \
             if (number == 0) {{ luminaire_led_start(carries, {name}_strip.order, led); }}"
        )
    } else {
        format!(
            "    uint16_t carries[4];\n    luminaire_led_start(carries, {name}_strip.order, led + number);"
        )
    };
    let (mode, begin, last, end) = match chip {
        // A bit for each two LEDs, behind four bytes.
        Family::Apa102 => ("SPI_MODE0", 4, "0", 4 + count.div_ceil(16)),
        _ => ("SPI_MODE3", 16, "0xff", count.div_ceil(8)),
    };
    let wire = format!("NEO_{order}{}", if *chip == Family::Sk6812Rgbw { "W" } else { "" });
    let [x, z] = placed.middle.map(|c| steps(c, 16));
    let lights = if turns.is_empty() || *turn == 0 {
        "lights that stand still"
    } else {
        "lights that turn about them"
    };
    let (period, moves) = match turn {
        0 => (String::new(), String::new()),
        seconds => (
            format!("const uint32_t TURN = {seconds}000; // milliseconds of a turn of the lights\n\n"),
            format!("    {name}_turn(&scene, (uint32_t)((uint64_t)(millis() % TURN) * 65536 / TURN));\n"),
        ),
    };
    vec![
        ("PLACES", lines(&placed.places, 16)),
        ("FACING", lines(&placed.facing, 14)),
        ("CARRIES", carries),
        ("TURNS", turns.to_owned()),
        ("STRIP", strip),
        ("MIDDLE", format!("{x}, {z}")),
        ("PERIOD", period),
        ("MOVE", moves),
        ("BYTES", bytes.to_string()),
        ("MODE", mode.to_owned()),
        ("BEGIN", begin.to_string()),
        ("LAST", last.to_owned()),
        ("END", end.to_string()),
        ("WIRE", wire),
        ("CHIP", chip_words.to_owned()),
        ("WHAT", lights.to_owned()),
        ("GUARD", guard),
        ("NAME", name.to_owned()),
        ("COUNT", count.to_string()),
    ]
}

/// Replaces each word in braces.
fn replaced(text: &str, words: &[(&str, String)]) -> String {
    let mut text = text.to_owned();
    for (word, own) in words {
        text = text.replace(&format!("{{{word}}}"), own);
    }
    text
}
