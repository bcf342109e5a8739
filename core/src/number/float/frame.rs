//! Projection of a point onto the square of a spotlight, in f32.

use crate::{number::STEPS, vec3::Vec3};

/// Frame of a projection: the light's axis, and two vectors orthogonal to the axis, scaled to
/// coordinate steps.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FloatFrame {
    right: Vec3<f32>,
    down: Vec3<f32>,
    axis: Vec3<f32>,
    /// Coordinates of the axis on the square, in steps, plus one side of the square.
    ///
    /// The added side keeps coordinates positive up to one side outside the square.
    center: [f32; 2],
}

impl FloatFrame {
    /// Restores a frame from its bits, in the order of the fields.
    pub const fn from_bits(bits: [u32; 11]) -> Self {
        let [a, b, c, d, e, f, g, h, i, column, row] = bits;
        Self {
            right: vector([a, b, c]),
            down: vector([d, e, f]),
            axis: vector([g, h, i]),
            center: [f32::from_bits(column), f32::from_bits(row)],
        }
    }

    /// Returns the bits, in the order of the fields.
    pub const fn to_bits(self) -> [u32; 11] {
        let Self { right, down, axis, center: [column, row] } = self;
        let [a, b, c] = [right.x.to_bits(), right.y.to_bits(), right.z.to_bits()];
        let [d, e, f] = [down.x.to_bits(), down.y.to_bits(), down.z.to_bits()];
        let [g, h, i] = [axis.x.to_bits(), axis.y.to_bits(), axis.z.to_bits()];
        [a, b, c, d, e, f, g, h, i, column.to_bits(), row.to_bits()]
    }

    /// Builds the frame from three unit vectors and half the square's side at distance 1.
    ///
    /// After rounding, the right and down vectors are not quite orthogonal to the axis, and a
    /// narrow cone would magnify this error. The coordinates of the centre are corrected for this
    /// error.
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
    pub(super) fn project(&self, way: Vec3<f32>) -> ([i32; 2], f32) {
        const LAST: f32 = (3 * STEPS - 1) as f32;
        let depth = way.dot(self.axis);
        let reciprocal = 1.0 / depth;
        // Excludes points behind the light, and depths without a positive reciprocal.
        let is_ahead = reciprocal > 0.0;
        let step = |across: Vec3<f32>, center| {
            let step = way.dot(across) * reciprocal + center;
            let step = if is_ahead & (step > 0.0) { step } else { 0.0 };
            (if step < LAST { step } else { LAST }) as i32 - STEPS
        };
        (
            [step(self.right, self.center[0]), step(self.down, self.center[1])],
            if is_ahead { depth } else { 0.0 },
        )
    }
}

const fn vector([x, y, z]: [u32; 3]) -> Vec3<f32> {
    Vec3::new(f32::from_bits(x), f32::from_bits(y), f32::from_bits(z))
}
