//! Where the lines of sight of a row meet the ball.

use crate::camera::{DEPTH_BITS, Sight, half_pixel, middle, steps};
use crate::measures::{BALL, BALL_RADIUS, EYE};

/// The offset from the eye to the ball's centre: right, up and ahead.
const WAY: [f32; 3] = [BALL[0] - EYE[0], BALL[1] - EYE[1], EYE[2] - BALL[2]];
/// The squared length of `WAY` minus the squared radius.
const GAP: f32 = WAY[0] * WAY[0] + WAY[1] * WAY[1] + WAY[2] * WAY[2] - BALL_RADIUS * BALL_RADIUS;

/// The lines of sight of a row, from left to right: at which depth each of them meets the ball.
///
/// The squared distance from the ball's centre minus the squared radius is `a t² - 2 b t + c` at the
/// depth `t` of a line. From pixel to pixel `a` and the discriminant are quadratic and `b` is linear,
/// so sums replace their products.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lines {
    /// `b² - a c`.
    discriminant: Series,
    a: Series,
    /// `1 / a` with 16 fraction bits. Newton's method finds it from that of the pixel before.
    inverse: i32,
    /// With 20 fraction bits.
    b: i32,
    /// What `b` changes by from pixel to pixel.
    step: i32,
}

impl Lines {
    /// The lines of a row from a column on.
    pub(crate) fn new<const WIDTH: usize>(column: usize, row: i32) -> Self {
        const ACROSS: i32 = steps(WAY[0]);
        let (half, place) = (half_pixel(WIDTH), middle::<WIDTH>(column));
        let up = i64::from(Sight::<WIDTH>::through(column, row).up);
        // `b` with 28 fraction bits, where the line goes neither to the right nor to the left.
        let ahead = ((up * i64::from(steps(WAY[1]))) >> 4) + (i64::from(steps(WAY[2])) << 12);
        let least = (1 << 32) + up * up;
        let constant = ((ahead * ahead) >> 16) - ((least * i64::from(steps(GAP))) >> 8);
        let linear = (2 * i64::from(half * (ACROSS >> 4)) * ahead) >> 16;
        let a = Series::of([const { square(half_pixel(WIDTH), 1.0) }, 0, least << 8], place);
        Self {
            discriminant: Series::of(
                [const { square(half_pixel(WIDTH), WAY[0] * WAY[0] - GAP) }, linear, constant],
                place,
            ),
            a,
            inverse: (1_u32 << 31).checked_div(a.value.cast_unsigned() >> 15).unwrap_or(0).cast_signed(),
            b: (ahead >> 8) as i32 + ((place * half * (ACROSS >> 4)) >> 8),
            step: (2 * half * ACROSS) >> 12,
        }
    }

    /// The depth at which the next line meets the ball.
    #[inline(always)]
    pub(crate) fn next_depth(&mut self) -> Option<i32> {
        let (discriminant, b) = (self.discriminant.next(), self.b);
        // The product is nearly 1, with 31 fraction bits.
        let lack = (1_u32 << 31).cast_signed().wrapping_sub((self.a.next() >> 15).wrapping_mul(self.inverse));
        self.inverse += (self.inverse * (lack >> 15)) >> 16;
        self.b += self.step;
        let away = u32::try_from(discriminant).ok()?;
        let near = (b >> 4) - (root(away) << 1).cast_signed();
        let [high, low] = [near >> 8, near & 0xff].map(|part| part * self.inverse);
        Some((high + (low >> 8)) >> (24 - DEPTH_BITS))
    }
}

/// The square of half a pixel times a factor, with 40 fraction bits.
const fn square(half_pixel: i32, factor: f32) -> i64 {
    (half_pixel as f64 * half_pixel as f64 * factor as f64 * 256.0) as i64
}

/// A quadratic function of whole numbers, evaluated at every second of them.
#[derive(Clone, Copy, Debug)]
struct Series {
    /// With 30 fraction bits.
    value: i32,
    /// The next value minus this one, with 34 fraction bits.
    change: i32,
    /// What `change` changes by, with 34 fraction bits.
    second: i32,
}

impl Series {
    /// The function `a m² + b m + c` from a number on. Its coefficients have 40 fraction bits.
    fn of([a, b, c]: [i64; 3], m: i32) -> Self {
        let m = i64::from(m);
        let value = (a * m + b) * m + c;
        let change = a * (4 * m + 4) + 2 * b;
        Self { value: (value >> 10) as i32, change: (change >> 6) as i32, second: (a >> 3) as i32 }
    }

    #[inline(always)]
    fn next(&mut self) -> i32 {
        let value = self.value;
        self.value = value.wrapping_add(self.change >> 4);
        self.change = self.change.wrapping_add(self.second);
        value
    }
}

/// The square root of a number below 2^30, rounded down: from a table, and then corrected.
#[inline(always)]
fn root(square: u32) -> u32 {
    // Small numbers are multiplied by a power of 16, so that the chords are within a step of the curve.
    let (mut scaled, mut down) = (square | 1, 0);
    while scaled < 1 << 26 {
        scaled <<= 4;
        down += 2;
    }
    let place = (scaled >> 22) as usize & 255;
    let [low, high] = [place, place + 1].map(|place| u32::from(ROOTS[place]));
    let mut root = (low + (((high - low) * (scaled >> 10 & 0xfff)) >> 12)) >> down;
    while root * root > square {
        root -= 1;
    }
    while (root + 1) * (root + 1) <= square {
        root += 1;
    }
    root
}

/// The square roots of multiples of 2^22, rounded down.
const ROOTS: [u16; 257] = {
    let (mut roots, mut place) = ([0; 257], 0);
    while place < 257 {
        roots[place] = ((place as u32) << 22).isqrt() as u16;
        place += 1;
    }
    roots
};
