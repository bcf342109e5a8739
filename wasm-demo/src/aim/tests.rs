//! Lights in the picture: projection, picking, and what a pointer moves.

use super::*;
use luminaire_render::scenes::Example;

const ASPECT: f32 = 16.0 / 9.0;

fn stage(scene: Example) -> Stage {
    Stage::of(scene).unwrap()
}

fn spot(stage: &Stage, light: usize) -> ([f32; 3], [f32; 3]) {
    match stage.lit(light).unwrap() {
        AnyLight::Spot(spot) => (spot.position().into(), spot.axis().into()),
        _ => panic!("no spot"),
    }
}

fn near(one: [f32; 3], other: [f32; 3]) -> bool {
    one.iter().zip(other).all(|(a, b)| (a - b).abs() < 2e-3)
}

#[test]
fn every_light_aims_at_a_surface_of_its_scene() {
    for &scene in Example::ALL {
        let stage = stage(scene);
        for light in 0..stage.state().lights.len() {
            let state = stage.light_state(light).unwrap();
            if state.is_spot {
                assert!(state.throw.is_some_and(|throw| throw > 0.1), "light {light} of {scene:?}");
                assert!(state.lux > Some(0.0), "light {light} of {scene:?}: {:?} lx", state.lux);
            }
            assert_eq!(state.position.is_empty(), state.unit == "lx", "light {light} of {scene:?}");
        }
    }
}

#[test]
fn a_light_follows_the_pointer_and_keeps_its_aim() {
    let mut stage = stage(Example::ThreePoint);
    let aim = stage.light_state(2).unwrap().aim;
    for (place, is_level) in [([0.6, 0.3], false), ([0.45, 0.45], true)] {
        let before = spot(&stage, 2).0;
        stage.drag_light(2, place[0], place[1], ASPECT, is_level).unwrap();
        let [Some(found), _] = stage.places(ASPECT).unwrap()[2] else { panic!("not in the picture") };
        assert!((found[0] - place[0]).abs() < 1e-3 && (found[1] - place[1]).abs() < 1e-3, "{found:?}");
        let (after, now) = (spot(&stage, 2).0, stage.light_state(2).unwrap().aim);
        assert_eq!((after[1] - before[1]).abs() < 1e-3, is_level, "{before:?} {after:?}");
        assert!(now.iter().zip(&aim).all(|(a, b)| (a - b).abs() < 1e-3), "{aim:?} {now:?}");
    }
    stage.put_back(2).unwrap();
    assert_eq!(stage.state(), Stage::of(Example::ThreePoint).unwrap().state());
}

#[test]
fn a_pool_follows_the_pointer_onto_the_surface() {
    let mut stage = stage(Example::BareSpot);
    for place in [[0.5, 0.75], [0.3, 0.7], [0.6, 0.4]] {
        stage.drag_aim(0, place[0], place[1], ASPECT).unwrap();
        let [_, Some(found)] = stage.places(ASPECT).unwrap()[0] else { panic!("not in the picture") };
        assert!(
            (found[0] - place[0]).abs() < 0.01 && (found[1] - place[1]).abs() < 0.01,
            "{found:?} {place:?}"
        );
    }
    // Where no surface is, the light still aims toward the pointer.
    let before = spot(&stage, 0).1;
    stage.orbit(0.0, -1.0);
    stage.drag_aim(0, 0.5, -3.0, ASPECT).unwrap();
    assert_ne!(spot(&stage, 0).1, before);
    stage.drag_aim(0, f32::NAN, 0.5, ASPECT).unwrap_err();
}

/// A light that sweeps goes on sweeping where it is moved to, and stops where it is aimed.
#[test]
fn a_sweep_ends_with_an_aim_and_not_with_a_move() {
    let mut stage = stage(Example::Show);
    let moves = |stage: &mut Stage| {
        let before = spot(stage, 0).1;
        stage.advance(1.0);
        spot(stage, 0).1 != before
    };
    stage.drag_light(0, 0.3, 0.2, ASPECT, false).unwrap();
    assert!(moves(&mut stage) && stage.light_state(0).unwrap().sweeps);
    stage.drag_aim(0, 0.5, 0.8, ASPECT).unwrap();
    assert!(!moves(&mut stage) && !stage.light_state(0).unwrap().sweeps);
    stage.put_back(0).unwrap();
    assert!(moves(&mut stage));
}

#[test]
fn a_pool_surrounds_the_aim() {
    let stage = stage(Example::Grid);
    let pool = stage.pool(27, ASPECT).unwrap();
    let [Some(light), Some(aim)] = stage.places(ASPECT).unwrap()[27] else { panic!("not in the picture") };
    let points: Vec<_> = pool[2..].iter().flatten().collect();
    assert_eq!(points.len(), RAYS, "the floor is one surface");
    let share = 1.0 / points.len() as f32;
    let centre = points.iter().fold([0.0, 0.0], |[x, y], [u, v]| [x + u * share, y + v * share]);
    assert!((centre[0] - aim[0]).abs() < 0.01 && (centre[1] - aim[1]).abs() < 0.02, "{centre:?} {aim:?}");
    let [Some(left), Some(right)] = pool[..2] else { panic!("no sides") };
    assert!((left[0] - light[0]) * (right[0] - light[0]) < 0.0, "{left:?} {light:?} {right:?}");
    let stage = Stage::of(Example::Gallery).unwrap();
    for light in 0..stage.state().lights.len() {
        let pool = stage.pool(light, ASPECT).unwrap();
        assert_eq!(pool.is_empty(), !stage.light_state(light).unwrap().is_spot);
    }
}

/// The outline leaves out what a few rays meet, also across the start of the ring.
#[test]
fn an_outline_leaves_out_small_objects() {
    let ring = |near: &[usize]| {
        let mut distances = [5.0; RAYS];
        near.iter().for_each(|&i| distances[i % RAYS] = 4.0);
        on_large_surfaces(&distances)
    };
    assert_eq!(ring(&[]), [true; RAYS]);
    let small: Vec<_> = (RAYS - 4..RAYS + FEWEST - 5).collect();
    let kept = ring(&small);
    assert!((0..RAYS).all(|i| kept[i] != small.iter().any(|&object| object % RAYS == i)), "{kept:?}");
    let large: Vec<_> = (RAYS - 4..RAYS + FEWEST - 4).collect();
    assert_eq!(ring(&large), [true; RAYS]);
    let scattered: Vec<f32> = (0..RAYS).map(|i| 1.0 + (i % 2) as f32).collect();
    assert_eq!(on_large_surfaces(&scattered), [true; RAYS]);
}

/// The line is cut where it would cross from one surface to another.
#[test]
fn an_outline_is_cut_at_steps_of_depth() {
    assert_eq!(pieces(vec![(4.0, 'a'), (4.1, 'b'), (4.0, 'c')]), ['a', 'b', 'c'].map(Some));
    let cut = pieces(vec![(4.0, 'a'), (5.0, 'b'), (5.1, 'c'), (4.1, 'd')]);
    assert_eq!(cut, [Some('d'), Some('a'), None, Some('b'), Some('c'), None]);
    assert_eq!(pieces::<char>(Vec::new()), []);
}

#[test]
fn a_position_that_no_light_can_have_is_refused() {
    let mut stage = stage(Example::BareSpot);
    let before = stage.state().clone();
    assert!(stage.place(0, Vec3::new(f32::NAN, 0.0, 0.0)).is_err());
    assert!(stage.aim(0, Vec3::new(f32::INFINITY, 0.0, 0.0)).is_err());
    let (position, _) = spot(&stage, 0);
    assert!(stage.aim(0, position.into()).is_err());
    assert!(stage.place(7, Vec3::new(0.0, 1.0, 0.0)).is_err());
    assert_eq!(stage.state(), &before);
    assert!(near(spot(&stage, 0).0, position));
}

#[test]
fn the_distances_of_a_light_enclose_its_throw() {
    for &scene in Example::ALL {
        let stage = stage(scene);
        for light in 0..stage.rig().lights() {
            let (distances, throw) =
                (stage.distances(light).unwrap(), stage.light_state(light).unwrap().throw);
            let Some(throw) = throw else { continue };
            let [near, far] = distances[..] else { panic!("{scene:?}, light {light}: {distances:?}") };
            assert!(
                near > 0.0 && near <= throw && throw <= far,
                "{scene:?}, light {light}: {distances:?}, {throw}"
            );
        }
    }
    // Straight down onto a floor.
    let mut stage = stage(Example::Grid);
    stage.place_light(0, 0.0, 3.0, 0.0).unwrap();
    stage.aim_light(0, 0.0, 0.0, 0.0).unwrap();
    let rim = 3.0 / (stage.light_state(0).unwrap().outer / 2.0).to_radians().cos();
    let [near, far] = stage.distances(0).unwrap()[..] else { panic!("no surface") };
    assert!((near - 3.0).abs() < 1e-4 && (far - rim).abs() < 1e-3, "{near} to {far}, expected 3 to {rim}");
}
