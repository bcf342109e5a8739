//! Measured lights, compiled.

use super::{Incident, LightModel, light_facing, lobe, reaches, sealed::Sealed};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    distribution::Distribution,
    number::{Directed, Fraction, Offset, Ray, Scalar, Share},
    points::SurfacePoint,
    specular::{NoSpecular, SpecularLobe},
    vec3::Vec3,
};

/// A measured light compiled for the format `S`. Made by
/// [`MeasuredLight::compile`](crate::MeasuredLight::compile). It borrows the samples of its distribution, which may be in
/// flash memory.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledMeasuredLight<'a, S: Scalar, A: Attenuation = InverseSquare> {
    pub(crate) position: Vec3<S::Length>,
    /// The side, the front and the axis.
    pub(crate) frame: [Vec3<S::Unit>; 3],
    pub(crate) distribution: Distribution<'a>,
    pub(crate) outside: S,
    pub(crate) attenuation: A::Constants<S>,
    pub(crate) intensity: S::Gain,
    pub(crate) fine_below: u32,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<'a, S: Scalar, A: Attenuation> CompiledMeasuredLight<'a, S, A> {
    /// Returns the irradiance at a surface point, not yet multiplied by the colours; 1 is full
    /// scale.
    ///
    /// The irradiance is the product of intensity, distribution, attenuation and Lambert's cosine.
    ///
    /// Points with exactly zero light are rejected before the square root, as by
    /// [`CompiledSpotLight::irradiance`](crate::light::CompiledSpotLight::irradiance): those of surfaces that face away, those
    /// beyond the range, and for a light within a right angle of its axis those clearly outside.
    #[inline]
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), true).diffuse
    }

    /// Returns the result of [`irradiance`](Self::irradiance), but without early-outs.
    #[inline]
    pub fn irradiance_unskipped(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), false).diffuse
    }

    /// Returns the irradiance of a surface that faces the light at a point, not yet multiplied by the colours: see
    /// [`CompiledSpotLight::irradiance_facing`](crate::light::CompiledSpotLight::irradiance_facing).
    #[inline]
    pub fn irradiance_facing(&self, point: Vec3<S::Length>) -> S::Irradiance {
        let offset = S::Offset::between(self.position, point);
        if offset.is_outside(self.frame[2], self.outside) {
            return S::Irradiance::default();
        }
        let light = (&self.attenuation, self.intensity, self.fine_below);
        light_facing::<S, _, A>(light, (&self.frame, self.distribution), &offset)
    }

    /// Returns `false` only if no point within `radius` of `center` receives light: see
    /// [`CompiledSpotLight::can_reach`](crate::light::CompiledSpotLight::can_reach). Every sphere may be reached by a light
    /// at a right angle to its axis or behind.
    pub fn can_reach(&self, center: Vec3<S::Length>, radius: S::Length) -> bool {
        LightModel::can_reach(self, center, radius)
    }

    /// Returns whether the evaluation at a point is fine: see
    /// [`CompiledSpotLight::is_fine`](crate::light::CompiledSpotLight::is_fine).
    #[cfg(feature = "arithmetic")]
    pub fn is_fine(&self, point: Vec3<S::Length>) -> bool {
        S::Offset::between(self.position, point).is_near(self.fine_below)
    }

    /// Returns the position of the light.
    pub fn position(&self) -> Vec3<S::Length> {
        self.position
    }

    /// Returns the side, the front and the axis, of unit length.
    pub fn frame(&self) -> [Vec3<S::Unit>; 3] {
        self.frame
    }

    /// Returns the distribution.
    pub fn distribution(&self) -> Distribution<'a> {
        self.distribution
    }

    /// Creates a light from its fields, as [`codegen`](crate::codegen) writes them.
    ///
    /// The frame is the side, the front and the axis; `outside` is the bound for rejecting points outside the light, and
    /// `fine_below` is the result of `Errors::fine_below`; the colours are the diffuse and the specular colour.
    #[expect(clippy::too_many_arguments, reason = "generated source names each part of a light once")]
    pub const fn from_parts(
        position: Vec3<S::Length>,
        frame: [Vec3<S::Unit>; 3],
        distribution: Distribution<'a>,
        outside: S,
        attenuation: A::Constants<S>,
        intensity: S::Gain,
        fine_below: u32,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self {
            position,
            frame,
            distribution,
            outside,
            attenuation,
            intensity,
            fine_below,
            color,
            specular_color,
        }
    }
}

impl<S: Scalar, A: Attenuation> Sealed for CompiledMeasuredLight<'_, S, A> {}

impl<S: Scalar, A: Attenuation> LightModel<S> for CompiledMeasuredLight<'_, S, A> {
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
        let SurfacePoint { point, normal, view } = *surface;
        let Self { position, frame, distribution, outside, ref attenuation, intensity, .. } = *self;
        let offset = S::Offset::between(position, point);
        if offset.is_near(self.fine_below) {
            return self.evaluate_finely::<H>(offset, (normal, view), highlight);
        }
        let facing = offset.facing(normal);
        if skips
            && (S::Offset::faces_away(facing)
                || offset.is_outside(frame[2], outside)
                || A::is_beyond::<S, _>(attenuation, &offset))
        {
            return Incident::default();
        }
        let ray = offset.ray();
        let cosine = ray.cosine(facing, normal);
        let share = ray.distributed(&frame, distribution);
        let light = |share| A::light(attenuation, &offset, &ray, share, intensity);
        let diffuse = light(cosine.times_value(share));
        if !H::SHINES {
            return Incident { diffuse, ..Incident::default() };
        }
        let lobe = lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.value().scalar());
        Incident { diffuse, specular: light(share.times(Share::of_scalar(lobe))) }
    }

    fn can_reach(&self, center: Vec3<S::Length>, radius: S::Length) -> bool {
        reaches::<S>(self.position, (self.frame[2], self.outside), center, radius)
    }
}

impl<S: Scalar, A: Attenuation> CompiledMeasuredLight<'_, S, A> {
    /// Evaluates a point near the light, or of a steep distribution: see `CompiledSpotLight::evaluate_finely`.
    #[cold]
    #[inline(never)]
    fn evaluate_finely<H: SpecularLobe>(
        &self,
        offset: S::Offset,
        (normal, view): (Vec3<S>, Vec3<S::Unit>),
        highlight: &H::Constants<S>,
    ) -> Incident<S::Irradiance> {
        let facing = offset.facing(normal);
        if S::Offset::faces_far_away(facing) || offset.is_outside(self.frame[2], self.outside) {
            return Incident::default();
        }
        let light = (&self.attenuation, self.intensity, self.fine_below);
        let angular = (&self.frame, self.distribution);
        super::evaluate_finely::<S, _, A, H>(light, angular, (&offset, facing), (normal, view), highlight)
    }
}
