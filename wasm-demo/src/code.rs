//! The JavaScript class that writes lights as source of other languages.

use crate::{job::Task, panic, refusal::Refusal};
use luminaire_export::{C_HEADERS, Language, export};
use std::fmt;
use wasm_bindgen::prelude::*;

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
    /// stops and switched on. `language` is the name of a [`Language`], or of one of [`C_HEADERS`]. Throws
    /// a string if the language or its number format cannot express the light.
    pub fn write(&mut self, job: &str, light: usize, language: &str) -> Result<String, Refusal> {
        if let Some((_, text)) = C_HEADERS.iter().find(|(name, _)| *name == language) {
            return Ok((*text).to_owned());
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
    use crate::{job, model::Chosen, stage::Stage};
    use luminaire::attenuation::AnyAttenuation;
    use luminaire_render::scenes::Example;

    #[test]
    fn what_cannot_be_written_is_refused_in_words() {
        let mut code = Code::default();
        let job = job::write_opened(Example::ThreePoint, (96, 54));
        for (light, language, words) in [
            (0, "basic", "language = basic: expected one of json, glsl"),
            (99, "json", "light = 99: expected a number from 0"),
        ] {
            let refusal = code.write(&job, light, language).unwrap_err().to_string();
            assert!(refusal.contains(words), "{refusal}");
        }
        assert!(code.write("", 0, C_HEADERS[0].0).unwrap().contains("luminaire_inverse_square_roots"));
    }

    #[test]
    fn the_law_and_the_kind_of_a_light_are_written() {
        let (mut code, mut stage) = (Code::default(), Stage::of(Example::ThreePoint).unwrap());
        for law in AnyAttenuation::all() {
            stage.set_choice(0, "law", law.name()).unwrap();
            for language in ["json", "rust-fx16", "c-fx16", "c-f32", "glsl", "wgsl"] {
                let written = code.write(&stage.job(), 0, language).map(|text| text.is_empty());
                assert_eq!(written, Ok(false), "{}, {language}", law.name());
            }
        }
        for (name, choice, words) in [
            ("law", "polynomial", "Polynomial::new(1.0, 0.2, 0.03)"),
            ("kind", "point", "PointLight::new"),
            ("kind", "directional", "DirectionalLight::new"),
        ] {
            stage.set_choice(0, name, choice).unwrap();
            let text = code.write(&stage.job(), 0, "rust-build").unwrap();
            assert!(text.contains(words), "{text}");
        }
        let text = code.write(&stage.job(), 0, "c-fx16").unwrap();
        assert!(text.contains("luminaire_directional"), "{text}");
    }
}
