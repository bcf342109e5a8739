//! Light interpolated over cells.
//!
//! The light of a point light on a surface with the normal `n` at the point `p` is `e(p) (n . o) / o.z`, with the vector
//! `o` from `p` to the light and the light `e` that the plane z = 0 receives at `p`: the kernel's irradiance with the
//! normal `(0, 0, 1)`. Only `e` is interpolated, between the corners of square cells. The tilt `(n . o) / o.z` is a sum
//! of two products and `n.z`, because `o.z` is the same for all points and `o.x / o.z` rises by the same step from each
//! pixel to the next.
//!
//! # The bound
//!
//! For a light of intensity `I` at the height `z`, `e = I z (r^2 + z^2)^(-3/2)` at the distance `r` from the foot of the
//! light. Its second derivatives in two orthogonal directions are `e'' = 3 I z (4 r^2 - z^2) d^-7` and
//! `e' / r = -3 I z d^-5`, with `d^2 = r^2 + z^2`; both are largest at the foot, with `3 I / z^4`. Bilinear interpolation over a cell of side `h` errs by at
//! most `h^2 / 8` of the sum of two second derivatives, here `3/4 I h^2 / z^4`. The tilt multiplies this by at most
//! `d / z`. So the light of a pixel errs by at most
//!
//! ```text
//! 3/4 (h / z)^2 (d / z) I / z^2
//! ```
//!
//! beside the errors of the kernel and of roundings. A test compares all pixels of pictures with it.

use luminaire::{Fx16, Length, Vec3, light::Row, number::Light16};

use crate::{
    measures::{PIXEL_BITS, SIDE},
    scene::{Lights, place},
    sprite::{Span, Sprite, Word},
};

/// The most corners in a row of cells of at least 4 pixels.
const CORNERS: usize = SIDE / 4 + 1;

/// Two numbers, one of each light.
type Both = [i32; 2];

/// The tilt of a vector to the light: `o / o.z` at the first pixel, and how much it falls from one pixel to the next.
#[derive(Clone, Copy)]
struct Tilt {
    x: i32,
    y: i32,
    step: i32,
}

/// Fraction bits of a tilt.
const TILT_BITS: u32 = 16;

impl Tilt {
    fn new(light: Vec3<Length>) -> Self {
        // A height of 1 to 2^15 units: the reciprocal has 15 to 1 bits below the first.
        let reciprocal = u32::MAX / (light.z.to_bits() as u32).max(1);
        let scaled = |c: i32| ((i64::from(c) * i64::from(reciprocal)) >> (32 - TILT_BITS)) as i32;
        let from = |c: Length| scaled(c.to_bits().wrapping_sub(place(0).to_bits()));
        Self { x: from(light.x), y: from(light.y), step: scaled(PIXEL_BITS) }
    }
}

/// Draws the sprite with light that is interpolated over cells of `N` pixels' side, 4 or 8. Transparent pixels keep
/// their values.
#[inline(never)]
pub fn draw<const N: usize>(sprite: &Sprite<'_>, lights: &Lights, pixels: &mut [u16; SIDE * SIDE]) {
    const { assert!(matches!(N, 4 | 8), "N is 4 or 8") };
    let tilts = lights.1.map(Tilt::new);
    let mut words = sprite.words;
    let mut spans = sprite.spans;
    let (mut upper, mut lower) = ([[0; 2]; CORNERS], [[0; 2]; CORNERS]);
    corners::<N>(lights, 0, &mut lower);
    for top in (0..SIDE).step_by(N) {
        (upper, lower) = (lower, upper);
        corners::<N>(lights, (top + N) as i32, &mut lower);
        let mut steps = [[0; 2]; CORNERS];
        for ((step, from), to) in steps.iter_mut().zip(&upper).zip(&lower) {
            *step = [0, 1].map(|i| (to[i] - from[i]) >> N.ilog2());
        }
        let mut here = upper;
        for y in top..top + N {
            while let Some((span, rest)) = spans.split_first()
                && usize::from(span.y) == y
            {
                spans = rest;
                words = row::<N>(sprite, (*span, &here), &tilts, words, pixels);
            }
            for (here, step) in here.iter_mut().zip(&steps) {
                *here = [0, 1].map(|i| here[i] + step[i]);
            }
        }
    }
}

/// Sets the light of the corners in a row of pixels, with [`fraction bits`](scaled).
#[inline(always)]
fn corners<const N: usize>(lights: &Lights, y: i32, corners: &mut [Both; CORNERS]) {
    let row =
        Row::along_x(Fx16::normal([0.0, 0.0, 1.0]), [place(y), Length::ZERO], |i| place((N * i) as i32));
    for (i, light) in lights.0.iter().enumerate() {
        let mut arrived = [Light16::ZERO; CORNERS];
        row.fill(light, 0, &mut arrived[..=SIDE / N]);
        for (corner, light) in corners.iter_mut().zip(arrived) {
            corner[i] = scaled::<N>(light);
        }
    }
}

/// Returns light with 17 fraction bits, times 128/127 because of the unit of normals.
///
/// A step between corners is rounded down, in both directions, by less than 1: `2 N` more keep the light positive.
#[inline(always)]
fn scaled<const N: usize>(light: Light16) -> i32 {
    let light = light.to_bits() as i32;
    (light << 3) + (light >> 4) + 2 * N as i32
}

/// Draws a span. Returns the words after it.
#[inline(always)]
fn row<'a, const N: usize>(
    sprite: &Sprite<'_>,
    (span, here): (Span, &[Both; CORNERS]),
    tilts: &[Tilt; 2],
    mut words: &'a [Word],
    pixels: &mut [u16; SIDE * SIDE],
) -> &'a [Word] {
    let (y, mut x, end) = (usize::from(span.y), usize::from(span.start), usize::from(span.end));
    let tilt_y = [0, 1].map(|i| tilts[i].y - tilts[i].step * y as i32);
    let mut tilt_x = [0, 1].map(|i| tilts[i].x - tilts[i].step * x as i32);
    while x < end {
        let (cell, within) = (x / N, x % N);
        let count = (N - within).min(end - x);
        let Some([from, to]) = here.get(cell..).and_then(|here| here.first_chunk()) else { break };
        let step = [0, 1].map(|i| (to[i] - from[i]) >> N.ilog2());
        let mut light = [0, 1].map(|i| from[i] + within as i32 * step[i]);
        let (Some((now, rest)), Some(to)) =
            (words.split_at_checked(count), pixels.get_mut(SIDE * y + x..SIDE * y + x + count))
        else {
            break;
        };
        for (word, to) in now.iter().zip(to) {
            let [nx, ny, nz] = word.normal().map(i32::from);
            let steps = [0, 1].map(|i| {
                let tilt = nx * tilt_x[i] + ny * tilt_y[i] + (nz << TILT_BITS);
                let steps = (tilt.max(0) as u32 >> 9).wrapping_mul(light[i] as u32) >> 20;
                tilt_x[i] -= tilts[i].step;
                light[i] += step[i];
                steps
            });
            *to = sprite.shown.pixel(*word, steps);
        }
        words = rest;
        x += count;
    }
    words
}
