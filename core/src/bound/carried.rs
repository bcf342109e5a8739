//! Numbers that carry their errors through the kernel's code of falloffs and attenuations.

#[cfg(test)]
mod tests;

use core::{cell::Cell, cmp::Ordering};

use crate::{
    number::{Fraction, InversePower, KEPT, Knot, Offset, Ray, RealExponent, Rounding, Share, Stages},
    trig::real_power,
    vec3::Vec3,
};

/// One pass of an evaluation over a cell of distances, and the light that it ends with.
#[derive(Debug)]
pub(super) struct Pass {
    pub(super) stages: Stages,
    /// Whether the evaluation is the fine one.
    pub(super) is_fine: bool,
    /// The nearest and the farthest distance of a cell.
    pub(super) distances: [f64; 2],
    pub(super) intensity: f64,
    /// Whether only light counts that the coarse evaluation of `Fx16` keeps.
    pub(super) is_kept: bool,
    /// The light of the cell.
    pub(super) lit: Cell<Lit>,
}

/// The light at a set of points, clipped to full scale.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Lit {
    /// The least exact light.
    pub from: f64,
    /// The most exact light.
    pub to: f64,
    /// An upper bound of the error.
    pub error: f64,
}

/// A result of an operation.
///
/// The exact result is in `[low, high]`. The computed one differs by a derivative within `slope` times
/// the error of the falloff's argument, and by at most `error` more.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Carried<'a> {
    pass: Option<&'a Pass>,
    pub(super) low: f64,
    pub(super) high: f64,
    /// The smallest and the largest derivative with respect to the argument of the falloff.
    slope: [f64; 2],
    /// The error of the argument.
    argument: f64,
    error: f64,
}

/// Returns the interval of the products of the numbers of two intervals.
fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let products = [a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]];
    [
        products.into_iter().fold(f64::INFINITY, f64::min),
        products.into_iter().fold(f64::NEG_INFINITY, f64::max),
    ]
}

fn sum(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

impl<'a> Carried<'a> {
    /// Creates the argument of a falloff between two exact values. The cell is widened by the error,
    /// so that derivatives between an exact and a computed value are those of the cell.
    pub(super) fn argument(pass: &'a Pass, [low, high]: [f64; 2], error: f64) -> Self {
        let (low, high) = ((low - error).max(0.0), (high + error).min(1.0));
        Self { pass: Some(pass), low, high, slope: [1.0; 2], argument: error, error: 0.0 }
    }

    /// Creates a number in an interval with an error.
    pub(super) fn number(pass: &'a Pass, [low, high]: [f64; 2], error: f64) -> Self {
        Self { pass: Some(pass), low, high, error, ..Self::default() }
    }

    /// Returns the error of the result.
    pub(super) fn total(&self) -> f64 {
        // Beside an infinite derivative, both values are still in the interval.
        (self.steepness() * self.argument).min(self.high - self.low) + self.error
    }

    /// Returns the largest derivative with respect to the argument.
    pub(super) fn steepness(&self) -> f64 {
        self.slope[0].abs().max(self.slope[1].abs())
    }

    /// Returns the same number without its dependence on an argument.
    fn settled(self) -> Self {
        Self { error: self.total(), slope: [0.0; 2], argument: 0.0, ..self }
    }

    /// Returns the same number with the rounding of a stage. One without an evaluation is the constant
    /// zero, whose operations are exact.
    fn rounded(self, stage: impl Fn(&Stages) -> Rounding) -> Self {
        let rounding = self.pass.map_or(Rounding::NONE, |pass| stage(&pass.stages));
        Self { error: self.error + rounding.of(self.high), ..self }
    }

    /// Returns a monotone function of this number from its values at both ends and its derivative.
    fn mapped(self, ends: [f64; 2], derivative: [f64; 2], stage: impl Fn(&Stages) -> Rounding) -> Self {
        let (low, high) = (ends[0].min(ends[1]).max(0.0), ends[0].max(ends[1]).min(1.0));
        let error =
            if self.error > 0.0 { self.error * derivative[0].abs().max(derivative[1].abs()) } else { 0.0 };
        Self { low, high, slope: product(self.slope, derivative), error, ..self }.rounded(stage)
    }

    fn multiplied(self, other: Self, stage: impl Fn(&Stages) -> Rounding) -> Self {
        let slope =
            sum(product(self.slope, [other.low, other.high]), product(other.slope, [self.low, self.high]));
        // Two numbers that depend on the same argument have the same error of it.
        let argument = self.argument.max(other.argument);
        let error = self.error * (other.high + other.error) + other.error * self.high;
        let (low, high) = (self.low * other.low, self.high * other.high);
        Self { pass: self.pass.or(other.pass), low, high, slope, argument, error }.rounded(stage)
    }

    /// `t^2 (3 - 2 t)`.
    fn smoothed(self) -> Self {
        let derivative = |t: f64| 6.0 * t * (1.0 - t);
        let [a, b] = [derivative(self.low), derivative(self.high)];
        let most = if self.low < 0.5 && self.high > 0.5 { 1.5 } else { a.max(b) };
        let ends = [self.low, self.high].map(|t| t * t * (3.0 - 2.0 * t));
        self.mapped(ends, [a.min(b), most], |stages| stages.smooth)
    }

    /// `t (1 + u (g + h t))`, where this many coefficients and sums of two are rounded.
    fn lifted(self, g: f64, h: f64, rounded: f64) -> Self {
        let value = |t: f64| t * (1.0 + (1.0 - t) * (g + h * t));
        let derivative = |t: f64| 1.0 + g * (1.0 - 2.0 * t) + h * t * (2.0 - 3.0 * t);
        let [a, b] = [derivative(self.low), derivative(self.high)];
        let (mut least, mut most) = (a.min(b), a.max(b));
        // The derivative is a parabola with its vertex here.
        let vertex = (h - g) / (3.0 * h);
        if vertex > self.low && vertex < self.high {
            (least, most) = (least.min(derivative(vertex)), most.max(derivative(vertex)));
        }
        let lifted = self.mapped([value(self.low), value(self.high)], [least, most], |stages| {
            let of_weights = stages.weight * rounded * (1.0 - self.low);
            Rounding::absolute(stages.lift.of(self.high) + self.high * of_weights)
        });
        lifted.rounded(|stages| stages.value)
    }

    /// The linear interpolation over `u = 1 - t` between points `(u, value)` in the order of `u`.
    fn interpolated(self, points: impl Iterator<Item = [(f64, f64); 2]>) -> Self {
        let (from, to) = (1.0 - self.high, 1.0 - self.low);
        let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
        let mut derivative = [f64::INFINITY, f64::NEG_INFINITY];
        for [(start, first), (end, last)] in points {
            if end < from || start > to || end <= start {
                continue;
            }
            let rise = (last - first) / (end - start);
            for u in [from.max(start), to.min(end)] {
                let value = (first + rise * (u - start)).clamp(0.0, 1.0);
                (low, high) = (low.min(value), high.max(value));
            }
            derivative = [derivative[0].min(-rise), derivative[1].max(-rise)];
        }
        if high < low || derivative[0] > derivative[1] {
            return self.mapped([0.0; 2], [0.0; 2], |stages| stages.sample);
        }
        let steepest = derivative[0].abs().max(derivative[1].abs());
        self.mapped([low, high], derivative, |stages| {
            Rounding::absolute(stages.sample.of(1.0) + steepest * stages.place.of(to))
        })
    }

    /// Ends the evaluation with this share of the intensity, times a factor in an interval and with a
    /// relative error.
    fn lit_by(self, [least, most]: [f64; 2], relative: f64) -> f32 {
        let share = self.settled();
        let Some(pass) = self.pass else { return 0.0 };
        let [least, most] = [least, most].map(|factor| factor * pass.intensity);
        let (of_share, step) = (share.error + pass.stages.given, pass.stages.light.of(1.0));
        let exact = share.low * least;
        let error = if pass.is_kept {
            let [least_share, least_light] = KEPT.map(|steps| f64::from(steps) / 16_384.0);
            let share = share.high + of_share;
            if share <= least_share || share * most * (1.0 + relative) + step <= least_light {
                0.0
            } else {
                let kept = (least_light - step) / (1.0 + relative) - of_share * most;
                1.0 - exact.max(kept).max((least_share - of_share) * least)
            }
        } else if (share.low - of_share) * least * (1.0 - relative) - step >= 1.0 {
            // Even the least computed light is over full scale.
            0.0
        } else {
            let size = (share.high * most).min(1.0);
            of_share * most * (1.0 + relative) + size * relative + pass.stages.light.of(size)
        };
        let [from, to] = [exact, share.high * most].map(|light| light.clamp(0.0, 1.0));
        pass.lit.set(Lit { from, to, error: error.clamp(0.0, 1.0) });
        0.0
    }
}

impl PartialEq for Carried<'_> {
    fn eq(&self, _: &Self) -> bool {
        false
    }
}

/// Falloffs and attenuations compare with 0 alone, at which a share ends.
impl PartialOrd for Carried<'_> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(if self.high > other.high { Ordering::Greater } else { Ordering::Less })
    }
}

impl Fraction<f32> for Carried<'_> {
    type Value = Self;

    fn complement(self) -> Self {
        Share::complement(self)
    }

    fn times(self, other: Self) -> Self {
        self.multiplied(other, |stages| stages.product)
    }

    fn times_to_value(self, other: Self) -> Self {
        self.multiplied(other, |stages| stages.value)
    }

    fn times_value(self, value: Self) -> Self {
        self.multiplied(value, |stages| stages.value)
    }

    fn real_power(self, exponent: RealExponent) -> Self {
        let (p, floor, gain) = exponent.parts();
        let power = |t: f64| ((real_power(t, p) - floor) * gain).max(0.0);
        let slope = |t: f64| match t {
            _ if p >= 1.0 => gain * p * real_power(t, p - 1.0),
            _ if t > 0.0 => gain * p / real_power(t, 1.0 - p),
            _ => f64::INFINITY,
        };
        let [a, b] = [slope(self.low), slope(self.high)];
        let own = |_: &Stages| Rounding::absolute(exponent.error());
        let mapped = self.mapped([power(self.low), power(self.high)], [a.min(b), a.max(b)], own);
        mapped.rounded(|stages| stages.power)
    }

    fn value(self) -> Self {
        // The rounding of a product to a value is at least that of a fraction.
        self.rounded(|stages| stages.value)
    }

    fn step(self) -> Self {
        Self { low: 1.0, high: 1.0, slope: [0.0; 2], error: 0.0, ..self }
    }

    fn smooth(self) -> Self {
        self.smoothed()
    }

    fn quadratic(self, g: f32) -> Self {
        self.lifted(g.into(), 0.0, 1.0)
    }

    fn cubic(self, g: f32, h: f32) -> Self {
        self.lifted(g.into(), h.into(), 3.0)
    }

    fn soft_pair(self, share: f32, ratio: f32) -> Self {
        let (k, g) = (f64::from(share), f64::from(ratio));
        let narrow = |t: f64| (1.0 - g * (1.0 - t)).max(0.0);
        let value = |t: f64| (1.0 - k) * t * t + k * narrow(t) * narrow(t);
        // The derivative does not fall.
        let derivative = |t: f64| 2.0 * ((1.0 - k) * t + k * g * narrow(t));
        let ends = [self.low, self.high];
        self.mapped(ends.map(value), ends.map(derivative), |stages| stages.pair)
    }

    fn sample(self, samples: &[u16]) -> Self {
        let last = samples.len().saturating_sub(1) as f64;
        self.interpolated(samples.windows(2).enumerate().map(|(i, pair)| {
            let at = |i: usize, sample: u16| (i as f64 / last, f64::from(sample) / 65_535.0);
            [at(i, pair[0]), at(i + 1, pair[1])]
        }))
    }

    fn sample_knots(self, knots: &[Knot]) -> Self {
        self.interpolated(knots.iter().enumerate().map(|(i, knot)| {
            let (start, value, slope) = knot.to_bits();
            let end = knots.get(i + 1).map_or(65_536.0, |next| f64::from(next.to_bits().0));
            let rise = f64::from(slope) / 32_768.0 * (end - f64::from(start));
            let point = |place: f64, value: f64| (place / 65_536.0, value / 65_535.0);
            [point(start.into(), value.into()), point(end, f64::from(value) + rise)]
        }))
    }
}

impl Share<f32> for Carried<'_> {
    fn of_scalar(_: f32) -> Self {
        // Shares begin with the cosine.
        Self::default()
    }

    fn scalar(self) -> f32 {
        self.high as f32
    }

    fn is_one(self) -> bool {
        self.low >= 1.0
    }

    fn complement(self) -> Self {
        let (low, high) = (1.0 - self.high, 1.0 - self.low);
        Self { low, high, slope: [-self.slope[1], -self.slope[0]], ..self }
            .rounded(|stages| stages.complement)
    }

    fn times(self, other: Self) -> Self {
        self.multiplied(other, |stages| stages.share)
    }

    fn smooth(self) -> Self {
        self.settled().smoothed()
    }

    fn light(self, _: f32) -> f32 {
        let gain = self.pass.map_or(0.0, |pass| pass.stages.gain);
        self.lit_by([1.0; 2], gain)
    }
}

/// The ray of a cell of distances.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way<'a>(pub(super) &'a Pass);

impl<'a> Way<'a> {
    /// Returns a function of the distance that does not fall, at most 1.
    fn share(self, value: impl Fn(f64) -> f64) -> Carried<'a> {
        let ends = self.0.distances.map(|distance| value(distance).min(1.0));
        let near = self.0.stages.near;
        Carried::number(self.0, ends, near.of(ends[1]))
    }

    /// Returns the factors at the farthest and at the nearest distance.
    fn factors(self, factor: impl Fn(f64) -> f64) -> [f64; 2] {
        let [near, far] = self.0.distances;
        [factor(far), factor(near)]
    }
}

/// An attenuation computes with the last five operations alone.
impl<'a> Ray<f32> for Way<'a> {
    type Fraction = Carried<'a>;
    type Share = Carried<'a>;

    fn distance(&self) -> f32 {
        self.0.distances[0] as f32
    }

    fn direction(&self) -> Vec3<f32> {
        Vec3::default()
    }

    fn rise(&self, _: Vec3<f32>, _: <f32 as crate::number::Types>::Ramp) -> Carried<'a> {
        Carried::default()
    }

    fn cosine(&self, _: f32, _: Vec3<f32>) -> Carried<'a> {
        Carried::default()
    }

    fn range_share(&self, gain: f32) -> Carried<'a> {
        self.share(|distance| distance * f64::from(gain))
    }

    fn squared_range_share<O: Offset<f32>>(&self, _: &O, gain: f32) -> Carried<'a> {
        self.share(|distance| distance * distance * f64::from(gain))
    }

    fn light(&self, share: Carried<'a>, _: f32) -> f32 {
        let factors = self.factors(|distance| 1.0 / (distance * distance));
        share.lit_by(factors, self.0.stages.inverse_square)
    }

    fn light_by_polynomial(&self, share: Carried<'a>, coefficients: &[f32; 3], _: f32) -> f32 {
        let [constant, linear, quadratic] = coefficients.map(f64::from);
        let factors =
            self.factors(|distance| 1.0 / (constant + distance * (linear + distance * quadratic)).max(1.0));
        share.lit_by(factors, self.0.stages.inverse_polynomial)
    }

    fn light_by_decay(&self, share: Carried<'a>, power: InversePower, _: f32) -> f32 {
        let (k, most) = power.parts();
        let factors = self.factors(|distance| {
            let (base, inverts) = if distance < 1.0 { (1.0 / distance, false) } else { (distance, true) };
            let power = real_power(base, k);
            (if inverts { 1.0 / power } else { power }).min(most)
        });
        let [constant, growth] = self.0.stages.inverse_power;
        share.lit_by(factors, constant + growth * k)
    }
}
