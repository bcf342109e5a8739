//! A picture that several renderers share is bit-identical to the picture of one renderer, and they find
//! the same edges.

use luminaire::{Fx16, Fx32, Vec3, projector::Fixture};
use luminaire_render::{
    Account, Camera, Display, Edges, Format, Output, Renderer, Scene, SizeError, Stripes,
    scenes::{Example, Setup, stage, turntable},
};

/// Not whole tiles in either direction, and more stripes than shares.
const SIZE: (usize, usize) = (170, 150);

/// The renderers of all shares of a picture, and one of the whole picture.
struct Team<S: Format> {
    whole: Renderer<S>,
    shares: Vec<Renderer<S>>,
}

impl<S: Format> Team<S> {
    fn new(count: usize) -> Self {
        let share = |stripes| {
            let mut renderer = Renderer::of_stripes(SIZE.0, SIZE.1, stripes).unwrap();
            renderer.set_antialiased(true);
            renderer
        };
        let shares = (0..count).map(|number| share(Stripes::new(number, count).unwrap()));
        Self { whole: share(Stripes::ALL), shares: shares.collect() }
    }

    /// Draws a picture in both ways and compares everything that a renderer tells of it. Returns the
    /// number of shadow maps that were drawn.
    fn must_agree(
        &mut self,
        what: &str,
        scene: &Scene,
        camera: &Camera,
        lights: &[Fixture],
        display: Display,
    ) -> usize {
        self.whole.draw_geometry(scene, camera);
        self.whole.draw_shadows(scene, lights).unwrap();
        self.whole.draw_light(lights).unwrap();
        self.whole.set_display(display);
        self.whole.encode();

        let mut maps = Vec::new();
        for (owner, renderer) in self.shares.iter_mut().enumerate() {
            for number in renderer.draw_own_shadows(scene, lights).unwrap() {
                let depths: Vec<u32> = renderer.shadow_map(number).expect("a map").collect();
                maps.push((owner, number, depths));
            }
        }
        let (mut marks, mut picture) = (Vec::new(), vec![0; self.whole.pixels().len()]);
        for (share, renderer) in self.shares.iter_mut().enumerate() {
            for (_, number, depths) in maps.iter().filter(|(owner, ..)| *owner != share) {
                renderer.take_shadow_map(scene, lights, *number, depths).unwrap();
            }
            renderer.draw_geometry(scene, camera);
            renderer.draw_light(lights).unwrap();
            renderer.set_display(display);
            let rows = renderer.stripes().rows(SIZE.1).flatten();
            for (row, pixels) in rows.zip(renderer.encode().chunks_exact(4 * SIZE.0)) {
                picture[4 * SIZE.0 * row..][..pixels.len()].copy_from_slice(pixels);
            }
            marks.extend(renderer.edge_marks());
        }
        let mut edges = Edges::new();
        edges.take(marks);
        edges.mix(display, SIZE.0, &mut picture);
        assert!(picture == self.whole.pixels(), "{what}: the picture differs");
        self.must_tell_the_same(what);
        maps.len()
    }

    fn must_tell_the_same(&self, what: &str) {
        for y in 0..SIZE.1 {
            for x in 0..SIZE.0 {
                let tell = |renderer: &Renderer<S>| {
                    let light = renderer.linear(x, y)?.map(f32::to_bits);
                    Some((light, renderer.lights_evaluated(x, y)?, renderer.is_relit(x, y)?))
                };
                let told: Vec<_> = self.shares.iter().filter_map(tell).collect();
                assert_eq!(told, [tell(&self.whole).unwrap()], "{what}: the pixel at {x}, {y}");
            }
        }
        let sum = |count: fn(&Account) -> u64| -> u64 {
            self.shares.iter().map(|renderer| count(&renderer.account())).sum()
        };
        let whole = self.whole.account();
        for (count, name) in [
            (Account::pairs as fn(&Account) -> u64, "pairs"),
            (|account| account.evaluated, "evaluated"),
            (|account| account.evaluated_shining, "shining"),
            (|account| account.evaluated_through_gobos, "through gobos"),
            (|account| account.evaluated_in_shadows, "in shadows"),
            (|account| account.evaluated_in_air, "in air"),
            (|account| account.kept, "kept"),
            (|account| account.tiles.into(), "tiles"),
            (|account| account.tiles_relit.into(), "tiles re-lit"),
        ] {
            assert_eq!(sum(count), count(&whole), "{what}: {name}");
        }
    }
}

fn agree<S: Format>(name: &str, setup: &Setup, count: usize) {
    let mut team = Team::<S>::new(count);
    let mut camera = setup.camera_at(0.0);
    for (frame, seconds) in [0.0, 0.4, 0.4, 0.9].into_iter().enumerate() {
        let lights = setup.fixtures_at(seconds).unwrap();
        let display = if frame < 3 { Output::Rgb888.dithered() } else { Output::Rgb565.dithered() };
        if frame > 1 {
            camera.orbit(0.3, 0.1);
        }
        let what = format!("{name} in {} by {count}, frame {frame}", S::NAME);
        team.must_agree(&what, &setup.scene, &camera, &lights, display);
    }
}

#[test]
fn shares_of_every_scene_have_the_bits_of_the_whole() {
    for &scene in Example::ALL {
        let setup = scene.setup().unwrap();
        agree::<f32>(scene.name(), &setup, 2);
        if matches!(scene, Example::Show | Example::ThreePoint | Example::Gallery) {
            agree::<f32>(scene.name(), &setup, 4);
        }
    }
}

#[test]
fn shares_in_fixed_point_have_the_bits_of_the_whole() {
    let setup = Example::ThreePoint.setup().unwrap();
    agree::<Fx32>("three-point", &setup, 2);
    agree::<Fx16>("three-point", &setup, 3);
    agree::<Fx16>("turntable", &turntable(5).unwrap(), 2);
}

/// More shares than stripes: some renderers draw nothing.
#[test]
fn a_share_may_be_empty() {
    agree::<f32>("turntable", &turntable(2).unwrap(), 16);
}

/// Each map is drawn once, whichever share it is dealt to, and a change of one light is the change
/// of one map.
#[test]
fn shadow_maps_are_dealt_and_passed_on() {
    let (scene, mut camera) = (stage::scene().unwrap(), stage::camera());
    let lights = |turn: f32, is_on: bool| -> Vec<Fixture> {
        let mut lights = stage::lights().unwrap();
        if !is_on {
            lights[0] = lights[0].with_intensity(0.0).unwrap();
        }
        let axis = lights[1].axis();
        lights[1] = lights[1].with_axis(Vec3::new(axis.x + turn, axis.y, axis.z)).unwrap();
        lights.map(|light| Fixture::from(light).with_shadow(64).unwrap()).into()
    };
    let mut team = Team::<f32>::new(2);
    let mut drawn = |what: &str, lights: &[Fixture], camera: &Camera| {
        team.must_agree(what, &scene, camera, lights, Display::default())
    };
    assert_eq!(drawn("all", &lights(0.0, true), &camera), 3);
    assert_eq!(drawn("none again", &lights(0.0, true), &camera), 0);
    assert_eq!(drawn("one moves", &lights(0.2, true), &camera), 1);
    // The maps of the others change hands.
    assert_eq!(drawn("one is switched off", &lights(0.2, false), &camera), 0);
    assert_eq!(drawn("one moves by another hand", &lights(0.4, false), &camera), 1);
    camera.orbit(0.2, 0.0);
    assert_eq!(drawn("one is switched on", &lights(0.6, true), &camera), 1);
}

#[test]
fn a_map_that_is_not_the_fixtures_is_rejected() {
    let (scene, lights) = (stage::scene().unwrap(), stage::lights().unwrap());
    let shadowed = lights.map(|light| Fixture::from(light).with_shadow(16).unwrap());
    let mut renderer = Renderer::<f32>::of_stripes(32, 32, Stripes::new(1, 2).unwrap()).unwrap();
    renderer.draw_own_shadows(&scene, &shadowed).unwrap();
    for (number, depths, expected) in [(0, 255, 256), (0, 0, 256), (3, 256, 0)] {
        let refused = renderer.take_shadow_map(&scene, &shadowed, number, &vec![0; depths]).unwrap_err();
        assert_eq!(refused, SizeError::Depths(depths, expected).into(), "{refused}");
    }
    assert!(renderer.take_shadow_map(&scene, &lights, 0, &[0; 256]).is_err(), "a light without shadows");
}
