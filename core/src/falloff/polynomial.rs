//! Properties shared by the polynomial falloffs.

use crate::trig;

/// The falloff `t (a + t (b + t c))`, the common form from which integral and steepness are
/// computed.
#[derive(Clone, Copy)]
pub(super) struct Polynomial {
    pub(super) a: f32,
    pub(super) b: f32,
    pub(super) c: f32,
}

impl Polynomial {
    /// Returns the integral of the intensity from 0 to `u`.
    ///
    /// The integral is expanded in powers of `u`, because powers of `t` would cancel for small `u`.
    pub(super) fn integral(self, u: f32) -> f32 {
        let slope = self.a + 2.0 * self.b + 3.0 * self.c;
        u * (1.0 - u * (slope / 2.0 - u * ((self.b + 3.0 * self.c) / 3.0 - u * self.c / 4.0)))
    }

    /// Returns the maximum of `2 f'(t) sqrt(v) / (1 - h)` over the versines `v` from the hotspot
    /// `h` to 1.
    ///
    /// Here `t = (1 - v) / (1 - h)`. The maximum is at an end of the range, or where the derivative
    /// with respect to `v` is zero. The zeros of this derivative are the roots of a quadratic in
    /// `v`.
    pub(super) fn steepness(self, hotspot: f32) -> f32 {
        let span = 1.0 - hotspot;
        let slope = |v: f32| {
            let t = (1.0 - v) / span;
            2.0 * (self.a + t * (2.0 * self.b + t * (3.0 * self.c))) * trig::sqrt(v) / span
        };
        // With `f'` as a quadratic `p + q v + r v^2`, the derivative is zero where
        // `2 v (f')' + f' = p + 3 q v + 5 r v^2` is zero.
        let (linear, square) = (2.0 * self.b / span, 3.0 * self.c / (span * span));
        let (p, q, r) = (self.a + linear + square, -linear - 2.0 * square, square);
        let mut largest = max(slope(hotspot), slope(1.0));
        for v in roots(5.0 * r, 3.0 * q, p) {
            if v > hotspot && v < 1.0 {
                largest = max(largest, slope(v));
            }
        }
        largest
    }
}

/// Returns the real roots of `a x^2 + b x + c`, without cancellation; NaN or infinity for a root
/// that does not exist.
fn roots(a: f32, b: f32, c: f32) -> [f32; 2] {
    let root = trig::sqrt(b * b - 4.0 * a * c);
    let q = if b < 0.0 { b - root } else { b + root } / -2.0;
    [q / a, c / q]
}

fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
