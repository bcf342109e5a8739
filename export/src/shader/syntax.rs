//! The syntax of the languages with `f32`.

use std::fmt::Write;

use super::expression::{Builtin, Constant, Expression, Function, Program, Statement, Type, Value};
use super::names::Names;

/// A language with `f32`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Syntax {
    /// GLSL ES 3.00.
    Glsl,
    /// WGSL.
    Wgsl,
    /// C99 and C++11.
    C,
}

impl Syntax {
    /// Writes the constants and functions of a light.
    pub(super) fn program(self, names: Names<'_>, program: &Program) -> String {
        let mut out = String::new();
        for constant in &program.constants {
            self.constant(&mut out, constant);
        }
        let functions: Vec<_> =
            program.functions.iter().map(|function| self.function(names, function)).collect();
        if self == Self::C {
            helpers(&mut out, names, &functions);
        }
        for function in functions {
            out.push('\n');
            out += &function;
        }
        out
    }

    fn constant(self, out: &mut String, Constant { doc, name, value }: &Constant) {
        let list = |values: &[f32]| {
            let values: Vec<_> = values.iter().map(|&value| self.literal(value)).collect();
            // Long tables break every eight numbers.
            values.chunks(8).map(|row| row.join(", ")).collect::<Vec<_>>().join(",\n    ")
        };
        let comment = if self == Self::C { format!("/* {doc} */") } else { format!("// {doc}") };
        let _ = match (self, value) {
            (Self::Glsl, Value::Number(x)) => {
                writeln!(out, "const highp float {name} = {}; {comment}", self.literal(*x))
            }
            (Self::Glsl, Value::Vector(v)) => {
                writeln!(out, "const highp vec3 {name} = vec3({}); {comment}", list(v))
            }
            (Self::Glsl, Value::Table(table)) => {
                let n = table.len();
                writeln!(out, "const highp float {name}[{n}] = float[{n}]( {comment}\n    {});", list(table))
            }
            (Self::Wgsl, Value::Number(x)) => {
                writeln!(out, "const {name}: f32 = {}; {comment}", self.literal(*x))
            }
            (Self::Wgsl, Value::Vector(v)) => {
                writeln!(out, "const {name} = vec3<f32>({}); {comment}", list(v))
            }
            // A variable, because not every compiler indexes a constant by a variable.
            (Self::Wgsl, Value::Table(table)) => {
                let n = table.len();
                writeln!(
                    out,
                    "var<private> {name}: array<f32, {n}> = array<f32, {n}>( {comment}\n    {});",
                    list(table)
                )
            }
            (Self::C, Value::Number(x)) => {
                writeln!(out, "static const float {name} = {}; {comment}", self.literal(*x))
            }
            (Self::C, Value::Vector(v)) => {
                writeln!(out, "static const float {name}[3] = {{ {} }}; {comment}", list(v))
            }
            (Self::C, Value::Table(table)) => {
                let n = table.len();
                writeln!(out, "static const float {name}[{n}] = {{ {comment}\n    {} }};", list(table))
            }
        };
    }

    fn function(self, names: Names<'_>, function: &Function) -> String {
        let Function { doc, name, parameters, body, result } = function;
        let writer = Writer { syntax: self, names };
        let parameters = parameters.iter().map(|&(kind, name)| match (self, kind) {
            (Self::Glsl, Type::Number) => format!("highp float {name}"),
            (Self::Glsl, Type::Vector) => format!("highp vec3 {name}"),
            (Self::Wgsl, Type::Number) => format!("{name}: f32"),
            (Self::Wgsl, Type::Vector) => format!("{name}: vec3<f32>"),
            (Self::C, Type::Number) => format!("float {name}"),
            (Self::C, Type::Vector) => format!("const float {name}[3]"),
        });
        let parameters = parameters.collect::<Vec<_>>().join(", ");
        let (comment, head) = match self {
            Self::Glsl => (format!("// {doc}"), format!("highp float {name}({parameters})")),
            Self::Wgsl => (format!("// {doc}"), format!("fn {name}({parameters}) -> f32")),
            Self::C => (format!("/* {doc} */"), format!("static inline float {name}({parameters})")),
        };
        let body: String = body.iter().map(|statement| writer.statement(statement)).collect();
        format!("{comment}\n{head} {{\n{body}    return {};\n}}\n", writer.outer(result))
    }

    /// Returns the shortest literal that every compiler reads as this number.
    pub(super) fn literal(self, value: f32) -> String {
        let short = format!("{value:?}");
        // WGSL reads a literal as f64 and then rounds it to f32.
        let twice = short.parse::<f64>().is_ok_and(|double| double as f32 == value);
        let text = if twice { short } else { format!("{value:.16e}") };
        if self == Self::C { format!("{text}f") } else { text }
    }
}

/// Writes the functions that C has not, as far as they are called.
fn helpers(out: &mut String, names: Names<'_>, functions: &[String]) {
    let helpers = [
        ("min", "the smaller of two numbers", "float a, float b", "a < b ? a : b"),
        ("max", "the larger of two numbers", "float a, float b", "a > b ? a : b"),
        (
            "clamp",
            "the nearest number in [0, 1], and 0 for NaN",
            "float x",
            "x > 0.0f ? x < 1.0f ? x : 1.0f : 0.0f",
        ),
    ];
    for (helper, doc, parameters, result) in helpers {
        let name = names.of(helper);
        if functions.iter().any(|function| function.contains(&format!("{name}("))) {
            let _ = write!(
                out,
                "\n/* Returns {doc}. */\nstatic inline float {name}({parameters}) {{\n    return {result};\n}}\n"
            );
        }
    }
}

/// Writes statements and expressions.
#[derive(Clone, Copy)]
struct Writer<'a> {
    syntax: Syntax,
    names: Names<'a>,
}

impl Writer<'_> {
    fn statement(self, statement: &Statement) -> String {
        let syntax = self.syntax;
        match statement {
            Statement::Let(Type::Number, name, value) => {
                let value = self.outer(value);
                match syntax {
                    Syntax::Glsl => format!("    highp float {name} = {value};\n"),
                    Syntax::Wgsl => format!("    let {name} = {value};\n"),
                    Syntax::C => format!("    const float {name} = {value};\n"),
                }
            }
            Statement::Let(Type::Vector, name, value) => match syntax {
                Syntax::Glsl => format!("    highp vec3 {name} = {};\n", self.outer(value)),
                Syntax::Wgsl => format!("    let {name} = {};\n", self.outer(value)),
                Syntax::C => {
                    let [x, y, z] = [0, 1, 2].map(|axis| self.component(value, axis));
                    format!("    const float {name}[3] = {{ {x}, {y}, {z} }};\n")
                }
            },
            Statement::Index(name, value) => {
                let value = self.outer(value);
                match syntax {
                    Syntax::Glsl => format!("    highp int {name} = int({value});\n"),
                    Syntax::Wgsl => format!("    let {name} = u32({value});\n"),
                    Syntax::C => format!("    const int {name} = (int)({value});\n"),
                }
            }
            Statement::Find(name, (table, length), value) => {
                let value = self.outer(value);
                let (index, next) = match syntax {
                    Syntax::Glsl => (format!("highp int {name} = 0"), "highp int k = 1; k < "),
                    Syntax::C => (format!("int {name} = 0"), "int k = 1; k < "),
                    Syntax::Wgsl => (format!("var {name} = 0u"), "var k = 1u; k < "),
                };
                let unit = if syntax == Syntax::Wgsl { "u" } else { "" };
                format!(
                    "    {index};\n    for ({next}{length}{unit}; k++) {{\n        \
                     if ({table}[k] <= {value}) {{ {name} = k; }}\n    }}\n"
                )
            }
        }
    }

    /// Writes an expression without parentheses around it.
    fn outer(self, expression: &Expression) -> String {
        self.write(expression, 0)
    }

    /// Writes an expression as an operand. Operators of a lower rank than `rank` get parentheses.
    fn write(self, expression: &Expression, rank: u8) -> String {
        let (text, own) = match expression {
            Expression::Number(value) => (self.syntax.literal(*value), if *value < 0.0 { 1 } else { 9 }),
            Expression::Name(name) | Expression::Vector(name) => (name.clone(), 9),
            Expression::Infix(sign, operands) => {
                let own = if matches!(sign, '+' | '-') { 1 } else { 2 };
                let [a, b] = [self.write(&operands[0], own), self.write(&operands[1], own + 1)];
                (format!("{a} {sign} {b}"), own)
            }
            Expression::IfLess(operands) => {
                let [a, b, then, otherwise] = operands.each_ref().map(|operand| self.write(operand, 1));
                match self.syntax {
                    Syntax::Wgsl => (format!("select({otherwise}, {then}, {a} < {b})"), 9),
                    Syntax::Glsl | Syntax::C => (format!("{a} < {b} ? {then} : {otherwise}"), 0),
                }
            }
            Expression::Call(Builtin::Dot, arguments) if self.syntax == Syntax::C => {
                let products = [0, 1, 2].map(|axis| {
                    let [a, b] = [&arguments[0], &arguments[1]].map(|vector| self.component(vector, axis));
                    format!("{a} * {b}")
                });
                (products.join(" + "), 1)
            }
            Expression::Call(builtin, arguments) => (self.call(*builtin, arguments), 9),
            Expression::Own(name, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|argument| self.outer(argument)).collect();
                (format!("{name}({})", arguments.join(", ")), 9)
            }
            Expression::Element(table, index, 0) => (format!("{table}[{index}]"), 9),
            Expression::Element(table, index, next) => {
                let unit = if self.syntax == Syntax::Wgsl { "u" } else { "" };
                (format!("{table}[{index} + {next}{unit}]"), 9)
            }
            Expression::Converted(index) => match self.syntax {
                Syntax::Glsl => (format!("float({index})"), 9),
                Syntax::Wgsl => (format!("f32({index})"), 9),
                Syntax::C => (format!("(float){index}"), 3),
            },
        };
        if own < rank { format!("({text})") } else { text }
    }

    fn call(self, builtin: Builtin, arguments: &[Expression]) -> String {
        let written: Vec<_> = arguments.iter().map(|argument| self.outer(argument)).collect();
        let written = written.join(", ");
        let is_c = self.syntax == Syntax::C;
        match builtin {
            Builtin::Clamp if is_c => format!("{}({written})", self.names.of("clamp")),
            Builtin::Min if is_c => format!("{}({written})", self.names.of("min")),
            Builtin::Max if is_c => format!("{}({written})", self.names.of("max")),
            Builtin::Sqrt if is_c => format!("sqrtf({written})"),
            Builtin::Power if is_c => format!("powf({written})"),
            Builtin::Clamp => format!("clamp({written}, 0.0, 1.0)"),
            Builtin::Min => format!("min({written})"),
            Builtin::Max => format!("max({written})"),
            Builtin::Sqrt => format!("sqrt({written})"),
            Builtin::Power => format!("pow({written})"),
            Builtin::Dot => format!("dot({written})"),
        }
    }

    /// Writes a component of a vector; a number stands for each of its components.
    fn component(self, expression: &Expression, axis: usize) -> String {
        match expression {
            Expression::Vector(name) => format!("{name}[{axis}]"),
            Expression::Infix(sign, operands) => {
                let [a, b] = operands.each_ref().map(|operand| self.component(operand, axis));
                format!("{a} {sign} {b}")
            }
            number => self.write(number, 3),
        }
    }
}
