//! Many points and one compiled light: slices in and out, each quantity in its own slice.
//!
//! Every result is bit-identical to the result of a single-point call; only the order of the work
//! differs. In `f32` the points are processed in blocks. A first pass computes the square roots of
//! a block, and a second pass does all other computations. So no computation waits for a square
//! root, and compilers vectorise both passes to the width of the target; with the feature `native` to that
//! of the processor, if it has AVX2. Fixed point is processed point by point, with early-outs: without
//! them, compilers do not vectorise it either, because of its tables.
//!
//! If slices differ in length, the shortest slice determines the number of points. Elements beyond
//! this number are not changed.

use core::ops::Range;

use crate::{
    attenuation::Attenuation,
    color::Rgb,
    cone::CompiledCone,
    falloff::Falloff,
    number::{Fraction, Offset, Quick, Ray, Scalar},
    shade::{
        CompiledDirectionalLight, CompiledPointLight, CompiledSpotLight, LightModel, QuickSpotLight,
        SurfacePoint,
    },
    specular::NoSpecular,
    vec3::Vec3,
};

/// Number of points per block. The number is large enough to amortise the start of a loop. The
/// number is also small enough for the first-level cache to hold the results of the first pass.
///
/// A block of 32 points would be slower, because compilers fully unroll a loop over 32 points.
const BLOCK: usize = 64;

/// Results passed from the first pass to the second, aligned so that no vector load crosses a cache
/// line.
#[repr(align(64))]
struct Lanes<T>([T; BLOCK]);

/// A light with a position.
trait Batched<S: Scalar>: LightModel<S> {
    /// Returns the position of the light.
    fn position(&self) -> Vec3<S::Length>;
    /// Returns the irradiance at a single point, given the direction and distance.
    fn light_along(
        &self,
        offset: &S::Offset,
        ray: &<S::Offset as Offset<S>>::Ray,
        normal: Vec3<S>,
    ) -> S::Irradiance;
}

impl<S: Scalar, P: Falloff, A: Attenuation> Batched<S> for CompiledSpotLight<S, P, A> {
    #[inline]
    fn position(&self) -> Vec3<S::Length> {
        self.position
    }

    #[inline]
    fn light_along(
        &self,
        offset: &S::Offset,
        ray: &<S::Offset as Offset<S>>::Ray,
        normal: Vec3<S>,
    ) -> S::Irradiance {
        let cosine = ray.cosine(offset.facing(normal), normal);
        let share = cosine.times_value(self.cone.toward(ray, self.axis));
        A::light(&self.attenuation, offset, ray, share, self.intensity)
    }
}

impl<S: Scalar, A: Attenuation> Batched<S> for CompiledPointLight<S, A> {
    #[inline]
    fn position(&self) -> Vec3<S::Length> {
        self.position
    }

    #[inline]
    fn light_along(
        &self,
        offset: &S::Offset,
        ray: &<S::Offset as Offset<S>>::Ray,
        normal: Vec3<S>,
    ) -> S::Irradiance {
        let cosine = ray.cosine(offset.facing(normal), normal).value();
        A::light(&self.attenuation, offset, ray, cosine, self.intensity)
    }
}

/// Returns the number of points.
fn extent<S: Scalar>(points: Vec3<&[S::Length]>, normals: Vec3<&[S]>, lights: usize) -> usize {
    let points = points.x.len().min(points.y.len()).min(points.z.len());
    let normals = normals.x.len().min(normals.y.len()).min(normals.z.len());
    lights.min(points).min(normals)
}

/// Returns the number of points in whole blocks.
fn in_blocks<S: Scalar>(count: usize) -> usize {
    if S::Offset::ROOTS_FIRST { count - count % BLOCK } else { 0 }
}

/// Returns the blocks of a range of indices of three columns.
///
/// Every item is `Some`; the loops that use this iterator skip `None`. If this function removed
/// `None` by a `filter_map`, the loops would take more instructions, because the compiler
/// would no longer turn the zipped columns into a loop over one index (callgrind, `irradiance_each`
/// and `add_each` of a soft spotlight in f32, x86-64).
fn blocks<T>(columns: Vec3<&[T]>, range: Range<usize>) -> impl Iterator<Item = Option<Vec3<&[T; BLOCK]>>> {
    let blocks = columns.map(|column| {
        let column = column.get(range.clone()).unwrap_or_default();
        column.chunks_exact(BLOCK).map(<[T]>::first_chunk)
    });
    blocks.x.zip(blocks.y).zip(blocks.z).map(|((x, y), z)| Some(Vec3::new(x?, y?, z?)))
}

/// Iterates over a column in blocks, as [`blocks`] does.
fn blocks_mut<T>(column: &mut [T]) -> impl Iterator<Item = Option<&mut [T; BLOCK]>> {
    column.chunks_exact_mut(BLOCK).map(<[T]>::first_chunk_mut)
}

/// Returns the vectors at a range of indices of three columns, which hold their coordinates.
fn rows<T: Copy>(columns: Vec3<&[T]>, range: Range<usize>) -> impl Iterator<Item = Vec3<T>> {
    let rows = columns.map(|column| column.get(range.clone()).unwrap_or_default().iter());
    rows.x.zip(rows.y).zip(rows.z).map(|((&x, &y), &z)| Vec3::new(x, y, z))
}

/// Computes the irradiance at each point of a block.
#[inline(always)]
fn light_block<S: Scalar>(
    source: &impl Batched<S>,
    points: Vec3<&[S::Length; BLOCK]>,
    normals: Vec3<&[S; BLOCK]>,
    lights: &mut [S::Irradiance; BLOCK],
) {
    let mut reciprocals = Lanes([0.0; BLOCK]);
    for (i, reciprocal) in reciprocals.0.iter_mut().enumerate() {
        *reciprocal = S::Offset::between(source.position(), points.map(|column| column[i])).reciprocal();
    }
    for (i, light) in lights.iter_mut().enumerate() {
        let offset = S::Offset::between(source.position(), points.map(|column| column[i]));
        let ray = offset.ray_of(reciprocals.0[i]);
        *light = source.light_along(&offset, &ray, normals.map(|column| column[i]));
    }
}

/// Adds light, multiplied by a colour, to a channel.
#[inline(always)]
fn add<S: Scalar>(sum: &mut S::Irradiance, light: S::Irradiance, color: S) {
    *sum = *sum + S::filter(light, color);
}

/// Returns the irradiance at a single point, with early-outs in fixed point and without branches in
/// `f32`.
#[inline]
fn single<S: Scalar, L: LightModel<S>>(light: &L, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
    let skips = !S::Offset::ROOTS_FIRST;
    light.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), skips).diffuse
}

/// Computes the irradiance at a range of points, one by one.
fn irradiance_singly<S: Scalar, L: LightModel<S>>(
    light: &L,
    range: Range<usize>,
    points: Vec3<&[S::Length]>,
    normals: Vec3<&[S]>,
    lights: &mut [S::Irradiance],
) {
    let sites = rows(points, range.clone()).zip(rows(normals, range.clone()));
    for ((point, normal), sum) in sites.zip(lights.iter_mut().skip(range.start)) {
        *sum = single(light, point, normal);
    }
}

/// Adds the irradiance at a range of points, one by one.
fn add_singly<S: Scalar, L: LightModel<S>>(
    light: &L,
    range: Range<usize>,
    points: Vec3<&[S::Length]>,
    normals: Vec3<&[S]>,
    Rgb { red, green, blue }: Rgb<&mut [S::Irradiance]>,
) {
    let [color, _] = light.colors();
    let sites = rows(points, range.clone()).zip(rows(normals, range.clone()));
    let sums = red.iter_mut().zip(green.iter_mut()).zip(blue.iter_mut()).skip(range.start);
    for ((point, normal), ((red, green), blue)) in sites.zip(sums) {
        let light = single(light, point, normal);
        add(red, light, color.red);
        add(green, light, color.green);
        add(blue, light, color.blue);
    }
}

/// Runs a loop over many points with the vectors of the processor, by the feature `native`.
#[inline(always)]
fn with_vectors(work: impl FnOnce()) {
    #[cfg(feature = "native")]
    luminaire_native::with_vectors(work);
    #[cfg(not(feature = "native"))]
    work();
}

/// Computes the irradiance at each point, in blocks.
fn irradiance_each<S: Scalar, L: Batched<S>>(
    light: &L,
    count: usize,
    points: Vec3<&[S::Length]>,
    normals: Vec3<&[S]>,
    lights: &mut [S::Irradiance],
) {
    let whole = in_blocks::<S>(count);
    let sites = blocks(points, 0..whole).zip(blocks(normals, 0..whole));
    let blocks = sites.zip(blocks_mut(lights));
    with_vectors(
        #[inline(always)]
        || {
            for ((points, normals), lights) in blocks {
                let (Some(points), Some(normals), Some(lights)) = (points, normals, lights) else { continue };
                light_block(light, points, normals, lights);
            }
        },
    );
    irradiance_singly(light, whole..count, points, normals, lights);
}

/// Adds the irradiance at each point, in blocks.
fn add_each<S: Scalar, L: Batched<S>>(
    light: &L,
    count: usize,
    points: Vec3<&[S::Length]>,
    normals: Vec3<&[S]>,
    Rgb { red, green, blue }: Rgb<&mut [S::Irradiance]>,
) {
    let ([color, _], whole) = (light.colors(), in_blocks::<S>(count));
    let sites = blocks(points, 0..whole).zip(blocks(normals, 0..whole));
    let sums = blocks_mut(red).zip(blocks_mut(green)).zip(blocks_mut(blue));
    let mut lights = Lanes([S::Irradiance::default(); BLOCK]);
    let blocks = sites.zip(sums);
    with_vectors(
        #[inline(always)]
        || {
            for ((points, normals), ((red, green), blue)) in blocks {
                let (Some(points), Some(normals)) = (points, normals) else { continue };
                light_block(light, points, normals, &mut lights.0);
                for (sums, color) in [(red, color.red), (green, color.green), (blue, color.blue)] {
                    let Some(sums) = sums else { continue };
                    sums.iter_mut().zip(&lights.0).for_each(|(sum, &light)| add(sum, light, color));
                }
            }
        },
    );
    add_singly(light, whole..count, points, normals, Rgb { red, green, blue });
}

/// Implements the calls with slices for a kind of light.
macro_rules! slices {
    ([$($parameters:tt)*] $light:ty, $self:ident, $points:ident, $normals:ident,
     |$count:ident, $lights:ident| $each:expr, |$sums:ident| $add:expr) => {
        impl<$($parameters)*> $light {
            /// Computes the irradiance at each of many surface points.
            ///
            /// Each result is bit-identical to a call of `irradiance`. Points and normals are
            /// structures of arrays, one slice per component. The shortest slice determines the
            /// number of points; elements of `lights` beyond this number are not changed.
            pub fn irradiance_each(
                &$self,
                $points: Vec3<&[S::Length]>,
                $normals: Vec3<&[S]>,
                $lights: &mut [S::Irradiance],
            ) {
                let $count = extent($points, $normals, $lights.len());
                $each
            }

            /// Adds the irradiance at each of many surface points, times the light's colour, to `sums`.
            ///
            /// Each result is bit-identical to calls of `irradiance`, [`Rgb::lit`] and
            /// addition. The lengths of the slices have the same effect as in
            /// [`irradiance_each`](Self::irradiance_each).
            pub fn add_each(
                &$self,
                $points: Vec3<&[S::Length]>,
                $normals: Vec3<&[S]>,
                $sums: Rgb<&mut [S::Irradiance]>,
            ) {
                let lights = $sums.red.len().min($sums.green.len()).min($sums.blue.len());
                let $count = extent($points, $normals, lights);
                $add
            }
        }
    };
    ([$($parameters:tt)*] $light:ty, in blocks) => {
        slices!([$($parameters)*] $light, self, points, normals,
            |count, lights| irradiance_each(self, count, points, normals, lights),
            |sums| add_each(self, count, points, normals, sums));
    };
    ([$($parameters:tt)*] $light:ty, one by one) => {
        slices!([$($parameters)*] $light, self, points, normals,
            |count, lights| irradiance_singly(self, 0..count, points, normals, lights),
            |sums| add_singly(self, 0..count, points, normals, sums));
    };
}

slices!([S: Scalar, P: Falloff, A: Attenuation] CompiledSpotLight<S, P, A>, in blocks);
slices!([S: Scalar, A: Attenuation] CompiledPointLight<S, A>, in blocks);
slices!([S: Quick, P: Falloff, A: Attenuation] QuickSpotLight<S, P, A>, one by one);
slices!([S: Scalar] CompiledDirectionalLight<S>, one by one);

impl<S: Scalar, P: Falloff> CompiledCone<S, P> {
    /// Computes the intensity at each of many versines, up to the length of the shorter slice.
    ///
    /// Each result is bit-identical to [`at`](Self::at).
    pub fn at_each(&self, versines: &[S::Versine], intensities: &mut [S]) {
        for (intensity, &versine) in intensities.iter_mut().zip(versines) {
            *intensity = self.at(versine);
        }
    }
}
