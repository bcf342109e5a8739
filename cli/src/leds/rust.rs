//! The words of a crate of Rust.

use std::path::Path;

use luminaire::dynamic::AnyLight;
use luminaire_export::{Language, identifier};

use super::options::{Family, Order};
use super::program::{File, Program, Words, lines, replaced, steps};

/// The texts of a crate: words in braces are replaced.
const MANIFEST: &str = include_str!("rust/Cargo.toml.txt");
const LIBRARY: &str = include_str!("rust/lib.txt");
const PLACES: &str = include_str!("rust/places.txt");
const TURNING: &str = include_str!("rust/turning.txt");
const TURNED: &str = include_str!("rust/turned.txt");

/// The folder of the kernel that this command was built with.
const CORE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../core");

/// Returns the files of a crate with the text of the lights.
pub(super) fn files(program: &Program<'_>, lights: &str) -> Vec<File> {
    let words = [own_words(program), program.words()].concat();
    let [manifest, library, places] = [MANIFEST, LIBRARY, PLACES].map(|text| replaced(text, &words));
    vec![
        File::own("Cargo.toml", manifest),
        File::data("src/lib.rs", library),
        File::data("src/places.rs", places),
        File::data("src/lights.rs", lights.to_owned()),
    ]
}

/// What is put in place of each word of the texts of a crate.
fn own_words(program: &Program<'_>) -> Words {
    let Program { options, name, placed, .. } = program;
    let chip = Chip::of(options.chip);
    let (begin, end, last) = options.chip.frame(placed.places.len());
    let framing = if options.chip.has_clock() {
        format!(":\n    /// {begin} bytes of 0 go before them, and {end} of {last} behind them")
    } else {
        String::new()
    };
    let limit = options.limit.map_or_else(String::new, |limit| {
        format!("        let strip = strip.with_limit({limit}, {}, 1);\n", options.channel)
    });
    let share = steps(options.brightness, 16);
    let brightness = if share < 65_536 {
        format!("        let strip = strip.with_brightness(Fx32::from_bits({share} << 14));\n")
    } else {
        String::new()
    };
    let (turns, has_axes) =
        (program.turns(), program.turns() && program.lights.iter().any(|(_, own)| has_axis(own)));
    let types: String = [(placed.facing.is_some(), "Fx16, "), (has_axes || !brightness.is_empty(), "Fx32, ")]
        .into_iter()
        .filter_map(|(is_used, name)| is_used.then_some(name))
        .collect();
    let (tables, place, facing, way, lit) = match &placed.facing {
        Some(facing) => (
            "FACING, PLACES",
            ", and the ways that they face",
            format!(
                "\n/// In steps of 2^-14.\npub(crate) const FACING: [[i16; 3]; COUNT] = [\n{}];\n",
                lines(facing, 14, ["[", "]"])
            ),
            "            let facing = Vec3::from(FACING[led]).map(Fx16::from_bits);\n",
            "scene.light(place, facing)",
        ),
        None => ("PLACES", "", String::new(), "", "scene.light_facing(place)"),
    };
    // A dither by the number of the frame needs no memory; that of an APA102 goes on where its current changes.
    let dither =
        format!("            let mut dither = {}::dither(led.wrapping_add(number) as u16);\n", chip.name);
    let [state, start, counted, each, item, step, dither] = if options.chip == Family::Apa102 {
        [
            "    dithers: [CurrentDither; COUNT],\n",
            "            dithers: core::array::from_fn(|led| Apa102::dither(led as u16)),\n",
            "",
            "self.dithers.iter_mut().enumerate()",
            "(led, dither)",
            "",
            "dither",
        ]
    } else {
        [
            "    number: usize,\n",
            "            number: 0,\n",
            "        let number = self.number;\n        self.number = number.wrapping_add(1);\n",
            "0..COUNT",
            "led",
            &dither,
            "&mut dither",
        ]
    };
    let order = match program.order() {
        Order::Grb => "Grb",
        Order::Rgb => "Rgb",
        Order::Bgr => "Bgr",
    };
    let own = |text: &str, is_used: bool| if is_used { text.to_owned() } else { String::new() };
    vec![
        ("TURN_FUNCTION", own(TURNING, turns)),
        ("TURNED", own(TURNED, turns)),
        ("TURNS", program.each_placed(turned)),
        ("QUARTER", quarter()),
        ("MIDDLE", program.middle()),
        (
            "PERIOD",
            own(
                &format!(
                    "\n/// Milliseconds of a turn of the lights.\nconst TURN: u32 = {}_000;\n",
                    options.turn
                ),
                turns,
            ),
        ),
        (
            "MOVE",
            own(
                "        self.turn((u64::from(milliseconds % TURN) * 65_536 / u64::from(TURN)) as u32);\n",
                turns,
            ),
        ),
        ("MILLISECONDS", if turns { "milliseconds" } else { "_milliseconds" }.to_owned()),
        ("PLACES", lines(&placed.places, 16, ["[", "]"])),
        ("WHERE", place.to_owned()),
        ("FACING", facing),
        ("TABLES", tables.to_owned()),
        ("WAY", way.to_owned()),
        ("LIT", lit.to_owned()),
        ("STATE", state.to_owned()),
        ("START", start.to_owned()),
        ("EACH", each.to_owned()),
        ("ITEM", item.to_owned()),
        ("STEP", step.to_owned()),
        ("DITHER", dither.to_owned()),
        ("COUNTED", counted.to_owned()),
        ("ORDER", order.to_owned()),
        ("CHIPS", chip.imports.to_owned()),
        ("CHIP_TYPE", chip.value.to_owned()),
        ("COLORS", chip.colors.to_owned()),
        ("PIXEL_DOC", chip.pixel_doc.to_owned()),
        ("PIXEL", chip.pixel.to_owned()),
        (
            "BOUND",
            chip.bound.map_or_else(
                || " ".to_owned(),
                |bound| format!("\n    where\n        {bound}: Into<W::Color>,\n    "),
            ),
        ),
        ("MAP", chip.map.to_owned()),
        ("CALL", chip.call.to_owned()),
        ("FRAMING", framing),
        ("LIMIT", limit),
        ("BRIGHTNESS", brightness),
        ("TYPES", types),
        ("SCENE_NAME", (*name).to_owned()),
        ("VERSION", env!("CARGO_PKG_VERSION").to_owned()),
        ("PATCH", patch()),
    ]
}

fn has_axis(light: &AnyLight) -> bool {
    match light {
        AnyLight::Spot(_) | AnyLight::Measured(_) => true,
        AnyLight::Point(_) | AnyLight::Directional(_) => false,
    }
}

/// Returns the statements that turn a light.
fn turned(light: &str, own: &AnyLight, forth: bool) -> String {
    let turn = if forth { "turn" } else { "turn.wrapping_neg()" };
    let moved = format!(
        "        let from = start.{light}.position().map(Length::to_bits);\n        \
         scene.{light} = scene.{light}.moved_to(turned(from, MIDDLE, {turn}));\n"
    );
    match own {
        AnyLight::Spot(_) => format!(
            "{moved}        let axis = start.{light}.axis().map(Fx32::to_bits);\n        \
             let aimed = scene.{light}.aimed_along(turned(axis, [0; 2], {turn}));\n        \
             scene.{light} = aimed.unwrap_or(scene.{light});\n"
        ),
        AnyLight::Measured(_) => format!(
            "{moved}        let frame = start.{light}.frame().map(|own| own.map(Fx32::to_bits));\n        \
             let [side, _, axis] = frame.map(|own| turned(own, [0; 2], {turn}));\n        \
             let aimed = scene.{light}.framed_along(axis, side);\n        \
             scene.{light} = aimed.unwrap_or(scene.{light});\n"
        ),
        AnyLight::Point(_) | AnyLight::Directional(_) => moved,
    }
}

/// Returns the table of `luminaire_sine`: the sine at 16 parts of a quarter, its end, and one more, which takes no part.
fn quarter() -> String {
    let at =
        |i: i32| (16_384.0 * (f64::from(i.min(16)) * std::f64::consts::PI / 32.0).sin()).round().to_string();
    let all: Vec<_> = (0..18).map(at).collect();
    all.chunks(15).map(|part| format!("    {},\n", part.join(", "))).collect()
}

/// Returns where Cargo finds the kernel: the folder that this command was built from, if it is still there.
fn patch() -> String {
    match Path::new(CORE).canonicalize() {
        // A text of TOML between apostrophes has no escapes.
        Ok(folder) if folder.to_str().is_some_and(|folder| !folder.contains('\'')) => format!(
            "\n# Until luminaire is published, its folder.\n[patch.crates-io]\nluminaire = {{ path = '{}' }}\n",
            folder.display()
        ),
        _ => "\n# Until luminaire is published, its folder:\n# [patch.crates-io]\n# luminaire = { path = \"luminaire/core\" }\n"
            .to_owned(),
    }
}

/// How a crate writes the LEDs of a family.
struct Chip {
    /// The type, and its value with an order of channels.
    name: &'static str,
    value: &'static str,
    imports: &'static str,
    /// What the crate takes from smart-leds-trait.
    colors: &'static str,
    /// The type that becomes a pixel of the driver; none where the caller makes that.
    bound: Option<&'static str>,
    pixel: &'static str,
    pixel_doc: &'static str,
    /// The function from the bytes of an LED to a pixel.
    map: &'static str,
    call: &'static str,
}

impl Chip {
    fn of(family: Family) -> Self {
        let plain = Self {
            name: "LedOrder",
            value: "order",
            imports: "LedChip, LedLoad, LedOrder, LedStrip",
            colors: "RGB8, SmartLedsWrite",
            bound: Some("RGB8"),
            pixel: "",
            pixel_doc: "",
            map: "|[red, green, blue]| RGB8::new(red, green, blue)",
            call: "leds.write(milliseconds(), &mut strip)?;",
        };
        match family {
            Family::Ws2812 => plain,
            Family::Sk6812Rgbw => Self {
                name: "Rgbw",
                value: "Rgbw(order)",
                imports: "LedChip, LedLoad, LedOrder, LedStrip, Rgbw",
                colors: "RGBW, SmartLedsWrite, White",
                bound: Some("RGBW<u8>"),
                map: "|[r, g, b, w]| RGBW::new_alpha(r, g, b, White(w))",
                ..plain
            },
            Family::Apa102 => Self {
                name: "Apa102",
                value: "Apa102(order)",
                imports: "Apa102, CurrentDither, LedChip, LedLoad, LedOrder, LedStrip",
                bound: None,
                pixel: "\n        mut pixel: impl FnMut(u8, RGB8) -> W::Color,",
                pixel_doc: " `pixel` makes\n    /// its pixel of a current from 1 to 31 and a colour.",
                map: "|[current, r, g, b]| pixel(current & 31, RGB8::new(r, g, b))",
                call: "// `Apa102Pixel` and `u5` are those of apa102-spi.\n//!     leds.write(milliseconds(), &mut strip, |current, color| Apa102Pixel {\n//!         red: color.r,\n//!         green: color.g,\n//!         blue: color.b,\n//!         brightness: u5::new(current),\n//!     })?;",
                ..plain
            },
            Family::Hd108 => Self {
                name: "Hd108",
                value: "Hd108(order)",
                imports: "Hd108, LedChip, LedLoad, LedOrder, LedStrip",
                colors: "RGB16, SmartLedsWrite",
                bound: Some("RGB16"),
                map: "|[_, _, rest @ ..]| {\n            let [red, green, blue] = [0, 2, 4].map(|i| u16::from_be_bytes([rest[i], rest[i + 1]]));\n            RGB16::new(red, green, blue)\n        }",
                ..plain
            },
        }
    }
}

/// Returns the name of a crate: an identifier, and none of a crate that it uses.
pub(super) fn crate_name(stem: &str) -> String {
    let name = identifier(stem, Language::RustFixed16);
    if name == "smart_leds_trait" { format!("{name}_light") } else { name }
}
