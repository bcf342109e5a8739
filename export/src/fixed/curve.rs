//! The curve of a falloff in the C of the 16-bit format.

use std::fmt::Write;

use luminaire::Fx16;

use super::attenuation::Precision;
use crate::name::global;
use crate::trace::{Operation, Trace};

/// Returns the function of a falloff's argument in one of the two evaluations.
pub(super) fn curve(name: &str, trace: &Trace<Fx16>, precision: Precision) -> String {
    let Precision(precision) = precision;
    let mut body = String::new();
    let mut results: Vec<String> = Vec::new();
    let mut locals = 0;
    for (operation, uses) in trace.operations.iter().zip(trace.uses()) {
        let mut text = expression(name, operation, precision, &results);
        if uses > 1 && *operation != Operation::Argument {
            locals += 1;
            let local = format!("x{locals}");
            let _ = writeln!(body, "    const uint32_t {local} = {text};");
            text = local;
        }
        results.push(text);
    }
    let result = &results[trace.result];
    let result = match trace.guard {
        Some(guard) => format!("{} > 0 ? {result} : 0", results[guard]),
        None => result.clone(),
    };
    format!(
        "static inline uint32_t {}(uint32_t t) {{\n{body}    return {result};\n}}\n",
        global(name, &format!("{precision}_curve"))
    )
}

fn expression(name: &str, operation: &Operation<Fx16>, precision: &str, results: &[String]) -> String {
    let call = |function: &str, arguments: &[&str]| {
        format!("luminaire_{precision}_{function}({})", arguments.join(", "))
    };
    let of = |index: usize| results[index].as_str();
    match *operation {
        Operation::Argument => "t".to_owned(),
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
        Operation::Sample(x, ref samples) => {
            call("sample", &[of(x), &global(name, "table"), &samples.len().to_string()])
        }
        Operation::Along(x, ref knots) => {
            call("along", &[of(x), &global(name, "table"), &knots.len().to_string()])
        }
    }
}

/// Returns the table of a falloff as a definition; empty for a falloff without a table.
pub(super) fn table(name: &str, trace: &Trace<Fx16>) -> String {
    let rows =
        |values: Vec<String>| values.chunks(8).map(|row| row.join(", ")).collect::<Vec<_>>().join(",\n    ");
    for operation in &trace.operations {
        let (kind, values) = match operation {
            Operation::Sample(_, samples) => ("uint16_t", samples.iter().map(u16::to_string).collect()),
            Operation::Along(_, knots) => {
                let knot = |(place, value, slope)| format!("{{ {place}, {value}, {slope} }}");
                ("luminaire_knot", knots.iter().map(|line| knot(line.to_bits())).collect())
            }
            _ => continue,
        };
        let values: Vec<String> = values;
        return format!(
            "static const {kind} {}[{}] = {{\n    {}\n}};\n",
            global(name, "table"),
            values.len(),
            rows(values)
        );
    }
    String::new()
}
