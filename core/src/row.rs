//! Rows of pixels on flat surfaces, and the part of a row that a light can reach.

use core::ops::Range;

use crate::{
    color::Rgb,
    number::Scalar,
    points::{AlongX, Every, Points},
    shade::LightModel,
    vec3::Vec3,
};

/// The largest block of points that one test of a light skips.
const MOST: usize = 64;
/// The smallest block of points that is tested.
const LEAST: usize = 16;

/// A row of points on a straight line of a flat matte surface: a row of pixels on a wall or a floor.
///
/// A row finds which of its points a light can reach, in blocks of 16 to 64 points, and evaluates the
/// light there alone. `docs/EFFECTS.md` has the instructions of the test of a block, *bounding sphere*
/// (`cargo xtask measure`).
///
/// ```
/// use luminaire::{Angle, Cone, Fx16, Length, Rgb, SpotLight, Vec3, light::Row};
/// use luminaire::display::{Rgb565, clip};
///
/// let cone = Cone::soft(Angle::degrees(20.0))?;
/// let lights = [
///     SpotLight::new([2.0, 3.0, 1.0], [0.0, -1.0, 0.0], cone)?.with_intensity(9.0)?.compile::<Fx16>()?,
///     SpotLight::new([7.0, 3.0, 1.0], [0.0, -1.0, 0.0], cone)?.with_intensity(9.0)?.compile()?,
/// ];
/// // Ten metres of a floor, 32 pixels to the metre: a length has 16 fraction bits.
/// let row = Row::new(Fx16::normal([0.0, 1.0, 0.0]), |column| {
///     Vec3::new(Length::from_bits((column as i32) << (16 - 5)), Length::ZERO, Fx16::length(1.0))
/// });
/// let mut pixels = [0; 320];
/// row.light(&lights, &mut pixels, |pixel, column, light| {
///     *pixel = Rgb565::from_linear_dithered(clip(light), column as u32, 0).0.to_be();
/// });
/// assert!(pixels[64] != 0 && pixels[224] != 0 && pixels[144] == 0);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Row<S: Scalar, F> {
    normal: Vec3<S>,
    points: F,
}

impl<S: Scalar, F: Fn(usize) -> Vec3<S::Length>> Row<S, F> {
    /// Creates a row with the surface's normal, of unit length, and a function from an index to a
    /// point.
    ///
    /// The points are on a straight line and in order, each within a step of the length of its
    /// exact place. Their distances may differ, as in perspective. If they are not on a line, a
    /// light may be missing at some of them.
    pub fn new(normal: Vec3<S>, points: F) -> Self {
        Self { normal, points }
    }
}

impl<S: Scalar, F: Fn(usize) -> S::Length> Row<S, AlongX<S::Length, F>> {
    /// Creates a row of points that share y and z, with the surface's normal, of unit length, and a
    /// function from an index to x.
    ///
    /// The points are in order, as those of [`new`](Self::new). A wall or a floor that is parallel to the
    /// picture's rows has such points in every row, in perspective, too. In the quick evaluation of
    /// [`Fx16`](crate::Fx16) such a row takes fewer instructions a point: y and z are scaled and squared once for all
    /// points whose vectors from the light have a largest component of the same bit length; so is their part of
    /// Lambert's cosine, if the normal has no x.
    ///
    /// ```
    /// use luminaire::{Angle, Cone, Fx16, Length, Scalar, SpotLight, falloff::Soft, light::Row, number::Light16};
    ///
    /// let cone = Cone::from_field(Soft, Angle::degrees(40.0))?;
    /// let light = SpotLight::new([5.0, 3.0, 1.0], [0.0, -1.0, 0.0], cone)?.compile_quick::<Fx16>()?;
    /// // A row of a floor, 32 pixels to the metre.
    /// let row = Row::along_x(Fx16::normal([0.0, 1.0, 0.0]), [Length::ZERO, Fx16::length(1.0)], |column| {
    ///     Length::from_bits((column as i32) << (16 - 5))
    /// });
    /// let mut arrived = [Light16::ZERO; 320];
    /// let lit = row.reach(&light, arrived.len());
    /// row.fill(&light, lit.start, &mut arrived[lit]);
    /// assert!(arrived[160] != Light16::ZERO && arrived[0] == Light16::ZERO);
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    pub fn along_x(normal: Vec3<S>, [y, z]: [S::Length; 2], x: F) -> Self {
        Self { normal, points: AlongX { y, z, x } }
    }
}

impl<S: Scalar, F: Points<S>> Row<S, F> {
    /// Returns a range of indices below `length` outside which no point receives this light.
    ///
    /// The range is longer than the lit part: by less than 16 points at each end, and by what
    /// [`can_reach`](crate::light::CompiledSpotLight::can_reach) does not skip. Of other lights
    /// than spotlights it is the whole row.
    pub fn reach<L: LightModel<S>>(&self, light: &L, length: usize) -> Range<usize> {
        let start = first_reached(light, length, |i| self.points.at(i));
        let mirrored = |i| self.points.at((length - 1).wrapping_sub(i));
        let beyond = first_reached(light, length.saturating_sub(start), mirrored);
        start..length - beyond
    }

    /// Sets `arrived` to the irradiance from a light at the points from index `first` on, not yet multiplied
    /// by the light's colour.
    ///
    /// The irradiance is bit-identical to that of `irradiance`. It is zero outside the range of
    /// [`reach`](Self::reach).
    #[inline(always)]
    pub fn fill<L: LightModel<S>>(&self, light: &L, first: usize, arrived: &mut [S::Irradiance]) {
        self.fill_facing(light, |_| self.normal, first, arrived);
    }

    /// Sets `arrived` as [`fill`](Self::fill) does, with a normal for each index in place of the row's: that of
    /// a normal map, or of a body whose points are in the row.
    #[inline(always)]
    pub fn fill_facing<L: LightModel<S>>(
        &self,
        light: &L,
        normal: impl Fn(usize) -> Vec3<S>,
        first: usize,
        arrived: &mut [S::Irradiance],
    ) {
        let points = Every::<_> { points: &self.points, first };
        light.fill(&points, |i| normal(first.wrapping_add(i)), arrived);
    }

    /// Sets `arrived` as [`fill`](Self::fill) does at every `N`-th point from index `first` on, and linearly
    /// between these points; `N` is 2, 4 or 8.
    ///
    /// [`interpolation_bound`](crate::SpotLight::interpolation_bound) bounds the error of a light with an
    /// inverse square. In fixed point means are rounded down, by at most 1/2, 3/4 or 9/8 of a step of the
    /// format. The light is evaluated at up to `N` indices beyond the end of `arrived`, too.
    /// The start of [`reach`](Self::reach) is a multiple of 16: from there, the same points of a row are
    /// evaluated wherever the light's reach begins.
    ///
    /// ```
    /// use luminaire::{Angle, Cone, Fx16, Length, Rgb, Scalar, SpotLight, light::Row, number::Light16};
    /// use luminaire::display::{Rgb565, clip};
    ///
    /// let cone = Cone::soft(Angle::degrees(40.0))?;
    /// let spot = SpotLight::new([5.0, 3.0, 1.0], [0.0, -1.0, 0.0], cone)?.with_intensity(4.5)?;
    /// let light = spot.compile_quick::<Fx16>()?;
    /// // A row of a floor, 64 pixels to the metre: the points that are evaluated are 1/16 m apart.
    /// let row = Row::along_x(Fx16::normal([0.0, 1.0, 0.0]), [Length::ZERO, Fx16::length(1.0)], |column| {
    ///     Length::from_bits((column as i32) << (16 - 6))
    /// });
    /// let mut arrived = [Light16::ZERO; 640];
    /// let lit = row.reach(&light, arrived.len());
    /// row.fill_interpolated::<_, 4>(&light, lit.start, &mut arrived[lit]);
    /// // Less than a code of eight bits in linear light.
    /// assert!(spot.interpolation_bound(1.0 / 16.0, 3.0).unwrap() < 0.9 / 255.0);
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    #[inline(always)]
    pub fn fill_interpolated<L: LightModel<S>, const N: usize>(
        &self,
        light: &L,
        first: usize,
        arrived: &mut [S::Irradiance],
    ) {
        const { assert!(matches!(N, 2 | 4 | 8), "N is 2, 4 or 8") };
        let mut evaluated = [S::Irradiance::default(); RUNS + 1];
        for (i, points) in arrived.chunks_mut(RUNS * N).enumerate() {
            let from = first.wrapping_add(i * RUNS * N);
            let last = points.len().div_ceil(N);
            let ends = evaluated.get_mut(..=last).unwrap_or_default();
            let every = Every::<_, N> { points: &self.points, first: from };
            light.fill(&every, |_| self.normal, ends);
            for (run, ends) in points.chunks_mut(N).zip(ends.windows(2)) {
                if let [from, to] = *ends {
                    set_between::<S>(from, to, run, N);
                }
            }
        }
    }

    /// Calls `show` for each pixel that receives light, with the pixel, its index and the sum of
    /// the lights, each times its colour. Pixels without light keep their values.
    ///
    /// The sum is bit-identical to that of `irradiance`, [`Rgb::lit`] and addition over all
    /// lights. Blocks of 64 pixels are lit by one light after the other: their sums take 1 KiB of the stack, in
    /// `Fx32` 2 KiB.
    #[inline]
    pub fn light<L: LightModel<S>, T>(
        &self,
        lights: &[L],
        pixels: &mut [T],
        show: impl FnMut(&mut T, usize, Rgb<S::Irradiance>),
    ) {
        self.light_by(pixels, |block| lights.iter().for_each(|light| block.add(light)), show);
    }

    /// Calls `show` as [`light`](Self::light) does, with light that `add` adds to blocks of pixels: that of lights of
    /// several types.
    ///
    /// ```
    /// use luminaire::{AmbientLight, Angle, Cone, Fx16, PointLight, SpotLight, Vec3, light::Row};
    /// use luminaire::display::{Rgb565, clip};
    ///
    /// let cone = Cone::soft(Angle::degrees(20.0))?;
    /// let spot = SpotLight::new([2.0, 3.0, 1.0], [0.0, -1.0, 0.0], cone)?.with_intensity(9.0)?.compile::<Fx16>()?;
    /// let bulb = PointLight::new([7.0, 3.0, 1.0])?.compile::<Fx16>()?;
    /// let ambient = AmbientLight::new([0.5, 0.7, 1.0].into())?.with_intensity(0.02)?.compile::<Fx16>();
    /// let row = Row::new(Fx16::normal([0.0, 1.0, 0.0]), |column| Fx16::point([column as f32 / 32.0, 0.0, 1.0]));
    /// let mut pixels = [0; 320];
    /// row.light_by(
    ///     &mut pixels,
    ///     |block| {
    ///         block.add_ambient(ambient);
    ///         block.add(&spot);
    ///         block.add(&bulb);
    ///     },
    ///     |pixel, _, light| *pixel = Rgb565::from_linear(clip(light)).0,
    /// );
    /// assert!(pixels[64] > pixels[224] && pixels[224] > pixels[144]);
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    #[inline]
    pub fn light_by<T>(
        &self,
        pixels: &mut [T],
        mut add: impl FnMut(&mut Block<'_, S, F>),
        mut show: impl FnMut(&mut T, usize, Rgb<S::Irradiance>),
    ) {
        for (block, pixels) in pixels.chunks_mut(MOST).enumerate() {
            let first = block * MOST;
            let mut sums = [Rgb::default(); MOST];
            let row = Row { normal: self.normal, points: Every { points: &self.points, first } };
            add(&mut Block { row, sums: sums.get_mut(..pixels.len()).unwrap_or_default() });
            for (i, (pixel, sum)) in pixels.iter_mut().zip(sums).enumerate() {
                if sum != Rgb::default() {
                    show(pixel, first + i, sum);
                }
            }
        }
    }
}

/// Pixels of a row to which light is added: see [`Row::light_by`].
pub struct Block<'a, S: Scalar, F> {
    row: Row<S, Every<'a, F>>,
    /// At most as many as a block.
    sums: &'a mut [Rgb<S::Irradiance>],
}

impl<S: Scalar, F: Points<S>> Block<'_, S, F> {
    /// Adds a light, times its colour, at each pixel that it may reach.
    pub fn add<L: LightModel<S>>(&mut self, light: &L) {
        let dark = S::Irradiance::default();
        let lit = self.row.reach(light, self.sums.len());
        let mut arrived = [dark; MOST];
        let arrived = arrived.get_mut(..lit.len()).unwrap_or_default();
        self.row.fill(light, lit.start, arrived);
        let [color, _] = light.colors();
        for (sum, &mut arrived) in self.sums.get_mut(lit).unwrap_or_default().iter_mut().zip(arrived) {
            if arrived != dark {
                *sum += Rgb::lit::<S>(arrived, color);
            }
        }
    }

    /// Adds ambient light, the same at every pixel.
    pub fn add_ambient(&mut self, light: Rgb<S::Irradiance>) {
        self.sums.iter_mut().for_each(|sum| *sum += light);
    }
}

impl<S: Scalar, F> core::fmt::Debug for Block<'_, S, F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Block").field("sums", &self.sums).finish_non_exhaustive()
    }
}

/// The runs of interpolated points whose ends are evaluated together.
const RUNS: usize = 16;

/// Sets a run of points between two values: the first point to `from`. The point after a run of `length` points
/// has the value `to`, and is not in the run.
#[inline(always)]
fn set_between<S: Scalar>(from: S::Irradiance, to: S::Irradiance, run: &mut [S::Irradiance], length: usize) {
    let middle = S::mean_light(from, to);
    let quarter = |from, to| {
        let middle = S::mean_light(from, to);
        [from, S::mean_light(from, middle), middle, S::mean_light(middle, to)]
    };
    let set =
        |run: &mut [_], values: &[_]| run.iter_mut().zip(values).for_each(|(point, value)| *point = *value);
    match length {
        2 => set(run, &[from, middle]),
        4 => set(run, &quarter(from, to)),
        _ => {
            let ([a, b, c, d], [e, f, g, h]) = (quarter(from, middle), quarter(middle, to));
            set(run, &[a, b, c, d, e, f, g, h]);
        }
    }
}

/// Returns the first index of points on a line that a light can reach, or `length`.
///
/// Blocks of points are skipped by their bounding spheres. A block that the light can reach is
/// divided, down to blocks of [`LEAST`] points.
fn first_reached<S: Scalar, L: LightModel<S>>(
    light: &L,
    length: usize,
    point: impl Fn(usize) -> Vec3<S::Length>,
) -> usize {
    let (mut start, mut size) = (0, MOST);
    while start < length {
        let last = (length - 1).min(start.saturating_add(size - 1));
        let (center, radius) = S::enclosing(point(start), point(last));
        if !light.can_reach(center, radius) {
            start = last + 1;
            if size < MOST && start & (2 * size - 1) == 0 {
                size *= 2;
            }
        } else if size > LEAST {
            size /= 2;
        } else {
            break;
        }
    }
    start.min(length)
}
