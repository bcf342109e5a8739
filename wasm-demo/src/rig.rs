//! A scene with its switches: lights, effects, and the resulting input of the renderer.

use crate::{
    format::Format,
    light::hex_of,
    refusal::Refusal,
    scene_state::{SceneLightState, SwitchState},
};
use luminaire::{
    Error,
    dynamic::{AnyLight, Effect, Effects, RenderPlan},
    haze::Haze,
    projector::Fixture,
};
use luminaire_render::{
    Camera, Display, Scene,
    scenes::{MovingLight, Setup},
};

/// The effects that have a switch, with the label of each switch.
const SWITCHABLE: [(Effect, &str); 5] = [
    (Effect::Specular, "highlights"),
    (Effect::Gobo, "gobos"),
    (Effect::Shadow, "shadows"),
    (Effect::Haze, "haze"),
    (Effect::Dither, "dither"),
];

/// Side in texels of the shadow maps that a visitor adds, and the largest number of lights with
/// such maps.
const SHADOW_SIDE: u16 = 512;
const SHADOWS: usize = 16;

/// Density of the haze that a visitor adds: share of the light scattered per metre.
const HAZE: f32 = 0.05;

/// Times in seconds at which a scene is sampled to find out whether anything in it moves.
const LOOKS: [f32; 4] = [0.3, 1.1, 2.7, 6.0];

/// A scene, its fixtures, and the state of its switches.
#[derive(Clone, Debug)]
pub(crate) struct Rig {
    setup: Setup,
    /// The scene, without effects that are switched off.
    scene: Scene,
    /// The fixtures, without effects that are switched off.
    fixtures: Vec<MovingLight>,
    /// Which lights are on.
    on: Vec<bool>,
    /// The switched effects and their new states.
    switched: Vec<(Effect, bool)>,
    /// Side in texels of the shadow maps that are added to lights without shadows of their own.
    shadow_side: u16,
    /// The effects that the original scene needs.
    effects: Effects,
}

impl Rig {
    /// A scene in its original state: all lights on, no effect switched.
    pub(crate) fn new(setup: Setup) -> Result<Self, Error> {
        let mut rig = Self {
            scene: setup.scene.clone(),
            fixtures: setup.fixtures.clone(),
            on: vec![true; setup.fixtures.len()],
            setup,
            switched: Vec::new(),
            shadow_side: SHADOW_SIDE,
            effects: Effects::NONE,
        };
        rig.effects = rig.plan(&rig.fixtures_at(0.0)?).effects();
        Ok(rig)
    }

    /// Gives every light that can cast shadows a shadow map of `side` x `side` texels.
    pub(crate) fn add_shadows(&mut self, side: u16) -> Result<(), Error> {
        self.shadow_side = side;
        self.put(Effect::Shadow, true)?;
        self.fixtures_at(0.0).map(drop)
    }

    /// The scene with its switches applied.
    pub(crate) fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Returns the scene's own camera at a time in seconds.
    pub(crate) fn camera_at(&self, seconds: f32) -> Camera {
        self.setup.camera_at(seconds)
    }

    /// Returns the fixtures at a time in seconds. A fixture that is switched off stays in the list
    /// as a dark one, so that the others keep their indices.
    pub(crate) fn fixtures_at(&self, seconds: f32) -> Result<Vec<Fixture>, Error> {
        let at = |(moving, &on): (&MovingLight, &bool)| {
            let fixture = moving.at(seconds)?;
            Ok(if on { fixture } else { darkened(fixture.light())?.into() })
        };
        self.fixtures.iter().zip(&self.on).map(at).collect()
    }

    /// Returns the plan of the effects that the scene and these fixtures need.
    pub(crate) fn plan(&self, fixtures: &[Fixture]) -> RenderPlan {
        let plan = fixtures.iter().fold(self.scene.plan(), RenderPlan::with_fixture);
        if self.has(Effect::Dither) { plan.with(Effect::Dither) } else { plan }
    }

    /// The display of the picture.
    pub(crate) fn display(&self) -> Display {
        if self.has(Effect::Dither) { Display::Rgb888Dithered } else { Display::Rgb888 }
    }

    /// Returns whether any light of the scene changes over time.
    pub(crate) fn moves(&self) -> bool {
        let fixtures = |seconds| self.setup.fixtures_at(seconds).ok();
        LOOKS.iter().any(|&seconds| fixtures(seconds) != fixtures(0.0))
    }

    /// Returns whether the camera moves by itself over time.
    pub(crate) fn camera_moves(&self) -> bool {
        LOOKS.iter().any(|&seconds| self.camera_at(seconds) != self.camera_at(0.0))
    }

    /// Checks whether a format can hold every light at a time in seconds.
    pub(crate) fn check(&self, format: Format, seconds: f32) -> Result<(), Refusal> {
        let fixtures = self.fixtures_at(seconds)?;
        for (light, (fixture, moving)) in fixtures.iter().zip(&self.setup.fixtures).enumerate() {
            let refused = |error| Refusal::SceneLight { format, light, name: moving.name, error };
            format.check_fixture(fixture).map_err(refused)?;
        }
        Ok(())
    }

    /// The lights with their switches.
    pub(crate) fn lights(&self) -> Result<Vec<SceneLightState>, Error> {
        let state = |(fixture, &on): (&MovingLight, &bool)| {
            let color = hex_of(fixture.at(0.0)?.light().color());
            Ok(SceneLightState { name: fixture.name.to_owned(), color, on })
        };
        self.setup.fixtures.iter().zip(&self.on).map(state).collect()
    }

    /// Switches a light on or off.
    pub(crate) fn switch_light(&mut self, light: usize, on: bool) -> Result<(), Refusal> {
        let count = self.on.len();
        *self.on.get_mut(light).ok_or(Refusal::Number { value: light, count })? = on;
        Ok(())
    }

    /// The effects that have a switch.
    pub(crate) fn switches(&self) -> Vec<SwitchState> {
        let state = |(effect, label): (Effect, &str)| SwitchState {
            effect: effect.name().to_owned(),
            label: label.to_owned(),
            offered: self.effects.has(effect) || self.takes(effect),
            on: self.has(effect),
        };
        SWITCHABLE.map(state).into()
    }

    /// Switches an effect on or off. An effect that the scene neither has nor can be given stays
    /// off.
    pub(crate) fn switch_effect(&mut self, name: &str, on: bool) -> Result<(), Refusal> {
        let Some((effect, _)) = SWITCHABLE.into_iter().find(|(effect, _)| effect.name() == name) else {
            return Err(Refusal::Name {
                parameter: "effect to switch",
                value: name.to_owned(),
                expected: "specular, gobo, shadow, haze or dither",
            });
        };
        if self.effects.has(effect) || self.takes(effect) {
            self.put(effect, on)?;
        }
        Ok(())
    }

    fn put(&mut self, effect: Effect, on: bool) -> Result<(), Error> {
        self.switched.retain(|&(other, _)| other != effect);
        self.switched.push((effect, on));
        self.refit()
    }

    /// Whether an effect is in the scene now.
    fn has(&self, effect: Effect) -> bool {
        let switched = self.switched.iter().find(|(other, _)| *other == effect);
        switched.map_or(self.effects.has(effect), |&(_, on)| on)
    }

    /// Returns whether an effect can be added to the scene: haze and dithering to every scene,
    /// shadows to a scene in which 1 to `SHADOWS` lights can cast them.
    fn takes(&self, effect: Effect) -> bool {
        let takers = || self.setup.fixtures.iter().filter(|fixture| takes_shadow(fixture)).count();
        match effect {
            Effect::Shadow => (1..=SHADOWS).contains(&takers()),
            Effect::Haze | Effect::Dither => true,
            _ => false,
        }
    }

    /// Rebuilds scene and fixtures from the switches.
    fn refit(&mut self) -> Result<(), Error> {
        self.scene = self.setup.scene.clone();
        if !self.has(Effect::Specular) {
            self.scene.repaint(|material| material.without_highlight());
        }
        if self.has(Effect::Haze) != self.effects.has(Effect::Haze) {
            let haze = if self.has(Effect::Haze) { Some(Haze::new(HAZE)?) } else { None };
            self.scene.set_haze(haze);
        }
        let has = |effect| self.has(effect);
        let adds_shadows = has(Effect::Shadow) && !self.effects.has(Effect::Shadow);
        let fit = |mut fixture: MovingLight| {
            if !has(Effect::Gobo) {
                fixture = fixture.without_gobo();
            }
            if !has(Effect::Shadow) {
                fixture = fixture.without_shadow();
            }
            if adds_shadows && takes_shadow(&fixture) {
                fixture = fixture.with_shadow(self.shadow_side);
            }
            fixture
        };
        self.fixtures = self.setup.fixtures.iter().copied().map(fit).collect();
        Ok(())
    }
}

/// Returns whether a fixture can cast shadows: it is a spotlight that is not too wide.
fn takes_shadow(fixture: &MovingLight) -> bool {
    fixture.with_shadow(SHADOW_SIDE).at(0.0).is_ok()
}

/// Returns the same light with intensity 0.
fn darkened(light: &AnyLight) -> Result<AnyLight, Error> {
    Ok(match *light {
        AnyLight::Directional(sun) => sun.with_intensity(0.0)?.into(),
        AnyLight::Point(point) => point.with_intensity(0.0)?.into(),
        AnyLight::Spot(spot) => spot.with_intensity(0.0)?.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire_render::scenes::Example;

    fn rig(example: Example) -> Rig {
        Rig::new(example.setup().unwrap()).unwrap()
    }

    fn effects(rig: &Rig) -> Effects {
        rig.plan(&rig.fixtures_at(0.0).unwrap()).effects()
    }

    #[test]
    fn a_light_that_is_switched_off_is_dark_and_keeps_its_number() {
        for example in Example::ALL {
            let mut rig = rig(example);
            let lit = rig.fixtures_at(1.0).unwrap();
            for light in 0..lit.len() {
                rig.switch_light(light, false).unwrap();
                let mut dark = rig.fixtures_at(1.0).unwrap();
                assert!(dark[light].light().is_dark() && !rig.lights().unwrap()[light].on);
                dark[light] = lit[light];
                assert_eq!(dark, lit, "light {light} of {example:?}");
                rig.switch_light(light, true).unwrap();
            }
            let refusal = rig.switch_light(lit.len(), false).unwrap_err().to_string();
            assert!(refusal.contains(&format!("light = {}", lit.len())), "{refusal}");
        }
    }

    #[test]
    fn an_effect_is_left_out_and_put_back_in() {
        for (example, effect) in [
            (Example::Turntable, Effect::Specular),
            (Example::Gallery, Effect::Specular),
            (Example::Show, Effect::Gobo),
            (Example::Show, Effect::Haze),
        ] {
            let mut rig = rig(example);
            let state = |rig: &Rig| {
                let switches = rig.switches().into_iter();
                let switch = switches.into_iter().find(|switch| switch.effect == effect.name()).unwrap();
                (switch.offered, switch.on)
            };
            let before = (effects(&rig), rig.fixtures_at(2.0).unwrap(), rig.scene().clone());
            assert_eq!(state(&rig), (true, true), "{example:?}");
            rig.switch_effect(effect.name(), false).unwrap();
            assert_eq!(state(&rig), (true, false), "{example:?}");
            assert!(before.0.has(effect) && !effects(&rig).has(effect), "{example:?}");
            assert_eq!(effects(&rig).with(effect), before.0);
            rig.switch_effect(effect.name(), true).unwrap();
            assert_eq!((effects(&rig), rig.fixtures_at(2.0).unwrap(), rig.scene().clone()), before);
        }
        let refusal = rig(Example::Show).switch_effect("spot", false).unwrap_err().to_string();
        assert!(refusal.contains("\"spot\"") && refusal.contains("specular"), "{refusal}");
    }

    #[test]
    fn a_scene_without_an_effect_offers_no_switch_for_it() {
        let offered = |example: Example| {
            let switches = rig(example).switches().into_iter().filter(|switch| switch.offered);
            switches.map(|switch| switch.effect).collect::<Vec<_>>().join(" ")
        };
        assert_eq!([Example::BareSpot, Example::Grid].map(offered), ["shadow haze dither", "haze dither"]);
        let mut rig = rig(Example::BareSpot);
        let before = effects(&rig);
        rig.switch_effect("gobo", true).unwrap();
        assert_eq!(effects(&rig), before);
    }

    #[test]
    fn a_scene_knows_what_moves_in_it() {
        assert!(!rig(Example::BareSpot).moves());
        for example in [Example::Grid, Example::Show, Example::Turntable] {
            assert!(rig(example).moves(), "{example:?} stands still");
        }
        assert!(rig(Example::Turntable).camera_moves() && !rig(Example::Grid).camera_moves());
    }

    #[test]
    fn haze_and_dither_are_added() {
        let mut rig = rig(Example::BareSpot);
        let before = (effects(&rig), rig.scene().clone());
        assert_eq!((rig.scene().haze(), rig.display()), (None, Display::Rgb888));
        for effect in [Effect::Haze, Effect::Dither] {
            rig.switch_effect(effect.name(), true).unwrap();
            assert!(effects(&rig).has(effect), "{effect:?}");
        }
        assert!(rig.scene().haze().is_some() && rig.display().is_dithered());
        for effect in [Effect::Haze, Effect::Dither] {
            rig.switch_effect(effect.name(), false).unwrap();
        }
        assert_eq!((effects(&rig), rig.scene().clone()), before);
    }

    #[test]
    fn shadows_are_added_and_taken_away() {
        let mut rig = rig(Example::Turntable);
        let before = (effects(&rig), rig.fixtures_at(1.0).unwrap());
        assert!(!before.0.has(Effect::Shadow));
        rig.switch_effect("shadow", true).unwrap();
        let sides = |rig: &Rig| -> Vec<_> {
            rig.fixtures_at(1.0)
                .unwrap()
                .iter()
                .map(|fixture| fixture.shadow().map(|(side, _)| side))
                .collect()
        };
        assert!(effects(&rig).has(Effect::Shadow));
        assert_eq!(sides(&rig), [Some(SHADOW_SIDE); 8]);
        rig.switch_effect("shadow", false).unwrap();
        assert_eq!((effects(&rig), rig.fixtures_at(1.0).unwrap()), before);
        rig.add_shadows(64).unwrap();
        assert_eq!(sides(&rig), [Some(64); 8]);
        assert!(rig.add_shadows(5).is_err());
    }
}
