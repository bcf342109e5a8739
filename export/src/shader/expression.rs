//! Expressions and functions in `f32`, for all languages that have it.

use std::ops::{Add, Mul, Sub};

/// An expression: a number, unless it says otherwise.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Expression {
    /// A literal.
    Number(f32),
    /// A constant, a parameter or a local.
    Name(String),
    /// A constant, a parameter or a local that is a vector.
    Vector(String),
    /// A sum, difference, product or quotient; of a vector if an operand is one.
    Infix(char, Box<[Expression; 2]>),
    /// `a < b ? c : d`, of `[a, b, c, d]`.
    IfLess(Box<[Expression; 4]>),
    /// A function of the language.
    Call(Builtin, Vec<Expression>),
    /// A function of the light. A vector among the arguments must be a name.
    Own(String, Vec<Expression>),
    /// An element of a table: the name of the table, the name of the index and a number to add to it.
    Element(String, String, u32),
    /// An index as a number.
    Converted(String),
}

/// A function that every language has, under some name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Builtin {
    /// The nearest number in [0, 1].
    Clamp,
    /// The smaller of two numbers.
    Min,
    /// The larger of two numbers.
    Max,
    /// The square root.
    Sqrt,
    /// `x^y` for `x >= 0`.
    Power,
    /// The dot product of two vectors, which must be names.
    Dot,
}

/// A type of a parameter or a local.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Type {
    /// A number.
    Number,
    /// A vector of three numbers.
    Vector,
}

/// A statement of a function.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Statement {
    /// A local.
    Let(Type, String, Expression),
    /// A local index: a number of at least 0, rounded down.
    Index(String, Expression),
    /// A local index: that of the last entry of a rising table that is at most a number, or 0. The
    /// table is given by its name and its length.
    Find(String, (String, usize), Expression),
}

/// A function of the light.
#[derive(Clone, Debug)]
pub(crate) struct Function {
    /// A sentence that describes the function.
    pub(crate) doc: String,
    /// The name.
    pub(crate) name: String,
    /// The types and names of the parameters.
    pub(crate) parameters: Vec<(Type, &'static str)>,
    /// The statements.
    pub(crate) body: Vec<Statement>,
    /// The returned number.
    pub(crate) result: Expression,
}

/// A constant of the light.
#[derive(Clone, Debug)]
pub(crate) struct Constant {
    /// A phrase that describes the constant.
    pub(crate) doc: &'static str,
    /// The name.
    pub(crate) name: String,
    /// The value.
    pub(crate) value: Value,
}

/// The value of a constant.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    /// A number.
    Number(f32),
    /// A vector.
    Vector([f32; 3]),
    /// A table.
    Table(Vec<f32>),
}

/// The constants and functions of a light.
#[derive(Clone, Debug, Default)]
pub(crate) struct Program {
    /// The constants.
    pub(crate) constants: Vec<Constant>,
    /// The functions, in the order of their use.
    pub(crate) functions: Vec<Function>,
}

/// Returns the number of this name.
pub(crate) fn name(name: impl Into<String>) -> Expression {
    Expression::Name(name.into())
}

/// Returns the vector of this name.
pub(crate) fn vector(name: impl Into<String>) -> Expression {
    Expression::Vector(name.into())
}

/// Returns a literal.
pub(crate) fn number(value: f32) -> Expression {
    Expression::Number(value)
}

/// Returns `a < b ? then : otherwise`.
pub(crate) fn if_less(a: Expression, b: Expression, then: Expression, otherwise: Expression) -> Expression {
    Expression::IfLess(Box::new([a, b, then, otherwise]))
}

/// Returns the nearest number in [0, 1].
pub(crate) fn clamp(x: Expression) -> Expression {
    Expression::Call(Builtin::Clamp, vec![x])
}

/// Returns a call of a function of two arguments.
pub(crate) fn call(function: Builtin, a: Expression, b: Expression) -> Expression {
    Expression::Call(function, vec![a, b])
}

macro_rules! infix {
    ($($trait:ident $method:ident $sign:literal;)*) => {$(
        impl $trait for Expression {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self::Infix($sign, Box::new([self, other]))
            }
        }
    )*};
}

infix! {
    Add add '+';
    Sub sub '-';
    Mul mul '*';
}

/// Returns `a / b`.
pub(crate) fn quotient(a: Expression, b: Expression) -> Expression {
    Expression::Infix('/', Box::new([a, b]))
}
