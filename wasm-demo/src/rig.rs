//! A scene with its switches: which lamps are on, which effects are left out, and so what the renderer is given.

use crate::{
    format::Format,
    light::hex_of,
    refusal::Refusal,
    scene_state::{LampState, SwitchState},
};
use luminaire::{Effect, Effects, Error, Lamp, Luminaire, Plan};
use luminaire_render::{
    Camera, Material, Scene,
    examples::{Fixture, Setup},
};

/// The effects that have a switch, with the words for it.
const SWITCHABLE: [(Effect, &str); 3] =
    [(Effect::Specular, "highlights"), (Effect::Gobo, "gobos"), (Effect::Shadow, "shadows")];

/// The side in texels of a shadow map that a visitor asks for, and for how many lamps there may be such maps.
const SHADOW_SIDE: u16 = 512;
const SHADOWS: usize = 16;

/// Seconds at which a scene is looked at to find out whether anything in it moves.
const LOOKS: [f32; 4] = [0.3, 1.1, 2.7, 6.0];

/// A scene, the luminaires above it, and what of both is switched off.
#[derive(Clone, Debug)]
pub(crate) struct Rig {
    setup: Setup,
    /// What stands there, without what is left out.
    scene: Scene,
    /// The luminaires, without what is left out.
    fixtures: Vec<Fixture>,
    /// Which lamps are on.
    on: Vec<bool>,
    left_out: Vec<Effect>,
    /// The side of the shadow maps of lamps that throw no shadows by themselves; nothing where they shall not.
    added_shadows: Option<u16>,
    /// What the scene calls for as it was made.
    effects: Effects,
}

impl Rig {
    /// A scene as it was made: all lamps on, nothing left out, nothing added.
    pub(crate) fn new(setup: Setup) -> Result<Self, Error> {
        let mut rig = Self {
            scene: setup.scene.clone(),
            fixtures: setup.fixtures.clone(),
            on: vec![true; setup.fixtures.len()],
            setup,
            left_out: Vec::new(),
            added_shadows: None,
            effects: Effects::NONE,
        };
        rig.effects = rig.plan(&rig.luminaires_at(0.0)?).effects();
        Ok(rig)
    }

    /// Gives every lamp shadows that can have them, by maps of so many texels a side.
    pub(crate) fn add_shadows(&mut self, side: u16) -> Result<(), Error> {
        self.added_shadows = Some(side);
        self.refit();
        self.luminaires_at(0.0).map(drop)
    }

    /// What stands there.
    pub(crate) fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The scene's own camera after so many seconds.
    pub(crate) fn camera_at(&self, seconds: f32) -> Camera {
        self.setup.camera_at(seconds)
    }

    /// The luminaires after so many seconds. One that is switched off is there, and dark, so that the others keep
    /// their numbers.
    pub(crate) fn luminaires_at(&self, seconds: f32) -> Result<Vec<Luminaire>, Error> {
        let luminaire = |(fixture, &on): (&Fixture, &bool)| {
            let luminaire = fixture.at(seconds)?;
            Ok(if on { luminaire } else { darkened(luminaire.lamp())?.into() })
        };
        self.fixtures.iter().zip(&self.on).map(luminaire).collect()
    }

    /// Which effects these luminaires and what stands there call for.
    pub(crate) fn plan(&self, luminaires: &[Luminaire]) -> Plan {
        let mut plan = luminaires.iter().fold(Plan::new(), Plan::with_luminaire);
        if self.scene.ambient() != Default::default() {
            plan = plan.with(Effect::Ambient);
        }
        if self.scene.materials().any(Material::shines) {
            plan = plan.with(Effect::Specular);
        }
        plan
    }

    /// Whether a lamp changes as the seconds pass.
    pub(crate) fn moves(&self) -> Result<bool, Error> {
        let rest = self.setup.luminaires_at(0.0)?;
        for seconds in LOOKS {
            if self.setup.luminaires_at(seconds)? != rest {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether the camera moves by itself as the seconds pass.
    pub(crate) fn camera_moves(&self) -> bool {
        LOOKS.iter().any(|&seconds| self.camera_at(seconds) != self.camera_at(0.0))
    }

    /// Whether a format can hold every lamp as it is after so many seconds.
    pub(crate) fn check(&self, format: Format, seconds: f32) -> Result<(), Refusal> {
        let luminaires = self.luminaires_at(seconds)?;
        for (lamp, (luminaire, fixture)) in luminaires.iter().zip(&self.setup.fixtures).enumerate() {
            let refused = |error| Refusal::Lamp { format, lamp, name: fixture.name, error };
            format.check_luminaire(luminaire).map_err(refused)?;
        }
        Ok(())
    }

    /// The lamps with their switches.
    pub(crate) fn lamps(&self) -> Result<Vec<LampState>, Error> {
        let state = |(fixture, &on): (&Fixture, &bool)| {
            let color = hex_of(fixture.at(0.0)?.lamp().color());
            Ok(LampState { name: fixture.name.to_owned(), color, on })
        };
        self.setup.fixtures.iter().zip(&self.on).map(state).collect()
    }

    /// Switches a lamp on or off.
    pub(crate) fn switch_lamp(&mut self, lamp: usize, on: bool) -> Result<(), Refusal> {
        let count = self.on.len();
        *self.on.get_mut(lamp).ok_or(Refusal::Number { value: lamp, count })? = on;
        Ok(())
    }

    /// The effects that have a switch.
    pub(crate) fn switches(&self) -> Vec<SwitchState> {
        let state = |(effect, label): (Effect, &str)| SwitchState {
            effect: effect.name().to_owned(),
            label: label.to_owned(),
            offered: self.effects.has(effect) || (effect == Effect::Shadow && self.takes_shadows()),
            on: self.has(effect),
        };
        SWITCHABLE.map(state).into()
    }

    /// Leaves an effect out, or puts it in. What a scene has not stays out of it, but for shadows.
    pub(crate) fn switch_effect(&mut self, name: &str, on: bool) -> Result<(), Refusal> {
        let Some((effect, _)) = SWITCHABLE.into_iter().find(|(effect, _)| effect.name() == name) else {
            return Err(Refusal::Name {
                parameter: "effect to switch",
                value: name.to_owned(),
                remedy: "give specular, gobo or shadow",
            });
        };
        self.left_out.retain(|&other| other != effect);
        if !on {
            self.left_out.push(effect);
        }
        if effect == Effect::Shadow && !self.effects.has(effect) {
            self.added_shadows = (on && self.takes_shadows()).then_some(SHADOW_SIDE);
        }
        self.refit();
        Ok(())
    }

    /// Whether an effect of the scene is there now.
    fn has(&self, effect: Effect) -> bool {
        let is_added = effect == Effect::Shadow && self.added_shadows.is_some();
        is_added || (self.effects.has(effect) && !self.left_out.contains(&effect))
    }

    /// Whether there are lamps that can throw shadows, and not too many of them.
    fn takes_shadows(&self) -> bool {
        (1..=SHADOWS).contains(&self.setup.fixtures.iter().filter(|fixture| takes_shadow(fixture)).count())
    }

    /// Makes scene and luminaires of what is left in.
    fn refit(&mut self) {
        self.scene = self.setup.scene.clone();
        if !self.has(Effect::Specular) {
            self.scene.repaint(|material| Material::new(material.albedo));
        }
        let (gobos, shadows, added) = (self.has(Effect::Gobo), self.has(Effect::Shadow), self.added_shadows);
        self.fixtures = self.setup.fixtures.clone();
        for fixture in &mut self.fixtures {
            if !gobos {
                *fixture = fixture.without_gobo();
            }
            if !shadows {
                *fixture = fixture.without_shadow();
            }
            if let Some(side) = added.filter(|_| takes_shadow(fixture)) {
                *fixture = fixture.with_shadow(side);
            }
        }
    }
}

/// Whether the lamp of a fixture can throw shadows: a spotlight that is not too wide.
fn takes_shadow(fixture: &Fixture) -> bool {
    fixture.with_shadow(SHADOW_SIDE).at(0.0).is_ok()
}

/// The lamp without its light.
fn darkened(lamp: &Lamp) -> Result<Lamp, Error> {
    Ok(match *lamp {
        Lamp::Directional(light) => light.with_intensity(0.0)?.into(),
        Lamp::Point(light) => light.with_intensity(0.0)?.into(),
        Lamp::Spot(light) => light.with_intensity(0.0)?.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire_render::examples::Example;

    fn rig(example: Example) -> Rig {
        Rig::new(example.setup().unwrap()).unwrap()
    }

    fn effects(rig: &Rig) -> Effects {
        rig.plan(&rig.luminaires_at(0.0).unwrap()).effects()
    }

    #[test]
    fn a_lamp_that_is_switched_off_is_dark_and_keeps_its_number() {
        for example in Example::ALL {
            let mut rig = rig(example);
            let lit = rig.luminaires_at(1.0).unwrap();
            for lamp in 0..lit.len() {
                rig.switch_lamp(lamp, false).unwrap();
                let mut dark = rig.luminaires_at(1.0).unwrap();
                assert!(dark[lamp].lamp().is_dark() && !rig.lamps().unwrap()[lamp].on);
                dark[lamp] = lit[lamp];
                assert_eq!(dark, lit, "lamp {lamp} of {example:?}");
                rig.switch_lamp(lamp, true).unwrap();
            }
            let refusal = rig.switch_lamp(lit.len(), false).unwrap_err().to_string();
            assert!(refusal.contains(&format!("light {}", lit.len())), "{refusal}");
        }
    }

    #[test]
    fn an_effect_is_left_out_and_put_back_in() {
        for (example, effect) in [
            (Example::Turntable, Effect::Specular),
            (Example::Gallery, Effect::Specular),
            (Example::Show, Effect::Gobo),
        ] {
            let mut rig = rig(example);
            let state = |rig: &Rig| {
                let switches = rig.switches().into_iter();
                let switch = switches.into_iter().find(|switch| switch.effect == effect.name()).unwrap();
                (switch.offered, switch.on)
            };
            let before = (effects(&rig), rig.luminaires_at(2.0).unwrap(), rig.scene().clone());
            assert_eq!(state(&rig), (true, true), "{example:?}");
            rig.switch_effect(effect.name(), false).unwrap();
            assert_eq!(state(&rig), (true, false), "{example:?}");
            assert!(before.0.has(effect) && !effects(&rig).has(effect), "{example:?}");
            assert_eq!(effects(&rig).with(effect), before.0);
            rig.switch_effect(effect.name(), true).unwrap();
            assert_eq!((effects(&rig), rig.luminaires_at(2.0).unwrap(), rig.scene().clone()), before);
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
        assert_eq!([Example::BareSpot, Example::Grid].map(offered), ["shadow", ""]);
        let mut rig = rig(Example::BareSpot);
        let before = effects(&rig);
        rig.switch_effect("gobo", true).unwrap();
        assert_eq!(effects(&rig), before);
    }

    #[test]
    fn a_scene_knows_what_moves_in_it() {
        assert!(!rig(Example::BareSpot).moves().unwrap());
        for example in [Example::Grid, Example::Show, Example::Turntable] {
            assert!(rig(example).moves().unwrap(), "{example:?} stands still");
        }
        assert!(rig(Example::Turntable).camera_moves() && !rig(Example::Grid).camera_moves());
    }

    #[test]
    fn shadows_are_added_and_taken_away() {
        let mut rig = rig(Example::Turntable);
        let before = (effects(&rig), rig.luminaires_at(1.0).unwrap());
        assert!(!before.0.has(Effect::Shadow));
        rig.switch_effect("shadow", true).unwrap();
        let sides = |rig: &Rig| -> Vec<_> {
            rig.luminaires_at(1.0).unwrap().iter().map(|lamp| lamp.shadow().map(|(side, _)| side)).collect()
        };
        assert!(effects(&rig).has(Effect::Shadow));
        assert_eq!(sides(&rig), [Some(SHADOW_SIDE); 8]);
        rig.switch_effect("shadow", false).unwrap();
        assert_eq!((effects(&rig), rig.luminaires_at(1.0).unwrap()), before);
        rig.add_shadows(64).unwrap();
        assert_eq!(sides(&rig), [Some(64); 8]);
        assert!(rig.add_shadows(5).is_err());
    }
}
