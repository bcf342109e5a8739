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

/// The effects that can be left out of a scene, with the words for their switches.
const SWITCHABLE: [(Effect, &str); 2] = [(Effect::Specular, "highlights"), (Effect::Gobo, "gobos")];

/// Seconds at which a scene is looked at to find out whether anything in it moves.
const LOOKS: [f32; 4] = [0.3, 1.1, 2.7, 6.0];

/// A scene, the luminaires above it, and what of both is switched off.
#[derive(Clone, Debug)]
pub(crate) struct Rig {
    setup: Setup,
    /// What stands there, without what is left out.
    scene: Scene,
    /// Which lamps are on.
    on: Vec<bool>,
    left_out: Vec<Effect>,
    /// What the scene calls for with all switches on.
    effects: Effects,
}

impl Rig {
    /// A scene with all of its switches on.
    pub(crate) fn new(setup: Setup) -> Result<Self, Error> {
        let (scene, on) = (setup.scene.clone(), vec![true; setup.fixtures.len()]);
        let mut rig = Self { setup, scene, on, left_out: Vec::new(), effects: Effects::NONE };
        rig.effects = rig.plan(&rig.luminaires_at(0.0)?).effects();
        Ok(rig)
    }

    /// Gives every spotlight shadows, by maps of so many texels a side.
    pub(crate) fn add_shadows(&mut self, side: u16) -> Result<(), Error> {
        for fixture in &mut self.setup.fixtures {
            if matches!(fixture.at(0.0)?.lamp(), Lamp::Spot(_)) {
                *fixture = fixture.with_shadow(side);
            }
        }
        *self = Self::new(self.setup.clone())?;
        Ok(())
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
        let fixtures = self.setup.fixtures.iter().zip(&self.on);
        fixtures.map(|(fixture, &on)| self.luminaire_at(fixture, on, seconds)).collect()
    }

    fn luminaire_at(&self, fixture: &Fixture, on: bool, seconds: f32) -> Result<Luminaire, Error> {
        let luminaire = fixture.at(seconds)?;
        if !on {
            return Ok(darkened(luminaire.lamp())?.into());
        }
        if self.leaves_out(Effect::Gobo) && luminaire.gobo().is_some() {
            let bare = Luminaire::from(*luminaire.lamp());
            return luminaire.shadow().map_or(Ok(bare), |(side, _)| bare.with_shadow(side));
        }
        Ok(luminaire)
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

    /// The effects that can be left out, with their switches.
    pub(crate) fn switches(&self) -> Vec<SwitchState> {
        let state = |(effect, label): (Effect, &str)| SwitchState {
            effect: effect.name().to_owned(),
            label: label.to_owned(),
            offered: self.effects.has(effect),
            on: !self.leaves_out(effect),
        };
        SWITCHABLE.map(state).into()
    }

    /// Leaves an effect out, or puts it back in.
    pub(crate) fn switch_effect(&mut self, name: &str, on: bool) -> Result<(), Refusal> {
        let Some((effect, _)) = SWITCHABLE.into_iter().find(|(effect, _)| effect.name() == name) else {
            return Err(Refusal::Name {
                parameter: "effect to leave out",
                value: name.to_owned(),
                remedy: "give specular or gobo",
            });
        };
        self.left_out.retain(|&other| other != effect);
        if !on {
            self.left_out.push(effect);
        }
        self.scene = self.setup.scene.clone();
        if self.leaves_out(Effect::Specular) {
            self.scene.repaint(|material| Material::new(material.albedo));
        }
        Ok(())
    }

    fn leaves_out(&self, effect: Effect) -> bool {
        self.left_out.contains(&effect)
    }
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
    fn an_effect_that_is_left_out_is_not_called_for() {
        let offered = |example: Example| {
            let switches = rig(example).switches();
            switches
                .into_iter()
                .filter(|switch| switch.offered)
                .map(|switch| switch.effect)
                .collect::<Vec<_>>()
        };
        assert_eq!(offered(Example::BareSpot), Vec::<String>::new());
        for (example, effect) in [(Example::Turntable, Effect::Specular), (Example::Show, Effect::Gobo)] {
            assert!(offered(example).iter().any(|name| name == effect.name()), "{example:?}");
            let mut rig = rig(example);
            let before = (effects(&rig), rig.luminaires_at(2.0).unwrap(), rig.scene().clone());
            rig.switch_effect(effect.name(), false).unwrap();
            assert!(
                before.0.has(effect) && effects(&rig).with(effect) == before.0 && !effects(&rig).has(effect)
            );
            rig.switch_effect(effect.name(), true).unwrap();
            assert_eq!((effects(&rig), rig.luminaires_at(2.0).unwrap(), rig.scene().clone()), before);
        }
        let refusal = rig(Example::Show).switch_effect("spot", false).unwrap_err().to_string();
        assert!(refusal.contains("\"spot\"") && refusal.contains("specular"), "{refusal}");
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
    fn every_spotlight_takes_a_shadow() {
        let mut rig = rig(Example::Turntable);
        assert!(!effects(&rig).has(Effect::Shadow));
        rig.add_shadows(512).unwrap();
        let luminaires = rig.luminaires_at(1.0).unwrap();
        assert!(luminaires.iter().all(|luminaire| luminaire.shadow().is_some()));
        assert!(effects(&rig).has(Effect::Shadow) && rig.add_shadows(5).is_err());
    }
}
