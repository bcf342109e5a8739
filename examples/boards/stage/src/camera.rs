//! From a pixel to a line of sight.

use core::ops::Range;

use luminaire::{Vec3, number::Length};

use super::measures::EYE;

/// A length in steps of 2^-16.
pub(super) const fn steps(metres: f32) -> i32 {
    (metres * 65_536.0) as i32
}

/// The fraction bits of a depth.
pub(super) const DEPTH_BITS: u32 = 13;

/// Half a pixel of a picture, as a slope in steps of 2^-16: the picture is one metre wide at a depth
/// of one.
pub(super) const fn half_pixel(width: usize) -> i32 {
    let width = width as i32;
    (32_768 + width / 2) / width
}

/// The row of the horizon.
const fn horizon(width: usize) -> i32 {
    38 * width as i32 / 160
}

/// How many half pixels the middle of a column is to the right of the middle of the picture.
pub(super) const fn middle<const WIDTH: usize>(column: usize) -> i32 {
    2 * (column as i32 - WIDTH as i32 / 2) + 1
}

/// A line of sight: how far it goes to the right and up for each metre into the depth, in steps of
/// 2^-16.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight<const WIDTH: usize> {
    pub(super) right: i32,
    pub(super) up: i32,
}

impl<const WIDTH: usize> Sight<WIDTH> {
    /// The line of sight through the centre of a pixel.
    #[inline(always)]
    pub(super) fn through(column: usize, row: i32) -> Self {
        let up = -(2 * (row - horizon(WIDTH)) + 1) * half_pixel(WIDTH);
        Self { right: middle::<WIDTH>(column) * half_pixel(WIDTH), up }
    }

    /// The height of the line at a depth.
    #[inline(always)]
    pub(super) fn height(self, depth: i32) -> i32 {
        steps(EYE[1]) + ((self.up * depth) >> DEPTH_BITS)
    }

    /// The depth at which the line falls to a height below the eye. `None` if it rises.
    #[inline(always)]
    pub(super) fn fall_to(self, height: f32) -> Option<i32> {
        let drop = steps(EYE[1] - height).cast_unsigned();
        let depth = (drop << DEPTH_BITS).checked_div(u32::try_from(-self.up).ok()?)?;
        Some(depth.cast_signed())
    }

    /// The x coordinate of the line at a depth.
    #[inline(always)]
    pub(super) fn x(self, depth: i32) -> Length {
        Length::from_bits(steps(EYE[0]) + ((self.right * depth) >> DEPTH_BITS))
    }

    /// The x coordinate of the first line of a row at a depth, from the eye, and the step from line to
    /// line, with `DEPTH_BITS` more fraction bits than a length.
    pub(super) fn row_at(depth: i32) -> [i32; 2] {
        [Self::through(0, 0).right * depth, 2 * half_pixel(WIDTH) * depth]
    }

    /// The point at a depth.
    #[inline(always)]
    pub(super) fn point(self, depth: i32) -> Vec3<Length> {
        let back = steps(EYE[2]) - (depth << (16 - DEPTH_BITS));
        Vec3::new(self.x(depth), Length::from_bits(self.height(depth)), Length::from_bits(back))
    }

    /// The square of the line's component to the right for each metre of depth, in steps of 2^-20.
    pub(super) fn right_squared(self) -> i32 {
        (self.right * self.right) >> 12
    }
}

/// The pixels in which an object can be visible: those of a rectangle around the object.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    columns: [usize; 2],
    rows: [i32; 2],
}

impl Window {
    /// The window of a box with this centre and half size.
    pub(super) const fn about<const WIDTH: usize>(middle: [f32; 3], half: [f32; 3]) -> Self {
        let depth = EYE[2] - middle[2];
        let depths = [depth - half[2], depth + half[2]];
        let [left, right] = slopes(middle[0] - EYE[0], half[0], depths);
        let [bottom, top] = slopes(middle[1] - EYE[1], half[1], depths);
        let [first, end] = pixels([left, right], WIDTH as i32 / 2, WIDTH);
        Self {
            columns: [clamped(first, WIDTH), clamped(end, WIDTH)],
            rows: pixels([-top, -bottom], horizon(WIDTH), WIDTH),
        }
    }

    /// The columns of the window.
    pub(super) const fn columns(&self) -> Range<usize> {
        self.columns[0]..self.columns[1]
    }

    /// Whether pixels of a row lie in the window.
    pub(super) const fn has(&self, row: i32) -> bool {
        row >= self.rows[0] && row < self.rows[1]
    }

    /// The pixels of a row that lie in the window, with the numbers of their columns.
    pub(super) fn of<'a, T, const WIDTH: usize>(
        &self,
        row: i32,
        pixels: &'a mut [T; WIDTH],
    ) -> impl Iterator<Item = (usize, &'a mut T)> {
        let [first, end] = if self.has(row) { self.columns } else { [0, 0] };
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
const fn pixels([low, high]: [f32; 2], zero: i32, width: usize) -> [i32; 2] {
    let pixel = 2 * half_pixel(width);
    [zero + steps(low) / pixel - 1, zero + steps(high) / pixel + 2]
}

/// A column, clamped to those of the picture.
const fn clamped(column: i32, width: usize) -> usize {
    if column < 0 {
        0
    } else if column as usize > width {
        width
    } else {
        column as usize
    }
}
