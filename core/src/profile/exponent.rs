//! The profile nearest to a power of a real exponent.
//!
//! An importer asks for it once per light. The power itself is taken by squarings and square roots, one for
//! each binary digit of its exponent, in f64, so that the difference that is found is that of the profile and
//! not of the search.

use super::{Cubic, Matched, MixedPower, MixedRim, cubic::middle_slopes, integer::raised, mixed::Mixture};
use crate::{
    search::{least_at, maximum},
    trig,
};

/// How near to zero a power is looked at: what f32 tells from the edge of a cone.
const NEAREST: f64 = 1.0 / 16_777_216.0;

/// The larger exponents that a line or a square is mixed with to stand for a root.
const HIGH: [u32; 12] = [3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128];

/// `max(x, floor)^exponent` for `x` from `least` to 1.
#[derive(Clone, Copy)]
pub(crate) struct RealPower {
    pub(crate) exponent: f32,
    pub(crate) least: f32,
    pub(crate) floor: f32,
}

/// What stands for a real power of `x`.
#[derive(Clone, Copy)]
enum Stand {
    /// The integer power itself.
    Power(u32),
    /// A mixture of powers of `x`.
    Mixed(Mixture),
    /// One less a mixture of powers of `1 - x`: the infinite slope of a root is that of a high power.
    Mirrored(Mixture),
    Cubic(Cubic),
}

impl Stand {
    fn value(self, x: f64) -> f64 {
        match self {
            Self::Power(exponent) => raised(x, exponent),
            Self::Mixed(mixture) => mixture.value(x),
            Self::Mirrored(mixture) => 1.0 - mixture.value(1.0 - x),
            Self::Cubic(cubic) => {
                let [a, b, c] = cubic.coefficients().map(f64::from);
                x * (a + x * (b + x * c))
            }
        }
    }
}

/// The profile nearest to `t^exponent`, and the largest difference between the two.
pub(crate) fn power(target: RealPower) -> (Matched, f64) {
    let (stand, difference) = target.nearest(true);
    let profile = match stand {
        Stand::Power(exponent) => Matched::power(exponent),
        Stand::Mixed(mixture) => Matched::MixedPower(MixedPower::of(mixture)),
        Stand::Mirrored(mixture) => Matched::MixedRim(MixedRim::of(mixture)),
        Stand::Cubic(cubic) => Matched::Cubic(cubic),
    };
    (profile, difference)
}

/// The profile nearest to `1 - u^exponent`, and the largest difference between the two. Without a jump on the
/// axis.
pub(crate) fn rim(target: RealPower) -> (Matched, f64) {
    let (stand, difference) = target.nearest(false);
    let profile = match stand {
        Stand::Power(exponent) => Matched::rim(exponent),
        Stand::Mixed(mixture) => Matched::MixedRim(MixedRim::of(mixture)),
        Stand::Mirrored(mixture) => Matched::MixedPower(MixedPower::of(mixture)),
        Stand::Cubic(cubic) => Matched::Cubic(cubic.mirrored()),
    };
    (profile, difference)
}

impl RealPower {
    fn value(self, x: f64) -> f64 {
        real_power(x.max(self.floor.into()), self.exponent.into())
    }

    /// What is nearest, and its largest difference. `jumps` allows a share of `x^0`, which jumps at 0.
    fn nearest(self, jumps: bool) -> (Stand, f64) {
        let whole = self.exponent as u32;
        if whole as f32 == self.exponent {
            let stand = Stand::Power(whole);
            return (stand, if self.floor > 0.0 { self.difference(stand) } else { 0.0 });
        }
        let samples = self.samples();
        let mut best = (Stand::Power(whole.max(1)), f64::INFINITY);
        let mut try_mixture = |low, high, stand: fn(Mixture) -> Stand, mirrored| {
            let (share, worst) = nearest_share(&samples, low, high, mirrored);
            if worst < best.1 {
                best = (stand(Mixture { low, high, share }), worst);
            }
        };
        if whole > 0 || jumps {
            try_mixture(whole, whole + 1, Stand::Mixed, false);
        }
        if whole == 0 {
            for high in HIGH {
                try_mixture(1, high, Stand::Mirrored, true);
                try_mixture(2, high, Stand::Mirrored, true);
            }
        }
        if whole < 4 {
            let (cubic, worst) = nearest_cubic(&samples);
            if worst < best.1 {
                best = (Stand::Cubic(cubic), worst);
            }
        }
        (best.0, self.difference(best.0))
    }

    /// The largest difference between the power and what stands for it.
    fn difference(self, stand: Stand) -> f64 {
        maximum(0.0, 1.0, |place| {
            let x = self.at(place);
            (stand.value(x) - self.value(x)).abs()
        })
    }

    /// Places from 0 to 1, taken to the interval of `x` and crowded at both of its ends, where powers bend.
    fn at(self, place: f64) -> f64 {
        let least = f64::from(self.least).max(NEAREST);
        let (near, far) = (raised(place, 4), raised(1.0 - place, 4));
        least + (1.0 - least) * near / (near + far)
    }

    fn samples(self) -> [Sample; SAMPLES] {
        core::array::from_fn(|i| {
            let x = self.at(i as f64 / (SAMPLES - 1) as f64);
            Sample { x, value: self.value(x) }
        })
    }
}

/// How many places the search looks at.
const SAMPLES: usize = 129;

#[derive(Clone, Copy)]
struct Sample {
    x: f64,
    value: f64,
}

/// The share of the larger of two exponents that comes nearest to the samples, and its largest difference.
fn nearest_share(samples: &[Sample; SAMPLES], low: u32, high: u32, mirrored: bool) -> (f32, f64) {
    let powers = samples.map(|Sample { x, value }| {
        let (x, value) = if mirrored { (1.0 - x, 1.0 - value) } else { (x, value) };
        (raised(x, low), raised(x, high), value)
    });
    let worst = |share: f64| {
        powers.iter().map(|(low, high, value)| (low + (high - low) * share - value).abs()).fold(0.0, f64::max)
    };
    let share = least_at(0.0, 1.0, worst) as f32;
    (share, worst(share.into()))
}

/// The monotone cubic that comes nearest to the samples, and its largest difference: the difference is convex
/// in both slopes, so that one search within another finds it.
fn nearest_cubic(samples: &[Sample; SAMPLES]) -> (Cubic, f64) {
    let worst = |a: f64, d: f64| {
        let cubic = |x: f64| x * (1.0 + (1.0 - x) * (a - 1.0 + (2.0 - a - d) * x));
        samples.iter().map(|sample| (cubic(sample.x) - sample.value).abs()).fold(0.0, f64::max)
    };
    let best_middle = |edge: f64| {
        let (least, most) = middle_slopes(edge as f32);
        least_at(least.into(), most.into(), |middle| worst(edge, middle))
    };
    let edge = least_at(0.0, 4.0, |edge| worst(edge, best_middle(edge)));
    let middle = best_middle(edge);
    (Cubic::nearest(edge as f32, middle as f32), worst(edge, middle))
}

/// A positive number to the power of a real exponent from 0 up, relative error under 1e-9: squarings for what
/// is before the binary point of the exponent, square roots for what is behind it. Set-up only.
pub(crate) fn real_power(base: f64, exponent: f64) -> f64 {
    let whole = exponent as u32;
    let mut power = 1.0;
    for digit in (0..32 - whole.leading_zeros()).rev() {
        power *= power;
        if whole >> digit & 1 == 1 {
            power *= base;
        }
    }
    let (mut root, mut rest) = (base, exponent - f64::from(whole));
    for _ in 0..40 {
        root = square_root(root);
        rest *= 2.0;
        if rest >= 1.0 {
            power *= root;
            rest -= 1.0;
        }
    }
    power
}

/// The square root in f64: that of f32, and a step of Newton's method.
fn square_root(x: f64) -> f64 {
    let root = f64::from(trig::sqrt(x as f32));
    (root + x / root) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    extern crate std;

    #[test]
    fn real_powers_keep_their_stated_error() {
        let worst = (1..400_u16)
            .flat_map(|i| (0..200_u16).map(move |j| (f64::from(i) / 13.0, f64::from(j) / 17.3)))
            .map(|(base, exponent)| (real_power(base, exponent) / base.powf(exponent) - 1.0).abs())
            .fold(0.0, f64::max);
        assert!((1e-14..=1e-9).contains(&worst), "largest relative error {worst:.2e}");
    }
}
