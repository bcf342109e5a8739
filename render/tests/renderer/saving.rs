//! Skipping changes no bit of a picture, and saves as much as stated.

use luminaire::{
    Fx16, Fx32, MeasuredLight, Rgb, Vec3,
    dynamic::AnyLight,
    light::{Distribution, SurfacePoint, Symmetry},
    projector::Fixture,
    specular::SpecularLobe as _,
};
use luminaire_render::{
    Account, Format, Highlight, Material, Mesh, Renderer, Scene,
    scenes::{Example, Setup, turntable},
};
use std::ops::Range;

/// No whole number of tiles in width or height.
const SIZE: (usize, usize) = (122, 69);

fn renderer<S: Format>(setup: &Setup) -> Renderer<S> {
    let mut renderer = Renderer::new(SIZE.0, SIZE.1).unwrap();
    assert!(renderer.draw_geometry(&setup.scene, &setup.camera));
    renderer
}

/// Iterates over the coordinates of all pixels.
fn pixels<S: Format>(renderer: &Renderer<S>) -> impl Iterator<Item = (usize, usize)> + use<S> {
    let (width, height) = renderer.size();
    (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)))
}

/// Returns the light of all pixels and their codes, as bits.
fn bits<S: Format>(renderer: &mut Renderer<S>) -> (Vec<[u32; 3]>, Vec<u8>) {
    let light = pixels(renderer).map(|(x, y)| {
        let Rgb { red, green, blue } = renderer.linear(x, y).unwrap();
        [red, green, blue].map(f32::to_bits)
    });
    (light.collect(), renderer.encode().to_vec())
}

/// Draws the pictures in turn with one renderer, and each with a fresh one. Compares both with the
/// picture that skips nothing.
fn assert_same<S: Format>(setup: &Setup, pictures: &[Vec<Fixture>], what: &str) {
    let (mut going_on, mut everything) = (renderer::<S>(setup), renderer::<S>(setup));
    for (number, fixtures) in pictures.iter().enumerate() {
        let mut fresh = renderer::<S>(setup);
        for renderer in [&mut going_on, &mut fresh, &mut everything] {
            renderer.draw_shadows(&setup.scene, fixtures).unwrap();
        }
        going_on.draw_light(fixtures).unwrap();
        fresh.draw_light(fixtures).unwrap();
        everything.draw_everything(fixtures).unwrap();
        let expected = bits(&mut everything);
        assert!(bits(&mut fresh) == expected, "{what} in {}: picture {number}", S::NAME);
        assert!(bits(&mut going_on) == expected, "{what} in {}: picture {number} after others", S::NAME);
        for account in [fresh.account(), going_on.account(), everything.account()] {
            assert_eq!(account.pairs(), (fixtures.len() * SIZE.0 * SIZE.1) as u64, "{what}: {account:?}");
        }
        let account = everything.account();
        assert_eq!(account.evaluated, account.pairs(), "{what}: {account:?}");
    }
}

fn assert_same_everywhere(example: Example, pictures: impl Fn(&Setup) -> Vec<Vec<Fixture>>) {
    let setup = example.setup().unwrap();
    let pictures = pictures(&setup);
    assert_same::<f32>(&setup, &pictures, example.name());
    assert_same::<Fx32>(&setup, &pictures, example.name());
    assert_same::<Fx16>(&setup, &pictures, example.name());
}

/// A light that is switched off.
fn off(fixture: &Fixture) -> Fixture {
    match fixture.light() {
        AnyLight::Directional(light) => light.with_intensity(0.0).unwrap().into(),
        AnyLight::Point(light) => light.with_intensity(0.0).unwrap().into(),
        AnyLight::Spot(light) => light.with_intensity(0.0).unwrap().into(),
        AnyLight::Measured(light) => light.with_intensity(0.0).unwrap().into(),
    }
}

#[test]
fn planned_pictures_are_those_of_everything() {
    for &example in Example::ALL {
        assert_same_everywhere(example, |setup| {
            [0.0, 1.7, 1.75, 6.3].map(|seconds| setup.fixtures_at(seconds).unwrap()).to_vec()
        });
    }
}

#[test]
fn dark_lights_and_lights_that_go_off_and_on_leave_no_trace() {
    for example in [Example::ThreePoint, Example::Show, Example::Gallery] {
        assert_same_everywhere(example, |setup| {
            let all = setup.fixtures_at(0.0).unwrap();
            let without = |part: usize| {
                let number = |(number, fixture): (usize, &Fixture)| {
                    if number % 3 == part { off(fixture) } else { *fixture }
                };
                all.iter().enumerate().map(number).collect::<Vec<_>>()
            };
            let fewer = all[..all.len() - 1].to_vec();
            let reversed = all.iter().rev().copied().collect();
            let none = all.iter().map(off).collect();
            vec![all.clone(), without(0), without(1), all.clone(), Vec::new(), all, fewer, reversed, none]
        });
    }
}

/// Lights that are not round, in the places of spotlights: up to 50 degrees off the axis, and in all directions.
#[test]
fn measured_lights_are_skipped_where_they_send_nothing() {
    const NARROW: [u16; 25] =
        [65_535, 40_000, 0, 0, 0, 50_000, 30_000, 0, 0, 0, 20_000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    const WHOLE: [u16; 15] = [9_000, 65_535, 40_000, 30_000, 7, 9, 1, 40_000, 0, 7, 65_535, 3, 1, 3, 65_535];
    let narrow = Distribution::from_parts(&NARROW, 9, Symmetry::Quadrant);
    let whole = Distribution::from_parts(&WHOLE, 5, Symmetry::Bilateral);
    for example in [Example::ThreePoint, Example::Gallery] {
        assert_same_everywhere(example, |setup| {
            let all = setup.fixtures_at(0.0).unwrap();
            let with = |distribution| {
                let measured = |fixture: &Fixture| {
                    let AnyLight::Spot(spot) = fixture.light() else { return *fixture };
                    let side = Vec3::new(spot.axis().y, spot.axis().z, -spot.axis().x);
                    let light = MeasuredLight::new(spot.position(), spot.axis(), side, distribution).unwrap();
                    let light = light.with_attenuation(spot.attenuation());
                    light.with_intensity(spot.intensity()).unwrap().with_color(spot.color()).unwrap().into()
                };
                all.iter().map(measured).collect::<Vec<_>>()
            };
            vec![with(narrow), with(whole), all.clone(), with(narrow)]
        });
    }
}

#[test]
fn dark_lights_are_dropped() {
    let setup = Example::ThreePoint.setup().unwrap();
    let mut fixtures = setup.fixtures_at(0.0).unwrap();
    fixtures[1] = off(&fixtures[1]);
    let mut renderer = renderer::<f32>(&setup);
    renderer.draw_light(&fixtures).unwrap();
    let account = renderer.account();
    assert_eq!((account.lights, account.lights_dropped), (3, 1));
    assert_eq!(account.dropped, (SIZE.0 * SIZE.1) as u64);
}

/// Returns a renderer of the size that the grids are composed for, with its light drawn.
fn lit(example: Example) -> (Setup, Renderer<f32>) {
    let setup = example.setup().unwrap();
    let (width, height) = example.size();
    let mut renderer = Renderer::new(width, height).unwrap();
    assert!(renderer.draw_geometry(&setup.scene, &setup.camera));
    assert!(renderer.draw_light(&setup.fixtures_at(0.0).unwrap()).unwrap());
    (setup, renderer)
}

/// Returns the number of (spotlight, pixel) pairs in which light arrives: a lower bound of the
/// evaluated pairs.
fn lit_pairs(setup: &Setup, renderer: &Renderer<f32>) -> u64 {
    let fixtures = setup.fixtures_at(0.0).unwrap();
    let spots = fixtures.iter().map(|fixture| match fixture.light() {
        AnyLight::Spot(spot) => spot.compile::<f32>().unwrap(),
        other => panic!("{other:?}"),
    });
    let spots: Vec<_> = spots.collect();
    let points = pixels(renderer).filter_map(|(x, y)| renderer.surface(x, y));
    let lights = |(point, normal, _)| spots.iter().filter(move |spot| spot.irradiance(point, normal) > 0.0);
    points.map(|surface| lights(surface).count() as u64).sum()
}

/// Checks the ratio of all pairs to the evaluated ones, and of the evaluated ones to those in which
/// light arrives.
fn assert_saving(example: Example, saving: Range<f64>, surplus: Range<f64>) {
    let (setup, renderer) = lit(example);
    let (account, least) = (renderer.account(), lit_pairs(&setup, &renderer));
    let evaluated = account.evaluated as f64;
    let found = (account.pairs() as f64 / evaluated, evaluated / least as f64);
    assert!(
        saving.contains(&found.0) && surplus.contains(&found.1),
        "{}: {found:?}, expected {saving:?} and {surplus:?}",
        example.name()
    );
}

#[test]
fn a_spot_is_evaluated_little_beyond_its_circle() {
    // A circle is about as wide as a row of 32 pixels there.
    assert_saving(Example::Grid, 95.1..95.3, 1.96..1.97);
}

/// Returns the number of (light, pixel) pairs in which a highlight arrives: a lower bound of the
/// evaluated pairs.
fn shining_pairs(setup: &Setup, renderer: &Renderer<f32>) -> u64 {
    let fixtures = setup.fixtures_at(0.0).unwrap();
    let lights: Vec<_> = fixtures.iter().map(|lit| lit.light().compile::<f32>().unwrap()).collect();
    let points = pixels(renderer).filter_map(|(x, y)| renderer.surface(x, y));
    let shines = |(point, normal, material): (Vec3<f32>, Vec3<f32>, Material)| {
        let surface = SurfacePoint::<f32>::seen_from(setup.camera.eye(), point, normal);
        let twice = 2.0 * surface.view.dot(normal);
        let mirrored = surface.view.zip(normal, |view, n| view - twice * n);
        let surface = SurfacePoint { view: mirrored, ..surface };
        let highlight = Highlight::constants::<f32>(material.shininess());
        lights
            .iter()
            .filter(|light| light.evaluate::<Highlight>(&surface, &highlight, true).specular > 0.0)
            .count()
    };
    points.map(|surface| shines(surface) as u64).sum()
}

#[test]
fn a_highlight_is_evaluated_little_beyond_its_lobe() {
    let (setup, renderer) = lit(Example::Turntable);
    let (account, least) = (renderer.account(), shining_pairs(&setup, &renderer));
    let share = account.evaluated_shining as f64 / account.evaluated as f64;
    let surplus = account.evaluated_shining as f64 / least as f64;
    assert!(
        (0.31..0.32).contains(&share) && (1.95..1.97).contains(&surplus),
        "{share}, {surplus}, expected share in 0.31..0.32 and surplus in 1.95..1.97"
    );
}

/// What gobos and shadow maps attenuate is what their lights evaluate alone.
#[test]
fn account_of_gobos_and_shadows_is_that_of_their_lights() {
    let gobos = |account: Account| account.evaluated_through_gobos;
    let shadows = |account: Account| account.evaluated_in_shadows;
    check(Example::Show, |fixture| fixture.gobo().is_some(), gobos);
    check(Example::ThreePoint, |fixture| fixture.shadow().is_some(), shadows);

    fn check(example: Example, has: fn(&Fixture) -> bool, count: fn(Account) -> u64) {
        let setup = example.setup().unwrap();
        let account = |fixtures: &[Fixture]| {
            let mut renderer = Renderer::<f32>::new(SIZE.0, SIZE.1).unwrap();
            renderer.draw_geometry(&setup.scene, &setup.camera);
            renderer.draw_light(fixtures).unwrap();
            renderer.account()
        };
        let fixtures = setup.fixtures_at(0.0).unwrap();
        let own: Vec<_> = fixtures.iter().copied().filter(has).collect();
        let (all, own) = (account(&fixtures), account(&own));
        assert!(0 < own.evaluated && own.evaluated < all.evaluated, "{}: {own:?}", example.name());
        assert_eq!([count(all), count(own)], [own.evaluated; 2], "{}", example.name());
    }
}

/// Draws a picture after another, and compares the re-lit pixels with the changed ones. Both ranges
/// are shares of the picture.
fn assert_relit(example: Example, seconds: f32, relit: Range<f64>, changed: Range<f64>) {
    let (setup, mut renderer) = lit(example);
    let light = |renderer: &Renderer<f32>| -> Vec<_> {
        pixels(renderer).map(|(x, y)| renderer.linear(x, y).unwrap()).collect()
    };
    let before = light(&renderer);
    assert!(renderer.draw_light(&setup.fixtures_at(seconds).unwrap()).unwrap());
    let is_changed = before.iter().zip(&light(&renderer)).map(|(a, b)| a != b).collect::<Vec<_>>();
    let is_relit: Vec<_> = pixels(&renderer).map(|(x, y)| renderer.is_relit(x, y).unwrap()).collect();
    assert!(is_changed.iter().zip(&is_relit).all(|(changed, relit)| relit | !changed), "{}", example.name());
    let (account, all) = (renderer.account(), is_relit.len());
    let count = |is: &[bool]| is.iter().filter(|is| **is).count();
    assert_eq!(account.kept, u64::from(account.lights) * (all - count(&is_relit)) as u64, "{account:?}");
    let found = (count(&is_relit) as f64 / all as f64, count(&is_changed) as f64 / all as f64);
    assert!(
        relit.contains(&found.0) && changed.contains(&found.1),
        "{}: {found:?}, expected {relit:?} and {changed:?}",
        example.name()
    );
}

#[test]
fn only_the_tiles_of_lights_that_have_changed_are_relit() {
    // The chase has moved from one of 64 lights to the next; of the 26 lights the follow spot has moved.
    assert_relit(Example::Grid, 0.25, 0.0275..0.0278, 0.0087..0.0089);
    assert_relit(Example::Gallery, 0.25, 0.0495..0.0505, 0.0119..0.0122);
}

#[test]
fn where_nothing_has_changed_nothing_is_done() {
    for &example in Example::ALL {
        let setup = example.setup().unwrap();
        let mut renderer = renderer::<f32>(&setup);
        assert_eq!(renderer.account().triangles, setup.scene.triangle_count());
        renderer.draw_light(&setup.fixtures_at(0.1).unwrap()).unwrap();
        assert!(!renderer.draw_geometry(&setup.scene, &setup.camera));
        assert_eq!(renderer.account().triangles, 0);
        assert!(
            !renderer.draw_light(&setup.fixtures_at(0.1).unwrap()).unwrap(),
            "{}: lights that have not changed are drawn again, expected no work",
            example.name()
        );
    }
}

#[test]
fn a_changed_scene_is_drawn_and_paint_and_ambient_light_draw_no_triangle() {
    let painted = |albedo| {
        let mut scene = Scene::new();
        scene.add(Mesh::cuboid(2.0, 1.0, 1.0), Material::new(albedo).unwrap()).unwrap();
        scene
    };
    let (red, blue) = (painted(Rgb::new(0.8, 0.1, 0.1)), painted(Rgb::new(0.1, 0.1, 0.8)));
    let mut dim = blue.clone();
    dim.set_ambient(Rgb::new(0.1, 0.1, 0.1)).unwrap();
    let mut more = dim.clone();
    more.add(Mesh::cuboid(1.0, 2.0, 1.0), Material::default()).unwrap();
    let setup = turntable(4).unwrap();
    let fixtures = setup.fixtures_at(0.0).unwrap();
    let mut renderer = Renderer::<f32>::new(SIZE.0, SIZE.1).unwrap();
    for (scene, triangles) in [(&red, 12), (&blue, 0), (&dim, 0), (&more, 24)] {
        assert!(renderer.draw_geometry(scene, &setup.camera));
        assert!(renderer.draw_light(&fixtures).unwrap());
        let account = renderer.account();
        assert_eq!((account.triangles, account.tiles_relit), (triangles, account.tiles));
        let mut fresh = Renderer::<f32>::new(SIZE.0, SIZE.1).unwrap();
        fresh.draw_geometry(scene, &setup.camera);
        fresh.draw_everything(&fixtures).unwrap();
        assert!(bits(&mut renderer) == bits(&mut fresh), "{triangles} triangles");
    }
}
