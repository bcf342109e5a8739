//! The stage: what is taken, what is refused, and the way back.

use super::*;
use crate::{
    design::{Design, Mark},
    fixture,
    format::Format,
    job,
    kind::arriving,
    light::{DialEnds, LightState},
    model::Chosen,
    own_cone,
    state::EXPOSURES,
};
use luminaire::dynamic::{AnyLight, Effect, Effects};
use luminaire::{attenuation::AnyAttenuation, falloff::AnyFalloff};
use luminaire_fixtures::FIXTURES;
use luminaire_render::{Renderer, Surfaces, scenes::Example};

fn stage(scene: Example) -> Stage {
    Stage::of(scene).unwrap()
}

/// A scene in `f32`, which holds the narrowest beams.
fn in_floats(scene: Example) -> Stage {
    let mut stage = stage(scene);
    stage.put("format", "f32").unwrap();
    stage
}

fn effects(stage: &Stage) -> Effects {
    let (rig, state) = (stage.rig(), stage.state());
    let plan = rig.plan(&rig.fixtures_at(state.seconds[0]).unwrap());
    if rig.has(state, Effect::Dither) { plan.with(Effect::Dither).effects() } else { plan.effects() }
}

fn light(stage: &Stage, light: usize) -> LightState {
    stage.light_state(light).unwrap()
}

fn number(stage: &mut Stage, name: &str, value: f32) -> Result<(), Refusal> {
    stage.set_number(0, name, value)
}

fn choice(stage: &mut Stage, name: &str, value: &str) -> Result<(), Refusal> {
    stage.set_choice(0, name, value)
}

#[test]
fn the_other_half_of_a_picture_has_a_format_that_holds_the_lights() {
    let mut stage = in_floats(Example::ThreePoint);
    let narrow =
        |stage: &mut Stage| stage.change_light(0, |light| light.design = Design::of(Mark::Field, 0.5));
    stage.put("with", "fx16").unwrap();
    assert!(narrow(&mut stage).unwrap_err().to_string().contains("16-bit fixed point cannot hold light 1"));
    stage.put("with", Value::Nothing).unwrap();
    narrow(&mut stage).unwrap();
    assert!(stage.put("with", "fx16").is_err() && stage.state().other.is_none());
}

#[test]
fn a_scene_opens_as_it_was_composed() {
    for &scene in Example::ALL {
        let (setup, stage) = (scene.setup().unwrap(), stage(scene));
        for seconds in [0.0, 1.3] {
            assert_eq!(stage.rig().fixtures_at(seconds), setup.fixtures_at(seconds), "{scene:?}");
        }
        assert_eq!((stage.rig().scene(), stage.camera()), (&setup.scene, setup.camera), "{scene:?}");
    }
}

#[test]
fn a_light_that_is_switched_off_is_dark_and_keeps_its_number() {
    for &scene in Example::ALL {
        let mut stage = stage(scene);
        let lit = stage.rig().fixtures_at(1.0).unwrap();
        for light in 0..lit.len() {
            stage.change_light(light, |setting| setting.is_on = false).unwrap();
            let mut dark = stage.rig().fixtures_at(1.0).unwrap();
            assert!(dark[light].light().is_dark(), "light {light} of {scene:?}");
            dark[light] = lit[light];
            assert_eq!(dark, lit, "light {light} of {scene:?}");
            stage.change_light(light, |setting| setting.is_on = true).unwrap();
        }
        let refusal = stage.change_light(lit.len(), |_| ()).unwrap_err().to_string();
        assert!(refusal.contains(&format!("light = {}", lit.len())), "{refusal}");
    }
}

#[test]
fn an_effect_is_left_out_and_put_back_in() {
    for (scene, effect) in [
        (Example::Turntable, Effect::Specular),
        (Example::Gallery, Effect::Specular),
        (Example::Show, Effect::Gobo),
        (Example::Show, Effect::Haze),
    ] {
        let mut stage = stage(scene);
        let look = |stage: &Stage| {
            (effects(stage), stage.rig().fixtures_at(2.0).unwrap(), stage.rig().scene().clone())
        };
        let before = look(&stage);
        stage.switch(effect.name(), false).unwrap();
        assert!(before.0.has(effect) && !effects(&stage).has(effect), "{scene:?}");
        assert_eq!(effects(&stage).with(effect), before.0);
        stage.switch(effect.name(), true).unwrap();
        assert_eq!(look(&stage), before);
    }
    let refusal = stage(Example::Show).switch("spot", false).unwrap_err().to_string();
    assert!(refusal.contains("\"spot\"") && refusal.contains("specular"), "{refusal}");
}

#[test]
fn haze_dither_and_shadows_are_added_and_taken_away() {
    let mut stage = stage(Example::Turntable);
    let look =
        |stage: &Stage| (effects(stage), stage.rig().fixtures_at(1.0).unwrap(), stage.rig().scene().clone());
    assert!(effects(&stage).has(Effect::Dither));
    stage.switch("dither", false).unwrap();
    let before = look(&stage);
    for effect in [Effect::Haze, Effect::Dither, Effect::Shadow] {
        assert!(!before.0.has(effect));
        stage.switch(effect.name(), true).unwrap();
        assert!(effects(&stage).has(effect), "{effect:?}");
    }
    let sides = |stage: &Stage| -> Vec<_> {
        let fixtures = stage.rig().fixtures_at(1.0).unwrap();
        fixtures.iter().map(|fixture| fixture.shadow().map(|(side, _)| side)).collect()
    };
    assert!(stage.rig().scene().haze().is_some() && stage.rig().display(stage.state()).is_dithered);
    assert_eq!(sides(&stage), [Some(512); 8]);
    for effect in [Effect::Haze, Effect::Dither, Effect::Shadow] {
        stage.switch(effect.name(), false).unwrap();
    }
    assert_eq!(look(&stage), before);
    for (side, is_taken) in [(64, true), (5, false)] {
        let rig = job::rig(Example::Turntable, Some((8, Some(side))), None).unwrap();
        let mut stage = Stage::with_rig(Example::Turntable, rig);
        assert_eq!(stage.switch("shadow", true).is_ok(), is_taken);
        assert_eq!(sides(&stage), [Some(side).filter(|_| is_taken); 8]);
    }
}

#[test]
fn the_angles_follow_one_another() {
    let mut stage = stage(Example::BareSpot);
    number(&mut stage, "field", 15.0).unwrap();
    let state = light(&stage, 0);
    assert!((state.beam - 9.81).abs() < 0.005 && (state.outer - 18.15).abs() < 0.005);
    number(&mut stage, "beam", state.beam).unwrap();
    assert!((light(&stage, 0).field - 15.0).abs() < 1e-3);
    // Another edge keeps the angle that was set last.
    choice(&mut stage, "edge", "hard").unwrap();
    assert!((light(&stage, 0).beam - state.beam).abs() < 1e-3);
    choice(&mut stage, "edge", "own").unwrap();
    assert!((light(&stage, 0).field - 15.0).abs() < 1e-3);
}

#[test]
fn both_angles_are_given_and_stay_as_they_were_given() {
    let mut stage = stage(Example::BareSpot);
    number(&mut stage, "field", 20.0).unwrap();
    number(&mut stage, "fit-beam", 7.0).unwrap();
    number(&mut stage, "fit-field", 15.0).unwrap();
    let angles = |stage: &Stage| (light(stage, 0).beam, light(stage, 0).field, light(stage, 0).edge);
    let near = |(beam, field, edge): (f32, f32, String), expected: (f32, f32)| {
        assert!((beam - expected.0).abs() < 1e-3 && (field - expected.1).abs() < 1e-3, "{beam} {field}");
        assert_eq!(edge, "fitted");
    };
    near(angles(&stage), (7.0, 15.0));
    number(&mut stage, "beam", 10.0).unwrap();
    near(angles(&stage), (10.0, 15.0));
    let [_, _, least, most] = light(&stage, 0).reach[..] else { panic!("nothing is reached") };
    assert!((least - 10.0).abs() < 1e-3 && (23.0..24.0).contains(&most), "{least} to {most}");
    number(&mut stage, "field", 40.0).unwrap();
    assert!(light(&stage, 0).beam > 17.0, "the beam does not follow");
    // A soft edge has these two angles and others.
    choice(&mut stage, "edge", "fitted-soft").unwrap();
    let state = light(&stage, 0);
    assert!((state.field - 40.0).abs() < 1e-3 && state.edge == "fitted-soft", "{}", state.field);
    number(&mut stage, "beam", 7.0).unwrap();
    let soft = light(&stage, 0);
    assert!(
        (soft.beam - 7.0).abs() < 1e-3 && (soft.field - 40.0).abs() < 1e-3,
        "{} {}",
        soft.beam,
        soft.field
    );
    assert!(soft.outer > 50.0 && soft.reach[3] > 100.0, "{} {:?}", soft.outer, soft.reach);
    choice(&mut stage, "edge", "fitted").unwrap();
    assert!(light(&stage, 0).field < 17.0, "the field angle does not follow");
    number(&mut stage, "field", 40.0).unwrap();
    // Another edge has one angle.
    choice(&mut stage, "edge", "smooth").unwrap();
    assert!((light(&stage, 0).field - 40.0).abs() < 1e-3 && light(&stage, 0).edge == "smooth");
    choice(&mut stage, "edge", "fitted").unwrap();
    let state = light(&stage, 0);
    number(&mut stage, "fit-field", state.field).unwrap();
    near(angles(&stage), (state.beam, state.field));
}

/// The light at the centre rises as the flux is gathered in a narrower cone: by the ratio of the
/// solid angles.
#[test]
fn a_zoom_conserves_the_flux() {
    let mut stage = stage(Example::BareSpot);
    choice(&mut stage, "edge", "soft").unwrap();
    number(&mut stage, "field", 10.0).unwrap();
    let wide = light(&stage, 0);
    number(&mut stage, "field", 5.0).unwrap();
    let narrow = light(&stage, 0);
    let ratio = |[narrow, wide]: [f32; 2]| {
        let versine = |field: f32| 1.0 - (f64::from(field).to_radians() / 2.0).cos();
        versine(wide) / versine(narrow)
    };
    let expected = ratio([5.0, 10.0]) as f32;
    assert!((3.99..4.0).contains(&expected));
    assert!((narrow.intensity / wide.intensity / expected - 1.0).abs() < 1e-3);
    assert!((narrow.lumens.unwrap() / wide.lumens.unwrap() - 1.0).abs() < 1e-4);
    let (near, far) = (narrow.lux.unwrap(), wide.lux.unwrap());
    assert!((near / far / expected - 1.0).abs() < 1e-3, "the centre rises from {far} to {near} lx");
    assert!(
        (far * wide.throw.unwrap().powi(2) / wide.intensity - 1.0).abs() < 1e-3,
        "not the inverse square"
    );
    stage.zoom_light(0, 2.0).unwrap();
    assert!((light(&stage, 0).intensity / wide.intensity - 1.0).abs() < 1e-3);
    // Another edge gives another intensity, and the same flux.
    for edge in ["hard", "step", "fitted", "fitted-soft", "power", "own"] {
        choice(&mut stage, "edge", edge).unwrap();
        let lumens = light(&stage, 0).lumens.unwrap();
        assert!((lumens / wide.lumens.unwrap() - 1.0).abs() < 1e-3, "{edge}: {lumens} lm");
    }
}

#[test]
fn a_fixture_brings_its_lumens() {
    let mut stage = in_floats(Example::ThreePoint);
    let bright = FIXTURES.iter().filter(|fixture| fixture.lumens.is_some());
    let mut count = 0;
    for fixture in bright {
        choice(&mut stage, "fixture", fixture.name).unwrap();
        for factor in [0.5, 3.0, 0.9] {
            let lumens = light(&stage, 0).lumens.unwrap();
            assert!((lumens / fixture.lumens.unwrap() - 1.0).abs() < 1e-3, "{}: {lumens} lm", fixture.name);
            stage.zoom_light(0, factor).unwrap();
        }
        count += 1;
    }
    assert!(count > 20, "{count} fixtures have a flux");
    number(&mut stage, "intensity", 5000.0).unwrap();
    assert!((light(&stage, 0).intensity - 5000.0).abs() < 0.01);
    // The exposure that shows the pool as full scale.
    stage.expose_for(0).unwrap();
    let shown = light(&stage, 0).lux.unwrap() * stage.state().exposure.exp2() / 1000.0;
    assert!((0.9..1.1).contains(&shown), "{shown} of full scale");
}

#[test]
fn a_light_of_a_file_keeps_its_shape_and_the_place_of_the_light() {
    let mut stage = stage(Example::ThreePoint);
    stage.place_light(0, 1.0, 2.0, 3.0).unwrap();
    let cone = "knots/0.01/0.03/0.03/0/65535/-2000000000/30000/56379/-51984";
    stage.put_light(0, &format!(":nSpot-12:o{cone}:cff8000"), 5000.0, true).unwrap();
    assert_eq!([&light(&stage, 0).name, &stage.listed_lights().unwrap()[0].name], ["Spot-12"; 2]);
    let put = light(&stage, 0);
    assert_eq!((put.own_edge, put.intensity, put.position[2]), ("table with a hotspot".into(), 5000.0, 3.0));
    stage.zoom_light(0, 0.5).unwrap();
    let ratios = [light(&stage, 0).field / put.field, light(&stage, 0).beam / put.beam];
    assert!(ratios.iter().all(|ratio| (2.0 * ratio - 1.0).abs() < 1e-3), "{ratios:?}");
    // A table lives as long as the program: the one that is read for each picture is the same.
    let knots = || match own_cone::read(cone).map(|cone| cone.falloff()) {
        Some(AnyFalloff::Table(table)) => table.knots().as_ptr(),
        other => panic!("expected a table, found {other:?}"),
    };
    assert_eq!(knots(), knots());
    assert!(stage.put_light(0, ":oknots/0/0.1/0.1/1/2", 1.0, false).is_err());
}

/// The second of two typed angles keeps the first, by another edge if it must; else the pair is the nearest.
#[test]
fn a_pair_of_angles_has_an_edge_or_is_the_nearest() {
    let mut stage = stage(Example::BareSpot);
    for (first, second, edge, expected) in [
        (("field", 22.0), ("pair-beam", 12.0), "fitted", [12.0, 22.0]),
        (("beam", 12.0), ("pair-field", 22.0), "fitted", [12.0, 22.0]),
        (("field", 40.0), ("pair-beam", 10.0), "fitted-soft", [10.0, 40.0]),
        (("field", 22.0), ("pair-beam", 40.0), "fitted", [40.0, 40.0]),
    ] {
        choice(&mut stage, "edge", "own").unwrap();
        for (name, degrees) in [first, second] {
            number(&mut stage, name, degrees).unwrap();
        }
        let found = light(&stage, 0);
        let is_near = [found.beam, found.field]
            .iter()
            .zip(expected)
            .all(|(found, expected)| (found - expected).abs() < 1e-2);
        assert!(is_near && found.edge == edge, "{second:?}: {}, {}, {}", found.beam, found.field, found.edge);
    }
}

#[test]
fn a_refused_value_changes_nothing() {
    let mut stage = stage(Example::BareSpot);
    number(&mut stage, "field", 15.0).unwrap();
    let before = stage.state().clone();
    let refused = |outcome: Result<(), Refusal>, words: &str| {
        let message = outcome.unwrap_err().to_string();
        assert!(message.contains(words), "{message}");
    };
    for degrees in [0.0, -10.0, 400.0, 150.0, f32::NAN, f32::INFINITY] {
        refused(number(&mut stage, "field", degrees), "field angle");
        refused(number(&mut stage, "beam", degrees), "beam angle");
    }
    refused(number(&mut stage, "beam", 1e-9), "beam angle = 1e-9: expected 0.7");
    refused(number(&mut stage, "pair-beam", f32::NAN), "degrees in 16-bit fixed point");
    refused(stage.aim_light(0, 0.0, f32::INFINITY, 0.0), "aim y = inf: expected -");
    refused(stage.place_light(0, 0.0, 0.0, -1e9), "position z = -1000000000: expected -");
    let [x, y, z] = light(&stage, 0).position[..] else { panic!("no position") };
    refused(stage.aim_light(0, x, y, z), "aim = the position of the light");
    refused(number(&mut stage, "intensity", -1.0), "intensity");
    refused(number(&mut stage, "intensity", f32::NAN), "intensity");
    refused(number(&mut stage, "zoom", 20.0), "fixture");
    refused(number(&mut stage, "length", 1.0), "number of a light");
    refused(choice(&mut stage, "fixture", "Nobody's lamp"), "fixture = \"Nobody's lamp\"");
    refused(choice(&mut stage, "edge", ""), "edge");
    refused(choice(&mut stage, "reading", "outer"), "beam or field");
    refused(choice(&mut stage, "kind", "area"), "kind of light = \"area\": expected spot, point or");
    refused(choice(&mut stage, "law", "linear"), "law = \"linear\": expected own, unattenuated");
    refused(number(&mut stage, "law-1", 1.0), "law-1 = \"1\": expected the law of distance");
    refused(number(&mut stage, "edge-0", 1.0), "edge-0 = \"1\": expected the edge");
    for color in ["", "#fff", "ffffff", "#gggggg", "#ffffff0", "#ééé", "#+1+1+1"] {
        refused(choice(&mut stage, "color", color), "color");
    }
    refused(stage.put("exposure", 7.0), "exposure");
    refused(stage.put("exposure", f32::NAN), "exposure");
    let position = stage.rig().fixtures_at(0.0).unwrap();
    let luminaire::dynamic::AnyLight::Spot(spot) = position[0].light() else { panic!("no spot") };
    let position = spot.position();
    refused(stage.change_light(0, |setting| setting.target = Some(position)), "axis");
    assert_eq!(stage.state(), &before);
}

#[test]
fn a_format_that_cannot_hold_a_light_is_refused() {
    let mut stage = in_floats(Example::ThreePoint);
    number(&mut stage, "beam", 1.0).unwrap();
    let refusal = stage.put("format", "fx16").unwrap_err().to_string();
    assert!(
        refusal.contains("16-bit") && refusal.contains("light 1") && refusal.contains("outer angle"),
        "{refusal}"
    );
    assert_eq!(stage.state().format, Format::F32);
    number(&mut stage, "beam", 20.0).unwrap();
    stage.put("format", "fx16").unwrap();
    assert!(number(&mut stage, "beam", 1.0).is_err());
}

/// Sets both ends of every dial of a light, from the light as it is or from the ends of its dials. Returns
/// the number of values.
fn turn_dials(stage: &mut Stage, light: usize, starts: &[Option<usize>]) -> usize {
    let (opened, mut count) = (stage.state().clone(), 0);
    for first in starts {
        let dials = |stage: &Stage| {
            let DialEnds { beam, field, zoom, intensity, kelvin, law, edge } =
                stage.dial_ends(light).unwrap();
            let plain = [("beam", beam), ("field", field), ("zoom", zoom), ("intensity", intensity)];
            let dials = plain.into_iter().chain([("kelvin", kelvin)]);
            let mut dials: Vec<_> = dials.map(|(name, ends)| (name.to_owned(), ends)).collect();
            for (model, ends) in [("law", law), ("edge", edge)] {
                let each = ends.chunks(2).enumerate();
                dials.extend(each.map(|(place, ends)| (format!("{model}-{place}"), ends.to_vec())));
            }
            dials
        };
        stage.adopt(opened.clone()).unwrap();
        for (name, ends) in dials(stage) {
            stage.adopt(opened.clone()).unwrap();
            if let Some(end) = first.and_then(|end| ends.get(end)) {
                stage.set_number(light, &name, *end).unwrap();
            }
            stage.grip();
            for (name, ends) in dials(stage) {
                for end in ends {
                    let outcome = stage.set_number(light, &name, end);
                    assert_eq!(outcome, Ok(()), "{:?}, light {light}: {name} = {end}", opened.scene);
                    count += 1;
                }
            }
        }
    }
    count
}

#[test]
fn dials_accept_both_ends() {
    let mut count = 0;
    for &scene in Example::ALL {
        for format in Format::ALL {
            let mut stage = stage(scene);
            stage.put("format", format.name()).unwrap();
            let mut names = Vec::new();
            for light in 0..stage.state().lights.len() {
                let name = stage.light_state(light).unwrap().name;
                if !names.contains(&name) {
                    count += turn_dials(&mut stage, light, &[None]);
                    names.push(name);
                }
            }
            for stops in EXPOSURES {
                stage.put("exposure", stops).unwrap();
            }
        }
    }
    for format in Format::ALL {
        let edges: Vec<_> =
            AnyFalloff::all().iter().map(|edge| edge.name()).chain(["fitted", "fitted-soft"]).collect();
        for (name, value) in edges
            .iter()
            .map(|edge| ("edge", *edge))
            .chain(["ARRI L7-C", FIXTURES[0].name, FIXTURES[40].name].map(|name| ("fixture", name)))
        {
            let mut stage = stage(Example::ThreePoint);
            stage.put("format", format.name()).unwrap();
            // The 16-bit format does not hold every fixture.
            if choice(&mut stage, name, value).is_ok() {
                count += turn_dials(&mut stage, 0, &[None, Some(0), Some(1)]);
            }
        }
        let mut stage = stage(Example::ThreePoint);
        stage.put("format", format.name()).unwrap();
        for law in AnyAttenuation::all() {
            choice(&mut stage, "law", law.name()).unwrap();
            for kind in ["own", "point", "directional"] {
                choice(&mut stage, "kind", kind).unwrap();
                count += turn_dials(&mut stage, 0, &[None, Some(0), Some(1)]);
            }
        }
    }
    assert!(count > 500, "only {count} values");
}

/// Each value of a gesture is computed from the light as it was when the gesture began.
#[test]
fn gestures_end_where_they_began() {
    let mut stage = stage(Example::BareSpot);
    number(&mut stage, "field", 22.0).unwrap();
    number(&mut stage, "fit-beam", 12.0).unwrap();
    let before = light(&stage, 0);
    let near = |stage: &Stage, beam: f32, field: f32| {
        let now = light(stage, 0);
        assert!((now.beam / beam - 1.0).abs() < 1e-4 && (now.field / field - 1.0).abs() < 1e-4, "{now:?}");
        let flux = now.lumens.unwrap() / before.lumens.unwrap();
        assert!((flux - 1.0).abs() < 1e-3, "{flux} of the flux");
    };
    for name in ["beam", "fit-beam"] {
        let [narrowest, widest] = stage.dial_ends(0).unwrap().beam[..] else { panic!("no dial") };
        stage.grip();
        for value in [5.0, narrowest, widest, 2.0, 12.0] {
            number(&mut stage, name, value).unwrap();
        }
        near(&stage, 12.0, 22.0);
        assert!(number(&mut stage, name, 0.0).is_err());
        near(&stage, 12.0, 22.0);
    }
    // The next gesture begins with the light as it is then.
    stage.grip();
    number(&mut stage, "fit-beam", 5.0).unwrap();
    let field = light(&stage, 0).field;
    assert!(field < 22.0);
    stage.grip();
    number(&mut stage, "fit-beam", 4.9).unwrap();
    number(&mut stage, "fit-beam", 5.0).unwrap();
    near(&stage, 5.0, field);
    // So does what is no step of it.
    choice(&mut stage, "color", "#ff0000").unwrap();
    number(&mut stage, "intensity", 5000.0).unwrap();
    assert_eq!(light(&stage, 0).color, "#ff0000");
    stage.remove_light(0).unwrap();
    assert!(number(&mut stage, "beam", 5.0).is_err());
}

#[test]
fn a_cancelled_gesture_leaves_nothing() {
    let mut stage = stage(Example::Show);
    stage.mark();
    stage.grip();
    let before = stage.state().clone();
    stage.drag_light(0, 0.1, 0.2, 1.5, false).unwrap();
    stage.orbit(0.3, 0.1);
    stage.advance(1.0);
    assert!(stage.cancel().unwrap() && stage.state().is_same_setting(&before));
    assert_eq!((stage.state().seconds, stage.can_return()), ([1.0, 0.0], [false, false]));
    assert!(!stage.cancel().unwrap());
}

#[test]
fn every_fixture_is_a_light() {
    let mut stage = in_floats(Example::BareSpot);
    for fixture in FIXTURES {
        choice(&mut stage, "fixture", fixture.name).unwrap();
        let state = light(&stage, 0);
        assert_eq!(state.fixture, fixture.name);
        assert!(
            (state.field - fixture::middle(fixture)).abs() < 1e-3 * fixture::middle(fixture),
            "{}",
            fixture.name
        );
        assert_eq!(state.zoom, Some(fixture::middle(fixture)));
    }
    let zoom = fixture::find("ARRI L7-C").unwrap();
    choice(&mut stage, "fixture", zoom.name).unwrap();
    choice(&mut stage, "reading", "beam").unwrap();
    assert!((light(&stage, 0).beam - fixture::middle(zoom)).abs() < 1e-3);
    number(&mut stage, "zoom", zoom.widest).unwrap();
    assert!((light(&stage, 0).beam - zoom.widest).abs() < 1e-3);
    let message = number(&mut stage, "zoom", zoom.widest + 1.0).unwrap_err().to_string();
    assert!(message.contains("expected 15 to 50"), "{message}");
    number(&mut stage, "field", 20.0).unwrap();
    assert_eq!(light(&stage, 0).fixture, "");
}

#[test]
fn a_color_comes_back() {
    let mut stage = stage(Example::Gallery);
    for place in 0..stage.state().lights.len() {
        for color in ["#000000", "#ffffff", "#ffd9b3", "#010a7f"] {
            stage.set_choice(place, "color", color).unwrap();
            assert_eq!(light(&stage, place).color, color);
        }
    }
}

#[test]
fn exposure_multiplies_all_light() {
    let mut stage = stage(Example::ThreePoint);
    let intensity = |stage: &Stage| stage.rig().fixtures_at(0.0).unwrap()[0].light().intensity();
    let (before, ambient) = (intensity(&stage), stage.rig().scene().ambient());
    stage.put("exposure", 2.0).unwrap();
    assert_eq!((intensity(&stage), stage.rig().scene().ambient().red), (4.0 * before, 4.0 * ambient.red));
    // The stage shows the light's own intensity, in candela.
    assert_eq!(light(&stage, 0).intensity, 1000.0 * before);
}

#[test]
fn lights_are_copied_and_removed() {
    let mut stage = stage(Example::ThreePoint);
    stage.copy_light(1).unwrap();
    let fixtures = stage.rig().fixtures_at(0.0).unwrap();
    assert!(fixtures.len() == 4 && fixtures[1] == fixtures[2]);
    stage.remove_light(0).unwrap();
    assert_eq!(stage.rig().fixtures_at(0.0).unwrap(), &fixtures[1..]);
    while stage.remove_light(0).is_ok() {}
    assert!(stage.state().lights.is_empty());
    let mut stage = Stage::of(Example::Grid).unwrap();
    while stage.copy_light(0).is_ok() {}
    let refusal = stage.copy_light(0).unwrap_err().to_string();
    assert!(stage.state().lights.len() == LIGHTS && refusal.contains("expected 0 to 80"), "{refusal}");
    assert_eq!(stage.add_light().unwrap_err().to_string(), refusal);
}

/// The picture of a state, at a sixth of the scene's size, as the page draws it.
fn picture(stage: &Stage) -> Vec<u8> {
    let (width, height) = stage.state().scene.size();
    let fixtures = stage.rig().fixtures_at(0.0).unwrap();
    let mut renderer = Renderer::<f32>::new(width.min(160), height.min(160) * 9 / 16).unwrap();
    renderer.draw_geometry(stage.rig().scene(), &stage.camera());
    renderer.draw_shadows(stage.rig().scene(), &fixtures).unwrap();
    renderer.draw_light(&fixtures).unwrap();
    renderer.encode().to_vec()
}

#[test]
fn an_added_light_is_seen_at_once() {
    for &scene in Example::ALL {
        let mut stage = stage(scene);
        let (count, mut places) = (stage.rig().lights(), Vec::new());
        for added in count..count + 4 {
            stage.orbit(0.2, 0.0);
            if added == count + 1 {
                stage.put("exposure", -3.0).unwrap();
            }
            let before = picture(&stage);
            stage.add_light().unwrap();
            let [place, aim] = stage.places(1.5).unwrap()[added];
            let [[x, y], [across, down]] = [place.unwrap(), aim.unwrap()];
            assert!((0.0..1.0).contains(&x) && (0.0..0.5).contains(&y), "{scene:?}: at {x}, {y}");
            assert!(
                [across, down].iter().all(|share| (0.0..1.0).contains(share)),
                "{scene:?}: to {across}, {down}"
            );
            let state = light(&stage, added);
            let lux = state.lux.unwrap() * stage.state().exposure.exp2();
            assert!(state.on && state.is_spot && lux > 0.99 * full_scale(scene), "{scene:?}: {state:?}");
            assert!(!places.contains(&state.position), "{scene:?}: two lights at {:?}", state.position);
            places.push(state.position);
            let after = picture(&stage);
            let pixels = before.chunks_exact(4).zip(after.chunks_exact(4));
            let is_seen = |(before, after): (&[u8], &[u8])| {
                before.iter().zip(after).any(|(before, after)| before.abs_diff(*after) >= 24)
            };
            let share = pixels.filter(|pair| is_seen(*pair)).count() as f32 / (before.len() / 4) as f32;
            assert!(share > 0.02, "{scene:?}: light {added} changes {share} of the picture");
        }
        let fixtures = stage.rig().fixtures_at(0.0).unwrap();
        assert_ne!(fixtures[count], fixtures[count + 1], "{scene:?}");
        let address = address::write(stage.state(), count);
        assert_eq!(address::parse(&address, scene), Ok((stage.state().clone(), Vec::new())));
        stage.put_back(count).unwrap();
        for format in Format::ALL {
            stage.put("format", format.name()).unwrap();
        }
        stage.begin();
        stage.add_light().unwrap();
        stage.undo().unwrap();
        assert_eq!(stage.state().lights.len(), count + 4, "{scene:?}");
    }
}

#[test]
fn what_was_done_is_undone_and_redone() {
    let mut stage = stage(Example::Show);
    assert_eq!(stage.can_return(), [false, false]);
    let opened = stage.state().clone();
    stage.switch("haze", false).unwrap();
    assert_eq!(stage.can_return(), [true, false]);
    stage.mark();
    assert!(!stage.mark(), "nothing has changed");
    stage.open(Example::Grid.name()).unwrap();
    stage.advance(3.0);
    let grid = stage.state().clone();
    stage.undo().unwrap();
    assert_eq!((stage.state().scene, stage.can_return()), (Example::Show, [true, true]));
    stage.advance(1.0);
    stage.undo().unwrap();
    // In the same scene the time goes on.
    assert_eq!(stage.state().seconds, [1.0, 0.0]);
    assert!(stage.state().is_same_setting(&opened) && stage.can_return() == [false, true]);
    stage.undo().unwrap();
    assert!(stage.state().is_same_setting(&opened));
    stage.redo().unwrap();
    stage.redo().unwrap();
    assert!(stage.state().is_same_setting(&grid) && stage.can_return() == [true, false]);
    stage.undo().unwrap();
    stage.put("exposure", 1.0).unwrap();
    stage.mark();
    assert_eq!(stage.can_return(), [true, false], "a new change ends what can be redone");
}

#[test]
fn only_what_can_move_plays() {
    for (scene, plays) in [
        (Example::BareSpot, [false, false]),
        (Example::Grid, [true, false]),
        (Example::Turntable, [true, true]),
    ] {
        let mut stage = stage(scene);
        stage.put("play", "both").unwrap();
        assert_eq!(stage.plays(), plays, "{scene:?}");
        assert_eq!(stage.advance(0.5), plays.contains(&true));
        assert_eq!(stage.state().seconds, plays.map(|plays| if plays { 0.5 } else { 0.0 }));
        stage.advance(f32::NAN);
        stage.advance(-1.0);
        assert_eq!(stage.state().seconds, plays.map(|plays| if plays { 0.5 } else { 0.0 }));
    }
}

#[test]
fn another_scene_keeps_the_format_and_what_plays() {
    let mut stage = stage(Example::Show);
    stage
        .change(|state| (state.format, state.plays, state.exposure) = (Format::Fx32, [false, true], 1.0))
        .unwrap();
    stage.open(Example::Pocket.name()).unwrap();
    let state = stage.state();
    assert_eq!((state.format, state.plays, state.exposure), (Format::Fx32, [false, true], 0.0));
}

/// A light that ends close behind its throw is not made bright enough to arrive there.
#[test]
fn a_range_at_the_throw_keeps_the_intensity_in_bounds() {
    let mut stage = stage(Example::BareSpot);
    let before = light(&stage, 0);
    let throw = before.throw.expect("a surface");
    choice(&mut stage, "law", "smooth-range").unwrap();
    for share in [0.5, 0.999, 1.0, 1.001, 1.05, 1.2, 2.0] {
        number(&mut stage, "law-0", share * throw).unwrap();
        let factor = light(&stage, 0).intensity / before.intensity;
        assert!((0.01..10.0).contains(&factor), "{factor} times the intensity at {share} of the throw");
    }
}

/// What the light at its throw is worth, as a share of full scale: what a law and a kind keep.
fn at_throw(stage: &Stage, light: usize) -> f32 {
    let setting = *stage.setting(light).unwrap();
    let on = |kind| *stage.rig().on(&Setting { kind, ..setting }).unwrap().light();
    let AnyLight::Spot(hung) = on(Some(Effect::Spot)) else { panic!("expected a spotlight") };
    let throw = Surfaces::of(stage.rig().scene()).first(hung.position(), hung.axis()).unwrap();
    arriving(&on(setting.kind), throw) as f32 * on(setting.kind).intensity()
}

#[test]
fn every_law_and_kind_keeps_the_light_at_the_throw_and_has_an_address() {
    // A spotlight, one that sweeps, a directional light, and a point light that ends before the surface.
    let sun = stage(Example::Gallery).rig().lights() - 1;
    for (scene, light) in
        [(Example::BareSpot, 0), (Example::Show, 0), (Example::Gallery, sun), (Example::Gallery, sun - 1)]
    {
        for is_moved in [false, true] {
            let mut stage = stage(scene);
            let opened = stage.rig().fixtures_at(0.0).unwrap();
            if is_moved {
                stage.place_light(light, 0.3, 2.5, 1.5).unwrap();
            }
            let before = at_throw(&stage, light);
            for kind in ["own", "spot", "point", "directional"] {
                let laws = AnyAttenuation::all();
                for law in ["own"].into_iter().chain(laws.iter().map(Chosen::name)) {
                    stage.set_choice(light, "kind", kind).unwrap();
                    stage.set_choice(light, "law", law).unwrap();
                    if law == "polynomial" {
                        stage.set_number(light, "law-1", 2.0).unwrap();
                    }
                    let now = at_throw(&stage, light) / before;
                    assert!((now - 1.0).abs() < 1e-3, "{scene:?}, {kind}, {law}: {now} of the light");
                    let text = address::write(stage.state(), stage.rig().lights());
                    assert_eq!(address::parse(&text, scene), Ok((stage.state().clone(), Vec::new())));
                    for format in Format::ALL {
                        stage.put("format", format.name()).unwrap();
                    }
                }
            }
            ["kind", "law"].iter().for_each(|name| stage.set_choice(light, name, "own").unwrap());
            assert!(is_moved || stage.rig().fixtures_at(0.0).unwrap() == opened, "{scene:?}");
        }
    }
}
