//! The JavaScript class that writes lights as source of other languages.

use crate::{job::Task, panic, refusal::Refusal};
use luminaire_export::{Language, c_header, export};
use std::fmt;
use wasm_bindgen::prelude::*;

/// The name of the file that all lights in C share, as a language to choose.
const HEADER: &str = "c-header";

/// Writes the lights of a scene as source of other languages.
#[wasm_bindgen]
#[derive(Default)]
pub struct Code {
    /// The last job, whose scene may be needed again.
    task: Option<Task>,
}

#[wasm_bindgen]
impl Code {
    /// A writer without a scene.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        panic::tell_the_page();
        Self::default()
    }

    /// Writes a light of a job of the stage, as it is where its movement begins, at an exposure of 0
    /// stops and switched on. `language` is the name of a [`Language`], or `c-header` for the file
    /// that all lights in C share. Throws a string if the language or its number format cannot
    /// express the light.
    pub fn write(&mut self, job: &str, light: usize, language: &str) -> Result<String, JsValue> {
        Ok(self.source(job, light, language)?)
    }
}

impl Code {
    fn source(&mut self, job: &str, light: usize, language: &str) -> Result<String, Refusal> {
        if language == HEADER {
            return Ok(c_header());
        }
        let language: Language = language.parse()?;
        let task = Task::read(job, self.task.take())?;
        let task = self.task.insert(task);
        let name = format!("light_{}", light + 1);
        Ok(export(task.rig.described(&task.job.state, light)?, &name, language)?)
    }
}

impl fmt::Debug for Code {
    /// The output omits the scene, which would make the module larger.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Code").finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{desk::Desk, job};
    use luminaire_render::scenes::Example;

    fn job_of(desk: &Desk) -> String {
        job::write((96, 54), None, desk.state(), desk.rig().lights())
    }

    #[test]
    fn every_light_of_every_scene_is_written_as_the_crate_writes_it() {
        let mut code = Code::new();
        for &scene in Example::ALL {
            let desk = Desk::new(scene).unwrap();
            let job = job_of(&desk);
            for (number, original) in scene.setup().unwrap().fixtures.iter().enumerate() {
                if original.sweeps() {
                    continue;
                }
                for &language in Language::ALL {
                    let expected = export(*original.light(), &format!("light_{}", number + 1), language);
                    let found = code.source(&job, number, language.name());
                    assert_eq!(
                        found.map_err(|refusal| refusal.to_string()),
                        expected.map_err(|error| error.to_string()),
                        "{scene:?} {number} {language}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_code_has_the_settings_of_the_light_and_not_its_switch_or_exposure() {
        let mut desk = Desk::new(Example::ThreePoint).unwrap();
        let mut code = Code::new();
        let mut json = |desk: &Desk| code.source(&job_of(desk), 0, "json").unwrap();
        let before = json(&desk);
        desk.set("exposure", 2.0).unwrap();
        desk.change_light(0, |setting| setting.is_on = false).unwrap();
        assert_eq!(json(&desk), before);
        desk.set_number(0, "field", 12.0).unwrap();
        assert_ne!(json(&desk), before);
    }

    #[test]
    fn what_cannot_be_written_is_refused_in_words() {
        let mut code = Code::new();
        let job = job_of(&Desk::new(Example::ThreePoint).unwrap());
        for (light, language, words) in [
            (0, "basic", "language = basic: expected one of json, glsl"),
            (99, "json", "light = 99: expected a number from 0"),
        ] {
            let refusal = code.source(&job, light, language).unwrap_err().to_string();
            assert!(refusal.contains(words), "{refusal}");
        }
        assert!(code.source("", 0, HEADER).unwrap().contains("luminaire_inverse_square_roots"));
    }
}
