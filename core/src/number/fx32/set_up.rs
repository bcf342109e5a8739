//! What the kernel asks of the 32-bit format beside the evaluation of a point: set-up and its error
//! bounds, projections, colours, and the directions of specular lobes. Its products have 64 bits.

use super::{Fine, FineRay, Frame32, Gain32, Offset32, errors, versine};
use crate::{
    number::{
        Arithmetic, Directions, Errors, Fx32, Length, Light32, Lights, Offset, Places, Placing, Ramps, Rise,
        Slopes, Stages, Types, Versine, Weight32, Word, nearest, raised,
        ramp::{self, FixedRamp, MOST_ZOOM, zoom},
        root::{self, high_half, signed_high_half, wide},
        rounded, sphere,
    },
    vec3::Vec3,
};

/// Returns the inner product of a direction and a normal, with 58 fraction bits.
#[inline]
pub(super) fn inner(direction: Vec3<Fx32>, normal: Vec3<Fx32>) -> i64 {
    let products = direction.zip(normal, |d, n| wide(d.to_bits(), n.to_bits()) >> 2);
    products.x + products.y + products.z
}

/// Returns the cross product of two directions, with 28 fraction bits. Each component is within one unit of 2^-28.
#[inline]
pub(in crate::number) fn cross(a: Vec3<Fx32>, b: Vec3<Fx32>) -> Vec3<Fx32> {
    let [a, b] = [a, b].map(|direction| direction.map(Fx32::to_bits));
    let minor = |a: i32, b: i32, c: i32, d: i32| {
        Fx32::from_bits(signed_high_half(a, b).wrapping_sub(signed_high_half(c, d)))
    };
    Vec3::new(minor(a.y, b.z, a.z, b.y), minor(a.z, b.x, a.x, b.z), minor(a.x, b.y, a.y, b.x))
}

impl Offset32 {
    /// Returns the unit vector along the offset. `lost` is what its components have lost by rounding, with 16
    /// fraction bits.
    ///
    /// Each component is within half a step of its exact value times a common factor, which is within 9.4e-10 of 1.
    /// An axis is computed once, with 64-bit products.
    fn unit(&self, lost: Vec3<i32>) -> Vec3<Fx32> {
        let squares = self.way.map(|c| wide(c, c) as u64);
        let squared = squares.x + squares.y + squares.z;
        let reciprocal = if squared >= 1 << 62 {
            root::inverse_sqrt_32(squared) >> 1
        } else if squared >= 1 << 60 {
            root::inverse_sqrt_32(squared << 2)
        } else {
            0
        };
        self.way.zip(lost, |c, lost| {
            let product = i64::from(c) * reciprocal as i64 + i64::from(lost) * (reciprocal >> 16) as i64;
            Fx32::from_bits(((product + (1 << 31)) >> 32) as i32)
        })
    }
}

/// The margin of the bound for rejecting points outside a cone, of which `number::outside_bound`
/// states the reason, and one step for the rounding of the squared cosine.
const OUTSIDE: i32 = (16 + 1) << 16;

impl Types for Fx32 {
    type Position = Length;
    type Direction = Self;
    type Received = Light32;
    type Versine = Versine;
    type Fraction = Fine;
    type Fine = Fine;
    type FineRay = FineRay;
    type Weight = Weight32;
    type Ramp = FixedRamp;
    type Frame = Frame32;
    type Gain = Gain32;
    type Offset = Offset32;
}

impl Arithmetic for Fx32 {
    #[inline]
    fn from_steps(steps: i32) -> Self {
        Self::from_bits(steps << 16)
    }

    fn weight(value: f32) -> Weight32 {
        Weight32::from_bits(rounded(value.clamp(-4.0, 4.0) * 1_073_741_824.0) as i64)
    }

    fn gain(value: f32) -> Gain32 {
        Gain32::nearest(value)
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        self.saturating_sub(other)
    }

    #[inline]
    fn weighted_byte(sum: u32) -> Self {
        /// `2^38 / 255`. The product of this constant and the sum has at most 63 bits.
        const INVERSE: u64 = 1_077_952_576;
        Self::from_bits(((u64::from(sum) * INVERSE + (1 << 31)) >> 32).min(1 << 30) as i32)
    }

    #[inline]
    fn of_linear(_: impl FnOnce() -> f32, steps24: impl FnOnce() -> u32) -> Self {
        Self::from_bits((steps24() << 6) as i32)
    }

    #[inline]
    fn word(self) -> Word {
        Word::Steps30(self.to_bits())
    }
}

impl Directions for Fx32 {
    /// Uses all bits of the components, and normalises the axis with 64-bit products.
    fn axis(axis: Vec3<f32>) -> Vec3<Self> {
        let scaled = axis.map(|c| c * (1_u32 << 31) as f32);
        let way = scaled.map(nearest);
        // A component of less than 2^-7 may have bits below 2^-31.
        let lost = scaled.zip(way, |c, whole| nearest((c - whole as f32) * 65_536.0));
        Offset32::new(way).unit(lost)
    }

    fn aim(toward: Vec3<f32>, _: Vec3<f32>) -> Vec3<Self> {
        Self::axis(toward)
    }

    #[inline]
    fn cross(a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        cross(a, b)
    }

    #[inline]
    fn offset_along(direction: Vec3<Self>) -> Offset32 {
        Offset32::new(direction.map(Self::to_bits))
    }

    #[inline]
    fn has_direction(offset: &Offset32) -> bool {
        offset.way != Vec3::default()
    }

    #[inline]
    fn fine_ray(offset: &Offset32) -> FineRay {
        offset.ray()
    }

    #[inline]
    fn direction_between(a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        // Half the difference of two components always fits 32 bits.
        Offset32::new(b.zip(a, |b, a| (b.to_bits() >> 1) - (a.to_bits() >> 1))).ray().unit()
    }

    #[inline]
    fn versine_between(a: Vec3<Self>, b: Vec3<Self>, ramp: FixedRamp) -> Versine {
        versine(a.map(Self::to_bits), b, ramp)
    }

    #[inline]
    fn power(versine: Versine, exponent: u32) -> Self {
        /// Returns `1 - x y` from `a = 1 - x` and `b = 1 - y`, with 32 fraction bits.
        #[inline]
        fn complement_of_product(a: u32, b: u32) -> u32 {
            a.saturating_add(b - high_half(a, b))
        }
        let lack = raised(0, versine.to_bits().saturating_mul(8), exponent, complement_of_product);
        let lack = ((lack >> 1) + 1) >> 1;
        Self::from_bits((1 << 30) - lack as i32)
    }

    #[inline]
    fn normal_unit(normal: Vec3<Self>) -> Vec3<Self> {
        normal
    }

    #[inline]
    fn unit_normal(unit: Vec3<Self>) -> Vec3<Self> {
        unit
    }

    #[inline]
    fn unit_of_bytes(bytes: [i8; 3]) -> Vec3<Self> {
        bytes.map(|c| Self::from_bits(i32::from(c) << 23)).into()
    }

    /// The result wraps for vectors that are not of unit length, which is defined behaviour.
    #[inline]
    fn mirror(direction: Vec3<Self>, normal: Vec3<Self>) -> Vec3<Self> {
        let cosine = (inner(direction, normal) + (1 << 27)) >> 28;
        direction.zip(normal, |d, n| {
            let twice_along = cosine.wrapping_mul(n.to_bits().into()).wrapping_add(1 << 28) >> 29;
            Self::from_bits(d.to_bits().wrapping_sub(twice_along as i32))
        })
    }

    #[inline]
    fn incidence(direction: Vec3<Self>, normal: Vec3<Self>) -> Self {
        let cosine = ((1 << 27) - inner(direction, normal)) >> 28;
        Self::from_bits(cosine.clamp(0, 1 << 30) as i32)
    }
}

impl Places for Fx32 {
    fn enclosing(a: Vec3<Length>, b: Vec3<Length>) -> (Vec3<Length>, Length) {
        sphere::enclosing(a, b)
    }

    fn moved_back(tip: Vec3<Length>, axis: Vec3<Self>, bound: Self, radius: Length) -> Option<Vec3<Length>> {
        let squared_sine = Self::ONE.minus(bound).minus(Self::from_bits(OUTSIDE + 1));
        let squared_sine = squared_sine.to_bits().max(0) as u32;
        (bound > Self::ZERO).then(|| sphere::moved_back(tip, axis, squared_sine, radius)).flatten()
    }

    fn along_integers(way: [i32; 3]) -> Vec3<Length> {
        way.map(Length::from_bits).into()
    }

    #[inline]
    fn length_times(length: Length, count: i32) -> Length {
        Length::from_bits(length.to_bits().wrapping_mul(count))
    }

    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> Frame32 {
        Frame32::new(vectors, tangent)
    }

    #[inline]
    fn project(frame: &Frame32, light: Vec3<Length>, point: Vec3<Length>) -> ([i32; 2], Length) {
        frame.project(light, point)
    }
}

impl Ramps for Fx32 {
    fn ramp(inner: f32, outer: f32, limit: f32) -> FixedRamp {
        FixedRamp::new(inner, outer, limit)
    }

    fn zoomed(from: FixedRamp, to: FixedRamp, part: Self) -> (FixedRamp, Self) {
        let (ramp, chords) = from.between(to, (part.to_bits() as u32) << 2, MOST_ZOOM);
        (ramp, Self::from_bits(chords.squared_cosine() as i32 - OUTSIDE))
    }

    fn versine(ramp: FixedRamp, value: f32) -> Versine {
        ramp.versine(value)
    }

    #[inline]
    fn rise(ramp: FixedRamp, versine: Versine) -> Rise<Self> {
        Rise::Coarse(ramp.rise_finely(versine))
    }
}

impl Errors for Fx32 {
    // The components of a direction are within one step of 2^-30 and those of an axis within half a
    // step, up to a common factor: together they turn by `1.5 sqrt(3) / 2^30 = 2.42e-9`. Two errors
    // of a versine are largest, relative to the outer versine, in the narrowest cone, a step with a
    // half angle `a` of 1.35e-6: half the square of the difference of the two lengths, at most 2.4e-8 and
    // 1.75e-9, is as much as a turn by `(2.575e-8)^2 / 2 a = 2.46e-10`, and the last place of the versine by
    // `3 / 2^59 a = 4e-12`. The constant does not include the halving of an offset with a component
    // of more than 32,768 units, which turns the direction by 0.71 steps more.
    const DIRECTION_ERROR: f32 = 2.68e-9;
    const CHORD_ERROR: f32 = ramp::CHORD_ERROR;
    const CHORD_STEP: f32 = ramp::CHORD_STEP;
    const LOSES_HIDDEN: bool = true;
    const NEAREST: f64 = 1.0 / 65_536.0;
    const OUTSIDE_STEP: f32 = 1.0 / (1 << 14) as f32;

    /// Adds the other error terms:
    ///
    /// - The versines computed at set-up are `f32`, with a relative error of at most 4e-7.
    /// - The length of a direction has an error of at most 2.4e-8.
    /// - A versine is rounded down by less than 3 units of its last place, 1.2e-8 of the outer versine.
    /// - The falloff's argument `t` and the products after it have 31 fraction bits.
    fn rounding(edge: &Slopes) -> f32 {
        const LENGTH: f32 = 2.4e-8;
        edge.angle * (0.21e-6 + LENGTH / 2.0 + 0.6e-8)
            + (edge.fraction + edge.beside_axis) * 3e-9
            + 3.0 * LENGTH
    }

    fn edge_error(outer: f32) -> f32 {
        ramp::edge_error(outer)
    }

    fn inner_chord_error(inner: f32, limit: f32) -> f32 {
        ramp::inner_chord_error(inner, limit)
    }

    fn stages(_: f64) -> Stages {
        errors::STAGES
    }

    fn placing(_: bool) -> Placing {
        errors::PLACING
    }

    fn magnification(limit: f32) -> f64 {
        f64::from(1_u32 << zoom(limit))
    }
}

impl Lights for Fx32 {
    #[inline]
    fn filter(light: Light32, color: Self) -> Light32 {
        let color = u64::from(color.to_bits().max(0) as u32);
        let (high, low) = (light.to_bits() >> 32, light.to_bits() & 0xffff_ffff);
        let high = high * color;
        let high = if high >> 62 == 0 { high << 2 } else { u64::MAX };
        Light32::from_bits(high.saturating_add((low * color + (1 << 29)) >> 30))
    }

    #[inline]
    fn light_from_f32(value: f32) -> Light32 {
        Light32::from_f32(value)
    }

    #[inline]
    fn mean_light(a: Light32, b: Light32) -> Light32 {
        Light32::from_bits(u64::midpoint(a.to_bits(), b.to_bits()))
    }

    #[inline]
    fn light_to_gain(light: Light32) -> Gain32 {
        Gain32::normalised(light.to_bits(), 30)
    }

    #[inline]
    fn amplify(light: Light32, gain: Gain32) -> Light32 {
        let (factor, scale) = (u64::from(gain.mantissa), gain.shift);
        let (high, low) = ((light.to_bits() >> 32) * factor, (light.to_bits() & 0xffff_ffff) * factor);
        if scale < 32 {
            Light32::shifted(high, scale - 32).saturating_add(Light32::shifted(low, scale))
        } else {
            Light32::shifted(high + (low >> 32), scale - 32)
        }
    }

    #[inline]
    fn clip(light: Light32) -> Self {
        Self::from_bits(light.to_bits().min(1 << 30) as i32)
    }

    #[inline]
    fn light_steps(light: Light32) -> u32 {
        (light.to_bits() >> 16).try_into().unwrap_or(u32::MAX)
    }
}
