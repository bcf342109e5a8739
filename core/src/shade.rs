//! Shading of one surface point by one compiled light.

mod directional;
mod measured;
mod point;
mod quick;
mod spot;

// Behind the evaluation: rustdoc shows methods in this order.
mod change;

pub use self::{
    directional::CompiledDirectionalLight, measured::CompiledMeasuredLight, point::CompiledPointLight,
    quick::QuickSpotLight, spot::CompiledSpotLight,
};

use crate::{
    attenuation::Attenuation,
    color::Rgb,
    cone::CompiledCone,
    distribution::Distribution,
    falloff::{CompiledFalloff, Falloff, Hard, Soft, Square},
    number::{Directed, Fraction, Lamp, Offset, Ray, Scalar, Share, Vectors},
    points::{Points, SurfacePoint, SurfacePoints},
    specular::{NoSpecular, SpecularLobe},
    vec3::{Vec3, nth},
};

/// Light that arrives at a surface, not yet multiplied by the light's colours; 1 is full scale.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Incident<I> {
    /// The product of intensity, falloff, attenuation and Lambert's cosine.
    pub diffuse: I,
    /// The product of intensity, falloff, attenuation and the specular lobe.
    pub specular: I,
}

/// A compiled light of any kind: what a function takes that lights with all of them.
///
/// The trait is sealed: its types are the compiled lights of this crate.
///
/// ```
/// use luminaire::{Angle, Cone, Fx16, Length, PointLight, Rgb, SpotLight, Vec3, light::LightModel, number::Light16};
///
/// fn shade<L: LightModel<Fx16>>(lights: &[L], point: Vec3<Length>, normal: Vec3<Fx16>) -> Rgb<Light16> {
///     let lit = |light: &L| Rgb::lit(light.irradiance(point, normal), light.color());
///     lights.iter().map(lit).fold(Rgb::default(), |sum, light| sum + light)
/// }
///
/// let cone = Cone::soft(Angle::degrees(20.0))?;
/// let spots = [SpotLight::new([0.0, 2.0, 0.0], [0.0, -1.0, 0.0], cone)?.compile()?];
/// let points = vec![PointLight::new([0.0, 2.0, 0.0])?.compile()?; 2];
/// let (point, normal) = (Fx16::point([0.0, 0.0, 0.0]), Fx16::normal([0.0, 1.0, 0.0]));
/// let [one, two] = [shade(&spots, point, normal), shade(&points, point, normal)];
/// assert_eq!(one + one, two);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no compiled light",
    note = "a described light is compiled for a number format: `light.compile::<Fx16>()`"
)]
pub trait LightModel<S: Scalar>: Copy + core::fmt::Debug + sealed::Sealed {
    /// Returns the irradiance of a matte surface with this normal, of unit length, not yet multiplied by the
    /// light's colour.
    #[inline]
    fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), true).diffuse
    }
    /// Returns the linear colour of the light.
    #[inline]
    fn color(&self) -> Rgb<S> {
        let [color, _] = self.colors();
        color
    }
    /// Returns the linear colours of the light: the diffuse and the specular colour.
    #[cfg_attr(not(feature = "arithmetic"), doc(hidden))]
    fn colors(&self) -> [Rgb<S>; 2];
    /// Computes the light at a surface whose specular lobe is of the type `H`.
    ///
    /// With `skips`, points that receive no light are rejected before the square root. The result
    /// is bit-identical with and without `skips`.
    #[cfg_attr(not(feature = "arithmetic"), doc(hidden))]
    fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance>;
    /// Evaluates the light at `N` surface points with the specular lobe `H`, each bit-identical to a single
    /// point. A lobe of [`NoSpecular`] leaves `arrivals.specular` unchanged.
    ///
    /// `f32` has no early-out, because a branch would prevent vector instructions. Nor has `Fx16` on processors with
    /// vector instructions, for spotlights with the inverse-square law whose falloff is a polynomial of `t` (if it is
    /// chosen at run time: soft, hard, linear, quadratic or cubic). Else fixed point computes the points one by
    /// one, and returns 0 for unreachable points before the square root.
    fn evaluate_each<H: SpecularLobe, const N: usize>(
        &self,
        surfaces: &SurfacePoints<'_, S, N>,
        highlight: &H::Constants<S>,
        arrivals: &mut Incident<[S::Irradiance; N]>,
    ) {
        let Incident { diffuse, specular } = arrivals;
        each::<S, H, Self, N>(self, surfaces, highlight, diffuse, specular);
    }
    /// Evaluates the light at `N` surface points in vectors. Returns `false`, and writes nothing, where the format,
    /// the light or the points do not have this.
    #[doc(hidden)]
    #[inline(always)]
    fn in_vectors<H: SpecularLobe, const N: usize>(
        &self,
        _surfaces: &SurfacePoints<'_, S, N>,
        _highlight: &H::Constants<S>,
        _arrivals: (&mut [S::Irradiance; N], &mut [S::Irradiance; N]),
    ) -> bool {
        false
    }
    /// Computes the irradiance at each of many surface points.
    ///
    /// Each result is bit-identical to a call of [`irradiance`](Self::irradiance). Points and normals are
    /// structures of arrays, one slice per component. The shortest slice determines the
    /// number of points; elements of `lights` beyond this number are not changed.
    fn irradiance_each(&self, points: Vec3<&[S::Length]>, normals: Vec3<&[S]>, lights: &mut [S::Irradiance]) {
        let count = points.x.len().min(points.y.len()).min(points.z.len()).min(lights.len());
        let count = normals.x.len().min(normals.y.len()).min(normals.z.len()).min(count);
        let (dark, views) = ([S::Irradiance::default(); BLOCK], [S::Unit::default(); BLOCK]);
        let mut arrivals = Incident { diffuse: dark, specular: dark };
        let blocks = lights.get_mut(..count).unwrap_or_default().chunks_mut(BLOCK);
        for (lights, first) in blocks.zip((0..).step_by(BLOCK)) {
            match (lights.first_chunk_mut(), block(points, first), block(normals, first)) {
                (Some(lights), Some(point), Some(normal)) => {
                    let surfaces = SurfacePoints { point, normal, view: Vec3::new(&views, &views, &views) };
                    self.evaluate_each::<NoSpecular, BLOCK>(&surfaces, &(), &mut arrivals);
                    *lights = arrivals.diffuse;
                }
                _ => {
                    for (i, arrived) in (first..).zip(lights) {
                        *arrived = self.irradiance(points.map(|c| nth(c, i)), normals.map(|c| nth(c, i)));
                    }
                }
            }
        }
    }
    /// Sets the irradiance at points of matte surfaces, that of [`irradiance`](Self::irradiance), from a point and a
    /// normal for each index.
    #[cfg_attr(not(feature = "arithmetic"), doc(hidden))]
    #[inline]
    fn fill<F: Points<S>>(
        &self,
        points: &F,
        normal: impl Fn(usize) -> Vec3<S>,
        arrived: &mut [S::Irradiance],
    ) {
        fill_each(self, points, normal, 0, arrived);
    }
    /// Returns `false` only if no point within `radius` of `center` receives light.
    fn can_reach(&self, _center: Vec3<S::Length>, _radius: S::Length) -> bool {
        true
    }
}

pub(crate) mod sealed {
    /// Keeps other crates from implementing [`LightModel`](super::LightModel).
    pub trait Sealed {}
}

/// Evaluates a light at each point. The outputs are separate arguments, so that the compiler
/// knows that the outputs do not alias the inputs.
#[inline(never)]
fn each<S: Scalar, H: SpecularLobe, L: LightModel<S>, const N: usize>(
    light: &L,
    surfaces: &SurfacePoints<'_, S, N>,
    highlight: &H::Constants<S>,
    diffuse: &mut [S::Irradiance; N],
    specular: &mut [S::Irradiance; N],
) {
    if light.in_vectors::<H, N>(surfaces, highlight, (&mut *diffuse, &mut *specular)) {
        return;
    }
    let (surfaces, highlight) = (*surfaces, *highlight);
    for i in 0..N {
        let arrival = light.evaluate::<H>(&surfaces.at(i), &highlight, S::SKIPS);
        diffuse[i] = arrival.diffuse;
        if H::SHINES {
            specular[i] = arrival.specular;
        }
    }
}

/// Evaluates a spotlight at many points in vectors by the offsets of an evaluation: see
/// [`in_vectors`](LightModel::in_vectors). `lamp` and the curve of its falloff are those of a spotlight with the
/// inverse-square law.
#[inline(always)]
fn spot_in_vectors<S: Scalar, O: Vectors<S>, P: Falloff, H: SpecularLobe, const N: usize>(
    (lamp, curve): (&Lamp<S>, P::Compiled<S>),
    surfaces: &SurfacePoints<'_, S, N>,
    highlight: &H::Constants<S>,
    arrivals: (&mut [S::Irradiance; N], &mut [S::Irradiance; N]),
) -> bool {
    let SurfacePoints { point, normal, view } = *surfaces;
    let lobe = |i: usize, incoming, cosine| {
        let (normal, view) = (normal.map(|c| nth(c, i)), view.map(|c| nth(c, i)));
        lobe::<S, H>(highlight, (normal, view), incoming, cosine)
    };
    if P::Compiled::<S>::IN_VECTORS {
        return O::in_vectors(lamp, point, normal, |t| curve.intensity(t), H::SHINES, lobe, arrivals);
    }
    if !O::HAS_ONE_CUBIC {
        match curve.as_square() {
            Some(Square::Soft) => {
                let soft = |t| CompiledFalloff::<S>::intensity(Soft, t);
                return O::in_vectors(lamp, point, normal, soft, H::SHINES, lobe, arrivals);
            }
            Some(Square::Hard) => {
                let hard = |t| CompiledFalloff::<S>::intensity(Hard, t);
                return O::in_vectors(lamp, point, normal, hard, H::SHINES, lobe, arrivals);
            }
            None => {}
        }
    }
    let Some([g, h]) = curve.as_cubic() else { return false };
    O::in_vectors(lamp, point, normal, |t| t.cubic(g, h), H::SHINES, lobe, arrivals)
}

/// Returns whether a spotlight may be evaluated in vectors by the offsets of an evaluation.
#[inline(always)]
fn has_vectors<S: Scalar, O: Vectors<S>, P: Falloff, A: Attenuation>(curve: P::Compiled<S>) -> bool {
    O::IS_VECTORISED && A::IS_INVERSE_SQUARE && (P::Compiled::<S>::IN_VECTORS || curve.as_cubic().is_some())
}

/// Sets the irradiance at points of matte surfaces from an index on, one by one.
#[inline(always)]
fn fill_each<S: Scalar, L: LightModel<S>, F: Points<S>>(
    light: &L,
    points: &F,
    normal: impl Fn(usize) -> Vec3<S>,
    first: usize,
    arrived: &mut [S::Irradiance],
) {
    for (i, arrived) in (first..).zip(arrived) {
        *arrived = light.irradiance(points.at(i), normal(i));
    }
}

/// Sets the irradiance at points of matte surfaces in vectors, in blocks of [`RUN`] points. `each` sets that of the
/// others: of part of the points, from an index on.
#[inline(always)]
fn fill_in_vectors<S: Scalar, L: LightModel<S>, F: Points<S>>(
    light: &L,
    points: &F,
    normal: impl Fn(usize) -> Vec3<S>,
    arrived: &mut [S::Irradiance],
    each: impl Fn(usize, &mut [S::Irradiance]),
) {
    for (part, first) in arrived.chunks_mut(RUN).zip((0..).step_by(RUN)) {
        let is_filled = part.first_chunk_mut().is_some_and(|whole| {
            let mut point = Vec3::default().map(|()| [S::Length::default(); RUN]);
            let mut normals = Vec3::default().map(|()| [S::ZERO; RUN]);
            for i in 0..RUN {
                let (at, facing) = (points.at(first + i), normal(first + i));
                (point.x[i], point.y[i], point.z[i]) = (at.x, at.y, at.z);
                (normals.x[i], normals.y[i], normals.z[i]) = (facing.x, facing.y, facing.z);
            }
            let views = [S::Unit::default(); RUN];
            let surfaces = SurfacePoints {
                point: Vec3::new(&point.x, &point.y, &point.z),
                normal: Vec3::new(&normals.x, &normals.y, &normals.z),
                view: Vec3::new(&views, &views, &views),
            };
            let mut dark = [S::Irradiance::default(); RUN];
            light.in_vectors::<NoSpecular, RUN>(&surfaces, &(), (whole, &mut dark))
        });
        if !is_filled {
            each(first, part);
        }
    }
}

/// Number of points of a row that are evaluated together: the smallest block of a [`Row`](crate::light::Row).
const RUN: usize = 16;

/// Number of points that a call with slices evaluates together.
const BLOCK: usize = 32;

/// Returns a whole block of three columns, from an index on.
#[inline]
fn block<T>(columns: Vec3<&[T]>, first: usize) -> Option<Vec3<&[T; BLOCK]>> {
    fn column<T>(column: &[T], first: usize) -> Option<&[T; BLOCK]> {
        column.get(first..)?.first_chunk()
    }
    Some(Vec3::new(column(columns.x, first)?, column(columns.y, first)?, column(columns.z, first)?))
}

/// Returns the specular lobe if the light hits the front of a surface, else zero.
#[inline]
fn lobe<S: Scalar, H: SpecularLobe>(
    highlight: &H::Constants<S>,
    (normal, view): (Vec3<S>, Vec3<S::Unit>),
    incoming: Vec3<S::Unit>,
    cosine: S,
) -> S {
    if !H::SHINES {
        return S::ZERO;
    }
    let lobe = H::lobe(highlight, incoming, normal, view);
    if cosine > S::ZERO { lobe } else { S::ZERO }
}

/// Returns whether a cone with this position, axis and bound of the test for points outside may reach a
/// sphere.
fn reaches<S: Scalar>(
    position: Vec3<S::Length>,
    (axis, outside): (Vec3<S::Unit>, S),
    center: Vec3<S::Length>,
    radius: S::Length,
) -> bool {
    let tip = S::moved_back(position, axis, outside, radius);
    tip.is_none_or(|tip| !S::Offset::between(tip, center).is_center_outside(axis, outside))
}

/// What a light emits in a direction, as a share of its intensity.
trait Angular<S: Scalar>: Copy {
    /// Returns the share along a ray; `None` for a light that emits the same in all directions.
    fn along<R: Directed<S>>(self, ray: &R) -> Option<R::Share>;
}

impl<S: Scalar> Angular<S> for () {
    #[inline(always)]
    fn along<R: Directed<S>>(self, _: &R) -> Option<R::Share> {
        None
    }
}

/// A compiled cone and its axis.
impl<S: Scalar, P: Falloff> Angular<S> for (&CompiledCone<S, P>, Vec3<S::Unit>) {
    #[inline(always)]
    fn along<R: Directed<S>>(self, ray: &R) -> Option<R::Share> {
        let (cone, axis) = self;
        Some(cone.at_ray(ray, axis))
    }
}

/// The frame of a measured light and its distribution.
impl<S: Scalar> Angular<S> for (&[Vec3<S::Unit>; 3], Distribution<'_>) {
    #[inline(always)]
    fn along<R: Directed<S>>(self, ray: &R) -> Option<R::Share> {
        let (frame, distribution) = self;
        Some(ray.distributed(frame, distribution))
    }
}

/// Returns the light at a point near a bright light, or in a steep cone, by the fine evaluation.
///
/// Where the coarse evaluation shows that the light is clipped to full scale in any case, its light
/// is returned.
#[inline(always)]
fn evaluate_finely<S: Scalar, B: Angular<S>, A: Attenuation, H: SpecularLobe>(
    (attenuation, intensity, fine_below): (&A::Constants<S>, S::Gain, u32),
    angular: B,
    (offset, facing): (&S::Offset, <S::Offset as Offset<S>>::Facing),
    (normal, view): (Vec3<S>, Vec3<S::Unit>),
    highlight: &H::Constants<S>,
) -> Incident<S::Irradiance> {
    let is_always_fine = fine_below == u32::MAX;
    let (mut lobe, mut coarse, mut keeps) = (S::ZERO, Incident::default(), [false; 2]);
    if H::SHINES || !is_always_fine {
        let ray = offset.ray();
        let cosine = ray.cosine(facing, normal);
        lobe = self::lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.value().scalar());
        let (shares, light) =
            along_ray::<S, B, A, H, _>((attenuation, intensity), angular, (offset, &ray), cosine, lobe);
        let is_enough = |share, light| {
            !is_always_fine && S::is_clipped(A::windowed(attenuation, offset, &ray, share).scalar(), light)
        };
        keeps = [
            is_enough(shares.diffuse, light.diffuse),
            lobe == S::ZERO || is_enough(shares.specular, light.specular),
        ];
        coarse = light;
        if keeps == [true; 2] {
            return light;
        }
    }
    // The specular lobe stays that of the coarse direction: rounding the lobe to a scalar causes a
    // larger error than a finer direction would remove.
    let ray = S::fine_ray(offset);
    let cosine = ray.cosine(facing, normal);
    let (_, fine) =
        along_ray::<S, B, A, H, _>((attenuation, intensity), angular, (offset, &ray), cosine, lobe);
    let [keeps_diffuse, keeps_specular] = keeps;
    Incident {
        diffuse: if keeps_diffuse { coarse.diffuse } else { fine.diffuse },
        specular: if keeps_specular { coarse.specular } else { fine.specular },
    }
}

/// Returns the light that a surface receives which faces the light: the product of intensity, what the light emits in
/// this direction and attenuation.
#[inline(always)]
fn light_facing<S: Scalar, B: Angular<S>, A: Attenuation>(
    (attenuation, intensity, fine_below): (&A::Constants<S>, S::Gain, u32),
    angular: B,
    offset: &S::Offset,
) -> S::Irradiance {
    if offset.is_near(fine_below) {
        // The coarse early-out of the range has fewer bits than the fine evaluation.
        let ray = S::fine_ray(offset);
        let share = angular.along(&ray).unwrap_or_else(|| ray.whole());
        return A::light(attenuation, offset, &ray, share, intensity);
    }
    if A::is_beyond::<S, _>(attenuation, offset) {
        return S::Irradiance::default();
    }
    let ray = offset.ray();
    let share = angular.along(&ray).unwrap_or_else(|| ray.whole());
    A::light(attenuation, offset, &ray, share, intensity)
}

/// Returns the light along a ray: as shares of the intensity, and as irradiances.
#[inline(always)] // `lit-table` on Cortex-M0: +29 instructions without.
fn along_ray<S: Scalar, B: Angular<S>, A: Attenuation, H: SpecularLobe, R: Directed<S>>(
    (attenuation, intensity): (&A::Constants<S>, S::Gain),
    angular: B,
    (offset, ray): (&S::Offset, &R),
    cosine: R::Fraction,
    lobe: S,
) -> (Incident<R::Share>, Incident<S::Irradiance>) {
    let light = |share| A::light(attenuation, offset, ray, share, intensity);
    let falloff = angular.along(ray);
    let share = falloff.map_or(cosine.value(), |falloff| cosine.times_value(falloff));
    let diffuse = Incident { diffuse: share, specular: R::Share::default() };
    let lit = Incident { diffuse: light(share), specular: S::Irradiance::default() };
    if !H::SHINES {
        return (diffuse, lit);
    }
    let lobe = R::Share::of_scalar(lobe);
    let share = falloff.map_or(lobe, |falloff| falloff.times(lobe));
    (Incident { specular: share, ..diffuse }, Incident { specular: light(share), ..lit })
}
