//! The parts of an answer, refusals and scenes.

use luminaire::attenuation::{AnyAttenuation, FilamentRange, InverseSquare};
use luminaire::falloff::{AnyFalloff, Smooth, Soft};
use luminaire::{Angle, Cone, Fx16, SpotLight};
use luminaire_pick::{Attenuation, Chip, Display, Edge, Evaluation, Light, Price, Request, Scene};

fn request(steps: f64) -> Request {
    Request::new(Chip::CortexM0, Display::Rgb565).steps(steps)
}

fn level(field: f32) -> Light {
    Light { field: Some(field), attenuation: Attenuation::None, intensity: 1.0, ..Light::default() }
}

#[test]
fn pick_wide_cone_is_quick_and_narrow_cone_is_not() {
    let wide = request(1.0).pick(&level(60.0)).unwrap();
    let narrow = request(1.0).pick(&Light { edge: Edge::Hard, ..level(3.0) }).unwrap();
    assert_eq!(wide.evaluation, Evaluation::Fx16Quick);
    assert_ne!(narrow.evaluation, Evaluation::Fx16Quick);
    assert!(wide.price.instructions < narrow.price.instructions);
    assert_eq!(wide.bound.label, "derived");
    assert!(wide.price.cycles > Some(wide.price.instructions));
    assert!(wide.code.contains("QuickSpotLight<luminaire::Fx16, luminaire::falloff::Soft"));
}

#[test]
fn pick_floating_point_unit_takes_f32() {
    let answer = Request::new(Chip::CortexM4f, Display::Rgb888).steps(1.0).pick(&level(40.0)).unwrap();
    assert_eq!(answer.evaluation, Evaluation::F32);
}

#[test]
fn steps_of_leds_are_linear_codes() {
    let light = level(20.0);
    let bound = |request: Request| request.pick(&light).unwrap().bound.value;
    let leds = bound(Request::new(Chip::CortexM0, Display::Ws2812).steps(1.2));
    assert_eq!(leds, bound(Request::new(Chip::CortexM0, Display::Rgb888).codes(1.2)));
    assert!(leds < bound(Request::new(Chip::CortexM0, Display::Rgb888).steps(1.2)));
    let fine = Request::new(Chip::CortexM0, Display::Pwm16).steps(1.0).pick(&light).unwrap();
    assert_eq!(fine.evaluation, Evaluation::Fx32);
}

#[test]
fn price_of_a_bright_light_includes_the_fine_evaluation() {
    let dim = Light { intensity: 1.0, ..Light::default() };
    let tight = Request::new(Chip::CortexM0, Display::Rgb565).codes(1.2);
    let [dim, bright] =
        [dim, Light { intensity: 16.0, ..Light::default() }].map(|light| tight.pick(&light).unwrap());
    assert_eq!(bright.evaluation, Evaluation::Fx16);
    assert!(dim.price.fine_share == 0.0 && bright.price.fine_share > 0.0);
}

#[test]
fn request_for_the_worst_case_picks_by_it() {
    let light = Light { intensity: 16.0, ..Light::default() };
    for &chip in Chip::ALL {
        let mean = Request::new(chip, Display::Rgb565).steps(1.0);
        match mean.worst_case().pick(&light) {
            Ok(answer) => {
                let Price { instructions, worst, .. } = answer.price;
                assert!(worst.is_some_and(|worst| worst >= instructions), "{chip}: {:?}", answer.price);
                // No other evaluation within the tolerance takes less at worst.
                for other in mean.survey(&light).unwrap().evaluations {
                    let most = other.prices[chip.name()].worst;
                    assert!(other.bound.value > 1.0 || most.is_none() || most >= worst, "{chip}: {other:?}");
                }
            }
            Err(refusal) => {
                let told =
                    format!("worst = {chip}: expected a chip whose worst cases are on record: cortex-m0, ");
                assert!(refusal.to_string().starts_with(&told), "{refusal}");
                assert!(mean.pick(&light).unwrap().price.worst.is_none());
            }
        }
    }
    let worst = |light: &Light| {
        let survey = request(1e9).survey(light).unwrap();
        let fx16 = survey.evaluations.iter().find(|found| found.evaluation == Evaluation::Fx16);
        fx16.unwrap().prices["cortex-m0"].worst.unwrap()
    };
    // Without attenuation a dim light has no point that takes both evaluations.
    assert!(worst(&Light { intensity: 16.0, ..level(36.0) }) > 1.5 * worst(&level(36.0)));
    assert!(worst(&light) > 1.5 * worst(&level(36.0)));
}

/// The price of a light that is bright at every distance is that of the count on record, and that of a steep cone is the
/// fine evaluation alone.
#[test]
fn price_of_a_bright_spot_is_what_is_counted() {
    let record: serde_json::Value = serde_json::from_str(include_str!("../../../docs/prices.json")).unwrap();
    let counted = &record["cortex-m0"]["figures"]["lit-bright.fx16"];
    let fx16 = |light: &Light| {
        let survey = request(1e9).survey(light).unwrap();
        let found = survey.evaluations.iter().find(|each| each.evaluation == Evaluation::Fx16).unwrap();
        found.prices.clone()
    };
    let bright = fx16(&Light { intensity: 16.0, ..level(36.0) });
    let price = bright["cortex-m0"];
    assert_eq!(price.fine_share, 1.0);
    for (told, unit, most) in [
        (Some(price.instructions), "instructions", Price::IN_PARTS),
        (price.cycles, "cycles", Price::IN_PARTS),
        (Some(price.bytes as f64), "bytes", Price::BYTES_IN_PARTS),
    ] {
        let counted = counted[unit].as_f64().unwrap();
        let ratio = told.unwrap() / counted;
        assert!((ratio - 1.0).abs() < most, "{unit}: {told:?} told, {counted} counted");
    }
    let narrowest = 1.02 * Cone::narrowest::<Fx16>(Soft).to_degrees();
    let steep = fx16(&Light { field: None, outer: Some(narrowest), ..level(36.0) });
    for (chip, steep) in steep {
        let bright = bright[chip];
        assert!(steep.fine_share == 1.0 && steep.instructions < bright.instructions, "{chip}: {steep:?}");
    }
}

#[test]
fn refusals_name_the_parameter_and_what_can_be_had() {
    let refused = |request: Request, light: Light| request.pick(&light).unwrap_err().to_string();
    for (light, parameter) in [
        (Light { field: Some(170.0), ..Light::default() }, "field angle = 170: expected more than 0"),
        (Light { outer: Some(0.0), ..Light::default() }, "outer angle"),
        (Light { outer: Some(30.0), inner: Some(30.0), ..Light::default() }, "inner angle = 30"),
        (Light { outer: Some(30.0), field: Some(20.0), ..Light::default() }, "outer angle = 30: expected no"),
        (Light { near: 2.0, far: 1.0, ..Light::default() }, "distances = 2 to 1"),
        (Light { near: 1e-5, ..Light::default() }, "near = 0.00001: expected at least 0.00024"),
        (
            Light { position: [1e9, 0.0, 0.0], ..Light::default() },
            "position = 1000000000: expected coordinates",
        ),
        (
            Light { name: "key`\npub fn evil() {}".to_owned(), ..Light::default() },
            "name = key`\\npub fn evil() {}: ",
        ),
        (
            Light { name: "\u{202e}\u{1b}".to_owned(), ..Light::default() },
            "name = \\u{202e}\\u{1b}: expected letters",
        ),
        (Light { intensity: -1.0, ..Light::default() }, "intensity = -1"),
        (Light { axis: [0.0; 3], ..Light::default() }, "axis"),
    ] {
        let told = refused(request(1.0), light);
        assert!(told.starts_with(parameter), "{told}");
    }
    let told = refused(request(1e-9), Light::default());
    assert!(told.starts_with("tolerance = 0.000000001 steps: expected at least"), "{told}");
    assert!(told.contains("the bound of f32") || told.contains("the bound of fx32"), "{told}");
    assert!(refused(request(f64::NAN), Light::default()).starts_with("tolerance = NaN"));
}

#[test]
fn refused_tolerance_names_one_that_is_answered() {
    let refusal = request(1e-9).pick(&Light::default()).unwrap_err();
    let words: Vec<_> = refusal.expected.split(' ').collect();
    let steps: f64 = words[2].parse().unwrap();
    assert!(request(steps).pick(&Light::default()).is_ok(), "{refusal}");
}

#[test]
fn json_has_the_figures_by_name() {
    let answer = request(1.0).pick(&Light::default()).unwrap();
    let json = serde_json::to_value(&answer).unwrap();
    assert_eq!(json["chip"], "cortex-m0");
    assert_eq!(json["bound"]["label"], "derived");
    assert!(json["cycles"].is_f64() && json["bytes"].is_u64() && json["instructions"].is_f64());
    assert!(json["bound"]["at"]["degrees_off_axis"].is_f64());
    assert_eq!((&json["counted"], &json["bound"]["range"]), (&"whole".into(), &0.0.into()));
}

#[test]
fn scene_keeps_the_sum_within_the_tolerance_at_the_least_price() {
    let lights = vec![level(20.0), level(60.0), Light { edge: Edge::Hard, ..level(40.0) }];
    let scene = Scene { lights };
    let mut last = f64::INFINITY;
    for steps in [0.05, 0.5, 1.0, 1.5, 3.0] {
        let answer = request(steps).pick_scene(&scene).unwrap();
        assert!(answer.budget.total <= steps, "{:?}", answer.budget);
        assert!(answer.budget.lights < answer.budget.total + 1e-12);
        let sum: f64 = answer.lights.iter().map(|light| light.price.instructions).sum();
        assert!((sum - answer.instructions).abs() < 1e-9 && sum <= last, "{sum} after {last}");
        last = sum;
    }
    assert!(last < 3.0 * 160.0, "no quick evaluations at 3 steps: {last}");
    let told = request(1e-6).pick_scene(&scene).unwrap_err().to_string();
    assert!(told.starts_with("tolerance"), "{told}");
}

#[test]
fn survey_picks_the_evaluation_of_the_answer_and_prices_every_chip() {
    let lights = [level(60.0), Light { edge: Edge::Hard, ..level(3.0) }, Light::default()];
    for (light, steps) in lights.iter().zip([1.0, 1.0, 0.1]) {
        let survey = request(steps).survey(light).unwrap();
        let answer = request(steps).pick(light).unwrap();
        assert_eq!(survey.picked, Some(answer.evaluation));
        let found = survey.evaluations.iter().find(|each| each.evaluation == answer.evaluation).unwrap();
        assert_eq!((found.bound, &found.code), (answer.bound, &answer.code));
        assert_eq!(found.prices["cortex-m0"], answer.price);
        let rv32 = Request::new(Chip::Rv32imc, Display::Rgb565).steps(steps).pick(light).unwrap();
        let found = survey.evaluations.iter().find(|each| each.evaluation == rv32.evaluation).unwrap();
        assert_eq!(found.prices["rv32imc"], rv32.price);
    }
    assert_eq!(request(1e-9).survey(&Light::default()).unwrap().picked, None);
    let told =
        request(1.0).survey(&Light { field: Some(170.0), ..Light::default() }).unwrap_err().to_string();
    assert!(told.starts_with("field angle = 170"), "{told}");
}

/// A request has the fields of a light that have an effect, and reads them again.
#[test]
fn light_of_an_answer_is_the_light_of_the_request() {
    let cone = Cone::from_outer(AnyFalloff::from(Smooth), Angle::degrees(40.0)).unwrap();
    let spot = SpotLight::new([1.0, 2.0, 3.0], [0.0, 0.0, 1.0], cone).unwrap().with_intensity(9.0).unwrap();
    let range = FilamentRange::new(InverseSquare, Some(9.0)).unwrap();
    let any = Light::of("key", &spot.with_attenuation(AnyAttenuation::from(range)).into());
    for light in [any, Light { field: Some(30.0), ..Light::default() }] {
        let answer = request(2.0).pick(&light).unwrap();
        assert_eq!(answer.light, light);
        let written = serde_json::to_value(&light).unwrap();
        assert_eq!(serde_json::from_value::<Light>(written.clone()).unwrap(), light, "{written}");
        assert_eq!(written.get("edge").is_some(), light.light.is_none(), "{written}");
        assert_eq!(serde_json::to_value(&answer).unwrap()["light"], written);
    }
}

/// The fields of a spotlight by its angles have no effect beside a light, and are refused.
#[test]
fn light_beside_other_fields_is_refused() {
    let cone = Cone::from_outer(AnyFalloff::from(Smooth), Angle::degrees(40.0)).unwrap();
    let spot = SpotLight::new([0.0; 3], [0.0, 0.0, 1.0], cone).unwrap();
    let light = Light::of("key", &spot.with_attenuation(AnyAttenuation::from(InverseSquare)).into());
    assert!(request(9.0).pick(&Light { near: 2.0, far: 3.0, ..light.clone() }).is_ok());
    let told = request(9.0).pick(&Light { field: Some(20.0), ..light }).unwrap_err().to_string();
    assert!(told.starts_with("light = spot: expected the name, near and far alone beside it"), "{told}");
}
