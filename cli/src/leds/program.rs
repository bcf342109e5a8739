//! The files of a program: what the targets share, and what each has of its own.

use std::fmt::Write;

use luminaire::dynamic::AnyLight;
use luminaire_export::C_HEADERS;

use super::{Facing, Family, Leds, Order, Placed, Target, rust};

/// The texts of the programs in C: words in braces are replaced.
const LEDS: &str = include_str!("leds.h");
const TURNING: &str = include_str!("turning.h");
const WIRE: [&str; 2] = [include_str!("wire.ino"), include_str!("idf/wire.c")];
const SPI: [&str; 2] = [include_str!("spi.ino"), include_str!("idf/spi.c")];
const PROJECT: &str = include_str!("idf/CMakeLists.txt");
const COMPONENT: &str = include_str!("idf/component.txt");
const DEPENDENCIES: &str = include_str!("idf/component.yml");

/// A file of a program.
pub(super) struct File {
    /// In the folder of the program.
    pub(super) path: String,
    pub(super) text: String,
    /// Whether people change it, so that another one is not written over.
    pub(super) stays: bool,
}

impl File {
    fn own(path: &str, text: String) -> Self {
        Self { path: path.to_owned(), text, stays: true }
    }

    fn data(path: &str, text: String) -> Self {
        Self { path: path.to_owned(), text, stays: false }
    }
}

/// What a program is made from.
pub(super) struct Program<'a> {
    pub(super) options: &'a Leds,
    /// The name of the scene.
    pub(super) name: &'a str,
    /// The name of the folder.
    pub(super) stem: &'a str,
    pub(super) placed: &'a Placed,
    pub(super) lights: &'a [(&'a str, AnyLight)],
}

pub(super) type Words = Vec<(&'static str, String)>;

impl Family {
    /// What people call it, and the bytes of an LED.
    fn words(self) -> (&'static str, usize) {
        match self {
            Self::Ws2812 => ("WS2812", 3),
            Self::Sk6812Rgbw => ("SK6812 RGBW", 4),
            Self::Apa102 => ("APA102", 4),
            Self::Hd108 => ("HD108", 8),
        }
    }

    pub(super) fn has_clock(self) -> bool {
        match self {
            Self::Ws2812 | Self::Sk6812Rgbw => false,
            Self::Apa102 | Self::Hd108 => true,
        }
    }

    /// What is sent before the LEDs and behind them: how many zeros, and how many bytes of which value.
    pub(super) fn frame(self, count: usize) -> (usize, usize, &'static str) {
        match self {
            Self::Ws2812 | Self::Sk6812Rgbw => (0, 0, "0"),
            // A bit for each two LEDs, behind four bytes.
            Self::Apa102 => (4, 4 + count.div_ceil(16), "0"),
            Self::Hd108 => (16, count.div_ceil(8), "0xff"),
        }
    }
}

/// Returns a number in steps of a power of two.
pub(super) fn steps(value: f64, bits: i32) -> i64 {
    (value * 2_f64.powi(bits)).round() as i64
}

impl Program<'_> {
    /// Returns the files of the program with the text of the lights.
    pub(super) fn files(&self, lights: &str) -> Vec<File> {
        match self.options.to {
            Target::Arduino => {
                let words = [self.words_of_c(), self.words()].concat();
                let sketch = if self.options.chip.has_clock() { SPI[0] } else { WIRE[0] };
                vec![
                    // The builder of Arduino takes the sketch of the folder's own name.
                    File::own(&format!("{}.ino", self.stem), replaced(sketch, &words)),
                    File::data("leds.h", replaced(LEDS, &words)),
                    File::data(&format!("{}_lights.h", self.name), lights.to_owned()),
                ]
            }
            Target::EspIdf => {
                let words = [self.words_of_c(), self.words()].concat();
                let main = if self.options.chip.has_clock() { SPI[1] } else { WIRE[1] };
                let own = [
                    ("CMakeLists.txt", PROJECT),
                    ("main/CMakeLists.txt", COMPONENT),
                    ("main/idf_component.yml", DEPENDENCIES),
                    ("main/main.c", main),
                ];
                let own = own.into_iter().map(|(path, text)| File::own(path, replaced(text, &words)));
                let library = C_HEADERS.into_iter();
                own.chain([
                    File::data("main/leds.h", replaced(LEDS, &words)),
                    File::data(&format!("main/{}_lights.h", self.name), lights.to_owned()),
                ])
                .chain(library.map(|(name, text)| File::data(&format!("main/{name}"), text.to_owned())))
                .collect()
            }
            Target::Rust => {
                let words = [self.words_of_rust(), self.words()].concat();
                let [manifest, library, places] =
                    [rust::MANIFEST, rust::LIBRARY, rust::PLACES].map(|text| replaced(text, &words));
                vec![
                    File::own("Cargo.toml", manifest),
                    File::data("src/lib.rs", library),
                    File::data("src/places.rs", places),
                    File::data("src/lights.rs", lights.to_owned()),
                ]
            }
        }
    }

    /// Returns the bytes of flash and of memory that the LEDs take.
    pub(super) fn bytes(&self) -> (usize, usize) {
        let count = self.placed.places.len();
        let table = if self.placed.facing.is_some() { 18 } else { 12 };
        let memory = match (self.options.chip, self.options.to) {
            // The carries of three channels.
            (Family::Apa102, _) => 6,
            (Family::Hd108, _) | (_, Target::Rust) => 0,
            // A library that sends all at once holds what is sent.
            (Family::Ws2812 | Family::Sk6812Rgbw, Target::Arduino | Target::EspIdf) => {
                self.options.chip.words().1
            }
        };
        (table * count, memory * count)
    }

    /// Returns whether a light turns.
    pub(super) fn turns(&self) -> bool {
        let stands = |(_, light): &(&str, AnyLight)| matches!(light, AnyLight::Directional(_));
        self.options.turn > 0 && !self.lights.iter().all(stands)
    }

    /// Returns the statements of the lights that have a place, each with its number among these.
    pub(super) fn each_placed(&self, statement: impl Fn(&str, &AnyLight, bool) -> String) -> String {
        let placed = self.lights.iter().filter(|(_, light)| !matches!(light, AnyLight::Directional(_)));
        placed.enumerate().map(|(number, (name, light))| statement(name, light, number % 2 == 0)).collect()
    }

    pub(super) fn order(&self) -> Order {
        let standard = if self.options.chip == Family::Apa102 { Order::Bgr } else { Order::Grb };
        self.options.order.unwrap_or(standard)
    }

    /// What is put in place of each word of the texts of every target.
    fn words(&self) -> Words {
        let Self { options, placed, .. } = self;
        let (chip, bytes) = options.chip.words();
        let count = placed.places.len();
        let takes = match placed.side {
            Facing::Map => "An LED takes the light of the side that it faces, as the map says.",
            Facing::Out => {
                "An LED takes the light of the side away from the upright axis through their middle."
            }
            Facing::All => "An LED takes light from all sides: each light in full, whatever its direction.",
        };
        let what = if self.turns() { "lights that turn about them" } else { "lights that stand still" };
        let (begin, end, last) = options.chip.frame(count);
        vec![
            ("BYTES", bytes.to_string()),
            ("BEGIN", begin.to_string()),
            ("LAST", last.to_owned()),
            ("END", end.to_string()),
            ("CHIP", chip.to_owned()),
            ("TAKES", takes.to_owned()),
            ("WHAT", what.to_owned()),
            ("GUARD", self.name.to_ascii_uppercase()),
            ("NAME", self.name.to_owned()),
            ("COUNT", count.to_string()),
        ]
    }

    pub(super) fn middle(&self) -> String {
        let [x, z] = self.placed.middle.map(|c| steps(c, 16));
        format!("{x}, {z}")
    }

    fn words_of_c(&self) -> Words {
        let Self { options, name, placed, .. } = self;
        let guard = name.to_ascii_uppercase();
        let order = match self.order() {
            Order::Grb => "GRB",
            Order::Rgb => "RGB",
            Order::Bgr => "BGR",
        };
        let family = match options.chip {
            Family::Ws2812 => "",
            Family::Sk6812Rgbw => " + LUMINAIRE_LED_RGBW",
            Family::Apa102 => " + LUMINAIRE_LED_APA102",
            Family::Hd108 => " + LUMINAIRE_LED_HD108",
        };
        let (most, channel) = options.limit.map_or((0, 0), |limit| (limit, options.channel));
        let dimmed = 65_536 - steps(options.brightness, 16);
        let strip = format!("{most}, {channel}, 1, LUMINAIRE_LED_{order}{family}, {dimmed}");
        // An APA102 changes its current with the light, so that its carries need memory.
        let carries = if options.chip == Family::Apa102 {
            format!(
                "    static uint16_t all[{guard}_COUNT][3];\n    uint16_t *carries = all[led];\n    \
                 if (number == 0) {{ luminaire_led_start(carries, {name}_strip.order, led); }}"
            )
        } else {
            format!(
                "    uint16_t carries[4];\n    luminaire_led_start(carries, {name}_strip.order, led + number);"
            )
        };
        let (steps, facing, way, read, lit) = match &placed.facing {
            Some(facing) => (
                "A place has steps of 2^-16, and the way that an LED faces has steps of 2^-14. Both stay in flash.",
                format!(
                    "static const int16_t {name}_facing[{guard}_COUNT][3] LUMINAIRE_TABLE = {{\n{}}};\n",
                    lines(facing, 14, ["{ ", " }"])
                ),
                "    int16_t facing[3];\n",
                format!(
                    "    for (i = 0; i < 3; ++i) {{ facing[i] = (int16_t)LUMINAIRE_READ_16(&{name}_facing[led][i]); }}\n"
                ),
                format!("{name}_light(scene, place, facing)"),
            ),
            None => (
                "A place has steps of 2^-16. The places stay in flash.",
                String::new(),
                "",
                String::new(),
                format!("{name}_light_facing(scene, place)"),
            ),
        };
        let turns = |light: &str, own: &AnyLight, forth: bool| {
            let way = if forth { "turn" } else { "0 - turn" };
            let (function, aims) = match own {
                AnyLight::Measured(_) => ("measured_turned", ""),
                AnyLight::Spot(_) => ("light_turned", " 1,"),
                AnyLight::Point(_) | AnyLight::Directional(_) => ("light_turned", " 0,"),
            };
            format!("    {name}_{function}(&scene->{light}, &{name}_start.{light},{aims} {way});\n")
        };
        let (turning, period, moves) = match (self.turns(), options.to) {
            (false, _) => ("", String::new(), String::new()),
            (true, Target::EspIdf) => (
                TURNING,
                format!(
                    "#define TURN UINT32_C({}000) /* milliseconds of a turn of the lights */\n",
                    options.turn
                ),
                format!(
                    "        const uint32_t now = (uint32_t)(esp_timer_get_time() / 1000) % TURN;\n        \
                     {name}_turn(&scene, (uint32_t)((uint64_t)now * 65536 / TURN));\n"
                ),
            ),
            (true, _) => (
                TURNING,
                format!(
                    "const uint32_t TURN = {}000; // milliseconds of a turn of the lights\n\n",
                    options.turn
                ),
                format!("    {name}_turn(&scene, (uint32_t)((uint64_t)(millis() % TURN) * 65536 / TURN));\n"),
            ),
        };
        let mode = match (options.chip, options.to) {
            (Family::Apa102, Target::EspIdf) => "0",
            (_, Target::EspIdf) => "3",
            (Family::Apa102, _) => "SPI_MODE0",
            _ => "SPI_MODE3",
        };
        let white = if options.chip == Family::Sk6812Rgbw { "W" } else { "" };
        let (model, set, driver) = match options.chip {
            Family::Sk6812Rgbw => (
                "SK6812",
                "led_strip_set_pixel_rgbw(pixels, led, bytes[0], bytes[1], bytes[2], bytes[3])",
                "  espressif/led_strip: \"^3.0.0\"\n",
            ),
            Family::Ws2812 => (
                "WS2812",
                "led_strip_set_pixel(pixels, led, bytes[0], bytes[1], bytes[2])",
                "  espressif/led_strip: \"^3.0.0\"\n",
            ),
            Family::Apa102 | Family::Hd108 => ("", "", ""),
        };
        vec![
            ("TURNING", turning.to_owned()),
            ("TURNS", self.each_placed(turns)),
            ("PLACES", lines(&placed.places, 16, ["{ ", " }"])),
            ("FACING", facing),
            ("STEPS", steps.to_owned()),
            ("WAY", way.to_owned()),
            ("READ", read),
            ("LIT", lit),
            ("CARRIES", carries),
            ("STRIP", strip),
            ("MIDDLE", self.middle()),
            ("PERIOD", period),
            ("MOVE", moves),
            ("MODE", mode.to_owned()),
            ("WIRE", format!("NEO_{order}{white}")),
            ("COMPONENTS", format!("RGB{white}")),
            ("MODEL", model.to_owned()),
            ("SET", set.to_owned()),
            ("DRIVER", driver.to_owned()),
        ]
    }
}

/// Returns vectors as lines of a table, in steps of a power of two.
pub(super) fn lines(rows: &[[f64; 3]], bits: i32, [open, close]: [&str; 2]) -> String {
    let mut text = String::new();
    for row in rows {
        let [x, y, z] = row.map(|c| steps(c, bits));
        let _ = writeln!(text, "    {open}{x}, {y}, {z}{close},");
    }
    text
}

/// Replaces each word in braces, in the order of the words: what a word stands for may have words that come later.
fn replaced(text: &str, words: &[(&str, String)]) -> String {
    let mut text = text.to_owned();
    for (word, own) in words {
        text = text.replace(&format!("{{{word}}}"), own);
    }
    text
}
