//! Point lights, compiled.

use super::{Arrival, Light, Surface, lobe};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    scalar::{Fraction, Offset, Ray, Scalar},
    specular::{Matte, Specular},
    vec3::Vec3,
};

/// A point light compiled for the format `S`. Made by [`Point::compile`](crate::Point::compile).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledPoint<S: Scalar, A: Attenuation = InverseSquare> {
    pub(crate) position: Vec3<S::Length>,
    pub(crate) attenuation: A::Constants<S>,
    pub(crate) intensity: S::Gain,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<S: Scalar, A: Attenuation> CompiledPoint<S, A> {
    /// The light of these parts, as [`source`](crate::source) writes them: the colours are the diffuse and the specular
    /// one.
    pub const fn from_parts(
        position: Vec3<S::Length>,
        attenuation: A::Constants<S>,
        intensity: S::Gain,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self { position, attenuation, intensity, color, specular_color }
    }

    /// The light that arrives at a surface point, before the colours: distance and Lambert's cosine. Skips what is
    /// exactly zero, as [`CompiledSpot::irradiance`](crate::CompiledSpot::irradiance) does.
    #[inline(always)]
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.arrive::<Matte>(&Surface::matte(point, normal), &(), true).diffuse
    }

    /// As [`irradiance`](Self::irradiance), with every step done for every point.
    #[inline(always)]
    pub fn irradiance_unskipped(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.arrive::<Matte>(&Surface::matte(point, normal), &(), false).diffuse
    }
}

impl<S: Scalar, A: Attenuation> Light<S> for CompiledPoint<S, A> {
    fn color(&self) -> Rgb<S> {
        self.color
    }

    fn specular_color(&self) -> Rgb<S> {
        self.specular_color
    }

    #[inline(always)]
    fn arrive<H: Specular>(
        &self,
        surface: &Surface<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Arrival<S::Irradiance> {
        let offset = S::offset(self.position, surface.point);
        let facing = offset.facing(surface.normal);
        if skips && (S::Offset::faces_away(facing) || A::is_beyond::<S>(&self.attenuation, &offset)) {
            return Arrival::default();
        }
        let ray = offset.ray();
        let cosine = ray.cosine(facing).scalar();
        let expose = |fraction| A::expose(&self.attenuation, &offset, &ray, fraction, self.intensity);
        let diffuse = expose(cosine);
        if !H::SHINES {
            return Arrival { diffuse, specular: S::Irradiance::default() };
        }
        let lobe = lobe::<S, H>(highlight, surface, ray.direction(), cosine);
        Arrival { diffuse, specular: expose(lobe) }
    }
}
