//! The beam of a lamp in haze, for many view rays.

use super::{CompiledLamp, each::nth};
use crate::{
    attenuation::{Attenuation, Distance, InverseSquare},
    cone::Falloff,
    haze::{AirFilter, Haze, HazyBeam, ViewRay},
    profile::{Matched, Profile, with_profile},
    vec3::Vec3,
};

/// View rays from one eye, each quantity in an array of its own: see [`ViewRay`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ViewRays<const N: usize> {
    /// Where the eye is.
    pub eye: Vec3<f32>,
    /// Where it looks, of unit length.
    pub direction: Vec3<[f32; N]>,
    /// How far it sees; infinity where there is no surface.
    pub length: [f32; N],
}

impl<const N: usize> ViewRays<N> {
    /// One of the rays; beyond the last a ray of no length.
    #[inline(always)]
    pub fn at(&self, i: usize) -> ViewRay {
        let Vec3 { x, y, z } = &self.direction;
        let direction = Vec3::new(nth(x, i), nth(y, i), nth(z, i));
        ViewRay { eye: self.eye, direction, length: nth(&self.length, i) }
    }
}

impl CompiledLamp<f32> {
    /// The beam of the lamp in haze; nothing where it is no spotlight.
    pub fn in_haze(&self, haze: &Haze) -> Option<HazyBeam<Matched, Distance>> {
        match self {
            Self::Spot(spot) => Some(spot.in_haze(haze)),
            Self::Directional(_) | Self::Point(_) => None,
        }
    }
}

impl HazyBeam<Matched, Distance> {
    /// The air light of each of many rays: to the bit what [`air_light`](Self::air_light) of the beam's own profile gives for
    /// one. There is a loop for each profile under the inverse-square law, and one with branches for all others.
    pub fn air_light_each<const N: usize>(&self, rays: &ViewRays<N>, lights: &mut [f32; N]) {
        if Distance::is_inverse_square::<f32>(&self.attenuation) {
            with_profile!(self.falloff, profile, curve => each(&self.by_square(profile, curve), rays, lights));
        } else {
            each(self, rays, lights);
        }
    }

    /// The air light of each of many rays through something: to the bit what
    /// [`air_light_through`](Self::air_light_through) gives for one with `PARTS` places, which the filter is told all at once,
    /// ray by ray. It is not asked for rays that are not in the beam.
    pub fn air_light_through_each<const PARTS: usize, const N: usize>(
        &self,
        rays: &ViewRays<N>,
        filter: &mut AirFilter<'_, PARTS>,
        lights: &mut [f32; N],
    ) {
        if Distance::is_inverse_square::<f32>(&self.attenuation) {
            with_profile!(self.falloff, profile, curve => {
                each_through(&self.by_square(profile, curve), rays, filter, lights)
            });
        } else {
            each_through(self, rays, filter, lights);
        }
    }

    /// The same beam with the types of its profile and of the inverse-square law.
    fn by_square<P: Profile>(&self, profile: P, curve: P::Compiled<f32>) -> HazyBeam<P, InverseSquare> {
        let falloff = Falloff::from_parts(self.falloff.ramp, profile, curve);
        let Self { position, axis, gain, cone, reach, .. } = *self;
        HazyBeam::from_parts(position, axis, falloff, (), gain, cone, reach)
    }
}

#[inline(never)]
fn each<P: Profile, A: Attenuation, const N: usize>(
    beam: &HazyBeam<P, A>,
    rays: &ViewRays<N>,
    lights: &mut [f32; N],
) {
    for (i, light) in lights.iter_mut().enumerate() {
        *light = beam.air_light(&rays.at(i));
    }
}

#[inline(never)]
fn each_through<P: Profile, A: Attenuation, const PARTS: usize, const N: usize>(
    beam: &HazyBeam<P, A>,
    rays: &ViewRays<N>,
    filter: &mut AirFilter<'_, PARTS>,
    lights: &mut [f32; N],
) {
    for (i, light) in lights.iter_mut().enumerate() {
        *light = beam.air_light_filtered(&rays.at(i), filter);
    }
}
