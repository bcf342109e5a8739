//! The beam of a spotlight in haze, and its light along view rays.

use crate::light::places::Places;
use luminaire::{
    Cone, Error, Rgb, Scalar, Vec3,
    attenuation::AnyAttenuation,
    dynamic::AnyLight,
    falloff::{AnyFalloff, Falloff as _, Formula},
    haze::{BeamScattering, Haze, RayBundle, ViewRays},
    light::CompiledCone,
    projector::{CompiledGobo, Fixture, Gobo, Projection, Shadow},
};

/// Rays per batch: a whole number of vector registers on every target.
pub(super) const BATCH: usize = 16;

/// Number of sample points on a view ray through a beam with a gobo or a shadow map.
const PLACES: usize = 16;

/// The beam of a spotlight in haze.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hazy {
    pub(super) beam: BeamScattering<AnyFalloff, AnyAttenuation>,
    pub(super) color: Rgb<f32>,
    pub(super) position: glam::Vec3,
    pub(super) axis: glam::Vec3,
    /// The in-scattering at a distance of 1 from the light, where the integral over the directions
    /// is 1.
    pub(super) gain: f32,
    pub(super) cone: Cone<AnyFalloff>,
    pub(super) falloff: CompiledCone<f32, AnyFalloff>,
    pub(super) gobo: Option<(Gobo<'static>, Projection)>,
    /// The radius of the light, which is an opaque sphere.
    pub(super) radius: f32,
}

/// The gobo and the shadow map of a beam.
#[derive(Debug)]
pub(crate) struct Way<'a, S: Scalar> {
    pub(crate) gobo: Option<&'a CompiledGobo<'static, S>>,
    pub(crate) shadow: Option<Shadow<'a, S>>,
}

impl Hazy {
    /// Compiles the beam of a light; `None` if the light is not a spotlight.
    ///
    /// # Errors
    /// A light that `f32` can't hold.
    pub(crate) fn new(fixture: &Fixture, haze: &Haze) -> Result<Option<Self>, Error> {
        let light = fixture.light();
        let AnyLight::Spot(spot) = light else { return Ok(None) };
        let Some(beam) = light.compile::<f32>()?.in_haze(haze) else { return Ok(None) };
        Ok(Some(Self {
            beam,
            color: light.color(),
            position: spot.position().into(),
            axis: spot.axis().into(),
            gain: spot.intensity() * (haze.density() / 4.0),
            cone: spot.cone(),
            falloff: spot.cone().compile()?,
            gobo: fixture.gobo(),
            radius: haze.source_radius(),
        }))
    }

    /// Returns false only if no ray of the bundle meets the beam.
    pub(crate) fn may_be_seen(&self, sight: &RayBundle) -> bool {
        self.beam.can_meet(sight)
    }

    /// Computes the intensity at each of many versines. For polynomials there is a loop without branches.
    pub(super) fn intensities<const N: usize>(&self, versines: &[f32; N], intensities: &mut [f32; N]) {
        let ([inner, outer, limit], falloff) = (self.cone.versines(), self.cone.falloff());
        let Formula::Polynomial([a, b, c]) = falloff.formula() else {
            return self.falloff.at_each(versines, intensities);
        };
        let rise = 1.0 / (outer - inner);
        for i in 0..N {
            let t = (outer - versines[i]) * rise;
            let t = if (t > 0.0) & (versines[i] < limit) { t } else { 0.0 };
            let t = if t < 1.0 { t } else { 1.0 };
            intensities[i] = t * (a + t * (b + t * c));
        }
    }

    /// Writes the in-scattered light of the beam along each ray, before its colour.
    pub(super) fn scatter<S: Scalar>(
        &self,
        rays: &ViewRays<BATCH>,
        way: &Way<'_, S>,
        air: &mut [f32; BATCH],
    ) {
        if way.is_clear() {
            self.beam.in_scattering_each(rays, air);
        } else {
            let mut places = Places::default();
            let mut filter = |points: &Vec3<_>, lights: &mut _| way.leave(points, lights, &mut places);
            self.beam.in_scattering_through_each(rays, &mut filter, air);
        }
    }
}

impl<S: Scalar> Way<'_, S> {
    /// Returns whether the beam has neither gobo nor shadow map.
    pub(super) fn is_clear(&self) -> bool {
        self.gobo.is_none() && self.shadow.is_none()
    }

    /// Multiplies the light at each point by the transmittance of the gobo and of the shadow map.
    fn leave(
        &self,
        points: &Vec3<[f32; PLACES]>,
        lights: &mut [f32; PLACES],
        places: &mut Places<S, PLACES>,
    ) {
        let points = points.map(|column| column.map(S::length));
        if let Some(gobo) = self.gobo {
            places.find(gobo.projection(), &points);
            for (light, part) in lights.iter_mut().zip(places.transmissions(gobo.gobo())) {
                *light *= part.to_f32();
            }
        }
        if let Some(shadow) = &self.shadow {
            places.find(shadow.projection(), &points);
            for (i, light) in lights.iter_mut().enumerate().filter(|(_, light)| **light > 0.0) {
                *light *= shadow.at(&places.at(i)).to_f32();
            }
        }
    }
}
