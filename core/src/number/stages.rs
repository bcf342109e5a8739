//! The errors of the stages of an evaluation, from which [`bound`](crate::bound) derives the error of
//! a light.

/// Returns `2^exponent`.
#[cfg(feature = "fixed")]
pub(super) const fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1_023 + exponent) as u64) << 52)
}

/// The relative error of a constant of a range: `f32` rounds its square, the reciprocal of that and the result.
#[cfg(feature = "fixed")]
pub(super) const RANGE: f64 = 1.2e-7;

/// The share and the light, in steps of 2^-14, over which `Fx16` keeps the light of its coarse
/// evaluation, which is clipped in any case.
pub(crate) const KEPT: [u32; 2] = [1 << 9, 9 << 11];

/// An upper bound of a rounding error: an absolute part, and a part relative to the result.
#[derive(Clone, Copy, Debug)]
pub struct Rounding {
    /// The absolute part.
    pub absolute: f64,
    /// The part relative to the result.
    pub relative: f64,
}

impl Rounding {
    /// No rounding.
    pub const NONE: Self = Self { absolute: 0.0, relative: 0.0 };

    /// An error of up to `step`, whatever the result.
    pub const fn absolute(step: f64) -> Self {
        Self { absolute: step, relative: 0.0 }
    }

    /// An error of up to `part` of the result.
    pub const fn relative(part: f64) -> Self {
        Self { absolute: 0.0, relative: part }
    }

    /// Returns the bound for a result of up to this size.
    pub fn of(self, size: f64) -> f64 {
        self.absolute + self.relative * size
    }
}

/// Upper bounds of the errors of each stage of an evaluation, in the order of the data.
///
/// A stage computes with the results of the stages before it, so a bound is that of the stage alone.
/// Lengths and gains have relative errors, because they have an exponent of their own.
#[derive(Clone, Copy, Debug)]
pub struct Stages {
    /// The relative error of the length of a direction, and of the axis.
    pub length: f64,
    /// The error of a direction across itself, and that of the axis, in radians.
    pub turn: f64,
    /// The rounding of the difference of direction and axis, as a length, without a zoom.
    pub difference: f64,
    /// The rounding of a versine. Its absolute part is that without a zoom.
    pub versine: Rounding,
    /// The rounding of the versines of a cone at set-up, without a zoom.
    pub set_up: f64,
    /// The rounding of `t`, for the versines of the ramp.
    pub ramp: Rounding,
    /// `1 - x` of a fraction or a share.
    pub complement: Rounding,
    /// The product of two fractions.
    pub product: Rounding,
    /// A fraction as a value, and the product of two fractions or of a fraction and a value.
    pub value: Rounding,
    /// `1 + u (g + h t)` in `t (1 + u (g + h t))`, without the error of its coefficients. The result is
    /// rounded to a value. The relative part is that of `t`.
    pub lift: Rounding,
    /// A coefficient, and the sum of two.
    pub weight: f64,
    /// `t^2 (3 - 2 t)`.
    pub smooth: Rounding,
    /// `(1 - k) t^2 + k w^2` with `w = max(0, 1 - g u)`, with the error of `k`.
    pub pair: Rounding,
    /// The place `1 - t` among samples, which their slope magnifies.
    pub place: Rounding,
    /// The interpolation of samples.
    pub sample: Rounding,
    /// The power of a real exponent, as the format rounds it.
    pub power: Rounding,
    /// The cosine of the angle of incidence.
    pub cosine: Rounding,
    /// The cosine of the angle of incidence of light that has the same direction everywhere.
    pub incidence: Rounding,
    /// The product of two shares.
    pub share: Rounding,
    /// A distance or a squared distance, relative to a range.
    pub near: Rounding,
    /// The relative error of a gain.
    pub gain: f64,
    /// The relative error of a gain, attenuated by the inverse square of the distance.
    pub inverse_square: f64,
    /// The error of a share by its product with a gain.
    pub given: f64,
    /// The relative error of a gain, attenuated by a polynomial.
    pub inverse_polynomial: f64,
    /// The relative error of a gain, attenuated by `d^-k`: a constant and a multiple of `k`.
    pub inverse_power: [f64; 2],
    /// The rounding of light.
    pub light: Rounding,
}

/// Upper bounds of the errors of the stages that a [`Distribution`](crate::light::Distribution) adds, derived beside their
/// numbers and searched by `tests/suite/measured.rs`.
#[derive(Clone, Copy, Debug)]
pub struct Placing {
    /// The error of the components of a direction in the frame of a light, as the length of a vector: by the
    /// vectors of the frame, if its side is orthogonal to its axis.
    pub frame: f64,
    /// The error of a place on the square, without those of the direction and the frame.
    pub square: f64,
    /// The interpolation in a cell.
    pub cell: f64,
}

impl Placing {
    /// Returns the error of a place on the square, for a direction with this error and a side at an angle of this sine to the
    /// axis.
    ///
    /// The gradient of `x = a / s` has the square `(1 - 2 x + 3 x^2) / s^2`, which is at most 2: an error of a direction
    /// changes a place by at most `sqrt(2)` times as much. So it is behind, where `1 - x` takes the place of y.
    pub(crate) fn error(&self, turn: f64, sine: f64) -> f64 {
        core::f64::consts::SQRT_2 * (turn + self.frame / sine) + self.square
    }
}
