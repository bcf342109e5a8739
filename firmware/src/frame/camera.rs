//! From a pixel to a line of sight.

use luminaire::{Vec3, source::I16F16};

use super::measures::EYE;
use super::{HEIGHT, WIDTH};

/// A length in steps of 2^-16.
pub(super) const fn steps(metres: f32) -> i32 {
    (metres * 65_536.0) as i32
}

/// The fraction bits of a depth.
pub(super) const DEPTH_BITS: u32 = 13;
/// Half a pixel, as a slope in steps of 2^-16: the picture is one metre wide at a depth of one.
const HALF_PIXEL: i32 = 205;
/// The row in which the horizon is.
const HORIZON: i32 = 38;

/// A line of sight: how far it goes to the right and up for each metre into the depth, in steps of 2^-16.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    pub(super) right: i32,
    pub(super) up: i32,
}

impl Sight {
    /// Through the middle of a pixel.
    #[inline(always)]
    pub(super) fn through(column: usize, row: usize) -> Self {
        debug_assert!(column < WIDTH && row < HEIGHT);
        let middle = |pixel: usize, zero: i32| 2 * (pixel as i32 - zero) + 1;
        let right = middle(column, WIDTH as i32 / 2) * HALF_PIXEL;
        Self { right, up: -middle(row, HORIZON) * HALF_PIXEL }
    }

    /// How high it is at a depth.
    #[inline(always)]
    pub(super) fn height(self, depth: i32) -> i32 {
        steps(EYE[1]) + ((self.up * depth) >> DEPTH_BITS)
    }

    /// The point at a depth.
    #[inline(always)]
    pub(super) fn point(self, depth: i32) -> Vec3<I16F16> {
        let right = steps(EYE[0]) + ((self.right * depth) >> DEPTH_BITS);
        let back = steps(EYE[2]) - (depth << (16 - DEPTH_BITS));
        Vec3::new(right, self.height(depth), back).map(I16F16::from_bits)
    }

    /// The squared length of the part to the right, of that upwards, and of one metre into the depth, in steps of
    /// 2^-20.
    #[inline(always)]
    pub(super) fn squares(self) -> [i32; 3] {
        let square = |slope: i32| (slope * slope) >> 12;
        [square(self.right), square(self.up), 1 << 20]
    }
}

/// The lines of sight that can meet something: a box about it, as seen from the eye.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    right: [i32; 2],
    up: [i32; 2],
}

impl Window {
    /// About a box of this middle and half size.
    pub(super) const fn about(middle: [f32; 3], half: [f32; 3]) -> Self {
        let depth = EYE[2] - middle[2];
        let [near, far] = [depth - half[2], depth + half[2]];
        Self {
            right: range(middle[0] - EYE[0], half[0], near, far),
            up: range(middle[1] - EYE[1], half[1], near, far),
        }
    }

    /// Whether a line of sight goes through its rows.
    #[inline(always)]
    pub(super) fn has_row(&self, sight: Sight) -> bool {
        sight.up >= self.up[0] && sight.up <= self.up[1]
    }

    /// Whether a line of sight goes through its columns.
    #[inline(always)]
    pub(super) fn has_column(&self, sight: Sight) -> bool {
        sight.right >= self.right[0] && sight.right <= self.right[1]
    }
}

/// The least and the largest slope of what is so wide, between two depths.
const fn range(middle: f32, half: f32, near: f32, far: f32) -> [i32; 2] {
    let (low, high) = (middle - half, middle + half);
    let low = low / if low < 0.0 { near } else { far };
    let high = high / if high < 0.0 { far } else { near };
    [steps(low) - 1, steps(high) + 1]
}
