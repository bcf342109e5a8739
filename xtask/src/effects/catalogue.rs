//! The effects that have a price, and why the others have none of their own.

use luminaire::dynamic::Effect::{self, *};

/// Effects of a kind.
#[derive(Debug)]
pub(super) struct Group {
    pub(super) title: &'static str,
    /// What the programs of the group have in common.
    pub(super) note: &'static str,
    pub(super) entries: &'static [Entry],
}

/// A program that shows an effect.
#[derive(Debug)]
pub(super) struct Entry {
    /// The name for people.
    pub(super) title: &'static str,
    pub(super) program: &'static str,
    /// The effects of the library that it is of.
    pub(super) effects: &'static [Effect],
    /// The program that lacks them, and nothing else.
    pub(super) over: Option<&'static str>,
    /// What it is, and when a scene calls for it.
    pub(super) what: &'static str,
}

/// The plain soft spotlight, with which the others are compared.
const SPOT: &str = "spot-soft-lambert";
const INVERSE_SQUARE: &str = "spot-soft-lambert-inverse-square";
const MATTE: &str = "matte";

pub(super) static GROUPS: [Group; 6] = [
    Group {
        title: "Lights",
        note: "From a point and a normal to what arrives of one light, before its colour.",
        entries: &[
            Entry {
                title: "soft spotlight",
                program: SPOT,
                effects: &[Spot, Soft, Unattenuated],
                over: None,
                what: "A spotlight with the soft edge and Lambert's cosine, at full strength at every distance: a \
                       scene has it per soft spotlight, and the other programs are told from it.",
            },
            Entry {
                title: "its falloff alone",
                program: "spot-soft",
                effects: &[],
                over: None,
                what: "The same without Lambert's cosine: for what has no normal, such as air.",
            },
            Entry {
                title: "Lambert's cosine",
                program: SPOT,
                effects: &[Diffuse],
                over: Some("spot-soft"),
                what: "The cosine between the normal and the way to the light: every lit surface calls for it. Facing \
                       away is found before the root is paid for.",
            },
            Entry {
                title: "point light",
                program: "point",
                effects: &[Point],
                over: None,
                what: "Light in all directions by the inverse-square law, and Lambert's cosine.",
            },
            Entry {
                title: "directional light",
                program: "directional",
                effects: &[Directional],
                over: None,
                what: "Parallel light, such as the sun's: Lambert's cosine of a fixed direction.",
            },
        ],
    },
    Group {
        title: "Edges of the cone",
        note: "The soft spotlight with another profile. A scene pays for those that its spotlights have.",
        entries: &[
            Entry {
                title: "hard",
                program: "spot-hard-lambert",
                effects: &[Hard],
                over: Some(SPOT),
                what: "The hard edge, `1 - u^2`.",
            },
            Entry {
                title: "linear",
                program: "spot-linear-lambert",
                effects: &[Linear],
                over: Some(SPOT),
                what: "A straight ramp.",
            },
            Entry {
                title: "cut-off",
                program: "spot-cut-off-lambert",
                effects: &[Step],
                over: Some(SPOT),
                what: "A step: all or nothing.",
            },
            Entry {
                title: "smooth",
                program: "spot-smooth-lambert",
                effects: &[Smooth],
                over: Some(SPOT),
                what: "Smoothstep.",
            },
            Entry {
                title: "blend",
                program: "spot-blend-lambert",
                effects: &[Quadratic],
                over: Some(SPOT),
                what: "A quadratic between soft and hard: a luminaire of given beam and field angles calls for it.",
            },
            Entry {
                title: "cubic",
                program: "spot-cubic-lambert",
                effects: &[Cubic],
                over: Some(SPOT),
                what: "A monotone cubic: the angles that no quadratic has.",
            },
            Entry {
                title: "power",
                program: "spot-power-lambert",
                effects: &[Power],
                over: Some(SPOT),
                what: "An integer power, here the eighth: a concentrated beam.",
            },
            Entry {
                title: "rim",
                program: "spot-rim-lambert",
                effects: &[InvertedPower],
                over: Some(SPOT),
                what: "An integer power of the rim, here the fourth: a flat middle and a steep edge.",
            },
            Entry {
                title: "table",
                program: "spot-table-lambert",
                effects: &[Table],
                over: Some(SPOT),
                what: "Samples, here 16, with straight lines between: a luminaire that was measured.",
            },
            Entry {
                title: "hotspot",
                program: "spot-soft-lambert-hotspot",
                effects: &[Hotspot],
                over: Some(SPOT),
                what: "Full intensity up to an inner angle: other constants of the same ramp.",
            },
            Entry {
                title: "delimiter",
                program: "spot-soft-lambert-delimiter",
                effects: &[Delimiter],
                over: Some(SPOT),
                what: "A cone that is cut off before its profile ends, as by barn doors or a snoot: another constant.",
            },
        ],
    },
    Group {
        title: "Distance",
        note: "The soft spotlight with a fall with distance. The window and the range are told from the inverse square.",
        entries: &[
            Entry {
                title: "inverse square",
                program: INVERSE_SQUARE,
                effects: &[InverseSquare],
                over: Some(SPOT),
                what: "The law of a small source: the default of every spot and point light.",
            },
            Entry {
                title: "polynomial",
                program: "spot-soft-lambert-polynomial",
                effects: &[Polynomial],
                over: Some(SPOT),
                what: "`1/(a0 + a1 d + a2 d^2)`, capped: lights of OpenGL and Direct3D call for it.",
            },
            Entry {
                title: "smooth range",
                program: "spot-soft-lambert-smooth-range",
                effects: &[SmoothRange],
                over: Some(SPOT),
                what: "A smoothstep that ends at a range.",
            },
            Entry {
                title: "window",
                program: "spot-soft-lambert-windowed",
                effects: &[Window],
                over: Some(INVERSE_SQUARE),
                what: "The window by which lights of glTF end at their range.",
            },
            Entry {
                title: "squared window",
                program: "spot-soft-lambert-squared-window",
                effects: &[Window],
                over: Some(INVERSE_SQUARE),
                what: "The same squared, as Filament and Godot have it.",
            },
            Entry {
                title: "range",
                program: "spot-soft-lambert-hard-range",
                effects: &[Range],
                over: Some(INVERSE_SQUARE),
                what: "Cut off at a range: nothing from there on, and the law unchanged before.",
            },
        ],
    },
    Group {
        title: "In the way of a spotlight",
        note: "The soft spotlight through something. A luminaire has it or not, and one that has it not knows nothing of it.",
        entries: &[
            Entry {
                title: "gobo",
                program: "spot-soft-lambert-gobo",
                effects: &[Gobo],
                over: Some(SPOT),
                what: "A pattern that the spotlight projects, here of 16 x 16 bytes: a luminaire with a gobo calls for \
                       it.",
            },
            Entry {
                title: "shadow",
                program: "spot-soft-lambert-shadow",
                effects: &[Shadow],
                over: Some(SPOT),
                what: "A shadow map, here of 16 x 16 lengths, by four comparisons: a luminaire that casts shadows calls \
                       for it. Drawing the map is not counted.",
            },
            Entry {
                title: "haze",
                program: "haze",
                effects: &[Haze],
                over: None,
                what: "The light that air sends from a beam to the eye, once a pixel and beam, in `f32` on every \
                       processor: a scene with haze calls for it.",
            },
        ],
    },
    Group {
        title: "Surfaces",
        note: "From a point, its normal and the direction to the eye to what a material sends back of one directional \
               light, in colours. The direction to the eye is found once for all lights and not counted. Highlights are \
               of a shininess of 32.",
        entries: &[
            Entry {
                title: "matt",
                program: MATTE,
                effects: &[],
                over: None,
                what: "A diffuse colour and nothing else.",
            },
            Entry {
                title: "Phong",
                program: "phong",
                effects: &[Specular],
                over: Some(MATTE),
                what: "The highlight of the mirrored direction: a material with a specular colour calls for it.",
            },
            Entry {
                title: "Blinn-Phong",
                program: "blinn-phong",
                effects: &[Specular],
                over: Some(MATTE),
                what: "The highlight of the half angle.",
            },
            Entry {
                title: "dual cone",
                program: "dual-cone",
                effects: &[Specular],
                over: Some(MATTE),
                what: "A spotlight's falloff about the mirrored direction.",
            },
            Entry {
                title: "Lyon",
                program: "lyon",
                effects: &[Specular],
                over: Some(MATTE),
                what: "Phong's by a difference of directions and three squarings.",
            },
        ],
    },
    Group {
        title: "The picture as a whole",
        note: "Once a pixel, however many lights there are: from the sum of the light, or from a colour, in three channels.",
        entries: &[
            Entry {
                title: "ambient light",
                program: "ambient",
                effects: &[Ambient],
                over: None,
                what: "Light that is everywhere, as one matt material sends it back, added to the light of lamps.",
            },
            Entry {
                title: "exposure",
                program: "exposure",
                effects: &[],
                over: None,
                what: "Stops: a picture that is brighter or darker than its light.",
            },
            Entry {
                title: "clip",
                program: "clip",
                effects: &[],
                over: None,
                what: "What is over full scale becomes full scale.",
            },
            Entry {
                title: "keep hue",
                program: "keep-hue",
                effects: &[],
                over: Some("clip"),
                what: "What is over full scale is scaled to it, and its hue stays.",
            },
            Entry {
                title: "sRGB",
                program: "srgb",
                effects: &[],
                over: None,
                what: "Codes of eight bits for a display.",
            },
            Entry {
                title: "sRGB, dithered",
                program: "dither",
                effects: &[Dither],
                over: Some("srgb"),
                what: "Ordered dither against banding: a picture with slow gradients calls for it.",
            },
            Entry {
                title: "RGB565",
                program: "rgb565",
                effects: &[],
                over: None,
                what: "Pixels of 16 bits for a small display.",
            },
            Entry {
                title: "RGB565, dithered",
                program: "rgb565-dithered",
                effects: &[Dither],
                over: Some("rgb565"),
                what: "The same dither, which so few codes need more.",
            },
        ],
    },
];

/// The effects that no program shows, and why.
pub(super) static UNPRICED: [(Effect, &str); 4] = [
    (MixedPower, "is chosen while a program runs and is no constant of one"),
    (InvertedMixedPower, "likewise"),
    (RealPower, "likewise"),
    (InvertedRealPower, "likewise"),
];

/// All entries, in the order of the page.
pub(super) fn entries() -> impl Iterator<Item = &'static Entry> {
    GROUPS.iter().flat_map(|group| group.entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_has_a_price_or_a_reason_and_not_both() {
        for effect in Effect::ALL {
            let is_priced = entries().any(|entry| entry.effects.contains(effect));
            let is_unpriced = UNPRICED.iter().any(|(unpriced, _)| unpriced == effect);
            assert!(is_priced != is_unpriced, "{}", effect.name());
        }
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
