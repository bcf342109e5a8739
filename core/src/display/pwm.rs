//! Duties of LEDs, whose mean light is in proportion to the duty of their pulses.

use super::level;
use crate::number::Scalar;

/// A pulse-width output of `BITS` bits, 1 to 16, such as a timer's channel or an LED driver.
///
/// A LED is linear: half of full scale is half of the duty. A gamma curve on the way would be
/// applied twice, because light in this crate is linear.
///
/// ```
/// use luminaire::{Fx16, display::{Pwm, Pwm8, Pwm12}};
/// let light = Fx16::from_f32(0.2);
/// assert_eq!((Pwm8::duty(light), Pwm12::duty(light), Pwm::<10>::duty(light)), (51, 819, 205));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Pwm<const BITS: u32> {}

/// An output of eight bits.
pub type Pwm8 = Pwm<8>;
/// An output of ten bits.
pub type Pwm10 = Pwm<10>;
/// An output of twelve bits.
pub type Pwm12 = Pwm<12>;
/// An output of 16 bits.
pub type Pwm16 = Pwm<16>;

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
        level::nearest(light.word(), Self::LAST.count_ones())
    }
}

/// Temporal dither of one LED: the fraction of a duty is carried from frame to frame, so that the
/// mean of the duties is the light (a first-order sigma-delta modulator).
///
/// After any number of frames, the sum of the duties differs from the sum of `LAST * light` by less
/// than 1. So no light is too faint: it lights the LED once in a while. In `Fx16` nothing is
/// rounded; in the other formats a value counts as at most 2^-13 above itself, in steps of a duty.
///
/// The duties of constant light are the two around it, and repeat after at most 2^14 frames in
/// `Fx16`, and 2^16 in the other formats. Of two lights in the same state, the brighter never has
/// the lower duty.
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
    /// Creates the state of the LED of an index.
    ///
    /// The index determines the phase, so that LEDs of equal light do not flash together: the phases
    /// of any consecutive indices are spread evenly (multiples of the golden ratio).
    pub const fn new(index: u16) -> Self {
        Self { carry: index.wrapping_mul(40_503) }
    }

    /// Returns the duty of the next frame.
    #[inline]
    pub fn next<S: Scalar>(&mut self, light: S) -> u16 {
        let bits = Pwm::<BITS>::LAST.count_ones();
        // At most 2^32 - 1: the largest product is (2^16 - 1) * 2^16.
        let sum = level::fine(light.word(), bits) + u32::from(self.carry);
        self.carry = sum as u16;
        (sum >> 16) as u16
    }
}
