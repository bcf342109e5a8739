//! A spotlight: its edges, its distances, and what stands in its way.

use luminaire::haze::ViewRay;

use crate::constants::{
    BEAM, GOBO, SHADOW, SPOT_BLEND, SPOT_CUBIC, SPOT_CUT_OFF, SPOT_DELIMITER, SPOT_HARD, SPOT_HARD_RANGE,
    SPOT_HOTSPOT, SPOT_INVERSE_SQUARE, SPOT_LINEAR, SPOT_POLYNOMIAL, SPOT_POWER, SPOT_RIM, SPOT_SMOOTH,
    SPOT_SMOOTH_RANGE, SPOT_SOFT, SPOT_SQUARED_WINDOW, SPOT_TABLE, SPOT_WINDOWED,
};
use crate::{Format, Irradiance, Surface};

macro_rules! spots {
    ($($(#[$meta:meta])* $name:ident = $light:ident;)*) => {$(
        $(#[$meta])*
        #[inline(always)]
        pub fn $name(Surface { point, normal, .. }: Surface) -> Irradiance {
            $light.irradiance(point, normal)
        }
    )*};
}

spots! {
    /// The irradiance of a spotlight with a soft edge: Lambert's cosine, no fall with distance.
    spot_soft_lambert = SPOT_SOFT;
    /// The same with a hard edge.
    spot_hard_lambert = SPOT_HARD;
    /// The same with a smooth edge.
    spot_smooth_lambert = SPOT_SMOOTH;
    /// The same with a cubic edge.
    spot_cubic_lambert = SPOT_CUBIC;
    /// The same with the eighth power for an edge.
    spot_power_lambert = SPOT_POWER;
    /// The same with a straight ramp for an edge.
    spot_linear_lambert = SPOT_LINEAR;
    /// The same with a step for an edge.
    spot_cut_off_lambert = SPOT_CUT_OFF;
    /// The same with an edge between soft and hard.
    spot_blend_lambert = SPOT_BLEND;
    /// The same with the fourth power of the rim for an edge.
    spot_rim_lambert = SPOT_RIM;
    /// The same with a table of 16 samples for an edge.
    spot_table_lambert = SPOT_TABLE;
    /// A soft edge around a hotspot.
    spot_soft_lambert_hotspot = SPOT_HOTSPOT;
    /// A soft edge that is cut off before it ends.
    spot_soft_lambert_delimiter = SPOT_DELIMITER;
    /// A soft edge, Lambert's cosine and the inverse-square law.
    spot_soft_lambert_inverse_square = SPOT_INVERSE_SQUARE;
    /// A soft edge, Lambert's cosine and the capped reciprocal of a polynomial in the distance.
    spot_soft_lambert_polynomial = SPOT_POLYNOMIAL;
    /// A soft edge, Lambert's cosine and a smoothstep to a range.
    spot_soft_lambert_smooth_range = SPOT_SMOOTH_RANGE;
    /// A soft edge, Lambert's cosine and the inverse-square law in the window of glTF.
    spot_soft_lambert_windowed = SPOT_WINDOWED;
    /// A soft edge, Lambert's cosine and the inverse-square law in the squared window.
    spot_soft_lambert_squared_window = SPOT_SQUARED_WINDOW;
    /// A soft edge, Lambert's cosine and the inverse-square law, cut off at a range.
    spot_soft_lambert_hard_range = SPOT_HARD_RANGE;
}

/// The falloff of the soft spotlight alone.
#[inline(always)]
pub fn spot_soft(Surface { point, .. }: Surface) -> Format {
    SPOT_SOFT.falloff(point)
}

/// The soft spotlight behind a gobo of 16 by 16.
#[inline(always)]
pub fn spot_soft_lambert_gobo(surface: Surface) -> Irradiance {
    GOBO.filter(spot_soft_lambert(surface), surface.point)
}

/// The soft spotlight under a shadow map of 16 by 16.
#[inline(always)]
pub fn spot_soft_lambert_shadow(surface: Surface) -> Irradiance {
    SHADOW.filter(spot_soft_lambert(surface), surface.point)
}

/// The air light of a view ray through the beam of the soft spotlight in haze. It is f32 in every format.
#[inline(always)]
pub fn haze(view: ViewRay) -> f32 {
    BEAM.in_scattering(&view)
}
