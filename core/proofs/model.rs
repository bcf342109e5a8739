//! The operations of the stages, on integers or on the text of a script.

use core::ops::{Add, Mul, Sub};

use super::super::fx16;

/// An integer of an operation, or the expression of one.
pub(in crate::number) trait Number:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + From<i64>
{
    /// Returns the quotient by `2^bits`, rounded down.
    fn down(self, bits: u32) -> Self;
    /// Returns the quotient by a power of two, rounded down.
    fn divided(self, power: Self) -> Self;
    /// Names a result that must fit an unsigned word of 32 bits.
    fn word(self, name: &str) -> Self;
    /// Names a result that must fit a signed word of 32 bits.
    fn signed(self, name: &str) -> Self;
}

impl Number for i128 {
    fn down(self, bits: u32) -> Self {
        self >> bits
    }

    fn divided(self, power: Self) -> Self {
        self.div_euclid(power)
    }

    fn word(self, name: &str) -> Self {
        assert!(u32::try_from(self).is_ok(), "{name} is {self}, more than a word");
        self
    }

    fn signed(self, name: &str) -> Self {
        assert!(i32::try_from(self).is_ok(), "{name} is {self}, more than a word");
        self
    }
}

/// The constants of the stages that the proofs depend on.
#[derive(Clone, Copy, Debug)]
pub(in crate::number) struct Constants {
    /// Added to a reciprocal length before its lower two bits are dropped.
    pub(in crate::number) reciprocal_half: i64,
    /// Added to a direction, and to one of the quick evaluation.
    pub(in crate::number) cut_off: i64,
    pub(in crate::number) quick_cut_off: i64,
    /// Added to a difference of directions, in halves of its step.
    pub(in crate::number) difference_half: i64,
    /// Bits of the divisor's reciprocal that a ramp's mantissa drops, and the rounding of `t`.
    pub(in crate::number) mantissa_bits: u32,
    pub(in crate::number) ramp_half: i64,
    /// Added to a product of fractions that becomes a value, and to one that stays a fraction.
    pub(in crate::number) value_half: i64,
    pub(in crate::number) fraction_half: i64,
    /// Bits of an inner product that the cosine drops.
    pub(in crate::number) along: u32,
    /// Bits of a squared reciprocal length, and of its product with a gain, that the light drops.
    pub(in crate::number) squared: u32,
    pub(in crate::number) mantissa: u32,
    /// Added to a mantissa that is rounded, in halves of its step.
    pub(in crate::number) gain_half: i64,
    /// The coefficient of the square in the correction of a length, and its bits.
    pub(in crate::number) newton: i64,
    pub(in crate::number) newton_bits: u32,
    /// Bits that a fine excess has more than the squared length.
    pub(in crate::number) excess_bits: u32,
    /// Bits that an attenuated gain drops before its correction.
    pub(in crate::number) nearly_bits: u32,
}

impl Constants {
    pub(in crate::number) const KERNEL: Self = Self {
        reciprocal_half: 2,
        cut_off: fx16::CUT_OFF as i64,
        quick_cut_off: fx16::QUICK_CUT_OFF as i64,
        difference_half: 1,
        mantissa_bits: 16,
        ramp_half: 1 << 15,
        value_half: fx16::Fraction16::HALF as i64,
        fraction_half: fx16::Fraction16::HALF as i64 / 2,
        along: 13,
        squared: 16,
        mantissa: 14,
        gain_half: 1,
        newton: 3,
        newton_bits: 25,
        excess_bits: 3,
        nearly_bits: 17,
    };

    // ---- The coarse and the quick evaluation ----

    /// The upper bits of a reciprocal length.
    pub(in crate::number) fn fourteen_bits<N: Number>(&self, reciprocal: N) -> N {
        (reciprocal + N::from(self.reciprocal_half)).down(2)
    }

    /// A quotient to which `half` halves of a step are added before it is rounded down.
    pub(in crate::number) fn quotient<N: Number>(&self, value: N, step: N, half: i64) -> N {
        (value * N::from(2) + N::from(half) * step.clone()).divided(step * N::from(2))
    }

    /// A component of a difference of directions, in the scale of a ramp: dropped bits are rounded.
    pub(in crate::number) fn difference<N: Number>(&self, apart: N, step: N) -> N {
        self.quotient(apart, step, self.difference_half).signed("difference")
    }

    /// The mantissa of a ramp from that of its divisor, which is `2^63` divided by the divisor.
    ///
    /// `up` is a power of two: the bits by which a short span is scaled up.
    pub(in crate::number) fn ramp_mantissa<N: Number>(&self, fine_mantissa: N, up: N) -> N {
        // The kernel drops all but one of these bits, and rounds half of the rest up.
        let half = N::from(1 << (self.mantissa_bits - 1));
        (fine_mantissa * up + half).down(self.mantissa_bits).word("m")
    }

    /// The number from which a ramp subtracts, and what `t` is before its last bits are dropped.
    ///
    /// `step` is `2^shift`, and `excess` the shifted excess over the inner versine.
    pub(in crate::number) fn risen<N: Number>(&self, mantissa: N, step: N, excess: N, raised: N) -> N {
        let dropped = mantissa.clone().divided(step).word("dropped");
        let less = (mantissa.clone() - dropped).down(1).word("less");
        let one = (N::from((1 << 31) + self.ramp_half) - less + raised).word("one");
        one - excess * mantissa
    }

    pub(in crate::number) fn times<N: Number>(&self, a: N, b: N) -> N {
        ((a * b).word("product") + N::from(self.fraction_half)).word("sum").down(15).word("fraction")
    }

    pub(in crate::number) fn times_to_value<N: Number>(&self, a: N, b: N) -> N {
        ((a * b).word("product") + N::from(self.value_half)).word("sum").down(16).word("value")
    }

    /// The product of two shares.
    pub(in crate::number) fn share_of<N: Number>(&self, a: N, b: N) -> N {
        ((a * b).word("shares") + N::from(1 << 13)).down(14).word("share_of")
    }

    pub(in crate::number) fn value<N: Number>(&self, t: N) -> N {
        (t + N::from(1)).down(1).word("value")
    }

    pub(in crate::number) fn smooth<N: Number>(&self, t: N) -> N {
        let product = self.times(t.clone(), t.clone()) * (N::from(3 << 15) - N::from(2) * t);
        (product.word("cubic") + N::from(self.value_half)).word("rounded").down(16).word("value")
    }

    /// `t (1 + u g)` before the cap, of a fraction and its complement.
    pub(in crate::number) fn quadratic<N: Number>(&self, t: N, u: N, g: N) -> N {
        let lift = ((u * g).signed("slope") + N::from(1 << 13)).signed("slope_half").down(14).signed("lift");
        let lifted = (t * (N::from(1 << 15) + lift)).word("lifted");
        (lifted + N::from(self.value_half)).word("rounded").down(16).word("value")
    }

    /// The sum of a cubic's coefficients at `t`.
    pub(in crate::number) fn bend<N: Number>(&self, t: N, g: N, h: N) -> N {
        g + ((t * h).signed("turn") + N::from(1 << 14)).signed("turn_half").down(15).signed("bent")
    }

    /// `1 - w` of the narrow one of two soft falloffs, before the cap, for a power of two `step`.
    pub(in crate::number) fn narrow<N: Number>(&self, u: N, mantissa: N, step: N) -> N {
        ((u * mantissa).word("scaled") + (step.clone() - N::from(1))).word("up").divided(step)
    }

    /// Two soft falloffs: a wide one of `t`, and a narrow one with a share of 14 bits.
    pub(in crate::number) fn pair<N: Number>(&self, t: N, narrow: N, share: N) -> N {
        let [narrow, wide] = [narrow, t].map(|t| self.times(t.clone(), t));
        let narrow = (narrow * share.clone()).signed("narrow_part");
        let wide = (wide * (N::from(1 << 14) - share)).signed("wide_part");
        ((narrow + wide).signed("both") * N::from(2) + N::from(self.value_half))
            .word("rounded")
            .down(16)
            .word("value")
    }

    /// The interpolation of two samples, and the value of 14 bits of one of 16.
    pub(in crate::number) fn interpolated<N: Number>(&self, here: N, step: N, share: N) -> N {
        (here * N::from(1 << 15) + step * share + N::from(1 << 14)).signed("line").down(15).word("value")
    }

    pub(in crate::number) fn of_sixteen_bits<N: Number>(&self, value: N) -> N {
        (value.clone() + value.down(15) + N::from(2)).down(2)
    }

    /// A component of a direction, of which 14 fraction bits are multiplied by a normal.
    pub(in crate::number) fn rounded_component<N: Number>(&self, direction: N) -> N {
        (direction + N::from(1 << 15)).down(16)
    }

    /// The cosine of light that has the same direction everywhere, before the cap, of an inner product with
    /// `bits` bits more than it, and with the opposite sign.
    pub(in crate::number) fn incidence<N: Number>(&self, along: N, bits: u32) -> N {
        (N::from(1 << (bits - 1)) - along).down(bits)
    }

    /// The power of a fraction from that with 16 bits more.
    pub(in crate::number) fn power<N: Number>(&self, power: N) -> N {
        (power + N::from(1 << 15)).word("raised").down(16)
    }

    /// The cosine, before the cap, of an inner product with the opposite sign.
    pub(in crate::number) fn cosine<N: Number>(&self, facing: N, reciprocal: N) -> N {
        let along = facing.signed("facing").down(self.along).word("along");
        (along * reciprocal).word("product").down(16).word("cosine")
    }

    /// The square of a reciprocal length, and the gain at the distance.
    pub(in crate::number) fn squared_reciprocal<N: Number>(&self, reciprocal: N) -> N {
        (reciprocal.clone() * reciprocal).word("whole").down(self.squared).word("squared")
    }

    pub(in crate::number) fn attenuated<N: Number>(&self, gain: N, squared: N) -> N {
        (gain * squared).word("given").down(self.mantissa).word("mantissa")
    }

    /// The upper 16 bits of a mantissa of 32, rounded.
    pub(in crate::number) fn normalised<N: Number>(&self, mantissa: N) -> N {
        (mantissa * N::from(2) + N::from(self.gain_half << 16)).down(17).word("rounded")
    }

    // ---- The fine evaluation ----

    /// The excess of a length over 1 from that of its square.
    pub(in crate::number) fn excess<N: Number>(&self, over: N) -> N {
        let coarse = over.clone().down(4).signed("coarse");
        let square = (coarse.clone() * coarse).signed("square");
        let curved = (N::from(self.newton) * square).signed("thrice").down(self.newton_bits).signed("curved");
        let straight = over.down(self.excess_bits).signed("straight");
        (straight - curved).signed("excess")
    }

    /// A component of a vector, less its excess.
    pub(in crate::number) fn corrected<N: Number>(&self, component: N, excess: N) -> N {
        let much = (component.clone() * (excess * N::from(1 << 16)).signed("much")).down(32).signed("part");
        component - much.down(10).signed("less")
    }

    /// The upper half of a square, of which a versine adds three.
    pub(in crate::number) fn high_square<N: Number>(&self, part: N) -> N {
        (part.clone() * part).down(32).word("upper")
    }

    /// `1 - t` at an excess that is scaled up to the bits of the span, and `1 - t` without `step` bits.
    pub(in crate::number) fn fallen<N: Number>(&self, excess: N, reciprocal: N, step: N) -> N {
        (excess * reciprocal).down(32).word("upper").divided(step).word("fallen")
    }

    /// The product of two fractions of 31 bits.
    pub(in crate::number) fn fine_times<N: Number>(&self, a: N, b: N) -> N {
        ((a * b).down(32).word("upper") * N::from(2)).word("fraction")
    }

    /// `t^2 (3 - 2 t)` of a fraction and its complement, before the cap.
    pub(in crate::number) fn fine_smooth<N: Number>(&self, t: N, u: N) -> N {
        let square = self.fine_times(t.clone(), t);
        square.clone() + N::from(2) * self.fine_times(square, u)
    }

    /// `1 - w` of the narrow one of two soft falloffs, for a `u` that is scaled to the bits of the mantissa.
    pub(in crate::number) fn fine_narrow<N: Number>(&self, scaled: N, mantissa: N) -> N {
        (scaled.word("scaled") * mantissa).down(32).word("upper") * N::from(2)
    }

    /// Two soft falloffs: a wide one of `t`, and a narrow one with a share of 31 bits.
    pub(in crate::number) fn fine_pair<N: Number>(&self, t: N, narrow: N, share: N) -> N {
        let rest = N::from(1 << 31) - share.clone();
        let [narrow, wide] = [(narrow, share), (t, rest)]
            .map(|(t, share)| self.fine_times(self.fine_times(t.clone(), t), share));
        narrow + wide
    }

    /// `t u slope`, with 31 fraction bits, of a slope with 28.
    pub(in crate::number) fn lift<N: Number>(&self, t: N, u: N, slope: N) -> N {
        (self.fine_times(t, u) * slope).down(32).word("lift") * N::from(16)
    }

    /// A sample and a share of the step to the next one, which is smaller if it `falls`, as a fraction.
    pub(in crate::number) fn fine_sample<N: Number>(&self, here: N, step: N, share: N, falls: bool) -> N {
        let (start, step) = ((here * N::from(1 << 15)).word("start"), (share * step).down(16).word("step"));
        self.fine_value(if falls { start - step } else { start + step })
    }

    /// A sample with 15 fraction bits more, as a fraction.
    pub(in crate::number) fn fine_value<N: Number>(&self, value: N) -> N {
        value.clone() + (value + N::from(1 << 15)).down(16).word("part")
    }

    /// A component of the cosine of a direction and a normal of 14 bits, with 30 fraction bits.
    pub(in crate::number) fn fine_component<N: Number>(&self, direction: N, normal: N) -> N {
        (direction * normal).down(14).signed("component")
    }

    /// A component of the cosine of a direction and a normal of 30 bits, with 27 fraction bits.
    pub(in crate::number) fn finest_component<N: Number>(&self, direction: N, normal: N) -> N {
        (direction * normal.down(1).signed("halved")).down(32).signed("component")
    }

    /// The gain at a distance, of an estimate of its reciprocal and the excess of the estimate.
    pub(in crate::number) fn finely_attenuated<N: Number>(&self, gain: N, estimate: N, excess: N) -> N {
        let once = (gain * estimate.clone()).down(16).word("once");
        let nearly = (once * estimate).down(16).word("nearly");
        let squared = (excess.clone() * excess.clone()).signed("excess_squared").down(26).signed("second");
        let twice = (N::from(2) * excess - squared).signed("twice");
        let upper = nearly.clone().down(self.nearly_bits).signed("upper_bits");
        nearly - (upper * twice).signed("product").down(9).signed("less")
    }

    /// The length of an offset, from its square, an estimate of its reciprocal, and the excess.
    pub(in crate::number) fn length<N: Number>(&self, squared: N, estimate: N, excess: N) -> N {
        let less = (estimate.clone() * excess).signed("whole").down(11).signed("less");
        let reciprocal = (estimate * N::from(1 << 15) - less).word("reciprocal");
        ((squared * reciprocal).down(32).word("eighth") * N::from(8)).word("length")
    }
}
