//! The 16-bit format: scalars of 16 bits, lengths and directions of 32, and no product wider than 32 bits, so that
//! a processor with nothing but a 32-bit multiply runs it.
//!
//! In the comments `|v|` is the length of the scaled offset, whose largest component has 17 bits.

use super::{Offset, Ray, Scalar, fraction::Fraction16, root};
use crate::vec3::Vec3;
use fixed::types::{I2F14, I2F30, I16F16, I18F14, U1F31, U18F14};

/// The 16-bit format: I2F14, from -2 to 2 in steps of 1/16384.
pub type Fx16 = I2F14;

/// How many bits the largest component of a scaled offset has. A product with the reciprocal of its length has 31 in
/// all: the offset gets more of them, because its error turns the direction while the reciprocal's only shortens it.
const WAY_BITS: u32 = 17;

/// The way from a light to a point, scaled until its largest component has 17 bits.
#[derive(Clone, Copy, Debug)]
pub struct Offset16 {
    way: Vec3<i32>,
    /// Bits of the largest component before scaling; 0 where the point is on the light.
    bits: u32,
    /// `(|v| / 4)^2`, which fits 32 bits.
    squared: u32,
}

/// A unit direction and the reciprocal of its former length.
#[derive(Clone, Copy, Debug)]
pub struct Ray16 {
    direction: Vec3<i32>,
    bits: u32,
    /// `2^31 / |v|`, of 14 to 16 bits.
    reciprocal: u32,
}

/// A ramp: from the gap between a versine and the outer one to `t`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ramp16 {
    /// Powers of four by which the versines of this ramp are magnified.
    zoom: u32,
    /// From here on there is no light: the outer versine, or that of a tighter delimiter.
    limit: u32,
    outer: u32,
    span: u32,
    /// Takes the span to at most 16 bits.
    shift: u32,
    /// `2^31` over the shifted span.
    mantissa: u32,
    /// Half a unit of what a shifted gap has lost, and half a step of the result: both roundings in one addition.
    half: u32,
}

/// A factor `mantissa / 2^shift`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Gain16 {
    /// At most 16 bits.
    mantissa: u32,
    shift: i32,
}

/// Scales one component to `bits`, rounding to nearest.
#[inline(always)]
fn scale(component: i32, bits: u32) -> i32 {
    if bits > WAY_BITS {
        ((component >> (bits - WAY_BITS - 1)) + 1) >> 1
    } else {
        component << (WAY_BITS - bits)
    }
}

/// The largest zoom of a ramp: one more would ask for bits that a direction does not have.
const MOST_ZOOM: u32 = 14;

/// The nearest versine times `4^zoom`, saturating; not a number becomes zero.
fn magnified(value: f32, zoom: u32) -> U1F31 {
    let value = value * (1_u64 << (2 * zoom)) as f32;
    if value.is_nan() { U1F31::ZERO } else { U1F31::saturating_from_num(value) }
}

/// The square of a component that has at most 17 bits, saturating.
#[inline(always)]
fn square(component: i32) -> u32 {
    let magnitude = component.unsigned_abs().min(0xffff);
    magnitude * magnitude
}

/// `product / 2^shift`, rounded to nearest, saturating.
#[inline(always)]
fn shifted(product: u32, shift: i32) -> U18F14 {
    U18F14::from_bits(if shift > 0 {
        let doubled = product.checked_shr(shift.unsigned_abs() - 1).unwrap_or(0);
        (doubled >> 1) + (doubled & 1)
    } else if product == 0 || shift.unsigned_abs() <= product.leading_zeros() {
        product.checked_shl(shift.unsigned_abs()).unwrap_or(0)
    } else {
        u32::MAX
    })
}

impl Scalar for Fx16 {
    type Length = I16F16;
    type Unit = I2F30;
    type Versine = U1F31;
    type Fraction = Fraction16;
    type Weight = I18F14;
    type Ramp = Ramp16;
    type Gain = Gain16;
    type Irradiance = U18F14;
    type Offset = Offset16;

    const NAME: &'static str = "fx16";
    const ZERO: Self = I2F14::ZERO;
    const ONE: Self = I2F14::ONE;
    const STEP: f32 = 1.0 / 16_384.0;
    const DIRECTION_ERROR: f32 = 1.2e-5;

    fn from_f32(value: f32) -> Self {
        if value.is_nan() { Self::ZERO } else { Self::saturating_from_num(value) }
    }

    fn to_f32(self) -> f32 {
        self.to_num()
    }

    fn length(value: f32) -> I16F16 {
        if value.is_nan() { I16F16::ZERO } else { I16F16::saturating_from_num(value) }
    }

    fn axis(axis: Vec3<f32>) -> Vec3<I2F30> {
        axis.map(|c| if c.is_nan() { I2F30::ZERO } else { I2F30::saturating_from_num(c) })
    }

    fn versine(ramp: Ramp16, value: f32) -> U1F31 {
        magnified(value, ramp.zoom)
    }

    fn weight(value: f32) -> I18F14 {
        if value.is_nan() { I18F14::ZERO } else { I18F14::saturating_from_num(value.clamp(-4.0, 4.0)) }
    }

    fn gain(value: f32) -> Gain16 {
        let (mantissa, shift) = super::mantissa_and_shift(value);
        Gain16 { mantissa: ((mantissa + 0x80) >> 8).min(0xffff), shift: shift - 8 }
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let product = i32::from(self.to_bits()) * i32::from(other.to_bits());
        // The largest product, of the two least scalars, is 2^30: rounding it cannot overflow.
        let rounded = (product + (1 << 13)) >> 14;
        Self::from_bits(rounded.clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16)
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self.saturating_sub(other)
    }

    #[inline(always)]
    fn offset(light: Vec3<I16F16>, point: Vec3<I16F16>) -> Offset16 {
        let way = point.zip(light, |p, l| p.to_bits().saturating_sub(l.to_bits()));
        let magnitudes = way.x.unsigned_abs() | way.y.unsigned_abs() | way.z.unsigned_abs();
        let bits = u32::BITS - magnitudes.leading_zeros();
        let way = way.map(|c| scale(c, bits));
        let squared = square(way.x >> 2) + square(way.y >> 2) + square(way.z >> 2);
        Offset16 { way, bits, squared }
    }

    fn ramp(inner: f32, outer: f32, limit: f32) -> Ramp16 {
        let zoom =
            (1..=MOST_ZOOM).take_while(|&zoom| magnified(outer, zoom) <= U1F31::ONE).last().unwrap_or(0);
        let [inner, outer, limit] = [inner, outer, limit].map(|versine| magnified(versine, zoom).to_bits());
        let span = outer.saturating_sub(inner);
        let shift = (u32::BITS - span.leading_zeros()).saturating_sub(16);
        // The whole span divides, not the shifted one: what the shift loses would be an error of the slope.
        let divisor = u64::from(span.max(1));
        let mantissa = (((1 << (31 + shift)) + divisor / 2) / divisor) as u32;
        // The largest gap short of the span must not be rounded past one.
        let room = (1 << 31) + (1 << 16) - 1 - (span.saturating_sub(1) >> shift) * mantissa;
        let half = ((mantissa - (mantissa >> shift)) / 2 + (1 << 15)).min(room);
        Ramp16 { zoom, limit: limit.min(outer), outer, span, shift, mantissa, half }
    }

    #[inline(always)]
    fn rise(ramp: Ramp16, versine: U1F31) -> Fraction16 {
        let versine = versine.to_bits();
        if versine >= ramp.limit {
            return Fraction16(0);
        }
        let gap = ramp.outer - versine;
        if gap >= ramp.span {
            return Fraction16(1 << 15);
        }
        Fraction16((((gap >> ramp.shift) * ramp.mantissa + ramp.half) >> 16) as u16)
    }

    #[inline(always)]
    fn expose(self, gain: Gain16) -> U18F14 {
        let fraction = u32::from(self.clamp(Self::ZERO, Self::ONE).to_bits().cast_unsigned());
        shifted(fraction * gain.mantissa, gain.shift)
    }

    #[inline(always)]
    fn filter(light: U18F14, color: Self) -> U18F14 {
        let color = u32::from(color.to_bits().max(0).cast_unsigned());
        let (high, low) = (light.to_bits() >> 16, light.to_bits() & 0xffff);
        let high = high * color;
        let high = if high >> 30 == 0 { high << 2 } else { u32::MAX };
        U18F14::from_bits(high.saturating_add((low * color + (1 << 13)) >> 14))
    }

    #[inline(always)]
    fn add_light(a: U18F14, b: U18F14) -> U18F14 {
        a.saturating_add(b)
    }

    #[inline(always)]
    fn light_to_f32(light: U18F14) -> f32 {
        light.to_bits() as f32 * Self::STEP
    }
}

impl Offset<Fx16> for Offset16 {
    type Ray = Ray16;
    /// In steps of 2^-14 of `|v| / 8`.
    type Facing = i32;

    #[inline(always)]
    fn facing(&self, normal: Vec3<Fx16>) -> i32 {
        let products = normal.zip(self.way, |n, v| i32::from(n.to_bits()) * (v >> 3));
        -(products.x + products.y + products.z)
    }

    #[inline(always)]
    fn faces_away(facing: i32) -> bool {
        facing <= 0
    }

    #[inline(always)]
    fn is_outside(&self, axis: Vec3<I2F30>, bound: Fx16) -> bool {
        let products = axis.zip(self.way, |s, v| (s.to_bits() >> 16) * (v >> 2));
        let along = products.x.wrapping_add(products.y).wrapping_add(products.z) >> 14;
        let magnitude = (square(along) >> 2).cast_signed();
        let signed = if along < 0 { -magnitude } else { magnitude };
        signed < (self.squared >> 16).cast_signed() * i32::from(bound.to_bits())
    }

    #[inline(always)]
    fn ray(&self) -> Ray16 {
        let reciprocal = if self.squared >= 1 << 30 {
            (root::inverse_sqrt_16(self.squared) + 2) >> 2
        } else if self.squared >= 1 << 28 {
            (root::inverse_sqrt_16(self.squared << 2) + 1) >> 1
        } else {
            0
        };
        let fourteen_bits = ((reciprocal + 1) >> 1).cast_signed();
        let direction = self.way.map(|c| c * fourteen_bits);
        Ray16 { direction, bits: self.bits, reciprocal }
    }
}

impl Ray<Fx16> for Ray16 {
    #[inline(always)]
    fn direction(&self) -> Vec3<I2F30> {
        self.direction.map(I2F30::from_bits)
    }

    #[inline(always)]
    fn versine(&self, axis: Vec3<I2F30>, ramp: Ramp16) -> U1F31 {
        let shift = MOST_ZOOM - ramp.zoom;
        let difference = self.direction.zip(axis, |l, s| ((l.wrapping_sub(s.to_bits()) >> shift) + 1) >> 1);
        let squares = difference.map(square);
        U1F31::from_bits(squares.x.saturating_add(squares.y).saturating_add(squares.z))
    }

    #[inline(always)]
    fn cosine(&self, facing: i32) -> Fx16 {
        let cosine = ((facing >> 13) * self.reciprocal.cast_signed() + (1 << 14)) >> 15;
        Fx16::from_bits(cosine.clamp(0, 1 << 14) as i16)
    }

    #[inline(always)]
    fn expose(&self, fraction: Fx16, gain: Gain16) -> U18F14 {
        let fraction = u32::from(fraction.clamp(Fx16::ZERO, Fx16::ONE).to_bits().cast_unsigned());
        // At most 16, 16 and 18 bits: every product fits 32.
        let squared = (self.reciprocal * self.reciprocal) >> 14;
        let mantissa = (gain.mantissa * squared) >> 14;
        shifted(fraction * mantissa, gain.shift + 2 * self.bits.cast_signed() - 32)
    }
}
