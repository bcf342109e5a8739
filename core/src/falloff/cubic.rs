//! Cubic falloffs.

use core::fmt::{self, Formatter};

use super::{CompiledFalloff, Falloff, Formula, polynomial::Polynomial};
use crate::{
    error::{Error, Expected, Parameter},
    model::{Model as _, Number, model, plain},
    number::{Fraction, Scalar},
    search::bisect,
    source::{Source, call, name},
    trig,
};

/// The smoothstep `t^2 (3 - 2t)`: two multiplies. Its derivative is 0 at both ends. Used by
/// dual-cone shaders in GLSL, by three.js and by Blender.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Smooth;

model! {
    /// Any monotone cubic `t (a + t (b + t c))` with `a + b + c = 1`: three multiplies.
    ///
    /// Two derivatives with respect to `t` determine the cubic: the edge slope `a` at `t = 0`, and the
    /// middle slope `d = a + 2b + 3c` at `t = 1`. The cubic is monotone for slopes in the region of F.
    /// N. Fritsch and R. E. Carlson, *Monotone Piecewise Cubic Interpolation*, SIAM J. Numer. Anal. 17
    /// (1980). The cubic is evaluated as `t (1 + u (g + h t))` with `g = a - 1` and `g + h = 1 - d`, so
    /// that the value on the axis is exactly 1, however the slopes are rounded.
    ///
    /// Both slopes are multiples of 2^-20, so that the coefficients are exact.
    Cubic {
        /// Returns the edge slope: the derivative with respect to `t` at the edge.
        edge_slope: f32 = Number::between(Parameter::EdgeSlope, 0.0, 4.0, 1.25);
        /// Returns the middle slope: the derivative with respect to `t` at `t = 1`.
        ///
        /// `t = 1` is at the inner angle or, without a hotspot, on the axis.
        middle_slope: f32 = Number::between(Parameter::MiddleSlope, 0.0, 4.0, 3.5);
    } by Self::with_slopes(edge_slope, middle_slope)
}

/// Number of grid steps per unit of a slope. Coefficients are below 8, so coefficients and their
/// sums are exact in the 24 bits of f32.
const GRID: f32 = 1_048_576.0;

/// Rounds to the nearest multiple of 1 / [`GRID`].
fn on_grid(value: f32) -> f32 {
    let steps = value * GRID;
    (if steps < 0.0 { steps - 0.5 } else { steps + 0.5 }) as i32 as f32 / GRID
}

/// Returns the smallest and the largest middle slope of a monotone cubic with edge slope `a` in
/// [0, 4].
///
/// The smallest middle slope `d` is 0 for `a <= 3`. For `a > 3` the smallest `d` lies on the
/// ellipse `a^2 + a d + d^2 - 6 a - 6 d + 9 = 0`. The largest `d` lies on the same ellipse for
/// every `a`.
pub(super) fn middle_slopes(edge_slope: f32) -> (f32, f32) {
    let (a, root) = (edge_slope, trig::sqrt((3.0 * edge_slope * (4.0 - edge_slope)).max(0.0)));
    let least = if a <= 3.0 { 0.0 } else { (6.0 - a - root) / 2.0 };
    (least, (6.0 - a + root) / 2.0)
}

impl Cubic {
    /// Creates the cubic with these derivatives with respect to `t`, at the edge and at `t = 1`.
    /// Each slope is in [0, 4] and is rounded to a multiple of 2^-20.
    ///
    /// # Errors
    /// An edge slope outside [0, 4], or a middle slope with which the cubic is not monotone. The
    /// error names the range of middle slopes for this edge slope.
    pub fn with_slopes(edge_slope: f32, middle_slope: f32) -> Result<Self, Error> {
        let edge_slope = on_grid(Self::NUMBERS[0].checked(edge_slope)?);
        let (least, most) = middle_slopes(edge_slope);
        // The limits come from a square root. The limits are rounded to the grid, so that the
        // limits that an error names are accepted.
        let (least, most) = (on_grid(least), on_grid(most));
        let middle = Number { limits: [least, most], ..Self::NUMBERS[1] };
        Ok(Self { edge_slope, middle_slope: on_grid(middle.checked(middle_slope)?) })
    }

    /// Creates the cubic `t (a + t (b + t c))`. The coefficients are rounded to multiples of 2^-20
    /// with `a + b + c = 1` exactly.
    ///
    /// # Errors
    /// A sum `a + b + c` that is not within 2^-20 of 1. Otherwise the errors of
    /// [`Cubic::with_slopes`].
    pub fn new(a: f32, b: f32, c: f32) -> Result<Self, Error> {
        let sum = a + b + c;
        let near = (1.0 - 1.0 / GRID)..=(1.0 + 1.0 / GRID);
        if !near.contains(&sum) {
            let accepted = Expected::Exactly(1.0);
            return Err(Error { parameter: Parameter::CoefficientSum, value: sum, accepted });
        }
        // d = a + 2b + 3c with c = 1 - a - b.
        Self::with_slopes(on_grid(a), on_grid(3.0 - 2.0 * on_grid(a) - on_grid(b)))
    }

    /// Returns the coefficients `[a, b, c]`: multiples of 2^-20 whose sum is exactly 1.
    pub fn coefficients(self) -> [f32; 3] {
        let (a, d) = (self.edge_slope, self.middle_slope);
        [a, 3.0 - 2.0 * a - d, a + d - 2.0]
    }

    /// Creates the cubic without rounding the slopes to the grid: for searches, which round their result,
    /// and for slopes on the grid.
    pub(crate) fn exactly(edge_slope: f32, middle_slope: f32) -> Self {
        Self { edge_slope, middle_slope }
    }

    /// Returns the versine at the field angle divided by the versine at the beam angle.
    pub(super) fn ratio(self) -> f32 {
        self.field_versine() / self.beam_versine()
    }

    /// Creates the cubic with both slopes rounded to the grid.
    pub(super) fn nearest(edge_slope: f32, middle_slope: f32) -> Self {
        Self { edge_slope: on_grid(edge_slope), middle_slope: on_grid(middle_slope) }
    }

    /// Smoothstep as a cubic.
    pub(crate) const SMOOTH: Self = Self { edge_slope: 0.0, middle_slope: 0.0 };

    fn polynomial(self) -> Polynomial {
        let [a, b, c] = self.coefficients();
        Polynomial { a, b, c }
    }

    /// Returns the `u` with this intensity, by bisection: faster methods fail where the derivative
    /// is zero.
    fn versine_of(self, intensity: f32) -> f32 {
        let (g, h) = (self.edge_slope - 1.0, 2.0 - self.edge_slope - self.middle_slope);
        bisect(0.0, 1.0, |u| {
            let t = 1.0 - u;
            t * (1.0 + u * (g + h * t)) > intensity
        })
    }
}

impl Falloff for Smooth {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Polynomial([0.0, 3.0, -2.0])
    }

    /// Returns `1/2`.
    fn beam_versine(self) -> f32 {
        0.5
    }

    /// Returns `1 - t` for the `t` with `t^2 (3 - 2t) = 1/10`.
    fn field_versine(self) -> f32 {
        0.804_199_9
    }

    fn steepness(self, hotspot: f32) -> f32 {
        Polynomial { a: 0.0, b: 3.0, c: -2.0 }.steepness(hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u * (1.0 - u * u * (1.0 - u / 2.0))
    }
}

impl<S: Scalar> CompiledFalloff<S> for Smooth {
    const IN_VECTORS: bool = true;

    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.smooth()
    }
}

/// A [`Cubic`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledCubic<S: Scalar> {
    pub(crate) g: S::Weight,
    pub(crate) h: S::Weight,
}

impl<S: Scalar> CompiledCubic<S> {
    /// Creates the cubic `t (1 + u (g + h t))`, as [`codegen`](crate::codegen) writes it.
    pub const fn from_parts(g: S::Weight, h: S::Weight) -> Self {
        Self { g, h }
    }

    /// Returns the weights `g` and `h`.
    pub const fn weights(&self) -> (S::Weight, S::Weight) {
        (self.g, self.h)
    }
}

plain!(Smooth);

impl<S: Scalar> Source for CompiledCubic<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledCubic::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.g, &self.h])
    }
}

impl<S: Scalar> From<Cubic> for CompiledCubic<S> {
    fn from(cubic: Cubic) -> Self {
        let (a, d) = (cubic.edge_slope, cubic.middle_slope);
        Self { g: S::weight(a - 1.0), h: S::weight(2.0 - a - d) }
    }
}

impl Falloff for Cubic {
    type Compiled<S: Scalar> = CompiledCubic<S>;

    fn formula(&self) -> Formula<'_> {
        Formula::Polynomial(self.coefficients())
    }

    fn beam_versine(self) -> f32 {
        self.versine_of(0.5)
    }

    fn field_versine(self) -> f32 {
        self.versine_of(0.1)
    }

    fn steepness(self, hotspot: f32) -> f32 {
        self.polynomial().steepness(hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        self.polynomial().integral(u)
    }
}

impl<S: Scalar> CompiledFalloff<S> for CompiledCubic<S> {
    const IN_VECTORS: bool = true;

    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.cubic(self.g, self.h)
    }

    #[inline]
    fn as_cubic(self) -> Option<[S::Weight; 2]> {
        Some([self.g, self.h])
    }
}
