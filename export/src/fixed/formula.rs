//! The curve of a falloff and the factor of an attenuation in the C of the 16-bit format.

use std::fmt::Write;

use luminaire::Fx16;
use luminaire::codegen::Gain16;

use crate::name::global;
use crate::trace::{Operation, Trace};

/// Which of the two evaluations of the format: `coarse` or `fine`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Precision(pub(super) &'static str);

/// Returns the function of a falloff's argument in one of the two evaluations.
pub(super) fn curve(name: &str, trace: &Trace<Fx16>, precision: Precision) -> String {
    let (mut body, results) = statements(name, "t", trace, precision, &mut Vec::new());
    let result = &results[trace.result];
    let result = match trace.guard {
        Some(guard) => format!("{} > 0 ? {result} : 0", results[guard]),
        None => result.clone(),
    };
    let _ = write!(body, "    return {result};");
    let Precision(precision) = precision;
    format!(
        "static inline uint32_t {}(uint32_t t) {{\n{body}\n}}\n",
        global(name, &format!("{precision}_curve"))
    )
}

/// Returns a function of a ray and a share: an attenuation, or its windows alone. Adds the gains that
/// the function names as definitions.
pub(super) fn attenuation(
    name: &str,
    part: &str,
    trace: &Trace<Fx16>,
    precision: Precision,
    constants: &mut Vec<String>,
) -> String {
    let (mut body, results) = statements(name, "share", trace, precision, constants);
    let Precision(precision) = precision;
    let all = if precision == "fine" { "LUMINAIRE_FINE_ONE" } else { "LUMINAIRE_FULL_SCALE" };
    for &end in &trace.ends {
        let _ = writeln!(body, "    if ({} == {all}) {{ return 0; }}", results[end]);
    }
    let _ = write!(body, "    return {};", results[trace.result]);
    let unused = [("spot->", "spot"), ("(ray", "ray")].map(|(used, parameter)| {
        if body.contains(used) { String::new() } else { format!("    (void){parameter};\n") }
    });
    format!(
        "static inline uint32_t {}(\n    const luminaire_spot *spot, const luminaire_{precision}_ray *ray, \
         uint32_t share\n) {{\n{}{body}\n}}\n",
        global(name, &format!("{precision}_{part}")),
        unused.concat()
    )
}

/// Returns the initialiser of a gain.
pub(super) fn gain_of(gain: Gain16) -> String {
    let [mantissa, shift] = gain.to_bits();
    format!("{{ UINT32_C({:#x}), {shift} }}", mantissa as u32)
}

/// Defines a gain, unless there is the same already, and returns its name.
fn constant(constants: &mut Vec<String>, light: &str, part: &str, size: &str, value: &str) -> String {
    for number in 1.. {
        let part = if number == 1 { part.to_owned() } else { format!("{part}_{number}") };
        let name = global(light, &part);
        let begin = format!("static const luminaire_gain {name}{size} = ");
        let definition = format!("{begin}{value};");
        let before = constants.iter().find(|before| before.starts_with(&begin));
        if before.is_none_or(|before| *before == definition) {
            if before.is_none() {
                constants.push(definition);
            }
            return name;
        }
    }
    unreachable!("a light has few gains")
}

/// Returns the statements of a trace, and the expression of each operation.
fn statements(
    name: &str,
    argument: &str,
    trace: &Trace<Fx16>,
    precision: Precision,
    constants: &mut Vec<String>,
) -> (String, Vec<String>) {
    let Precision(precision) = precision;
    let mut body = String::new();
    let mut results: Vec<String> = Vec::new();
    let mut locals = 0;
    for (operation, uses) in trace.operations.iter().zip(trace.uses()) {
        let mut text = if *operation == Operation::Argument {
            argument.to_owned()
        } else {
            expression(name, operation, precision, &results, constants)
        };
        if uses > 1 && *operation != Operation::Argument {
            locals += 1;
            let local = format!("x{locals}");
            let _ = writeln!(body, "    const uint32_t {local} = {text};");
            text = local;
        }
        results.push(text);
    }
    (body, results)
}

fn expression(
    name: &str,
    operation: &Operation<Fx16>,
    precision: &str,
    results: &[String],
    constants: &mut Vec<String>,
) -> String {
    let call = |function: &str, arguments: &[&str]| {
        format!("luminaire_{precision}_{function}({})", arguments.join(", "))
    };
    let of = |index: usize| results[index].as_str();
    match *operation {
        Operation::Argument => unreachable!("the name of the argument"),
        Operation::Complement(x) => call("complement", &[of(x)]),
        Operation::FineProduct(a, b) => call("fine_product", &[of(a), of(b)]),
        Operation::Product(a, b) => call("product", &[of(a), of(b)]),
        Operation::RealPower(x, bits) => {
            let [mantissa, shift, least, gain] = bits.map(|bits| format!("UINT32_C({bits})"));
            call("real_power", &[of(x), &mantissa, &shift, &least, &gain])
        }
        Operation::Scalar(x) => call("scalar", &[of(x)]),
        Operation::Of(a, b) => call("of", &[of(a), of(b)]),
        Operation::Rest(x) => call("rest", &[of(x)]),
        Operation::Step(x) => call("step", &[of(x)]),
        Operation::Smooth(x) => call("smooth", &[of(x)]),
        Operation::Quadratic(x, g) => call("quadratic", &[of(x), &g.to_bits().to_string()]),
        Operation::Cubic(x, g, h) => {
            call("cubic", &[of(x), &g.to_bits().to_string(), &h.to_bits().to_string()])
        }
        Operation::SoftPair(x, share, ratio) => {
            let [mantissa, shift] = ratio.to_bits();
            let mantissa = format!("UINT32_C({:#x})", mantissa as u32);
            call("soft_pair", &[of(x), &share.to_bits().to_string(), &mantissa, &shift.to_string()])
        }
        Operation::Sample(x, ref samples) => {
            call("sample", &[of(x), &global(name, "table"), &samples.len().to_string()])
        }
        Operation::Along(x, ref knots) => {
            call("along", &[of(x), &global(name, "table"), &knots.len().to_string()])
        }
        Operation::Near(gain) => {
            call("near", &["ray", &constant(constants, name, "range", "", &gain_of(gain))])
        }
        Operation::SquaredNear(gain) => {
            call("squared_near", &["ray", &constant(constants, name, "squared_range", "", &gain_of(gain))])
        }
        Operation::ShareOf(a, b) => call("times", &[of(a), of(b)]),
        Operation::Smoothed(x) => call("smoothed", &[of(x)]),
        Operation::Give(share) => call("give", &[of(share), "spot->intensity"]),
        Operation::InverseSquare(share) => call("inverse_square", &["ray", of(share), "spot->intensity"]),
        Operation::Polynomial(share, gains) => {
            let gains = format!("{{ {} }}", gains.map(gain_of).join(", "));
            let divisor = constant(constants, name, "divisor", "[3]", &gains);
            let (distance, intensity) = (call("distance", &["ray"]), "spot->intensity".to_owned());
            call("give", &[of(share), &format!("luminaire_polynomial({distance}, {divisor}, {intensity})")])
        }
        Operation::Decay(share, power) => {
            let [mantissa, shift, most] = power.to_bits();
            let (distance, intensity) = (call("distance", &["ray"]), "spot->intensity".to_owned());
            let factor = format!(
                "luminaire_decay({distance}, UINT32_C({mantissa}), {shift}, INT32_C({}))",
                most as i32
            );
            call("give", &[of(share), &format!("luminaire_gain_by({factor}, {intensity})")])
        }
    }
}

/// Returns the table of a falloff as a definition; empty for a falloff without a table.
pub(super) fn table(name: &str, trace: &Trace<Fx16>) -> String {
    for operation in &trace.operations {
        let (kind, values) = match operation {
            Operation::Sample(_, samples) => ("uint16_t", samples.iter().map(u16::to_string).collect()),
            Operation::Along(_, knots) => {
                let knot = |(place, value, slope)| format!("{{ {place}, {value}, {slope} }}");
                ("luminaire_knot", knots.iter().map(|line| knot(line.to_bits())).collect())
            }
            _ => continue,
        };
        return samples(name, kind, values);
    }
    String::new()
}

/// Returns the definition of the table of a light, of values of a type.
pub(super) fn samples(name: &str, kind: &str, values: Vec<String>) -> String {
    let rows = values.chunks(8).map(|row| row.join(", ")).collect::<Vec<_>>().join(",\n    ");
    let (name, count) = (global(name, "table"), values.len());
    format!("static const {kind} {name}[{count}] LUMINAIRE_TABLE = {{\n    {rows}\n}};\n")
}
