//! A view ray as seen from a light: an arc of a great circle, in 32-bit products.
//!
//! The formulas are those of [`haze`](super). Vectors have 30 fraction bits. In a narrow cone
//! `v = tan(psi/2)` is small and would lose its leading bits, so it is scaled by `2^zoom` of the
//! cone's ramp, and versines by `4^zoom`.

use crate::number::{
    Fx32, Gain, Length, Versine,
    fx16::Gain16,
    fx32::normalised,
    root::{
        self, high_half, high_product, high_square, quick_inverse_16, signed_high_half, signed_high_product,
        size,
    },
};
use crate::vec3::Vec3;

/// A vector as its direction and its length.
#[derive(Clone, Copy, Debug)]
struct Polar {
    /// The vector, scaled until its largest component has 31 bits.
    scaled: Vec3<i32>,
    /// `2^(15 + bits)` over the length, of 15 or 16 bits.
    reciprocal: u32,
    /// The squared length of the vector, scaled until its largest component has 15 bits.
    squared: u32,
    /// Bit length of the largest component.
    bits: i32,
}

impl Polar {
    #[inline(never)]
    fn of(vector: Vec3<i32>) -> Self {
        let bits = root::bit_length(size(vector));
        let scaled = vector.map(|c| c << (31 - bits));
        let squares = scaled.map(|c| {
            let rounded = (c >> 16) + ((c >> 15) & 1);
            (rounded * rounded) as u32
        });
        let squared = squares.x + squares.y + squares.z;
        let reciprocal = root::inverse_sqrt_16(squared);
        Self { scaled, reciprocal, squared, bits: bits as i32 }
    }

    /// Returns the unit vector with 30 fraction bits; its length is within 1.6e-4 of 1.
    #[inline]
    fn direction(&self) -> Vec3<i32> {
        self.scaled.map(|c| signed_high_product(c, self.reciprocal))
    }

    /// Returns the unit vector with 30 fraction bits; its length is within 3e-8 of 1.
    #[inline(never)]
    fn fine_direction(&self) -> Vec3<i32> {
        normalised(self.direction()).0
    }

    /// Returns the length of a vector with this number of fraction bits.
    #[inline]
    fn length(&self, fraction_bits: i32) -> Gain16 {
        Gain16::normalised(high_product(self.squared, self.reciprocal), 29 - self.bits + fraction_bits)
    }
}

/// Returns the scalar product of two vectors with 30 fraction bits, with 28 fraction bits.
#[inline(never)]
fn dot(a: Vec3<i32>, b: Vec3<i32>) -> i32 {
    let products = a.zip(b, signed_high_half);
    products.x.wrapping_add(products.y).wrapping_add(products.z)
}

/// Returns the vector product of two vectors with 30 fraction bits, with 28 fraction bits.
#[inline(never)]
fn cross(a: Vec3<i32>, b: Vec3<i32>) -> Vec3<i32> {
    let difference =
        |a: i32, b: i32, c: i32, d: i32| signed_high_half(a, b).wrapping_sub(signed_high_half(c, d));
    Vec3::new(difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z), difference(a.x, b.y, a.y, b.x))
}

/// A vector orthogonal to two directions.
struct Normal {
    /// The vector product, with `28 + up` fraction bits.
    product: Vec3<i32>,
    up: i32,
    /// Whether the angle between the directions is less than a right angle.
    is_acute: bool,
}

impl Normal {
    /// Returns the normal of two directions with 30 fraction bits.
    ///
    /// One factor is the difference of the directions, or their sum if that is shorter. So the
    /// product keeps its leading bits for directions that are nearly equal or nearly opposite.
    #[inline(never)]
    fn of(a: Vec3<i32>, b: Vec3<i32>) -> Self {
        let difference = b.zip(a, |b, a| (b >> 1) - (a >> 1));
        let sum = b.zip(a, |b, a| (b >> 1) + (a >> 1));
        let is_acute = size(difference) < size(sum);
        let step = if is_acute { difference } else { sum };
        let up = 30 - root::bit_length(size(step)).min(30);
        Self { product: cross(a, step.map(|c| c << up)), up: up as i32 - 1, is_acute }
    }
}

/// A part of a view ray, as seen from a light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord {
    /// The offsets of the ends from the light.
    eye: Vec3<i32>,
    surface: Vec3<i32>,
    /// The difference of the ends.
    way: Vec3<i32>,
    /// The additional fraction bits of the two offsets.
    more: [i32; 2],
    /// The unit of length is `2^(unit - 16)`.
    unit: i32,
}

impl Chord {
    /// Returns the chord between two points.
    ///
    /// Lengths are in units of 2^-15 if a coordinate has more than 30 bits.
    #[inline]
    pub(super) fn between(light: Vec3<Length>, eye: Vec3<Length>, surface: Vec3<Length>) -> Self {
        let [light, eye, surface] = [light, eye, surface].map(|point| point.map(Length::to_bits));
        let unit = if (size(light) | size(eye) | size(surface)) >> 30 == 0 { 0 } else { 1 };
        let difference = |to: Vec3<i32>, from: Vec3<i32>| to.zip(from, |t, f| (t >> unit) - (f >> unit));
        let way = difference(surface, eye);
        Self { eye: difference(eye, light), surface: difference(surface, light), way, more: [0; 2], unit }
    }

    /// Returns the part of the chord that is outside the light's body and not hidden by it; `None`
    /// if there is no such part.
    #[cold]
    pub(super) fn outside(self, body: Length) -> Option<Self> {
        let body = i64::from(body.to_bits() >> self.unit).clamp(0, 1 << 28);
        // Directions from the body's surface need more fraction bits than coordinates have.
        let more = (body.leading_zeros() as i32 - 36).clamp(0, 12);
        let body = body << more;
        let direction = Polar::of(self.way).fine_direction();
        let dot = |offset: Vec3<i64>| {
            let products = offset.zip(direction, times);
            products.x + products.y + products.z
        };
        let moved = |offset: Vec3<i64>, by: i64| offset.zip(direction, |o, d| o + times(by, d));
        // Orthogonalises twice: the length of the direction has an error of up to 3e-8, and after one step
        // twice this part of a long offset is left along the ray, which may be longer than the body.
        let along = |offset: Vec3<i64>| {
            let nearly = dot(offset);
            nearly + dot(moved(offset, -nearly))
        };
        let [eye, surface] = [self.eye, self.surface].map(|offset| offset.map(|c| i64::from(c) << more));
        let [first, last] = [eye, surface].map(along);
        let foot = moved(eye, -first);
        // A foot outside the body has a component that may be too large to square.
        let squares = foot.map(|c| c.clamp(-body - 1, body + 1).pow(2));
        let rest = body * body - (squares.x + squares.y + squares.z);
        if rest <= 0 {
            return Some(self);
        }
        let half = i64::from(sqrt(rest as u64));
        let end = |by: i64| moved(foot, by).map(|c| c as i32);
        let way = |by: i64| direction.map(|d| (times(by, d) >> more) as i32);
        if first.abs() < half {
            let [_, there] = self.more;
            let rest = Self { eye: end(half), way: way(last - half), more: [more, there], ..self };
            (last > half).then_some(rest)
        } else if first < 0 && last > -half {
            let [here, _] = self.more;
            Some(Self { surface: end(-half), way: way(-half - first), more: [here, more], ..self })
        } else {
            Some(self)
        }
    }
}

/// Returns `a b / 2^30` for `a` of 44 bits and `b` of 31 bits.
#[inline(never)]
fn times(a: i64, b: i32) -> i64 {
    let b = i64::from(b);
    ((a >> 16) * b + (((a & 0xffff) * b) >> 16)) >> 14
}

/// Returns the square root of a positive number below 2^58, with a relative error of at most
/// 1e-4.
fn sqrt(n: u64) -> u32 {
    let up = n.leading_zeros() & !1;
    let leading = ((n << (up & 63)) >> 32) as u32;
    high_product(leading, root::inverse_sqrt_16(leading)) >> (up / 2 - 2).min(31)
}

/// A view ray as an arc of directions, measured by `v` from the direction that is nearest to the
/// axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc16 {
    zoom: u32,
    /// The versine of the angle between the axis and the circle, scaled, with 29 fraction bits.
    least: u32,
    /// The cosine of this angle, with 15 fraction bits.
    radius: u32,
    /// `v` at the ends of the arc, scaled, with 30 fraction bits, in `[-2, 2]`.
    ends: [i32; 2],
    /// Whether the arc passes the direction opposite to the one nearest to the axis.
    is_around: bool,
    /// Whether the arc is too short for the difference of its ends.
    is_short: bool,
    /// The length of the chord over the product of the distances of its ends.
    worth: Gain16,
    /// The reciprocal of the distance of the line from the light.
    pub(super) nearness: Gain16,
}

/// `v` opposite the axis, and for all directions that are outside every cone: just under 2.
const OPPOSITE: i32 = i32::MAX;

/// Shortest arc, relative to the cone's edge, as a power of two.
///
/// A shorter arc is lengthened to this, so that its mean is computed although both ends may have the
/// same value.
const SHORTEST: u32 = 12;

/// A part of an arc, in `v`, with 30 fraction bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span16 {
    pub(super) from: i32,
    pub(super) to: i32,
}

impl Arc16 {
    /// Computes the arc of a chord; `None` if the line of the chord misses every cone of this zoom.
    #[inline(never)]
    pub(super) fn new(chord: &Chord, axis: Vec3<Fx32>, zoom: u32) -> Option<Self> {
        let axis = axis.map(Fx32::to_bits);
        let Chord { eye, surface, way, more: [here, there], unit } = *chord;
        let [first, last, way] = [eye, surface, way].map(Polar::of);
        // `|way| / (|eye| |surface|)`.
        let shift = first.bits - here + last.bits - there - 2 + unit;
        let worth = Gain16::normalised(first.reciprocal * last.reciprocal, shift).times(way.length(16));

        let [first, last] = [first.fine_direction(), last.fine_direction()];
        let Normal { mut product, up, is_acute } = Normal::of(first, last);
        // Any circle through the eye's direction replaces that of a line through the light.
        let is_radial = size(product) < 1 << 10;
        if is_radial {
            product = Normal::of(first, axis).product;
        }
        let normal = Polar::of(product);

        let direction = normal.direction();
        let sine = dot(direction, axis);
        if sine.unsigned_abs() >> (29 - zoom) != 0 {
            return None;
        }
        let squared_sine = high_square(sine << (zoom + 1));
        let toward = cross(direction, axis);
        let radius = {
            let toward = Polar::of(toward);
            let length = high_product(toward.squared, toward.reciprocal);
            (length >> (42 - toward.bits).clamp(0, 31)).min(1 << 15)
        };
        let least = high_product(squared_sine, quick_inverse_16(((1 << 15) + radius).min(65_535))) << 3;

        let toward = toward.map(|c| c.wrapping_shl(2));
        let radius_28 = (radius << 13) as i32;
        let [from, to] = [first, last].map(|direction| {
            let cosine = dot(axis, direction);
            End { sine: dot(toward, direction), cosine, one_plus_cosine: radius_28.wrapping_add(cosine) }
        });
        // An arc of less than a half circle between two such directions has no direction between
        // them that is nearer to the axis.
        if from.cosine < 0 && to.cosine < 0 {
            return None;
        }
        let is_around = from.sine > 0 && to.sine < 0 && (from.cosine < 0 || to.cosine < 0);
        let is_around = is_around && !from.is_opposite() && !to.is_opposite();
        // Opposite the axis, the sign of the sine may be that of a rounding error.
        let ends = [
            if from.is_opposite() { -OPPOSITE } else { from.tangent(zoom) },
            if to.is_opposite() { OPPOSITE } else { to.tangent(zoom) },
        ];

        let bits = normal.bits - 28 - up;
        let nearness = if is_radial {
            Gain16::HUGE
        } else {
            worth.times(Gain16::normalised(normal.reciprocal, 15 + bits))
        };
        let is_short = is_acute && (is_radial || bits + (zoom as i32) < -9);
        Some(Self { zoom, least, radius, ends, is_around, is_short, worth, nearness })
    }

    /// Returns the `v` at which the circle leaves a cone; zero if it does not meet the cone.
    ///
    /// `versine` is scaled and at most 2, `rest` is 1 less the versine without the scale; both have
    /// 29 fraction bits.
    #[inline(never)]
    pub(super) fn edge(&self, versine: u32, rest: u32) -> i32 {
        let over = versine.saturating_sub(self.least).min(1 << 30);
        // `over / sqrt(over divisor)`; the product has 26 fraction bits.
        let product = high_half(over, rest + (self.radius << 14)).max(1);
        let up = (32 - root::bit_length(product)) & !1;
        (high_product(over, root::inverse_sqrt_16(product << up)) << (up / 2)).min(OPPOSITE as u32) as i32
    }

    /// Returns the part of the arc within an [`edge`](Self::edge), and the factor of an integral of
    /// `2 / (1 + v^2)` over it; an empty part unless `from < to`.
    #[inline]
    pub(super) fn span(&self, edge: i32) -> (Span16, Gain16) {
        let [from, to] = self.ends;
        if self.is_around {
            let span = if from < edge { Span16 { from, to: edge } } else { Span16 { from: -edge, to } };
            return (span, self.long());
        }
        let (begin, scale) = if self.is_short {
            let kept = to.saturating_sub(from).max(edge >> SHORTEST).max(1);
            (to.saturating_sub(kept), self.short([from, to], kept as u32))
        } else {
            (from, self.long())
        };
        (Span16 { from: begin.max(-edge), to: to.min(edge) }, scale)
    }

    /// Returns the factor of a long arc: `1 / height`, without the scale of `v`.
    #[inline]
    fn long(&self) -> Gain16 {
        self.nearness.halved(self.zoom as i32 - 1)
    }

    /// Returns the factor of a short arc: its mean times `worth`.
    #[cold]
    fn short(&self, [from, to]: [i32; 2], kept: u32) -> Gain16 {
        let product = signed_high_half(from >> 1, to >> 1) >> (11 + 2 * self.zoom).min(31);
        let one_plus = ((1 << 15) + product).max(1) as u32;
        let up = 32 - root::bit_length(kept);
        let inverse = Gain16::normalised(quick_inverse_16((kept << up) >> 16), 17 - up as i32);
        self.worth.times(Gain16::normalised(one_plus, 15)).times(inverse)
    }

    /// Returns the versine off the axis at `v`, and `1 / (1 + v^2)` with 16 fraction bits.
    #[inline]
    pub(super) fn at(&self, v: i32) -> (Versine, u32) {
        let square = high_square(v);
        let one_plus = (1 << 15) + (square >> (13 + 2 * self.zoom).min(31));
        let share = quick_inverse_16(one_plus.min(65_535));
        let risen = high_product(square, (self.radius * share) >> 15);
        (Versine::from_bits(self.least.saturating_add(risen << 2)), share)
    }
}

/// Returns `half place` for a place with 16 fraction bits.
#[inline]
pub(super) fn part(half: i32, place: u32) -> i32 {
    signed_high_product(half, place)
}

/// Returns `half sum` with 28 fraction bits, for factors with 30 fraction bits.
#[inline]
pub(super) fn whole(half: i32, sum: u32) -> u32 {
    high_half(half as u32, sum)
}

/// The direction of an end of an arc, relative to the direction nearest to the axis.
///
/// All values have 28 fraction bits.
#[derive(Clone, Copy)]
struct End {
    sine: i32,
    cosine: i32,
    one_plus_cosine: i32,
}

impl End {
    /// Returns whether the direction is so nearly opposite that `v` is a ratio of rounding errors.
    fn is_opposite(self) -> bool {
        self.one_plus_cosine < 1 << 20
    }

    /// Returns `v`, scaled by `2^zoom`, with 30 fraction bits, clamped to `[-2, 2]`.
    #[inline(never)]
    fn tangent(self, zoom: u32) -> i32 {
        let (size, divisor) = (self.sine.unsigned_abs(), self.one_plus_cosine.max(1) as u32);
        let is_large = size >> (30 - zoom) != 0 || (size << zoom) >> 1 >= divisor;
        let tangent = if is_large {
            OPPOSITE
        } else {
            let (dividend, up) = (size << zoom, 32 - root::bit_length(divisor));
            let inverse = quick_inverse_16((divisor << up) >> 16);
            let nearly = high_product(dividend, inverse) << (up - 1);
            // One Newton step; the rest has 26 fraction bits.
            let rest = (dividend >> 2) as i32 - high_half(nearly, divisor) as i32;
            let correction = signed_high_product(rest << 2, inverse) << (up - 1);
            nearly.saturating_add_signed(correction).min(OPPOSITE as u32) as i32
        };
        if self.sine < 0 { -tangent } else { tangent }
    }
}
