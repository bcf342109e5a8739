//! The lighting desk: the state, the scene that it gives, and earlier states to return to.

use crate::{
    address,
    parameter::{self, Value},
    photometry::full_scale,
    refusal::Refusal,
    rig::Rig,
    setting::Setting,
    state::{LIGHTS, State, switch_of, switchable},
};
use luminaire_render::{
    Camera,
    scenes::{Example, MovingLight},
};

/// Largest number of states to return to.
const PAST: usize = 200;

/// The state and what follows from it. A change is either taken or refused as a whole, so that the
/// state can always be drawn.
#[derive(Clone, Debug)]
pub(crate) struct Desk {
    state: State,
    rig: Rig,
    /// Earlier states, the last of which is marked as one to return to.
    past: Vec<State>,
    /// States that were undone, the last of which comes next.
    future: Vec<State>,
    /// The lights as they were when the visitor's gesture began: its values are computed from them, and
    /// not from those that it has passed.
    grip: Option<Vec<Setting>>,
}

impl Desk {
    /// Opens a scene.
    pub(crate) fn new(scene: Example) -> Result<Self, Refusal> {
        Ok(Self::with_rig(scene, Rig::new(scene.setup()?)?))
    }

    /// Opens a scene with other lights than its own.
    pub(crate) fn with_rig(scene: Example, rig: Rig) -> Self {
        let state = State::of(scene, rig.lights());
        Self { past: vec![state.clone()], state, rig, future: Vec::new(), grip: None }
    }

    /// The state.
    pub(crate) fn state(&self) -> &State {
        &self.state
    }

    /// The scene and its lights.
    pub(crate) fn rig(&self) -> &Rig {
        &self.rig
    }

    /// The camera of the picture.
    pub(crate) fn camera(&self) -> Camera {
        self.rig.camera_of(&self.state)
    }

    /// The scene's own camera.
    fn own_camera(&self) -> Camera {
        self.rig.camera_at(self.state.seconds[1])
    }

    /// Changes the state.
    pub(crate) fn change(&mut self, act: impl FnOnce(&mut State)) -> Result<(), Refusal> {
        let mut next = self.state.clone();
        act(&mut next);
        self.adopt(next)
    }

    /// Sets a parameter of the state by its name.
    pub(crate) fn set(&mut self, name: &str, value: impl Into<Value>) -> Result<(), Refusal> {
        let mut next = self.state.clone();
        parameter::named(name)?.set(&mut next, value.into())?;
        self.adopt(next)
    }

    /// Changes the setting of a light.
    pub(crate) fn change_light(
        &mut self,
        light: usize,
        act: impl FnOnce(&mut Setting),
    ) -> Result<(), Refusal> {
        self.setting(light)?;
        self.change(|state| act(&mut state.lights[light]))
    }

    /// Changes the setting of a light, given the light as the scene has it.
    fn change_original(
        &mut self,
        light: usize,
        act: impl FnOnce(&mut Setting, &MovingLight) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let mut setting = *self.setting(light)?;
        let original = self.rig.original(setting.of)?;
        act(&mut setting, original)?;
        self.change_light(light, |light| *light = setting)
    }

    /// Begins a gesture of the visitor, which lasts until the next one begins.
    pub(crate) fn grip(&mut self) {
        self.grip = Some(self.state.lights.clone());
    }

    /// Does a step of a gesture, from the lights as they were when it began. A refusal changes nothing.
    pub(crate) fn within_gesture(
        &mut self,
        act: impl FnOnce(&mut Self) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let Some(grip) = self.grip.take() else { return act(self) };
        let before = (self.state.clone(), self.rig.clone());
        let restored = if self.state.lights == grip {
            Ok(())
        } else {
            self.adopt(State { lights: grip.clone(), ..self.state.clone() })
        };
        let outcome = restored.and_then(|()| act(self));
        if outcome.is_err() {
            (self.state, self.rig) = before;
        }
        self.grip = Some(grip);
        outcome
    }

    /// The setting of a light as it was when the visitor's gesture began.
    pub(crate) fn held(&self, light: usize) -> Result<&Setting, Refusal> {
        let lights = self.grip.as_ref().unwrap_or(&self.state.lights);
        lights.get(light).ok_or(Refusal::Number { value: light, count: lights.len() })
    }

    /// Sets a number of a light, as a step of a gesture: see [`Setting::set_number`].
    pub(crate) fn set_number(&mut self, light: usize, name: &str, value: f32) -> Result<(), Refusal> {
        let full_scale = full_scale(self.state.scene);
        self.within_gesture(|desk| {
            desk.change_original(light, |setting, original| {
                setting.set_number(name, value, original, full_scale)
            })
        })
    }

    /// Sets a choice of a light: see [`Setting::set_choice`].
    pub(crate) fn set_choice(&mut self, light: usize, name: &str, value: &str) -> Result<(), Refusal> {
        let full_scale = full_scale(self.state.scene);
        self.change_original(light, |setting, original| setting.set_choice(name, value, original, full_scale))
    }

    /// Zooms a light: see [`Setting::zoom`].
    pub(crate) fn zoom_light(&mut self, light: usize, factor: f32) -> Result<(), Refusal> {
        self.change_original(light, |setting, original| setting.zoom(factor, original))
    }

    /// Adds a copy of a light behind it.
    pub(crate) fn copy_light(&mut self, light: usize) -> Result<(), Refusal> {
        self.insert_light(light + 1, *self.setting(light)?)
    }

    /// Inserts a light, if there are not too many.
    pub(crate) fn insert_light(&mut self, place: usize, setting: Setting) -> Result<(), Refusal> {
        let count = self.state.lights.len() + 1;
        if count > LIGHTS {
            return Err(Refusal::outside("number of lights", count as f32, [0.0, LIGHTS as f32], "lights"));
        }
        self.change(|state| state.lights.insert(place, setting))
    }

    /// Removes a light.
    pub(crate) fn remove_light(&mut self, light: usize) -> Result<(), Refusal> {
        self.setting(light)?;
        self.change(|state| {
            state.lights.remove(light);
        })
    }

    /// The setting of a light.
    pub(crate) fn setting(&self, light: usize) -> Result<&Setting, Refusal> {
        let count = self.state.lights.len();
        self.state.lights.get(light).ok_or(Refusal::Number { value: light, count })
    }

    /// Switches an effect on or off by its name.
    pub(crate) fn switch(&mut self, name: &str, on: bool) -> Result<(), Refusal> {
        let place = switch_of(name).ok_or_else(|| Refusal::name("effect to switch", name, switchable()))?;
        self.change(|state| state.switched[place] = Some(on))
    }

    /// Opens a scene as it was composed, in the current number format.
    pub(crate) fn open(&mut self, scene: Example) -> Result<(), Refusal> {
        let lights =
            if scene == self.state.scene { self.rig.lights() } else { scene.setup()?.fixtures.len() };
        self.adopt(self.state.followed_by(scene, lights))
    }

    /// Moves what plays by some seconds. Returns whether anything plays.
    pub(crate) fn advance(&mut self, seconds: f32) -> bool {
        let plays = self.plays();
        for (time, _) in self.state.seconds.iter_mut().zip(plays).filter(|(_, plays)| *plays) {
            *time += if seconds.is_finite() { seconds.max(0.0) } else { 0.0 };
        }
        plays.contains(&true)
    }

    /// Returns whether the lights and the camera move now.
    pub(crate) fn plays(&self) -> [bool; 2] {
        let moves = self.rig.moves();
        [0, 1].map(|track| self.state.plays[track] && moves[track])
    }

    /// Turns the camera around its target, by angles in radians.
    pub(crate) fn orbit(&mut self, yaw: f32, pitch: f32) {
        let camera = self.own_camera();
        self.state.viewpoint.orbit(camera, yaw, pitch);
    }

    /// Moves the camera to `factor` times its distance. Returns whether it moved.
    pub(crate) fn zoom(&mut self, factor: f32) -> bool {
        let camera = self.own_camera();
        self.state.viewpoint.zoom(camera, factor)
    }

    /// Takes the state of an address. Returns what was refused; the rest is taken.
    pub(crate) fn recall(&mut self, query: &str) -> Result<Vec<Refusal>, Refusal> {
        let (mut asked, mut refused) = address::parse(query, self.state.scene)?;
        let scene = asked.scene;
        let rig = Rig::new(scene.setup()?)?;
        let others = State { lights: Vec::new(), ..asked.clone() };
        for (light, setting) in asked.lights.iter_mut().enumerate() {
            if let Err(refusal) = rig.accept(&others, light, setting) {
                refused.push(Refusal::Opened { light, reason: refusal.to_string() });
                *setting = Setting::of(setting.of);
            }
        }
        if let Err(refusal) = self.adopt(asked) {
            refused.push(refusal);
            self.adopt(State::of(scene, scene.setup()?.fixtures.len()))?;
        }
        Ok(refused)
    }

    /// Forgets all states to return to.
    pub(crate) fn begin(&mut self) {
        self.past = vec![self.state.clone()];
        self.future.clear();
    }

    /// Marks the state as one to return to. Returns whether it is a new one.
    pub(crate) fn mark(&mut self) -> bool {
        let is_new = self.past.last().is_none_or(|last| !last.is_same_setting(&self.state));
        if is_new {
            self.future.clear();
            self.past.push(self.state.clone());
            let excess = self.past.len().saturating_sub(PAST);
            self.past.drain(..excess);
        }
        is_new
    }

    /// Returns whether there is a state to undo and one to redo.
    pub(crate) fn can_return(&self) -> [bool; 2] {
        let is_changed = self.past.last().is_some_and(|last| !last.is_same_setting(&self.state));
        [self.past.len() > 1 || is_changed, !self.future.is_empty()]
    }

    /// Returns to the marked state before this one, or does nothing if there is none.
    pub(crate) fn undo(&mut self) -> Result<(), Refusal> {
        self.mark();
        if self.past.len() > 1 {
            self.future.extend(self.past.pop());
            self.return_to(self.past.last().cloned())?;
        }
        Ok(())
    }

    /// Returns to the last marked state, as if the changes since then had not been. Returns whether there
    /// were any.
    pub(crate) fn cancel(&mut self) -> Result<bool, Refusal> {
        let marked = self.past.last().filter(|marked| !marked.is_same_setting(&self.state)).cloned();
        let is_changed = marked.is_some();
        self.return_to(marked)?;
        Ok(is_changed)
    }

    /// Returns to the state that was undone last, or does nothing if there is none.
    pub(crate) fn redo(&mut self) -> Result<(), Refusal> {
        let next = self.future.pop();
        self.past.extend(next.clone());
        self.return_to(next)
    }

    /// Adopts a state of the past or the future. In the same scene the time goes on.
    fn return_to(&mut self, state: Option<State>) -> Result<(), Refusal> {
        let Some(mut state) = state else { return Ok(()) };
        if state.scene == self.state.scene {
            state.seconds = self.state.seconds;
        }
        self.adopt(state)
    }

    fn adopt(&mut self, next: State) -> Result<(), Refusal> {
        let is_another = next.scene != self.state.scene;
        let rig =
            if is_another { Rig::new(next.scene.setup()?)?.fitted(&next) } else { self.rig.fitted(&next) }?;
        (self.state, self.rig) = (next, rig);
        // What is no step of a gesture begins another one.
        if let Some(grip) = &mut self.grip {
            grip.clone_from(&self.state.lights);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
