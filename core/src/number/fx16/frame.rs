//! Projection of a point onto the square of a spotlight, in the 16-bit format.

use super::Offset16;
use crate::{
    number::{
        Length, Offset, STEPS, mantissa_and_shift, nearest,
        root::{self, signed_high_product},
    },
    vec3::Vec3,
};

/// Number of fraction bits of a frame's vectors. With more bits, the inner product with an offset
/// of 17 bits would not fit 32 bits.
const BITS: u32 = 13;

/// Bit length of a depth up to which a point counts as behind the light.
///
/// A point with so small a depth is more than 88 degrees off the axis; the corners of the widest
/// square are 83 degrees off the axis.
const LEAST_BITS: u32 = 24;

/// One of a frame's vectors.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Vector {
    parts: Vec3<i32>,
    /// Half the sum of the components, a correction of the inner product with an offset.
    ///
    /// The correction is the mean error that the bits truncated from the offset cause.
    half: i32,
}

/// Frame of a projection about the axis of a light.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Frame16 {
    right: Vector,
    down: Vector,
    axis: Vector,
    /// Coordinates of the axis on the square.
    center: [i32; 2],
    /// `2^(shift + 8)` divided by the side of the square at a depth of one; 16 bits.
    scale: u32,
    shift: u32,
}

impl Vector {
    const fn from_bits(x: i32, y: i32, z: i32, half: i32) -> Self {
        Self { parts: Vec3::new(x, y, z), half }
    }

    fn new(vector: Vec3<f32>) -> Self {
        let parts = vector.map(|c| nearest(c * (1 << BITS) as f32));
        Self { parts, half: (parts.x + parts.y + parts.z) >> 1 }
    }

    /// Returns the inner product with a unit vector.
    fn component(self, unit: Vec3<f32>) -> f64 {
        let products = self.parts.zip(unit, |part, unit| f64::from(part) * f64::from(unit));
        (products.x + products.y + products.z) / f64::from(1 << BITS)
    }

    /// Returns the inner product with an offset of 17 bits: at most 31 bits and a sign.
    #[inline]
    fn part(&self, way: Vec3<i32>) -> i32 {
        let products = self.parts.zip(way, i32::wrapping_mul);
        products.x.wrapping_add(products.y).wrapping_add(products.z).wrapping_add(self.half)
    }
}

impl Frame16 {
    /// Restores a frame from its bits, in the order of the fields.
    pub const fn from_bits(bits: [i32; 16]) -> Self {
        let [a, b, c, d, e, f, g, h, i, j, k, l, column, row, scale, shift] = bits;
        Self {
            right: Vector::from_bits(a, b, c, d),
            down: Vector::from_bits(e, f, g, h),
            axis: Vector::from_bits(i, j, k, l),
            center: [column, row],
            scale: scale as u32 & ((1 << 16) - 1),
            shift: shift as u32 % u32::BITS,
        }
    }

    /// Returns the bits, in the order of the fields.
    pub const fn to_bits(self) -> [i32; 16] {
        let Self { right, down, axis, center: [column, row], scale, shift } = self;
        let [Vec3 { x: a, y: b, z: c }, Vec3 { x: e, y: f, z: g }] = [right.parts, down.parts];
        let Vec3 { x: i, y: j, z: k } = axis.parts;
        let [scale, shift] = [scale as i32, shift as i32];
        [a, b, c, right.half, e, f, g, down.half, i, j, k, axis.half, column, row, scale, shift]
    }

    /// Builds the frame from three unit vectors and half the square's side at a depth of one.
    ///
    /// Rounding turns and stretches the vectors, which would move the square. The components of the
    /// rounded right and down vectors along the axis correct the centre, and the length of the
    /// rounded axis corrects the scale.
    pub(super) fn new([right, down, axis]: [Vec3<f32>; 3], tangent: f32) -> Self {
        let vectors = [right, down, axis].map(Vector::new);
        let length = vectors[2].component(axis);
        let scale = (length / (2.0 * f64::from(tangent))) as f32;
        let center = [vectors[0], vectors[1]].map(|across| {
            let lean = across.component(axis) / length;
            nearest(STEPS as f32 * (0.5 - lean as f32 * scale))
        });
        let (mantissa, shift) = mantissa_and_shift(scale);
        Self {
            right: vectors[0],
            down: vectors[1],
            axis: vectors[2],
            center,
            scale: ((mantissa + (1 << 7)) >> 8).min((1 << 16) - 1),
            shift: (shift - 16).clamp(0, 24) as u32,
        }
    }

    #[inline(always)] // `lit-gobo` on Cortex-M0: +76 instructions without.
    pub(super) fn project(&self, light: Vec3<Length>, point: Vec3<Length>) -> ([i32; 2], Length) {
        let offset = Offset16::between(light, point);
        let way = offset.way();
        let depth = self.axis.part(way);
        if depth >> LEAST_BITS <= 0 {
            return ([-STEPS; 2], Length::default());
        }
        let z = depth as u32;
        let more = root::ilog2_of_seven_bits(z >> LEAST_BITS);
        let inverse = root::inverse_16(z >> (more + LEAST_BITS + 1 - 16));
        // The two factors have at most 17 and 16 bits; 16 bits of the product are kept.
        let factor = (inverse * self.scale + (1 << 15)) >> 16;
        let shift = (self.shift + more) % u32::BITS;
        let step = |across: Vector, center: i32| {
            let step = signed_high_product(across.part(way), factor) >> shift;
            step.wrapping_add(center).clamp(-STEPS, 2 * STEPS - 1)
        };
        ([step(self.right, self.center[0]), step(self.down, self.center[1])], offset.length_of(depth))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A scale just below a power of two rounds to no more than 16 bits.
    #[test]
    fn a_frame_keeps_its_bits() {
        let vectors = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, -1.0, 0.0), Vec3::new(0.0, 0.0, -1.0)];
        for steps in -2_000..2_000_i16 {
            let tangent = 0.5 + f32::from(steps) / 16_777_216.0;
            let frame = Frame16::new(vectors, tangent);
            assert_eq!(Frame16::from_bits(frame.to_bits()), frame, "{tangent}");
            assert!(frame.scale >> 15 == 1, "{tangent}: {}, expected frame.scale >> 15 == 1", frame.scale);
        }
    }
}
