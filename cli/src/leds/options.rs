//! The options of `leds`.

use std::path::PathBuf;

use luminaire_exchange::leds;
use luminaire_export::Language;

use crate::source::{Source, Spot};

/// The options of `leds`.
#[derive(Debug, clap::Args)]
pub(crate) struct Leds {
    /// The places of the LEDs: a table of x,y,z, as of GIFT trees and marimapper, or a map of Pixelblaze or WLED
    #[arg(long, value_name = "FILE")]
    pub(super) map: PathBuf,
    /// The folder of the program, which names it
    #[arg(long, value_name = "FOLDER")]
    pub(super) output: PathBuf,
    /// What is written: a sketch of Arduino, a project of ESP-IDF or a crate of Rust
    #[arg(long, value_name = "TARGET", default_value = "arduino")]
    pub(super) to: Target,
    /// The family of the chips
    #[arg(long, default_value = "ws2812")]
    pub(super) chip: Family,
    /// The order of the channels [default: grb, of apa102 bgr]
    #[arg(long)]
    pub(super) order: Option<Order>,
    /// The axis of the map that points up
    #[arg(long, default_value = "z")]
    pub(super) up: Up,
    /// The side from which an LED takes light: as the map says, or without that away from the upright axis (map), always
    /// away from that axis (out), or all sides, where a light counts in full whatever its direction (all)
    #[arg(long, value_name = "SIDE", default_value = "map")]
    pub(super) facing: Facing,
    /// The height to which the map is scaled, its lowest LED at 0 and its middle above 0,0,0 [default: as it is]
    #[arg(long)]
    pub(super) height: Option<f64>,
    /// The current of the supply in milliamperes [default: no limit]
    #[arg(long, value_name = "MA")]
    pub(super) limit: Option<u32>,
    /// The current of a channel at full duty in milliamperes
    #[arg(long, value_name = "MA", default_value = "20", requires = "limit",
        value_parser = clap::value_parser!(u16).range(1..))]
    pub(super) channel: u16,
    /// The share of all light that is shown, which keeps the hue of dim light
    #[arg(long, value_name = "SHARE", default_value = "1")]
    pub(super) brightness: f64,
    /// The seconds in which the lights turn about the LEDs; 0 for lights that stand still
    #[arg(long, value_name = "SECONDS", default_value = "20")]
    pub(super) turn: u16,
    #[command(flatten)]
    pub(super) spot: Spot,
    #[command(flatten)]
    pub(super) source: Source,
}

/// What a program is for.
#[derive(Clone, Copy, PartialEq, Debug, clap::ValueEnum)]
pub(super) enum Target {
    Arduino,
    EspIdf,
    Rust,
}

impl Target {
    /// The language of the lights.
    pub(super) fn language(self) -> Language {
        match self {
            Self::Arduino | Self::EspIdf => Language::CFixed,
            Self::Rust => Language::RustFixed16,
        }
    }
}

/// The names of [`leds::Facing`].
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Facing {
    Map,
    Out,
    All,
}

impl From<Facing> for leds::Facing {
    fn from(facing: Facing) -> Self {
        match facing {
            Facing::Map => Self::Map,
            Facing::Out => Self::Out,
            Facing::All => Self::All,
        }
    }
}

/// A family of chips.
#[derive(Clone, Copy, PartialEq, Debug, clap::ValueEnum)]
pub(super) enum Family {
    Ws2812,
    Sk6812Rgbw,
    Apa102,
    Hd108,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Order {
    Grb,
    Rgb,
    Bgr,
}

/// The names of [`leds::Up`].
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Up {
    Y,
    Z,
}

impl From<Up> for leds::Up {
    fn from(up: Up) -> Self {
        match up {
            Up::Y => Self::Y,
            Up::Z => Self::Z,
        }
    }
}

impl Family {
    /// What people call it, and the bytes of an LED.
    pub(super) fn words(self) -> (&'static str, usize) {
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
