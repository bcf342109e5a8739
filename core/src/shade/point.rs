//! Point lights, compiled.

use super::{Arrival, Light, Surface, lobe};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    scalar::{Fraction, Offset, Ray, Scalar, Share},
    specular::{Matte, Specular},
    vec3::Vec3,
};

/// A point light compiled for the format `S`. Made by [`Point::compile`](crate::Point::compile).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledPoint<S: Scalar, A: Attenuation = InverseSquare> {
    pub(crate) position: Vec3<S::Length>,
    pub(crate) attenuation: A::Constants<S>,
    pub(crate) intensity: S::Gain,
    pub(crate) fine_below: u32,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<S: Scalar, A: Attenuation> CompiledPoint<S, A> {
    /// The light of these parts, as [`source`](crate::source) writes them: `fine_below` is that of [`Scalar::fine_below`], and
    /// the colours are the diffuse and the specular one.
    pub const fn from_parts(
        position: Vec3<S::Length>,
        attenuation: A::Constants<S>,
        intensity: S::Gain,
        fine_below: u32,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self { position, attenuation, intensity, fine_below, color, specular_color }
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

    /// What arrives along a ray.
    #[inline(always)]
    fn along<H: Specular, R: Ray<S>>(
        &self,
        offset: &S::Offset,
        ray: &R,
        cosine: R::Fraction,
        (normal, view): (Vec3<S>, Vec3<S::Unit>),
        highlight: &H::Constants<S>,
    ) -> Arrival<S::Irradiance> {
        let cosine = cosine.scalar();
        let expose = |share| A::expose(&self.attenuation, offset, ray, share, self.intensity);
        let diffuse = expose(cosine);
        if !H::SHINES {
            return Arrival { diffuse, specular: S::Irradiance::default() };
        }
        let lobe = lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.rounded());
        Arrival { diffuse, specular: expose(R::Share::of_scalar(lobe)) }
    }

    /// The share of the intensity that falls on the surface, and its light.
    #[inline(always)]
    fn diffuse<R: Ray<S>>(
        &self,
        offset: &S::Offset,
        ray: &R,
        cosine: R::Fraction,
    ) -> (R::Share, S::Irradiance) {
        let share = cosine.scalar();
        (share, A::expose(&self.attenuation, offset, ray, share, self.intensity))
    }

    /// What arrives at a point that is near: with all bits that the format can give, but where they
    /// would show nothing. Apart from the rest, which is to stay in registers.
    #[cold]
    #[inline(never)]
    fn arrive_finely<H: Specular>(
        &self,
        offset: S::Offset,
        (normal, view): (Vec3<S>, Vec3<S::Unit>),
        highlight: &H::Constants<S>,
    ) -> Arrival<S::Irradiance> {
        let facing = offset.facing(normal);
        if S::Offset::faces_far_away(facing) {
            return Arrival::default();
        }
        let ray = offset.ray();
        let (share, light) = self.diffuse(&offset, &ray, ray.cosine(facing, normal));
        let has_window = !A::is_inverse_square::<S>(&self.attenuation);
        let is_enough = self.fine_below < u32::MAX && S::is_enough(share, light, has_window);
        if is_enough && !H::SHINES {
            return Arrival { diffuse: light, specular: S::Irradiance::default() };
        }
        let ray = offset.fine_ray();
        let cosine = ray.cosine(facing, normal);
        let arrival = self.along::<H, _>(&offset, &ray, cosine, (normal, view), highlight);
        // With a highlight or without, the diffuse light is the same.
        if is_enough { Arrival { diffuse: light, ..arrival } } else { arrival }
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
        let Surface { point, normal, view } = *surface;
        let offset = S::offset(self.position, point);
        if offset.is_below(self.fine_below) {
            return self.arrive_finely::<H>(offset, (normal, view), highlight);
        }
        let facing = offset.facing(normal);
        if skips && (S::Offset::faces_away(facing) || A::is_beyond::<S>(&self.attenuation, &offset)) {
            return Arrival::default();
        }
        let ray = offset.ray();
        let cosine = ray.cosine(facing, normal);
        self.along::<H, _>(&offset, &ray, cosine, (normal, view), highlight)
    }
}
