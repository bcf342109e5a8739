//! A scene with the visitor's settings: the input of the renderer.

use crate::{
    decimal::read,
    kind::{AnySpot, kept},
    refusal::Refusal,
    setting::Setting,
    state::{SWITCHABLE, State},
    viewpoint::Reach,
};
use luminaire::{
    Angle, Cone, Error, Rgb, SpotLight, Vec3,
    attenuation::InverseSquare,
    dynamic::{AnyLight, Effect, Effects, RenderPlan},
    falloff::Soft,
    haze::Haze,
    projector::Fixture,
};
use luminaire_render::{
    Camera, Display, Scene, Surfaces,
    scenes::{MovingLight, Setup},
};
use std::{cell::OnceCell, rc::Rc};

/// Side in texels of the shadow maps that a visitor adds, and the largest number of lights with
/// such maps.
const SHADOW_SIDE: u16 = 512;
const SHADOWS: usize = 16;

/// Density of the haze that a visitor adds: share of the light scattered per metre.
const HAZE: f32 = 0.05;

/// The field angle of a light that a visitor adds, in degrees.
const FIELD: f32 = 30.0;

/// The distance in metres at which a beam ends that no surface stops.
pub(crate) const FARTHEST: f32 = 30.0;

/// Times in seconds at which a scene is sampled to find out whether anything in it moves.
const LOOKS: [f32; 4] = [0.3, 1.1, 2.7, 6.0];

/// A scene and its fixtures, as a state has them.
#[derive(Clone, Debug)]
pub(crate) struct Rig {
    /// The original scene.
    setup: Rc<Setup>,
    /// The effects that the original scene needs.
    effects: Effects,
    /// Whether the lights and the camera of the original scene change over time.
    moves: [bool; 2],
    scene: Rc<Scene>,
    fixtures: Vec<MovingLight>,
    /// The light that a visitor adds, before its settings. Its number follows those of the scene.
    added: MovingLight,
    /// The lights of the scene and the added one as spotlights with their throws, once found.
    hung: Rc<[OnceCell<(AnySpot, f32)>]>,
    /// The settings of effects, exposure and highlights that `scene` has.
    fitted: ([Option<bool>; SWITCHABLE.len()], f32, [&'static str; 2]),
    /// Side in texels of the shadow maps that are added to lights without shadows of their own.
    shadow_side: u16,
}

impl Rig {
    /// A scene as it was composed.
    pub(crate) fn new(setup: Setup) -> Result<Self, Error> {
        let mut rig = Self {
            moves: moves(&setup),
            scene: Rc::new(setup.scene.clone()),
            fixtures: setup.fixtures.clone(),
            added: added(&setup)?,
            hung: (0..=setup.fixtures.len()).map(|_| OnceCell::new()).collect(),
            setup: Rc::new(setup),
            effects: Effects::NONE,
            fitted: ([None; SWITCHABLE.len()], 0.0, ["own"; 2]),
            shadow_side: SHADOW_SIDE,
        };
        rig.effects = rig.plan(&rig.fixtures_at(0.0)?).effects();
        if rig.effects.has(Effect::Shadow) {
            rig.added = rig.added.with_shadow(SHADOW_SIDE);
        }
        Ok(rig)
    }

    /// The same scene with added shadow maps of `side` x `side` texels.
    pub(crate) fn with_shadow_side(self, side: u16) -> Self {
        Self { shadow_side: side, ..self }
    }

    /// The same scene with the settings of a state.
    ///
    /// # Errors
    /// A setting that a light or the state's number format can't have.
    pub(crate) fn fitted(&self, state: &State) -> Result<Self, Refusal> {
        let fixtures =
            state.lights.iter().map(|setting| self.fixture(state, setting)).collect::<Result<Vec<_>, _>>()?;
        for (light, fixture) in fixtures.iter().enumerate() {
            check(state, light, fixture)?;
        }
        let fitted = (state.switched, state.exposure, [state.shininess, state.highlight]);
        let is_kept = self.fitted == fitted;
        let scene = if is_kept {
            Rc::clone(&self.scene)
        } else {
            self.scene_of(state, state.exposure.exp2())?.into()
        };
        Ok(Self { scene, fixtures, fitted, ..self.clone() })
    }

    /// Checks whether a light of a state can have a setting.
    pub(crate) fn accept(&self, state: &State, light: usize, setting: &Setting) -> Result<(), Refusal> {
        check(state, light, &self.fixture(state, setting)?)
    }

    /// A light with its setting and the effects of a state.
    pub(crate) fn fixture(&self, state: &State, setting: &Setting) -> Result<MovingLight, Refusal> {
        let has = |effect| self.has(state, effect);
        let mut fixture = setting.applied(&self.original(setting)?, state.exposure.exp2())?;
        if !has(Effect::Gobo) {
            fixture = fixture.without_gobo();
        }
        if !has(Effect::Shadow) {
            fixture = fixture.without_shadow();
        } else if !self.effects.has(Effect::Shadow) && takes_shadow(&fixture) {
            fixture = fixture.with_shadow(self.shadow_side);
        }
        Ok(fixture)
    }

    /// The scene without the effects that are switched off, and with those that are added.
    fn scene_of(&self, state: &State, gain: f32) -> Result<Scene, Error> {
        let mut scene = self.setup.scene.clone();
        scene.set_ambient(scene.ambient().map(|channel| gain * channel))?;
        let [shininess, strength] = [state.shininess, state.highlight].map(read);
        scene.repaint(|material| {
            let color = strength.map_or(material.specular(), |share| Rgb::new(share, share, share));
            let shininess = shininess.map_or(material.shininess(), |exponent| exponent as u32);
            // The choices are within what a material takes.
            material.with_highlight(color, shininess).unwrap_or(*material)
        });
        if !self.has(state, Effect::Specular) {
            scene.repaint(|material| material.without_highlight());
        }
        let has_haze = self.has(state, Effect::Haze);
        if has_haze != self.effects.has(Effect::Haze) {
            scene.set_haze(if has_haze { Some(Haze::new(HAZE)?) } else { None });
        }
        Ok(scene)
    }

    /// The scene with its switches applied.
    pub(crate) fn scene(&self) -> &Scene {
        &self.scene
    }

    /// How many lights the original scene has.
    pub(crate) fn lights(&self) -> usize {
        self.setup.fixtures.len()
    }

    /// A light of the original scene, or the light that a visitor adds, in the kind and with the law
    /// of a setting: see [`Setting::turned`]. Without a cone it has no gobo, no shadows and no sweep.
    pub(crate) fn original(&self, setting: &Setting) -> Result<MovingLight, Refusal> {
        let lights = &self.setup.fixtures;
        let added = (setting.of == lights.len()).then_some(&self.added);
        let own = lights.get(setting.of).or(added);
        let own = own.ok_or_else(|| Refusal::light(setting.of, lights.len() + 1))?;
        if (setting.kind, setting.law) == (None, None) {
            return Ok(*own);
        }
        let light = setting.turned(own.light(), self.hung(setting.of, own.light())?)?;
        let fixture = own.with_light(light);
        let is_spot = matches!(light, AnyLight::Spot(_));
        Ok(if is_spot { fixture } else { fixture.aimed().without_gobo().without_shadow() })
    }

    /// Returns a light of the scene as a spotlight, and its throw in metres. A point light aims at the
    /// camera's target; a directional one shines on it from as far as the camera, or below a ceiling.
    fn hung(&self, light: usize, own: &AnyLight) -> Result<(AnySpot, f32), Refusal> {
        if let Some(found) = self.hung[light].get() {
            return Ok(*found);
        }
        let target = self.setup.camera.target();
        let cone = Cone::from_field(Soft.into(), Angle::degrees(FIELD))?;
        let spot = match own {
            AnyLight::Spot(spot) => *spot,
            AnyLight::Point(point) => {
                let way = target.zip(point.position(), |to, from| to - from);
                SpotLight::new(point.position(), way, cone)?.with_attenuation(point.attenuation())
            }
            AnyLight::Measured(light) => SpotLight::new(light.position(), light.given_axis(), cone)?
                .with_attenuation(light.attenuation()),
            AnyLight::Directional(sun) => {
                let free = Surfaces::of(&self.setup.scene).first(target, sun.given_direction());
                let distance = self.setup.camera.distance().min(0.9 * free.unwrap_or(FARTHEST));
                let position = target.zip(sun.given_direction(), |to, toward| to + distance * toward);
                SpotLight::new(position, sun.direction(), cone)?.with_attenuation(InverseSquare.into())
            }
        };
        Ok(*self.hung[light].get_or_init(|| (spot, self.throw(&spot))))
    }

    /// Returns the distance in metres at which the axis of a spotlight meets a surface.
    fn throw(&self, spot: &AnySpot) -> f32 {
        Surfaces::of(&self.setup.scene).first(spot.position(), spot.axis()).unwrap_or(FARTHEST)
    }

    /// Keeps the irradiance at the throw of a light whose kind or law has changed.
    pub(crate) fn keep_light(&self, before: &Setting, after: &mut Setting) -> Result<(), Refusal> {
        // The intensity of the scene follows by itself.
        let is_own = (after.intensity, after.position, after.target) == (None, None, None);
        if !is_own
            && (before.kind, before.law) != (after.kind, after.law)
            && let AnyLight::Spot(hung) = self.on(&Setting { kind: Some(Effect::Spot), ..*before })?.light()
        {
            // The intensity of a setting is that of white.
            let [before, now] = [Setting { kelvin: None, ..*before }, Setting { kelvin: None, ..*after }];
            let [before, now] = [self.on(&before)?, self.on(&now)?];
            after.intensity = Some(kept(before.light(), now.light(), self.throw(hung)));
        }
        Ok(())
    }

    /// Returns a light as the visitor has set it: switched on, at an exposure of 0 stops.
    pub(crate) fn on(&self, setting: &Setting) -> Result<MovingLight, Refusal> {
        Setting { is_on: true, ..*setting }.applied(&self.original(setting)?, 1.0)
    }

    /// Returns the scene's own camera at a time in seconds.
    pub(crate) fn camera_at(&self, seconds: f32) -> Camera {
        self.setup.camera_at(seconds)
    }

    /// Returns the camera of a state.
    pub(crate) fn camera_of(&self, state: &State) -> Camera {
        state.viewpoint.of(self.camera_at(state.seconds[1]), Reach::of(state.scene))
    }

    /// Returns the fixtures at a time in seconds. A fixture that is switched off stays in the list
    /// as a dark one, so that the others keep their indices.
    pub(crate) fn fixtures_at(&self, seconds: f32) -> Result<Vec<Fixture>, Error> {
        self.fixtures.iter().map(|fixture| fixture.at(seconds)).collect()
    }

    /// Returns a light of a state as the visitor describes it: switched on, at an exposure of 0 stops,
    /// and where its movement begins.
    pub(crate) fn described(&self, state: &State, light: usize) -> Result<AnyLight, Refusal> {
        let count = state.lights.len();
        let setting = state.lights.get(light).ok_or_else(|| Refusal::light(light, count))?;
        let on = self.on(setting)?;
        Ok(if on.sweeps() { *on.at(0.0)?.light() } else { *on.light() })
    }

    /// Returns the plan of the effects that the scene and these fixtures need.
    pub(crate) fn plan(&self, fixtures: &[Fixture]) -> RenderPlan {
        fixtures.iter().fold(self.scene.plan(), RenderPlan::with_fixture)
    }

    /// The display of the picture.
    pub(crate) fn display(&self, state: &State) -> Display {
        let is_dithered = self.has(state, Effect::Dither);
        Display { output: state.output, is_dithered, keeps_hue: state.keeps_hue }
    }

    /// Returns whether the lights and the camera of the scene change over time.
    pub(crate) fn moves(&self) -> [bool; 2] {
        self.moves
    }

    /// Returns whether an effect is in the picture of a state. An effect that the scene neither has
    /// nor can be given stays off.
    pub(crate) fn has(&self, state: &State, effect: Effect) -> bool {
        // Dither costs nothing, and most scenes show bands without it.
        let is_added = matches!(effect, Effect::Dither | Effect::Specular) && self.offers(state, effect);
        let own = self.effects.has(effect) || is_added;
        state.switched(effect).filter(|_| self.offers(state, effect)).unwrap_or(own)
    }

    /// Returns whether the switch of an effect is enabled: the scene has the effect, or it can be
    /// added. Haze and dithering can be added to every scene, shadows to a scene in which 1 to
    /// `SHADOWS` lights can cast them, and highlights by their strength.
    pub(crate) fn offers(&self, state: &State, effect: Effect) -> bool {
        let takers = || self.setup.fixtures.iter().filter(|fixture| takes_shadow(fixture)).count();
        self.effects.has(effect)
            || match effect {
                Effect::Shadow => (1..=SHADOWS).contains(&takers()),
                Effect::Haze | Effect::Dither => true,
                Effect::Specular => state.highlight != "own",
                _ => false,
            }
    }
}

/// Checks whether the number formats of a state can hold a light at its time.
fn check(state: &State, light: usize, moving: &MovingLight) -> Result<(), Refusal> {
    let fixture = moving.at(state.seconds[0])?;
    [Some(state.format), state.other].into_iter().flatten().try_for_each(|format| {
        let (format_name, number, name) = (format.label(), light + 1, moving.name);
        let refused = |error| Refusal(format!("{format_name} cannot hold light {number}, {name}: {error}"));
        format.check_fixture(&fixture).map_err(refused)
    })
}

/// Returns whether the lights and the camera of a scene change over time.
fn moves(setup: &Setup) -> [bool; 2] {
    let lights = |seconds| setup.fixtures_at(seconds).ok();
    [
        LOOKS.iter().any(|&seconds| lights(seconds) != lights(0.0)),
        LOOKS.iter().any(|&seconds| setup.camera_at(seconds) != setup.camera_at(0.0)),
    ]
}

/// Returns a place in the upper part of a camera's picture, nearer than its middle, and the middle:
/// position and target of a light that a visitor adds. `place` is in shares of the width and the height
/// of a square picture, and no surface lies between it and the eye.
pub(crate) fn place_in_view(scene: &Scene, camera: &Camera, place: [f32; 2]) -> [Vec3<f32>; 2] {
    let (eye, distance) = (camera.eye(), camera.distance());
    let [middle, top, toward] = [[0.5, 0.5], [0.5, 0.0], place].map(|place| camera.toward(place, 1.0));
    let up = top.zip(middle, |top, middle| distance * (top - middle));
    let nearer = distance - 0.7 * up.dot(up).sqrt();
    let free = Surfaces::of(scene).first(eye, toward).map_or(nearer, |depth| 0.9 * depth);
    [(nearer.min(free), toward), (distance, middle)]
        .map(|(depth, toward)| eye.zip(toward, |eye, toward| eye + depth * toward))
}

/// Returns a spotlight that aims at the middle of a scene's picture and lights it to full scale.
fn added(setup: &Setup) -> Result<MovingLight, Error> {
    let [position, target] = place_in_view(&setup.scene, &setup.camera, [0.5, 0.15]);
    let way = target.zip(position, |to, from| to - from);
    let spot = SpotLight::new(position, way, Cone::from_field(Soft, Angle::degrees(FIELD))?)?;
    Ok(MovingLight::new("added spot", spot.with_intensity(way.dot(way))?))
}

/// Returns whether a fixture can cast shadows: it is a spotlight that is not too wide.
fn takes_shadow(fixture: &MovingLight) -> bool {
    fixture.with_shadow(SHADOW_SIDE).at(0.0).is_ok()
}
