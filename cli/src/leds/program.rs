//! What the programs of all targets share.

use std::fmt::Write;

use luminaire::dynamic::AnyLight;
use luminaire_exchange::leds::{Facing, PlacedLeds};

use super::options::{Family, Leds, Order, Target};

/// A file of a program.
pub(super) struct File {
    /// In the folder of the program.
    pub(super) path: String,
    pub(super) text: String,
    /// Whether people change it, so that another one is not written over.
    pub(super) stays: bool,
}

impl File {
    /// A file that people change.
    pub(super) fn own(path: &str, text: String) -> Self {
        Self { path: path.to_owned(), text, stays: true }
    }

    /// A file that is written again.
    pub(super) fn data(path: &str, text: String) -> Self {
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
    pub(super) placed: &'a PlacedLeds,
    pub(super) lights: &'a [(&'a str, AnyLight)],
}

pub(super) type Words = Vec<(&'static str, String)>;

/// Returns a number in steps of a power of two.
pub(super) fn steps(value: f64, bits: i32) -> i64 {
    (value * 2_f64.powi(bits)).round() as i64
}

impl Program<'_> {
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
    pub(super) fn words(&self) -> Words {
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
pub(super) fn replaced(text: &str, words: &[(&str, String)]) -> String {
    let mut text = text.to_owned();
    for (word, own) in words {
        text = text.replace(&format!("{{{word}}}"), own);
    }
    text
}
