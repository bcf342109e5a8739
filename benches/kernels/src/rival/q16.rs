//! Fixed point with 16 bits below the point, as most people write it: the formula of a shader with a root
//! and divisions.

use fixed::types::I16F16;
use luminaire::Fx16;

use super::values::{AT, axis, lit, nearest};
use crate::{scene::INTENSITY, value::Q16};

/// The axis in steps of 2^-16.
const AXIS: [i32; 3] = axis(65_536.0);

/// The light's brightness at a distance of 1.
const BRIGHT: i32 = INTENSITY as i32 * 65_536;

/// What the three lights have in common: the outer cosine and the reciprocal of the outer versine.
#[derive(Clone, Copy, Debug)]
struct Cone {
    outer: i32,
    reciprocal: i32,
}

impl Cone {
    const fn new(outer: f32) -> Self {
        let outer = outer as f64;
        Self { outer: nearest(65_536.0 * (1.0 - outer)), reciprocal: nearest(65_536.0 / outer) }
    }
}

fn way(point: [i32; 3]) -> [i32; 3] {
    [0, 1, 2].map(|i| point[i].wrapping_sub(AT[i]))
}

/// A product, rounded to nearest.
#[inline(always)]
fn times(a: i32, b: i32) -> i32 {
    ((i64::from(a) * i64::from(b) + 0x8000) >> 16) as i32
}

/// Declares a light whose `root` and `over` differ.
macro_rules! by_operations {
    ($(#[$doc:meta])* $name:ident: $length:ident, $over:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct $name(Cone);

        impl $name {
            pub(crate) const fn new(outer: f32) -> Self {
                Self(Cone::new(outer))
            }

            #[inline(always)]
            fn at(&self, point: [i32; 3], normal: [i16; 3]) -> Q16 {
                let way = way(point);
                let length = $length(way);
                if length <= 0 {
                    return Q16(0);
                }
                let (mut facing, mut cosine) = (0_i32, 0_i32);
                for i in 0..3 {
                    let unit = $over(way[i], length);
                    facing = facing.wrapping_sub(times(unit, i32::from(normal[i]) << 2));
                    cosine = cosine.wrapping_add(times(unit, AXIS[i]));
                }
                let t = times(cosine.wrapping_sub(self.0.outer), self.0.reciprocal);
                if facing <= 0 || t <= 0 {
                    return Q16(0);
                }
                let share = times(times(t, t), facing);
                Q16($over(times(share, BRIGHT), times(length, length)))
            }
        }

        lit!($name: Fx16 => Q16);
    };
}

by_operations! {
    /// Products and quotients of 64 bits, and a root by binary digits.
    Digits: digits, quotient
}

by_operations! {
    /// The root and the division of libfixmath, which take no 64-bit division.
    Fixmath: fixmath_length, fixmath_quotient
}

/// The length, by the binary digits of the root of 64 bits.
fn digits(way: [i32; 3]) -> i32 {
    let mut rest = way.iter().fold(0, |sum: u64, c| sum + i64::from(*c).pow(2).cast_unsigned());
    let (mut root, mut bit) = (0, 1 << 62);
    while bit > rest {
        bit >>= 2;
    }
    while bit != 0 {
        if rest >= root + bit {
            rest -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
        bit >>= 2;
    }
    root as i32
}

fn quotient(a: i32, b: i32) -> i32 {
    (i64::from(a) << 16).checked_div(b.into()).unwrap_or_default() as i32
}

/// The root of the rounded squares: 16 bits of the root, then 8 more, in words of 32 bits.
fn fixmath_length(way: [i32; 3]) -> i32 {
    let squared = way.iter().fold(0, |sum: i32, c| sum.wrapping_add(times(*c, *c)));
    let (mut rest, mut root) = (squared.unsigned_abs(), 0_u32);
    let mut bit = if rest >> 20 == 0 { 1 << 18 } else { 1 << 30 };
    while bit > rest {
        bit >>= 2;
    }
    for is_second in [false, true] {
        while bit != 0 {
            if rest >= root + bit {
                rest -= root + bit;
                root = (root >> 1) + bit;
            } else {
                root >>= 1;
            }
            bit >>= 2;
        }
        if !is_second {
            // A rest that cannot be shifted by 16 bits has the first of the next bits taken from it.
            let half = if rest > 0xffff { 0x8000 } else { 0 };
            rest = ((rest - if half > 0 { root } else { 0 }) << 16).wrapping_sub(half);
            root = (root << 16) + half;
            bit = 1 << 14;
        }
    }
    (root + u32::from(rest > root)).cast_signed()
}

/// The rounded quotient by divisions of 32 bits, each as far as the rest has room.
fn fixmath_quotient(a: i32, b: i32) -> i32 {
    let (mut rest, mut divider) = (a.unsigned_abs(), b.unsigned_abs());
    if divider == 0 {
        return i32::MIN;
    }
    let (mut quotient, mut bits) = (0_u32, 17);
    if divider >> 20 != 0 {
        quotient = rest / ((divider >> 17) + 1);
        rest = rest.wrapping_sub(((u64::from(quotient) * u64::from(divider)) >> 17) as u32);
    }
    while divider & 15 == 0 && bits >= 4 {
        divider >>= 4;
        bits -= 4;
    }
    while rest != 0 && bits >= 0 {
        let room = (rest.leading_zeros() as i32).min(bits);
        rest <<= room;
        bits -= room;
        quotient = quotient.wrapping_add((rest / divider) << bits);
        rest = (rest % divider) << 1;
        bits -= 1;
    }
    let rounded = (quotient.wrapping_add(1) >> 1).cast_signed();
    if a ^ b < 0 { rounded.wrapping_neg() } else { rounded }
}

/// The types of the crate `fixed`, and the root of the crate `cordic`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cordic(Cone);

impl Cordic {
    pub(crate) const fn new(outer: f32) -> Self {
        Self(Cone::new(outer))
    }

    #[inline(always)]
    fn at(&self, point: [i32; 3], normal: [i16; 3]) -> Q16 {
        let way = way(point).map(I16F16::from_bits);
        let normal = normal.map(|c| I16F16::from_bits(i32::from(c) << 2));
        let dot = |a: [I16F16; 3], b: [I16F16; 3]| {
            a[0].wrapping_mul(b[0])
                .wrapping_add(a[1].wrapping_mul(b[1]))
                .wrapping_add(a[2].wrapping_mul(b[2]))
        };
        let squared = dot(way, way);
        // The crate's root does not end for a negative number, nor where a square overflows.
        if squared <= 0 || squared >= 16_384 {
            return Q16(0);
        }
        let length = cordic::sqrt(squared);
        let unit = way.map(|c| c.wrapping_div(length));
        let facing = -dot(unit, normal);
        let Cone { outer, reciprocal } = self.0;
        let above = dot(unit, AXIS.map(I16F16::from_bits)) - I16F16::from_bits(outer);
        let t = above.wrapping_mul(I16F16::from_bits(reciprocal));
        if facing <= 0 || t <= 0 {
            return Q16(0);
        }
        let share = t.wrapping_mul(t).wrapping_mul(facing);
        Q16(share.wrapping_mul(I16F16::from_bits(BRIGHT)).wrapping_div(squared).to_bits())
    }
}

lit!(Cordic: Fx16 => Q16);
