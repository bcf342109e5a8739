//! The integral of a polynomial falloff over an arc, in closed form.
//!
//! On the arc, with `y = sin^2(psi/2)`, the argument of a falloff is `t = t0 - slope y`. So a falloff
//! that is a polynomial of `t` is one of `y`, and `d(psi) = 2 dx / sqrt(1 - x^2)` with
//! `x = sin(psi/2)`. Let
//!
//! ```text
//! G_k(y) = ∫ u^2k / sqrt(1 - y u^2) du over u from 0 to 1
//! ```
//!
//! Then the integral from 0 to `psi` of the sum of `c_k y^k` is `2 x` times the sum of
//! `c_k y^k G_k(y)`. The derivative of `u^(2k-1) sqrt(1 - y u^2)` gives the recurrence
//!
//! ```text
//! (2k - 1) G_(k-1) = sqrt(1 - y) + 2k y G_k
//! ```
//!
//! All its terms are positive, so no bits cancel, and three steps multiply an error of `G_3` by at
//! most `3.2 y^3`. `G_3` is a fitted polynomial; in a cone of up to 180 degrees `y` is at most 1/2.

use super::quadrature::{by_angle, integrate_short};
use crate::trig;

/// Coefficients of `G_3`, which is exact at 0 and errs by at most 1.1e-6 up to 1/2.
const G3: [f32; 6] = [1.0 / 7.0, 0.055_577_137, 0.033_305_254, 0.031_912_725, -0.012_549_401, 0.060_773_395];

/// Shortest part of an arc, relative to half the arc within the cone, whose integral is a difference
/// of the primitive. In a shorter part the difference would cancel.
const SHORT: f32 = 1.0 / 8.0;

/// The falloff `t (a + t (b + t c))` with `[a, b, c]` on an arc: `t` in the direction nearest to the
/// axis, and how much it falls per `y`.
pub(super) struct OnArc {
    pub(super) curve: [f32; 3],
    pub(super) top: f32,
    pub(super) slope: f32,
}

impl OnArc {
    /// Returns the integral of the intensity over the directions between two limits of `v =
    /// tan(psi/2)`; zero unless `from < to`. The cone leaves the arc at `edge`.
    #[inline(always)]
    pub(super) fn integral(&self, from: f32, to: f32, edge: f32) -> f32 {
        if to - from < SHORT * edge {
            let Self { curve: [a, b, c], top, slope } = *self;
            return integrate_short(from, to, |v| {
                by_angle(v, |share| {
                    let t = top - slope * (v * v * share);
                    t * (a + t * (b + t * c))
                })
            });
        }
        self.primitive(to) - self.primitive(from)
    }

    /// Returns the integral from the direction nearest to the axis to the direction `v`.
    #[inline(always)]
    fn primitive(&self, v: f32) -> f32 {
        let Self { curve: [a, b, c], top, slope } = *self;
        // The coefficients of the powers of `slope y`, with alternating signs.
        let (c3, b3) = (c, b + 3.0 * top * c);
        let (c2, c1, c0) = (b3, a + top * (b + b3), top * (a + top * (b + top * c)));
        let cosine = trig::inverse_sqrt(1.0 + v * v);
        let x = v * cosine;
        let y = x * x;
        let g3 = G3[0] + y * (G3[1] + y * (G3[2] + y * (G3[3] + y * (G3[4] + y * G3[5]))));
        let g2 = 0.2 * cosine + 1.2 * (y * g3);
        let g1 = (1.0 / 3.0) * cosine + (4.0 / 3.0) * (y * g2);
        let g0 = cosine + 2.0 * (y * g1);
        let fall = slope * y;
        2.0 * x * (c0 * g0 - fall * (c1 * g1 - fall * (c2 * g2 - fall * (c3 * g3))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `G_3` is the sum of `binom(2 n, n) (y/4)^n / (2 n + 7)`.
    #[test]
    fn g3_errs_by_at_most_its_bound() {
        let exact = |y: f64| {
            let term = |(term, sum): (f64, f64), n: i32| {
                let n = f64::from(n);
                (term * y * (n + 0.5) / (n + 1.0), sum + term / (2.0 * n + 7.0))
            };
            (0..60).fold((1.0, 0.0), term).1
        };
        let fitted = |y: f64| G3.iter().rev().fold(0.0, |sum, &g| f64::from(g) + y * sum);
        let error = (0..=1_000).map(|i| f64::from(i) / 2_000.0).map(|y| (fitted(y) - exact(y)).abs());
        let most = error.fold(0.0, f64::max);
        assert!((0.9e-6..1.1e-6).contains(&most), "{most}");
    }
}
