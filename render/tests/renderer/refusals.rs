//! Scenes of random numbers: rejected with the parameter's name, or drawn finite, with
//! bit-identical results whether effects are skipped or not.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Fx16, Fx32, PointLight, Rgb, SpotLight, Vec3,
    attenuation::AnyAttenuation,
    dynamic::AnyLight,
    falloff::{AnyFalloff, InvertedRealPower, Soft},
    haze::Haze,
    projector::{Fixture, Gobo},
};
use luminaire_render::{Camera, Format, Material, Mesh, Outline, Renderer, Scene};

fn assert_refused<T: std::fmt::Debug>(result: Result<T, luminaire::Error>, message: &str) {
    assert_eq!(result.expect_err(message).to_string(), message);
}

#[test]
fn what_no_scene_can_have_is_refused_by_name() {
    let mut scene = Scene::new();
    let empty = scene.clone();
    let color = |value| Rgb::new(0.5, value, 0.5);
    for (value, shown) in [(f32::NAN, "NaN"), (-0.5, "-0.5"), (1.5, "1.5"), (f32::INFINITY, "inf")] {
        let message = format!("albedo = {shown}: expected a finite number from 0 to 1");
        assert_refused(Material::new(color(value)), &message);
    }
    for (value, shown) in [(f32::NAN, "NaN"), (-0.5, "-0.5"), (f32::INFINITY, "inf")] {
        let message = format!("ambient light = {shown}: expected a finite number from 0 to 1000000000");
        assert_refused(scene.set_ambient(color(value)), &message);
    }
    for (value, shown) in [(f32::NAN, "NaN"), (f32::INFINITY, "inf"), (2e6, "2000000")] {
        let message = format!("vertex = {shown}: expected a finite number from -1000000 to 1000000");
        let meshes = [
            Mesh::cuboid(1.0, 1.0, 1.0).moved(Vec3::new(0.0, value, 0.0)),
            Mesh::lathe(&Outline::start(0.0, value).line_to(1.0, 1.0), 3),
            Mesh::extrude(&Outline::start(0.0, 0.0).line_to(value, 1.0), 1.0, 3),
        ];
        for mesh in meshes {
            assert_refused(scene.add(mesh, Material::default()), &message);
        }
    }
    let turned = Mesh::cuboid(1.0, 1.0, 1.0).turned(Vec3::new(0.0, 1.0, 0.0), f32::NAN);
    assert!(scene.add(turned, Material::default()).is_err());
    assert_eq!(scene, empty, "what is refused is not there");
}

#[test]
fn what_no_renderer_can_have_is_refused_by_name() {
    let refused = |width, height| Renderer::<f32>::new(width, height).map(drop).unwrap_err().to_string();
    assert_eq!(refused(0, 10), "width = 0: expected 1 to 8192 pixels");
    assert_eq!(refused(8193, 10), "width = 8193: expected 1 to 8192 pixels");
    assert_eq!(refused(10, usize::MAX), format!("height = {}: expected 1 to 8192 pixels", usize::MAX));
    let mut renderer = Renderer::<Fx16>::new(16, 16).expect("a sound size");
    let far = PointLight::new(Vec3::new(0.0, 40_000.0, 0.0)).expect("a sound light");
    let message = "position = 40000: expected a finite number from -16383 to 16383 (y)";
    assert_refused(renderer.draw_light(&[far]), message);
}

#[test]
fn meshes_larger_than_memory_are_refused_by_name() {
    let mut scene = Scene::new();
    let line = Outline::start(1.0, 0.0).line_to(1.0, 1.0);
    let numbers = [
        (524_288, "524288"),
        (u32::MAX as usize / 2 + 1, "2147483648"),
        (usize::MAX / 4, "4.611686e18"),
        (usize::MAX, "1.8446744e19"),
    ];
    for (segments, shown) in numbers {
        let message = format!("number of segments = {shown}: expected a whole number from 0 to 524287");
        assert_refused(scene.add(Mesh::lathe(&line, segments), Material::default()), &message);
        assert_refused(scene.add(Mesh::extrude(&line, 1.0, segments), Material::default()), &message);
    }
    let most = Mesh::extrude(&line, 1.0, 524_287);
    assert_eq!(most.triangle_count(), 2 * 524_287);
    for (lines, shown) in [(65_537, "65537"), (usize::MAX, "1.8446744e19")] {
        let message = format!("number of segments = {shown}: expected a whole number from 0 to 65536");
        for curve in
            [line.clone().arc(0.0, 0.0, 1.0, lines), line.clone().curve_to([(0.0, 0.0); 2], 1.0, 2.0, lines)]
        {
            assert_refused(scene.add(Mesh::lathe(&curve, 3), Material::default()), &message);
        }
    }
    let message = "number of vertices = 1048580: expected a whole number from 0 to 1048576";
    let both = most.and(Mesh::extrude(&line, 1.0, 1));
    assert_refused(scene.add(both.and(Mesh::default()), Material::default()), message);
}

/// Returns how many lights are refused and drawn, by what skips work and by what skips none alike:
/// narrow and wide, bright and dark, with and without a gobo, in haze and in clear air.
fn assert_refused_alike<S: Format>() -> [usize; 2] {
    const STRIPES: Gobo<'static> = Gobo::of(&[255, 0, 255, 0]);
    let steep = InvertedRealPower::new(1_000.0).expect("a falloff");
    let (mut counts, mut renderer) = ([0; 2], Renderer::<S>::new(8, 8).expect("a sound size"));
    for haze in [None, Haze::new(0.02).ok()] {
        let mut scene = Scene::new();
        scene.set_haze(haze);
        renderer.draw_geometry(&scene, &Camera::new(Vec3::default(), 5.0, 0.0, 0.0, 40.0));
        for step in 0..80 {
            let angle = Angle::degrees(150.0 * 0.5_f32.powi(step / 4));
            let (intensity, has_gobo) = ([9.0, 0.0][step as usize % 2], step % 4 > 1);
            for falloff in [AnyFalloff::Soft(Soft), AnyFalloff::InvertedRealPower(steep)] {
                let cone = Cone::from_outer(falloff, angle).expect("a cone");
                let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone).expect("a light");
                let fixture = Fixture::from(spot.with_intensity(intensity).expect("a light"));
                let patterned = fixture.with_gobo(STRIPES, Angle::degrees(0.0)).expect("a gobo");
                let fixture = if has_gobo { patterned } else { fixture };
                let skipping = renderer.draw_light(&[fixture]).map(drop);
                assert_eq!(skipping, renderer.draw_everything(&[fixture]), "{haze:?}: {fixture:?}");
                counts[usize::from(skipping.is_ok())] += 1;
            }
        }
    }
    counts
}

#[test]
fn a_light_is_refused_whether_work_is_skipped_or_not() {
    let counts =
        [assert_refused_alike::<f32>(), assert_refused_alike::<Fx32>(), assert_refused_alike::<Fx16>()];
    assert!(counts.as_flattened().iter().all(|count| *count > 20), "refused and drawn: {counts:?}");
}

/// Returns a random number: of ordinary size in 13 of 16 cases, else one that may cause trouble.
fn number(rng: &mut Rng) -> f32 {
    let odd = [f32::NAN, f32::INFINITY, -f32::INFINITY, f32::MAX, 1e30, 1e6, -1e5, 1e-30, -0.0, 0.0];
    match rng.u8(..16) {
        0 => odd[rng.usize(..odd.len())],
        1 => f32::from_bits(rng.u32(..)),
        2 => rng.f32() * 1e5,
        _ => 4.0 * rng.f32() - 2.0,
    }
}

fn vector(rng: &mut Rng) -> Vec3<f32> {
    Vec3::new(number(rng), number(rng), number(rng))
}

fn color(rng: &mut Rng) -> Rgb<f32> {
    let channel = |rng: &mut Rng| if rng.u8(..8) == 0 { number(rng) } else { rng.f32() };
    Rgb::new(channel(rng), channel(rng), channel(rng))
}

fn mesh(rng: &mut Rng) -> Mesh {
    let count = |rng: &mut Rng| if rng.u8(..20) == 0 { rng.usize(..) } else { rng.usize(..12) };
    let mut outline = Outline::start(number(rng), number(rng)).line_to(number(rng), number(rng));
    if rng.bool() {
        outline = outline.arc(number(rng), number(rng), number(rng), count(rng));
    }
    if rng.bool() {
        let controls = [(number(rng), number(rng)), (number(rng), number(rng))];
        outline = outline.curve_to(controls, number(rng), number(rng), count(rng));
    }
    let mesh = match rng.u8(..3) {
        0 => Mesh::lathe(&outline, count(rng)),
        1 => Mesh::extrude(&outline, number(rng), count(rng)),
        _ => Mesh::cuboid(number(rng), number(rng), number(rng)),
    };
    mesh.turned(vector(rng), number(rng)).moved(vector(rng))
}

fn fixture(rng: &mut Rng) -> Result<Fixture, luminaire::Error> {
    let place = vector(rng);
    if rng.bool() {
        return Ok(PointLight::new(place)?.with_intensity(number(rng))?.with_color(color(rng))?.into());
    }
    let falloff = AnyFalloff::anywhere(rng.usize(..), || rng.f32())?;
    let cone = Cone::from_outer(falloff, Angle::degrees(180.0 * rng.f32()))?;
    let spot = SpotLight::new(place, vector(rng), cone)?.with_intensity(30.0 * number(rng))?;
    let attenuation = AnyAttenuation::anywhere(rng.usize(..), || rng.f32())?;
    let fixture = Fixture::from(AnyLight::from(spot.with_color(color(rng))?.with_attenuation(attenuation)));
    if rng.bool() { fixture.with_shadow(16) } else { Ok(fixture) }
}

/// Draws a scene and compares the picture with the one that skips nothing. Returns whether the
/// format holds its lights.
fn assert_drawn<S: Format>(scene: &Scene, camera: &Camera, fixtures: &[Fixture]) -> bool {
    let mut renderer = Renderer::<S>::new(24, 16).expect("a sound size");
    renderer.draw_geometry(scene, camera);
    let drawn = renderer.draw_shadows(scene, fixtures).is_ok() && renderer.draw_light(fixtures).is_ok();
    if !drawn {
        return false;
    }
    let picture = renderer.encode().to_vec();
    let linear = |renderer: &Renderer<S>| -> Vec<_> {
        let places = (0..16).flat_map(|y| (0..24).map(move |x| (x, y)));
        places.filter_map(|(x, y)| renderer.linear(x, y)).collect()
    };
    let light = linear(&renderer);
    for Rgb { red, green, blue } in &light {
        assert!([red, green, blue].into_iter().all(|c| c.is_finite() && *c >= 0.0), "{light:?}");
    }
    renderer.draw_everything(fixtures).expect("what was held is held again");
    assert_eq!((linear(&renderer), renderer.encode()), (light, &picture[..]));
    // Nothing has changed: no material compares unequal to itself.
    assert!(!renderer.draw_geometry(scene, camera));
    true
}

#[test]
fn hostile_scenes_are_refused_or_drawn() {
    let mut rng = Rng::with_seed(0x5ce_0e5);
    let scenes = if std::env::var_os("LUMINAIRE_FULL").is_some() { 20_000 } else { 300 };
    let (mut refused, mut accepted, mut drawn) = (0, 0, 0);
    for _ in 0..scenes {
        let rng = &mut rng;
        let mut scene = Scene::new();
        let mut count = |result: Result<(), luminaire::Error>| match result {
            Ok(()) => accepted += 1,
            Err(error) => {
                refused += 1;
                assert!(error.to_string().contains(": expected "), "{error}");
            }
        };
        count(scene.set_ambient(color(rng)));
        for _ in 0..4 {
            let added = Material::new(color(rng)).and_then(|paint| match rng.bool() {
                true => paint.with_highlight(Rgb::new(1.0, 1.0, 1.0), 40),
                false => Ok(paint),
            });
            count(added.and_then(|material| scene.add(mesh(rng), material)));
        }
        if rng.u8(..4) == 0 {
            scene.set_haze(Haze::new(number(rng)).ok());
        }
        let fixtures: Vec<_> = (0..3).filter_map(|_| fixture(rng).ok()).collect();
        let [distance, yaw, pitch, field] = std::array::from_fn(|_| number(rng));
        let camera = Camera::new(vector(rng), distance, yaw, pitch, field);
        drawn += usize::from(match rng.u8(..3) {
            0 => assert_drawn::<f32>(&scene, &camera, &fixtures),
            1 => assert_drawn::<Fx32>(&scene, &camera, &fixtures),
            _ => assert_drawn::<Fx16>(&scene, &camera, &fixtures),
        });
    }
    assert!(refused > scenes && accepted > scenes, "{refused} refused, {accepted} accepted");
    assert!(drawn > scenes / 2, "{drawn} drawn");
}
