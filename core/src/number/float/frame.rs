//! The way from a point to its place on the square, in f32.

use crate::{
    number::place::{ProjectedPoint, STEPS},
    vec3::Vec3,
};

/// A frame about the axis of a light: two vectors across it that are as long as a place's steps want them, and the axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FloatFrame {
    right: Vec3<f32>,
    down: Vec3<f32>,
    axis: Vec3<f32>,
    /// Where the axis meets the square, one side farther: what is on either side of the square is positive, too.
    center: [f32; 2],
}

impl FloatFrame {
    /// The frame of these bits, in the order of the fields.
    pub const fn from_bits(bits: [u32; 11]) -> Self {
        let [a, b, c, d, e, f, g, h, i, column, row] = bits;
        Self {
            right: vector([a, b, c]),
            down: vector([d, e, f]),
            axis: vector([g, h, i]),
            center: [f32::from_bits(column), f32::from_bits(row)],
        }
    }

    /// The bits, in the order of the fields.
    pub const fn to_bits(self) -> [u32; 11] {
        let Self { right, down, axis, center: [column, row] } = self;
        let [a, b, c] = [right.x.to_bits(), right.y.to_bits(), right.z.to_bits()];
        let [d, e, f] = [down.x.to_bits(), down.y.to_bits(), down.z.to_bits()];
        let [g, h, i] = [axis.x.to_bits(), axis.y.to_bits(), axis.z.to_bits()];
        [a, b, c, d, e, f, g, h, i, column.to_bits(), row.to_bits()]
    }

    /// The frame of three unit vectors and the tangent of half a side. A vector across is not quite at a right angle to the
    /// axis once it is rounded, which a narrow cone would magnify: that much is taken off the centre.
    pub(super) fn new([right, down, axis]: [Vec3<f32>; 3], tangent: f32) -> Self {
        let scale = STEPS as f32 / (2.0 * tangent);
        let [right, down] = [right, down].map(|across| across.map(|c| c * scale));
        let center = [right, down].map(|across| {
            let lean = across.zip(axis, |a, s| f64::from(a) * f64::from(s));
            (1.5 * f64::from(STEPS) - (lean.x + lean.y + lean.z)) as f32
        });
        Self { right, down, axis, center }
    }

    #[inline]
    pub(super) fn place(&self, way: Vec3<f32>) -> ProjectedPoint<f32> {
        const LAST: f32 = (3 * STEPS - 1) as f32;
        let depth = way.dot(self.axis);
        let reciprocal = 1.0 / depth;
        // Neither behind the light nor at a depth that has no reciprocal.
        let is_ahead = reciprocal > 0.0;
        let step = |across: Vec3<f32>, center| {
            let step = way.dot(across) * reciprocal + center;
            let step = if is_ahead & (step > 0.0) { step } else { 0.0 };
            (if step < LAST { step } else { LAST }) as i32 - STEPS
        };
        ProjectedPoint {
            column: step(self.right, self.center[0]),
            row: step(self.down, self.center[1]),
            depth: if is_ahead { depth } else { 0.0 },
        }
    }
}

const fn vector([x, y, z]: [u32; 3]) -> Vec3<f32> {
    Vec3::new(f32::from_bits(x), f32::from_bits(y), f32::from_bits(z))
}
