//! Fixed point by hand for a Cortex-M0: products of 16 bits, a root by a table, two early-outs.
//!
//! The offset is cut to 15 bits, whatever the distance. Roots are those of its squared length, at most one
//! table step of which the chord errs; components of unit vectors have 14 bits, and light is in steps of 2^-14.

use luminaire::{Fx16, number::Light16};

use super::values::{AT, axis, lit, nearest, root};

/// Bytes of the tables of both lights.
pub(crate) const TABLES: usize = size_of_val(&ROOTS) + size_of_val(&SHIFTS);

/// The axis in steps of 2^-14.
const AXIS: [i32; 3] = axis(16_384.0);

/// `2^18 / sqrt(k)`, minus half of the chord's error, from the smallest `k` of 15 bits on.
static ROOTS: [u16; 257] = {
    let mut roots = [0; 257];
    let mut k = 16;
    while k < roots.len() {
        let exact = 262_144.0 / root(k as f64);
        roots[k] = (exact - 3.0 / 64.0 * exact / (k * k) as f64) as u16;
        k += 1;
    }
    roots
};

/// The bits of a number of 7 bits: a Cortex-M0 does not count them by an instruction.
static SHIFTS: [u8; 128] = {
    let mut shifts = [0; 128];
    let mut number = 1;
    while number < shifts.len() {
        shifts[number] = (usize::BITS - number.leading_zeros()) as u8;
        number += 1;
    }
    shifts
};

/// A surface that faces the light, at 0.5 to 64 units of length.
struct Facing {
    /// The offset from the light, shifted down to 15 bits.
    way: [i32; 3],
    shift: u32,
    /// The product with the normal, at most 0, in steps of 2^-14.
    product: i32,
    /// `2^30 / |way|`.
    reciprocal: u32,
}

impl Facing {
    #[inline(always)]
    fn new(point: [i32; 3], normal: [i16; 3]) -> Option<Self> {
        let [x, y, z] = [0, 1, 2].map(|i| point[i].wrapping_sub(AT[i]));
        let size = ((x ^ (x >> 31)) | (y ^ (y >> 31)) | (z ^ (z >> 31))) as u32;
        let upper = size >> 15;
        if upper.wrapping_sub(1) >= 127 {
            return None;
        }
        let shift = u32::from(SHIFTS[upper as usize]);
        let way = [x >> shift, y >> shift, z >> shift];
        let product = dot(way, normal.map(i32::from));
        if product >= 0 {
            return None;
        }
        let squared = dot(way, way) as u32;
        let k = usize::from((squared >> 24) as u8);
        let [from, to] = [ROOTS[k], ROOTS[k + 1]].map(u32::from);
        let reciprocal = from - (((from - to) * (squared << 8 >> 16)) >> 16);
        Some(Self { way, shift, product, reciprocal })
    }

    /// The light at this argument of the falloff, in steps of 2^-15.
    #[inline(always)]
    fn light(&self, t: u32) -> Light16 {
        let cosine = ((self.product.wrapping_neg().cast_unsigned() >> 13) * self.reciprocal) >> 16;
        let share = ((t * t) >> 15).wrapping_mul(cosine) >> 16;
        let gain = (self.reciprocal * self.reciprocal) >> 16;
        Light16::from_bits(share.wrapping_mul(gain) >> (8 + 2 * self.shift))
    }
}

#[inline(always)]
fn dot(a: [i32; 3], b: [i32; 3]) -> i32 {
    (a[0] * b[0]).wrapping_add(a[1] * b[1]).wrapping_add(a[2] * b[2])
}

/// The versine by the difference of the direction and the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Difference {
    /// Twice the outer versine in steps of 2^-28.
    limit: u32,
    /// The reciprocal of half the outer versine times 2^12.
    reciprocal: u32,
}

impl Difference {
    pub(crate) const fn new(outer: f32) -> Self {
        let outer = outer as f64;
        Self { limit: (outer * 536_870_912.0) as u32, reciprocal: nearest(2_048.0 / outer) as u32 }
    }

    #[inline(always)]
    fn at(&self, point: [i32; 3], normal: [i16; 3]) -> Light16 {
        let Some(facing) = Facing::new(point, normal) else { return Light16::ZERO };
        let apart = [0, 1, 2].map(|i| ((facing.way[i] * facing.reciprocal as i32) >> 16) - AXIS[i]);
        let versine = dot(apart, apart) as u32;
        if versine >= self.limit {
            return Light16::ZERO;
        }
        facing.light(32_768 - (((versine >> 9) * self.reciprocal) >> 16))
    }
}

/// The cosine by the inner product of the direction and the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Product {
    /// The outer cosine in steps of 2^-16.
    outer: i32,
    /// The reciprocal of the outer versine times 2^11.
    reciprocal: u32,
}

impl Product {
    pub(crate) const fn new(outer: f32) -> Self {
        let outer = outer as f64;
        Self { outer: (65_536.0 * (1.0 - outer)) as i32, reciprocal: nearest(2_048.0 / outer) as u32 }
    }

    #[inline(always)]
    fn at(&self, point: [i32; 3], normal: [i16; 3]) -> Light16 {
        let Some(facing) = Facing::new(point, normal) else { return Light16::ZERO };
        let along = dot(facing.way, AXIS);
        if along <= 0 {
            return Light16::ZERO;
        }
        let cosine = ((along.cast_unsigned() >> 14) * facing.reciprocal) >> 14;
        let above = cosine.cast_signed() - self.outer;
        if above <= 0 {
            return Light16::ZERO;
        }
        facing.light((above.cast_unsigned().wrapping_mul(self.reciprocal) >> 12).min(32_768))
    }
}

lit!(Difference: Fx16 => Light16);
lit!(Product: Fx16 => Light16);
