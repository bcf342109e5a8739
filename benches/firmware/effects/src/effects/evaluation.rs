//! The soft spotlight by other evaluations, moved, and set up again; and lit points whose prices choose
//! an evaluation.

use core::hint::black_box;

use luminaire::dynamic::Effects;
use luminaire::light::{LightModel, SurfacePoint};
use luminaire::number::{Arithmetic, Lights};
use luminaire::{
    Angle, Cone, Scalar, SpotLight,
    attenuation::{InverseSquare, NoAttenuation},
    falloff::Soft,
    specular::Phong,
};

use crate::catalogue::{Entry, Visit};
use crate::constants::{
    AXIS_BACK, BRIGHT, DIFFUSE, EYE, HIGHLIGHT, PART, POSITION, QUICK, RADIUS, SPECULAR, WIDE,
};
use crate::format::{Format, Irradiance, Surface};
use crate::input::Inputs;
use crate::listed::Listed;

/// Visits lit points, each with the light that the build script has written under its name.
macro_rules! lit {
    ($visit:ident, $inputs:ident: $($name:expr;)*) => {$(
        $visit.effect(unlisted($name), Inputs::$inputs, |Surface { point, normal, .. }: Surface| {
            const { include!(concat!(env!("OUT_DIR"), "/", $name, ".rs")) }.irradiance(point, normal)
        });
    )*};
}

effects! { each;
    /// The quick evaluation of `fx16`, with a larger error: for a display of few bits.
    "quick", surface, [] over "lit";
    fn lit_quick(Surface { point, normal, .. }: Surface) -> Irradiance { QUICK.irradiance(point, normal) }

    /// A light of 16 times full scale at every distance: in `fx16` all its points take the fine
    /// evaluation, as those of a steep cone do.
    "fine", surface, [] over "lit";
    fn lit_bright(Surface { point, normal, .. }: Surface) -> Irradiance { BRIGHT.irradiance(point, normal) }

    /// The light moved to another position with another axis, both in the format.
    "move", surface, [] over "lit";
    fn lit_placed(Surface { point, normal, .. }: Surface) -> Irradiance {
        let normal = normal.map(|c| Format::default().minus(c));
        Soft::CONSTANT.placed(point, AXIS_BACK).irradiance(POSITION, normal)
    }

    /// The light moved to another position and aimed at a point: its axis is computed in the format.
    "aim", surface, [] over "lit";
    fn lit_aimed(Surface { point, normal, .. }: Surface) -> Irradiance {
        let normal = normal.map(|c| Format::default().minus(c));
        let aimed = Soft::CONSTANT.moved_to(point).aimed_at(POSITION);
        aimed.map_or(Irradiance::default(), |light| light.irradiance(POSITION, normal))
    }

    /// The light with a cone between its own and that of another light: its ramp is computed in the
    /// format.
    "zoom", surface, [] over "lit";
    fn lit_zoomed(Surface { point, normal, .. }: Surface) -> Irradiance {
        let [narrow, wide] = black_box([&Soft::CONSTANT, &WIDE]);
        narrow.zoomed(wide, black_box(PART)).irradiance(point, normal)
    }

    /// The light evaluated after a test whether it can reach a sphere. One test skips an object, a
    /// tile or a part of a row.
    "bounding sphere", surface, [] over "lit";
    fn lit_bounded(Surface { point, normal, .. }: Surface) -> Irradiance {
        if Soft::CONSTANT.can_reach(point, black_box(RADIUS)) {
            Soft::CONSTANT.irradiance(point, normal)
        } else {
            Irradiance::default()
        }
    }

    /// Normals of any length, scaled to length 1 in the format.
    "interpolated normal", surface, [] over "lit";
    fn lit_normalized(Surface { point, normal, .. }: Surface) -> Irradiance {
        Soft::CONSTANT.irradiance(point, <Format as Scalar>::normalize(normal))
    }

    /// The light described by its field angle, position and axis in `f32`, and compiled: with the
    /// series for sine and root that needs no library.
    "compile", surface, [] over "lit";
    fn lit_compiled(Surface { point, normal, .. }: Surface) -> Irradiance {
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
}

/// Visits the lit points of the price list that are no row of the page of effects: the early-outs, a
/// highlight, and four edges with an inverse square by every evaluation.
pub fn each_evaluation(visit: &mut impl Visit) {
    let lit = |surface: Surface| Soft::effect(surface);
    visit.effect(unlisted("away"), Inputs::away, lit);
    visit.effect(unlisted("outside"), Inputs::outside, lit);
    #[cfg(not(any(feature = "f32", feature = "fx32")))]
    visit.effect(unlisted("away-quick"), Inputs::away, lit_quick);
    #[cfg(not(any(feature = "f32", feature = "fx32")))]
    visit.effect(unlisted("outside-quick"), Inputs::outside, lit_quick);
    visit.effect(unlisted("lit-specular"), Inputs::surface, highlit);
    macro_rules! edges {
        ($($name:literal;)*) => {$(
            #[cfg(not(any(feature = "f32", feature = "fx32")))]
            lit! { visit, surface: concat!("lit", $name, "-inverse-square-quick"); }
            #[cfg(not(any(feature = "f32", feature = "fx32")))]
            lit! { visit, narrow:
                concat!("lit", $name, "-fine");
                concat!("lit", $name, "-inverse-square-fine");
            }
            #[cfg(not(any(feature = "f32", feature = "fx32")))]
            lit! { visit, surface: concat!("lit", $name, "-inverse-square-coarse"); }
        )*};
    }
    edges! { ""; "-hard"; "-quadratic"; "-cubic"; }
    macro_rules! other_edges {
        ($($name:literal;)*) => {$(
            #[cfg(not(any(feature = "f32", feature = "fx32")))]
            lit! { visit, surface: concat!("lit", $name, "-quick"); }
            lit! { visit, surface: concat!("lit", $name, "-inverse-square"); }
        )*};
    }
    other_edges! { "-hard"; "-quadratic"; "-cubic"; }
}

// The build script writes the function `each_choice`, which visits lit points with one model each of the
// library's lists, by the evaluations that are no row above. They have a program of their own, so that those above
// keep their counts.
include!(concat!(env!("OUT_DIR"), "/choices.rs"));

fn unlisted(name: &'static str) -> Entry {
    Entry { title: "", name, listed: None, effects: Effects::NONE, over: &[], what: "" }
}

/// The soft spotlight with an inverse square and Phong's highlight, in one channel. The direction to the
/// eye is computed for the light.
#[inline(always)]
fn highlit(Surface { point, normal, .. }: Surface) -> Irradiance {
    let surface = SurfacePoint::seen_from(EYE, point, normal);
    let arrival = InverseSquare::CONSTANT.evaluate::<Phong>(&surface, &HIGHLIGHT, true);
    Format::filter(arrival.diffuse, DIFFUSE) + Format::filter(arrival.specular, SPECULAR)
}
