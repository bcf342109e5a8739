//! The desk: what is taken, what is refused, and the way back.

use super::*;
use crate::{
    design::{Design, Mark},
    fixture,
    format::Format,
    job,
    light::{DialEnds, LightState},
    state::EXPOSURES,
};
use luminaire::{
    Vec3,
    dynamic::{Effect, Effects},
};
use luminaire_fixtures::FIXTURES;
use luminaire_render::Renderer;

fn desk(scene: Example) -> Desk {
    Desk::new(scene).unwrap()
}

fn effects(desk: &Desk) -> Effects {
    desk.rig().plan_of(desk.state()).unwrap().effects()
}

fn light(desk: &Desk, light: usize) -> LightState {
    desk.light_state(light).unwrap()
}

fn number(desk: &mut Desk, name: &str, value: f32) -> Result<(), Refusal> {
    desk.set_number(0, name, value)
}

fn choice(desk: &mut Desk, name: &str, value: &str) -> Result<(), Refusal> {
    desk.set_choice(0, name, value)
}

#[test]
fn the_other_half_of_a_picture_has_a_format_that_holds_the_lights() {
    let mut desk = Desk::new(Example::ThreePoint).unwrap();
    let narrow = |desk: &mut Desk| desk.change_light(0, |light| light.design = Design::of(Mark::Field, 0.5));
    desk.set("with", "fx16").unwrap();
    assert!(narrow(&mut desk).unwrap_err().to_string().contains("16-bit fixed point cannot hold light 1"));
    desk.set("with", Value::Nothing).unwrap();
    narrow(&mut desk).unwrap();
    assert!(desk.set("with", "fx16").is_err() && desk.state().other.is_none());
}

#[test]
fn a_scene_opens_as_it_was_composed() {
    for &scene in Example::ALL {
        let (setup, desk) = (scene.setup().unwrap(), desk(scene));
        for seconds in [0.0, 1.3] {
            assert_eq!(desk.rig().fixtures_at(seconds), setup.fixtures_at(seconds), "{scene:?}");
        }
        assert_eq!((desk.rig().scene(), desk.camera()), (&setup.scene, setup.camera), "{scene:?}");
    }
}

#[test]
fn a_light_that_is_switched_off_is_dark_and_keeps_its_number() {
    for &scene in Example::ALL {
        let mut desk = desk(scene);
        let lit = desk.rig().fixtures_at(1.0).unwrap();
        for light in 0..lit.len() {
            desk.change_light(light, |setting| setting.is_on = false).unwrap();
            let mut dark = desk.rig().fixtures_at(1.0).unwrap();
            assert!(dark[light].light().is_dark(), "light {light} of {scene:?}");
            dark[light] = lit[light];
            assert_eq!(dark, lit, "light {light} of {scene:?}");
            desk.change_light(light, |setting| setting.is_on = true).unwrap();
        }
        let refusal = desk.change_light(lit.len(), |_| ()).unwrap_err().to_string();
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
        let mut desk = desk(scene);
        let look =
            |desk: &Desk| (effects(desk), desk.rig().fixtures_at(2.0).unwrap(), desk.rig().scene().clone());
        let before = look(&desk);
        desk.switch(effect.name(), false).unwrap();
        assert!(before.0.has(effect) && !effects(&desk).has(effect), "{scene:?}");
        assert_eq!(effects(&desk).with(effect), before.0);
        desk.switch(effect.name(), true).unwrap();
        assert_eq!(look(&desk), before);
    }
    let refusal = desk(Example::Show).switch("spot", false).unwrap_err().to_string();
    assert!(refusal.contains("\"spot\"") && refusal.contains("specular"), "{refusal}");
}

#[test]
fn haze_dither_and_shadows_are_added_and_taken_away() {
    let mut desk = desk(Example::Turntable);
    let look =
        |desk: &Desk| (effects(desk), desk.rig().fixtures_at(1.0).unwrap(), desk.rig().scene().clone());
    assert!(effects(&desk).has(Effect::Dither));
    desk.switch("dither", false).unwrap();
    let before = look(&desk);
    for effect in [Effect::Haze, Effect::Dither, Effect::Shadow] {
        assert!(!before.0.has(effect));
        desk.switch(effect.name(), true).unwrap();
        assert!(effects(&desk).has(effect), "{effect:?}");
    }
    let sides = |desk: &Desk| -> Vec<_> {
        let fixtures = desk.rig().fixtures_at(1.0).unwrap();
        fixtures.iter().map(|fixture| fixture.shadow().map(|(side, _)| side)).collect()
    };
    assert!(desk.rig().scene().haze().is_some() && desk.rig().display(desk.state()).is_dithered());
    assert_eq!(sides(&desk), [Some(512); 8]);
    for effect in [Effect::Haze, Effect::Dither, Effect::Shadow] {
        desk.switch(effect.name(), false).unwrap();
    }
    assert_eq!(look(&desk), before);
    for (side, is_taken) in [(64, true), (5, false)] {
        let rig = job::rig(Example::Turntable, Some((8, Some(side)))).unwrap();
        let mut desk = Desk::with_rig(Example::Turntable, rig);
        assert_eq!(desk.switch("shadow", true).is_ok(), is_taken);
        assert_eq!(sides(&desk), [Some(side).filter(|_| is_taken); 8]);
    }
}

#[test]
fn the_angles_follow_one_another() {
    let mut desk = desk(Example::BareSpot);
    number(&mut desk, "field", 15.0).unwrap();
    let state = light(&desk, 0);
    assert!((state.beam - 9.81).abs() < 0.005 && (state.outer - 18.15).abs() < 0.005);
    number(&mut desk, "beam", state.beam).unwrap();
    assert!((light(&desk, 0).field - 15.0).abs() < 1e-3);
    // Another edge keeps the angle that was set last.
    choice(&mut desk, "edge", "hard").unwrap();
    assert!((light(&desk, 0).beam - state.beam).abs() < 1e-3);
    choice(&mut desk, "edge", "own").unwrap();
    assert!((light(&desk, 0).field - 15.0).abs() < 1e-3);
}

#[test]
fn both_angles_are_given_and_stay_as_they_were_given() {
    let mut desk = desk(Example::BareSpot);
    number(&mut desk, "field", 20.0).unwrap();
    number(&mut desk, "fit-beam", 7.0).unwrap();
    number(&mut desk, "fit-field", 15.0).unwrap();
    let angles = |desk: &Desk| (light(desk, 0).beam, light(desk, 0).field, light(desk, 0).edge);
    let near = |(beam, field, edge): (f32, f32, String), expected: (f32, f32)| {
        assert!((beam - expected.0).abs() < 1e-3 && (field - expected.1).abs() < 1e-3, "{beam} {field}");
        assert_eq!(edge, "fitted");
    };
    near(angles(&desk), (7.0, 15.0));
    number(&mut desk, "beam", 10.0).unwrap();
    near(angles(&desk), (10.0, 15.0));
    let [_, _, least, most] = light(&desk, 0).reach[..] else { panic!("nothing is reached") };
    assert!((least - 10.0).abs() < 1e-3 && (23.0..24.0).contains(&most), "{least} to {most}");
    number(&mut desk, "field", 40.0).unwrap();
    assert!(light(&desk, 0).beam > 17.0, "the beam does not follow");
    // Another edge has one angle.
    choice(&mut desk, "edge", "smooth").unwrap();
    assert!((light(&desk, 0).field - 40.0).abs() < 1e-3 && light(&desk, 0).edge == "smooth");
    choice(&mut desk, "edge", "fitted").unwrap();
    let state = light(&desk, 0);
    number(&mut desk, "fit-field", state.field).unwrap();
    near(angles(&desk), (state.beam, state.field));
}

/// The light at the centre rises as the flux is gathered in a narrower cone: by the ratio of the
/// solid angles.
#[test]
fn a_zoom_conserves_the_flux() {
    let mut desk = desk(Example::BareSpot);
    choice(&mut desk, "edge", "soft").unwrap();
    number(&mut desk, "field", 10.0).unwrap();
    let wide = light(&desk, 0);
    number(&mut desk, "field", 5.0).unwrap();
    let narrow = light(&desk, 0);
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
    desk.zoom_light(0, 2.0).unwrap();
    assert!((light(&desk, 0).intensity / wide.intensity - 1.0).abs() < 1e-3);
    // Another edge gives another intensity, and the same flux.
    for edge in ["hard", "step", "fitted", "power", "own"] {
        choice(&mut desk, "edge", edge).unwrap();
        let lumens = light(&desk, 0).lumens.unwrap();
        assert!((lumens / wide.lumens.unwrap() - 1.0).abs() < 1e-3, "{edge}: {lumens} lm");
    }
}

#[test]
fn a_fixture_brings_its_lumens() {
    let mut desk = desk(Example::ThreePoint);
    let bright = FIXTURES.iter().filter(|fixture| fixture.lumens.is_some());
    let mut count = 0;
    for fixture in bright {
        choice(&mut desk, "fixture", fixture.name).unwrap();
        for factor in [0.5, 3.0, 0.9] {
            let lumens = light(&desk, 0).lumens.unwrap();
            assert!((lumens / fixture.lumens.unwrap() - 1.0).abs() < 1e-3, "{}: {lumens} lm", fixture.name);
            desk.zoom_light(0, factor).unwrap();
        }
        count += 1;
    }
    assert!(count > 20, "{count} fixtures have a flux");
    number(&mut desk, "intensity", 5000.0).unwrap();
    assert!((light(&desk, 0).intensity - 5000.0).abs() < 0.01);
    // The exposure that shows the pool as full scale.
    desk.expose_for(0).unwrap();
    let shown = light(&desk, 0).lux.unwrap() * desk.state().exposure.exp2() / 1000.0;
    assert!((0.9..1.1).contains(&shown), "{shown} of full scale");
}

#[test]
fn a_refused_value_changes_nothing() {
    let mut desk = desk(Example::BareSpot);
    number(&mut desk, "field", 15.0).unwrap();
    let before = desk.state().clone();
    let refused = |outcome: Result<(), Refusal>, words: &str| {
        let message = outcome.unwrap_err().to_string();
        assert!(message.contains(words), "{message}");
    };
    for degrees in [0.0, -10.0, 400.0, 150.0, f32::NAN, f32::INFINITY] {
        refused(number(&mut desk, "field", degrees), "field angle");
        refused(number(&mut desk, "beam", degrees), "beam angle");
    }
    refused(number(&mut desk, "intensity", -1.0), "intensity");
    refused(number(&mut desk, "intensity", f32::NAN), "intensity");
    refused(number(&mut desk, "zoom", 20.0), "fixture");
    refused(number(&mut desk, "length", 1.0), "number of a light");
    refused(choice(&mut desk, "fixture", "Nobody's lamp"), "fixture = \"Nobody's lamp\"");
    refused(choice(&mut desk, "edge", ""), "edge");
    refused(choice(&mut desk, "reading", "outer"), "beam or field");
    for color in ["", "#fff", "ffffff", "#gggggg", "#ffffff0", "#ééé", "#+1+1+1"] {
        refused(choice(&mut desk, "color", color), "color");
    }
    refused(desk.set("exposure", 7.0), "exposure");
    refused(desk.set("exposure", f32::NAN), "exposure");
    let position = desk.rig().fixtures_at(0.0).unwrap();
    let luminaire::dynamic::AnyLight::Spot(spot) = position[0].light() else { panic!("no spot") };
    let position = spot.position();
    refused(desk.change_light(0, |setting| setting.target = Some(position)), "axis");
    assert_eq!(desk.state(), &before);
}

#[test]
fn a_format_that_cannot_hold_a_light_is_refused() {
    let mut desk = desk(Example::ThreePoint);
    number(&mut desk, "beam", 1.0).unwrap();
    let refusal = desk.set("format", "fx16").unwrap_err().to_string();
    assert!(
        refusal.contains("16-bit") && refusal.contains("light 1") && refusal.contains("outer angle"),
        "{refusal}"
    );
    assert_eq!(desk.state().format, Format::F32);
    number(&mut desk, "beam", 20.0).unwrap();
    desk.set("format", "fx16").unwrap();
    assert!(number(&mut desk, "beam", 1.0).is_err());
}

/// Sets both ends of every dial of a light, from the light as it is or from the ends of its dials. Returns
/// the number of values.
fn turn_dials(desk: &mut Desk, light: usize, starts: &[Option<usize>]) -> usize {
    let (opened, mut count) = (desk.state().clone(), 0);
    for first in starts {
        let dials = |desk: &Desk| {
            let DialEnds { beam, field, zoom, intensity } = desk.dial_ends(light).unwrap();
            [("beam", beam), ("field", field), ("zoom", zoom), ("intensity", intensity)]
        };
        for (name, ends) in dials(desk) {
            desk.adopt(opened.clone()).unwrap();
            if let Some(end) = first.and_then(|end| ends.get(end)) {
                desk.set_number(light, name, *end).unwrap();
            }
            desk.grip();
            for (name, ends) in dials(desk) {
                for end in ends {
                    let outcome = desk.set_number(light, name, end);
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
            let mut desk = desk(scene);
            desk.set("format", format.name()).unwrap();
            let mut names = Vec::new();
            for light in 0..desk.state().lights.len() {
                let name = desk.light_state(light).unwrap().name;
                if !names.contains(&name) {
                    count += turn_dials(&mut desk, light, &[None]);
                    names.push(name);
                }
            }
            for stops in EXPOSURES {
                desk.set("exposure", stops).unwrap();
            }
        }
    }
    for format in Format::ALL {
        for (name, value) in ["soft", "hard", "fitted", "power"]
            .map(|edge| ("edge", edge))
            .into_iter()
            .chain(["ARRI L7-C", FIXTURES[0].name, FIXTURES[40].name].map(|name| ("fixture", name)))
        {
            let mut desk = desk(Example::ThreePoint);
            desk.set("format", format.name()).unwrap();
            // The 16-bit format does not hold every fixture.
            if choice(&mut desk, name, value).is_ok() {
                count += turn_dials(&mut desk, 0, &[None, Some(0), Some(1)]);
            }
        }
    }
    assert!(count > 500, "only {count} values");
}

/// Each value of a gesture is computed from the light as it was when the gesture began.
#[test]
fn gestures_end_where_they_began() {
    let mut desk = desk(Example::BareSpot);
    number(&mut desk, "field", 22.0).unwrap();
    number(&mut desk, "fit-beam", 12.0).unwrap();
    let before = light(&desk, 0);
    let near = |desk: &Desk, beam: f32, field: f32| {
        let now = light(desk, 0);
        assert!((now.beam / beam - 1.0).abs() < 1e-4 && (now.field / field - 1.0).abs() < 1e-4, "{now:?}");
        let flux = now.lumens.unwrap() / before.lumens.unwrap();
        assert!((flux - 1.0).abs() < 1e-3, "{flux} of the flux");
    };
    for name in ["beam", "fit-beam"] {
        let [narrowest, widest] = desk.dial_ends(0).unwrap().beam[..] else { panic!("no dial") };
        desk.grip();
        for value in [5.0, narrowest, widest, 2.0, 12.0] {
            number(&mut desk, name, value).unwrap();
        }
        near(&desk, 12.0, 22.0);
        assert!(number(&mut desk, name, 0.0).is_err());
        near(&desk, 12.0, 22.0);
    }
    // The next gesture begins with the light as it is then.
    desk.grip();
    number(&mut desk, "fit-beam", 5.0).unwrap();
    let field = light(&desk, 0).field;
    assert!(field < 22.0);
    desk.grip();
    number(&mut desk, "fit-beam", 4.9).unwrap();
    number(&mut desk, "fit-beam", 5.0).unwrap();
    near(&desk, 5.0, field);
    // So does what is no step of it.
    choice(&mut desk, "color", "#ff0000").unwrap();
    number(&mut desk, "intensity", 5000.0).unwrap();
    assert_eq!(light(&desk, 0).color, "#ff0000");
    desk.remove_light(0).unwrap();
    assert!(number(&mut desk, "beam", 5.0).is_err());
}

#[test]
fn a_cancelled_gesture_leaves_nothing() {
    let mut desk = desk(Example::Show);
    desk.mark();
    desk.grip();
    let before = desk.state().clone();
    desk.drag_light(0, [0.1, 0.2], 1.5, false).unwrap();
    desk.orbit(0.3, 0.1);
    desk.advance(1.0);
    assert!(desk.cancel().unwrap() && desk.state().is_same_setting(&before));
    assert_eq!((desk.state().seconds, desk.can_return()), ([1.0, 0.0], [false, false]));
    assert!(!desk.cancel().unwrap());
}

#[test]
fn every_fixture_is_a_light() {
    let mut desk = desk(Example::BareSpot);
    for fixture in FIXTURES {
        choice(&mut desk, "fixture", fixture.name).unwrap();
        let state = light(&desk, 0);
        assert_eq!(state.fixture, fixture.name);
        assert!(
            (state.field - fixture::middle(fixture)).abs() < 1e-3 * fixture::middle(fixture),
            "{}",
            fixture.name
        );
        assert_eq!(state.zoom, Some(fixture::middle(fixture)));
    }
    let zoom = fixture::find("ARRI L7-C").unwrap();
    choice(&mut desk, "fixture", zoom.name).unwrap();
    choice(&mut desk, "reading", "beam").unwrap();
    assert!((light(&desk, 0).beam - fixture::middle(zoom)).abs() < 1e-3);
    number(&mut desk, "zoom", zoom.widest).unwrap();
    assert!((light(&desk, 0).beam - zoom.widest).abs() < 1e-3);
    let message = number(&mut desk, "zoom", zoom.widest + 1.0).unwrap_err().to_string();
    assert!(message.contains("expected 15 to 50"), "{message}");
    number(&mut desk, "field", 20.0).unwrap();
    assert_eq!(light(&desk, 0).fixture, "");
}

#[test]
fn a_color_comes_back() {
    let mut desk = desk(Example::Gallery);
    for place in 0..desk.state().lights.len() {
        for color in ["#000000", "#ffffff", "#ffd9b3", "#010a7f"] {
            desk.set_choice(place, "color", color).unwrap();
            assert_eq!(light(&desk, place).color, color);
        }
    }
}

#[test]
fn exposure_multiplies_all_light() {
    let mut desk = desk(Example::ThreePoint);
    let intensity = |desk: &Desk| desk.rig().fixtures_at(0.0).unwrap()[0].light().intensity();
    let (before, ambient) = (intensity(&desk), desk.rig().scene().ambient());
    desk.set("exposure", 2.0).unwrap();
    assert_eq!((intensity(&desk), desk.rig().scene().ambient().red), (4.0 * before, 4.0 * ambient.red));
    // The desk shows the light's own intensity, in candela.
    assert_eq!(light(&desk, 0).intensity, 1000.0 * before);
}

#[test]
fn a_light_with_a_target_aims_at_it_and_stands_still() {
    let mut desk = desk(Example::Show);
    let target = Vec3::new(1.0, 0.0, 2.0);
    desk.change_light(0, |setting| setting.target = Some(target)).unwrap();
    let axis = |seconds| match desk.rig().fixtures_at(seconds).unwrap()[0].light() {
        luminaire::dynamic::AnyLight::Spot(spot) => (spot.axis(), spot.position()),
        _ => panic!("no spot"),
    };
    let (still, position) = axis(0.0);
    assert_eq!(axis(2.0), (still, position));
    let way = target.zip(position, |to, from| to - from);
    assert!((still.dot(way) - way.dot(way).sqrt()).abs() < 1e-4);
}

#[test]
fn lights_are_copied_and_removed() {
    let mut desk = desk(Example::ThreePoint);
    desk.copy_light(1).unwrap();
    let fixtures = desk.rig().fixtures_at(0.0).unwrap();
    assert!(fixtures.len() == 4 && fixtures[1] == fixtures[2]);
    desk.remove_light(0).unwrap();
    assert_eq!(desk.rig().fixtures_at(0.0).unwrap(), &fixtures[1..]);
    while desk.remove_light(0).is_ok() {}
    assert!(desk.state().lights.is_empty());
    let mut desk = Desk::new(Example::Grid).unwrap();
    while desk.copy_light(0).is_ok() {}
    let refusal = desk.copy_light(0).unwrap_err().to_string();
    assert!(desk.state().lights.len() == LIGHTS && refusal.contains("expected 0 to 80"), "{refusal}");
    assert_eq!(desk.add_light().unwrap_err().to_string(), refusal);
}

/// The picture of a state, at a sixth of the scene's size, as the page draws it.
fn picture(desk: &Desk) -> Vec<u8> {
    let (width, height) = desk.state().scene.size();
    let fixtures = desk.rig().fixtures_at(0.0).unwrap();
    let mut renderer = Renderer::<f32>::new(width.min(160), height.min(160) * 9 / 16).unwrap();
    renderer.draw_geometry(desk.rig().scene(), &desk.camera());
    renderer.draw_shadows(desk.rig().scene(), &fixtures).unwrap();
    renderer.draw_light(&fixtures).unwrap();
    renderer.encode().to_vec()
}

#[test]
fn an_added_light_is_seen_at_once() {
    for &scene in Example::ALL {
        let mut desk = desk(scene);
        let (count, mut places) = (desk.rig().lights(), Vec::new());
        for added in count..count + 4 {
            desk.orbit(0.2, 0.0);
            if added == count + 1 {
                desk.set("exposure", -3.0).unwrap();
            }
            let before = picture(&desk);
            desk.add_light().unwrap();
            let [place, aim] = desk.places(1.5).unwrap()[added];
            let [[x, y], [across, down]] = [place.unwrap(), aim.unwrap()];
            assert!((0.0..1.0).contains(&x) && (0.0..0.5).contains(&y), "{scene:?}: at {x}, {y}");
            assert!(
                [across, down].iter().all(|share| (0.0..1.0).contains(share)),
                "{scene:?}: to {across}, {down}"
            );
            let state = light(&desk, added);
            let lux = state.lux.unwrap() * desk.state().exposure.exp2();
            assert!(state.on && state.is_spot && lux > 0.99 * full_scale(scene), "{scene:?}: {state:?}");
            assert!(!places.contains(&state.position), "{scene:?}: two lights at {:?}", state.position);
            places.push(state.position);
            let after = picture(&desk);
            let pixels = before.chunks_exact(4).zip(after.chunks_exact(4));
            let is_seen = |(before, after): (&[u8], &[u8])| {
                before.iter().zip(after).any(|(before, after)| before.abs_diff(*after) >= 24)
            };
            let share = pixels.filter(|pair| is_seen(*pair)).count() as f32 / (before.len() / 4) as f32;
            assert!(share > 0.02, "{scene:?}: light {added} changes {share} of the picture");
        }
        let fixtures = desk.rig().fixtures_at(0.0).unwrap();
        assert_ne!(fixtures[count], fixtures[count + 1], "{scene:?}");
        let address = address::write(desk.state(), count);
        assert_eq!(address::parse(&address, scene), Ok((desk.state().clone(), Vec::new())));
        desk.put_back(count).unwrap();
        for format in Format::ALL {
            desk.set("format", format.name()).unwrap();
        }
        desk.begin();
        desk.add_light().unwrap();
        desk.undo().unwrap();
        assert_eq!(desk.state().lights.len(), count + 4, "{scene:?}");
    }
}

#[test]
fn what_was_done_is_undone_and_redone() {
    let mut desk = desk(Example::Show);
    assert_eq!(desk.can_return(), [false, false]);
    let opened = desk.state().clone();
    desk.switch("haze", false).unwrap();
    assert_eq!(desk.can_return(), [true, false]);
    desk.mark();
    assert!(!desk.mark(), "nothing has changed");
    desk.open(Example::Grid).unwrap();
    desk.advance(3.0);
    let grid = desk.state().clone();
    desk.undo().unwrap();
    assert_eq!((desk.state().scene, desk.can_return()), (Example::Show, [true, true]));
    desk.advance(1.0);
    desk.undo().unwrap();
    // In the same scene the time goes on.
    assert_eq!(desk.state().seconds, [1.0, 0.0]);
    assert!(desk.state().is_same_setting(&opened) && desk.can_return() == [false, true]);
    desk.undo().unwrap();
    assert!(desk.state().is_same_setting(&opened));
    desk.redo().unwrap();
    desk.redo().unwrap();
    assert!(desk.state().is_same_setting(&grid) && desk.can_return() == [true, false]);
    desk.undo().unwrap();
    desk.set("exposure", 1.0).unwrap();
    desk.mark();
    assert_eq!(desk.can_return(), [true, false], "a new change ends what can be redone");
}

#[test]
fn only_what_can_move_plays() {
    for (scene, plays) in [
        (Example::BareSpot, [false, false]),
        (Example::Grid, [true, false]),
        (Example::Turntable, [true, true]),
    ] {
        let mut desk = desk(scene);
        desk.set("play", "both").unwrap();
        assert_eq!(desk.plays(), plays, "{scene:?}");
        assert_eq!(desk.advance(0.5), plays.contains(&true));
        assert_eq!(desk.state().seconds, plays.map(|plays| if plays { 0.5 } else { 0.0 }));
        desk.advance(f32::NAN);
        desk.advance(-1.0);
        assert_eq!(desk.state().seconds, plays.map(|plays| if plays { 0.5 } else { 0.0 }));
    }
}

#[test]
fn another_scene_keeps_the_format_and_what_plays() {
    let mut desk = desk(Example::Show);
    desk.change(|state| (state.format, state.plays, state.exposure) = (Format::Fx32, [false, true], 1.0))
        .unwrap();
    desk.open(Example::Pocket).unwrap();
    let state = desk.state();
    assert_eq!((state.format, state.plays, state.exposure), (Format::Fx32, [false, true], 0.0));
}
