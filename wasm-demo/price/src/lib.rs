//! The picker of evaluations, for a worker of the demo's page.

use luminaire_pick::{Chip, Display, Light, Request, Tolerance};
use serde::Deserialize;
use wasm_bindgen::prelude::wasm_bindgen;

/// What the page asks.
#[derive(Debug, Deserialize)]
struct Question {
    chip: Chip,
    display: Display,
    tolerance: Tolerance,
    light: Light,
}

/// Returns all evaluations of a light with their errors and prices, and the picked one, as JSON.
/// `question` is JSON with a `chip`, a `display`, a `tolerance` and a `light`, by the names of
/// `luminaire pick`.
///
/// # Errors
/// The refusal of a parameter in words.
#[wasm_bindgen]
pub fn survey(question: &str) -> Result<String, String> {
    let Question { chip, display, tolerance, light } =
        serde_json::from_str(question).map_err(|error| format!("question: {error}"))?;
    let request = Request::new(chip, display).tolerance(tolerance);
    let survey = request.survey(&light).map_err(|refusal| refusal.to_string())?;
    serde_json::to_string(&survey).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn survey_of_a_light_names_the_picked_evaluation() {
        let question = r#"{"chip":"cortex-m0","display":"rgb565","tolerance":{"steps":1},
            "light":{"field":40,"near":2,"far":8}}"#;
        let answer: serde_json::Value = serde_json::from_str(&survey(question).unwrap()).unwrap();
        let light = Light { field: Some(40.0), near: 2.0, far: 8.0, ..Light::default() };
        let picked = Request::new(Chip::CortexM0, Display::Rgb565).steps(1.0).pick(&light).unwrap();
        assert_eq!(answer["picked"], picked.evaluation.name());
        let evaluations = answer["evaluations"].as_array().unwrap();
        let names: Vec<_> = evaluations.iter().map(|each| each["evaluation"].as_str().unwrap()).collect();
        assert_eq!(names, ["fx16-quick", "fx16", "fx32", "f32"]);
        assert!(evaluations.iter().all(|each| each["prices"]["rv32imc"]["instructions"].is_f64()));
        // A light of a document, of another kind.
        let point = question.replace(
            r#""field":40,"#,
            r#""light":{"kind":"point","attenuation":{"law":"decay","exponent":1.5,"most":9,"window":"square","range":9}},"#,
        );
        let answer: serde_json::Value = serde_json::from_str(&survey(&point).unwrap()).unwrap();
        let evaluations = answer["evaluations"].as_array().unwrap();
        assert!(
            evaluations.len() == 3 && evaluations[0]["prices"]["rv32imc"]["counted"] == "parts",
            "{answer}"
        );
        let refused = survey(&question.replace("40", "170")).unwrap_err();
        assert!(refused.starts_with("field angle = 170: expected"), "{refused}");
        assert!(survey("{}").unwrap_err().starts_with("question: "));
    }
}
