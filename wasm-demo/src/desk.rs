//! The lighting desk: the state, the scene that it gives, and earlier states to return to.

use crate::{
    address,
    photometry::full_scale,
    refusal::Refusal,
    rig::{self, Rig},
    setting::Setting,
    state::{EXPOSURES, LIGHTS, SWITCHABLE, State},
};
use luminaire_render::{
    Camera,
    scenes::{Example, MovingLight},
};

/// Largest number of states to return to.
const PAST: usize = 200;

/// Places of lights that are added, in turn: see [`rig::place_in_view`].
const PLACES: [f32; 3] = [0.5, 0.1, 0.9];

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
}

impl Desk {
    /// Opens a scene.
    pub(crate) fn new(scene: Example) -> Result<Self, Refusal> {
        Ok(Self::with_rig(scene, Rig::new(scene.setup()?)?))
    }

    /// Opens a scene with other lights than its own.
    pub(crate) fn with_rig(scene: Example, rig: Rig) -> Self {
        let state = State::of(scene, rig.lights());
        Self { past: vec![state.clone()], state, rig, future: Vec::new() }
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
    pub(crate) fn change(
        &mut self,
        act: impl FnOnce(&mut State) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let mut next = self.state.clone();
        act(&mut next)?;
        self.adopt(next)
    }

    /// Changes the setting of a light.
    pub(crate) fn change_light(
        &mut self,
        light: usize,
        act: impl FnOnce(&mut Setting) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        self.change(|state| {
            let count = state.lights.len();
            act(state.lights.get_mut(light).ok_or(Refusal::Number { value: light, count })?)
        })
    }

    /// Changes the setting of a light, given the light as the scene has it.
    fn change_original(
        &mut self,
        light: usize,
        act: impl FnOnce(&mut Setting, &MovingLight) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let original = *self.rig.original(self.setting(light)?.of)?;
        self.change_light(light, |setting| act(setting, &original))
    }

    /// Sets a number of a light: see [`Setting::set_number`].
    pub(crate) fn set_number(&mut self, light: usize, name: &str, value: f32) -> Result<(), Refusal> {
        let full_scale = full_scale(self.state.scene);
        self.change_original(light, |setting, original| setting.set_number(name, value, original, full_scale))
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

    /// Adds a spotlight in view that aims at the middle of the picture.
    pub(crate) fn add_light(&mut self) -> Result<(), Refusal> {
        let of = self.rig.lights();
        let before = self.state.lights.iter().filter(|setting| setting.of == of).count();
        let [position, target] =
            rig::place_in_view(self.rig.scene(), &self.camera(), PLACES[before % PLACES.len()]);
        let added = Setting { position: Some(position), target: Some(target), ..Setting::of(of) };
        self.insert_light(self.state.lights.len(), added)
    }

    /// Adds a copy of a light behind it.
    pub(crate) fn copy_light(&mut self, light: usize) -> Result<(), Refusal> {
        self.insert_light(light + 1, *self.setting(light)?)
    }

    fn insert_light(&mut self, place: usize, setting: Setting) -> Result<(), Refusal> {
        let count = self.state.lights.len() + 1;
        if count > LIGHTS {
            return Err(Refusal::outside("number of lights", count as f32, [0.0, LIGHTS as f32], "lights"));
        }
        self.change(|state| {
            state.lights.insert(place, setting);
            Ok(())
        })
    }

    /// Removes a light.
    pub(crate) fn remove_light(&mut self, light: usize) -> Result<(), Refusal> {
        self.setting(light)?;
        self.change(|state| {
            state.lights.remove(light);
            Ok(())
        })
    }

    /// The setting of a light.
    pub(crate) fn setting(&self, light: usize) -> Result<&Setting, Refusal> {
        let count = self.state.lights.len();
        self.state.lights.get(light).ok_or(Refusal::Number { value: light, count })
    }

    /// Switches an effect on or off by its name.
    pub(crate) fn switch(&mut self, name: &str, on: bool) -> Result<(), Refusal> {
        let place = SWITCHABLE.iter().position(|(effect, _)| effect.name() == name);
        let expected = "specular, gobo, shadow, haze or dither";
        let place = place.ok_or_else(|| Refusal::name("effect to switch", name, expected))?;
        self.change(|state| {
            state.switched[place] = Some(on);
            Ok(())
        })
    }

    /// Sets the exposure in stops.
    pub(crate) fn expose(&mut self, stops: f32) -> Result<(), Refusal> {
        let [least, most] = EXPOSURES;
        if !(least..=most).contains(&stops) {
            return Err(Refusal::outside("exposure", stops, EXPOSURES, "stops"));
        }
        self.change(|state| {
            state.exposure = stops;
            Ok(())
        })
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
        let (asked, mut refused) = address::parse(query, self.state.scene)?;
        let scene = asked.scene;
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
        if let Some(format) = next.other {
            rig.fitted(&State { format, ..next.clone() })?;
        }
        (self.state, self.rig) = (next, rig);
        Ok(())
    }
}

#[cfg(test)]
mod tests;
