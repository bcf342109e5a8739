//! Spotlights, compiled.

use super::{
    Incident, LightModel, fill_each, fill_in_vectors, has_vectors, light_facing, lobe, reaches,
    sealed::Sealed, spot_in_vectors,
};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    cone::CompiledCone,
    falloff::{Falloff, Soft},
    number::{Fraction, Lamp, Offset, Ray, Scalar, Share},
    points::{Points, SurfacePoint, SurfacePoints},
    specular::{NoSpecular, SpecularLobe},
    vec3::Vec3,
};

/// A spotlight compiled for the format `S`. Made by
/// [`SpotLight::compile`](crate::SpotLight::compile).
///
/// A program stores a soft light as `CompiledSpotLight<Fx16>` and a hard one as `CompiledSpotLight<Fx16, Hard>`.
/// Lights of both edges in one list are made with [`SoftOrHard`](crate::falloff::SoftOrHard), those of any edge with
/// [`AnyFalloff`](crate::falloff::AnyFalloff), and those of any kind are
/// [`CompiledAnyLight`](crate::dynamic::CompiledAnyLight)s.
///
/// ```
/// use luminaire::{Angle, Cone, Fx16, SpotLight};
/// let cone = Cone::soft(Angle::degrees(15.0))?;
/// let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(16.0)?;
/// let light = spot.compile::<Fx16>()?;
/// // The light at a point 34 cm from the middle of the floor, in 16-bit integers.
/// let lit = light.irradiance(Fx16::point([0.343, 0.0, 0.0]), Fx16::normal([0.0, 1.0, 0.0]));
/// assert!((lit.to_f32() - 0.5).abs() < 0.01);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledSpotLight<S: Scalar, P: Falloff = Soft, A: Attenuation = InverseSquare> {
    pub(crate) position: Vec3<S::Length>,
    pub(crate) axis: Vec3<S::Unit>,
    pub(crate) cone: CompiledCone<S, P>,
    pub(crate) outside: S,
    pub(crate) attenuation: A::Constants<S>,
    pub(crate) intensity: S::Gain,
    pub(crate) fine_below: u32,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<S: Scalar, P: Falloff, A: Attenuation> CompiledSpotLight<S, P, A> {
    /// Returns the irradiance at a surface point, not yet multiplied by the colours; 1 is full
    /// scale.
    ///
    /// The irradiance is the product of intensity, falloff, attenuation and Lambert's cosine.
    /// `point` is in the unit of the light's position; `normal` has unit length.
    ///
    /// Surfaces that face away, and points that are clearly outside the cone or beyond the range,
    /// are rejected before the square root. Such points receive exactly zero light, so the result
    /// is bit-identical to [`irradiance_unskipped`](Self::irradiance_unskipped).
    #[inline(always)] // `lit-shadow` on Cortex-M0: +44 instructions without.
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), true).diffuse
    }

    /// Returns the result of [`irradiance`](Self::irradiance), but without early-outs.
    ///
    /// Without the branches of the early-outs, compilers can vectorise this function.
    #[inline]
    pub fn irradiance_unskipped(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), false).diffuse
    }

    /// Returns the irradiance of a surface that faces the light at a point: what an LED, a particle or
    /// another small body without a normal receives, not yet multiplied by the colours.
    ///
    /// It is the product of intensity, falloff and attenuation. Points outside the cone, and in the coarse
    /// evaluation those beyond the range, are rejected before the square root; they receive exactly zero. The
    /// error is at most that of [`error_bound`](crate::SpotLight::error_bound).
    ///
    /// ```
    /// use luminaire::{Angle, Cone, Fx16, SpotLight};
    /// let cone = Cone::soft(Angle::degrees(15.0))?;
    /// let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(8.0)?;
    /// let light = spot.compile::<Fx16>()?;
    /// assert_eq!(light.irradiance_facing(Fx16::point([0.0, 0.0, 0.0])).to_f32(), 0.5);
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    #[inline]
    pub fn irradiance_facing(&self, point: Vec3<S::Length>) -> S::Irradiance {
        let offset = S::Offset::between(self.position, point);
        if offset.is_outside(self.axis, self.outside) {
            return S::Irradiance::default();
        }
        let light = (&self.attenuation, self.intensity, self.fine_below);
        light_facing::<S, _, A>(light, (&self.cone, self.axis), &offset)
    }

    /// Returns the falloff of the cone alone at a point, in `[0, 1]`.
    #[inline]
    pub fn falloff_at(&self, point: Vec3<S::Length>) -> S {
        let offset = S::Offset::between(self.position, point);
        if offset.is_near(self.fine_below) {
            return self.cone.at_ray(&S::fine_ray(&offset), self.axis).scalar();
        }
        self.cone.at_ray(&offset.ray(), self.axis).scalar()
    }

    /// Returns `false` only if no point within `radius` of `center` receives light: all of them are
    /// outside the cone.
    ///
    /// A program skips a light for an object, a tile or a row by its bounding sphere.
    /// [`Row`](crate::light::Row) does so for the parts of a row. For cones from 8 to 160 degrees a sphere is
    /// skipped if a plane that touches the cone separates them by more than 0.19 of the distance from the light to the
    /// centre and 3.5e-4 units in `Fx16` and `Fx32`, and by more than 4.2e-4 of the distance and 9e-7 of the coordinates of
    /// the light in `f32` (derived). In fixed point the radius over the sine of the half angle must be less than 8,000
    /// units, and the light moved back by it within 32,000.
    /// Spheres near a narrower cone may not be skipped, and those near a cone of 180 degrees never are.
    pub fn can_reach(&self, center: Vec3<S::Length>, radius: S::Length) -> bool {
        LightModel::can_reach(self, center, radius)
    }

    /// Returns whether the evaluation at a point is fine. The fine evaluation costs several times
    /// as much as the coarse evaluation.
    ///
    /// Only `Fx16` has a fine and a coarse evaluation. Where the light is clipped, the coarse
    /// result is kept although this function returns `true`.
    #[cfg(feature = "arithmetic")]
    pub fn is_fine(&self, point: Vec3<S::Length>) -> bool {
        S::Offset::between(self.position, point).is_near(self.fine_below)
    }

    /// Returns the same light at another position, with another axis of unit length.
    ///
    /// An axis in the format is that of another compiled light: [`axis`](Self::axis).
    #[must_use]
    pub fn placed(self, position: Vec3<S::Length>, axis: Vec3<S::Unit>) -> Self {
        Self { position, axis, ..self }
    }

    /// Returns the position of the light.
    pub fn position(&self) -> Vec3<S::Length> {
        self.position
    }

    /// Returns the direction in which the light points, of unit length.
    pub fn axis(&self) -> Vec3<S::Unit> {
        self.axis
    }

    /// Returns the falloff of the cone.
    pub fn falloff(&self) -> P {
        self.cone.falloff()
    }

    /// Returns the same light with its falloff converted to another type.
    ///
    /// A conversion from a run-time choice to a concrete type moves the branch on the falloff from
    /// each point to each light.
    pub fn with_falloff<Q: Falloff>(&self, falloff: Q) -> CompiledSpotLight<S, Q, A> {
        CompiledSpotLight {
            position: self.position,
            axis: self.axis,
            cone: self.cone.with_falloff(falloff),
            outside: self.outside,
            attenuation: self.attenuation,
            intensity: self.intensity,
            fine_below: self.fine_below,
            color: self.color,
            specular_color: self.specular_color,
        }
    }

    /// Creates a light from its fields, as [`codegen`](crate::codegen) writes them.
    ///
    /// `outside` is the bound for rejecting points outside the cone, and `fine_below` is the result
    /// of `Errors::fine_below`. A bound that rejects points which the cone lights leaves it open which of both a
    /// [`Row`](crate::light::Row) does. The colours are the diffuse and the specular colour.
    #[expect(clippy::too_many_arguments, reason = "generated source names each part of a light once")]
    pub const fn from_parts(
        position: Vec3<S::Length>,
        axis: Vec3<S::Unit>,
        cone: CompiledCone<S, P>,
        outside: S,
        attenuation: A::Constants<S>,
        intensity: S::Gain,
        fine_below: u32,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self { position, axis, cone, outside, attenuation, intensity, fine_below, color, specular_color }
    }
}

impl<S: Scalar, P: Falloff, A: Attenuation> Sealed for CompiledSpotLight<S, P, A> {}

impl<S: Scalar, P: Falloff, A: Attenuation> LightModel<S> for CompiledSpotLight<S, P, A> {
    #[inline]
    fn colors(&self) -> [Rgb<S>; 2] {
        [self.color, self.specular_color]
    }

    #[inline(always)]
    fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance> {
        let SurfacePoint { point, normal, view } = *surface;
        let offset = S::Offset::between(self.position, point);
        if offset.is_near(self.fine_below) {
            return self.evaluate_finely::<H>(offset, (normal, view), highlight);
        }
        let Self { axis, outside, ref attenuation, intensity, .. } = *self;
        let facing = offset.facing(normal);
        if skips
            && (S::Offset::faces_away(facing)
                || offset.is_outside(axis, outside)
                || A::is_beyond::<S, _>(attenuation, &offset))
        {
            return Incident::default();
        }
        let ray = offset.ray();
        let cosine = ray.cosine(facing, normal);
        let falloff = self.cone.at_ray(&ray, axis);
        let light = |share| A::light(attenuation, &offset, &ray, share, intensity);
        let diffuse = light(cosine.times_value(falloff));
        if !H::SHINES {
            return Incident { diffuse, ..Incident::default() };
        }
        let lobe = lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.value().scalar());
        Incident { diffuse, specular: light(falloff.times(Share::of_scalar(lobe))) }
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
            fine_below: self.fine_below,
        };
        let light = (&lamp, self.cone.curve);
        A::IS_INVERSE_SQUARE && spot_in_vectors::<S, S::Offset, P, H, N>(light, surfaces, highlight, arrivals)
    }

    #[inline]
    fn fill<F: Points<S>>(
        &self,
        points: &F,
        normal: impl Fn(usize) -> Vec3<S>,
        arrived: &mut [S::Irradiance],
    ) {
        let each = |first, arrived: &mut [S::Irradiance]| fill_each(self, points, &normal, first, arrived);
        if has_vectors::<S, S::Offset, P, A>(self.cone.curve) {
            fill_in_vectors(self, points, &normal, arrived, each);
        } else {
            each(0, arrived);
        }
    }

    fn can_reach(&self, center: Vec3<S::Length>, radius: S::Length) -> bool {
        reaches::<S>(self.position, (self.axis, self.outside), center, radius)
    }
}

impl<S: Scalar, P: Falloff, A: Attenuation> CompiledSpotLight<S, P, A> {
    /// Evaluates a point near the light, or in a steep cone. The function is separate and cold, so
    /// that the common path stays in registers.
    #[cold]
    #[inline(never)]
    fn evaluate_finely<H: SpecularLobe>(
        &self,
        offset: S::Offset,
        (normal, view): (Vec3<S>, Vec3<S::Unit>),
        highlight: &H::Constants<S>,
    ) -> Incident<S::Irradiance> {
        let facing = offset.facing(normal);
        if S::Offset::faces_far_away(facing) || offset.is_outside(self.axis, self.outside) {
            return Incident::default();
        }
        let light = (&self.attenuation, self.intensity, self.fine_below);
        let cone = (&self.cone, self.axis);
        super::evaluate_finely::<S, _, A, H>(light, cone, (&offset, facing), (normal, view), highlight)
    }
}
