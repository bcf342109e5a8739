//! Results, as bits and as exact numbers.

use luminaire::number::{Light16, Light32, Ramps};
use luminaire::{Fx16, Fx32, Scalar};

/// A result of a kernel.
pub trait Value: Copy {
    /// The unit in the last place of one.
    const STEP: f64;
    /// Its exact value.
    fn exact(self) -> f64;
    /// 32 bits that differ from those of its neighbours, for checksums.
    fn bits(self) -> u32;
}

/// A number format of the crate `luminaire`, whose results can be read.
pub trait Format: Scalar<Irradiance: Value> + Value {
    /// A word of a versine.
    fn versine_bits(versine: Self::Versine) -> u32;

    /// A word of a length.
    fn length_bits(length: Self::Length) -> u32;

    /// Whether [`bounds`](Self::bounds) visits inputs.
    const COUNTABLE: bool = false;

    /// Visits both ends of every interval of versines in which a ramp to an outer versine is
    /// constant, with their exact values. There the falloff is constant and the exact model is
    /// monotone, so the error is largest at one of the two ends.
    fn bounds(_outer: f32, _visit: &mut dyn FnMut(Self::Versine, f64)) {}
}

impl Value for f32 {
    const STEP: f64 = f32::EPSILON as f64;

    fn exact(self) -> f64 {
        self.into()
    }

    #[inline(always)]
    fn bits(self) -> u32 {
        self.to_bits()
    }
}

impl Value for f64 {
    const STEP: f64 = Self::EPSILON;

    fn exact(self) -> f64 {
        self
    }

    #[inline(always)]
    fn bits(self) -> u32 {
        (self.to_bits() >> 32) as u32 ^ self.to_bits() as u32
    }
}

/// A number with 16 bits below the point.
#[derive(Clone, Copy, Debug)]
pub struct Q16(pub i32);

impl Value for Q16 {
    const STEP: f64 = 1.0 / 65_536.0;

    fn exact(self) -> f64 {
        f64::from(self.0) * Self::STEP
    }

    #[inline(always)]
    fn bits(self) -> u32 {
        self.0.cast_unsigned()
    }
}

/// A grey of RGB565, whose value is that of its green channel.
#[derive(Clone, Copy, Debug)]
pub struct Green(pub u16);

impl Value for Green {
    const STEP: f64 = 1.0 / 63.0;

    fn exact(self) -> f64 {
        f64::from(self.0 >> 5 & 63) * Self::STEP
    }

    #[inline(always)]
    fn bits(self) -> u32 {
        self.0.into()
    }
}

macro_rules! fixed_value {
    ($type:ty, $step:literal, $fold:expr) => {
        impl Value for $type {
            const STEP: f64 = $step;

            fn exact(self) -> f64 {
                self.to_f64()
            }

            #[inline(always)]
            fn bits(self) -> u32 {
                $fold(self.to_bits())
            }
        }
    };
}

fixed_value!(Fx16, 6.103_515_625e-5, |bits| i32::from(bits).cast_unsigned());
fixed_value!(Light16, 6.103_515_625e-5, |bits: u32| bits);
fixed_value!(Fx32, 9.313_225_746_154_785e-10, i32::cast_unsigned);
fixed_value!(Light32, 9.313_225_746_154_785e-10, |bits: u64| (bits >> 32) as u32 ^ bits as u32);

/// The load of the empty loop: one word, whatever the width.
macro_rules! words {
    (|$value:ident| $versine:expr, $length:expr) => {
        #[inline(always)]
        fn versine_bits($value: Self::Versine) -> u32 {
            $versine
        }

        #[inline(always)]
        fn length_bits($value: Self::Length) -> u32 {
            $length
        }
    };
}

impl Format for f32 {
    words!(|value| value.to_bits(), value.to_bits());
}

impl Format for Fx32 {
    words!(|value| value.to_bits(), value.to_bits().cast_unsigned());
}

impl Format for Fx16 {
    words!(|value| value.to_bits(), value.to_bits().cast_unsigned());

    const COUNTABLE: bool = true;

    fn bounds(outer: f32, visit: &mut dyn FnMut(Self::Versine, f64)) {
        let ramp = Self::ramp(0.0, outer, outer);
        // Versines are magnified by a power of four that depends on the cone; of this one nothing
        // is lost.
        let known = 1.0 / 1_073_741_824.0;
        let unit = f64::from(known) / f64::from(Self::versine(ramp, known).to_bits());
        let versine = Self::Versine::from_bits;
        let rise = |bits| Self::rise(ramp, versine(bits));
        let edge = Self::versine(ramp, outer).to_bits();
        let mut first = 0;
        while first < edge {
            // The last versine of the level that begins here, by bisection: a ramp is monotone.
            let (mut last, mut beyond) = (first, edge);
            while beyond - last > 1 {
                let middle = last + (beyond - last) / 2;
                if rise(middle) == rise(first) {
                    last = middle;
                } else {
                    beyond = middle;
                }
            }
            for bits in [first, last] {
                visit(versine(bits), f64::from(bits) * unit);
            }
            first = last + 1;
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use std::vec::Vec;

    use super::*;

    #[test]
    fn the_bounds_are_the_ends_of_level_intervals_and_leave_no_versine_out() {
        let outer = 0.071_59;
        let ramp = Fx16::ramp(0.0, outer, outer);
        let mut ends = Vec::new();
        Fx16::bounds(outer, &mut |versine, exact| ends.push((versine.to_bits(), exact)));
        let edge = Fx16::versine(ramp, outer).to_bits();
        let mut next = 0;
        for pair in ends.chunks(2) {
            let [(first, exact), (last, _)] = pair else { panic!("an interval has two ends") };
            assert_eq!(*first, next, "an interval begins where the last has ended");
            assert!((exact - f64::from(outer) * f64::from(*first) / f64::from(edge)).abs() < 1e-8);
            let rise = |bits| Fx16::rise(ramp, luminaire::number::Versine::from_bits(bits));
            let step = ((last - first) / 16).max(1) as usize;
            assert!((*first..=*last).step_by(step).all(|bits| rise(bits) == rise(*first)), "it is level");
            next = last + 1;
        }
        assert_eq!(next, edge);
        assert!(ends.len() > 2 << 14, "a ramp of 15 bits has {} ends", ends.len());
    }
}
