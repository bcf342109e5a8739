//! Everything that the visitor has set, as one value.

use crate::{format::Format, map::Subject, refusal::one_of, setting::Setting, viewpoint::Viewpoint};
use luminaire::dynamic::Effect;
use luminaire_render::{Output, Strip, scenes::Example};
use std::rc::Rc;

/// The effects that have a switch, with the label of each switch.
pub(crate) const SWITCHABLE: [(Effect, &str); 5] = [
    (Effect::Specular, "highlights"),
    (Effect::Gobo, "gobos"),
    (Effect::Shadow, "shadows"),
    (Effect::Haze, "haze"),
    (Effect::Dither, "dither"),
];

/// Least and largest exposure in stops. At the least, a narrow beam of millions of candela is seen
/// near its light.
pub(crate) const EXPOSURES: [f32; 2] = [-14.0, 6.0];

/// Step of the exposure's slider in stops.
pub(crate) const EXPOSURE_STEP: f32 = 0.25;

/// Largest number of lights.
pub(crate) const LIGHTS: usize = 80;

/// The state of the stage. The picture is a function of it.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct State {
    pub(crate) scene: Example,
    /// The LEDs of a file, in place of those of the tree. No address has them.
    pub(crate) leds: Option<Rc<Strip>>,
    pub(crate) format: Format,
    /// The format of the other half of a divided picture; `None` for a whole picture.
    pub(crate) other: Option<Format>,
    /// Whether the difference between both formats covers the picture.
    pub(crate) is_difference: bool,
    /// The visitor's offset from the scene's camera.
    pub(crate) viewpoint: Viewpoint,
    /// The times to which the lights and the camera have moved, in seconds.
    pub(crate) seconds: [f32; 2],
    /// Whether the lights and the camera move.
    pub(crate) plays: [bool; 2],
    pub(crate) lights: Vec<Setting>,
    /// The effects of [`SWITCHABLE`] that the visitor has switched, and their new states.
    pub(crate) switched: [Option<bool>; SWITCHABLE.len()],
    pub(crate) map: Subject,
    /// Whether every effect is evaluated for every light at every pixel.
    pub(crate) is_everything: bool,
    /// The exposure in stops: binary logarithm of the factor on all light.
    pub(crate) exposure: f32,
    /// The shininess of all highlights and their strength: names of choices.
    pub(crate) shininess: &'static str,
    pub(crate) highlight: &'static str,
    /// The pixels of the display.
    pub(crate) output: Output,
    /// Whether overexposed light keeps its hue. Otherwise each channel is clipped.
    pub(crate) keeps_hue: bool,
    /// Whether the lights are drawn over the picture, to be dragged.
    pub(crate) shows_handles: bool,
}

impl State {
    /// The state in which a scene with this number of lights opens: as it was composed, with moving
    /// lights.
    pub(crate) fn of(scene: Example, lights: usize) -> Self {
        Self {
            scene,
            leds: None,
            format: Format::Fx16,
            other: None,
            is_difference: false,
            viewpoint: Viewpoint::ORIGINAL,
            seconds: [0.0; 2],
            plays: [true, false],
            lights: (0..lights).map(Setting::of).collect(),
            switched: [None; SWITCHABLE.len()],
            map: Subject::Nothing,
            is_everything: false,
            exposure: 0.0,
            shininess: "own",
            highlight: "own",
            output: scene.display().output,
            keeps_hue: false,
            shows_handles: true,
        }
    }

    /// The state in which another scene, or the same one again, opens for a visitor of this one.
    pub(crate) fn followed_by(&self, scene: Example, lights: usize) -> Self {
        let Self { format, other, is_difference, plays, map, is_everything, shows_handles, .. } = *self;
        Self {
            format,
            other,
            is_difference,
            plays,
            map,
            is_everything,
            shows_handles,
            ..Self::of(scene, lights)
        }
    }

    /// Returns the new state of a switched effect; `None` if it was not switched.
    pub(crate) fn switched(&self, effect: Effect) -> Option<bool> {
        self.switched[switch_of(effect.name())?]
    }

    /// Returns whether another state differs in nothing but its time, which passes by itself.
    pub(crate) fn is_same_setting(&self, other: &Self) -> bool {
        Self { seconds: [0.0; 2], ..self.clone() } == Self { seconds: [0.0; 2], ..other.clone() }
    }
}

/// Returns the place of an effect in [`SWITCHABLE`] by its name.
pub(crate) fn switch_of(name: &str) -> Option<usize> {
    SWITCHABLE.iter().position(|(effect, _)| effect.name() == name)
}

/// The names of the effects that have a switch, in words.
pub(crate) fn switchable() -> String {
    one_of(SWITCHABLE.iter().map(|(effect, _)| effect.name()))
}
