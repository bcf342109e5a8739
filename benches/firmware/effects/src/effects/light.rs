//! Lights, and other ramps of the soft spotlight.

use luminaire::dynamic::{Effect, Effects};
use luminaire::falloff::Soft;

use crate::catalogue::{Entry, Visit};
use crate::constants::{CUTOFF, DIRECTIONAL, HOTSPOT, MEASURED, POINT};
use crate::format::{Format, Irradiance, Surface};
use crate::listed::Listed;

/// The soft spotlight, with and without Lambert's cosine.
pub(super) fn soft(visit: &mut impl Visit) {
    let entry = Entry {
        title: "soft spotlight",
        name: Soft::NAME,
        listed: Some("Soft"),
        effects: Effects::NONE.with(Effect::Spot).with(Effect::Soft).with(Effect::Unattenuated),
        over: &[],
        what: "A spotlight with the soft edge and Lambert's cosine, of the same intensity at every distance: \
               a scene has it per soft spotlight, and the other programs are compared with it.",
    };
    visit.again(entry);
    alone(visit);
    visit.again(Entry {
        title: "Lambert's cosine",
        effects: Effects::NONE.with(Effect::Diffuse),
        over: &["falloff_alone"],
        what: "The cosine between the normal and the way to the light: every lit surface needs it. A point \
               facing away is an early-out before the root.",
        ..entry
    });
}

effects! { alone;
    /// The same without Lambert's cosine: for what has no normal, such as air.
    "its falloff alone", surface, [];
    fn falloff_alone(Surface { point, .. }: Surface) -> Format { Soft::CONSTANT.falloff_at(point) }
}

effects! { others;
    /// Light in all directions by the inverse-square law, and Lambert's cosine.
    "point light", surface, [Point];
    fn point(surface: Surface) -> Irradiance { POINT.irradiance(surface.point, surface.normal) }

    /// A light that is not round, such as a street light: the point light times a table over all directions, here of 17
    /// by 17 samples of a quadrant.
    "measured light", surface, [Measured] over "point";
    fn measured(surface: Surface) -> Irradiance { MEASURED.irradiance(surface.point, surface.normal) }

    /// Parallel light, such as the sun's: Lambert's cosine of a fixed direction.
    "directional light", surface, [Directional];
    fn directional(surface: Surface) -> Irradiance { DIRECTIONAL.irradiance(surface.normal) }
}

effects! { ramps;
    /// Full intensity up to an inner angle: other constants of the same ramp.
    "hotspot", surface, [Hotspot] over "lit";
    fn lit_hotspot(Surface { point, normal, .. }: Surface) -> Irradiance { HOTSPOT.irradiance(point, normal) }

    /// A cone that is cut off before its falloff ends, as by barn doors or a snoot: another constant.
    "cutoff", surface, [Cutoff] over "lit";
    fn lit_cutoff(Surface { point, normal, .. }: Surface) -> Irradiance { CUTOFF.irradiance(point, normal) }
}
