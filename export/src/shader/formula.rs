//! The curve of a falloff and the factor of an attenuation in `f32`, from the operations that the kernel
//! computes.

use luminaire::number::Knot;

use super::expression::{
    Builtin, Constant, Expression, Function, Statement, Type, Value, call, clamp, if_less, name, number,
    quotient,
};
use super::names::Names;
use crate::error::ExportError;
use crate::trace::{Operation, Trace};

/// The longest table. Shaders keep it among their constants.
const LONGEST: usize = 1_024;

/// The brightest irradiance of one light: 2^64.
const BRIGHTEST: f32 = 18_446_744_073_709_551_616.0;

/// Returns a share of a gain, at most the brightest irradiance.
fn give(share: Expression, gain: Expression) -> Expression {
    call(Builtin::Min, share * gain, number(BRIGHTEST))
}

/// The full scale of samples and knots.
const FULL: f32 = 1.0 / 65_535.0;

/// Writes the operations of a trace as expressions.
pub(super) struct Lowering<'a> {
    names: &'a Names<'a>,
    /// The expression of the argument.
    argument: Expression,
    constants: Vec<Constant>,
    pub(super) body: Vec<Statement>,
    /// The expression of each operation so far.
    results: Vec<Expression>,
}

/// Returns the function `NAME_curve` of `t`, and its tables.
pub(super) fn curve(names: &Names<'_>, trace: &Trace<f32>) -> Result<(Vec<Constant>, Function), ExportError> {
    let mut lowering = Lowering::new(names, name("t"), Vec::new());
    let result = lowering.result(trace)?;
    let result = match trace.guard {
        Some(guard) => if_less(number(0.0), lowering.results[guard].clone(), result, number(0.0)),
        None => result,
    };
    let function = Function {
        doc: "Returns the falloff of t, which is 1 on the axis and 0 at the outer angle.".to_owned(),
        name: names.of("curve"),
        parameters: vec![(Type::Number, "t")],
        body: lowering.body,
        result,
    };
    Ok((lowering.constants, function))
}

impl<'a> Lowering<'a> {
    /// Begins with an argument, after some statements.
    pub(super) fn new(names: &'a Names<'a>, argument: Expression, body: Vec<Statement>) -> Self {
        Self { names, argument, constants: Vec::new(), body, results: Vec::new() }
    }

    /// Adds the statements of a trace, and returns its result.
    pub(super) fn result(&mut self, trace: &Trace<f32>) -> Result<Expression, ExportError> {
        let mut locals = 0;
        for (operation, uses) in trace.operations.iter().zip(trace.uses()) {
            let expression = self.expression(operation)?;
            // An expression that is used once stands where it is used.
            let is_simple = matches!(expression, Expression::Name(_));
            let expression = if uses > 1 && !is_simple {
                let local = match operation {
                    Operation::Complement(0) => "u".to_owned(),
                    _ => {
                        locals += 1;
                        format!("x{locals}")
                    }
                };
                name(self.local(&local, expression))
            } else {
                expression
            };
            self.results.push(expression);
        }
        let result = self.results[trace.result].clone();
        let end = |result, &end: &usize| if_less(self.results[end].clone(), number(1.0), result, number(0.0));
        Ok(trace.ends.iter().fold(result, end))
    }

    fn expression(&mut self, operation: &Operation<f32>) -> Result<Expression, ExportError> {
        let results = self.results.clone();
        let of = |index: usize| results[index].clone();
        Ok(match *operation {
            Operation::Argument => self.argument.clone(),
            Operation::Complement(x) | Operation::Rest(x) => number(1.0) - of(x),
            Operation::FineProduct(a, b)
            | Operation::Product(a, b)
            | Operation::Of(a, b)
            | Operation::ShareOf(a, b) => of(a) * of(b),
            Operation::Scalar(x) => of(x),
            Operation::Step(x) => if_less(number(0.0), of(x), number(1.0), number(0.0)),
            Operation::Smooth(x) => clamp(of(x) * of(x) * (number(3.0) - (of(x) + of(x)))),
            Operation::Quadratic(x, g) => clamp(of(x) * (number(1.0) + (number(1.0) - of(x)) * number(g))),
            Operation::Cubic(x, g, h) => {
                let slope = number(g) + number(h) * of(x);
                clamp(of(x) * (number(1.0) + (number(1.0) - of(x)) * slope))
            }
            Operation::SoftPair(x, share, ratio) => {
                let narrow = number(1.0) - (number(1.0) - of(x)) * number(ratio);
                let narrow = name(self.local("narrow", call(Builtin::Max, narrow, number(0.0))));
                let wide = number(1.0 - share) * (of(x) * of(x));
                clamp(wide + number(share) * (narrow.clone() * narrow))
            }
            Operation::Smoothed(x) => {
                let t = name(self.local("nearness", of(x)));
                t.clone() * t.clone() * (number(3.0) - number(2.0) * t)
            }
            Operation::RealPower(x, exponent) => {
                let x = of(x);
                self.power(x, exponent)
            }
            Operation::Near(gain) => clamp(self.distance() * number(gain)),
            Operation::SquaredNear(gain) => clamp(name("squared") * number(gain)),
            Operation::Give(share) => give(of(share), self.intensity()),
            Operation::InverseSquare(share) => {
                let gain = self.intensity() * (name("reciprocal") * name("reciprocal"));
                of(share) * call(Builtin::Min, gain, number(BRIGHTEST))
            }
            Operation::Polynomial(share, gains) => {
                let ([constant, linear, quadratic], share) = (gains.map(number), of(share));
                let distance = self.distance();
                let divisor = (quadratic * distance.clone() + linear) * distance + constant;
                let divisor = name(self.local("divisor", call(Builtin::Max, divisor, number(1.0))));
                give(share, quotient(number(1.0), divisor) * self.intensity())
            }
            Operation::Decay(share, power) => {
                let share = of(share);
                let factor = self.decay(power.to_bits());
                give(share, factor * self.intensity())
            }
            Operation::Sample(x, ref samples) => {
                let x = of(x);
                self.sample(x, samples)?
            }
            Operation::Along(x, ref knots) => {
                let x = of(x);
                self.along(x, knots)?
            }
        })
    }

    /// Returns a power with a real exponent, less that of the floor.
    fn power(&mut self, x: Expression, [mantissa, shift, least, gain]: [u32; 4]) -> Expression {
        // The shift of an exponent is less than 64.
        let exponent = (f64::from(mantissa) / (1_u64 << shift) as f64) as f32;
        let base = name(self.local("base", x));
        // The power of 0 is 0. On some GPUs the built-in function returns the power of a small
        // number, which is not small for a small exponent.
        let power = call(Builtin::Power, base.clone(), number(exponent));
        let power = if_less(number(0.0), base, power, number(0.0));
        if least == 0 {
            return power;
        }
        let floor = (f64::from(least) / 2_147_483_648.0) as f32;
        let gain = (f64::from(gain) / 134_217_728.0) as f32;
        clamp((power - number(floor)) * number(gain))
    }

    /// Returns a power of the distance with a negative exponent, at most the cap.
    fn decay(&mut self, [mantissa, shift, most]: [u32; 3]) -> Expression {
        let exponent = f64::from(mantissa) / (1_u64 << shift) as f64;
        let octaves = f64::from(most as i32) / 16_777_216.0;
        // The distance at the cap: the built-in power of 0 would be infinite.
        let nearest = (-octaves / exponent).exp2().max(1e-18) as f32;
        let base = call(Builtin::Max, self.distance(), number(nearest));
        let power = call(Builtin::Power, base, number(-exponent as f32));
        call(Builtin::Min, power, number(octaves.exp2() as f32))
    }

    fn intensity(&self) -> Expression {
        name(self.names.of("intensity"))
    }

    /// The local distance, whose square is the local `squared`.
    fn distance(&mut self) -> Expression {
        let distance = Expression::Call(Builtin::Sqrt, vec![name("squared")]);
        let is_local =
            |statement: &Statement| matches!(statement, Statement::Let(_, name, _) if name == "distance");
        if !self.body.iter().any(is_local) {
            self.local("distance", distance);
        }
        name("distance")
    }

    /// Interpolates between evenly spaced samples.
    fn sample(&mut self, x: Expression, samples: &[u16]) -> Result<Expression, ExportError> {
        let samples =
            self.table("samples", "samples from the axis to the edge", samples.iter().map(|&s| s.into()))?;
        let last = (samples.1 - 1) as f32;
        let place = name(self.local("place", (number(1.0) - x) * number(last)));
        let index = "i".to_owned();
        // The last segment includes its end.
        let first = call(Builtin::Min, place.clone(), number(last - 1.0));
        self.body.push(Statement::Index(index.clone(), first));
        let [from, to] = [0, 1].map(|next| Expression::Element(samples.0.clone(), index.clone(), next));
        let rise = (to - from.clone()) * (place - Expression::Converted(index));
        Ok(clamp((from + rise) * number(FULL)))
    }

    /// Evaluates the line of the last knot at or before a place.
    fn along(&mut self, x: Expression, knots: &[Knot]) -> Result<Expression, ExportError> {
        /// The number of fraction bits of the slope of a knot.
        const SLOPE: f32 = 1.0 / 32_768.0;
        let bits = || knots.iter().map(|knot| knot.to_bits());
        let places = self.table("places", "starts of the lines", bits().map(|(place, ..)| place.into()))?;
        let values =
            self.table("values", "values at the starts", bits().map(|(_, value, _)| value.into()))?.0;
        let slopes = self.table("slopes", "slopes", bits().map(|(.., slope)| slope as f32 * SLOPE))?.0;
        let place = name(self.local("place", (number(1.0) - x) * number(65_536.0)));
        let index = "i".to_owned();
        self.body.push(Statement::Find(index.clone(), places.clone(), place.clone()));
        let of = |table: String| Expression::Element(table, index.clone(), 0);
        Ok(clamp((of(values) + (place - of(places.0)) * of(slopes)) * number(FULL)))
    }

    fn local(&mut self, local: &str, value: Expression) -> String {
        self.body.push(Statement::Let(Type::Number, local.to_owned(), value));
        local.to_owned()
    }

    /// Adds a table; returns its name and its length.
    fn table(
        &mut self,
        table: &str,
        doc: &'static str,
        values: impl Iterator<Item = f32>,
    ) -> Result<(String, usize), ExportError> {
        let (name, values) = (self.names.of(table), values.collect::<Vec<_>>());
        let length = values.len();
        if length > LONGEST {
            let expected = format!("at most {LONGEST}: resample it with Table::from_angles");
            return Err(ExportError::new("length of a table", length, expected));
        }
        self.constants.push(Constant { doc, name: name.clone(), value: Value::Table(values) });
        Ok((name, length))
    }
}
