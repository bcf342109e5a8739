//! Spotlights, compiled for the quick evaluation.

use core::ops::Range;

use super::{
    Incident, LightModel, fill_in_vectors, has_vectors, lobe, reaches, sealed::Sealed, spot_in_vectors,
};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    cone::CompiledCone,
    falloff::{Falloff, Soft},
    number::{Fraction, Lamp, Offset, OffsetAlong, Quick, Ray, Share},
    points::{Points, SurfacePoint, SurfacePoints},
    specular::{NoSpecular, SpecularLobe},
    vec3::Vec3,
};

/// A spotlight compiled for the quick evaluation of the format `S`.
///
/// This light takes fewer instructions per point than a
/// [`CompiledSpotLight`](super::CompiledSpotLight) and has a larger error.
///
/// Made by [`SpotLight::compile_quick`](crate::SpotLight::compile_quick);
/// [`SpotLight::quick_error_bound`](crate::SpotLight::quick_error_bound) bounds the error. Points, normals and
/// irradiances have the types of the format's standard evaluation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct QuickSpotLight<S: Quick, P: Falloff = Soft, A: Attenuation = InverseSquare> {
    pub(crate) position: Vec3<S::Length>,
    /// The axis as `Quick::quick_axis` returns it.
    pub(crate) axis: Vec3<S::Unit>,
    pub(crate) cone: CompiledCone<S, P>,
    /// The bound of the test for spheres outside the cone.
    pub(crate) outside: S,
    pub(crate) attenuation: A::Constants<S>,
    pub(crate) intensity: S::Gain,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<S: Quick, P: Falloff, A: Attenuation> QuickSpotLight<S, P, A> {
    /// Returns the irradiance at a surface point, not yet multiplied by the colours; 1 is full
    /// scale.
    ///
    /// The irradiance is the product of intensity, falloff, attenuation and Lambert's cosine.
    /// `point` is in the unit of the light's position; `normal` has unit length. A surface that
    /// faces away is rejected before the square root.
    #[inline]
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), true).diffuse
    }

    /// Returns the irradiance of a surface that faces the light at a point, like
    /// [`CompiledSpotLight::irradiance_facing`](super::CompiledSpotLight::irradiance_facing).
    #[inline]
    pub fn irradiance_facing(&self, point: Vec3<S::Length>) -> S::Irradiance {
        let offset = S::QuickOffset::between(self.position, point);
        if A::is_beyond::<S, _>(&self.attenuation, &offset) {
            return S::Irradiance::default();
        }
        let ray = offset.ray();
        let falloff = self.cone.at_ray(&ray, self.axis);
        if falloff == Share::of_scalar(S::ZERO) {
            return S::Irradiance::default();
        }
        A::light::<S, _, _>(&self.attenuation, &offset, &ray, falloff, self.intensity)
    }

    /// Returns `false` only if no point within `radius` of `center` receives light, like
    /// [`CompiledSpotLight::can_reach`](super::CompiledSpotLight::can_reach).
    pub fn can_reach(&self, center: Vec3<S::Length>, radius: S::Length) -> bool {
        LightModel::can_reach(self, center, radius)
    }

    /// Returns the same light at another position, with another axis of unit length.
    ///
    /// An axis in the format is that of a light of the standard evaluation:
    /// [`CompiledSpotLight::axis`](super::CompiledSpotLight::axis).
    #[must_use]
    pub fn placed(self, position: Vec3<S::Length>, axis: Vec3<S::Unit>) -> Self {
        Self { position, axis: S::quick_axis(axis), ..self }
    }

    /// Returns the falloff of the cone.
    pub fn falloff(&self) -> P {
        self.cone.falloff
    }

    /// Creates a light from its fields, as [`codegen`](crate::codegen) writes them.
    ///
    /// The colours are the diffuse and the specular colour.
    pub const fn from_parts(
        position: Vec3<S::Length>,
        axis: Vec3<S::Unit>,
        cone: CompiledCone<S, P>,
        outside: S,
        attenuation: A::Constants<S>,
        intensity: S::Gain,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self { position, axis, cone, outside, attenuation, intensity, color, specular_color }
    }
}

impl<S: Quick, P: Falloff, A: Attenuation> Sealed for QuickSpotLight<S, P, A> {}

impl<S: Quick, P: Falloff, A: Attenuation> LightModel<S> for QuickSpotLight<S, P, A> {
    #[inline]
    fn colors(&self) -> [Rgb<S>; 2] {
        [self.color, self.specular_color]
    }

    #[inline]
    fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance> {
        let offset = S::QuickOffset::between(self.position, surface.point);
        self.at::<H>(&offset, (surface.normal, surface.view), highlight, skips)
    }

    #[inline(always)]
    fn fill<F: Points<S>>(
        &self,
        points: &F,
        normal: impl Fn(usize) -> Vec3<S>,
        arrived: &mut [S::Irradiance],
    ) {
        if has_vectors::<S, S::QuickOffset, P, A>(self.cone.curve) {
            fill_in_vectors(self, points, &normal, arrived, |first, arrived| {
                self.fill_from(first, points, &normal, arrived);
            });
        } else {
            self.fill_from(0, points, normal, arrived);
        }
    }

    #[inline(always)]
    fn in_vectors<H: SpecularLobe, const N: usize>(
        &self,
        surfaces: &SurfacePoints<'_, S, N>,
        highlight: &H::Constants<S>,
        arrivals: (&mut [S::Irradiance; N], &mut [S::Irradiance; N]),
    ) -> bool {
        let lamp = Lamp {
            position: self.position,
            axis: self.axis,
            ramp: self.cone.ramp,
            intensity: self.intensity,
            fine_below: 0,
        };
        let light = (&lamp, self.cone.curve);
        A::IS_INVERSE_SQUARE
            && spot_in_vectors::<S, S::QuickOffset, P, H, N>(light, surfaces, highlight, arrivals)
    }

    fn can_reach(&self, center: Vec3<S::Length>, radius: S::Length) -> bool {
        reaches::<S>(self.position, (S::standard_axis(self.axis), self.outside), center, radius)
    }
}

impl<S: Quick, P: Falloff, A: Attenuation> QuickSpotLight<S, P, A> {
    /// Sets the irradiance at points from an index on, one by one.
    ///
    /// The points of a stretch share most of the computation of their offsets. In the inner loop that part, and
    /// what the evaluation computes of it, is constant.
    #[inline(always)]
    fn fill_from<F: Points<S>>(
        &self,
        mut start: usize,
        points: &F,
        normal: impl Fn(usize) -> Vec3<S>,
        mut arrived: &mut [S::Irradiance],
    ) {
        let light = |offset: &S::QuickOffset, normal| {
            self.at::<NoSpecular>(offset, (normal, Vec3::default()), &(), true).diffuse
        };
        let single = |i| light(&S::QuickOffset::between(self.position, points.at(i)), normal(i));
        if !F::ALONG_X {
            return (start..).zip(arrived).for_each(|(i, to)| *to = single(i));
        }
        let x = |i: usize| points.at(i).x;
        while !arrived.is_empty() {
            let stretch = S::QuickOffset::stretch(self.position, points.at(start));
            let end = start + arrived.len();
            let count = first_not(start..end, |i| S::QuickOffset::is_in(&stretch, x(i))) - start;
            let Some((part, rest)) = arrived.split_at_mut_checked(count.max(1)) else { return };
            if count == 0 {
                part.fill_with(|| single(start));
            } else {
                for (i, to) in (start..).zip(part.iter_mut()) {
                    *to = light(&S::QuickOffset::on_stretch(&stretch, x(i)), normal(i));
                }
            }
            start += part.len();
            arrived = rest;
        }
    }

    /// Computes the light at an offset.
    #[inline(always)]
    fn at<H: SpecularLobe>(
        &self,
        offset: &S::QuickOffset,
        (normal, view): (Vec3<S>, Vec3<S::Unit>),
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance> {
        let facing = offset.facing(normal);
        if skips && (S::QuickOffset::faces_away(facing) || A::is_beyond::<S, _>(&self.attenuation, offset)) {
            return Incident::default();
        }
        let ray = offset.ray();
        let falloff = self.cone.at_ray(&ray, self.axis);
        if skips && falloff == Share::of_scalar(S::ZERO) {
            return Incident::default();
        }
        let cosine = ray.cosine(facing, normal);
        let light = |share| A::light::<S, _, _>(&self.attenuation, offset, &ray, share, self.intensity);
        let diffuse = light(cosine.times_value(falloff));
        if !H::SHINES {
            return Incident { diffuse, ..Incident::default() };
        }
        let lobe = lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.value().scalar());
        Incident { diffuse, specular: light(falloff.times(Share::of_scalar(lobe))) }
    }
}

/// Returns the first index of a range for which a test fails, or the end of the range. The test fails for all
/// that follow.
fn first_not(Range { mut start, mut end }: Range<usize>, holds: impl Fn(usize) -> bool) -> usize {
    // The last one first: most stretches are whole.
    let mut middle = end.saturating_sub(1);
    while start < end {
        if holds(middle) {
            start = middle + 1;
        } else {
            end = middle;
        }
        middle = start.midpoint(end);
    }
    start
}
