//! The 32-bit format: scalars, lengths and directions of 32 bits, products of 64.
//!
//! In the comments `|v|` is the length of the scaled offset, whose largest component has 31 bits.

mod frame;
mod gain;
mod lobe;

pub use self::frame::Frame32;
use super::{
    Arithmetic, Fx32, Gain, Length, Light32, Offset, ProjectedPoint, Ray, Rise, Scalar, Slopes, Versine32,
    Weight32, Word, fraction::Fraction32, root, rounded,
};
use crate::vec3::Vec3;

/// The way from a light to a point, scaled until its largest component has 31 bits.
#[derive(Clone, Copy, Debug)]
pub struct Offset32 {
    way: Vec3<i32>,
    /// Bits of the largest component before scaling, at least 1.
    bits: u32,
}

/// A unit direction and the reciprocal of its former length.
#[derive(Clone, Copy, Debug)]
pub struct Ray32 {
    direction: Vec3<i32>,
    bits: u32,
    squared: u64,
    /// `2^62 / |v|`, of 31 to 33 bits.
    reciprocal: u64,
}

/// A ramp: from the gap between a versine and the outer one to `t`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ramp32 {
    /// From here on there is no light: the outer versine, or that of a tighter delimiter.
    limit: u64,
    outer: u64,
    /// From here on inwards there is all the light: the inner versine, or [`ON_AXIS`].
    inner: u64,
    span: u64,
    /// Takes the span to at most 32 bits.
    shift: u32,
    /// `2^63` over the shifted span.
    mantissa: u64,
    /// Half a unit of what a shifted gap has lost, and half a step of the result: both roundings in one addition.
    half: u64,
}

/// A factor `mantissa / 2^shift`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Gain32 {
    /// At most 28 bits.
    mantissa: u32,
    shift: i32,
}

impl Ramp32 {
    /// The ramp of these bits, in the order of the fields. Those that no ramp has are brought to where every versine has a
    /// place.
    pub const fn from_bits([limit, outer, inner, span, shift, mantissa, half]: [u64; 7]) -> Self {
        // What the longest product short of the span must stay within, with `half`, to be one at most.
        const MOST: u64 = (1 << 63) + (1 << 32) - 1;
        let shift = shift as u32 % u64::BITS;
        let steps = span.saturating_sub(1) >> shift;
        let mantissa = if steps.saturating_mul(mantissa) <= MOST { mantissa } else { 0 };
        let room = MOST - steps * mantissa;
        Self {
            limit: if limit < outer { limit } else { outer },
            outer,
            // Beyond the span a gap would be rounded past one.
            inner: if inner > outer.saturating_sub(span) { inner } else { outer.saturating_sub(span) },
            span,
            shift,
            mantissa,
            half: if half < room { half } else { room },
        }
    }

    /// The bits, in the order of the fields.
    pub const fn to_bits(self) -> [u64; 7] {
        [self.limit, self.outer, self.inner, self.span, self.shift as u64, self.mantissa, self.half]
    }

    #[inline(always)]
    fn rise(self, versine: u64) -> Fraction32 {
        if versine >= self.limit {
            return Fraction32(0);
        }
        if versine <= self.inner {
            return Fraction32(1 << 31);
        }
        Fraction32(((((self.outer - versine) >> self.shift) * self.mantissa + self.half) >> 32) as u32)
    }
}

/// A versine of no more than this is one on the axis: each component of a direction, of the axis as of the way to a point, is
/// within a unit in the last place of the exact one, so that two of the same direction are at most 2 units apart in each.
const ON_AXIS: u64 = 3 * 2 * 2;

/// The product in 64 bits.
#[inline(always)]
fn wide(a: i32, b: i32) -> i64 {
    i64::from(a) * i64::from(b)
}

/// The inner product of a vector and a way. Wraps where the vector is longer than 1.15.
#[inline(always)]
fn inner_product(vector: Vec3<Fx32>, way: Vec3<i32>) -> i64 {
    let products = vector.zip(way, |a, b| wide(a.to_bits(), b));
    products.x.wrapping_add(products.y).wrapping_add(products.z)
}

/// The square of a component.
#[inline(always)]
fn square(component: i32) -> u64 {
    wide(component, component).cast_unsigned()
}

/// `product / 2^shift`, rounded to saturating.
#[inline(always)]
fn shifted(product: u64, shift: i32) -> Light32 {
    let but_one = shift.wrapping_sub(1).cast_unsigned();
    Light32::from_bits(if but_one < u64::BITS {
        let doubled = product >> but_one;
        (doubled >> 1) + (doubled & 1)
    } else if shift > 0 || product == 0 {
        0
    } else if shift.unsigned_abs() <= product.leading_zeros() {
        product << shift.unsigned_abs()
    } else {
        u64::MAX
    })
}

/// A scalar clamped to [0, 1], as an unsigned factor.
#[inline(always)]
fn fraction(scalar: Fx32) -> u64 {
    u64::from(scalar.clamp(Fx32::ZERO, Fx32::ONE).to_bits().cast_unsigned())
}

/// The nearest versine; not a number becomes zero.
fn nearest_versine(value: f32) -> Versine32 {
    Versine32::from_bits(rounded(value * (1_u64 << 61) as f32) as u64)
}

impl Scalar for Fx32 {
    type Length = Length;
    type Unit = Fx32;
    type Irradiance = Light32;

    const NAME: &'static str = "fx32";
    const ZERO: Self = Fx32::ZERO;
    const ONE: Self = Fx32::ONE;
    const STEP: f32 = 1.0 / 1_073_741_824.0;
    const FARTHEST: f32 = 32_767.0;

    #[inline(always)]
    fn from_f32(value: f32) -> Self {
        Fx32::from_f32(value)
    }

    fn to_f32(self) -> f32 {
        Fx32::to_f32(self)
    }

    #[inline(always)]
    fn length(value: f32) -> Length {
        Length::from_f32(value)
    }

    #[inline(always)]
    fn light_to_f32(light: Light32) -> f32 {
        light.to_f32()
    }
}

impl Arithmetic for Fx32 {
    type Position = Length;
    type Direction = Fx32;
    type Received = Light32;
    type Versine = Versine32;
    type Fraction = Fraction32;
    type Fine = Fraction32;
    type Weight = Weight32;
    type Ramp = Ramp32;
    type Frame = Frame32;
    type Gain = Gain32;
    type Offset = Offset32;
    // Three roundings of half a step: 0.87 steps across the direction. A way of more than 32,768 units along a component
    // is halved for 32 bits, which is 0.71 steps more.
    const DIRECTION_ERROR: f32 = 8.2e-10;

    #[inline(always)]
    fn part(steps: u32) -> Self {
        Self::from_bits((steps << 16).cast_signed())
    }

    /// From all bits that the components have, and made of unit length as a direction to a point is.
    fn axis(axis: Vec3<f32>) -> Vec3<Fx32> {
        Offset32::scaled(axis.map(|c| Self::from_f32(c).to_bits())).ray().direction()
    }

    fn aim(toward: Vec3<f32>, _: Vec3<f32>) -> Vec3<Fx32> {
        Self::axis(toward)
    }

    /// The set-up has the versines in f32, within 4e-7 of themselves.
    fn rounding(edge: &Slopes) -> f32 {
        edge.angle * 0.21e-6 + (edge.fraction + 1.5) * Self::STEP
    }

    fn versine(_: Ramp32, value: f32) -> Versine32 {
        if value.is_nan() { Versine32::MAX } else { nearest_versine(value) }
    }

    fn weight(value: f32) -> Weight32 {
        Weight32::from_bits(rounded(value.clamp(-4.0, 4.0) * 1_073_741_824.0) as i64)
    }

    fn gain(value: f32) -> Gain32 {
        let (mantissa, shift) = super::mantissa_and_shift(value);
        Gain32 { mantissa: mantissa << 4, shift: shift + 4 }
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let [a, b] = [self, other].map(|scalar| u64::from(scalar.to_bits().cast_unsigned()));
        Self::from_bits((a.wrapping_mul(b).wrapping_add(1 << 29) >> 30).min(1 << 30) as i32)
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self.saturating_sub(other)
    }

    #[inline(always)]
    fn offset(light: Vec3<Length>, point: Vec3<Length>) -> Offset32 {
        let [p, l] = [point, light].map(|place| place.map(Length::to_bits));
        let way = (p.x.checked_sub(l.x), p.y.checked_sub(l.y), p.z.checked_sub(l.z));
        if let (Some(x), Some(y), Some(z)) = way {
            return Offset32::scaled(Vec3::new(x, y, z));
        }
        core::hint::cold_path();
        let half = |p, l| ((i64::from(p) - i64::from(l) + 1) >> 1).min(i32::MAX.into()) as i32;
        let Offset32 { way, bits } = Offset32::scaled(p.zip(l, half));
        Offset32 { way, bits: bits + 1 }
    }

    fn ramp(inner: f32, outer: f32, limit: f32) -> Ramp32 {
        let [inner, outer, limit] = [inner, outer, limit].map(|versine| nearest_versine(versine).to_bits());
        let span = outer.saturating_sub(inner);
        let shift = (u64::BITS - span.leading_zeros()).saturating_sub(32);
        let divisor = (span >> shift).max(1);
        let mantissa = ((1 << 63) + divisor / 2) / divisor;
        let inner = inner.max(ON_AXIS);
        // The largest gap short of the span must not be rounded past one.
        let room = ((1 << 63) + (1 << 32) - 1) - (span.saturating_sub(1) >> shift) * mantissa;
        let half = ((mantissa - (mantissa >> shift)) / 2 + (1 << 31)).min(room);
        Ramp32 { limit: limit.min(outer), outer, inner, span, shift, mantissa, half }
    }

    #[inline(always)]
    fn rise(ramp: Ramp32, versine: Versine32) -> Rise<Self> {
        Rise::Coarse(ramp.rise(versine.to_bits()))
    }

    #[inline(always)]
    fn smooth(self) -> Self {
        lobe::smooth(self)
    }

    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> Frame32 {
        Frame32::new(vectors, tangent)
    }

    #[inline(always)]
    fn place(frame: &Frame32, light: Vec3<Length>, point: Vec3<Length>) -> ProjectedPoint<Self> {
        frame.place(light, point)
    }

    #[inline(always)]
    fn weighted_byte(sum: u32) -> Self {
        /// `2^38 / 255`: a product of at most 63 bits.
        const INVERSE: u64 = 1_077_952_576;
        Self::from_bits(((u64::from(sum) * INVERSE + (1 << 31)) >> 32).min(1 << 30) as i32)
    }

    #[inline(always)]
    fn versine_between(a: Vec3<Fx32>, b: Vec3<Fx32>, _: Ramp32) -> Versine32 {
        let difference = a.zip(b, |a, b| a.to_bits().saturating_sub(b.to_bits()));
        let squares = difference.map(square);
        Versine32::from_bits(squares.x.saturating_add(squares.y).saturating_add(squares.z))
    }

    #[inline(always)]
    fn power(versine: Versine32, exponent: u32) -> Self {
        lobe::power(versine, exponent)
    }

    #[inline(always)]
    fn normal_unit(normal: Vec3<Self>) -> Vec3<Fx32> {
        normal
    }

    #[inline(always)]
    fn mirror(direction: Vec3<Fx32>, normal: Vec3<Self>) -> Vec3<Fx32> {
        lobe::mirror(direction, normal)
    }

    #[inline(always)]
    fn direction_between(a: Vec3<Fx32>, b: Vec3<Fx32>) -> Vec3<Fx32> {
        // Half the difference always fits.
        let half = b.zip(a, |b, a| (b.to_bits() >> 1) - (a.to_bits() >> 1));
        Offset32::scaled(half).ray().direction()
    }

    #[inline(always)]
    fn incidence(direction: Vec3<Fx32>, normal: Vec3<Self>) -> Self {
        lobe::incidence(direction, normal)
    }

    #[inline(always)]
    fn expose(self, gain: Gain32) -> Light32 {
        shifted(fraction(self) * u64::from(gain.mantissa), gain.shift)
    }

    #[inline(always)]
    fn filter(light: Light32, color: Self) -> Light32 {
        let color = u64::from(color.to_bits().max(0).cast_unsigned());
        let (high, low) = (light.to_bits() >> 32, light.to_bits() & 0xffff_ffff);
        let high = high * color;
        let high = if high >> 62 == 0 { high << 2 } else { u64::MAX };
        Light32::from_bits(high.saturating_add((low * color + (1 << 29)) >> 30))
    }

    #[inline(always)]
    fn add_light(a: Light32, b: Light32) -> Light32 {
        a.saturating_add(b)
    }

    #[inline(always)]
    fn light_to_gain(light: Light32) -> Gain32 {
        Gain32::normalised(light.to_bits(), 30)
    }

    #[inline(always)]
    fn amplify(light: Light32, gain: Gain32) -> Light32 {
        gain.amplify(light)
    }

    #[inline(always)]
    fn clip(light: Light32) -> Self {
        Self::from_bits(light.to_bits().min(1 << 30) as i32)
    }

    #[inline(always)]
    fn word(self) -> Word {
        Word::Steps30(self.to_bits())
    }
}

impl Offset32 {
    #[inline(always)]
    fn scaled(way: Vec3<i32>) -> Self {
        let magnitudes = way.map(|c| (c ^ (c >> 31)).cast_unsigned());
        let bits = root::bit_length(magnitudes.x | magnitudes.y | magnitudes.z);
        Self { way: way.map(|c| c << (31 - bits)), bits }
    }

    /// `|v|^2`. Computed where it is needed, for a surface that faces away has no need of it.
    #[inline(always)]
    fn squared(&self) -> u64 {
        let squares = self.way.map(square);
        squares.x + squares.y + squares.z
    }
}

impl Offset<Fx32> for Offset32 {
    type Ray = Ray32;
    type FineRay = Ray32;
    /// In steps of 2^-30 of `|v|`. Wraps for normals that are longer than 1.15, which leaves it defined.
    type Facing = i64;

    #[inline(always)]
    fn facing(&self, normal: Vec3<Fx32>) -> i64 {
        inner_product(normal, self.way).wrapping_neg()
    }

    #[inline(always)]
    fn faces_away(facing: i64) -> bool {
        facing <= 0
    }

    #[inline(always)]
    fn is_outside(&self, axis: Vec3<Fx32>, bound: Fx32) -> bool {
        let along = inner_product(axis, self.way) >> 31;
        along.wrapping_mul(along.abs()) < (self.squared() >> 32).cast_signed() * i64::from(bound.to_bits())
    }

    #[inline(always)]
    fn squared_distance(&self) -> Gain32 {
        Gain32::normalised(self.squared(), 94 - 2 * self.bits.cast_signed())
    }

    #[inline(always)]
    fn ray(&self) -> Ray32 {
        let squared = self.squared();
        let reciprocal = if squared >= 1 << 62 {
            root::inverse_sqrt_32(squared) >> 1
        } else if squared >= 1 << 60 {
            root::inverse_sqrt_32(squared << 2)
        } else {
            0
        };
        let direction = self.way.map(|c| {
            let product = i64::from(c) * reciprocal.cast_signed();
            ((product + (1 << 31)) >> 32) as i32
        });
        Ray32 { direction, bits: self.bits, squared, reciprocal }
    }

    #[inline(always)]
    fn fine_ray(&self) -> Ray32 {
        self.ray()
    }
}

impl Ray<Fx32> for Ray32 {
    type Fraction = Fraction32;
    type Share = Fx32;

    #[inline(always)]
    fn distance(&self) -> Gain32 {
        // `|v| 2^30`, of 61 or 62 bits.
        let distance = (self.squared >> 30) * (self.reciprocal >> 2);
        Gain32::normalised(distance, 77 - self.bits.cast_signed())
    }

    #[inline(always)]
    fn direction(&self) -> Vec3<Fx32> {
        self.direction.map(Fx32::from_bits)
    }

    #[inline(always)]
    fn versine(&self, axis: Vec3<Fx32>, ramp: Ramp32) -> Versine32 {
        Fx32::versine_between(self.direction(), axis, ramp)
    }

    #[inline(always)]
    fn rise(&self, axis: Vec3<Fx32>, ramp: Ramp32) -> Fraction32 {
        ramp.rise(self.versine(axis, ramp).to_bits())
    }

    #[inline(always)]
    fn cosine(&self, facing: i64, _: Vec3<Fx32>) -> Fraction32 {
        // The product is the length of the normal in steps of 2^-61: of at most 64 bits, also where the facing has wrapped,
        // for then `|v|` is over `2^31`.
        let cosine = ((facing.max(0).cast_unsigned() >> 31) * self.reciprocal) >> 30;
        Fraction32(cosine.min(1 << 31) as u32)
    }

    #[inline(always)]
    fn near(&self, gain: Gain32) -> Fx32 {
        self.distance().by(gain).fraction()
    }

    #[inline(always)]
    fn squared_near(&self, offset: &Offset32, gain: Gain32) -> Fx32 {
        offset.squared_distance().by(gain).fraction()
    }

    #[inline(always)]
    fn expose(&self, share: Fx32, gain: Gain32) -> Light32 {
        // At most 32, 28 and 34 bits: every product fits 64.
        let reciprocal = self.reciprocal >> 1;
        let squared = (reciprocal * reciprocal) >> 28;
        let mantissa = (u64::from(gain.mantissa) * squared) >> 28;
        shifted(fraction(share) * mantissa, gain.shift + 2 * self.bits.cast_signed() - 28)
    }
}
