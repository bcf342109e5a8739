//! Changes of the state: each is either taken or refused as a whole, so that the state can always be
//! drawn. Earlier states can be returned to.

use super::Stage;
use crate::{
    address, job, leds,
    parameter::{self, Value},
    photometry::full_scale,
    refusal::Refusal,
    rig::Rig,
    setting::Setting,
    state::{LIGHTS, State, switch_of, switchable},
    viewpoint::Reach,
};
use luminaire_render::scenes::{Example, MovingLight};
use std::rc::Rc;
use wasm_bindgen::prelude::*;

/// Largest number of states to return to.
const PAST: usize = 200;

#[wasm_bindgen]
impl Stage {
    /// Changes the state.
    pub(crate) fn change(&mut self, act: impl FnOnce(&mut State)) -> Result<(), Refusal> {
        let mut next = self.state.clone();
        act(&mut next);
        self.adopt(next)
    }

    /// Sets a parameter of the state by its name.
    pub(crate) fn put(&mut self, name: &str, value: impl Into<Value>) -> Result<(), Refusal> {
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
        let original = self.rig.original(&setting)?;
        act(&mut setting, &original)?;
        self.rig.keep_light(self.setting(light)?, &mut setting)?;
        self.change_light(light, |light| *light = setting)
    }

    /// Begins a gesture, such as the drag of a slider. Until the next one begins, numbers and drags of a
    /// light are computed from the light as it is now.
    pub fn grip(&mut self) {
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
        lights.get(light).ok_or_else(|| Refusal::light(light, lights.len()))
    }

    /// Sets a number of a light, as a step of a gesture: its `beam`, `field` or `zoom` angle in degrees;
    /// `fit-beam` or `fit-field`, which keep the other angle; a number of its chosen law of distance or
    /// edge, by its place behind `law-` or `edge-`; or its `intensity` in candela, or in lux for a
    /// directional light. Angles and edges conserve the flux, and the law of distance conserves the
    /// irradiance at the throw.
    #[wasm_bindgen(js_name = setNumber)]
    pub fn set_number(&mut self, light: usize, name: &str, value: f32) -> Result<(), Refusal> {
        let full_scale = full_scale(self.state.scene);
        let outcome = self.within_gesture(|stage| {
            stage.change_original(light, |setting, original| {
                setting.set_number(name, value, original, full_scale)
            })
        });
        outcome.map_err(|refusal| self.beyond_dial(light, name, value).unwrap_or(refusal))
    }

    /// Returns what is said of an angle beyond the ends of its dial. The kernel would name what follows from it: another
    /// angle, or the intensity.
    fn beyond_dial(&self, light: usize, name: &str, degrees: f32) -> Option<Refusal> {
        let (dials, name) = (self.dial_ends(light).ok()?, name.rsplit('-').next()?);
        let ends = match name {
            "beam" => dials.beam,
            "field" => dials.field,
            _ => return None,
        };
        let [least, most] = ends[..] else { return None };
        // Four digits, within the ends.
        let digits = |end: f32| 10_f32.powi(3 - end.log10().floor() as i32);
        let ends =
            [(least * digits(least)).ceil() / digits(least), (most * digits(most)).floor() / digits(most)];
        let unit = format!("degrees in {}", self.state.format.label());
        (!(least..=most).contains(&degrees))
            .then(|| Refusal::outside(&format!("{name} angle"), degrees, ends, &unit))
    }

    /// Sets a choice of a light: its `kind`, `law` of distance, `edge`, `color`, `fixture`, or the
    /// `reading` of its angle. Another kind or law keeps the irradiance at the throw.
    #[wasm_bindgen(js_name = setChoice)]
    pub fn set_choice(&mut self, light: usize, name: &str, value: &str) -> Result<(), Refusal> {
        let full_scale = full_scale(self.state.scene);
        self.change_original(light, |setting, original| setting.set_choice(name, value, original, full_scale))
    }

    /// Gives a light the settings of an address, such as the cone and the colour of a file, and a peak in candela
    /// or as a multiple of full scale at 1 metre. Its place, its aim and its switch stay.
    #[wasm_bindgen(js_name = putLight)]
    pub fn put_light(
        &mut self,
        light: usize,
        settings: &str,
        peak: f32,
        is_candela: bool,
    ) -> Result<(), Refusal> {
        let Setting { of, is_on, position, target, .. } = *self.setting(light)?;
        let read = address::read_light(&format!("{of}{settings}"), &|_| true);
        let (put, _) = read
            .filter(|(_, has_all)| *has_all)
            .ok_or_else(|| Refusal::name("light", settings, "the settings of an address"))?;
        let intensity = Some(if is_candela { peak / full_scale(self.state.scene) } else { peak });
        self.change_light(light, |light| *light = Setting { is_on, position, target, intensity, ..put[0] })
    }

    /// Puts the LEDs of a file in place of those of the tree, whose scene opens: places in metres, and the ways that
    /// they face or none, with three numbers for each LED. The lights of the tree stay as they are.
    #[wasm_bindgen(js_name = putLeds)]
    pub fn put_leds(&mut self, places: &[f32], facing: &[f32]) -> Result<(), Refusal> {
        let refused =
            || Refusal::outside("LEDs", (places.len() / 3) as f32, [1.0, leds::MOST as f32], "on the page");
        let leds = Some(Rc::new(leds::strip(places, facing).ok_or_else(refused)?));
        if self.state.scene != Example::Tree || self.load.is_some() {
            self.open(Example::Tree.name())?;
        }
        self.change(|state| state.leds = leds)
    }

    /// Multiplies the angles of a light by a factor and conserves its flux.
    #[wasm_bindgen(js_name = zoomLight)]
    pub fn zoom_light(&mut self, light: usize, factor: f32) -> Result<(), Refusal> {
        self.change_original(light, |setting, original| setting.zoom(factor, original))
    }

    /// Switches a light on or off.
    #[wasm_bindgen(js_name = setOn)]
    pub fn set_on(&mut self, light: usize, on: bool) -> Result<(), Refusal> {
        self.change_light(light, |setting| setting.is_on = on)
    }

    /// Adds a copy of a light behind it.
    #[wasm_bindgen(js_name = copyLight)]
    pub fn copy_light(&mut self, light: usize) -> Result<(), Refusal> {
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
    #[wasm_bindgen(js_name = removeLight)]
    pub fn remove_light(&mut self, light: usize) -> Result<(), Refusal> {
        self.setting(light)?;
        self.change(|state| {
            state.lights.remove(light);
        })
    }

    /// The setting of a light.
    pub(crate) fn setting(&self, light: usize) -> Result<&Setting, Refusal> {
        let count = self.state.lights.len();
        self.state.lights.get(light).ok_or_else(|| Refusal::light(light, count))
    }

    /// Switches an effect on or off by its name.
    #[wasm_bindgen(js_name = setEffect)]
    pub fn switch(&mut self, name: &str, on: bool) -> Result<(), Refusal> {
        let place = switch_of(name).ok_or_else(|| Refusal::name("effect to switch", name, switchable()))?;
        self.change(|state| state.switched[place] = Some(on))
    }

    /// Opens a scene as it was composed, in the current number format. Opening the same scene again
    /// resets it.
    pub fn open(&mut self, scene: &str) -> Result<(), Refusal> {
        let scene = address::scene_named(scene)?;
        if self.load.is_some() {
            self.take(Self::of(scene)?);
        }
        let lights =
            if scene == self.state.scene { self.rig.lights() } else { scene.setup()?.fixtures.len() };
        self.adopt(self.state.followed_by(scene, lights))
    }

    /// Moves what plays by some seconds. Returns whether anything plays.
    pub fn advance(&mut self, seconds: f32) -> bool {
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
    pub fn orbit(&mut self, yaw: f32, pitch: f32) {
        let camera = self.own_camera();
        self.state.viewpoint.orbit(camera, Reach::of(self.state.scene), yaw, pitch);
    }

    /// Moves the camera to `factor` times its distance. Returns whether it moved.
    pub fn zoom(&mut self, factor: f32) -> bool {
        let camera = self.own_camera();
        self.state.viewpoint.zoom(camera, Reach::of(self.state.scene), factor)
    }

    /// Takes the state of an address. Returns what was refused in words; the rest is taken.
    pub fn recall(&mut self, address: &str) -> Result<String, Refusal> {
        self.load = None;
        let refused = self.take_address(address)?;
        Ok(refused.iter().map(ToString::to_string).collect::<Vec<_>>().join(". "))
    }

    /// Takes the state of an address. Returns what was refused; the rest is taken.
    pub(crate) fn take_address(&mut self, query: &str) -> Result<Vec<Refusal>, Refusal> {
        let (mut asked, mut refused) = address::parse(query, self.state.scene)?;
        let scene = asked.scene;
        let rig = Rig::new(scene.setup()?)?;
        let others = State { lights: Vec::new(), ..asked.clone() };
        for (light, setting) in asked.lights.iter_mut().enumerate() {
            if let Err(refusal) = rig.accept(&others, light, setting) {
                let is_taken = |part: &Setting| rig.accept(&others, light, part).is_ok();
                let rest = address::read_light(&address::light_text(setting), &is_taken);
                *setting = rest.map_or(Setting::of(setting.of), |(rest, _)| rest[0]);
                refused.push(Refusal(format!("light {} is without this setting: {refusal}", light + 1)));
            }
        }
        if let Err(refusal) = self.adopt(asked) {
            refused.push(refusal);
            self.adopt(State::of(scene, scene.setup()?.fixtures.len()))?;
        }
        Ok(refused)
    }

    /// Forgets all states to return to.
    pub fn begin(&mut self) {
        self.past = vec![self.state.clone()];
        self.future.clear();
    }

    /// Marks the state as one to return to. Returns whether it is a new one.
    pub fn mark(&mut self) -> bool {
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

    /// Whether there is a state to undo.
    #[wasm_bindgen(getter, js_name = canUndo)]
    pub fn can_undo(&self) -> bool {
        self.can_return()[0]
    }

    /// Whether there is a state to redo.
    #[wasm_bindgen(getter, js_name = canRedo)]
    pub fn can_redo(&self) -> bool {
        self.can_return()[1]
    }

    /// Returns to the marked state before this one, or does nothing if there is none.
    pub fn undo(&mut self) -> Result<(), Refusal> {
        self.mark();
        if self.past.len() > 1 {
            self.future.extend(self.past.pop());
            self.return_to(self.past.last().cloned())?;
        }
        Ok(())
    }

    /// Returns to the last marked state, as if the changes since then had not been. Returns whether there
    /// were any.
    pub fn cancel(&mut self) -> Result<bool, Refusal> {
        let marked = self.past.last().filter(|marked| !marked.is_same_setting(&self.state)).cloned();
        let is_changed = marked.is_some();
        self.return_to(marked)?;
        Ok(is_changed)
    }

    /// Returns to the state that was undone last, or does nothing if there is none.
    pub fn redo(&mut self) -> Result<(), Refusal> {
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
        let is_another = (next.scene, &next.leds) != (self.state.scene, &self.state.leds);
        let rig = if is_another {
            job::rig(next.scene, None, next.leds.as_deref())?.fitted(&next)
        } else {
            self.rig.fitted(&next)
        }?;
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
