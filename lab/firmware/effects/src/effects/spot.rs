//! A soft spotlight: its edge, and what filters its light.

use luminaire::{falloff::Soft, haze::ViewRay};

use crate::constants::{BEAM, CUTOFF, GOBO, HOTSPOT, SHADOW};
use crate::{Format, Irradiance, Listed, Surface};

list! {
    surface: spot_soft spot_soft_lambert_hotspot spot_soft_lambert_cutoff spot_soft_lambert_gobo
        spot_soft_lambert_shadow;
    view: haze;
}

/// A soft edge around a hotspot.
#[inline(always)]
pub fn spot_soft_lambert_hotspot(Surface { point, normal, .. }: Surface) -> Irradiance {
    HOTSPOT.irradiance(point, normal)
}

/// A soft edge with a cutoff.
#[inline(always)]
pub fn spot_soft_lambert_cutoff(Surface { point, normal, .. }: Surface) -> Irradiance {
    CUTOFF.irradiance(point, normal)
}

/// The falloff of the soft spotlight alone.
#[inline(always)]
pub fn spot_soft(Surface { point, .. }: Surface) -> Format {
    Soft::CONSTANT.falloff(point)
}

/// The soft spotlight behind a gobo of 16 by 16 texels.
#[inline(always)]
pub fn spot_soft_lambert_gobo(surface: Surface) -> Irradiance {
    GOBO.filter(Soft::effect(surface), surface.point)
}

/// The soft spotlight with a shadow map of 16 by 16 texels.
#[inline(always)]
pub fn spot_soft_lambert_shadow(surface: Surface) -> Irradiance {
    SHADOW.filter(Soft::effect(surface), surface.point)
}

/// The light that haze scatters from the beam of the soft spotlight into a view ray. It is computed
/// in f32 in every format.
#[inline(always)]
pub fn haze(view: ViewRay) -> f32 {
    BEAM.in_scattering(&view)
}
