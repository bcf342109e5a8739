//! Lights with a position: the common part of spotlights and point lights.

use super::{Incident, SurfacePoint, lobe};
use crate::{
    attenuation::Attenuation,
    number::{Fraction, FullOffset, Offset, Ray, Scalar, Share},
    specular::SpecularLobe,
    vec3::Vec3,
};

/// The position of a light, its attenuation and its intensity.
#[derive(Clone, Copy)]
pub(super) struct Stand<'a, S: Scalar, A: Attenuation> {
    pub(super) position: Vec3<S::Length>,
    pub(super) attenuation: &'a A::Constants<S>,
    pub(super) intensity: S::Gain,
    pub(super) fine_below: u32,
}

/// A compiled light with a position.
pub(super) trait Placed<S: Scalar, A: Attenuation> {
    /// Returns the position, the attenuation and the intensity.
    fn place(&self) -> Stand<'_, S, A>;
    /// Returns whether a point is certainly outside the cone: see [`FullOffset::is_outside`].
    fn is_outside(&self, offset: &S::Offset) -> bool;
    /// Returns the falloff of the cone along a ray; `None` for a light without a cone.
    fn falloff<R: Ray<S>>(&self, ray: &R) -> Option<R::Share>;

    /// Returns the light that arrives at a surface: see
    /// [`LightModel::evaluate`](super::LightModel::evaluate).
    #[inline(always)] // `spot-soft-lambert-shadow` on Cortex-M0: +53 instructions without.
    fn evaluate_at<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance> {
        let SurfacePoint { point, normal, view } = *surface;
        let Stand { position, attenuation, fine_below, .. } = self.place();
        let offset = S::offset(position, point);
        if offset.is_near(fine_below) {
            return self.evaluate_finely::<H>(offset, (normal, view), highlight);
        }
        let facing = offset.facing(normal);
        if skips
            && (S::Offset::faces_away(facing)
                || self.is_outside(&offset)
                || A::is_beyond::<S, _>(attenuation, &offset))
        {
            return Incident::default();
        }
        let ray = offset.ray();
        let cosine = ray.cosine(facing, normal);
        let lobe = || lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.scalar().rounded());
        self.along::<H, _>(&offset, &ray, cosine, lobe).1
    }

    /// Evaluates a point near a bright light, or in a steep cone, with the fine evaluation.
    ///
    /// Where the light is clipped to full scale in any case, the result of the coarse evaluation is returned. The function is
    /// separate and cold, so that the common path stays in registers.
    #[cold]
    #[inline(never)]
    fn evaluate_finely<H: SpecularLobe>(
        &self,
        offset: S::Offset,
        (normal, view): (Vec3<S>, Vec3<S::Unit>),
        highlight: &H::Constants<S>,
    ) -> Incident<S::Irradiance> {
        let facing = offset.facing(normal);
        if S::Offset::faces_far_away(facing) || self.is_outside(&offset) {
            return Incident::default();
        }
        let Stand { attenuation, fine_below, .. } = self.place();
        let is_always_fine = fine_below == u32::MAX;
        let (mut lobe, mut coarse, mut keeps) = (S::ZERO, Incident::default(), [false; 2]);
        if H::SHINES || !is_always_fine {
            let ray = offset.ray();
            let cosine = ray.cosine(facing, normal);
            lobe = super::lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.scalar().rounded());
            let (shares, light) = self.along::<H, _>(&offset, &ray, cosine, || lobe);
            let is_enough = |share, light| {
                !is_always_fine
                    && S::is_clipped(A::windowed(attenuation, &offset, &ray, share).rounded(), light)
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
        let ray = offset.fine_ray();
        let cosine = ray.cosine(facing, normal);
        // The specular lobe stays that of the coarse direction: rounding the lobe to a scalar
        // causes a larger error than a finer direction would remove.
        let (_, fine) = self.along::<H, _>(&offset, &ray, cosine, || lobe);
        let [keeps_diffuse, keeps_specular] = keeps;
        Incident {
            diffuse: if keeps_diffuse { coarse.diffuse } else { fine.diffuse },
            specular: if keeps_specular { coarse.specular } else { fine.specular },
        }
    }

    /// Returns the light along a ray: as shares of the intensity, and as irradiances.
    #[inline(always)] // `spot-table-lambert` on Cortex-M0: +29 instructions without.
    fn along<H: SpecularLobe, R: Ray<S>>(
        &self,
        offset: &S::Offset,
        ray: &R,
        cosine: R::Fraction,
        lobe: impl FnOnce() -> S,
    ) -> (Incident<R::Share>, Incident<S::Irradiance>) {
        let Stand { attenuation, intensity, .. } = self.place();
        let expose = |share| A::expose(attenuation, offset, ray, share, intensity);
        let falloff = self.falloff(ray);
        let share = falloff.map_or(cosine.scalar(), |falloff| cosine.of(falloff));
        let diffuse = Incident { diffuse: share, specular: R::Share::default() };
        let light = Incident { diffuse: expose(share), specular: S::Irradiance::default() };
        if !H::SHINES {
            return (diffuse, light);
        }
        let lobe = R::Share::of_scalar(lobe());
        let share = falloff.map_or(lobe, |falloff| falloff.share_of(lobe));
        (Incident { specular: share, ..diffuse }, Incident { specular: expose(share), ..light })
    }
}
