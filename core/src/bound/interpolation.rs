//! A bound of the error of linear interpolation between points of a flat surface.
//!
//! On a straight line of a flat surface, a point at the distance `d` from the light has the irradiance
//! `E = I P(t) H / d^3`, with the light's height `H` above the surface. Let `s` and `c` be cosine and sine of
//! the angle between the line and the direction from the light, so `H <= c d`. Along the line
//!
//! ```text
//! H (d^-3)'  <= 3 s c d^-3          v'  <= sqrt(2 w) c / d
//! H (d^-3)'' <= c |15 s^2 - 3| d^-4   v'' <= (c^2 + 2 s c sqrt(2 w)) / d^2
//! ```
//!
//! with the versine `v` of the direction, at most the outer versine `w`: its sine is at most `sqrt(2 w)`.
//! With `t = (w - v) / span`, the largest slope `P1` and curvature `P2` of the falloff, and the maxima
//! over `s` of `c |15 s^2 - 3|` (4.1313), `8 s c^2` (3.0793) and `2 s c^2` (0.7699), the second derivative is
//!
//! ```text
//! |E''| <= I / d^4 (2 w P2 / span^2 + (1 + 3.0793 sqrt(2 w)) P1 / span + 4.1313)
//! ```
//!
//! Linear interpolation between points `h` apart errs by at most `h^2 / 8` times it, and by at most `h / 4`
//! times each kink of the slope between them. A falloff has kinks where the cone ends and where its full
//! intensity begins, of `I / d^2 |v'|` times its slope there over the span. A run of points crosses such an
//! edge once, or twice with slopes that add up to at most `h` times the largest `v''`.

use crate::{
    attenuation::InverseSquare,
    falloff::{Falloff, Formula},
    light::SpotLight,
    trig::square_root,
};

use super::above;

/// The largest `c |15 s^2 - 3|`: the curvature of the inverse square on a flat surface. Like all constants here it is
/// rounded up.
const FALL: f64 = 4.1313;
/// The largest `8 s c^2`: six of the product of both slopes, and two of the versine's own curvature.
const BOTH: f64 = 3.0793;
/// The largest `2 s c^2`: the curvature of the versine.
const BENT: f64 = 0.7699;

impl<P: Falloff> SpotLight<P, InverseSquare> {
    /// Returns an upper bound of the error of linear interpolation of the irradiance between points that are
    /// `spacing` apart on a straight line of a flat surface, no part of which is nearer than `nearest`.
    ///
    /// The bound is that of exact arithmetic: 1 is full scale and 1/255 a linear code. A display whose
    /// codes run from 0 to `last` shows it as at most `last` times the sRGB encoding of the bound, because
    /// the encoding is concave. `core/src/bound/interpolation.rs` has the derivation.
    ///
    /// `None` if the intensity jumps at the edge of the cone, if the falloff is neither a polynomial nor a
    /// power of at least 2, if `spacing` and `nearest` are not positive finite numbers, or if the bound is
    /// not finite in `f32`.
    pub fn interpolation_bound(&self, spacing: f32, nearest: f32) -> Option<f32> {
        let [inner, outer, limit] = self.cone().versines().map(f64::from);
        let falloff = self.cone().falloff();
        // The slopes at t = 0 and t = 1, the largest slope, and the largest curvature.
        let [start, end, slope, curvature] = match falloff.formula() {
            Formula::Polynomial(curve) => {
                let [a, b, c] = curve.map(f64::from);
                let slope = |t: f64| (a + t * (2.0 * b + t * (3.0 * c))).abs();
                let curvature = |t: f64| (2.0 * b + 6.0 * c * t).abs();
                let turn = -b / (3.0 * c);
                let middle = if turn > 0.0 && turn < 1.0 { slope(turn) } else { 0.0 };
                let [start, end] = [slope(0.0), slope(1.0)];
                [start, end, start.max(end).max(middle), curvature(0.0).max(curvature(1.0))]
            }
            Formula::Power(p) if p >= 2.0 => {
                let p = f64::from(p);
                [0.0, p, p, p * (p - 1.0)]
            }
            _ => return None,
        };
        let positive = |length: f32| Some(f64::from(length)).filter(|c| c.is_finite() && *c > 0.0);
        let (nearest, true) = (positive(nearest)?, limit >= outer && outer > inner) else { return None };
        let h = positive(spacing)? / nearest;
        let (span, sine) = (outer - inner, square_root(2.0 * outer));
        // The axis is no edge: there the versine has no slope.
        let at_edges = start + if inner > 0.0 { end } else { 0.0 };
        let crossed = sine.max(h * (1.0 + BENT * sine));
        let bend = second_derivative([inner, outer], slope, curvature);
        let error = h * h / 8.0 * bend + h / 4.0 * at_edges * crossed / span;
        Some(above(f64::from(self.intensity()) / (nearest * nearest) * error))
            .filter(|bound| bound.is_finite())
    }
}

/// Returns an upper bound of the second derivative along a line, of a light of intensity 1 at distance 1, from
/// the largest slope and curvature of the falloff.
fn second_derivative([inner, outer]: [f64; 2], slope: f64, curvature: f64) -> f64 {
    let (span, sine) = (outer - inner, square_root(2.0 * outer));
    2.0 * outer * curvature / (span * span) + (1.0 + BOTH * sine) * slope / span + FALL
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        angle::Angle,
        cone::Cone,
        falloff::{AnyFalloff, Linear, Power, Smooth, Soft},
    };

    #[test]
    fn constants_are_the_maxima_rounded_up() {
        let most = |of: fn(f64, f64) -> f64| {
            let sines = (0..=1_000_000).map(|i| f64::from(i) / 1e6);
            sines.map(|s| of(s, (1.0 - s * s).sqrt())).fold(0.0, f64::max)
        };
        let maxima = [
            most(|s, c| c * (15.0 * s * s - 3.0).abs()),
            most(|s, c| 8.0 * s * c * c),
            most(|s, c| 2.0 * s * c * c),
        ];
        for (constant, most) in [FALL, BOTH, BENT].into_iter().zip(maxima) {
            assert!((most..most + 2e-4).contains(&constant), "{constant} of {most}");
        }
    }

    /// Random lines through random cones, by differences of three points.
    #[test]
    fn no_second_derivative_along_a_line_exceeds_its_bound() {
        type Vector = [f64; 3];
        type Curve = (fn(f64) -> f64, [f64; 2]);
        let dot = |a: Vector, b: Vector| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let mut rng = fastrand::Rng::with_seed(1968);
        let mut direction = || loop {
            let v = [0; 3].map(|_| 2.0 * rng.f64() - 1.0);
            if (0.05..=1.0).contains(&dot(v, v)) {
                return v.map(|c| c / dot(v, v).sqrt());
            }
        };
        let numbers = &mut fastrand::Rng::with_seed(1969);
        // Each falloff with its largest slope and curvature.
        let falloffs: [Curve; 4] = [
            (|t| t, [1.0, 0.0]),
            (|t| t * t, [2.0, 2.0]),
            (|t| t * t * (3.0 - 2.0 * t), [1.5, 6.0]),
            (|t| t.powi(8), [8.0, 56.0]),
        ];
        for (falloff, [slope, curvature]) in falloffs {
            let mut most = 0.0_f64;
            for _ in 0..50_000 {
                let outer = 1e-6_f64.powf(numbers.f64());
                let inner = if numbers.bool() { 0.0 } else { 0.9 * outer * numbers.f64() };
                let (axis, along) = (direction(), direction());
                let off = direction();
                let size = outer.sqrt() * numbers.f64();
                let point = [0, 1, 2].map(|i| axis[i] + size * off[i]);
                let point = point.map(|c| c / dot(point, point).sqrt());
                // The surface that faces the light most, of those that have the line.
                let across = dot(point, along);
                let height = (1.0 - across * across).sqrt();
                let t = |place: f64| {
                    let at = [0, 1, 2].map(|i| point[i] + place * along[i]);
                    let distance = dot(at, at).sqrt();
                    let chord = [0, 1, 2].map(|i| at[i] / distance - axis[i]);
                    ((outer - dot(chord, chord) / 2.0) / (outer - inner), distance)
                };
                let step = 1e-3 * (outer - inner) / outer.sqrt();
                let places = [-step, 0.0, step].map(t);
                if places.iter().any(|(t, _)| !(0.0..=1.0).contains(t)) {
                    continue;
                }
                let [a, b, c] = places.map(|(t, distance)| falloff(t) * height / distance.powi(3));
                let found = (a - 2.0 * b + c).abs() / (step * step);
                most = most.max(found / second_derivative([inner, outer], slope, curvature));
            }
            assert!((0.25..=1.001).contains(&most), "{slope} {curvature}: {most} of the bound");
        }
    }

    #[test]
    fn a_bound_is_finite_or_none() {
        let lengths = [f32::NAN, f32::INFINITY, -1.0, 0.0, 1e-45, 1e-3, 1.0, 1e9, f32::MAX];
        let falloffs: [AnyFalloff; 4] = [Soft.into(), Linear.into(), Smooth.into(), Power::<16>.into()];
        let (mut bounds, mut none) = (0, 0);
        for falloff in falloffs {
            // The cone of two equal angles jumps at its edge.
            for [inner, outer] in [[0.0, 40.0], [20.0, 40.0], [40.0, 40.0], [0.0, 1e-3], [0.0, 180.0]] {
                // By the angles of micromath, half a turn is over the limit of a cone.
                let widest = [outer, 179.0].map(|outer| Cone::from_outer(falloff, Angle::degrees(outer)));
                let cone = widest.into_iter().find_map(Result::ok).unwrap();
                let cone = cone.with_inner(Angle::degrees(inner)).unwrap();
                let light = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone).unwrap();
                for intensity in [0.0, 1.0, 1e9] {
                    let light = light.with_intensity(intensity).unwrap();
                    for (spacing, nearest) in
                        lengths.iter().flat_map(|spacing| lengths.map(|nearest| (*spacing, nearest)))
                    {
                        let is_sound = [spacing, nearest].iter().all(|c| c.is_finite() && *c > 0.0);
                        let bound = light.interpolation_bound(spacing, nearest);
                        assert!(
                            bound.is_none_or(|bound| is_sound && bound.is_finite() && bound >= 0.0),
                            "{falloff:?} {inner} to {outer}, {spacing} {nearest}: {bound:?}"
                        );
                        bounds += usize::from(bound.is_some());
                        none += usize::from(is_sound && inner >= outer && bound.is_none());
                    }
                }
            }
        }
        assert!(bounds > 100 && none > 100, "{bounds} bounds; {none} of lights that jump");
    }
}
