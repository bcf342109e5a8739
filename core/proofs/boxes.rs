//! Bounds of functions over boxes, by intervals: a box whose bound is too large is halved.

extern crate std;

use core::ops::{Add, Div, Mul, Neg, Sub};
use std::vec::Vec;

/// A set of real numbers between two ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Interval {
    /// Returns an interval whose ends are results of one rounding each.
    fn rounded(low: f64, high: f64) -> Self {
        Self { low: low - f64::EPSILON * low.abs(), high: high + f64::EPSILON * high.abs() }
    }

    /// Returns the least interval around these results.
    fn around(numbers: [f64; 4]) -> Self {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = numbers.into_iter().fold(ends, |(low, high), n| (low.min(n), high.max(n)));
        Self::rounded(low, high)
    }

    pub(super) const fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    pub(super) const fn exactly(value: f64) -> Self {
        Self::new(value, value)
    }

    pub(super) fn squared(self) -> Self {
        let most = self.low.abs().max(self.high.abs());
        let least =
            if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { self.low.abs().min(self.high.abs()) };
        Self::rounded(least * least, most * most)
    }

    pub(super) fn root(self) -> Self {
        Self::rounded(self.low.max(0.0).sqrt(), self.high.sqrt())
    }

    pub(super) fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::rounded(self.low + other.low, self.high + other.high)
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let Self { low, high } = other;
        Self::around([self.low * low, self.low * high, self.high * low, self.high * high])
    }
}

impl Div for Interval {
    type Output = Self;

    /// The divisor is positive.
    fn div(self, other: Self) -> Self {
        let Self { low, high } = other;
        Self::around([self.low / low, self.low / high, self.high / low, self.high / high])
    }
}

/// Shows that a function is at most a bound over a box, or returns a part for which that is not shown.
pub(super) fn at_most<const N: usize>(
    bound: f64,
    whole: [Interval; N],
    function: impl Fn(&[Interval; N]) -> f64,
) -> Result<(), [Interval; N]> {
    /// Width of a box, relative to the whole, that is not halved.
    const NARROW: f64 = 1.0 / 65_536.0;
    /// Number of parts after which a bound is given up.
    const MANY: u32 = 250_000;
    let (mut boxes, mut count) = (Vec::from([whole]), 0);
    while let Some(part) = boxes.pop() {
        count += 1;
        if function(&part) <= bound {
            continue;
        }
        let width = |i: usize| (part[i].high - part[i].low) / (whole[i].high - whole[i].low).max(1e-300);
        let widest = (0..N).max_by(|&a, &b| width(a).total_cmp(&width(b))).unwrap_or(0);
        if width(widest) < NARROW || count > MANY {
            return Err(part);
        }
        let middle = f64::midpoint(part[widest].low, part[widest].high);
        let [mut lower, mut upper] = [part; 2];
        (lower[widest].high, upper[widest].low) = (middle, middle);
        boxes.extend([lower, upper]);
    }
    Ok(())
}
