//! What the truncation of an offset, and the rounding of its reciprocal length, do to a direction.
//!
//! `O` is the offset, scaled until its largest component is in [2^14, 2^15] and not rounded, `L` its length,
//! `u` its direction, and `v = O - d` the truncated one. A component of `d` is between 0 and what a bit
//! length loses at most.

extern crate std;

use std::format;
use std::string::String;

use super::boxes::{Interval, at_most};
use super::fx16::errors::{AXIS_LENGTH, AXIS_TURN};
use super::model::Constants;
use super::real::INVERSE_POWER;
use super::{Evaluation, FINE_STEP, FINER, Kind, RANGE, STEP};

/// The relative error of a mantissa of 16 bits that is rounded, and of one that is truncated.
const ROUNDED: f64 = STEP / 4.0;
const TRUNCATED: f64 = STEP / 2.0;

/// The part of a unit that truncation to `kept` bits loses at most.
fn lost(bits: u32, kept: u32) -> f64 {
    if bits > kept { 1.0 - (f64::from(kept) - f64::from(bits)).exp2() } else { 0.0 }
}

/// A cell of directions: the direction, the length of `O`, and what truncation and root do to lengths.
struct Cell {
    direction: [Interval; 3],
    length: Interval,
    /// `L / |v|`.
    stretch: Interval,
    /// `2^30 / |v|`, as the root computes it.
    reciprocal: Interval,
}

impl Cell {
    fn new(&[largest, y, z]: &[Interval; 3], sign: f64, lost: f64, root: Interval) -> Self {
        let one = Interval::exactly(1.0);
        let square = one + y.squared() + z.squared();
        let norm = square.root();
        let direction = [Interval::exactly(sign) / norm, y / norm, z / norm];
        let length = largest * norm;
        // `|v|` is at least `L - u.d`, and more by at most `|d|^2 / 2 (L - u.d)`.
        let along = [Interval::exactly(sign), y, z].map(|part| part * Interval::new(0.0, lost));
        let along = (along[0] + along[1] + along[2]) / (largest * square);
        let more = Interval::new(0.0, 3.0 * lost * lost / (2.0 * 16_382.0)) / length;
        let stretch = one / (one - along + more);
        let reciprocal = Interval::exactly(1_073_741_824.0) / length * stretch * (one + root);
        Self { direction, length, stretch, reciprocal }
    }

    /// Returns the largest part of `c - f d` across the direction and its parts along it, for all `d` up
    /// to `lost`. The part across is convex in `d`, so it is largest at a corner.
    fn parts(&self, c: f64, f: Interval, lost: f64) -> (f64, Interval) {
        let [x, y, z] = self.direction;
        let (mut across, mut along) = (0.0_f64, Interval::exactly(0.0));
        for corner in 0..8 {
            let part = |i: u32| {
                let lost = if corner >> i & 1 == 1 { lost } else { 0.0 };
                Interval::exactly(c) - f * Interval::exactly(lost)
            };
            let [a, b, c] = [part(0), part(1), part(2)];
            let cross = [b * z - c * y, c * x - a * z, a * y - b * x].map(Interval::squared);
            let whole = (a.squared() + b.squared() + c.squared()).root().high;
            across = across.max((cross[0] + cross[1] + cross[2]).root().high.min(whole));
            let inner = a * x + b * y + c * z;
            along =
                Interval::new(along.low.min(inner.low.max(-whole)), along.high.max(inner.high.min(whole)));
        }
        (across, along)
    }
}

/// A factor that is within an error of 1.
fn both(error: f64) -> Interval {
    Interval::new(1.0 - error, 1.0 + error)
}

/// Shows that a function of cells is at most a bound, where truncation loses this part of a unit and the root has this
/// error.
fn show(
    name: &str,
    bound: f64,
    [lost, root]: [f64; 2],
    function: &dyn Fn(&Cell) -> f64,
) -> Result<(), String> {
    let whole = [Interval::new(16_384.0, 32_768.0), Interval::new(-1.0, 1.0), Interval::new(-1.0, 1.0)];
    [1.0, -1.0].into_iter().try_for_each(|sign| {
        // The sums of the bounds themselves are rounded.
        let cell = |part: &[Interval; 3]| function(&Cell::new(part, sign, lost, Interval::new(-root, root)));
        at_most(bound + 1e-15, whole, cell).map_err(|part| format!("{name}: over {bound:e} in {part:?}"))
    })
}

/// Proves the errors of length, direction, cosine and attenuation of an evaluation of 15 bits, or those of a fine one.
pub(super) fn prove(evaluation: &Evaluation, constants: &Constants) -> Result<(), String> {
    let (bits, is_quick) = match evaluation.kind {
        Kind::Coarse(bits) => (bits, false),
        Kind::Quick(bits) => (bits, true),
        Kind::Fine16 | Kind::Far16 | Kind::Fine32 => return prove_finely(evaluation),
    };
    let stages = &evaluation.stages;
    let lost_of_15 = lost(bits, 15);
    let one = Interval::exactly(1.0);
    let unit = Interval::exactly(1_073_741_824.0);
    let root = Interval::new(-evaluation.root, evaluation.root);
    let truncated = Interval::new(1.0 - TRUNCATED, 1.0);
    let show = |name: &str, bound: f64, function: &dyn Fn(&Cell) -> f64| {
        show(name, bound, [lost_of_15, evaluation.root], function)
    };
    // The multiplier of an offset of up to 17 bits, the bits that the offset loses, and the direction's bias.
    let multiplier = |cell: &Cell| {
        if is_quick {
            return (cell.reciprocal, lost_of_15, constants.quick_cut_off as f64);
        }
        let half = constants.reciprocal_half as f64;
        let fourteen =
            cell.reciprocal / Interval::exactly(4.0) + Interval::new((half - 3.0) / 4.0, half / 4.0);
        (fourteen, lost(bits, 17), constants.cut_off as f64)
    };
    // The multiplier is the rounded quotient of `2^30` by a length: the product with the length of the offset
    // is computed without the length, which the interval would count twice.
    let stretched = |cell: &Cell| {
        let scaled = cell.stretch * (one + root);
        let half = constants.reciprocal_half as f64;
        scaled + cell.length * Interval::new(half - 3.0, half) / unit
    };
    show("turn", stages.turn - AXIS_TURN, &|cell| {
        let (multiplier, lost, bias) = multiplier(cell);
        cell.parts(bias, multiplier, lost).0 / 1_073_741_824.0
    })?;
    show("length", stages.length - AXIS_LENGTH, &|cell| {
        let (multiplier, lost, bias) = multiplier(cell);
        if is_quick {
            // The product of `v` and its reciprocal length has the length `1 + root`, turned by less than 1e-4.
            let (_, along) = cell.parts(bias, multiplier, 0.0);
            return (root * Interval::new(1.0 - 5e-9, 1.0) - Interval::new(0.0, 5e-9) + along / unit)
                .magnitude();
        }
        let (_, along) = cell.parts(bias, multiplier, lost);
        (stretched(cell) - one + along / unit).magnitude()
    })?;
    // Two steps are those of the script. A normal of 14 bits is longer than 1 by less than 5.3e-5.
    show("cosine", stages.cosine.absolute - 2.0 * FINER, &|cell| {
        let (across, _) = cell.parts(0.0, Interval::exactly(-1.0), lost_of_15);
        let turned = Interval::exactly(across) * cell.stretch / cell.length;
        turned.high * (1.0 + 5.3e-5) * (1.0 + evaluation.root) * (1.0 + 1e-8)
    })?;
    // The distance is `2^14 |v|`, of which a product is rounded down; then it is rounded to a mantissa.
    let distance = |cell: &Cell| (one + root) / cell.stretch * both(1.0 / 268_435_456.0) * both(ROUNDED);
    let given = both(ROUNDED) * truncated * both(RANGE);
    show("near", stages.near.relative, &|cell| {
        let far = distance(cell) * given - one;
        let squared = one / cell.stretch.squared() * both(ROUNDED) * given - one;
        far.magnitude().max(squared.magnitude())
    })?;
    show("inverse power", stages.inverse_power[1] - INVERSE_POWER[1], &|cell| {
        (distance(cell) - one).magnitude()
    })?;
    show("inverse square", stages.inverse_square, &|cell| {
        let square = Interval::new(0.0, 1.0) * cell.length.squared() / Interval::exactly(2_f64.powi(44));
        let squared = (cell.stretch * (one + root)).squared() - square;
        // The product with the gain is rounded down to a mantissa: see the script.
        (squared * Interval::new(1.0 - 9.2e-5, 1.0) * truncated - one).magnitude()
    })?;
    show("inverse polynomial", stages.inverse_polynomial, &|cell| of_polynomial(distance(cell), SIXTEEN_BITS))
}

/// What is lost of a polynomial of the distance: by the rounding and the truncation of a mantissa, of the smaller one
/// of two in a sum, and by a reciprocal.
type Lost = [f64; 4];
const SIXTEEN_BITS: Lost = [ROUNDED, TRUNCATED, FINE_STEP, 0.501 / 32_768.0];
const TWENTY_EIGHT_BITS: Lost = [FINE_STEP * 4.0, 0.0, 0.0, 0.9 / 134_217_728.0];

/// Returns the error of a gain that is attenuated by a polynomial without cancellation: two products with the
/// distance and two sums, each rounded, the reciprocal, and the product with the gain.
fn of_polynomial(distance: Interval, [rounded, truncated, aligned, inverse]: Lost) -> f64 {
    let truncated = Interval::new(1.0 - truncated, 1.0);
    let computed = both(rounded).squared() * both(rounded).squared() * both(aligned).squared();
    let divisor = distance.squared() * truncated * computed;
    (truncated * both(rounded) * both(inverse) / divisor - Interval::exactly(1.0)).magnitude()
}

/// Proves the error of a fine evaluation's estimate of a reciprocal length, which is that of 15 bits, and the
/// attenuation by a polynomial.
fn prove_finely(evaluation: &Evaluation) -> Result<(), String> {
    let one = Interval::exactly(1.0);
    let root = evaluation.root;
    let estimate = |cell: &Cell| (cell.stretch * both(root) - one).magnitude();
    show("estimate", evaluation.estimate(), [lost(32, 15), root], &estimate)?;
    let lost = if evaluation.kind == Kind::Fine32 { TWENTY_EIGHT_BITS } else { SIXTEEN_BITS };
    let distance = both(evaluation.length()) * both(evaluation.halved()) * both(lost[0]);
    let error = of_polynomial(distance, lost);
    let stated = evaluation.stages.inverse_polynomial;
    if error > stated { Err(format!("inverse polynomial: {error:e} over {stated:e}")) } else { Ok(()) }
}
