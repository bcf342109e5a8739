//! Two soft falloffs in one, for a soft edge at both a beam and a field angle.

use core::fmt::{self, Formatter};

use super::{CompiledFalloff, Cubic, Falloff, Formula, Soft, choice::choice};
use crate::{
    error::{Error, Parameter},
    model::{Model as _, Number, model},
    number::{Fraction, Scalar},
    source::{Source, call, name},
    trig,
};

model! {
    /// Two soft falloffs about one axis, `(1 - k) t^2 + k w^2` with `w = max(0, 1 - g u)`: a wide one, and a
    /// narrow one that ends at `1/g` of the versine of the edge. Five multiplies.
    ///
    /// A light with this falloff equals two lights with the falloff [`Soft`]. Like `Soft` it fades out without
    /// a visible edge, and it does not rise towards the edge, because neither of the two does. In contrast to
    /// `Soft` it can have a field angle that is many times as wide as the beam angle:
    /// [`Cone::soft_from_beam_and_field`](crate::Cone::soft_from_beam_and_field).
    ///
    /// In haze of `f32` the sum of two beams has a closed form. Where haze is integrated by nodes (other laws than the
    /// inverse square, and 16 bits), a narrow falloff of a large ratio may be missed between them.
    SoftPair {
        /// Returns `k`, the share of the narrow falloff in the intensity on the axis, in [0, 1].
        share: f32 = Number::between(Parameter::NarrowShare, 0.0, 1.0, 0.375);
        /// Returns `g`, the versine of the edge divided by the versine at which the narrow falloff ends, in
        /// [1, 1024].
        ratio: f32 = Number::between(Parameter::NarrowRatio, 1.0, 1_024.0, 4.0).usually(1.0, 32.0);
    } by Self::new(share, ratio)
}

impl SoftPair {
    /// Creates the pair with this share and this ratio of the narrow falloff.
    ///
    /// # Errors
    /// A share outside [0, 1], or a ratio outside [1, 1024].
    pub fn new(share: f32, ratio: f32) -> Result<Self, Error> {
        Ok(Self { share: Self::NUMBERS[0].checked(share)?, ratio: Self::NUMBERS[1].checked(ratio)? })
    }

    /// Returns the `u` with this intensity, less than 1, without cancellation.
    ///
    /// Within the narrow falloff it is a root of `(1 - k + k g^2) u^2 - 2 (1 - k + k g) u = intensity - 1`, and
    /// outside of `(1 - k) (1 - u)^2 = intensity`.
    fn versine_of(self, intensity: f32) -> f32 {
        let Self { share: k, ratio: g } = self;
        let (rest, end) = (1.0 - k, 1.0 - 1.0 / g);
        if intensity < rest * end * end {
            return 1.0 - trig::sqrt(intensity / rest);
        }
        let (square, linear, lost) = (rest + k * g * g, rest + k * g, 1.0 - intensity);
        lost / (linear + trig::sqrt((linear * linear - square * lost).max(0.0)))
    }
}

/// A [`SoftPair`] in the format `S`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledSoftPair<S: Scalar> {
    share: S::Weight,
    ratio: S::Gain,
}

impl<S: Scalar> CompiledSoftPair<S> {
    /// Creates the pair from its share and its ratio, as [`codegen`](crate::codegen) writes it.
    pub const fn from_parts(share: S::Weight, ratio: S::Gain) -> Self {
        Self { share, ratio }
    }
}

impl<S: Scalar> Source for CompiledSoftPair<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledSoftPair::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.share, &self.ratio])
    }
}

impl<S: Scalar> From<SoftPair> for CompiledSoftPair<S> {
    fn from(pair: SoftPair) -> Self {
        Self { share: S::weight(pair.share), ratio: S::gain(pair.ratio) }
    }
}

impl Falloff for SoftPair {
    type Compiled<S: Scalar> = CompiledSoftPair<S>;

    fn formula(&self) -> Formula<'_> {
        Formula::SoftPair([self.share, self.ratio])
    }

    fn beam_versine(self) -> f32 {
        self.versine_of(0.5)
    }

    fn field_versine(self) -> f32 {
        self.versine_of(0.1)
    }

    /// Returns the maximum of `2 f'(t) sqrt(v) / (1 - h)` over the versine `v`, where `h` is the hotspot and
    /// `v = h + (1 - h) u`.
    ///
    /// Within the narrow falloff and outside of it, `f'` is `2 (a - b u)`. The maximum of each part is at an end, or
    /// where `v = (a (1 - h) / b + h) / 3`.
    fn steepness(self, hotspot: f32) -> f32 {
        let Self { share: k, ratio: g } = self;
        let (span, rest) = (1.0 - hotspot, 1.0 - k);
        let steepest = |a: f32, b: f32, [from, to]: [f32; 2]| {
            let [from, to] = [from, to].map(|u| hotspot + span * u);
            let v = ((a * span / b + hotspot) / 3.0).min(to).max(from);
            4.0 * (a - b * (v - hotspot) / span) * trig::sqrt(v) / span
        };
        let narrow = steepest(rest + k * g, rest + k * g * g, [0.0, 1.0 / g]);
        narrow.max(steepest(rest, rest, [1.0 / g, 1.0]))
    }

    fn integral(self, u: f32) -> f32 {
        let narrow = (u * self.ratio).min(1.0);
        (1.0 - self.share) * Soft.integral(u) + self.share * Soft.integral(narrow) / self.ratio
    }
}

impl<S: Scalar> CompiledFalloff<S> for CompiledSoftPair<S> {
    const IN_VECTORS: bool = true;

    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.soft_pair(self.share, self.ratio)
    }
}

choice! {
    /// The falloff with a soft edge for a beam and a field angle: see
    /// [`Cone::soft_from_beam_and_field`](crate::Cone::soft_from_beam_and_field).
    SoftEdged, CompiledSoftEdged {
        /// A cubic of edge slope 0, between smoothstep and soft.
        Cubic(Cubic),
        /// Two soft falloffs, for field angles that are wider.
        SoftPair(SoftPair),
    }
}
