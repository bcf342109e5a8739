//! From a pixel to a line of sight.

use luminaire::{Vec3, number::Length};

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
/// The row of the horizon.
const HORIZON: i32 = 38;

/// A line of sight: how far it goes to the right and up for each metre into the depth, in steps of
/// 2^-16.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    pub(super) right: i32,
    pub(super) up: i32,
}

impl Sight {
    /// The line of sight through the centre of a pixel.
    #[inline(always)]
    pub(super) fn through(column: usize, row: usize) -> Self {
        debug_assert!(column < WIDTH && row < HEIGHT);
        let middle = |pixel: usize, zero: i32| 2 * (pixel as i32 - zero) + 1;
        let right = middle(column, WIDTH as i32 / 2) * HALF_PIXEL;
        Self { right, up: -middle(row, HORIZON) * HALF_PIXEL }
    }

    /// The height of the line at a depth.
    #[inline(always)]
    pub(super) fn height(self, depth: i32) -> i32 {
        steps(EYE[1]) + ((self.up * depth) >> DEPTH_BITS)
    }

    /// The x coordinate of the line at a depth.
    #[inline(always)]
    pub(super) fn x(self, depth: i32) -> Length {
        Length::from_bits(steps(EYE[0]) + ((self.right * depth) >> DEPTH_BITS))
    }

    /// The point at a depth.
    #[inline(always)]
    pub(super) fn point(self, depth: i32) -> Vec3<Length> {
        let back = steps(EYE[2]) - (depth << (16 - DEPTH_BITS));
        Vec3::new(self.x(depth), Length::from_bits(self.height(depth)), Length::from_bits(back))
    }

    /// The squares of the line's three components for each metre of depth: right, up and the metre
    /// itself, in steps of 2^-20.
    #[inline(always)]
    pub(super) fn squares(self) -> [i32; 3] {
        let square = |slope: i32| (slope * slope) >> 12;
        [square(self.right), square(self.up), 1 << 20]
    }
}

/// The pixels in which an object can be visible: those of a rectangle around the object.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    columns: [usize; 2],
    rows: [usize; 2],
}

impl Window {
    /// The window of a box with this centre and half size.
    pub(super) const fn about(middle: [f32; 3], half: [f32; 3]) -> Self {
        let depth = EYE[2] - middle[2];
        let depths = [depth - half[2], depth + half[2]];
        let [left, right] = slopes(middle[0] - EYE[0], half[0], depths);
        let [bottom, top] = slopes(middle[1] - EYE[1], half[1], depths);
        Self {
            columns: pixels([left, right], WIDTH as i32 / 2, WIDTH),
            rows: pixels([-top, -bottom], HORIZON, HEIGHT),
        }
    }

    /// The pixels of a row that lie in the window, with the numbers of their columns.
    pub(super) fn of<'a, T>(
        &self,
        row: usize,
        pixels: &'a mut [T; WIDTH],
    ) -> impl Iterator<Item = (usize, &'a mut T)> {
        let [first, end] = if row >= self.rows[0] && row < self.rows[1] { self.columns } else { [0, 0] };
        (first..).zip(pixels.get_mut(first..end).unwrap_or_default())
    }
}

/// The smallest and the largest slope towards an object between two depths. The object's centre is
/// at `middle`, and its half width is `half`.
const fn slopes(middle: f32, half: f32, [near, far]: [f32; 2]) -> [f32; 2] {
    let (low, high) = (middle - half, middle + half);
    [low / if low < 0.0 { near } else { far }, high / if high < 0.0 { far } else { near }]
}

/// The first pixel between two slopes, and the pixel after the last.
const fn pixels([low, high]: [f32; 2], zero: i32, count: usize) -> [usize; 2] {
    let first = zero + steps(low) / (2 * HALF_PIXEL) - 1;
    let end = zero + steps(high) / (2 * HALF_PIXEL) + 2;
    let count = count as i32;
    [if first < 0 { 0 } else { first as usize }, if end > count { count as usize } else { end as usize }]
}
