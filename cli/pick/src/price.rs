//! The counted cost of a lit point.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use serde::Serialize;

use crate::evaluation::Evaluation;
use crate::light::{Attenuation, Light, Shaped};
use crate::target::Chip;

/// The cost of a lit point, and the size of the code that computes it.
///
/// Instructions are counted under QEMU, with `opt-level = 3`. In `Fx16` some points take a fine
/// evaluation, which costs several times as much as the coarse evaluation: points near a bright
/// light, or all points of a steep cone. The price is the mean over points that are evenly
/// distributed over the cone and the distances.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Price {
    /// Mean number of instructions of a lit point.
    pub instructions: f64,
    /// Mean number of cycles of a lit point, on the Cortex-M0+ of an RP2040 without wait states.
    /// `null` in JSON for other processors, because their emulator counts instructions only.
    pub cycles: Option<f64>,
    /// Bytes of code.
    pub bytes: u64,
    /// The share of the points that take the fine evaluation.
    pub fine_share: f64,
}

#[derive(serde::Deserialize)]
struct OnBoard {
    kernels: BTreeMap<String, Counted>,
}

/// Instructions, bytes, and cycles if they were counted.
type Counted = (f64, u64, Option<f64>);

/// Returns the recorded price of a kernel. `cargo xtask measure --bless` writes the record.
fn recorded(chip: Chip, kernel: &str) -> Counted {
    static RECORD: OnceLock<BTreeMap<String, OnBoard>> = OnceLock::new();
    let read = || serde_json::from_str(include_str!("../prices.json")).expect("a record of prices");
    RECORD.get_or_init(read)[chip.name()].kernels[kernel]
}

impl Price {
    /// Returns the price of an evaluation. Only `Fx16` has points with a fine evaluation.
    pub(crate) fn of(
        chip: Chip,
        light: &Light,
        cone: &Shaped,
        evaluation: Evaluation,
        fine_share: f64,
    ) -> Self {
        let edge = cone.type_name().to_lowercase();
        let attenuation = match light.attenuation {
            Attenuation::None => "",
            Attenuation::InverseSquare => "-inverse-square",
        };
        let row = |evaluation: &str| recorded(chip, &format!("{edge}{attenuation}.{evaluation}"));
        let coarse = row(evaluation.name());
        let fine = if evaluation == Evaluation::Fx16 { row("fx16-fine") } else { coarse };
        let mean = |coarse: f64, fine: f64| (10.0 * (coarse + fine_share * (fine - coarse))).round() / 10.0;
        Self {
            instructions: mean(coarse.0, fine.0),
            cycles: coarse.2.zip(fine.2).map(|(coarse, fine)| mean(coarse, fine)),
            bytes: fine.1,
            fine_share,
        }
    }
}
