//! Gradients.

use core::{array, marker::PhantomData};

use crate::{
    color::Rgb,
    display::{Pixel, decode, offsets, packed, shown},
    error::{Error, Expected, Parameter, check_between},
    trig,
};

/// A gradient of sRGB colours, linear or radial, with dither: no bands, even in RGB565.
///
/// The colours are evenly spaced, and between two of them the encoded values are interpolated, as in
/// CSS and LVGL. The dither is that of [`Pixel::dithered`]: the mean light is that of the colour.
///
/// A table has `N` levels in `4 N` bytes. Before the dither, a pixel differs from the exact gradient in two ways
/// (derived):
///
/// - It has the colour of a place that is off by at most half a level, which is `1 / (2 (N - 1))` of the gradient,
///   and by 1/32 of a level of rounding, with up to 256 levels and 65,535 pixels.
/// - Each channel is rounded by at most `2^-(f + 1)` steps, with the fraction bits `f` of a
///   [`Ramp`](crate::display::Ramp), and by 3e-6 of full scale.
///
/// ```
/// use luminaire::{Rgb, display::Rgb565, draw::Gradient};
/// // The evening sky of a display of 240 x 160 pixels, and the sun in it.
/// let [night, dusk, gold] = [Rgb::new(12, 18, 60), Rgb::new(190, 90, 80), Rgb::new(255, 220, 150)];
/// let sky: Gradient<Rgb565> = Gradient::linear(&[night, dusk], [0.0, 0.0], [0.0, 159.0])?;
/// let sun: Gradient<Rgb565, 64> = Gradient::radial(&[gold, gold, dusk], [120.0, 140.0], 30.0)?;
/// let mut row = [Rgb565(0); 240];
/// sky.row(150, 0, &mut row); // y, x
/// sun.row(150, 90, &mut row[90..150]);
/// assert!(row[120].to_codes().green > 190 && row[0].to_codes().green < 90);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Gradient<P, const N: usize = 256> {
    levels: [u32; N],
    shape: Shape,
    pixels: PhantomData<P>,
}

/// The shape of a [`Gradient`], as [`codegen`](crate::codegen) writes it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// The level of a pixel is a sum. All 32 bits and a sign: past them is past an end of the gradient.
    Linear {
        /// The sum at `(0, 0)`.
        start: i64,
        /// What one pixel to the right adds.
        across: i64,
        /// What one pixel down adds.
        down: i64,
    },
    /// The level of a pixel follows the squared distance.
    Radial {
        /// The centre, in 1/256 pixel.
        center: [i64; 2],
        /// The radius, in 1/256 pixel.
        radius: i64,
        /// The square of the radius of level 1.
        square: i64,
        /// The fraction bits of squares.
        bits: u32,
    },
}

/// The coordinate of the farthest places, in pixels.
const FARTHEST: f32 = 32_767.0;
/// The largest radius, in pixels.
const LARGEST: f32 = 8_191.0;

impl<P: Pixel, const N: usize> Gradient<P, N> {
    /// The last level.
    const LAST: usize = N.saturating_sub(1);
    /// The fraction bits of a level in a word of 32 bits that holds all levels.
    const BITS: u32 = (Self::LAST as u32 | 1).leading_zeros();

    /// Computes a gradient from the first colour at one place, `[x, y]` in pixels, to the last colour at
    /// another place. Beyond the places it has the colours of the ends.
    ///
    /// # Errors
    /// Fewer than 2 colours or more than 256; a coordinate outside -32,767 to 32,767; places less than one
    /// pixel apart.
    pub fn linear(colors: &[Rgb<u8>], from: [f32; 2], to: [f32; 2]) -> Result<Self, Error> {
        check_places([from, to].as_flattened())?;
        let [x, y] = from.map(f64::from);
        let [dx, dy] = [f64::from(to[0]) - x, f64::from(to[1]) - y];
        let square = dx * dx + dy * dy;
        check_between(Parameter::GradientLength, trig::sqrt(square as f32), 1.0, 3.0 * FARTHEST)?;
        let scale = Self::LAST as f64 * (1_u64 << Self::BITS) as f64 / square;
        let [across, down] = [dx * scale, dy * scale].map(nearest);
        let half = (1_u64 << Self::BITS) as f64 / 2.0;
        let start = nearest(half - across as f64 * x - down as f64 * y);
        Ok(Self::from_parts(levels::<P, N>(colors)?, Shape::Linear { start, across, down }))
    }

    /// Computes a gradient from the first colour at a centre, `[x, y]` in pixels, to the last colour at a
    /// radius and beyond.
    ///
    /// The level follows the squared distance from pixel to pixel, without a root. The centre and the
    /// radius are rounded to 1/256 pixel.
    ///
    /// # Errors
    /// Fewer than 2 colours or more than 256; a coordinate outside -32,767 to 32,767; a radius outside 1 to
    /// 8,191 pixels.
    pub fn radial(colors: &[Rgb<u8>], center: [f32; 2], radius: f32) -> Result<Self, Error> {
        check_places(&center)?;
        check_between(Parameter::GradientRadius, radius, 1.0, LARGEST)?;
        let (last, radius) = (Self::LAST.max(1) as f64, f64::from(radius));
        // As many bits as leave the widest level and the widest step of a pixel below 2^30.
        let mut widest = (2.0 * radius + 2.0).max(2.0 * radius * radius / last);
        let mut bits = 0;
        while widest < (1 << 29) as f64 {
            widest *= 2.0;
            bits += 1;
        }
        let shape = Shape::Radial {
            center: center.map(|place| nearest(256.0 * f64::from(place))),
            radius: nearest(256.0 * radius),
            square: nearest(radius * radius / (last * last) * (1_u64 << bits) as f64),
            bits,
        };
        Ok(Self::from_parts(levels::<P, N>(colors)?, shape))
    }

    /// Creates a gradient from its levels and its shape, as [`codegen`](crate::codegen) writes them.
    pub const fn from_parts(levels: [u32; N], shape: Shape) -> Self {
        Self { levels, shape, pixels: PhantomData }
    }

    /// Returns the levels and the shape.
    pub const fn parts(&self) -> (&[u32; N], Shape) {
        (&self.levels, self.shape)
    }

    /// Sets the pixels from `(x, y)` on. Coordinates are clamped to ±2^28.
    pub fn row(&self, y: i32, x: i32, pixels: &mut [P]) {
        const MOST: i32 = 1 << 28;
        let [x, y] = [x, y].map(|place| i64::from(place.clamp(-MOST, MOST)));
        match self.shape {
            Shape::Linear { start, across, down } => {
                let mut sum = start.wrapping_add(across.wrapping_mul(x)).wrapping_add(down.wrapping_mul(y));
                self.paint([x, y], pixels, |_| {
                    let inside = match (sum >> 32) as i32 {
                        0 => sum as u32,
                        1.. => u32::MAX,
                        _ => 0,
                    };
                    sum = sum.wrapping_add(across);
                    (inside >> Self::BITS) as usize
                });
            }
            Shape::Radial { center, radius, square, bits } => {
                let [right, down] = [x, y].map(|place| place << 8);
                let [dx, dy] = [right.wrapping_sub(center[0]), down.wrapping_sub(center[1])];
                // Half of the row's chord of the circle: pixels outside have the last level.
                let room = squared(radius).wrapping_sub(squared(dy));
                let half = if dy.unsigned_abs() <= radius.unsigned_abs() {
                    greatest(22, |half| half * half <= room)
                } else {
                    -256
                };
                let index = |place: i64| place.wrapping_sub(dx).clamp(0, 1 << 40) >> 8;
                let (first, end) = (index(255 - half), index(half + 256));
                let mut walk = Walk::new([dx.wrapping_add(first << 8), dy], square, bits, Self::LAST);
                let [first, end] = [first, end].map(|i| usize::try_from(i).unwrap_or(usize::MAX));
                self.paint([x, y], pixels, |i| {
                    if i >= first && i < end { walk.next(Self::LAST) } else { Self::LAST }
                });
            }
        }
    }

    /// Sets pixels to their levels: `level` returns the index of each pixel's.
    #[inline(always)]
    fn paint(&self, [x, y]: [i64; 2], pixels: &mut [P], mut level: impl FnMut(usize) -> usize) {
        let offsets = offsets::<P>(y as u32);
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let level = self.levels.get(level(i)).or(self.levels.last()).copied().unwrap_or_default();
            *pixel = shown(level, offsets[(x as usize).wrapping_add(i) % 8]);
        }
    }
}

/// A walk along a row of pixels through the levels of a radial gradient.
///
/// Level k has the squared distances from `b(k) = s (k - 1/2)^2` to `b(k + 1)`, where `s` is the square of
/// the radius of level 1. The differences `b(k + 1) - b(k) = 2 s k` and those between the squared
/// distances of neighbouring pixels fit 31 bits; the squares need not.
struct Walk {
    level: usize,
    /// The squared distance less `b(level)`.
    past: i32,
    /// `b(level + 1) - b(level)`, and what it grows by from level to level.
    width: i32,
    wider: i32,
    /// What the next pixel adds to the squared distance, and what this grows by from pixel to pixel.
    growth: i32,
    faster: i32,
}

impl Walk {
    /// Starts at a pixel, of which the distances in x and y from the centre are in 1/256 pixel.
    fn new([dx, dy]: [i64; 2], square: i64, bits: u32, most: usize) -> Self {
        // From 16 fraction bits to `bits`.
        let scaled = |square: i64| square.wrapping_shl(bits) >> 16;
        let begin = |k: i64| square.wrapping_mul(k * k - k).wrapping_add(square >> 2);
        let distance = scaled(squared(dx).wrapping_add(squared(dy)));
        let level = greatest(usize::BITS - most.leading_zeros(), |k| begin(k) <= distance).min(most as i64);
        Self {
            level: level as usize,
            past: distance.wrapping_sub(begin(level)) as i32,
            width: square.wrapping_mul(2 * level) as i32,
            wider: square.wrapping_mul(2) as i32,
            growth: scaled(dx.wrapping_mul(512).wrapping_add(1 << 16)) as i32,
            faster: scaled(1 << 17) as i32,
        }
    }

    /// Returns the level of the pixel and goes on to the next.
    #[inline(always)]
    fn next(&mut self, most: usize) -> usize {
        let level = self.level;
        self.past = self.past.wrapping_add(self.growth);
        self.growth = self.growth.wrapping_add(self.faster);
        while self.past >= self.width && self.level < most {
            self.past = self.past.wrapping_sub(self.width);
            self.width = self.width.wrapping_add(self.wider);
            self.level += 1;
        }
        while self.past < 0 && self.level > 0 {
            self.width = self.width.wrapping_sub(self.wider);
            self.past = self.past.wrapping_add(self.width);
            self.level -= 1;
        }
        level
    }
}

fn squared(value: i64) -> i64 {
    value.wrapping_mul(value)
}

/// Returns the greatest number below 2^bits up to which a predicate holds.
fn greatest(bits: u32, holds: impl Fn(i64) -> bool) -> i64 {
    (0..bits.min(31))
        .rev()
        .fold(0, |found, bit| if holds(found | 1 << bit) { found | 1 << bit } else { found })
}

/// Returns the nearest integer; saturates.
fn nearest(value: f64) -> i64 {
    (value + if value < 0.0 { -0.5 } else { 0.5 }) as i64
}

fn check_places(places: &[f32]) -> Result<(), Error> {
    places.iter().try_for_each(|place| check_between(Parameter::Place, *place, -FARTHEST, FARTHEST))
}

/// Computes the levels of evenly spaced colours.
fn levels<P: Pixel, const N: usize>(colors: &[Rgb<u8>]) -> Result<[u32; N], Error> {
    let accepted = Expected::WholeBetween(2, 256);
    if !(2..=256).contains(&colors.len()) {
        return Err(Error { parameter: Parameter::ColorCount, value: colors.len() as f32, accepted });
    }
    let spaces = (colors.len() - 1) as f32 / N.saturating_sub(1).max(1) as f32;
    Ok(array::from_fn(|level| {
        let place = level as f32 * spaces;
        let [from, to] =
            [0, 1].map(|i| colors.get(place as usize + i).or(colors.last()).copied().unwrap_or_default());
        let part = place - place as usize as f32;
        let mixed = from.map(f32::from).zip(to.map(f32::from), |from, to| from + part * (to - from));
        packed::<P>(mixed.map(|code| decode(code / 255.0)))
    }))
}
