//! The list of lit points of others: every row, once.

use luminaire::falloff::Soft;
use luminaire_oracle as oracle;

use crate::{
    kernel::{Row, Visitor},
    list::{Setting, light_of},
    rival::{Law, RANGE, Rival, baked, float, q15, q16},
    scene::{INTENSITY, Population},
    truth::Point,
};

/// A visitor of the rivals.
pub trait RivalVisitor {
    /// Visits a rival with its exact model.
    fn rival<R: Rival>(&mut self, row: Row, truth: &Point);
}

impl<V: Visitor> RivalVisitor for V {
    fn rival<R: Rival>(&mut self, row: Row, truth: &Point) {
        self.point(row, R::ending_at(truth.light.cone.outer as f32), truth);
    }
}

/// The outer versine of the standard setting, for constants.
const STANDARD_OUTER: f32 = 0.071_578_65;

/// Declares the list: a name, a type, the bytes of its tables, its law, its points, and two phrases.
macro_rules! rivals {
    ($($name:literal $type:ty, $tables:expr, $law:expr, $population:ident, $what:literal, $who:literal;)*) => {
        $(impl Rival for $type {
            const NAME: &'static str = $name;
            const WHAT: &'static str = $what;
            const WHO: &'static str = $who;
            const TABLES: usize = $tables;
            const LAW: Law = $law;
            const POPULATION: Population = Population::$population;
            const STANDARD: &'static Self = &Self::new(STANDARD_OUTER);

            fn ending_at(outer: f32) -> Self {
                Self::new(outer)
            }
        })*

        /// Every lit point of others.
        pub fn rivals(setting: Setting, visitor: &mut impl RivalVisitor) {
            $(visitor.rival::<$type>(Row::lit($name, "rival"), &light::<$type>(setting));)*
        }
    };
}

rivals! {
    "lit-q15-difference" q15::Difference, q15::TABLES, Law::InverseSquare, Lit,
        "16-bit products by hand: offset cut to 15 bits, root from a table, difference of unit vectors",
        "an expert of fixed point with days for one light: few instructions";
    "lit-q15-product" q15::Product, q15::TABLES, Law::InverseSquare, Lit,
        "16-bit products by hand, the cosine by an inner product",
        "the same expert, for wide cones alone";
    "lit-q16-digits" q16::Digits, 0, Law::InverseSquare, Lit,
        "Q16.16, products of 64 bits, root by binary digits",
        "most people: nothing to tune";
    "lit-q16-libfixmath" q16::Fixmath, 0, Law::InverseSquare, Lit,
        "Q16.16, root and division by the methods of libfixmath",
        "who has libfixmath in the project";
    "lit-q16-cordic" q16::Cordic, 0, Law::InverseSquare, Lit,
        "Q16.16 by the crate `fixed`, root by the crate `cordic`",
        "who wants Rust types and no arithmetic of his own";
    "lit-baked" baked::Pool, size_of::<baked::Pool>(), Law::InverseSquare, Floor,
        "a pool of light baked on a floor, 64 x 64 texels, interpolated",
        "whose light and floor never move: next to no instructions";
    "lit-f32-plain" float::Plain, 0, Law::InverseSquare, Lit,
        "f32 as a shader has it: normalize, clamp, divide by the square",
        "who has a floating point unit and no wish to tune";
    "lit-f32-difference" float::Difference, 0, Law::InverseSquare, Lit,
        "f32, difference of unit vectors, two early-outs",
        "who has a floating point unit and counts instructions";
    "lit-f32-micromath" float::Micromath, 0, Law::InverseSquare, Lit,
        "f32, reciprocal root of the crate `micromath` and two steps of Newton's method",
        "who has no floating point unit and must have floats";
    "lit-f32-tgx" float::Tgx, 0, Law::Window(2.0), Lit,
        "f32, the spotlight of TGX, with its window in place of the inverse square",
        "who draws by TGX";
    "lit-f32-3dgfx" float::Embedded3dgfx, 0, Law::Window(1.0), Lit,
        "f32, the spotlight of embedded-3dgfx with its window, cut to RGB565; Lambert's cosine added",
        "who draws by embedded-3dgfx";
}

/// The exact light of a rival.
fn light<R: Rival>(setting: Setting) -> Point {
    let point = light_of::<Soft>(setting, R::POPULATION, INTENSITY, true);
    match R::LAW {
        Law::InverseSquare => point,
        Law::Window(power) => {
            let attenuation = oracle::Attenuation::SquareWindow([RANGE.into(), power]);
            Point { light: oracle::SpotLight { intensity: 1.0, attenuation, ..point.light }, ..point }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn standard_constants_are_those_of_the_standard_setting() {
        assert_eq!(STANDARD_OUTER.to_bits(), Setting::standard().outer_versine().to_bits());
    }
}
