//! The 16-bit format: scalars of 16 bits, lengths and directions of 32, and no product wider than 32 bits, so that
//! a processor with nothing but a 32-bit multiply runs it.
//!
//! In the comments `|v|` is the length of the scaled offset, whose largest component has 17 bits.

mod gain;
mod lobe;

use super::{Offset, Ray, Scalar, fraction::Fraction16, nearest, root};
use crate::{color::srgb16, vec3::Vec3};
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
}

/// A unit direction and the reciprocal of its former length.
#[derive(Clone, Copy, Debug)]
pub struct Ray16 {
    direction: Vec3<i32>,
    bits: u32,
    squared: u32,
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

impl Ramp16 {
    /// The ramp of these bits, in the order of the fields. Those that no ramp has are brought to where every versine has a
    /// place.
    pub const fn from_bits([zoom, limit, outer, span, shift, mantissa, half]: [u32; 7]) -> Self {
        // What the longest product short of the span must stay within, with `half`, to be one at most.
        const MOST: u32 = (1 << 31) + (1 << 16) - 1;
        let shift = shift % u32::BITS;
        let steps = span.saturating_sub(1) >> shift;
        let mantissa = if steps.saturating_mul(mantissa) <= MOST { mantissa } else { 0 };
        let room = MOST - steps * mantissa;
        Self {
            zoom: if zoom < MOST_ZOOM { zoom } else { MOST_ZOOM },
            limit: if limit < outer { limit } else { outer },
            outer,
            span,
            shift,
            mantissa,
            half: if half < room { half } else { room },
        }
    }

    /// The bits, in the order of the fields.
    pub const fn to_bits(self) -> [u32; 7] {
        [self.zoom, self.limit, self.outer, self.span, self.shift, self.mantissa, self.half]
    }
}

/// Scales a component of at most this many bits to 17, rounding to nearest: first up to all that there are, so that
/// one way serves long offsets and short ones.
#[inline(always)]
fn scale(component: i32, bits: u32) -> i32 {
    (((component << (31 - bits)) >> (30 - WAY_BITS)) + 1) >> 1
}

/// The largest zoom of a ramp: one more would ask for bits that a direction does not have.
const MOST_ZOOM: u32 = 14;

/// The nearest versine times `4^zoom`, saturating; not a number becomes zero.
fn magnified(value: f32, zoom: u32) -> U1F31 {
    let value = value * (1_u64 << (2 * zoom)) as f32;
    if value.is_nan() { U1F31::ZERO } else { U1F31::saturating_from_num(value) }
}

/// `product / 2^shift`, rounded to nearest, saturating.
#[inline(always)]
fn shifted(product: u32, shift: i32) -> U18F14 {
    let but_one = shift.wrapping_sub(1).cast_unsigned();
    U18F14::from_bits(if but_one < u32::BITS {
        let doubled = product >> but_one;
        (doubled >> 1) + (doubled & 1)
    } else if shift > 0 || product == 0 {
        0
    } else if shift.unsigned_abs() <= product.leading_zeros() {
        product << shift.unsigned_abs()
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
    const FARTHEST: f32 = 32_767.0;

    #[inline(always)]
    fn from_f32(value: f32) -> Self {
        let steps = nearest(value * 16_384.0);
        Self::from_bits(steps.clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16)
    }

    fn to_f32(self) -> f32 {
        self.to_num()
    }

    #[inline(always)]
    fn length(value: f32) -> I16F16 {
        I16F16::from_bits(nearest(value * 65_536.0))
    }

    fn axis(axis: Vec3<f32>) -> Vec3<I2F30> {
        axis.map(|c| if c.is_nan() { I2F30::ZERO } else { I2F30::saturating_from_num(c) })
    }

    fn versine(ramp: Ramp16, value: f32) -> U1F31 {
        if value.is_nan() { U1F31::MAX } else { magnified(value, ramp.zoom) }
    }

    fn weight(value: f32) -> I18F14 {
        if value.is_nan() { I18F14::ZERO } else { I18F14::saturating_from_num(value.clamp(-4.0, 4.0)) }
    }

    fn gain(value: f32) -> Gain16 {
        let (mantissa, shift) = super::mantissa_and_shift(value);
        Gain16::normalised(mantissa, shift)
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
        Offset16::scaled(point.zip(light, |p, l| p.to_bits().saturating_sub(l.to_bits())))
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
    fn smooth(self) -> Self {
        lobe::smooth(self)
    }

    #[inline(always)]
    fn versine_between(a: Vec3<I2F30>, b: Vec3<I2F30>, ramp: Ramp16) -> U1F31 {
        let shift = MOST_ZOOM - ramp.zoom + 1;
        // The rounding belongs to the second direction: where that is an axis, it is taken once per light. Opposite
        // directions may wrap round, from one difference that is far outside of every cone to another.
        let b = b.map(|c| c.to_bits().wrapping_sub(1 << (shift - 1)));
        let difference = a.zip(b, |a, b| a.to_bits().wrapping_sub(b) >> shift);
        let magnitudes = difference.map(i32::unsigned_abs);
        if (magnitudes.x | magnitudes.y | magnitudes.z) >> 16 != 0 {
            return U1F31::MAX;
        }
        let squares = magnitudes.map(|c| c * c);
        let sum = squares.x.checked_add(squares.y).and_then(|sum| sum.checked_add(squares.z));
        sum.map_or(U1F31::MAX, U1F31::from_bits)
    }

    #[inline(always)]
    fn power(versine: U1F31, exponent: u32) -> Self {
        lobe::power(versine, exponent)
    }

    #[inline(always)]
    fn normal_unit(normal: Vec3<Self>) -> Vec3<I2F30> {
        normal.map(|c| I2F30::from_bits(i32::from(c.to_bits()) << 16))
    }

    #[inline(always)]
    fn mirror(direction: Vec3<I2F30>, normal: Vec3<Self>) -> Vec3<I2F30> {
        lobe::mirror(direction, normal)
    }

    #[inline(always)]
    fn direction_between(a: Vec3<I2F30>, b: Vec3<I2F30>) -> Vec3<I2F30> {
        // Half the difference always fits.
        let half = b.zip(a, |b, a| (b.to_bits() >> 1) - (a.to_bits() >> 1));
        Offset16::scaled(half).ray().direction()
    }

    #[inline(always)]
    fn incidence(direction: Vec3<I2F30>, normal: Vec3<Self>) -> Self {
        lobe::incidence(direction, normal)
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

    #[inline(always)]
    fn light_to_gain(light: U18F14) -> Gain16 {
        Gain16::normalised(light.to_bits(), 14)
    }

    #[inline(always)]
    fn amplify(light: U18F14, gain: Gain16) -> U18F14 {
        gain.amplify(light)
    }

    #[inline(always)]
    fn clip(light: U18F14) -> Self {
        Self::from_bits(light.to_bits().min(1 << 14) as i16)
    }

    #[inline(always)]
    fn srgb<const LAST: usize>(self) -> u8 {
        srgb16::<LAST>(self.to_bits())
    }
}

impl Offset16 {
    /// The way, scaled until its largest component has 17 bits.
    #[inline(always)]
    fn scaled(way: Vec3<i32>) -> Self {
        let magnitudes = way.map(|c| (c ^ (c >> 31)).cast_unsigned());
        let bits = root::bit_length(magnitudes.x | magnitudes.y | magnitudes.z);
        Self { way: way.map(|c| scale(c, bits)), bits }
    }

    /// `(|v| / 4)^2`. Computed where it is needed, for a surface that faces away has no need of it.
    #[inline(always)]
    fn squared(&self) -> u32 {
        // At most 15 bits and a sign: 32 bits hold the sum of the squares.
        let squares = self.way.map(|c| (c >> 2).wrapping_mul(c >> 2).cast_unsigned());
        squares.x.wrapping_add(squares.y).wrapping_add(squares.z)
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
        // The axis has unit length, so that 16 bits hold the part of |v| / 4 along it.
        let magnitude = (along.wrapping_mul(along).cast_unsigned() >> 2).cast_signed();
        let signed = if along < 0 { -magnitude } else { magnitude };
        signed < (self.squared() >> 16).cast_signed() * i32::from(bound.to_bits())
    }

    #[inline(always)]
    fn squared_distance(&self) -> Gain16 {
        Gain16::normalised(self.squared(), 62 - 2 * self.bits.cast_signed())
    }

    #[inline(always)]
    fn ray(&self) -> Ray16 {
        let squared = self.squared();
        let reciprocal = if squared >= 1 << 30 {
            (root::inverse_sqrt_16(squared) + 2) >> 2
        } else if squared >= 1 << 28 {
            (root::inverse_sqrt_16(squared << 2) + 1) >> 1
        } else {
            0
        };
        let fourteen_bits = ((reciprocal + 1) >> 1).cast_signed();
        let direction = self.way.map(|c| c * fourteen_bits);
        Ray16 { direction, bits: self.bits, squared, reciprocal }
    }
}

impl Ray<Fx16> for Ray16 {
    #[inline(always)]
    fn distance(&self) -> Gain16 {
        // `|v| 2^11`, of 28 or 29 bits.
        Gain16::normalised(gain::high_product(self.squared, self.reciprocal), 44 - self.bits.cast_signed())
    }

    #[inline(always)]
    fn direction(&self) -> Vec3<I2F30> {
        self.direction.map(I2F30::from_bits)
    }

    #[inline(always)]
    fn versine(&self, axis: Vec3<I2F30>, ramp: Ramp16) -> U1F31 {
        Fx16::versine_between(self.direction(), axis, ramp)
    }

    #[inline(always)]
    fn cosine(&self, facing: i32) -> Fx16 {
        // Whatever the normal's length, the product has at most 31 bits: it is that length in steps of 2^-29.
        let cosine = ((facing.max(0).cast_unsigned() >> 13) * self.reciprocal + (1 << 14)) >> 15;
        Fx16::from_bits(cosine.min(1 << 14) as i16)
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
