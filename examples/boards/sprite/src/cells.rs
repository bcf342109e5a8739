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

use core::ops::Range;

use luminaire::{
    Fx16, Length, Vec3,
    light::{CompiledPointLight, Row},
    number::Light16,
};

use crate::{
    measures::{PIXEL_BITS, SIDE},
    scene::{Lights, place},
    shown::Shown,
    sprite::{Span, Sprite},
    word::Word,
};

/// The most corners in a row of cells of at least 4 pixels.
const CORNERS: usize = SIDE / 4 + 1;

/// The light of both lights at a place, with 14 fraction bits each: the first in the upper half. Every number stays in its
/// half, so that one addition is that of both.
type Both = u32;

/// Fraction bits of a tilt. With more, its product with the light would not fit 32 bits.
const TILT_BITS: u32 = 9;

/// Further fraction bits of a tilt while it is computed.
const MORE_BITS: u32 = 9;

/// What the pixels of a column have in common in a row.
#[derive(Clone, Copy, Default, Debug)]
#[repr(C)]
pub struct Column {
    /// The light of both lights on the plane, with 14 fraction bits: that of the first in the upper half.
    pub light: Both,
    /// The tilts `o.x / o.z` of both lights, with 9 fraction bits.
    pub tilt: [i32; 2],
}

/// Neighbouring opaque pixels of a row.
#[derive(Debug)]
pub struct Run<'a> {
    /// The pixels' words, of which the last has the mark of the end.
    pub words: &'a [Word],
    /// What their columns have, as many.
    pub columns: &'a [Column],
    /// The tilts `o.y / o.z` of both lights, with 9 fraction bits.
    pub tilt: [i32; 2],
    /// The tables.
    pub shown: Shown<'a>,
    /// Where the pixels are drawn, as many.
    pub pixels: &'a mut [u16],
}

/// Draws neighbouring opaque pixels, on any processor.
#[inline(always)]
pub fn run(run: Run<'_>) {
    let Run { words, columns, tilt: tilt_y, shown, pixels } = run;
    for ((word, column), to) in words.iter().zip(columns).zip(pixels) {
        let [nx, ny] = word.across();
        let steps = |tilt_x: i32, tilt_y: i32, light: u32| {
            // A product whose sign is set is dark by the table, which takes no instruction.
            let tilt = word.toward() + nx * tilt_x + ny * tilt_y;
            tilt.wrapping_mul(light as i32) as u32 >> 19
        };
        let first = steps(column.tilt[0], tilt_y[0], column.light >> 16);
        let second = steps(column.tilt[1], tilt_y[1], column.light & 0xffff);
        *to = shown.pixel(*word, [first, second]);
    }
}

/// The tilt of a vector to the light: `o / o.z` at the first pixel, and how much it falls from one pixel to the next; with
/// [`MORE_BITS`], and half a step of the result.
#[derive(Clone, Copy)]
struct Tilt {
    x: i32,
    y: i32,
    step: i32,
}

impl Tilt {
    fn new(light: Vec3<Length>) -> Self {
        let reciprocal = u32::MAX / (light.z.to_bits() as u32).max(1);
        let scaled = |c: i32| ((i64::from(c) * i64::from(reciprocal)) >> (32 - TILT_BITS - MORE_BITS)) as i32;
        let from = |c: Length| scaled(c.to_bits().wrapping_sub(place(0).to_bits())) + (1 << (MORE_BITS - 1));
        Self { x: from(light.x), y: from(light.y), step: scaled(PIXEL_BITS) }
    }
}

/// Draws the sprite with light that is interpolated over cells of `N` pixels' side, 4 or 8. Transparent pixels keep
/// their values. `run` draws a run of pixels, as [`run`] does.
#[inline(never)]
pub fn draw<const N: usize>(
    sprite: &Sprite<'_>,
    lights: &Lights,
    pixels: &mut [u16; SIDE * SIDE],
    run: impl Fn(Run<'_>),
) {
    const { assert!(matches!(N, 4 | 8), "N is 4 or 8") };
    let [a, b] = lights.1.map(Tilt::new);
    let (mut x, mut y) = ([a.x, b.x], [a.y, b.y]);
    let mut columns = [Column::default(); SIDE];
    for column in &mut columns {
        column.tilt = x.map(|tilt| tilt >> MORE_BITS);
        x = [x[0] - a.step, x[1] - b.step];
    }
    let cells = cells::<N>(sprite.spans);
    let (mut words, mut spans) = (sprite.words, sprite.spans);
    let mut corners = Corners::default();
    let mut range = 0..0;
    // Not a loop over the rows of each band, which the compiler would unroll: 2 kB more beside the processor.
    for row in 0..SIDE {
        if row % N == 0 {
            let band = row / N;
            let [above, [first, end], below] = [0, 1, 2].map(|i| cells[band + i]);
            if above == NONE && end > 0 {
                corners.lower::<N>(lights, band, first..end + 1);
            }
            if end > 0 {
                corners.lower::<N>(lights, band + 1, first.min(below[0])..end.max(below[1]) + 1);
            }
            range = first..end;
        }
        expand::<N>(&mut corners.here, range.clone(), &mut columns);
        while let Some((span, rest)) = spans.split_first()
            && usize::from(span.y) == row
        {
            spans = rest;
            let (start, end) = (usize::from(span.start), usize::from(span.end));
            let (Some((now, rest)), Some(columns), Some(pixels)) = (
                words.split_at_checked(end.saturating_sub(start)),
                columns.get(start..end),
                pixels.get_mut(SIDE * row + start..SIDE * row + end),
            ) else {
                return;
            };
            words = rest;
            let tilt = y.map(|tilt| tilt >> MORE_BITS);
            run(Run { words: now, columns, tilt, shown: sprite.shown, pixels });
        }
        y = [y[0] - a.step, y[1] - b.step];
    }
}

/// No cells: a range that is the smallest and the largest with another.
const NONE: [usize; 2] = [CORNERS - 1, 0];

/// Returns the first cell with opaque pixels and that after the last, of each row of cells, between two rows without.
fn cells<const N: usize>(spans: &[Span]) -> [[usize; 2]; CORNERS + 1] {
    let mut cells = [NONE; CORNERS + 1];
    for span in spans {
        if let Some([first, end]) = cells.get_mut(usize::from(span.y) / N + 1) {
            *first = (*first).min(usize::from(span.start) / N);
            *end = (*end).max(usize::from(span.end).div_ceil(N));
        }
    }
    cells
}

/// The light at a corner of cells, in a row of pixels, and its step to the next row.
#[derive(Clone, Copy, Default)]
struct Corner {
    light: Both,
    step: Both,
}

impl Corner {
    /// Returns the light, and moves to the next row.
    #[inline(always)]
    fn next(&mut self) -> Both {
        let light = self.light;
        self.light = light.wrapping_add(self.step);
        light
    }
}

/// A row of corners, where they are in the rows of pixels below it.
#[derive(Default)]
struct Corners {
    here: [Corner; CORNERS],
    /// The light at the next row of corners.
    lower: [Both; CORNERS],
    /// Room for the irradiances of each light.
    arrived: [[Light16; CORNERS]; 2],
}

impl Corners {
    /// Moves some corners to the next row of corners, whose lower neighbours are in `row`.
    #[inline(never)]
    fn lower<const N: usize>(&mut self, lights: &Lights, row: usize, range: Range<usize>) {
        let start = range.start;
        let (Some(here), Some(lower)) = (self.here.get_mut(range.clone()), self.lower.get_mut(range)) else {
            return;
        };
        for (light, arrived) in lights.0.iter().zip(&mut self.arrived) {
            fill::<N>(light, [start, row], arrived.get_mut(..lower.len()).unwrap_or_default());
        }
        let [first, second] = &self.arrived;
        for (((here, lower), first), second) in here.iter_mut().zip(lower).zip(first).zip(second) {
            let below = scaled::<N>(*first) << 16 | scaled::<N>(*second);
            *here = Corner { light: *lower, step: between::<N>(*lower, below) };
            *lower = below;
        }
    }
}

/// Sets the light of the columns of some cells between corners, and moves the corners to the next row.
// A function of its own, whose numbers fit the registers.
#[inline(never)]
fn expand<const N: usize>(
    corners: &mut [Corner; CORNERS],
    cells: Range<usize>,
    columns: &mut [Column; SIDE],
) {
    let columns = columns.as_chunks_mut::<N>().0.get_mut(cells.clone()).unwrap_or_default();
    let Some((first, corners)) = corners.get_mut(cells.start..).and_then(<[_]>::split_first_mut) else {
        return;
    };
    let mut from = first.next();
    for (columns, corner) in columns.iter_mut().zip(corners) {
        let to = corner.next();
        let (mut light, step) = (from, between::<N>(from, to));
        for column in columns {
            column.light = light;
            light = light.wrapping_add(step);
        }
        from = to;
    }
}

/// Returns the step from one pixel to the next, rounded down, between the light at two places `N` pixels apart.
#[inline(always)]
fn between<const N: usize>(from: Both, to: Both) -> Both {
    // In each half the difference has a sign, and that of the lower half borrows from the upper one.
    let difference = to.wrapping_sub(from) as i32;
    let lower = difference << 16;
    let upper = difference.wrapping_sub(lower >> 16);
    let [upper, lower] = [upper, lower].map(|half| half >> (16 + N.ilog2()));
    (lower as u32).wrapping_add((upper as u32) << 16)
}

/// Sets the irradiances of the plane at corners.
#[inline(never)]
fn fill<const N: usize>(light: &CompiledPointLight<Fx16>, [first, y]: [usize; 2], arrived: &mut [Light16]) {
    let corner = |i: usize| place((N * i) as i32);
    let row = Row::along_x(Fx16::normal([0.0, 0.0, 1.0]), [corner(y), Length::ZERO], corner);
    row.fill(light, first, arrived);
}

/// Returns light with 14 fraction bits, times 128/127 because of the unit of normals, at most the last below 2.
///
/// A step between corners is rounded down, in both directions, by less than 1: `2 N` more keep the light positive.
#[inline(always)]
fn scaled<const N: usize>(light: Light16) -> u32 {
    let light = light.to_bits();
    (light + (light >> 7) + 2 * N as u32).min(0x7fff)
}
