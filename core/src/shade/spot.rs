//! Spotlights, compiled.

use super::{Arrival, Light, Surface, lobe};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    cone::Falloff,
    profile::{Edge, Profile},
    scalar::{Fraction, Offset, Ray, Scalar, Share},
    specular::{Matte, Specular},
    vec3::Vec3,
};

/// A spotlight compiled for the format `S`. Made by [`Spot::compile`](crate::Spot::compile).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledSpot<S: Scalar, P: Profile = Edge, A: Attenuation = InverseSquare> {
    pub(crate) position: Vec3<S::Length>,
    pub(crate) axis: Vec3<S::Unit>,
    pub(crate) falloff: Falloff<S, P>,
    pub(crate) outside: S,
    pub(crate) attenuation: A::Constants<S>,
    pub(crate) intensity: S::Gain,
    pub(crate) fine_below: u32,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<S: Scalar, P: Profile, A: Attenuation> CompiledSpot<S, P, A> {
    /// The light of these parts, as [`source`](crate::source) writes them: `outside` is the bound by which points outside
    /// the cone are rejected, `fine_below` that of [`Scalar::fine_below`], and the colours are the diffuse and the specular
    /// one.
    #[expect(clippy::too_many_arguments, reason = "generated source names each part of a light once")]
    pub const fn from_parts(
        position: Vec3<S::Length>,
        axis: Vec3<S::Unit>,
        falloff: Falloff<S, P>,
        outside: S,
        attenuation: A::Constants<S>,
        intensity: S::Gain,
        fine_below: u32,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self { position, axis, falloff, outside, attenuation, intensity, fine_below, color, specular_color }
    }

    /// The light that arrives at a surface point, before the colours: falloff, distance and Lambert's cosine. 1 is
    /// full scale; the unit of `point` is that of the light's position, `normal` has unit length.
    ///
    /// No root is paid for a surface that faces away, or for a point that is clearly outside the cone or beyond the
    /// range; what is skipped is exactly zero, so the answer has the bits of
    /// [`irradiance_unskipped`](Self::irradiance_unskipped).
    #[inline(always)]
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.arrive::<Matte>(&Surface::matte(point, normal), &(), true).diffuse
    }

    /// As [`irradiance`](Self::irradiance), with every step done for every point: the form without branches, which
    /// compilers turn into vector instructions.
    #[inline(always)]
    pub fn irradiance_unskipped(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.arrive::<Matte>(&Surface::matte(point, normal), &(), false).diffuse
    }

    /// The falloff of the cone alone at a point: in [0, 1].
    #[inline(always)]
    pub fn falloff(&self, point: Vec3<S::Length>) -> S {
        let offset = S::offset(self.position, point);
        if offset.is_below(self.fine_below) {
            return self.falloff.toward(&offset.fine_ray(), self.axis).rounded();
        }
        self.falloff.toward(&offset.ray(), self.axis)
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
        let falloff = self.falloff.toward(ray, self.axis);
        let expose = |share| A::expose(&self.attenuation, offset, ray, share, self.intensity);
        let diffuse = expose(cosine.of(falloff));
        if !H::SHINES {
            return Arrival { diffuse, specular: S::Irradiance::default() };
        }
        let lobe = lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.scalar().rounded());
        Arrival { diffuse, specular: expose(falloff.share_of(R::Share::of_scalar(lobe))) }
    }

    /// The share of the intensity that falls on the surface, and its light.
    #[inline(always)]
    fn diffuse<R: Ray<S>>(
        &self,
        offset: &S::Offset,
        ray: &R,
        cosine: R::Fraction,
    ) -> (R::Share, S::Irradiance) {
        let share = cosine.of(self.falloff.toward(ray, self.axis));
        (share, A::expose(&self.attenuation, offset, ray, share, self.intensity))
    }

    /// What arrives at a point that is near, or of a cone that is steep: with all bits that the format can give, but where they
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
        if S::Offset::faces_far_away(facing) || offset.is_outside(self.axis, self.outside) {
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

    /// The light's linear colour.
    pub fn color(&self) -> Rgb<S> {
        self.color
    }

    /// The linear colour of the light's highlights.
    pub fn specular_color(&self) -> Rgb<S> {
        self.specular_color
    }

    /// The edge profile of the cone.
    pub fn profile(&self) -> P {
        self.falloff.profile()
    }

    /// The same light with another type of profile: what turns a choice made at run time into a type, once per
    /// light and not once per point.
    pub fn with_profile<Q: Profile>(&self, profile: Q) -> CompiledSpot<S, Q, A> {
        CompiledSpot {
            position: self.position,
            axis: self.axis,
            falloff: self.falloff.with_profile(profile),
            outside: self.outside,
            attenuation: self.attenuation,
            intensity: self.intensity,
            fine_below: self.fine_below,
            color: self.color,
            specular_color: self.specular_color,
        }
    }
}

impl<S: Scalar, P: Profile, A: Attenuation> Light<S> for CompiledSpot<S, P, A> {
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
        if skips
            && (S::Offset::faces_away(facing)
                || offset.is_outside(self.axis, self.outside)
                || A::is_beyond::<S>(&self.attenuation, &offset))
        {
            return Arrival::default();
        }
        let ray = offset.ray();
        let cosine = ray.cosine(facing, normal);
        self.along::<H, _>(&offset, &ray, cosine, (normal, view), highlight)
    }
}
