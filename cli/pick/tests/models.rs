//! Lights of every kind, every falloff and every attenuation.

#[path = "../../../export/tests/support/compiler.rs"]
mod compiler;

use luminaire::attenuation::{AnyAttenuation, CutAt, InverseSquare, NoAttenuation};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, IntegerPower, RealPower, Soft, Step, Table};
use luminaire::light::{Distribution, Symmetry};
use luminaire::models::Listed;
use luminaire::{Angle, Cone, DirectionalLight, MeasuredLight, PointLight, SpotLight};
use luminaire_pick::{Chip, Counted, Display, Evaluation, Light, Request, Scene, Survey};

fn request(steps: f64) -> Request {
    Request::new(Chip::CortexM0, Display::Rgb565).steps(steps)
}

fn spot(falloff: AnyFalloff, attenuation: AnyAttenuation) -> AnyLight {
    let cone = Cone::from_outer(falloff, Angle::degrees(40.0)).unwrap();
    SpotLight::new([1.0, 2.0, 3.0], [0.0, -1.0, 0.5], cone).unwrap().with_attenuation(attenuation).into()
}

fn attenuations() -> Vec<AnyAttenuation> {
    let sample = |numbers: &[luminaire::models::Number]| -> Vec<f32> {
        numbers.iter().map(|number| number.in_sample()).collect()
    };
    let of = |row: &luminaire::attenuation::AttenuationRow| {
        let beside: Vec<_> = row.beside_range().copied().collect();
        row.of(&sample(&beside), Some(5.0)).unwrap()
    };
    AnyAttenuation::LIST.iter().map(of).collect()
}

/// One light for each model.
fn lights() -> Vec<(String, AnyLight)> {
    let falls = || AnyAttenuation::from(InverseSquare);
    let mut lights = Vec::new();
    for falloff in AnyFalloff::samples() {
        lights.push((falloff.row().name.to_owned(), spot(falloff, falls())));
    }
    for law in attenuations() {
        lights.push((format!("{law:?}"), spot(Soft.into(), law)));
        let point = PointLight::new([1.0, 2.0, 3.0]).unwrap().with_attenuation(law);
        lights.push((format!("point {law:?}"), point.into()));
    }
    let cone = Cone::from_outer(AnyFalloff::from(Soft), Angle::degrees(40.0)).unwrap();
    for cone in [cone.with_cutoff(Angle::degrees(20.0)), cone.with_inner(Angle::degrees(20.0))] {
        let light = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone.unwrap()).unwrap();
        lights.push(("ramp".to_owned(), light.with_attenuation(falls()).into()));
    }
    let samples: &[u16] = &[9_000, 30_000, 65_535, 20_000, 50_000, 20_000];
    let lamp = Distribution::new(samples, 3, Symmetry::Bilateral).unwrap();
    for law in [falls(), CutAt::new(InverseSquare, Some(5.0)).unwrap().into()] {
        let lamp = MeasuredLight::new([1.0, 2.0, 3.0], [0.0, -1.0, 0.5], [1.0, 0.0, 0.0], lamp).unwrap();
        lights.push((format!("measured {law:?}"), lamp.with_attenuation(law).into()));
    }
    lights.push(("sun".to_owned(), DirectionalLight::new([0.0, -1.0, 0.5]).unwrap().into()));
    lights
}

/// Returns the survey of a light; `None` for one of a model that was added and whose price is not on record yet.
fn survey(name: &str, light: &AnyLight, steps: f64) -> Option<Survey> {
    match request(steps).survey(&Light::of("light", light)) {
        Ok(survey) => Some(survey),
        Err(refusal) if refusal.parameter == "price" => None,
        Err(refusal) => panic!("{name}: {refusal}"),
    }
}

#[test]
fn every_model_is_answered_by_every_evaluation_on_every_chip() {
    let mut texts = String::new();
    for (number, (name, light)) in lights().iter().enumerate() {
        let Some(survey) = survey(name, light, 1e9) else { continue };
        assert!(survey.picked.is_some(), "{name}");
        let expected: &[Evaluation] = match light {
            AnyLight::Spot(_) => Evaluation::ALL,
            AnyLight::Point(_) | AnyLight::Measured(_) | AnyLight::Directional(_) => &Evaluation::ALL[1..],
        };
        for evaluation in expected {
            let found = survey.evaluations.iter().find(|each| each.evaluation == *evaluation);
            let found = found.unwrap_or_else(|| panic!("{name} by {evaluation}"));
            assert_eq!(found.prices.len(), Chip::ALL.len());
            for (chip, price) in &found.prices {
                let least = if matches!(light, AnyLight::Directional(_)) { 5.0 } else { 20.0 };
                assert!(price.instructions > least && price.bytes > 50, "{name} on {chip}: {price:?}");
            }
            assert!(found.bound.found <= found.bound.value, "{name} by {evaluation}: {:?}", found.bound);
            let name = evaluation.name().replace('-', "_");
            texts += &format!("pub mod light_{number}_{name} {{\n{}}}\n", found.code);
        }
    }
    let folder = std::env::temp_dir().join(format!("luminaire-pick-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    compiler::compile_rust(&texts, "lib", &folder.join("lights")).unwrap();
    std::fs::remove_dir_all(folder).unwrap();
}

/// A price says whether it was counted with these models, and more of a model costs more.
#[test]
fn price_says_whether_it_was_counted_as_a_whole() {
    let price = |falloff, law| {
        let answer = Request::new(Chip::CortexM0, Display::Rgb565).steps(1e9);
        let survey = answer.survey(&Light::of("light", &spot(falloff, law))).unwrap();
        let found = survey.evaluations.iter().find(|each| each.evaluation == Evaluation::Fx32).unwrap();
        found.prices["cortex-m0"]
    };
    let falls = || AnyAttenuation::from(InverseSquare);
    let power = |exponent| AnyFalloff::from(IntegerPower::new(exponent).unwrap());
    for (counted, falloff, law) in [
        (Counted::Whole, Soft.into(), falls()),
        (Counted::Whole, Table::sample().unwrap().into(), falls()),
        (Counted::Parts, RealPower::new(2.25).unwrap().into(), falls()),
        (Counted::Whole, power(4), NoAttenuation.into()),
        (Counted::Parts, power(5), NoAttenuation.into()),
    ] {
        assert_eq!(price(falloff, law).counted, counted, "{falloff:?} {law:?}");
    }
    // The products of 2^n and of one with all digits set.
    let prices = [4, 16, 255].map(|exponent| price(power(exponent), falls()).instructions);
    assert!(prices.is_sorted_by(|few, many| few < many), "{prices:?}");
}

/// Where a light jumps, the bound holds beside the jump and says how far from it.
#[test]
fn bound_of_a_jump_has_a_place() {
    let bound = |light: &AnyLight| request(1e9).pick(&Light::of("light", light)).unwrap().bound;
    let step = bound(&spot(Step.into(), InverseSquare.into()));
    assert!(step.edge_degrees > 0.0 && step.edge_degrees < 0.5 && step.range == 0.0, "{step:?}");
    let cut = CutAt::new(InverseSquare, Some(5.0)).unwrap();
    let cut = bound(&spot(Soft.into(), cut.into()));
    assert!(cut.edge_degrees == 0.0 && cut.range > 0.0 && cut.range < 0.1, "{cut:?}");
}

#[test]
fn scene_of_every_kind_shares_a_tolerance() {
    let all = lights();
    let some = all.iter().step_by(5).filter_map(|(name, light)| {
        survey(name, light, 1e9).map(|_| Light { near: 2.0, far: 4.0, ..Light::of("light", light) })
    });
    let lights: Vec<_> = some.collect();
    let count = lights.len();
    let answer = request(1e6).pick_scene(&Scene { lights }).unwrap();
    assert!(answer.lights.len() == count && answer.budget.total <= 1e6, "{:?}", answer.budget);
}
