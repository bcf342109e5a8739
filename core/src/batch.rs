//! Many points and one compiled light: slices in, slices out, each quantity in a slice of its own.
//!
//! Every answer has the bits that the call for a single point gives; only the order of the work differs. In `f32` the
//! points are taken in blocks: a first pass finds the roots of a block and a second one does the rest, so that neither
//! waits for the other, and both become vector instructions of whatever width the build allows. Fixed point is taken
//! point by point, and leaves a point where nothing can arrive at once.
//!
//! Slices of unequal length are read and written as far as the shortest of them goes; what lies beyond stays as it was.

use core::ops::Range;

use crate::{
    attenuation::Attenuation,
    color::Rgb,
    cone::CompiledCone,
    falloff::Falloff,
    number::{Fraction, Offset, Ray, Scalar},
    shade::{CompiledPointLight, CompiledSpotLight, LightModel, SurfacePoint},
    specular::NoSpecular,
    vec3::Vec3,
};

/// How many points make a block: enough that starting a loop costs little, and few enough that what one pass leaves
/// for the next stays in the nearest cache. Compilers make a straight line of a loop over 32, which is slower.
const BLOCK: usize = 64;

/// What a pass leaves for the next one, so aligned that no vector load crosses a line of the cache.
#[repr(align(64))]
struct Lanes<T>([T; BLOCK]);

/// A light that stands somewhere.
trait Batched<S: Scalar>: LightModel<S> {
    /// Where it stands.
    fn position(&self) -> Vec3<S::Length>;
    /// What arrives at a single point, in the form that suits a loop.
    #[inline]
    fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        let skips = !S::Offset::ROOTS_FIRST;
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), skips).diffuse
    }
    /// The same, once the root is paid for.
    fn expose(
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
    fn expose(
        &self,
        offset: &S::Offset,
        ray: &<S::Offset as Offset<S>>::Ray,
        normal: Vec3<S>,
    ) -> S::Irradiance {
        let cosine = ray.cosine(offset.facing(normal), normal);
        let share = cosine.of(self.falloff.toward(ray, self.axis));
        A::expose(&self.attenuation, offset, ray, share, self.intensity)
    }
}

impl<S: Scalar, A: Attenuation> Batched<S> for CompiledPointLight<S, A> {
    #[inline]
    fn position(&self) -> Vec3<S::Length> {
        self.position
    }

    #[inline]
    fn expose(
        &self,
        offset: &S::Offset,
        ray: &<S::Offset as Offset<S>>::Ray,
        normal: Vec3<S>,
    ) -> S::Irradiance {
        let cosine = ray.cosine(offset.facing(normal), normal).scalar();
        A::expose(&self.attenuation, offset, ray, cosine, self.intensity)
    }
}

/// How many points make whole blocks, and how many there are.
fn extent<S: Scalar>(points: Vec3<&[S::Length]>, normals: Vec3<&[S]>, lights: usize) -> (usize, usize) {
    let points = points.x.len().min(points.y.len()).min(points.z.len());
    let normals = normals.x.len().min(normals.y.len()).min(normals.z.len());
    let count = lights.min(points).min(normals);
    (if S::Offset::ROOTS_FIRST { count - count % BLOCK } else { 0 }, count)
}

/// A range of three columns, in blocks.
fn blocks<T>(columns: Vec3<&[T]>, range: Range<usize>) -> impl Iterator<Item = Vec3<&[T; BLOCK]>> {
    let blocks = columns.map(|column| {
        let column = column.get(range.clone()).unwrap_or_default();
        column.chunks_exact(BLOCK).filter_map(<[T]>::first_chunk)
    });
    blocks.x.zip(blocks.y).zip(blocks.z).map(|((x, y), z)| Vec3::new(x, y, z))
}

/// A column in blocks.
fn blocks_mut<T>(column: &mut [T]) -> impl Iterator<Item = &mut [T; BLOCK]> {
    column.chunks_exact_mut(BLOCK).filter_map(<[T]>::first_chunk_mut)
}

/// A range of three columns, row by row.
fn rows<T: Copy>(columns: Vec3<&[T]>, range: Range<usize>) -> impl Iterator<Item = Vec3<T>> {
    let rows = columns.map(|column| column.get(range.clone()).unwrap_or_default().iter());
    rows.x.zip(rows.y).zip(rows.z).map(|((&x, &y), &z)| Vec3::new(x, y, z))
}

/// The light at each point of a block.
#[inline]
fn light_block<S: Scalar>(
    source: &impl Batched<S>,
    points: Vec3<&[S::Length; BLOCK]>,
    normals: Vec3<&[S; BLOCK]>,
    lights: &mut [S::Irradiance; BLOCK],
) {
    let mut reciprocals = Lanes([0.0; BLOCK]);
    for (i, reciprocal) in reciprocals.0.iter_mut().enumerate() {
        *reciprocal = S::offset(source.position(), points.map(|column| column[i])).reciprocal();
    }
    for (i, light) in lights.iter_mut().enumerate() {
        let offset = S::offset(source.position(), points.map(|column| column[i]));
        let ray = offset.ray_of(reciprocals.0[i]);
        *light = source.expose(&offset, &ray, normals.map(|column| column[i]));
    }
}

/// Adds a light to a channel.
#[inline]
fn add<S: Scalar>(sum: &mut S::Irradiance, light: S::Irradiance, color: S) {
    *sum = S::add_light(*sum, S::filter(light, color));
}

/// The light of many surface points: what `irradiance_each` of a light gives.
fn irradiance_each<S: Scalar, L: Batched<S>>(
    light: &L,
    points: Vec3<&[S::Length]>,
    normals: Vec3<&[S]>,
    lights: &mut [S::Irradiance],
) {
    let (whole, count) = extent(points, normals, lights.len());
    let sites = blocks(points, 0..whole).zip(blocks(normals, 0..whole));
    for ((points, normals), lights) in sites.zip(blocks_mut(lights)) {
        light_block(light, points, normals, lights);
    }
    let sites = rows(points, whole..count).zip(rows(normals, whole..count));
    for ((point, normal), sum) in sites.zip(lights.iter_mut().skip(whole)) {
        *sum = light.irradiance(point, normal);
    }
}

/// The light of many surface points in a colour, added to what is there: what `add_each` of a light does.
fn add_each<S: Scalar, L: Batched<S>>(
    light: &L,
    color: Rgb<S>,
    points: Vec3<&[S::Length]>,
    normals: Vec3<&[S]>,
    Rgb { red, green, blue }: Rgb<&mut [S::Irradiance]>,
) {
    let (whole, count) = extent(points, normals, red.len().min(green.len()).min(blue.len()));
    let sites = blocks(points, 0..whole).zip(blocks(normals, 0..whole));
    let sums = blocks_mut(red).zip(blocks_mut(green)).zip(blocks_mut(blue));
    let mut lights = Lanes([S::Irradiance::default(); BLOCK]);
    for ((points, normals), ((red, green), blue)) in sites.zip(sums) {
        light_block(light, points, normals, &mut lights.0);
        for (sums, color) in [(red, color.red), (green, color.green), (blue, color.blue)] {
            sums.iter_mut().zip(&lights.0).for_each(|(sum, &light)| add(sum, light, color));
        }
    }
    let sites = rows(points, whole..count).zip(rows(normals, whole..count));
    let sums = red.iter_mut().zip(green.iter_mut()).zip(blue.iter_mut()).skip(whole);
    for ((point, normal), ((red, green), blue)) in sites.zip(sums) {
        let light = light.irradiance(point, normal);
        add(red, light, color.red);
        add(green, light, color.green);
        add(blue, light, color.blue);
    }
}

impl<S: Scalar, P: Falloff, A: Attenuation> CompiledSpotLight<S, P, A> {
    /// The light that arrives at each of many surface points: to the bit what [`irradiance`](Self::irradiance)
    /// gives for one.
    ///
    /// Points, normals and lights are structures of arrays, a slice for each component. As many points are lit
    /// as the shortest slice has; lights beyond them stay as they were.
    pub fn irradiance_each(
        &self,
        points: Vec3<&[S::Length]>,
        normals: Vec3<&[S]>,
        lights: &mut [S::Irradiance],
    ) {
        irradiance_each(self, points, normals, lights);
    }

    /// Adds the light that arrives at each of many surface points, in the light's colour, to what is there: to the
    /// bit what [`irradiance`](Self::irradiance), [`Rgb::lit`] and [`Rgb::plus`] give for one. Slices are those of
    /// [`irradiance_each`](Self::irradiance_each).
    pub fn add_each(&self, points: Vec3<&[S::Length]>, normals: Vec3<&[S]>, sums: Rgb<&mut [S::Irradiance]>) {
        add_each(self, self.color, points, normals, sums);
    }
}

impl<S: Scalar, A: Attenuation> CompiledPointLight<S, A> {
    /// The light that arrives at each of many surface points: to the bit what [`irradiance`](Self::irradiance)
    /// gives for one.
    ///
    /// Points, normals and lights are structures of arrays, a slice for each component. As many points are lit
    /// as the shortest slice has; lights beyond them stay as they were.
    pub fn irradiance_each(
        &self,
        points: Vec3<&[S::Length]>,
        normals: Vec3<&[S]>,
        lights: &mut [S::Irradiance],
    ) {
        irradiance_each(self, points, normals, lights);
    }

    /// Adds the light that arrives at each of many surface points, in the light's colour, to what is there: to the
    /// bit what [`irradiance`](Self::irradiance), [`Rgb::lit`] and [`Rgb::plus`] give for one. Slices are those of
    /// [`irradiance_each`](Self::irradiance_each).
    pub fn add_each(&self, points: Vec3<&[S::Length]>, normals: Vec3<&[S]>, sums: Rgb<&mut [S::Irradiance]>) {
        add_each(self, self.color, points, normals, sums);
    }
}

impl<S: Scalar, P: Falloff> CompiledCone<S, P> {
    /// The intensity at each of many versines: to the bit what [`at`](Self::at) gives for one. As many as the shorter
    /// slice has.
    pub fn at_each(&self, versines: &[S::Versine], intensities: &mut [S]) {
        for (intensity, &versine) in intensities.iter_mut().zip(versines) {
            *intensity = self.at(versine);
        }
    }
}
