//! A beam without gobo and shadow map as seen from the eye: its in-scattering by a formula.
//!
//! The falloff is a polynomial of `t` of degree 3 or less, a power or an inverted power. Along a ray,
//! the directions from the light form an arc. With the angle `psi` from its direction nearest to the
//! axis and the `psi` of the cone's edge, let `s = sin(psi/2) / sin(edge/2)` and `m = sin^2(edge/2)`. Then
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
    frame::{Frame, OUTSIDE, Sheaf, WIDTH},
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
    /// The coefficients of t, t^2 and t^3, or the exponent and the `t` that is faint beside 1.
    curve: [f32; 3],
    outer: f32,
    /// The fall of t per versine.
    rise: f32,
    /// How rays are integrated.
    rule: u8,
}

/// The rule of a polynomial without cubic term in a narrow cone without a hotspot: a closed form.
const PLAIN: u8 = 0;

/// The rule of any polynomial: four nodes in each part of the rim.
const POLYNOMIAL: u8 = 1;

/// The rules of powers and of inverted powers without a hotspot: eight nodes between the ends.
const POWER: u8 = 2;
const INVERTED: u8 = 3;

/// Computes the light of [`WIDTH`] rays by a rule.
pub(super) type Run = fn(&Open, &Sheaf, (usize, usize), &[f32; WIDTH]) -> [f32; WIDTH];

/// Pairs of nodes of Gauss-Legendre quadrature: a place, and the weight.
const FOUR: [[f32; 2]; 4] = [[0.339_981_04, 0.652_145_15], [0.861_136_3, 0.347_854_85], [0.0; 2], [0.0; 2]];
const EIGHT: [[f32; 2]; 4] = [
    [0.183_434_64, 0.362_683_8],
    [0.525_532_4, 0.313_706_64],
    [0.796_666_5, 0.222_381_03],
    [0.960_289_84, 0.101_228_54],
];

/// Least share of a ray's brightest intensity that is integrated: eight nodes must be where light is.
const FAINT: f32 = 7e-4;

/// `log2((1 + w) / (1 - w))`: coefficients of `w`, `w^3` and `w^5`, within a relative 1e-6 up to a
/// ratio of the root of 2.
const LOG: [f32; 3] = [2.885_39, 0.961_796_7, 0.586_3];

/// `2^r - 1`: coefficients of `r` to `r^4`, within a relative 3.3e-5 up to 1/2.
const EXP: [f32; 4] = [core::f32::consts::LN_2, 0.240_226_5, 0.055_757_5, 0.009_647_4];

/// The bits of the root of 2, less one unit in the last place.
const ROOT: u32 = 0x3fb5_04f2;

/// Added to a number, it rounds the number to an integer in the last bits of the sum.
const ROUND: f32 = 12_582_912.0;

/// `∫ s^4 / sqrt(1 - y s^2) ds` over `s` from 0 to 1: exact at 0, and within 1.4e-5 up to 1/2.
const G2: [f32; 5] = [0.2, 0.071_397_77, 0.043_334_715, 0.014_101_34, 0.056_927_025];

/// `1 / sqrt(1 - y)` in a narrow cone: coefficients of `y` and `y^2`, within 5.2e-6 up to 0.05.
const WEIGHT: [f32; 2] = [0.499_894_1, 0.391_381_7];

/// Largest versine of a narrow cone, of a half angle of 26 degrees: `m` is at most half of it.
const NARROW: f32 = 0.1;

/// Arc in `s` below which the integral is the mean intensity times the arc's angle: a difference of primitives
/// would cancel, as would that of the arc's ends.
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

/// Returns `t^exponent`, or if `IS_INVERTED` `1 - (1 - t)^exponent`.
///
/// A table would take more: a look-up is no vector instruction on most targets.
#[inline(always)]
fn power<const IS_INVERTED: bool>(t: f32, exponent: f32) -> f32 {
    // `x = m / 2^octaves`, with `m` between the roots of 1/2 and of 2.
    let bits = (if IS_INVERTED { 1.0 - t } else { t }).to_bits();
    let octaves = ROOT.wrapping_sub(bits) >> 23;
    let m = f32::from_bits(bits.wrapping_add(octaves << 23));
    // A small `t` keeps its bits.
    let z = if IS_INVERTED && octaves == 0 { -t } else { m - 1.0 };
    let w = z / (2.0 + z);
    let square = w * w;
    let log = w * (LOG[0] + square * (LOG[1] + square * LOG[2])) - octaves as f32;
    let log = if exponent * log > -126.0 { exponent * log } else { -126.0 };
    let shifted = log + ROUND;
    let r = log - (shifted - ROUND);
    let rest = r * (EXP[0] + r * (EXP[1] + r * (EXP[2] + r * EXP[3])));
    let scale = f32::from_bits((shifted.to_bits() << 23).wrapping_add(1.0_f32.to_bits()));
    if IS_INVERTED { (1.0 - scale) - scale * rest } else { scale + scale * rest }
}

/// What the integral of the falloff along the line of a ray depends on.
#[derive(Clone, Copy)]
struct Line<const RULE: u8> {
    curve: [f32; 3],
    top: f32,
    m: f32,
}

impl<const RULE: u8> Line<RULE> {
    /// Returns the intensity at `s`.
    #[inline(always)]
    fn intensity(self, s: f32) -> f32 {
        let [a, b, c] = self.curve;
        let t = at_least_0(self.top * (1.0 - s * s));
        match RULE {
            POWER => return power::<false>(t, a),
            INVERTED => return power::<true>(t, a),
            _ => {}
        }
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

    /// Returns what a pair of nodes adds.
    #[inline(always)]
    fn pair(self, [place, weight]: [f32; 2], middle: f32, half: f32) -> f32 {
        let at = |s: f32| self.intensity(s) / sqrt(1.0 - self.m * (s * s));
        weight * (at(middle - half * place) + at(middle + half * place))
    }

    /// Returns the integral by nodes. A loop over the pairs would not be vectorised.
    #[inline(always)]
    fn rim(self, from: f32, to: f32) -> f32 {
        let (half, middle) = (0.5 * (to - from), 0.5 * (to + from));
        let [a, b, c, d] = if RULE < POWER { FOUR } else { EIGHT };
        let sum = self.pair(a, middle, half) + self.pair(b, middle, half);
        let more = if RULE < POWER { -0.0 } else { self.pair(c, middle, half) + self.pair(d, middle, half) };
        at_least_0(half) * (sum + more)
    }

    /// Returns the integral by nodes, for polynomials with full intensity between the parts of the rim: a
    /// difference of primitives would cancel where the rim is thin.
    #[inline(always)]
    fn integral(self, from: f32, to: f32) -> f32 {
        if RULE >= POWER {
            let near = at_least_0(if from > -to { from } else { -to });
            let lit = sqrt(1.0 - self.curve[1] * (1.0 - near * near));
            return self.rim(if from > -lit { from } else { -lit }, if to < lit { to } else { lit });
        }
        let hot = sqrt(at_least_0(1.0 - 1.0 / self.top));
        let middle = self.full(within(to, hot)) - self.full(within(from, hot));
        self.rim(from, if to < -hot { to } else { -hot })
            + middle
            + self.rim(if from > hot { from } else { hot }, to)
    }
}

impl Open {
    /// Prepares a beam; `None` if nodes do not integrate its falloff, if it is cut off, if it attenuates
    /// other than with the inverse square, or if the eye is in the light.
    pub(crate) fn new(hazy: &Hazy, eye: Vec3) -> Option<Self> {
        let ([inner, outer, limit], falloff) = (hazy.cone.versines(), hazy.cone.falloff());
        let is_cold = inner == 0.0;
        let (rule, curve) = match falloff.formula() {
            Formula::Polynomial(curve @ [_, _, 0.0]) if is_cold && outer < NARROW => (PLAIN, curve),
            Formula::Polynomial(curve) => (POLYNOMIAL, curve),
            // The slope of a lower one is too steep at the edge, or on the axis.
            Formula::Power(p) if is_cold && p >= 0.75 => (POWER, [p, libm::powf(FAINT, 1.0 / p), 0.0]),
            Formula::InvertedPower(p, 0.0) if is_cold && (1.5..=12.0).contains(&p) => {
                (INVERTED, [p, 0.0, 0.0])
            }
            _ => return None,
        };
        let mut frame = Frame::new(hazy, eye).filter(|_| limit >= outer && hazy.beam.is_inverse_square())?;
        if rule >= POWER {
            // The kernel's edge of the cone is where a power becomes faint.
            frame.is_outside = outer < 1.0 && frame.axis[1] > OUTSIDE * sqrt(outer * (2.0 - outer));
        }
        let gain = hazy.gain / frame.distance;
        Some(Self { frame, gain, curve, outer, rise: 1.0 / (outer - inner), rule })
    }

    /// Returns how the light of rays is computed.
    pub(super) fn way(&self, sheaf: &Sheaf) -> Run {
        match (self.rule, self.frame.is_outside) {
            (PLAIN, true) if !sheaf.is_near => Self::run::<false, PLAIN>,
            (POWER, true) => Self::run::<false, POWER>,
            (POWER, false) => Self::run::<true, POWER>,
            (INVERTED, true) => Self::run::<false, INVERTED>,
            (INVERTED, false) => Self::run::<true, INVERTED>,
            (_, true) => Self::run::<false, POLYNOMIAL>,
            (_, false) => Self::run::<true, POLYNOMIAL>,
        }
    }

    /// Returns the light of the rays through the pixels from `(x, y)` to the right, up to surfaces of
    /// this nearness. The eye may be in the cone or in the opposite cone if it may be `INSIDE`. By the rule
    /// `PLAIN` no ray may hit the light's body.
    #[inline(never)]
    fn run<const INSIDE: bool, const RULE: u8>(
        &self,
        sheaf: &Sheaf,
        (x, y): (usize, usize),
        nearness: &[f32; WIDTH],
    ) -> [f32; WIDTH] {
        let Self { frame, gain, curve, outer, rise, .. } = *self;
        let [ahead, aside] = frame.axis;
        let row = sheaf.row(x, y);
        let mut light = [0.0; WIDTH];
        for i in 0..WIDTH {
            let way = row(i);
            let squared = way.x * way.x + way.y * way.y;
            let squared = if squared > 1e-20 { squared } else { 1e-20 };
            let whole = squared + way.z * way.z;
            let far = frame.far(RULE != PLAIN, way, [squared, whole], nearness[i]);
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

            let line = |m: f32| Line::<RULE> { curve, top, m };
            let result = if INSIDE {
                let start = -along / sqrt((radius + height * ahead) * peak);
                let start = if ahead > 0.0 { start } else { along * f32::NEG_INFINITY };
                let from = within(start, 1.0);
                // Past the direction opposite the axis there is one edge of the cone.
                let is_around = (start > 0.0) & (end < 0.0) & ((start >= 1.0) | (end <= -1.0));
                let arc = end - start;
                let is_short = (arc < SHORT) & !is_around;
                let to = if is_around & (from < 1.0) { 1.0 } else { to };
                let from = if is_around & (from >= 1.0) { -1.0 } else { from };
                // In a short arc `s` stands for the angle, as if the cone were narrow: then a primitive is `s`.
                let line = line(if is_short { 0.0 } else { m });
                let integral = line.integral(from, to);
                let mean = if arc > 0.0 { integral / arc } else { line.intensity(to) };
                if is_short { mean * (height / (length + far)) / sqrt(m) } else { integral }
            } else if RULE == PLAIN {
                line(m).narrow(to)
            } else {
                line(m).integral(-1.0, to)
            };
            let scale = gain * (2.0 * sqrt(m * whole)) * (radius * per_both);
            let is_lit = (INSIDE | (way.x > 0.0)) & (peak > 0.0) & (result > 0.0);
            light[i] = if is_lit { scale * result } else { 0.0 };
        }
        light
    }
}
