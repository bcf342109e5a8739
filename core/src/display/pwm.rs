//! Duties of LEDs: linear codes, by a multiplication with the last code.

use crate::number::{Scalar, Word, float::clamp};

/// A pulse-width output of `BITS` bits, 1 to 16, such as a timer's channel or an LED driver.
///
/// ```
/// use luminaire::{Fx16, display::{Pwm, Pwm8}};
/// let light = Fx16::from_f32(0.2);
/// assert_eq!((Pwm8::duty(light), Pwm::<12>::duty(light)), (51, 819));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Pwm<const BITS: u32> {}

/// A pulse-width output of eight bits.
pub type Pwm8 = Pwm<8>;

impl<const BITS: u32> Pwm<BITS> {
    /// The last duty, `2^BITS - 1`: full scale.
    pub const LAST: u16 = {
        assert!(BITS >= 1 && BITS <= 16, "expected 1 to 16 bits");
        u16::MAX >> (16 - BITS)
    };

    /// Returns the duty nearest to linear light: the exact `LAST * light`, rounded to nearest, ties
    /// up, for every value of every format.
    ///
    /// The duty is 0 for light up to 0 and NaN, and `LAST` for light from 1 on.
    #[inline]
    pub fn duty<S: Scalar>(light: S) -> u16 {
        nearest(light.word(), Self::LAST.count_ones())
    }
}

/// Temporal dither of one LED: carries the fraction of a duty from frame to frame, so that the mean of
/// the duties is the light (a first-order sigma-delta modulator).
///
/// After any number of frames, the sum of the duties differs from the sum of `LAST * light` by less
/// than 1. So the faintest light lights the LED once in a while. In `Fx16` nothing is rounded; in the
/// other formats each value is first rounded up, by at most 2^-13 of a step.
///
/// The duties of constant light are the two around it, and repeat after at most 2^14 frames in
/// `Fx16`, 2^16 in the other formats. In equal states a brighter light has no lower duty.
///
/// ```
/// use luminaire::{Fx16, display::TemporalDither};
/// let mut led = TemporalDither::<8>::new(0);
/// let light = Fx16::from_f32(0.5); // 127.5 of 255
/// assert_eq!([(); 4].map(|()| led.next(light)), [127, 128, 127, 128]);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct TemporalDither<const BITS: u32> {
    /// What the duties so far are short of, in steps of 2^-16.
    carry: u16,
}

impl<const BITS: u32> TemporalDither<BITS> {
    /// Creates the state of the LED of an index, which determines the phase: neighbours do not flash
    /// together, because phases of consecutive indices are multiples of the golden ratio.
    pub const fn new(index: u16) -> Self {
        Self { carry: index.wrapping_mul(40_503) }
    }

    /// Returns the duty of the next frame.
    #[inline]
    pub fn next<S: Scalar>(&mut self, light: S) -> u16 {
        self.next_dimmed(light, FULL)
    }

    /// Returns the duty of the next frame for light times a factor, at most [`FULL`].
    #[inline]
    pub(super) fn next_dimmed<S: Scalar>(&mut self, light: S, factor: u32) -> u16 {
        self.next_fine(dimmed(fine(light.word(), Pwm::<BITS>::LAST.count_ones()), factor))
    }

    /// Returns the duty of the next frame for light in units of 2^-16 of a duty, at most `LAST` of them.
    #[inline]
    pub(super) fn next_fine(&mut self, light: u32) -> u16 {
        // At most 2^32 - 1: the largest product is (2^16 - 1) * 2^16.
        let sum = light + u32::from(self.carry);
        self.carry = sum as u16;
        (sum >> 16) as u16
    }
}

/// Returns light times a factor, at most [`FULL`], rounded down.
#[inline]
pub(super) fn dimmed(light: u32, factor: u32) -> u32 {
    if factor == FULL { light } else { ((u64::from(light) * u64::from(factor)) >> 16) as u32 }
}

/// The factor 1, in units of 2^-16.
pub(super) const FULL: u32 = 1 << 16;

/// Returns a linear value clamped to `[0, 1]` times `2^bits - 1`, rounded to nearest, ties up, for up
/// to 16 bits.
#[inline]
pub(super) fn nearest(linear: Word, bits: u32) -> u16 {
    match linear {
        Word::Single(linear) => {
            let value = clamp(linear);
            // Exact, as a product with a power of two. The code is this one or, because the value
            // times `2^bits - 1` is `scaled - value`, the one below. The difference is exact
            // (Sterbenz's lemma, and by its bits for code 1), so the comparison does not round.
            let scaled = value * (1_u32 << bits) as f32;
            let code = (scaled + 0.5) as u32;
            let is_below = scaled - (code as f32 - 0.5) < value;
            code.saturating_sub(is_below.into()) as u16
        }
        #[cfg(feature = "fixed")]
        Word::Steps14(linear) => {
            let linear = u32::from(linear.clamp(0, 1 << 14) as u16);
            (((linear << bits) - linear + (1 << 13)) >> 14) as u16
        }
        #[cfg(feature = "fixed")]
        Word::Steps30(linear) => {
            let linear = u64::from(linear.clamp(0, 1 << 30) as u32);
            (((linear << bits) - linear + (1 << 29)) >> 30) as u16
        }
    }
}

/// Returns a linear value clamped to `[0, 1]` times `2^bits - 1`, in units of 2^-16: exact for values
/// in units of 2^-14, else rounded up, so that only zero becomes zero.
#[inline]
pub(super) fn fine(linear: Word, bits: u32) -> u32 {
    #[cfg(feature = "fixed")]
    if let Word::Steps14(_) = linear {
        // 32 bits suffice.
        let steps = rounded_up::<14>(linear);
        return ((steps << bits) - steps) << 2;
    }
    let steps = u64::from(rounded_up::<30>(linear));
    (((steps << bits) - steps + 0x3fff) >> 14) as u32
}

/// Returns a linear value clamped to `[0, 1]` in units of `2^-FRACTION`, rounded up, for 14 to 30 fraction bits.
#[inline]
pub(super) fn rounded_up<const FRACTION: u32>(linear: Word) -> u32 {
    match linear {
        Word::Single(linear) => {
            let steps = clamp(linear) * (1_u32 << FRACTION) as f32;
            let whole = steps as u32;
            whole + u32::from((whole as f32) < steps)
        }
        #[cfg(feature = "fixed")]
        Word::Steps14(linear) => u32::from(linear.clamp(0, 1 << 14) as u16) << (FRACTION - 14),
        #[cfg(feature = "fixed")]
        Word::Steps30(linear) => (linear.clamp(0, 1 << 30) as u32).div_ceil(1 << (30 - FRACTION)),
    }
}
