//! What the kernel asks of the 16-bit format beside the evaluation of a point: set-up and its error
//! bounds, projections, colours, and the directions of specular lobes.

use super::{
    Fraction16, Frame16, Gain16, OUTSIDE, Offset16, WAY_BITS, errors, factor, outside_bound, thirty_two_bits,
    versine,
};
use crate::{
    number::{
        Arithmetic, Directions, Errors, Fx16, Fx32, HALF_A_CODE, KEPT, Length, Light16, Lights, Offset,
        Places, Placing, Ramps, Ray, Rise, Scalar, Slopes, Stages, Types, Versine, Weight16, Word,
        fx32::{Fine, FineRay},
        raised,
        ramp::{self, FixedRamp, MOST_ZOOM, zoom},
        root, rounded, sphere,
    },
    trig,
    vec3::Vec3,
};

/// Returns the squared distance within which points need the fine evaluation; infinity for all points.
fn fine_squared(error: f32, intensity: f32, growth: f32) -> f32 {
    /// Error of a cosine in the coarse evaluation, relative to half a linear code.
    const COSINE: f32 = 2.2e-4 / HALF_A_CODE;
    /// Factor below 1, because the error of a small share is smaller than the bound.
    ///
    /// Light within full scale at a large gain has a small share. With this factor a search
    /// finds errors below half a linear code of usual lights, and up to 1.62 of any falloff and attenuation.
    const BRIGHT: f32 = 0.5556;
    /// Factor above 1, for moving points and for the error of the cosine.
    ///
    /// The error of a moving point jumps where the evaluation changes from coarse to fine. With
    /// this factor a search finds errors below half a linear code against the trend of a
    /// moving point's light; without it, errors above.
    const MOVING: f32 = 1.04;
    let error = error / HALF_A_CODE;
    let squared = BRIGHT * (MOVING * error).max(COSINE) * intensity;
    if error > 1.0 || (squared > 1.0 && growth == 0.0) {
        return f32::INFINITY;
    }
    if growth == 0.0 || growth == 2.0 {
        return if growth == 0.0 { 0.0 } else { squared };
    }
    trig::real_power(squared.into(), f64::from(2.0 / growth)) as f32
}

impl Types for Fx16 {
    type Position = Length;
    type Direction = Fx32;
    type Received = Light16;
    type Versine = Versine;
    type Fraction = Fraction16;
    type Fine = Fine;
    type FineRay = FineRay;
    type Weight = Weight16;
    type Ramp = FixedRamp;
    type Frame = Frame16;
    type Gain = Gain16;
    type Offset = Offset16;
}

impl Arithmetic for Fx16 {
    #[inline]
    fn from_steps(steps: i32) -> Self {
        Self::from_bits(steps as i16)
    }

    fn weight(value: f32) -> Weight16 {
        Weight16::from_bits(rounded(value.clamp(-4.0, 4.0) * 16_384.0) as i32)
    }

    fn gain(value: f32) -> Gain16 {
        Gain16::nearest(value)
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        self.saturating_sub(other)
    }

    #[inline]
    fn weighted_byte(sum: u32) -> Self {
        // `257 / 2^16 = (1 - 2^-16) / 255`. The difference from `1 / 255` changes the result by at
        // most a quarter of a step, so the rounding still gives exactly 1 if all bytes are 255.
        Self::from_bits((((sum >> 10) * 257 + (1 << 15)) >> 16).min(1 << 14) as i16)
    }

    #[inline]
    fn of_linear(_: impl FnOnce() -> f32, steps24: impl FnOnce() -> u32) -> Self {
        Self::from_bits(((steps24() + (1 << 9)) >> 10) as i16)
    }

    #[inline]
    fn word(self) -> Word {
        Word::Steps14(self.to_bits())
    }
}

impl Directions for Fx16 {
    fn axis(axis: Vec3<f32>) -> Vec3<Fx32> {
        axis.map(Fx32::from_f32)
    }

    #[inline]
    fn offset_along(direction: Vec3<Fx32>) -> Offset16 {
        Offset16::new(direction.map(Fx32::to_bits))
    }

    #[inline]
    fn has_direction(offset: &Offset16) -> bool {
        offset.way != Vec3::default()
    }

    #[inline(always)] // `falloff-alone` on Cortex-M0: +80 instructions without.
    fn fine_ray(offset: &Offset16) -> FineRay {
        let whole = offset.way.map(|c| c << (31 - WAY_BITS - offset.shift));
        FineRay::new(whole, root::inverse_sqrt_16(offset.squared()), offset.bits)
    }

    #[inline]
    fn direction_between(a: Vec3<Fx32>, b: Vec3<Fx32>) -> Vec3<Fx32> {
        // Half the difference of two components always fits 32 bits.
        Offset16::new(b.zip(a, |b, a| (b.to_bits() >> 1) - (a.to_bits() >> 1))).ray().direction()
    }

    #[inline]
    fn cross(a: Vec3<Fx32>, b: Vec3<Fx32>) -> Vec3<Fx32> {
        Fx32::cross(a, b)
    }

    #[inline]
    fn versine_between(a: Vec3<Fx32>, b: Vec3<Fx32>, ramp: FixedRamp) -> Versine {
        versine(a, b, ramp)
    }

    #[inline]
    fn power(versine: Versine, exponent: u32) -> Self {
        /// Returns `1 - x y` from `a = 1 - x` and `b = 1 - y`, with 32 fraction bits.
        #[inline]
        fn complement_of_product(a: u32, b: u32) -> u32 {
            a.saturating_add(b - (a >> 16) * (b >> 16))
        }
        let lack = raised(0, versine.to_bits().saturating_mul(8), exponent, complement_of_product);
        let lack = ((lack >> 17) + 1) >> 1;
        Self::from_bits(((1 << 14) - lack) as i16)
    }

    #[inline]
    fn normal_unit(normal: Vec3<Self>) -> Vec3<Fx32> {
        normal.map(|c| Fx32::from_bits(i32::from(c.to_bits()) << 16))
    }

    #[inline]
    fn unit_normal(unit: Vec3<Fx32>) -> Vec3<Self> {
        unit.map(|c| Self::from_bits(((c.to_bits() + (1 << 15)) >> 16) as i16))
    }

    #[inline]
    fn unit_of_bytes(bytes: [i8; 3]) -> Vec3<Fx32> {
        bytes.map(|c| Fx32::from_bits(i32::from(c) << 23)).into()
    }

    /// The result wraps for vectors that are not of unit length, which is defined behaviour.
    #[inline]
    fn mirror(direction: Vec3<Fx32>, normal: Vec3<Self>) -> Vec3<Fx32> {
        let products = direction
            .zip(normal, |d, n| (((d.to_bits() >> 14) + 1) >> 1).wrapping_mul(i32::from(n.to_bits())));
        let cosine = products.x.wrapping_add(products.y).wrapping_add(products.z).wrapping_add(1 << 13) >> 14;
        direction.zip(normal, |d, n| {
            let along = cosine.wrapping_mul(i32::from(n.to_bits()));
            Fx32::from_bits(d.to_bits().wrapping_sub(along.wrapping_mul(4)))
        })
    }

    /// The sum wraps for vectors that are not of unit length, which is defined behaviour.
    #[inline]
    fn incidence(direction: Vec3<Fx32>, normal: Vec3<Self>) -> Self {
        let products = direction
            .zip(normal, |d, n| (((d.to_bits() >> 15) + 1) >> 1).wrapping_mul(i32::from(n.to_bits())));
        let along = products.x.wrapping_add(products.y).wrapping_add(products.z);
        let cosine = (1_i32 << 13).wrapping_sub(along) >> 14;
        Self::from_bits(cosine.clamp(0, 1 << 14) as i16)
    }
}

impl Places for Fx16 {
    fn enclosing(a: Vec3<Length>, b: Vec3<Length>) -> (Vec3<Length>, Length) {
        sphere::enclosing(a, b)
    }

    fn moved_back(tip: Vec3<Length>, axis: Vec3<Fx32>, bound: Self, radius: Length) -> Option<Vec3<Length>> {
        let squared_sine = factor(Self::ONE.minus(bound).minus(Self::from_bits(OUTSIDE + 1)));
        (bound > Self::ZERO).then(|| sphere::moved_back(tip, axis, squared_sine << 16, radius)).flatten()
    }

    fn along_integers(way: [i32; 3]) -> Vec3<Length> {
        way.map(Length::from_bits).into()
    }

    #[inline]
    fn length_times(length: Length, count: i32) -> Length {
        Length::from_bits(length.to_bits().wrapping_mul(count))
    }

    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> Frame16 {
        Frame16::new(vectors, tangent)
    }

    #[inline(always)]
    fn project(frame: &Frame16, light: Vec3<Length>, point: Vec3<Length>) -> ([i32; 2], Length) {
        frame.project(light, point)
    }
}

impl Ramps for Fx16 {
    fn ramp(inner: f32, outer: f32, limit: f32) -> FixedRamp {
        FixedRamp::new(inner, outer, limit)
    }

    fn fine_ramp(inner: f32, outer: f32, limit: f32) -> FixedRamp {
        FixedRamp::new(inner, outer, limit).into_fine()
    }

    fn zoomed(from: FixedRamp, to: FixedRamp, part: Self) -> (FixedRamp, Self) {
        let (ramp, chords) = from.between(to, thirty_two_bits(part), MOST_ZOOM);
        (ramp, outside_bound(chords))
    }

    fn versine(ramp: FixedRamp, value: f32) -> Versine {
        ramp.versine(value)
    }

    #[inline]
    fn rise(ramp: FixedRamp, versine: Versine) -> Rise<Self> {
        match ramp.within(versine) {
            Some(t) => Rise::Coarse(t),
            // For a fine ramp `within` returns `None`, because the `width` of a fine ramp is 0.
            None if ramp.fine > 0 => Rise::Fine(ramp.rise_finely(versine)),
            None => Rise::Coarse(ramp.end(versine)),
        }
    }
}

impl Errors for Fx16 {
    const DIRECTION_ERROR: f32 = 1.55e-5;
    const CHORD_ERROR: f32 = ramp::CHORD_ERROR;
    const CHORD_STEP: f32 = ramp::CHORD_STEP;
    const LOSES_HIDDEN: bool = true;
    const NEAREST: f64 = 1.0 / 65_536.0;
    const OUTSIDE_STEP: f32 = Self::STEP;

    /// Returns zero if the fine evaluation stays within half a linear code, else infinity.
    ///
    /// The rounding error of the fine evaluation need not be added to the direction's error.
    /// [`DIRECTION_ERROR`](Self::DIRECTION_ERROR) is the error of the coarse direction. The error
    /// of the fine direction is smaller by more than the rounding error.
    fn rounding(edge: &Slopes) -> f32 {
        const ROOM: f32 = 0.99 * HALF_A_CODE;
        let fine = edge.angle * 0.25e-6 + (edge.fraction + edge.beside_axis) * 1e-8 + Self::STEP;
        if fine <= ROOM { 0.0 } else { f32::INFINITY }
    }

    /// Adds the error terms of the coarse evaluation:
    ///
    /// - The relative error of a versine is at most 2.3e-4. This error comes from the rounding of
    ///   the reciprocal length, from the table of reciprocal lengths and from the truncated bits of
    ///   the offset, each at most 9e-5. A versine also has an absolute error of half the square of
    ///   2.3e-4.
    /// - The three components of the difference between direction and axis are rounded to integers:
    ///   together an error of 0.87 units in length.
    /// - The remaining error of the direction is 1.36e-5 radians.
    /// - The falloff's argument `t` and each product of a power are rounded to 15 fraction bits.
    ///   The ramp computes with 16 bits.
    ///
    /// The terms do not have their maxima at the same point: searches find errors below the
    /// bound, which is 0.9 of the sum of the terms.
    fn coarse_error(edge: &Slopes, outer: f32, limit: f32) -> f32 {
        const LENGTH: f32 = 2.3e-4;
        const MET: f32 = 0.9;
        let direction = 1.36e-5 + 0.87 / (1_u32 << (14 + zoom(limit))) as f32;
        // The chord `2 sin(theta / 2)` is not longer than the arc `theta`. So the bound of a narrow
        // cone's derivative with respect to the angle, taken with respect to the chord, also holds
        // for a wide cone.
        let chord = trig::sqrt(2.0 * outer);
        let versine =
            edge.angle * (direction / chord + LENGTH / 2.0) + edge.fraction * (LENGTH * LENGTH / 2.0 / outer);
        // Beside the axis both terms are largest at one point.
        let strip = edge.beside_axis * (LENGTH * LENGTH / 2.0 / outer + 3.0 / 65_536.0);
        MET * (versine + edge.fraction * 3.0 / 65_536.0 + 1.5 * Self::STEP) + strip
    }

    fn edge_error(outer: f32) -> f32 {
        ramp::edge_error(outer)
    }

    fn inner_chord_error(inner: f32, limit: f32) -> f32 {
        ramp::inner_chord_error(inner, limit)
    }

    fn fine_below(error: f32, intensity: f32, growth: f32) -> u32 {
        // The squared distance, in units of the square of 2^-16 (the step of a length).
        let squared = fine_squared(error, intensity, growth) * (1_u64 << 32) as f32;
        // No offset has more than 32 bits.
        if squared >= (1_u64 << 63) as f32 * 2.0 {
            return u32::MAX;
        }
        let squared = squared as u64;
        let bits = (u64::BITS - squared.leading_zeros()).div_ceil(2);
        let upper = squared.checked_shl(u64::BITS - 2 * bits).unwrap_or(0) >> 38;
        bits << 26 | upper as u32
    }

    /// Decodes what points are compared with, so that its roundings are no error of this distance.
    fn fine_within(error: f32, intensity: f32, growth: f32) -> f64 {
        let below = Self::fine_below(error, intensity, growth);
        if below == u32::MAX {
            return f64::INFINITY;
        }
        let (bits, upper) = (below >> 26, below & ((1 << 26) - 1));
        // `2^(bits - 13)` steps of a length, of 2^-16 each.
        trig::square_root(upper.into()) * (1_u64 << bits) as f64 / (1_u64 << 29) as f64
    }

    #[inline]
    fn is_clipped(share: Self, light: Light16) -> bool {
        // The relative error of a share of 1/32 or more is at most 6 %, so light above 1.125
        // exceeds full scale.
        let [least_share, least_light] = KEPT;
        i32::from(share.to_bits()) > least_share as i32 && light.to_bits() > least_light
    }

    fn distribution_error(steepness: f32) -> f32 {
        let (placing, turn) = (errors::COARSE_PLACING, errors::coarse(u32::BITS).turn);
        (f64::from(steepness) * placing.error(turn, 1.0) + placing.cell) as f32
    }

    fn stages(distance: f64) -> Stages {
        errors::coarse(errors::bits_at(distance))
    }

    fn fine_stages(far: f64) -> Stages {
        if far < 256.0 { errors::FINE } else { errors::FAR }
    }

    fn larger_errors_from(distance: f64) -> f64 {
        errors::more_bits_from(distance)
    }

    fn placing(is_fine: bool) -> Placing {
        if is_fine { errors::FINE_PLACING } else { errors::COARSE_PLACING }
    }

    fn magnification(limit: f32) -> f64 {
        f64::from(1_u32 << zoom(limit))
    }
}

impl Lights for Fx16 {
    #[inline]
    fn filter(light: Light16, color: Self) -> Light16 {
        let color = factor(color);
        let (high, low) = (light.to_bits() >> 16, light.to_bits() & 0xffff);
        let high = high * color;
        let high = if high >> 30 == 0 { high << 2 } else { u32::MAX };
        Light16::from_bits(high.saturating_add((low * color + (1 << 13)) >> 14))
    }

    #[inline(always)]
    fn filter_each<const N: usize>(lights: &[Light16; N], color: Self) -> [Light16; N] {
        // Nearly always no light is 8 or more, and the products fit 32 bits: a quarter of the instructions.
        let mut filtered = *lights;
        if lights.iter().fold(0, |all, light| all | light.to_bits()) >> 17 == 0 {
            let color = factor(color);
            for light in &mut filtered {
                *light = Light16::from_bits((light.to_bits() * color + (1 << 13)) >> 14);
            }
        } else {
            filtered.iter_mut().for_each(|light| *light = Self::filter(*light, color));
        }
        filtered
    }

    #[inline]
    fn light_from_f32(value: f32) -> Light16 {
        Light16::from_f32(value)
    }

    #[inline(always)]
    fn lights_from_f32<const N: usize>(values: &[f32; N]) -> [Light16; N] {
        // From this number to its double, an f32 has steps of 1. Unlike a conversion that saturates, the sum is
        // one vector instruction.
        const INTEGERS: f32 = 8_388_608.0;
        const MOST: f32 = INTEGERS / 16_384.0 - 1.0;
        let mut lights = [Light16::ZERO; N];
        if values.iter().fold(true, |all, value| all & (*value < MOST)) {
            for (light, &value) in lights.iter_mut().zip(values) {
                let steps = (if value > 0.0 { value * 16_384.0 } else { 0.0 }) + INTEGERS;
                *light = Light16::from_bits(steps.to_bits() - INTEGERS.to_bits());
            }
        } else {
            lights.iter_mut().zip(values).for_each(|(light, &value)| *light = Light16::from_f32(value));
        }
        lights
    }

    #[inline]
    fn mean_light(a: Light16, b: Light16) -> Light16 {
        Light16::from_bits(u32::midpoint(a.to_bits(), b.to_bits()))
    }

    #[inline]
    fn light_to_gain(light: Light16) -> Gain16 {
        Gain16::normalised(light.to_bits(), 14)
    }

    #[inline]
    fn amplify(light: Light16, gain: Gain16) -> Light16 {
        let (factor, scale) = (gain.factor(), gain.scale());
        let (high, low) = ((light.to_bits() >> 16) * factor, (light.to_bits() & 0xffff) * factor);
        if scale < 16 {
            Light16::shifted(high, scale - 16).saturating_add(Light16::shifted(low, scale))
        } else {
            Light16::shifted(high + (low >> 16), scale - 16)
        }
    }

    #[inline]
    fn clip(light: Light16) -> Self {
        Self::from_bits(light.to_bits().min(1 << 14) as i16)
    }

    #[inline]
    fn light_steps(light: Light16) -> u32 {
        light.to_bits()
    }
}
