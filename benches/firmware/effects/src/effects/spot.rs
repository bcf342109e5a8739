//! A soft spotlight: its edge, and what filters its light.

use core::hint::black_box;

use luminaire::{
    Angle, Cone, Scalar, SpotLight, attenuation::NoAttenuation, falloff::Soft, number::Arithmetic,
};

use crate::constants::{
    AXIS_BACK, BEAM, BRIGHT, CUTOFF, EYE, GOBO, HOTSPOT, PART, POSITION, QUICK, RADIUS, SHADOW, WIDE,
};
use crate::{Format, Irradiance, Listed, Surface};

list! {
    surface: spot_soft spot_soft_lambert_hotspot spot_soft_lambert_cutoff spot_soft_lambert_gobo
        spot_soft_lambert_shadow spot_soft_lambert_quick spot_soft_lambert_bright
        spot_soft_lambert_placed spot_soft_lambert_normalized spot_soft_lambert_aimed
        spot_soft_lambert_zoomed spot_soft_lambert_bounded spot_soft_lambert_compiled haze;
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

/// The soft spotlight by the quick evaluation.
#[inline(always)]
pub fn spot_soft_lambert_quick(Surface { point, normal, .. }: Surface) -> Irradiance {
    QUICK.irradiance(point, normal)
}

/// The soft spotlight, so bright that every point takes the fine evaluation.
#[inline(always)]
pub fn spot_soft_lambert_bright(Surface { point, normal, .. }: Surface) -> Irradiance {
    BRIGHT.irradiance(point, normal)
}

/// The soft spotlight, moved to each surface point, where it shines back to its old place.
#[inline(always)]
pub fn spot_soft_lambert_placed(Surface { point, normal, .. }: Surface) -> Irradiance {
    let normal = normal.map(|c| Format::default().minus(c));
    Soft::CONSTANT.placed(point, AXIS_BACK).irradiance(POSITION, normal)
}

/// The soft spotlight on a surface whose normals need not be of unit length.
#[inline(always)]
pub fn spot_soft_lambert_normalized(Surface { point, normal, .. }: Surface) -> Irradiance {
    Soft::CONSTANT.irradiance(point, Format::normalize(normal))
}

/// The soft spotlight, moved to each surface point and aimed back at its old place.
#[inline(always)]
pub fn spot_soft_lambert_aimed(Surface { point, normal, .. }: Surface) -> Irradiance {
    let normal = normal.map(|c| Format::default().minus(c));
    let aimed = Soft::CONSTANT.moved_to(point).aimed_at(POSITION);
    aimed.map_or(Irradiance::default(), |light| light.irradiance(POSITION, normal))
}

/// The soft spotlight, zoomed towards a wider one for each surface point.
#[inline(always)]
pub fn spot_soft_lambert_zoomed(Surface { point, normal, .. }: Surface) -> Irradiance {
    let [narrow, wide] = black_box([&Soft::CONSTANT, &WIDE]);
    narrow.zoomed(wide, black_box(PART)).irradiance(point, normal)
}

/// The soft spotlight, evaluated if it can reach a sphere around the surface point.
#[inline(always)]
pub fn spot_soft_lambert_bounded(Surface { point, normal, .. }: Surface) -> Irradiance {
    if Soft::CONSTANT.can_reach(point, black_box(RADIUS)) {
        Soft::CONSTANT.irradiance(point, normal)
    } else {
        Irradiance::default()
    }
}

/// The soft spotlight, described by numbers in f32 and compiled for each surface point.
#[inline(always)]
pub fn spot_soft_lambert_compiled(Surface { point, normal, .. }: Surface) -> Irradiance {
    let (position, axis) = ([1.5, 4.0, -0.75], [0.36, -0.8, 0.48]);
    let described = |field: Angle| {
        let cone = Cone::from_field(Soft, field)?;
        SpotLight::new(black_box(position), black_box(axis), cone)?
            .with_attenuation(NoAttenuation)
            .compile::<Format>()
    };
    described(black_box(Angle::degrees(36.0)))
        .map_or(Irradiance::default(), |light| light.irradiance(point, normal))
}

/// The falloff of the soft spotlight alone.
#[inline(always)]
pub fn spot_soft(Surface { point, .. }: Surface) -> Format {
    Soft::CONSTANT.falloff_at(point)
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

/// The light that haze scatters from the beam of the soft spotlight towards the eye, between the
/// eye and the surface point.
#[inline(always)]
#[cfg(feature = "f32")]
pub fn haze(Surface { point, .. }: Surface) -> Irradiance {
    BEAM.in_scattering(&luminaire::haze::ViewRay::between(EYE, point))
}

/// The light that haze scatters from the beam of the soft spotlight towards the eye, between the
/// eye and the surface point. Both fixed-point formats use the beam of 16 bits.
#[inline(always)]
#[cfg(not(feature = "f32"))]
pub fn haze(Surface { point, .. }: Surface) -> luminaire::number::Light16 {
    BEAM.in_scattering(EYE, point)
}
