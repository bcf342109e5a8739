//! What is in the way of a soft spotlight.

use luminaire::falloff::Soft;

use crate::constants::{BEAM, EYE, GOBO, SHADOW};
use crate::format::{Irradiance, Surface};
use crate::listed::Listed;

#[cfg(feature = "f32")]
type Scattered = Irradiance;
/// Both fixed-point formats use the beam of 16 bits.
#[cfg(not(feature = "f32"))]
type Scattered = luminaire::number::Light16;

effects! { each;
    /// A pattern that the spotlight projects, here of 16 x 16 bytes: a fixture with a gobo needs it.
    "gobo", surface, [Gobo] over "lit";
    fn lit_gobo(surface: Surface) -> Irradiance { GOBO.filter(Soft::effect(surface), surface.point) }

    /// A shadow map, here of 16 x 16 lengths, by four comparisons: a fixture that casts shadows needs
    /// it. Drawing the map is not counted.
    "shadow", surface, [Shadow] over "lit";
    fn lit_shadow(surface: Surface) -> Irradiance { SHADOW.filter(Soft::effect(surface), surface.point) }

    /// The light that haze scatters from a beam to the eye, once a pixel and beam: a scene with
    /// haze needs it.
    "haze", surface, [Haze];
    fn haze(Surface { point, .. }: Surface) -> Scattered {
        #[cfg(feature = "f32")]
        return BEAM.in_scattering(&luminaire::haze::ViewRay::between(EYE, point));
        #[cfg(not(feature = "f32"))]
        return BEAM.in_scattering(EYE, point);
    }
}
