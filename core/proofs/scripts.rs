//! The scripts of an evaluation: what each operation adds to the exact result of its arguments.

extern crate std;

use std::format;
use std::string::String;
use std::vec::Vec;

use super::gappa::{Script, Text};
use super::model::{Constants, Number};
use super::{Evaluation, FINE_STEP, FINER, Kind, STEP, fx16, fx32};

type Scripts = Vec<(Script, String)>;

/// Returns the scripts of an evaluation, with their texts.
pub(super) fn of(evaluation: &Evaluation, constants: &Constants) -> Scripts {
    let mut scripts = Scripts::new();
    let mut add = |script: Script| {
        let text = script.text();
        scripts.push((script, text));
    };
    match evaluation.kind {
        Kind::Coarse(_) | Kind::Quick(_) => {
            for is_short in [false, true] {
                add(ramp(evaluation, constants, is_short));
            }
            add(difference(evaluation, constants));
            add(products(evaluation, constants));
            add(smooth(evaluation, constants));
            add(lifted(evaluation, constants));
            add(narrow(evaluation, constants));
            add(pair(evaluation, constants));
            add(samples(evaluation, constants));
            add(cosine(evaluation, constants));
            add(light(evaluation, constants));
            add(gains(evaluation, constants));
            add(powers(evaluation, constants));
        }
        // Its stages are those near the light, with what is lost beside them.
        Kind::Far16 => return scripts,
        Kind::Fine16 | Kind::Fine32 => {
            add(excess(evaluation, constants));
            add(corrected(evaluation, constants));
            for is_short in [false, true] {
                add(fine_ramp(evaluation, constants, is_short));
            }
            add(fine_products(evaluation, constants));
            add(fine_narrow(evaluation, constants));
            add(fine_pair(evaluation, constants));
            add(fine_cosine(evaluation, constants));
            add(fine_light(evaluation, constants));
            add(fine_length(evaluation, constants));
            for falls in [false, true] {
                add(fine_samples(evaluation, constants, falls));
            }
        }
    }
    add(set_up(evaluation));
    add(rounded(evaluation, constants));
    add(incidence(evaluation, constants));
    scripts
}

fn named(evaluation: &Evaluation, name: &str) -> Script {
    Script::new(format!("{}_{name}", evaluation.name))
}

/// The ramp, for every cone and every versine: `t` against the exact quotient of excess and span.
fn ramp(evaluation: &Evaluation, constants: &Constants, is_short: bool) -> Script {
    let mut script = named(evaluation, if is_short { "short_ramp" } else { "ramp" });
    // The divisor, of which the upper bit is set; its reciprocal is rounded down, or less by one.
    script.given("D", [2_147_483_648.0, 4_294_967_295.0]);
    script.given("k", [0.0, 1.0]);
    let reciprocal = Text::new("(9223372036854775808 / D - k)").named("FM");
    // A long span is shifted right by `1 / q`; a short one is scaled up by `up`.
    let (q, up) = if is_short {
        (Text::from(1), script.given("w", [1.0, 32_768.0]))
    } else {
        (script.given("q", [0.5_f64.powi(31), 1.0]), Text::from(1))
    };
    let mantissa = constants.ramp_mantissa(reciprocal, up.clone());
    let excess = script.integer("x", [0.0, 65_536.0]);
    script.given("h", [0.0, 1.0]);
    // The rounding is raised so that the last versine gives a `t` of at least 0: by what `raw` is below 0 else.
    let raised = script.given("raised", [0.0, 32_769.0]);
    let step = if is_short { Text::from(1) } else { Text::new("(1 / q)") };
    let raw = constants.risen(mantissa, step.clone(), excess, raised).named("raw");
    script.states("raw", [-32_769.0, u32::MAX.into()]);
    let t = raw.down(16).named("t");
    Text::new(format!("D / 65536 / {up}")).named("Y");
    Text::new(format!("x + (1 - {q}) * h")).named("past");
    Text::new("32768 - 32768 * (past / Y)").named("T");
    script.given("past / Y", [0.0, 1.0]);
    let bound = evaluation.stages.ramp.absolute / FINER;
    script.states(format!("{t} - T"), [-bound, bound]);
    let (bits, half) = (1_u64 << constants.mantissa_bits, constants.ramp_half);
    script.given("FM", [2_147_483_647.0, 4_294_967_295.0]);
    let rounding = bits / 2;
    let exact = format!("{up} * 140737488355328 / D");
    script.equal(
        format!("m - {exact}"),
        format!(
            "(m - (FM * {up} + {rounding}) / {bits}) + {rounding} / {bits} - k * {up} / {bits} + \
             ({up} * 9223372036854775808 / D) * (1 / {bits} - 1 / 65536)"
        ),
        "D",
    );
    script.equal(
        "raw / 65536 - T",
        format!(
            "{half} / 65536 + raised / 65536 + ((1 - {q}) * (h - 1 / 2)) * m / 65536 + \
                 ((m * (1 - {q})) / 2 - less) / 65536 - past * (m - {exact}) / 65536"
        ),
        if is_short { "D w Y" } else { "D Y" },
    );
    script.equal(
        format!("(m * (1 - {q})) / 2 - less"),
        format!("((m - dropped) / 2 - less) - (m * {q} - dropped) / 2"),
        "",
    );
    if !is_short {
        script.equal("m / (1 / q) - m * q", "0", "q");
        script.equal("m - dropped", "m * (1 - q) + (m * q - dropped)", "");
    }
    script.equal("past", "(past / Y) * Y", if is_short { "D w Y" } else { "D Y" });
    script
}

/// The difference of a direction and an axis, in units of a step of 2 to 2^16.
fn difference(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "difference");
    let apart = script.given("D", [-2_147_483_648.0, 2_147_483_648.0]);
    let step = script.given("s", [2.0, 65_536.0]);
    let found = constants.difference(apart, step);
    // Three components have an error of `sqrt(3)` times as much.
    let bound = evaluation.stages.difference / STEP / 1.732;
    script.rounds(&found, "D / s", &format!("{} / 2", constants.difference_half), "s", [-bound, bound]);
    script
}

/// Products of fractions and shares.
fn products(evaluation: &Evaluation, constants: &Constants) -> Script {
    let stages = &evaluation.stages;
    let mut script = named(evaluation, "products");
    let [a, b] = ["a", "b"].map(|name| script.integer(name, [0.0, 32_768.0]));
    let [share, other] = ["share", "other"].map(|name| script.integer(name, [0.0, 16_384.0]));
    let half = format!("{} / 32768", constants.fraction_half);
    let within = |bound: f64| [-bound, bound];
    let found = constants.times(a.clone(), b.clone());
    script.rounds(&found, "a * b / 32768", &half, "", within(stages.product.absolute / FINER));
    let found = constants.times(a.clone(), share.clone());
    script.rounds(&found, "a * share / 32768", &half, "", within(stages.value.absolute / STEP));
    let found = constants.times_to_value(a.clone(), b);
    let half = format!("{} / 65536", constants.value_half);
    script.rounds(&found, "a * b / 65536", &half, "", within(stages.value.absolute / STEP));
    let found = constants.value(a);
    script.rounds(&found, "a / 2", "1 / 2", "", within(stages.value.absolute / STEP));
    let found = constants.share_of(share, other);
    script.rounds(&found, "share * other / 16384", "1 / 2", "", within(stages.share.absolute / STEP));
    script
}

/// `t^2 (3 - 2 t)`.
fn smooth(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "smooth");
    let t = script.integer("t", [0.0, 32_768.0]);
    let found = constants.smooth(t);
    let bound = evaluation.stages.smooth.absolute / STEP;
    script.equal("sum / 32768 - t * t / 32768", format!("{} / 32768", constants.fraction_half), "");
    let apart =
        format!("{} / 65536 + (fraction - t * t / 32768) * (98304 - 2 * t) / 65536", constants.value_half);
    script.rounds(&found, "t * t * (98304 - 2 * t) / 2147483648", &apart, "", [-bound, bound]);
    script
}

/// `t (1 + u (g + h t))` with coefficients that are rounded.
fn lifted(evaluation: &Evaluation, constants: &Constants) -> Script {
    let stages = &evaluation.stages;
    let mut script = named(evaluation, "lifted");
    let t = script.integer("t", [0.0, 32_768.0]);
    let u = (Text::from(1 << 15) - t.clone()).named("u");
    let g = script.integer("g", [-16_384.0, 49_152.0]);
    let h = script.integer("h", [-65_536.0, 32_768.0]);
    // What rounds beside the coefficients themselves: the sum of two.
    constants.bend(t.clone(), g, h).named("bend");
    let bound = stages.weight / STEP;
    script.rounds(&Text::new("bent"), "t * h / 32768", "1 / 2", "", [-bound, bound]);
    // A monotone cubic is in [0, 1].
    let slope = script.integer("w", [-49_152.0, 49_152.0]);
    script.given("lifted", [0.0, 1_073_774_592.0]);
    let found = constants.quadratic(t, u, slope);
    script.equal("slope_half / 16384 - u * w / 16384", "1 / 2", "");
    let apart = format!("{} / 65536 + t * (lift - u * w / 16384) / 65536", constants.value_half);
    let bound = stages.lift.relative / STEP + stages.value.absolute / STEP;
    script.rounds(&found, "t * (32768 + u * w / 16384) / 65536", &apart, "", [-bound, bound]);
    script
}

/// How far the narrow one of two soft falloffs is off, in units of a fraction.
const NARROW: f64 = 1.032;

/// `1 - w` of the narrow one of two soft falloffs, up to its end: from there on, both it and the exact one are capped.
fn narrow(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "narrow");
    let u = script.integer("u", [0.0, 32_768.0]);
    // The upper 16 bits of the mantissa, what follows them, and `2^bits`.
    let mantissa = script.integer("m", [32_768.0, 65_535.0]);
    script.given("e", [0.0, 1.0]);
    let step = script.given("s", [32.0, 32_768.0]);
    // The product of the mantissa and `u / s` is at most 2^15.
    script.given("u / s", [0.0, 1.0]);
    let found = constants.narrow(u, mantissa, step).named("fallen");
    script.rounds(&found, "u * (m + e) / s", "1 - 1 / s - u / s * e", "s", [-NARROW, NARROW]);
    script
}

/// Two soft falloffs, of a narrow part and a share that are rounded.
fn pair(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "pair");
    let [t, narrow] = ["t", "n"].map(|name| script.integer(name, [0.0, 32_768.0]));
    let share = script.integer("k", [0.0, 16_384.0]);
    script.given("N", [0.0, 32_768.0]);
    script.given("n - N", [-NARROW, NARROW]);
    script.given("k - K", [-0.5, 0.5]);
    let found = constants.pair(t, narrow, share);
    let bound = evaluation.stages.pair.absolute / STEP;
    let apart = format!(
        "{} / 65536 + (fraction - n * n / 32768) * k / 32768 + (fraction2 - t * t / 32768) * (16384 - k) / 32768 \
         + k * ((n - N) * (n + N)) / 1073741824 + (k - K) * (N * N - t * t) / 1073741824",
        constants.value_half
    );
    let exact = "((16384 - K) * (t * t) + K * (N * N)) / 1073741824";
    script.rounds(&found, exact, &apart, "", [-bound, bound]);
    for (square, of) in [("fraction", "n"), ("fraction2", "t")] {
        let sum = if of == "n" { "sum" } else { "sum2" };
        script.equal(
            format!("{square} - {of} * {of} / 32768"),
            format!("({square} - {sum} / 32768) + {} / 32768", constants.fraction_half),
            "",
        );
    }
    script
}

/// The interpolation of samples of 16 bits, to a sample between them.
fn samples(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "samples");
    let here = script.integer("here", [0.0, 65_535.0]);
    let step = script.integer("step", [-65_535.0, 65_535.0]);
    let share = script.integer("part", [0.0, 32_767.0]);
    script.given("line / 32768", [0.0, 65_535.5]);
    let found = constants.interpolated(here, step, share);
    script.rounds(&found, "(here + step * part / 32768)", "1 / 2", "", [-0.5, 0.5]);
    script
}

/// The cosine, against that of the truncated offset `v`.
fn cosine(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "cosine");
    // The exact cosine, the length of `v`, and the error of the root.
    script.given("K", [0.0, 1.0001]);
    script.given("L", [16_382.0, 56_757.0]);
    script.given("er", [-evaluation.root, evaluation.root]);
    let facing = Text::new("K * L * 16384");
    let reciprocal = Text::new("1073741824 / L * (1 + er)").named("r");
    script.given("r", [18_900.0, 65_535.0]);
    let found = constants.cosine(facing, reciprocal);
    let bits = 1_u64 << constants.along;
    let whole = format!("(along - facing / {bits}) * r + {} * K * (1 + er)", (1_u64 << 44) / bits);
    script.equal("along * r", &whole, "L");
    let apart = format!(
        "(along - facing / {bits}) * r / 65536 + {} * K * (1 + er)",
        (1_i64 << 28) / bits as i64 - 32_768
    );
    // The inner product and the result are rounded down.
    script.rounds(&found, "32768 * K * (1 + er)", &apart, "L", [-2.0, 0.0]);
    script
}

/// The light at a distance: the square of a reciprocal length, and its product with a gain and a share.
fn light(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "light");
    let reciprocal = script.integer("r", [18_910.0, 65_535.0]);
    let gain = script.integer("g", [32_768.0, 65_535.0]);
    let share = script.integer("share", [0.0, 16_384.0]);
    let squared = constants.squared_reciprocal(reciprocal);
    script.states("squared - r * r / 65536", [-1.0, 0.0]);
    let mantissa = constants.attenuated(gain, squared);
    drop((share * mantissa).word("lit"));
    script.states("mantissa * 16384 / (g * squared) - 1", [-9.2e-5, 0.0]);
    let bits = 1_u64 << constants.mantissa;
    script.equal(
        "mantissa * 16384 / (g * squared) - 1",
        format!("(mantissa - g * squared / {bits}) * 16384 / (g * squared) + (16384 / {bits} - 1)"),
        "g squared",
    );
    script
}

/// The rounding of a gain to a mantissa of 16 bits, and the truncation to its upper 16 bits.
fn gains(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "gains");
    let mantissa = script.integer("m", [2_147_483_648.0, 4_294_967_295.0]);
    let rounded = constants.normalised(mantissa.clone());
    script.rounds(&rounded, "m / 65536", &format!("{} / 2", constants.gain_half), "", [-0.5, 0.5]);
    script.states("rounded * 65536 / m - 1", [-STEP / 4.0, STEP / 4.0]);
    script.equal("rounded * 65536 / m - 1", "(rounded - m / 65536) * 65536 / m", "m");
    mantissa.down(16).named("upper");
    script.states("upper * 65536 / m - 1", [-evaluation.stages.gain, 0.0]);
    script.equal("upper * 65536 / m - 1", "(upper - m / 65536) * 65536 / m", "m");
    script
}

/// The rounding of a power to a fraction.
fn powers(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "powers");
    let power = script.integer("p", [0.0, 2_147_483_648.0]);
    let found = constants.power(power).named("found");
    let bound = evaluation.stages.power.absolute / FINER;
    script.rounds(&found, "p / 65536", "1 / 2", "", [-bound, bound]);
    script
}

/// What is rounded at set-up: a versine, in units of 2^-29, and a coefficient of a falloff.
fn set_up(evaluation: &Evaluation) -> Script {
    let stages = &evaluation.stages;
    let mut script = named(evaluation, "set_up");
    let versine = script.given("v", [0.0, 4_294_967_295.0]).nearest().named("versine");
    let bound = stages.set_up / FINE_STEP * 0.5;
    script.states(format!("{versine} - v"), [-bound, bound]);
    let coefficient = script.given("c", [-4_294_967_296.0, 4_294_967_296.0]).nearest().named("coefficient");
    if evaluation.kind == Kind::Fine32 {
        // Of 30 fraction bits, 28 are kept.
        let bound = stages.weight / FINE_STEP / 4.0;
        let kept = coefficient.down(2).named("kept");
        script.states(format!("{kept} - c / 4"), [-bound, bound]);
        script.equal(format!("{kept} - c / 4"), "(kept - coefficient / 4) + (coefficient - c) / 4", "");
    } else {
        let bound = stages.weight / STEP;
        script.states(format!("{coefficient} - c"), [-bound, bound]);
    }
    script
}

/// The rounding of light, and that of a share of a range, to the last bit.
fn rounded(evaluation: &Evaluation, constants: &Constants) -> Script {
    let stages = &evaluation.stages;
    let mut script = named(evaluation, "rounded");
    let product = script.integer("lit", [0.0, 4_294_967_295.0]);
    let step = script.given("s", [1.0, 4_294_967_296.0]);
    let found = constants.quotient(product.clone(), step.clone(), 1).named("found");
    let unit = if evaluation.kind == Kind::Fine32 { FINE_STEP } else { STEP };
    let bound = stages.light.absolute / unit;
    script.rounds(&found, "lit / s", "1 / 2", "s", [-bound, bound]);
    if evaluation.kind == Kind::Fine16 {
        // This share has 31 bits, and is rounded down.
        let share = product.divided(step).named("down");
        script.states(format!("{share} - lit / s"), [-stages.near.absolute / FINE_STEP * 2.0, 0.0]);
    } else {
        let bound = stages.near.absolute / unit;
        script.states(format!("{found} - lit / s"), [-bound, bound]);
    }
    script
}

/// The cosine of light that has the same direction everywhere, without the error of the direction.
fn incidence(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "incidence");
    let stated = evaluation.stages.incidence.absolute;
    if evaluation.kind == Kind::Fine32 {
        // Three products are rounded down.
        let whole = script.given("whole", [-1.2e18, 1.2e18]);
        let lacking = script.given("lacking", [0.0, 3.0]);
        let found = constants.incidence(whole - lacking, 28).named("found");
        let bound = (stated - fx32::errors::AXIS_TURN) / FINE_STEP;
        script.equal(
            format!("{found} + whole / 268435456"),
            "(found - (134217728 - (whole - lacking)) / 268435456) + 1 / 2 + lacking / 268435456",
            "",
        );
        script.states(format!("{found} + whole / 268435456"), [-bound, bound]);
        return script;
    }
    let direction = script.integer("d", [-1_073_800_000.0, 1_073_800_000.0]);
    let component = constants.rounded_component(direction).named("component");
    // Three components are within `sqrt(3)` of one, and a normal is longer than 1 by less than 5.3e-5.
    let of_axis = fx16::errors::AXIS_LENGTH + fx16::errors::AXIS_TURN;
    let bound = ((stated - of_axis) / STEP - 0.5) / 1.732_051 / (1.0 + 5.3e-5);
    script.rounds(&component, "d / 65536", "1 / 2", "", [-bound, bound]);
    let along = script.integer("along", [-536_870_912.0, 536_870_912.0]);
    let found = constants.incidence(along, 14).named("cosine");
    script.equal(format!("{found} + along / 16384"), "(cosine - (8192 - along) / 16384) + 1 / 2", "");
    script.states(format!("{found} + along / 16384"), [-0.5, 0.5]);
    script
}

/// The length of a direction after one step of Newton, of an estimate of its reciprocal.
///
/// `N = 2^30 (1 + e)` is the length before the step, `k` and `n` what the components of that vector, which are
/// rounded down, lack along it and in all, and `s` what three squares lack.
fn excess(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "excess");
    let estimate = evaluation.estimate();
    script.given("e", [-estimate, estimate]);
    script.given("k", [-1.7322, 1.7322]);
    script.given("n", [0.0, 3.0]);
    script.given("s", [0.0, 3.0]);
    Text::new("1073741824 * (1 + e)").named("N");
    let over = Text::new("((N * N - 2 * N * k + n) / 4294967296 - s - 268435456)").named("over");
    let _excess = constants.excess(over);
    // Twice the relative error and its square, exactly and as computed.
    Text::new("(2 * e + e * e)").named("y");
    Text::new("over / 268435456").named("x");
    let bound = evaluation.newton();
    script.states("(1 + e) * (1 - excess / 67108864) - 1", [-bound, bound]);
    let Constants { newton, newton_bits, excess_bits, .. } = *constants;
    let (thrice, dropped) = (1_u64 << newton_bits, 1 << excess_bits);
    let (straight, curved) = (format!("4 / {dropped}"), format!("{newton} * 4194304 / {thrice}"));
    script.equal(
        "(1 + e) * (1 - excess / 67108864) - 1",
        "e * e * e * (5 / 2 + e * (15 / 8 + e * 3 / 8)) + (1 + e) * (y / 2 - y * y * 3 / 8 - excess / 67108864)",
        "",
    );
    script.equal(
        "y / 2 - y * y * 3 / 8 - excess / 67108864",
        format!(
            "y * (1 / 2 - {straight}) + (y - x) * {straight} - (straight - over / {dropped}) / 67108864 \
             + (curved - {newton} * square / {thrice}) / 67108864 \
             + {newton} * (coarse - over / 16) * (coarse + over / 16) / {thrice} / 67108864 \
             + (x - y) * (x + y) * ({curved}) + y * y * ({curved} - 3 / 8)"
        ),
        "",
    );
    script.equal("x - y", "0 - 2 * k * (1 + e) / 1073741824 + n / 1152921504606846976 - s / 268435456", "");
    script.divided("e", 32);
    script
}

/// A component of a direction, less the excess of its length.
fn corrected(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "corrected");
    let most = 1.0 + evaluation.estimate();
    let component = script.integer("c", [-1_073_741_824.0 * most, 1_073_741_824.0 * most]);
    let excess = script.integer("E", [-32_767.0, 32_767.0]);
    let found = constants.corrected(component, excess).named("found");
    script.equal(
        format!("{found} - c * (1 - E / 67108864)"),
        "0 - (less - part / 1024) - (part - c * much / 4294967296) / 1024",
        "",
    );
    script.states(format!("{found} - c * (1 - E / 67108864)"), [0.0, 1.001]);
    script
}

/// The ramp with 31 fraction bits, for every cone and every versine, and the squares of a versine.
fn fine_ramp(evaluation: &Evaluation, constants: &Constants, is_short: bool) -> Script {
    let mut script = named(evaluation, if is_short { "short_ramp" } else { "ramp" });
    script.given("D", [2_147_483_648.0, 4_294_967_295.0]);
    script.given("k", [0.0, 1.0]);
    let reciprocal = Text::new("(9223372036854775808 / D - k)").named("FM");
    script.given("FM", [2_147_483_647.0, 4_294_967_295.0]);
    let excess = script.integer("x", [0.0, 4_294_967_295.0]);
    let step = if is_short { Text::from(1) } else { script.given("p", [1.0, 4_294_967_296.0]) };
    let fallen = constants.fallen(excess, reciprocal, step.clone());
    let bound = evaluation.stages.ramp.absolute / FINE_STEP * 2.0;
    let over = if is_short { String::new() } else { format!(" / {step}") };
    let error = format!("{fallen} - x * 2147483648 / D{over}");
    script.states(&error, [-bound, 0.0]);
    let before = format!("(upper - x * FM / 4294967296){over} - x * k / 4294967296{over}");
    let last = if is_short { String::new() } else { format!("(fallen - upper{over}) + ") };
    script.equal(error, last + &before, if is_short { "D" } else { "D p" });
    let part = script.integer("part", [-2_147_483_648.0, 2_147_483_647.0]);
    constants.high_square(part);
    let bound = evaluation.stages.versine.absolute / FINE_STEP / 2.0 / 3.0;
    script.states("upper2 - part * part / 4294967296", [-bound, 0.0]);
    script
}

/// Products of fractions with 31 bits, `t^2 (3 - 2 t)`, and `t (1 + u slope)`.
fn fine_products(evaluation: &Evaluation, constants: &Constants) -> Script {
    let stages = &evaluation.stages;
    let mut script = named(evaluation, "products");
    let unit = FINE_STEP / 2.0;
    let t = script.integer("t", [0.0, 2_147_483_648.0]);
    let u = (Text::from(1 << 31) - t.clone()).named("u");
    let smooth = constants.fine_smooth(t.clone(), u.clone()).named("smooth");
    // Products of fractions, of values and of shares are the same operation.
    let same = [stages.product, stages.value, stages.share].map(|product| product.absolute);
    let bound = same.into_iter().fold(f64::INFINITY, f64::min) / unit;
    script.states("fraction - t * t / 2147483648", [-bound, 0.0]);
    script.equal("fraction - t * t / 2147483648", "(upper - t * t / 4294967296) * 2", "");
    let exact = "t * t * (6442450944 - 2 * t) / 4611686018427387904";
    script.equal(
        format!("{smooth} - {exact}"),
        "(fraction - t * t / 2147483648) * (1 + 2 * u / 2147483648) + 2 * ((upper2 - fraction * u / 4294967296) * 2)",
        "",
    );
    let bound = stages.smooth.absolute / unit;
    script.states(format!("{smooth} - {exact}"), [-bound, 0.0]);
    let slope = script.integer("w", [0.0, 805_306_368.0]);
    let lift = constants.lift(t, u, slope).named("lifted");
    let bound = stages.lift.absolute / unit;
    script.states(format!("{lift} - t * u * w / 576460752303423488"), [-bound, 0.0]);
    script.equal(
        format!("{lift} - t * u * w / 576460752303423488"),
        "(lift - fraction3 * w / 4294967296) * 16 + (upper3 - t * u / 4294967296) * 2 * w / 268435456",
        "",
    );
    // Of two coefficients, one is multiplied by `t` and rounded down.
    let h = script.integer("h", [0.0, 1_073_741_824.0]);
    let bend = constants.fine_times(h, Text::new("t"));
    let bound = stages.weight * 268_435_456.0;
    script.states(format!("{bend} - h * t / 2147483648"), [-bound, 0.0]);
    script.equal(format!("{bend} - h * t / 2147483648"), "(upper4 - h * t / 4294967296) * 2", "");
    script
}

/// `1 - w` of the narrow one of two soft falloffs, up to its end.
fn fine_narrow(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "narrow");
    let scaled = script.integer("u", [0.0, 4_294_967_295.0]);
    let mantissa = script.integer("m", [2_147_483_648.0, 4_294_967_295.0]);
    let fallen = constants.fine_narrow(scaled, mantissa).named("fallen");
    script.states(format!("{fallen} - u * m / 2147483648"), [-FINE_NARROW, 0.0]);
    script.equal(format!("{fallen} - u * m / 2147483648"), "(upper - scaled * m / 4294967296) * 2", "");
    script
}

/// By how much the narrow one of two soft falloffs is too large, in units of 2^-31.
const FINE_NARROW: f64 = 2.0;

/// Two soft falloffs, of a narrow part and a share that are rounded.
fn fine_pair(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "pair");
    let [t, narrow, share] = ["t", "n", "k"].map(|name| script.integer(name, [0.0, 2_147_483_648.0]));
    script.given("N", [0.0, 2_147_483_648.0]);
    script.given("n - N", [0.0, FINE_NARROW]);
    // Half a unit of 2^-14; or half one of 2^-30 and one of 2^-28.
    let rounded = if evaluation.kind == Kind::Fine32 { 9.0 } else { 65_536.0 };
    script.given("k - K", [-rounded, rounded]);
    let found = constants.fine_pair(t, narrow, share).named("found");
    let bound = evaluation.stages.pair.absolute * 2_147_483_648.0;
    let exact = "((2147483648 - K) * (t * t) + K * (N * N)) / 4611686018427387904";
    script.states(format!("{found} - {exact}"), [-bound, bound]);
    script.equal(
        format!("{found} - {exact}"),
        "(upper2 - fraction * k / 4294967296) * 2 + (upper - n * n / 4294967296) * 2 * k / 2147483648 \
         + (upper4 - fraction3 * (2147483648 - k) / 4294967296) * 2 \
         + (upper3 - t * t / 4294967296) * 2 * (2147483648 - k) / 2147483648 \
         + k * ((n - N) * (n + N)) / 4611686018427387904 + (k - K) * (N * N - t * t) / 4611686018427387904",
        "",
    );
    script
}

/// The interpolation of samples to a fraction.
fn fine_samples(evaluation: &Evaluation, constants: &Constants, falls: bool) -> Script {
    let mut script = named(evaluation, if falls { "falling_samples" } else { "samples" });
    let here = script.integer("here", [0.0, 65_535.0]);
    let apart = script.integer("apart", [0.0, 65_535.0]);
    let share = script.integer("share", [0.0, 2_147_483_648.0]);
    let sign = if falls { "-" } else { "+" };
    let exact = format!("(here * 32768 {sign} share * apart / 65536)");
    script.given(&exact, [0.0, 2_147_450_880.0]);
    let found = constants.fine_sample(here, apart, share, falls).named("found");
    let bound = evaluation.stages.sample.absolute / FINE_STEP * 2.0;
    script.states(format!("{found} - {exact} * 65536 / 65535"), [-bound, bound]);
    script.equal(
        format!("{found} - {exact} * 65536 / 65535"),
        format!(
            "(part - ((start {sign} step) + 32768) / 65536) + 1 / 2 \
             {sign} (step - share * apart / 65536) * 65537 / 65536 - {exact} / 4294901760"
        ),
        "",
    );
    script
}

/// A component of the cosine: what it lacks, beside the errors of the direction.
fn fine_cosine(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "cosine");
    let direction = script.integer("d", [-1_073_800_000.0, 1_073_800_000.0]);
    // The errors of a direction's components turn it by at most `sqrt(3)` of 1.001 steps.
    let turned = 1.001 * 1.7321;
    let rounded = evaluation.stages.cosine.absolute / FINE_STEP - turned;
    if evaluation.kind == Kind::Fine16 {
        let normal = script.integer("n", [-16_400.0, 16_400.0]);
        constants.fine_component(direction, normal);
        script.states("component - d * n / 16384", [-rounded / 3.0, 0.0]);
    } else {
        let normal = script.integer("n", [-1_073_800_000.0, 1_073_800_000.0]);
        constants.finest_component(direction, normal);
        // Half of a normal loses up to half a unit, which is a step of the whole; three are within `sqrt(3)`.
        script.states("component - d * halved / 4294967296", [-(rounded - 1.7321) / 8.0 / 3.0, 0.0]);
        script.states("n / 2 - halved", [0.0, 1.0]);
    }
    script
}

/// The excess `E` of an estimate with the relative error `e`, which is within `l` of it.
fn excess_of_estimate(script: &mut Script, evaluation: &Evaluation) -> Text {
    let (estimate, newton) = (evaluation.estimate(), evaluation.newton());
    script.given("e", [-estimate, estimate]);
    script.given("l", [-newton, newton]);
    script.equal("E", "(e - l) / (1 + e) * 67108864", "1+e");
    Text::new("(1 - (1 + l) / (1 + e)) * 67108864").named("E")
}

/// The gain at a distance. `est = 2^46 / |W| (1 + e)`, whose excess is within `l` of `e`.
fn fine_light(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "light");
    let excess = excess_of_estimate(&mut script, evaluation);
    let gain = script.integer("g", [2_147_483_648.0, 4_294_967_295.0]);
    let found = script.integer("est", [18_910.0, 65_536.0]);
    let here = constants.finely_attenuated(gain, found, excess).named("here");
    // A share is multiplied by the attenuated gain and rounded down, which is an error of the share.
    let share = script.integer("share", [0.0, 2_147_483_648.0]);
    let lit = (share * here.clone()).down(32).word("lit");
    let given = evaluation.stages.given / FINE_STEP * 2.0;
    script.states(format!("({lit} - share * here / 4294967296) * 4294967296 / here"), [-given, 0.0]);
    let exact = "(g * est * est / 4294967296)";
    let whole = format!("{here} / {exact} * (1 + e) * (1 + e) - 1");
    let bound = evaluation.stages.inverse_square;
    script.states(&whole, [-bound, bound]);
    Text::new(format!("nearly / {exact}")).named("ratio");
    let bits = 1 << constants.nearly_bits;
    Text::new("less / nearly - twice / 67108864").named("A");
    Text::new("(second - E * E / 67108864) / 67108864").named("B");
    script.equal(&whole, "ratio * ((1 + l) * (1 + l) + (B - A) * (1 + e) * (1 + e)) - 1", "g est nearly 1+e");
    script.equal(
        "ratio",
        format!("1 + ((nearly - once * est / 65536) + (once - g * est / 65536) * est / 65536) / {exact}"),
        "g est",
    );
    script.equal(
        "A",
        format!(
            "((less - upper_bits * twice / 512) + (upper_bits - nearly / {bits}) * twice / 512) / nearly \
             + twice * (131072 / {bits} - 1) / 67108864"
        ),
        "nearly 1+e",
    );
    script.equal("E / 67108864", "(e - l) / (1 + e)", "1+e");
    script.divided("e", 16);
    script
}

/// The length of an offset. `est = 2^46 / |W| (1 + e)`, whose excess is within `l` of `e`.
fn fine_length(evaluation: &Evaluation, constants: &Constants) -> Script {
    let mut script = named(evaluation, "length");
    let excess = excess_of_estimate(&mut script, evaluation);
    let found = script.given("est", [18_910.0, 65_536.0]);
    Text::new("70368744177664 / est * (1 + e)").named("W");
    script.given("W", [1_073_741_824.0, 3_719_550_787.0]);
    script.given("s", [0.0, 3.0]);
    let squared = Text::new("(W * W / 4294967296 - s)").named("squares");
    let length = constants.length(squared, found, excess);
    let bound = evaluation.length();
    script.states(format!("{length} / W - 1"), [-bound, bound]);
    script.equal(
        format!("{length} / W - 1"),
        "(eighth - squares * reciprocal / 4294967296) * 8 / W + (reciprocal * W / 2305843009213693952 - 1) \
         - s * reciprocal / 536870912 / W",
        "W est 1+e",
    );
    script.equal(
        "reciprocal * W / 2305843009213693952 - 1",
        "l - (less - est * E / 2048) * W / 2305843009213693952",
        "est 1+e",
    );
    script
}
