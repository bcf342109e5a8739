//! A beam without gobo and shadow map as seen from the eye: its in-scattering by a formula.
//!
//! The falloff is a polynomial of `t` of degree 3 or less. Along a ray, the directions from the light
//! form an arc. With the angle `psi` from its direction nearest to the axis and the `psi` of the
//! cone's edge, let `s = sin(psi/2) / sin(edge/2)` and `m = sin^2(edge/2)`. Then
//!
//! ```text
//! t = top (1 - s^2),   d(psi) = 2 sqrt(m) ds / sqrt(1 - m s^2)
//! ```
//!
//! with the `top` of the line, and the cone is where `s` is in `[-1, 1]`. `luminaire::haze` has the
//! integral over `psi`. Here it is that of rays from one eye, whose vectors to depth 1 have the
//! coordinates `(x, y, z)` in a [`Frame`]: with `H` the length of `(x, y)`, `axis = (ahead, aside)` and
//! `R^2 = ahead^2 H^2 + aside^2 x^2`,
//!
//! ```text
//! k = versine H - (aside y)^2 / (H + R),   top = k / H / (versine - inner),   m = k / (2 R)
//! s = (ahead H^2 - aside x f) / sqrt(L (L R + H (aside x + ahead f)) k)
//! ```
//!
//! at the ray's end `n`, the nearness, with `f = distance n + z` and `L^2 = H^2 + f^2`.

use super::{
    frame::{Frame, Sheaf, WIDTH},
    hazy::Hazy,
};
use crate::space::vector::sqrt;
use glam::Vec3;
use luminaire::falloff::{Falloff, Formula};

/// The beam of a spotlight without gobo and shadow map, prepared for one eye.
#[derive(Clone, Debug)]
pub(crate) struct Open {
    pub(super) frame: Frame,
    /// The in-scattering at `h = 1` of a line whose integral is 1.
    gain: f32,
    /// The coefficients of t, t^2 and t^3.
    curve: [f32; 3],
    outer: f32,
    /// The fall of t per versine.
    rise: f32,
    /// Whether the cone is narrow and has no hotspot, and the falloff has no cubic term.
    is_plain: bool,
}

/// `∫ s^4 / sqrt(1 - y s^2) ds` over `s` from 0 to 1: exact at 0, and within 1.4e-5 up to 1/2.
const G2: [f32; 5] = [0.2, 0.071_397_77, 0.043_334_715, 0.014_101_34, 0.056_927_025];

/// `1 / sqrt(1 - y)` in a narrow cone: coefficients of `y` and `y^2`, within 5.2e-6 up to 0.05.
const WEIGHT: [f32; 2] = [0.499_894_1, 0.391_381_7];

/// Largest versine of a narrow cone, of a half angle of 26 degrees: `m` is at most half of it.
const NARROW: f32 = 0.1;

/// Arc below which its middle stands for all of it: the difference of primitives would cancel.
const SHORT: f32 = 1.0 / 128.0;

#[inline(always)]
fn at_least_0(x: f32) -> f32 {
    if x > 0.0 { x } else { 0.0 }
}

/// Clamps to `[-most, most]`.
#[inline(always)]
fn within(x: f32, most: f32) -> f32 {
    let x = if x > -most { x } else { -most };
    if x < most { x } else { most }
}

/// What the integral of the falloff along the line of a ray depends on.
#[derive(Clone, Copy)]
struct Line {
    curve: [f32; 3],
    top: f32,
    m: f32,
}

impl Line {
    /// Returns the intensity at `s`.
    #[inline(always)]
    fn intensity(self, s: f32) -> f32 {
        let [a, b, c] = self.curve;
        let t = at_least_0(self.top * (1.0 - s * s));
        let t = if t < 1.0 { t } else { 1.0 };
        t * (a + t * (b + t * c))
    }

    /// Returns the integral of a quadratic from -1 to `s`, in a narrow cone without a hotspot.
    #[inline(always)]
    fn narrow(self, s: f32) -> f32 {
        let ([a, b, _], m) = (self.curve, self.m);
        // The falloff, over `top`, is `c0 - c1 s^2 + c2 s^4`.
        let c2 = b * self.top;
        let (c0, c1) = (a + c2, a + 2.0 * c2);
        let (w1, w2) = (WEIGHT[0] * m, WEIGHT[1] * (m * m));
        let third = (1.0 / 3.0) * (w1 * c0 - c1);
        let fifth = 0.2 * (w2 * c0 - w1 * c1 + c2);
        let seventh = (1.0 / 7.0) * (w1 * c2 - w2 * c1);
        let ninth = (1.0 / 9.0) * (w2 * c2);
        let z = s * s;
        let primitive = s * (c0 + z * (third + z * (fifth + z * (seventh + z * ninth))));
        self.top * (primitive + (c0 + third + fifth + seventh + ninth))
    }

    /// Returns the integral of full intensity from 0 to `s`. `luminaire::haze` has the recurrence.
    #[inline(always)]
    fn full(self, s: f32) -> f32 {
        let y = self.m * (s * s);
        let cosine = sqrt(1.0 - y);
        let g2 = G2[0] + y * (G2[1] + y * (G2[2] + y * (G2[3] + y * G2[4])));
        let g1 = (1.0 / 3.0) * cosine + (4.0 / 3.0) * (y * g2);
        s * (cosine + 2.0 * (y * g1))
    }

    /// Returns the integral of any of the polynomials, with full intensity up to `hot`.
    ///
    /// The two parts of the rim are integrated by Gauss-Legendre quadrature with four nodes: a
    /// difference of primitives would cancel where the rim is thin.
    #[inline(always)]
    fn integral(self, from: f32, to: f32, hot: f32) -> f32 {
        let at = |s: f32| self.intensity(s) / sqrt(1.0 - self.m * (s * s));
        let rim = |from: f32, to: f32| {
            let (half, middle) = (0.5 * (to - from), 0.5 * (to + from));
            let pair = |place: f32| at(middle - half * place) + at(middle + half * place);
            at_least_0(half) * (0.652_145_15 * pair(0.339_981_04) + 0.347_854_85 * pair(0.861_136_3))
        };
        let middle = self.full(within(to, hot)) - self.full(within(from, hot));
        rim(from, if to < -hot { to } else { -hot }) + middle + rim(if from > hot { from } else { hot }, to)
    }
}

impl Open {
    /// Prepares a beam; `None` if its falloff is no polynomial, if it is cut off, if it attenuates other
    /// than with the inverse square, or if the eye is in the light.
    pub(crate) fn new(hazy: &Hazy, eye: Vec3) -> Option<Self> {
        let ([inner, outer, limit], falloff) = (hazy.cone.versines(), hazy.cone.falloff());
        let Formula::Polynomial(curve) = falloff.formula() else { return None };
        let frame = Frame::new(hazy, eye).filter(|_| limit >= outer && hazy.beam.is_inverse_square())?;
        let is_plain = inner == 0.0 && curve[2] == 0.0 && outer < NARROW;
        let gain = hazy.gain / frame.distance;
        Some(Self { frame, gain, curve, outer, rise: 1.0 / (outer - inner), is_plain })
    }

    /// Returns the light of the rays through the pixels from `(x, y)` to the right, up to surfaces of
    /// this nearness.
    #[inline(always)]
    pub(super) fn light(&self, sheaf: &Sheaf, at: (usize, usize), nearness: &[f32; WIDTH]) -> [f32; WIDTH] {
        if !self.frame.is_outside {
            self.run::<true, true>(sheaf, at, nearness)
        } else if self.is_plain && !sheaf.is_near {
            self.run::<false, false>(sheaf, at, nearness)
        } else {
            self.run::<false, true>(sheaf, at, nearness)
        }
    }

    /// Computes [`light`](Self::light). The eye may be in the cone or in the opposite cone if it may be
    /// `INSIDE`. Not `IN_FULL`, the beam must be plain and no ray may hit the light's body.
    #[inline(never)]
    fn run<const INSIDE: bool, const IN_FULL: bool>(
        &self,
        sheaf: &Sheaf,
        (x, y): (usize, usize),
        nearness: &[f32; WIDTH],
    ) -> [f32; WIDTH] {
        let Self { frame, gain, outer, rise, .. } = *self;
        let [ahead, aside] = frame.axis;
        let row = sheaf.row(x, y);
        let mut light = [0.0; WIDTH];
        for i in 0..WIDTH {
            let way = row(i);
            let squared = way.x * way.x + way.y * way.y;
            let squared = if squared > 1e-20 { squared } else { 1e-20 };
            let whole = squared + way.z * way.z;
            let far = frame.far::<IN_FULL>(way, [squared, whole], nearness[i]);
            let height = sqrt(squared);
            let (along, across) = (aside * way.x, aside * way.y);
            let radius = sqrt(ahead * ahead * squared + along * along);
            // One division for three.
            let (sum, both) = (height + radius, height * radius);
            let per_all = 1.0 / (sum * both);
            let per_both = sum * per_all;
            let peak = at_least_0(outer * height - across * across * (both * per_all));
            let m = 0.5 * peak * height * per_both;
            let top = peak * radius * per_both * rise;
            let length = sqrt(squared + far * far);
            let turn = squared * ahead - far * along;
            let dot = along + far * ahead;
            let to = turn / sqrt(length * (length * radius + height * dot) * peak);
            // Over a right angle from the axis.
            let end = if dot > 0.0 { to } else { turn * f32::INFINITY };
            let to = within(end, 1.0);

            let line = Line { curve: self.curve, top, m };
            let hot = sqrt(at_least_0(1.0 - 1.0 / top));
            let result = if INSIDE {
                let start = -along / sqrt((radius + height * ahead) * peak);
                let start = if ahead > 0.0 { start } else { along * f32::NEG_INFINITY };
                let from = within(start, 1.0);
                // Past the direction opposite the axis there is one edge of the cone.
                let is_around = (start > 0.0) & (end < 0.0) & ((start >= 1.0) | (end <= -1.0));
                let is_short = (end - start < SHORT) & !is_around;
                let (arc, middle) = (to - from, 0.5 * (to + from));
                let share = if arc < end - start { arc / (end - start) } else { 1.0 };
                let short = line.intensity(middle) * share * (height / (length + far));
                let to = if is_around & (from < 1.0) { 1.0 } else { to };
                let from = if is_around & (from >= 1.0) { -1.0 } else { from };
                if is_short { short / sqrt(m) } else { line.integral(from, to, hot) }
            } else if IN_FULL {
                line.integral(-1.0, to, hot)
            } else {
                line.narrow(to)
            };
            let scale = gain * (2.0 * sqrt(m * whole)) * (radius * per_both);
            let is_lit = (INSIDE | (way.x > 0.0)) & (peak > 0.0) & (result > 0.0);
            light[i] = if is_lit { scale * result } else { 0.0 };
        }
        light
    }
}
