//! The alternatives of a user: falloffs of the field in f32, and lit points as one computes them without
//! the crate `luminaire`.
//!
//! Each lit point is a text of its own of the published law, or calls a crate. It gets the same points and
//! normals as the kernels, in the words of `Fx16` or in f32, and its light is a constant, too.

mod baked;
mod falloff;
mod float;
mod q15;
mod q16;

pub use falloff::*;

use luminaire::Vec3;

use crate::{
    Setting,
    kernel::{Kernel, Row, Visitor},
    list::other_light,
    scene::{AXIS, POSITION, Population, Site},
    truth::Point,
};

/// A lit point of others, as a type for each.
pub trait Rival: Kernel<Place = Site> + 'static {
    /// The name on the price list.
    const NAME: &'static str;
    /// What it computes by.
    const WHAT: &'static str;
    /// Who would choose it, and why.
    const WHO: &'static str;
    /// Bytes of its tables.
    const TABLES: usize;
    /// Its distance law.
    const LAW: Law;
    /// The surface points that it lights.
    const POPULATION: Population;
    /// The light of the standard setting, whose costs are counted.
    const STANDARD: &'static Self;

    /// The light whose cone ends at this versine.
    fn ending_at(outer: f32) -> Self;
}

/// The fall of light with distance.
#[derive(Clone, Copy, Debug)]
pub enum Law {
    /// The inverse square.
    InverseSquare,
    /// `(1 - (d/r)^2)^n` up to the [range](RANGE), with this power.
    Window(f64),
}

/// The range of windows, in units of length.
pub const RANGE: f32 = 10.0;

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
const STANDARD_OUTER: f32 = 0.071_578_59;

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
            $(visitor.rival::<$type>(Row::lit($name, "rival"), &other_light::<$type>(setting));)*
        }
    };
}

rivals! {
    "lit-q15-difference" q15::Difference, q15::TABLES, Law::InverseSquare, Lit,
        "16-bit products by hand: offset cut to 15 bits, root from a table, difference of unit vectors",
        "an expert of fixed point, for one light: the fewest instructions at one code";
    "lit-q15-product" q15::Product, q15::TABLES, Law::InverseSquare, Lit,
        "the same with the cosine by an inner product",
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
        "whose light and floor never move: the cheapest by far";
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

/// The light's position in steps of 2^-16.
const AT: [i32; 3] = steps(POSITION, 65_536.0);

/// The axis in steps of a format.
const fn axis(one: f32) -> [i32; 3] {
    steps(AXIS, one)
}

/// The steps nearest to a vector.
const fn steps(v: Vec3<f32>, one: f32) -> [i32; 3] {
    [nearest((v.x * one) as f64), nearest((v.y * one) as f64), nearest((v.z * one) as f64)]
}

/// The nearest integer.
const fn nearest(x: f64) -> i32 {
    (if x < 0.0 { x - 0.5 } else { x + 0.5 }) as i32
}

/// The square root by Newton's method, for constants.
const fn root(x: f64) -> f64 {
    let mut root = if x < 1.0 { 1.0 } else { x };
    loop {
        let next = 0.5 * (root + x / root);
        if next >= root {
            return root;
        }
        root = next;
    }
}

/// Implements [`Kernel`] for a light with a method `at(point, normal)`, which takes the words of a format.
macro_rules! lit {
    ($type:ty: $format:ty => $output:ty) => {
        impl crate::kernel::Kernel for $type {
            type Place = crate::scene::Site;
            type Input = crate::ours::Stored<$format>;
            type Output = $output;

            fn input(&self, site: &crate::scene::Site) -> Self::Input {
                Self::Input::new(site)
            }

            #[inline(always)]
            fn evaluate(&self, site: &Self::Input) -> $output {
                let (point, normal) = site.words();
                self.at(point, normal)
            }

            #[inline(always)]
            fn touch(site: &Self::Input) -> u32 {
                site.touch()
            }
        }
    };
}
use lit;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn standard_constants_are_those_of_the_standard_setting() {
        assert_eq!(STANDARD_OUTER.to_bits(), Setting::standard().outer_versine().to_bits());
    }
}
