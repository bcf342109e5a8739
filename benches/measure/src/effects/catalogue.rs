//! The effects that have a price, and why other effects have no price of their own.

use std::sync::LazyLock;

use luminaire::{
    attenuation::{self, Attenuation, AttenuationVisitor},
    codegen::{Named, Source},
    dynamic::{Effect, Effects},
    falloff::{AnyFalloff, FalloffVisitor, ListedFalloff, constant_falloffs},
    models::Listed,
    specular::{self, LobeVisitor, SpecularLobe},
};

/// Effects of a kind.
#[derive(Debug)]
pub(crate) struct Group {
    pub(super) title: &'static str,
    /// What the programs of the group have in common.
    pub(super) note: &'static str,
    pub(super) entries: Vec<Entry>,
}

/// A program that shows an effect.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// The name for people.
    pub(super) title: &'static str,
    pub(crate) program: &'static str,
    /// The type of the model, if the entry comes from the library's lists of models.
    pub(crate) listed: Option<&'static str>,
    /// The effects of the library that the program shows.
    pub(super) effects: Effects,
    /// The program that differs only in lacking this effect; its cost is subtracted.
    pub(super) over: Option<&'static str>,
    /// What the effect is, and when a scene requires it.
    pub(super) what: &'static str,
}

/// The plain soft spotlight, with which other programs are compared.
const SPOT: &str = "spot-soft-lambert";
const INVERSE_SQUARE: &str = "spot-soft-lambert-inverse-square";
const MATTE: &str = "matte";
/// Why a sample is accepted.
const SOUND: &str = "the parameters of the lists are sound";

/// The entry of one row in a list of models: falloffs, attenuations or specular lobes.
fn listed(
    (title, program, of): (&'static str, &'static str, &'static str),
    effects: Effects,
    over: &'static str,
    what: &'static str,
) -> Entry {
    Entry {
        title,
        program,
        listed: Some(of),
        effects,
        over: (over != program).then_some(over),
        what: what.trim(),
    }
}

/// The entries of the models in the library's lists.
#[derive(Default)]
struct Models(Vec<Entry>);

impl Models {
    fn add<M: Listed>(&mut self, program: String, effects: Effects, over: &'static str) {
        let names = (M::NAME, &*program.leak(), M::TYPE);
        self.0.push(listed(names, effects, over, M::DOC));
    }
}

/// The soft spotlight with each falloff.
impl FalloffVisitor for Models {
    fn falloff<P: ListedFalloff>(&mut self) {
        let falloff: AnyFalloff = P::sample().expect(SOUND).into();
        self.add::<P>(format!("spot-{}-lambert", P::NAME), Effects::NONE.with(falloff.effect()), SPOT);
    }
}

/// The soft spotlight with each attenuation. An attenuation that limits the inverse square to a
/// range is compared with the plain inverse square.
impl AttenuationVisitor for Models {
    fn attenuation<A: Listed + Attenuation>(&mut self) {
        let effects = A::sample().expect(SOUND).effects();
        let program = format!("spot-soft-lambert-{}", A::NAME);
        if effects.has(Effect::Range) && effects.has(Effect::InverseSquare) {
            let window = effects.iter().filter(|effect| *effect != Effect::InverseSquare);
            self.add::<A>(program, window.fold(Effects::NONE, Effects::with), INVERSE_SQUARE);
        } else {
            self.add::<A>(program, effects, SPOT);
        }
    }
}

/// A surface with each specular lobe.
impl LobeVisitor<f32> for Models {
    fn lobe<H: Listed + SpecularLobe<Constants<f32>: Source> + Named>(&mut self) {
        self.add::<H>(H::NAME.to_owned(), Effects::NONE.with(Effect::Specular), MATTE);
    }
}

fn falloffs() -> Vec<Entry> {
    let mut models = Models::default();
    constant_falloffs(&mut models);
    models.0
}

fn attenuations() -> Vec<Entry> {
    let mut models = Models::default();
    attenuation::attenuations(&mut models);
    models.0
}

fn lobes() -> Vec<Entry> {
    let mut models = Models::default();
    specular::lobes(&mut models);
    models.0
}

pub(super) static GROUPS: LazyLock<[Group; 7]> = LazyLock::new(|| {
    [
    Group {
        title: "Lights",
        note: "From a point and a normal to what arrives of one light, before its colour.",
        entries: vec![
            Entry {
                title: "soft spotlight",
                program: SPOT,
                listed: Some("Soft"),
                effects: Effects::NONE.with(Effect::Spot).with(Effect::Soft).with(Effect::Unattenuated),
                over: None,
                what: "A spotlight with the soft edge and Lambert's cosine, of the same intensity at every distance: \
                       a scene has it per soft spotlight, and the other programs are compared with it.",
            },
            Entry {
                title: "its falloff alone",
                program: "spot-soft",
                listed: None,
                effects: Effects::NONE,
                over: None,
                what: "The same without Lambert's cosine: for what has no normal, such as air.",
            },
            Entry {
                title: "Lambert's cosine",
                program: SPOT,
                listed: Some("Soft"),
                effects: Effects::NONE.with(Effect::Diffuse),
                over: Some("spot-soft"),
                what: "The cosine between the normal and the way to the light: every lit surface needs it. A point \
                       facing away is an early-out before the root.",
            },
            Entry {
                title: "point light",
                program: "point",
                listed: None,
                effects: Effects::NONE.with(Effect::Point),
                over: None,
                what: "Light in all directions by the inverse-square law, and Lambert's cosine.",
            },
            Entry {
                title: "directional light",
                program: "directional",
                listed: None,
                effects: Effects::NONE.with(Effect::Directional),
                over: None,
                what: "Parallel light, such as the sun's: Lambert's cosine of a fixed direction.",
            },
        ],
    },
    Group {
        title: "Edges of the cone",
        note: "The soft spotlight with another falloff. A scene pays for those that its spotlights have.",
        entries: [falloffs(), vec![
            Entry {
                title: "hotspot",
                program: "spot-soft-lambert-hotspot",
                listed: None,
                effects: Effects::NONE.with(Effect::Hotspot),
                over: Some(SPOT),
                what: "Full intensity up to an inner angle: other constants of the same ramp.",
            },
            Entry {
                title: "cutoff",
                program: "spot-soft-lambert-cutoff",
                listed: None,
                effects: Effects::NONE.with(Effect::Cutoff),
                over: Some(SPOT),
                what: "A cone that is cut off before its falloff ends, as by barn doors or a snoot: another constant.",
            },
        ]].concat(),
    },
    Group {
        title: "Distance",
        note: "The soft spotlight with a fall with distance. The window and the range are compared with the inverse square.",
        entries: attenuations(),
    },
    Group {
        title: "Evaluation and set-up",
        note: "The soft spotlight by other evaluations, and what it costs to move it or to compile it again. Both are \
               needed once a light and picture; here they are part of each pixel, so that they can be counted.",
        entries: vec![
            Entry {
                title: "quick",
                program: "spot-soft-lambert-quick",
                listed: None,
                effects: Effects::NONE,
                over: Some(SPOT),
                what: "The quick evaluation, with a larger error: for a display of few bits.",
            },
            Entry {
                title: "fine",
                program: "spot-soft-lambert-bright",
                listed: None,
                effects: Effects::NONE,
                over: Some(SPOT),
                what: "A light of 16 times full scale at every distance: in `fx16` all its points take the fine \
                       evaluation, as those of a steep cone do.",
            },
            Entry {
                title: "move",
                program: "spot-soft-lambert-placed",
                listed: None,
                effects: Effects::NONE,
                over: Some(SPOT),
                what: "The light moved to another position with another axis, both in the format.",
            },
            Entry {
                title: "aim",
                program: "spot-soft-lambert-aimed",
                listed: None,
                effects: Effects::NONE,
                over: Some(SPOT),
                what: "The light moved to another position and aimed at a point: its axis is computed in the format.",
            },
            Entry {
                title: "zoom",
                program: "spot-soft-lambert-zoomed",
                listed: None,
                effects: Effects::NONE,
                over: Some(SPOT),
                what: "The light with a cone between its own and that of another light: its ramp is computed in the \
                       format.",
            },
            Entry {
                title: "bounding sphere",
                program: "spot-soft-lambert-bounded",
                listed: None,
                effects: Effects::NONE,
                over: Some(SPOT),
                what: "The light evaluated after a test whether it can reach a sphere. One test skips an object, a \
                       tile or a part of a row.",
            },
            Entry {
                title: "interpolated normal",
                program: "spot-soft-lambert-normalized",
                listed: None,
                effects: Effects::NONE,
                over: Some(SPOT),
                what: "Normals of any length, scaled to length 1 in the format.",
            },
            Entry {
                title: "compile",
                program: "spot-soft-lambert-compiled",
                listed: None,
                effects: Effects::NONE,
                over: Some(SPOT),
                what: "The light described by its field angle, position and axis in `f32`, and compiled: with the \
                       series for sine and root that needs no library.",
            },
        ],
    },
    Group {
        title: "In the way of a spotlight",
        note: "The soft spotlight through something. A fixture has it or not, and one that has it not knows nothing of it.",
        entries: vec![
            Entry {
                title: "gobo",
                program: "spot-soft-lambert-gobo",
                listed: None,
                effects: Effects::NONE.with(Effect::Gobo),
                over: Some(SPOT),
                what: "A pattern that the spotlight projects, here of 16 x 16 bytes: a fixture with a gobo needs \
                       it.",
            },
            Entry {
                title: "shadow",
                program: "spot-soft-lambert-shadow",
                listed: None,
                effects: Effects::NONE.with(Effect::Shadow),
                over: Some(SPOT),
                what: "A shadow map, here of 16 x 16 lengths, by four comparisons: a fixture that casts shadows needs \
                       it. Drawing the map is not counted.",
            },
            Entry {
                title: "haze",
                program: "haze",
                listed: None,
                effects: Effects::NONE.with(Effect::Haze),
                over: None,
                what: "The light that haze scatters from a beam to the eye, once a pixel and beam: a scene with \
                       haze needs it.",
            },
        ],
    },
    Group {
        title: "Surfaces",
        note: "From a point, its normal and the direction to the eye to what a material sends back of one directional \
               light, in colours. The direction to the eye is found once for all lights and not counted. Highlights are \
               of a shininess of 32.",
        entries: [vec![
            Entry {
                title: "matte",
                program: MATTE,
                listed: None,
                effects: Effects::NONE,
                over: None,
                what: "A diffuse colour and nothing else.",
            },
        ], lobes()].concat(),
    },
    Group {
        title: "The picture as a whole",
        note: "Once a pixel, however many lights there are: from the sum of the light, or from a colour, in three channels.",
        entries: vec![
            Entry {
                title: "ambient light",
                program: "ambient",
                listed: None,
                effects: Effects::NONE.with(Effect::Ambient),
                over: None,
                what: "Light that is everywhere, as one matte material sends it back, added to that of the other lights.",
            },
            Entry {
                title: "exposure",
                program: "exposure",
                listed: None,
                effects: Effects::NONE,
                over: None,
                what: "Stops: a picture that is brighter or darker than its light.",
            },
            Entry {
                title: "clip",
                program: "clip",
                listed: None,
                effects: Effects::NONE,
                over: None,
                what: "What is over full scale becomes full scale.",
            },
            Entry {
                title: "keep hue",
                program: "keep-hue",
                listed: None,
                effects: Effects::NONE,
                over: Some("clip"),
                what: "What is over full scale is scaled to it, and its hue stays.",
            },
            Entry {
                title: "sRGB",
                program: "srgb",
                listed: None,
                effects: Effects::NONE,
                over: None,
                what: "Codes of eight bits for a display.",
            },
            Entry {
                title: "sRGB, dithered",
                program: "dither",
                listed: None,
                effects: Effects::NONE.with(Effect::Dither),
                over: Some("srgb"),
                what: "Ordered dither against banding: a picture with slow gradients needs it.",
            },
            Entry {
                title: "RGB565",
                program: "rgb565",
                listed: None,
                effects: Effects::NONE,
                over: None,
                what: "Pixels of 16 bits for a small display.",
            },
            Entry {
                title: "RGB565, dithered",
                program: "rgb565-dithered",
                listed: None,
                effects: Effects::NONE.with(Effect::Dither),
                over: Some("rgb565"),
                what: "The same dither, which so few codes need more.",
            },
            Entry {
                title: "RGB565, dithered fast",
                program: "rgb565-dithered-fast",
                listed: None,
                effects: Effects::NONE.with(Effect::Dither),
                over: Some("rgb565"),
                what: "The same pixels. In fixed point the search for the codes starts from a table of 512 bytes.",
            },
            Entry {
                title: "RGB565, dithered, from a ramp",
                program: "rgb565-ramp",
                listed: None,
                effects: Effects::NONE.with(Effect::Dither),
                over: None,
                what: "The pixel of a surface of one colour by its irradiance: the colours, the sum, the clip and the dither in a table of 2,560 bytes.",
            },
        ],
    },
]
});

/// All entries, in the order of the page.
pub(crate) fn entries() -> impl Iterator<Item = &'static Entry> {
    GROUPS.iter().flat_map(|group| &group.entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_has_a_price() {
        let priced = entries().fold(Effects::NONE, |all, entry| all.union(entry.effects));
        assert_eq!(priced, Effects::ALL);
    }

    #[test]
    fn what_is_compared_with_is_in_the_catalogue() {
        for over in entries().filter_map(|entry| entry.over) {
            assert!(entries().any(|entry| entry.program == over), "{over}");
        }
    }

    #[test]
    fn each_entry_is_told_in_sentences() {
        for entry in entries() {
            assert!(entry.what.ends_with('.') && !entry.what.contains("  "), "{}", entry.what);
        }
    }
}
