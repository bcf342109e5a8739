//! The counted cost of a lit point.

use std::collections::BTreeMap;
use std::ops::{Add, Sub};
use std::sync::OnceLock;

use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::AnyFalloff;
use serde::Serialize;

use crate::evaluation::Evaluation;
use crate::refusal::Refusal;
use crate::target::{Chip, named};

named! {
    /// How a price was counted.
    Counted {
        /// With this falloff and this attenuation: as a whole.
        Whole = "whole",
        /// In parts, whose sum it is: see [`Price`].
        Parts = "parts",
    }
}

/// The cost of a lit point, and the size of the code that computes it.
///
/// Instructions are counted under QEMU, with `opt-level = 3`. In `Fx16` some points take a fine
/// evaluation, which costs several times as much as the coarse evaluation: points near a bright
/// light, or all points of a steep cone. The price is the mean over points that are evenly
/// distributed over the cone and the distances. On record is the fine evaluation of a steep cone. That of a bright
/// light has the coarse evaluation in it, which tells whether the light is clipped in any case: its price is the sum of
/// both, less a point outside the cone, which takes what the two share.
///
/// On record are the lit points of a soft spotlight with each falloff, with each law of the attenuation, and with each
/// window, which ends a law at a range; those of pairs that are frequent; and those of a point light, a measured light
/// and a directional light. Another price is a sum: that of the soft spotlight without attenuation, and what the
/// falloff, the law and the window each add to it. An integer power adds its products, too. For the pairs on record, on
/// every chip and by every evaluation, the instructions and cycles of the sum differ from those of the count by at most
/// [`IN_PARTS`](Self::IN_PARTS) of them, and its bytes by at most [`BYTES_IN_PARTS`](Self::BYTES_IN_PARTS), because the
/// parts share code. The worst cases of the parts are not those of the same point: their sum differs by at most
/// [`WORST_IN_PARTS`](Self::WORST_IN_PARTS).
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Price {
    /// Mean number of instructions of a lit point.
    pub instructions: f64,
    /// Mean number of cycles of a lit point, on the Cortex-M0+ of an RP2040 without wait states.
    /// `null` in JSON for other processors, because their emulator counts instructions only.
    pub cycles: Option<f64>,
    /// The most instructions of a point with any normal, within the distances or not: of a light that falls with the
    /// distance, those of a point that takes the coarse and the fine evaluation. It is searched, and hence a lower bound
    /// of the worst case. `null` in JSON where it is not on record.
    pub worst: Option<f64>,
    /// Bytes of code.
    pub bytes: u64,
    /// The share of the points that take the fine evaluation and keep its result.
    pub fine_share: f64,
    /// Whether the price was counted as a whole, or is the sum of counted parts.
    pub counted: Counted,
}

/// The points of a light that take the fine evaluation and keep its result.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Fine {
    /// All points of a steep cone.
    Steep,
    /// This share of the points, near a bright light.
    Bright(f64),
}

#[derive(serde::Deserialize)]
struct OnBoard {
    kernels: BTreeMap<String, Row>,
}

/// Instructions, bytes, and cycles and the most instructions if they were counted.
type Row = (f64, f64, Option<f64>, Option<f64>);

/// Returns the record. `cargo xtask measure --bless` writes it.
fn record() -> &'static BTreeMap<String, OnBoard> {
    static RECORD: OnceLock<BTreeMap<String, OnBoard>> = OnceLock::new();
    let read = || serde_json::from_str(include_str!("../prices.json")).expect("a record of prices");
    RECORD.get_or_init(read)
}

/// A row of the record; or a difference of two.
#[derive(Clone, Copy, Debug)]
struct Cost {
    instructions: f64,
    bytes: f64,
    cycles: Option<f64>,
    worst: Option<f64>,
}

impl Add for Cost {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = |own: Option<f64>, other| own.zip(other).map(|(own, other)| own + other);
        Self {
            instructions: self.instructions + other.instructions,
            bytes: self.bytes + other.bytes,
            cycles: sum(self.cycles, other.cycles),
            worst: sum(self.worst, other.worst),
        }
    }
}

impl Sub for Cost {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + other.times(-1.0)
    }
}

impl Cost {
    fn times(self, factor: f64) -> Self {
        let Self { instructions, bytes, cycles, worst } = self;
        Self {
            instructions: factor * instructions,
            bytes: factor * bytes,
            cycles: cycles.map(|cycles| factor * cycles),
            worst: worst.map(|worst| factor * worst),
        }
    }
}

/// What the light of a lit point is by its direction, by the names in data.
#[derive(Clone, Copy, Debug)]
enum Shape {
    /// The falloff of a spotlight.
    Falloff(&'static str),
    /// The kind of a light without a cone.
    Kind(&'static str),
}

/// What a lit point consists of, by the names in data.
#[derive(Clone, Copy, Debug)]
struct Parts {
    shape: Shape,
    /// The products of an integer power.
    products: Option<u32>,
    law: &'static str,
    /// The window that ends the law at a range.
    window: Option<&'static str>,
}

/// The law without attenuation, which no name on record has.
const CONSTANT: &str = "constant";
/// The law with which the windows are counted.
const INVERSE_SQUARE: &str = "inverse-square";
/// The evaluation of a steep cone, of which every point is fine.
const FINE: &str = "fx16-fine";
/// A point outside the cone: what comes before the evaluation of one inside.
const OUTSIDE: &str = "outside";
/// The products of the powers on record: those of the falloffs `power` and `inverted-power`, and of `power-16`.
const PRODUCTS: [u32; 2] = [2, 4];

impl Parts {
    fn of_spot(falloff: AnyFalloff, attenuation: &AnyAttenuation) -> Self {
        let products = |exponent: u32| exponent.ilog2() + exponent.count_ones() - 1;
        let power = match falloff {
            AnyFalloff::Power(power) => Some(power.exponent()),
            AnyFalloff::InvertedPower(power) => Some(power.exponent()),
            _ => None,
        };
        let shape = Shape::Falloff(falloff.row().name);
        Self { products: power.map(products), ..Self::new(shape, attenuation) }
    }

    fn new(shape: Shape, attenuation: &AnyAttenuation) -> Self {
        let row = attenuation.row();
        Self {
            shape,
            products: None,
            law: row.law,
            // Without a range, a window is none.
            window: row.window.filter(|_| attenuation.range().is_some()),
        }
    }

    /// Returns what the attenuation is called in a name on record.
    fn suffix(&self) -> String {
        let law = if self.law == CONSTANT { String::new() } else { format!("-{}", self.law) };
        law + &self.window.map_or_else(String::new, |window| format!("-{window}"))
    }

    /// Returns the name of the lit point on record, if it is there as a whole.
    fn whole(&self) -> Option<String> {
        let is_sample = self.products.is_none_or(|products| products == PRODUCTS[0]);
        let (Shape::Falloff(name) | Shape::Kind(name)) = self.shape;
        is_sample.then(|| format!("{name}{}", self.suffix()))
    }
}

/// The prices of an evaluation on a chip.
#[derive(Clone, Copy, Debug)]
struct Prices {
    chip: Chip,
    evaluation: &'static str,
}

impl Prices {
    fn find(&self, name: &str) -> Option<Cost> {
        let row = record()[self.chip.name()].kernels.get(&format!("{name}.{}", self.evaluation));
        row.map(|&(instructions, bytes, cycles, worst)| Cost { instructions, bytes, cycles, worst })
    }

    /// Returns the price of a model on record, or the refusal of one that is not there.
    fn get(&self, name: &str) -> Result<Cost, Refusal> {
        self.find(name).ok_or_else(|| {
            let value = format!("{name} by {} on {}", self.evaluation, self.chip);
            let expected =
                "a model whose instructions are on record: `cargo xtask measure --bless` counts them";
            Refusal::parameter("price", value, expected.to_owned())
        })
    }

    fn of(&self, light: &AnyLight) -> Result<(Cost, Counted), Refusal> {
        let parts = match light {
            AnyLight::Spot(spot) => Parts::of_spot(spot.cone().falloff(), &spot.attenuation()),
            AnyLight::Point(point) => Parts::new(Shape::Kind("point"), &point.attenuation()),
            AnyLight::Measured(lamp) => Parts::new(Shape::Kind("measured"), &lamp.attenuation()),
            AnyLight::Directional(_) => return Ok((self.get("directional")?, Counted::Whole)),
        };
        match parts.whole().and_then(|name| self.find(&name)) {
            Some(cost) => Ok((cost, Counted::Whole)),
            None => Ok((self.sum(&parts)?, Counted::Parts)),
        }
    }

    /// Returns the sum of the parts of a lit point.
    fn sum(&self, parts: &Parts) -> Result<Cost, Refusal> {
        let with_law = |law: &str| {
            let name = if law == CONSTANT { "soft".to_owned() } else { format!("soft-{law}") };
            self.get(&name)
        };
        let soft = self.get("soft")?;
        let mut sum = match parts.shape {
            Shape::Falloff(falloff) => self.get(falloff)? + (with_law(parts.law)? - soft),
            Shape::Kind(kind) => {
                let counted = self.get(&format!("{kind}-{INVERSE_SQUARE}"))?;
                counted + (with_law(parts.law)? - with_law(INVERSE_SQUARE)?)
            }
        };
        if let Some(products) = parts.products {
            let [few, many] = PRODUCTS.map(f64::from);
            let product = (self.get("power-16")? - self.get("power")?).times(1.0 / (many - few));
            sum = sum + product.times(f64::from(products) - few);
        }
        if let Some(window) = parts.window {
            sum = sum + (self.get(&format!("soft-{INVERSE_SQUARE}-{window}"))? - with_law(INVERSE_SQUARE)?);
        }
        Ok(sum)
    }
}

impl Price {
    /// The largest relative difference of instructions, and of cycles, of a sum of parts from the count of the whole.
    pub const IN_PARTS: f64 = 0.13;
    /// The largest relative difference of bytes of a sum of parts from the count of the whole.
    pub const BYTES_IN_PARTS: f64 = 0.31;
    /// The largest relative difference of the worst case of a sum of parts from that of the whole.
    pub const WORST_IN_PARTS: f64 = 0.18;

    /// Returns the names of the chips that worst cases are on record of.
    pub(crate) fn chips_with_worst() -> String {
        let has_worst =
            |chip: &&Chip| record()[chip.name()].kernels.values().any(|(.., worst)| worst.is_some());
        let names: Vec<_> = Chip::ALL.iter().filter(has_worst).map(|chip| chip.name()).collect();
        names.join(", ")
    }

    /// Returns the price of an evaluation. Only `Fx16` has points with a fine evaluation.
    pub(crate) fn of(
        chip: Chip,
        light: &AnyLight,
        evaluation: Evaluation,
        fine: Fine,
    ) -> Result<Self, Refusal> {
        let prices = Prices { chip, evaluation: evaluation.name() };
        let (coarse, counted) = prices.of(light)?;
        let steep = || Ok::<_, Refusal>(Prices { chip, evaluation: FINE }.of(light)?.0);
        let is_placed = !matches!(light, AnyLight::Directional(_));
        let (share, fine) = match (light, evaluation, fine) {
            (AnyLight::Spot(spot), Evaluation::Fx16, Fine::Bright(share)) if share > 0.0 => {
                // The code is that of both. A point outside takes the same in any case.
                let outside = prices.get(OUTSIDE)?;
                let shared = Cost { bytes: 0.0, worst: Some(outside.instructions), ..outside };
                let both = coarse + (steep()? - shared);
                // A light that falls with the distance has points that take both however dim it is.
                let worst = if spot.attenuation().row().law == CONSTANT { both.worst } else { coarse.worst };
                (share, Cost { worst, ..both })
            }
            // A point light is on record with both evaluations.
            (_, Evaluation::Fx16, Fine::Bright(share)) if is_placed => (share, steep()?),
            (_, Evaluation::Fx16, Fine::Steep) if is_placed => (1.0, steep()?),
            _ => (0.0, coarse),
        };
        let mean = |coarse: f64, fine: f64| (10.0 * (coarse + share * (fine - coarse))).round() / 10.0;
        Ok(Self {
            instructions: mean(coarse.instructions, fine.instructions),
            cycles: coarse.cycles.zip(fine.cycles).map(|(coarse, fine)| mean(coarse, fine)),
            worst: if share > 0.0 { fine.worst } else { coarse.worst }.map(f64::round),
            bytes: fine.bytes.max(0.0) as u64,
            fine_share: share,
            counted,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sums of all lit points that are counted as a whole, too, differ by what the price states.
    #[test]
    fn sums_of_parts_differ_from_counts_by_what_is_stated() {
        let pair =
            |falloff, law, window| Parts { shape: Shape::Falloff(falloff), products: None, law, window };
        let pairs = ["hard", "quadratic", "cubic", "table"]
            .map(|falloff| pair(falloff, INVERSE_SQUARE, None))
            .into_iter()
            .chain([pair("inverted-real-power", "decay", Some("square"))]);
        let mut worst = [(); 3].map(|()| (0.0_f64, String::new()));
        for parts in pairs {
            for &chip in Chip::ALL {
                for evaluation in ["fx16-quick", "fx16", "fx16-fine", "fx32", "f32"] {
                    let prices = Prices { chip, evaluation };
                    let name = parts.whole().unwrap();
                    let (count, sum) = (prices.get(&name).unwrap(), prices.sum(&parts).unwrap());
                    let ratio =
                        |sum: Option<f64>, count| sum.zip(count).map_or(1.0, |(sum, count)| sum / count);
                    let cycles = ratio(sum.cycles, count.cycles);
                    let instructions = sum.instructions / count.instructions;
                    let most = ratio(sum.worst, count.worst);
                    let ratios = [[instructions, cycles], [sum.bytes / count.bytes, 1.0], [most, 1.0]];
                    for (worst, ratios) in worst.iter_mut().zip(ratios) {
                        let difference =
                            ratios.map(|ratio| (ratio - 1.0).abs()).into_iter().fold(0.0, f64::max);
                        if difference > worst.0 {
                            *worst = (difference, format!("{name} by {evaluation} on {chip}"));
                        }
                    }
                }
            }
        }
        println!("{worst:?}");
        let stated = [Price::IN_PARTS, Price::BYTES_IN_PARTS, Price::WORST_IN_PARTS];
        for ((found, place), stated) in worst.into_iter().zip(stated) {
            assert!(found <= stated && found > stated - 0.01, "{found:.4} for {place}, not {stated}");
        }
    }
}
