//! The 16-bit format: scalars of 16 bits, lengths and directions of 32, and no product wider than 32 bits, so that
//! a processor with nothing but a 32-bit multiply runs it. Steep cones and bright light have products of 32 by 32 bits, which
//! are four of 16 where the processor has no wider one; real powers have 64 bits in every format.

mod fine;
mod fine_ray;
mod frame;
mod gain;
mod lobe;
mod offset;

pub use self::frame::Frame16;
use self::{fine::Fine16, offset::Offset16};
use super::{
    Arithmetic, Fx16, Fx32, HALF_A_CODE, Length, Light16, Offset, ProjectedPoint, Ray, Rise, Scalar, Slopes,
    Versine16, Weight16, Word, fraction::Fraction16, nearest, rounded,
};
use crate::{trig, vec3::Vec3};

/// A ramp: from what a versine has over the inner one to `t`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ramp16 {
    /// Powers of four by which the versines of this ramp are magnified.
    zoom: u32,
    /// Up to here there is all the light.
    inner: u32,
    /// So far from the inner versine on there is none: at the outer versine, or at that of a tighter delimiter.
    width: u32,
    /// Takes the span from inner to outer versine to at most 16 bits.
    shift: u32,
    /// `2^31` over the shifted span.
    mantissa: u32,
    /// One with 31 fraction bits, half a step of the result, less half of what a shifted versine has lost: what the
    /// product is taken from, and all roundings, in one subtraction.
    one: u32,
    /// The width of a ramp that is always evaluated finely, so that its `width` is 0; 0 for any other.
    fine: u32,
    /// How many bits the span has.
    fine_shift: u32,
    /// `2^63` over the span, which is shifted to 32 bits for that.
    fine_mantissa: u32,
}

/// A factor `mantissa / 2^shift`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Gain16 {
    /// Of 32 bits. The coarse evaluation has need of the upper 16 alone.
    mantissa: u32,
    shift: i32,
}

impl Ramp16 {
    /// The ramp of these bits, in the order of the fields. Those that no ramp has are brought to where every versine has a
    /// place.
    pub const fn from_bits(bits: [u32; 9]) -> Self {
        /// Beyond this a versine at the inner one would be more than one.
        const MOST: u32 = (1 << 31) + (1 << 16) - 1;
        let [zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa] = bits;
        let width = if fine == 0 { width } else { 0 };
        let shift = shift % u32::BITS;
        let one = if one < MOST { one } else { MOST };
        let steps = width.saturating_sub(1) >> shift;
        Self {
            zoom: if zoom < MOST_ZOOM { zoom } else { MOST_ZOOM },
            inner,
            width,
            shift,
            mantissa: if steps.saturating_mul(mantissa) <= one { mantissa } else { 0 },
            one,
            fine,
            fine_shift: fine_shift % u64::BITS,
            fine_mantissa,
        }
    }

    /// The bits, in the order of the fields.
    pub const fn to_bits(self) -> [u32; 9] {
        let Self { zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa } = self;
        [zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa]
    }

    /// Where a versine stands on a ramp that is not always fine.
    #[inline(always)]
    fn rise(self, versine: Versine16) -> Fraction16 {
        self.within(versine).unwrap_or_else(|| self.end(versine))
    }

    /// Where it stands between the ends.
    #[inline(always)]
    fn within(self, versine: Versine16) -> Option<Fraction16> {
        let past = versine.to_bits().wrapping_sub(self.inner);
        (past < self.width).then(|| Fraction16((self.one - (past >> self.shift) * self.mantissa) >> 16))
    }

    /// Where it stands at or beyond one of them.
    #[inline(always)]
    fn end(self, versine: Versine16) -> Fraction16 {
        Fraction16(if versine.to_bits() < self.inner { 1 << 15 } else { 0 })
    }
}

/// The largest zoom of a ramp: one more would ask for bits that a direction does not have.
const MOST_ZOOM: u32 = 15;

/// The zoom of a ramp that ends at this versine.
fn zoom(limit: f32) -> u32 {
    (1..=MOST_ZOOM).take_while(|&zoom| magnified(limit, zoom).to_bits() <= 2 << 29).last().unwrap_or(0)
}

/// The nearest versine times `4^zoom`, saturating; NaN becomes zero.
fn magnified(value: f32, zoom: u32) -> Versine16 {
    Versine16::from_bits(rounded(value * (1_u64 << (29 + 2 * zoom)) as f32) as u32)
}

/// `product / 2^shift`, rounded to nearest, saturating.
#[inline(always)]
fn shifted(product: u32, shift: i32) -> Light16 {
    let but_one = shift.wrapping_sub(1).cast_unsigned();
    Light16::from_bits(if but_one < u32::BITS {
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
    type Length = Length;
    type Unit = Fx32;
    type Irradiance = Light16;

    const NAME: &'static str = "fx16";
    const ZERO: Self = Fx16::ZERO;
    const ONE: Self = Fx16::ONE;
    const STEP: f32 = 1.0 / 16_384.0;
    const FARTHEST: f32 = 16_383.0;

    #[inline(always)]
    fn from_f32(value: f32) -> Self {
        Fx16::from_f32(value)
    }

    fn to_f32(self) -> f32 {
        Fx16::to_f32(self)
    }

    #[inline(always)]
    fn length(value: f32) -> Length {
        Length::from_f32(value)
    }

    #[inline(always)]
    fn light_to_f32(light: Light16) -> f32 {
        light.to_f32()
    }
}

impl Arithmetic for Fx16 {
    type Position = Length;
    type Direction = Fx32;
    type Received = Light16;
    type Versine = Versine16;
    type Fraction = Fraction16;
    type Fine = Fine16;
    type Weight = Weight16;
    type Ramp = Ramp16;
    type Frame = Frame16;
    type Gain = Gain16;
    type Offset = Offset16;
    const DIRECTION_ERROR: f32 = 1.55e-5;

    #[inline(always)]
    fn part(steps: u32) -> Self {
        Self::from_bits(steps as i16)
    }

    fn axis(axis: Vec3<f32>) -> Vec3<Fx32> {
        axis.map(Fx32::from_f32)
    }

    fn versine(ramp: Ramp16, value: f32) -> Versine16 {
        if value.is_nan() { Versine16::MAX } else { magnified(value, ramp.zoom) }
    }

    fn weight(value: f32) -> Weight16 {
        Weight16::from_bits(nearest(value.clamp(-4.0, 4.0) * 16_384.0))
    }

    fn gain(value: f32) -> Gain16 {
        let (mantissa, shift) = super::mantissa_and_shift(value);
        Gain16 { mantissa: mantissa << 8, shift: shift + 8 }
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let [a, b] = [self, other].map(|scalar| u32::from(scalar.to_bits().cast_unsigned()));
        Self::from_bits((a.wrapping_mul(b).wrapping_add(1 << 13) >> 14).min(1 << 14) as i16)
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self.saturating_sub(other)
    }

    #[inline(always)]
    fn offset(light: Vec3<Length>, point: Vec3<Length>) -> Offset16 {
        Offset16::between(light, point)
    }

    fn ramp(inner: f32, outer: f32, limit: f32) -> Ramp16 {
        // Two is the square of the largest component that `versine_between` lets pass. Beyond the limit none has to.
        let limit = if limit < outer { limit } else { outer };
        let zoom = zoom(limit);
        let [inner, limit] = [inner, limit].map(|versine| magnified(versine, zoom).to_bits());
        let outer = (outer * (1_u64 << (29 + 2 * zoom)) as f32 + 0.5) as u64;
        let span = outer.saturating_sub(inner.into()).max(1);
        let shift = (u64::BITS - span.leading_zeros()).saturating_sub(16).min(31);
        // The whole span divides, not the shifted one: what the shift loses would be an error of the slope.
        let mantissa = (((1 << (31 + shift)) + span / 2) / span) as u32;
        let width = limit.saturating_sub(inner);
        let one = (1 << 31) + (1 << 15) - (mantissa - (mantissa >> shift)) / 2;
        // The last versine short of the limit must not be taken below zero.
        let one = one.max((width.saturating_sub(1) >> shift) * mantissa);
        // Of the whole span, too: `divisor 2^(fine_shift - 32)`.
        let fine_shift = u64::BITS - span.leading_zeros();
        // The upper bit is set already: the compiler cannot know.
        let divisor = (span << span.leading_zeros()) >> 32 | 1 << 31;
        let fine_mantissa = ((1 << 63) / divisor).min(u32::MAX.into()) as u32;
        let inner = inner.min(limit);
        Ramp16 { zoom, inner, width, shift, mantissa, one, fine: 0, fine_shift, fine_mantissa }
    }

    /// That of a fine ramp, whose direction is hardly off: [`DIRECTION_ERROR`](Self::DIRECTION_ERROR) is the coarse one's, and
    /// leaves room for it.
    fn rounding(edge: &Slopes) -> f32 {
        const ROOM: f32 = 0.99 * HALF_A_CODE;
        let fine = edge.angle * 0.25e-6 + edge.fraction * 1e-8 + Self::STEP;
        if fine <= ROOM { 0.0 } else { f32::INFINITY }
    }

    /// A coarse versine is within 2.3e-4 of itself: by the rounding of the reciprocal length, by its table and by the
    /// bits that the offset has lost, 9e-5 and less each; and within half the square of that. The components of the
    /// difference are rounded to integers, 0.87 units in length. The direction is off by 1.36e-5 else. The argument and each
    /// product of a power are rounded to 15 bits; the ramp has 16.
    ///
    /// The largest of all of these do not meet in one place: a search finds 0.84 of their sum, and 0.9 of it
    /// decide.
    fn coarse_error(edge: &Slopes, outer: f32, limit: f32) -> f32 {
        const LENGTH: f32 = 2.3e-4;
        const MET: f32 = 0.9;
        let limit = if limit < outer { limit } else { outer };
        let direction = 1.36e-5 + 0.87 / (1_u32 << (14 + zoom(limit))) as f32;
        // Twice the sine of half an angle is no longer than its arc: what the slope over a narrow cone's angle is a
        // bound of, it is over that of a wide one.
        let chord = trig::sqrt(2.0 * outer);
        let versine =
            edge.angle * (direction / chord + LENGTH / 2.0) + edge.fraction * (LENGTH * LENGTH / 2.0 / outer);
        MET * (versine + edge.fraction * 3.0 / 65_536.0 + 1.5 * Self::STEP)
    }

    fn fine_ramp(inner: f32, outer: f32, limit: f32) -> Ramp16 {
        let ramp = Self::ramp(inner, outer, limit);
        Ramp16 { width: 0, fine: ramp.width, ..ramp }
    }

    #[inline(always)]
    fn rise(ramp: Ramp16, versine: Versine16) -> Rise<Self> {
        match ramp.within(versine) {
            Some(t) => Rise::Coarse(t),
            // No versine is within a fine ramp.
            None if ramp.fine > 0 => Rise::Fine(ramp.rise_finely(versine)),
            None => Rise::Coarse(ramp.end(versine)),
        }
    }

    fn fine_below(error: f32, intensity: f32, grows: bool) -> u32 {
        /// That of a cosine.
        const COSINE: f32 = 2.2e-4;
        /// Where light is not past full scale, a share of a large gain is small, and errs less: a search finds 0.43.
        const BRIGHT: f32 = 0.5556;
        let error = error.max(COSINE) / HALF_A_CODE;
        let squared = BRIGHT * error * intensity;
        if error > 1.0 || (squared > 1.0 && !grows) {
            return u32::MAX;
        }
        if !grows {
            return 0;
        }
        // The squared distance in quanta of a length.
        let squared = ((squared * (1_u64 << 32) as f32) as u64).min((1 << 62) - 1);
        let bits = (u64::BITS - squared.leading_zeros()).div_ceil(2);
        bits << 26 | ((squared << (62 - 2 * bits)) >> 36) as u32
    }

    #[inline(always)]
    fn is_clipped(share: Self, light: Light16) -> bool {
        // A share of 1/32 is off by 6 % at most.
        share.to_bits() > 1 << 9 && light.to_bits() > 9 << 11
    }

    #[inline(always)]
    fn smooth(self) -> Self {
        lobe::smooth(self)
    }

    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> Frame16 {
        Frame16::new(vectors, tangent)
    }

    #[inline(always)]
    fn place(frame: &Frame16, light: Vec3<Length>, point: Vec3<Length>) -> ProjectedPoint<Self> {
        frame.place(light, point)
    }

    #[inline(always)]
    fn weighted_byte(sum: u32) -> Self {
        // 257 / 2^16 is a 255th less 2^-16 of it: a quarter of a step at most, which the rounding makes good at one.
        Self::from_bits((((sum >> 10) * 257 + (1 << 15)) >> 16).min(1 << 14) as i16)
    }

    #[inline(always)]
    fn versine_between(a: Vec3<Fx32>, b: Vec3<Fx32>, ramp: Ramp16) -> Versine16 {
        let shift = MOST_ZOOM - ramp.zoom + 1;
        // The rounding belongs to the second direction: where that is an axis, it is taken once per light. Opposite
        // directions may wrap round, from one difference that is far outside of every cone to another.
        let b = b.map(|c| c.to_bits().wrapping_sub(1 << (shift - 1)));
        let difference = a.zip(b, |a, b| a.to_bits().wrapping_sub(b) >> shift);
        if offset::size(difference) >> 15 != 0 {
            return Versine16::MAX;
        }
        let squares = difference.map(|c| (c * c).cast_unsigned());
        Versine16::from_bits(squares.x + squares.y + squares.z)
    }

    #[inline(always)]
    fn power(versine: Versine16, exponent: u32) -> Self {
        lobe::power(versine, exponent)
    }

    #[inline(always)]
    fn normal_unit(normal: Vec3<Self>) -> Vec3<Fx32> {
        normal.map(|c| Fx32::from_bits(i32::from(c.to_bits()) << 16))
    }

    #[inline(always)]
    fn mirror(direction: Vec3<Fx32>, normal: Vec3<Self>) -> Vec3<Fx32> {
        lobe::mirror(direction, normal)
    }

    #[inline(always)]
    fn direction_between(a: Vec3<Fx32>, b: Vec3<Fx32>) -> Vec3<Fx32> {
        // Half the difference always fits.
        let half = b.zip(a, |b, a| (b.to_bits() >> 1) - (a.to_bits() >> 1));
        Offset16::new(half).ray().direction()
    }

    #[inline(always)]
    fn incidence(direction: Vec3<Fx32>, normal: Vec3<Self>) -> Self {
        lobe::incidence(direction, normal)
    }

    #[inline(always)]
    fn expose(self, gain: Gain16) -> Light16 {
        let fraction = u32::from(self.to_bits().max(0).cast_unsigned());
        shifted(fraction * gain.top(), gain.shift - 16)
    }

    #[inline(always)]
    fn filter(light: Light16, color: Self) -> Light16 {
        let color = u32::from(color.to_bits().max(0).cast_unsigned());
        let (high, low) = (light.to_bits() >> 16, light.to_bits() & 0xffff);
        let high = high * color;
        let high = if high >> 30 == 0 { high << 2 } else { u32::MAX };
        Light16::from_bits(high.saturating_add((low * color + (1 << 13)) >> 14))
    }

    #[inline(always)]
    fn add_light(a: Light16, b: Light16) -> Light16 {
        a.saturating_add(b)
    }

    #[inline(always)]
    fn light_to_gain(light: Light16) -> Gain16 {
        Gain16::normalised(light.to_bits(), 14)
    }

    #[inline(always)]
    fn amplify(light: Light16, gain: Gain16) -> Light16 {
        gain.amplify(light)
    }

    #[inline(always)]
    fn clip(light: Light16) -> Self {
        Self::from_bits(light.to_bits().min(1 << 14) as i16)
    }

    #[inline(always)]
    fn word(self) -> Word {
        Word::Steps14(self.to_bits())
    }
}
