//! Projection of a point onto the square of a spotlight, in the 32-bit format.

use super::Offset32;
use crate::{
    number::{
        Directions, Fx32, Length, Offset, STEPS, mantissa_and_shift,
        root::{inverse_28, wide},
    },
    vec3::Vec3,
};

/// Bit length of a depth up to which a point counts as behind the light.
///
/// A point with so small a depth is more than 88 degrees off the axis; the corners of the widest
/// square are 83 degrees off the axis.
const LEAST_BITS: u32 = 54;

/// Number of fraction bits of a coordinate, in steps, before the coordinate is rounded down.
const FINE: u32 = 8;

/// Frame of a projection about the axis of a light.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Frame32 {
    right: Vec3<i32>,
    down: Vec3<i32>,
    axis: Vec3<i32>,
    /// Coordinates of the axis on the square, in steps with [`FINE`] fraction bits.
    center: [i32; 2],
    /// `2^(shift + 2)` divided by the side of the square at a depth of one; 28 bits.
    scale: u32,
    shift: u32,
}

impl Frame32 {
    /// Restores a frame from its bits, in the order of the fields.
    ///
    /// Components are clamped to `[-1, 1]`, the range of a valid frame.
    pub const fn from_bits(bits: [i32; 13]) -> Self {
        let [a, b, c, d, e, f, g, h, i, column, row, scale, shift] = bits;
        Self {
            right: Vec3::new(within_one(a), within_one(b), within_one(c)),
            down: Vec3::new(within_one(d), within_one(e), within_one(f)),
            axis: Vec3::new(within_one(g), within_one(h), within_one(i)),
            center: [column, row],
            scale: scale as u32 & ((1 << 28) - 1),
            shift: shift as u32 % u64::BITS,
        }
    }

    /// Returns the bits, in the order of the fields.
    pub const fn to_bits(self) -> [i32; 13] {
        let Self { right, down, axis, center: [column, row], scale, shift } = self;
        let [Vec3 { x: a, y: b, z: c }, Vec3 { x: d, y: e, z: f }] = [right, down];
        let Vec3 { x: g, y: h, z: i } = axis;
        [a, b, c, d, e, f, g, h, i, column, row, scale as i32, shift as i32]
    }

    /// Builds the frame from three unit vectors and half the square's side at a depth of one.
    ///
    /// After rounding, the right and down vectors are not quite orthogonal to the axis, and a
    /// narrow cone would magnify this error. The coordinates of the centre are corrected for this
    /// error.
    pub(super) fn new([right, down, axis]: [Vec3<f32>; 3], tangent: f32) -> Self {
        let [right, down] = [right, down].map(|across| across.map(Fx32::from_f32));
        let axis = Fx32::axis(axis);
        let scale = 1.0 / (2.0 * tangent);
        let center = [right, down].map(|across| {
            let lean = across.zip(axis, |a, s| wide(a.to_bits(), s.to_bits()));
            let lean = (lean.x + lean.y + lean.z) as f64 / (1_u64 << 60) as f64;
            (f64::from(STEPS << FINE) * (0.5 - lean * f64::from(scale))) as i32
        });
        let (mantissa, shift) = mantissa_and_shift(scale);
        Self {
            right: right.map(Fx32::to_bits),
            down: down.map(Fx32::to_bits),
            axis: axis.map(Fx32::to_bits),
            center,
            scale: mantissa << 4,
            shift: (shift + 4 - 2).clamp(0, 63) as u32,
        }
    }

    #[inline]
    pub(super) fn project(&self, light: Vec3<Length>, point: Vec3<Length>) -> ([i32; 2], Length) {
        let offset = Offset32::between(light, point);
        let depth = part(self.axis, offset.way);
        if depth >> LEAST_BITS <= 0 {
            return ([-STEPS; 2], Length::default());
        }
        let z = depth as u64;
        let bits = u64::BITS - z.leading_zeros();
        let inverse = u64::from(inverse_28((z >> (bits - 28)) as u32));
        // The two factors have at most 29 and 28 bits; 28 bits of the product are kept.
        let factor = (inverse * u64::from(self.scale) + (1 << 27)) >> 28;
        let shift = (self.shift + bits - LEAST_BITS - 1) % u64::BITS;
        let step = |across, center: i32| {
            let step = signed_high_product(part(across, offset.way), factor) >> shift;
            let step = (step + i64::from(center)) >> FINE;
            step.clamp(i64::from(-STEPS), i64::from(2 * STEPS - 1)) as i32
        };
        ([step(self.right, self.center[0]), step(self.down, self.center[1])], offset.length_of(depth))
    }
}

/// Returns half the inner product of a vector and an offset. For a unit vector the result has at
/// most 61 bits and a sign.
#[inline]
fn part(vector: Vec3<i32>, way: Vec3<i32>) -> i64 {
    let products = vector.zip(way, |a, b| wide(a, b) >> 1);
    products.x + products.y + products.z
}

/// Returns `a b / 2^32` for `b` of 28 bits, rounded down.
#[inline]
fn signed_high_product(a: i64, b: u64) -> i64 {
    let low = ((a as u64 & 0xffff_ffff) * b) >> 32;
    (a >> 32) * b as i64 + low as i64
}

/// Clamps a component with 30 fraction bits to `[-1, 1]`.
const fn within_one(component: i32) -> i32 {
    const ONE: i32 = 1 << 30;
    if component > ONE {
        ONE
    } else if component < -ONE {
        -ONE
    } else {
        component
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_keeps_its_bits_and_no_others() {
        let vectors = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, -0.8, 0.6), Vec3::new(0.0, -0.6, -0.8)];
        for tangent in [1e-3, 0.1, 0.499_999_97, 0.5, 1.0, 5.0] {
            let frame = Frame32::new(vectors, tangent);
            assert_eq!(Frame32::from_bits(frame.to_bits()), frame, "{tangent}");
        }
        const ONE: i32 = 1 << 30;
        let (most, least) = (Frame32::from_bits([i32::MAX; 13]), Frame32::from_bits([i32::MIN; 13]));
        assert_eq!(most.to_bits()[..9], [ONE; 9]);
        assert_eq!(most.to_bits()[9..], [i32::MAX, i32::MAX, (1 << 28) - 1, 63]);
        assert_eq!(least.to_bits()[..9], [-ONE; 9]);
    }
}
