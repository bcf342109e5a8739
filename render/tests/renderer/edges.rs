//! Anti-aliasing, compared with 256 samples per pixel, and its independence from everything that
//! must not change a picture.

use luminaire::{Rgb, SpotLight, Vec3, display::decode_srgb, projector::Fixture};
use luminaire_render::{
    Camera, Display, Edges, Material, Mesh, Outline, Output, Renderer, Scene, scenes::Example,
};
use std::f32::consts::{PI, TAU};

const SIZE: (usize, usize) = (160, 90);
/// Samples along each side of a pixel of the reference.
const FINE: usize = 16;

/// The meshes are white under white ambient light, so that a pixel's linear light is its coverage.
fn white(meshes: impl IntoIterator<Item = Mesh>) -> Scene {
    let mut scene = Scene::new();
    scene.set_ambient(Rgb::new(1.0, 1.0, 1.0)).unwrap();
    meshes.into_iter().for_each(|mesh| scene.add(mesh, Material::srgb(255, 255, 255)).unwrap());
    scene
}

fn camera() -> Camera {
    Camera::new(Vec3::new(0.0, 1.0, 0.0), 6.0, 0.3, 0.3, 0.6)
}

/// Returns the coverage of each pixel.
fn coverage(scene: &Scene, (width, height): (usize, usize), antialiased: bool) -> Vec<f32> {
    let mut renderer = Renderer::<f32>::new(width, height).unwrap();
    renderer.set_antialiased(antialiased);
    renderer.draw_geometry(scene, &camera());
    renderer.draw_light::<SpotLight>(&[]).unwrap();
    renderer.encode().chunks_exact(4).map(|pixel| decode_srgb(pixel[1])).collect()
}

/// Returns the mean of all samples of each pixel.
fn reference(scene: &Scene) -> Vec<f32> {
    let wide = SIZE.0 * FINE;
    let samples = coverage(scene, (wide, SIZE.1 * FINE), false);
    let mut means = vec![0.0; SIZE.0 * SIZE.1];
    for (place, sample) in samples.into_iter().enumerate() {
        means[place / wide / FINE * SIZE.0 + place % wide / FINE] += sample / (FINE * FINE) as f32;
    }
    means
}

/// Error of the coverage in the pixels that are partly covered.
#[derive(Debug)]
struct Seen {
    /// The share of the pixels whose coverage is neither 0 nor 1, of those that are between 1/16
    /// and 15/16 covered.
    intermediate: f32,
    mean: f32,
    largest: f32,
    /// The largest error in all other pixels.
    elsewhere: f32,
}

fn seen(exact: &[f32], drawn: &[f32]) -> Seen {
    let is_partly = |exact: f32| exact > 0.001 && exact < 0.999;
    let of = |partly: bool| {
        let pairs = exact.iter().zip(drawn).filter(move |(exact, _)| is_partly(**exact) == partly);
        pairs.map(|(exact, drawn)| (exact - drawn).abs())
    };
    let clear: Vec<_> =
        exact.iter().zip(drawn).filter(|(exact, _)| (0.0625..0.9375).contains(*exact)).collect();
    let intermediate = clear.iter().filter(|(_, drawn)| is_partly(**drawn)).count();
    Seen {
        intermediate: intermediate as f32 / clear.len() as f32,
        mean: of(true).sum::<f32>() / of(true).count() as f32,
        largest: of(true).fold(0.0, f32::max),
        elsewhere: of(false).fold(0.0, f32::max),
    }
}

fn solids() -> [(&'static str, Mesh); 6] {
    let sphere = |lines| Mesh::lathe(&Outline::start(0.0, -1.0).arc(0.0, 0.0, PI, lines), 2 * lines);
    // 1.5 to 2 pixels wide; their distances are no whole numbers of pixels.
    let post = |number| Mesh::cuboid(0.1, 2.0, 0.1).moved(Vec3::new(-1.5 + 0.31 * number as f32, -0.6, 0.0));
    [
        ("a sphere", sphere(48)),
        ("a coarse sphere", sphere(8)),
        ("a box", Mesh::cuboid(1.0, 1.0, 1.0)),
        ("a torus", Mesh::lathe(&Outline::start(0.8, 0.0).arc(0.8, 0.3, TAU, 28), 56)),
        ("a sheet", Mesh::extrude(&Outline::start(0.8, 0.3).line_to(-0.9, 0.0), 1.3, 1)),
        ("posts", (0..10).map(post).reduce(Mesh::and).unwrap()),
    ]
}

#[test]
fn coverage_at_silhouettes_is_that_of_256_samples() {
    for (name, mesh) in solids() {
        let scene = white([mesh.moved(Vec3::new(0.013, 0.57, 0.0))]);
        let exact = reference(&scene);
        let (plain, smooth) =
            (seen(&exact, &coverage(&scene, SIZE, false)), seen(&exact, &coverage(&scene, SIZE, true)));
        println!("{name}: {plain:?}, anti-aliased {smooth:?}");
        assert!(
            plain.intermediate == 0.0 && plain.mean > 0.15,
            "{name}: {plain:?}, expected plain.intermediate == 0.0 and plain.mean > 0.15"
        );
        assert!(
            smooth.intermediate > 0.98 && smooth.mean < 0.01,
            "{name}: {smooth:?}, expected smooth.intermediate > 0.98 and smooth.mean < 0.01"
        );
        // A share is that of one straight edge. At corners, those of the posts above all, it is not
        // the area.
        let (largest, elsewhere) = if name == "posts" { (0.35, 0.45) } else { (0.12, 0.02) };
        assert!(
            smooth.largest < largest && smooth.elsewhere < elsewhere,
            "{name}: {smooth:?}, expected smooth.largest < largest and smooth.elsewhere < elsewhere"
        );
    }
}

#[test]
fn hidden_edges_change_no_pixel() {
    let wall = Mesh::cuboid(20.0, 20.0, 0.1).moved(Vec3::new(0.0, -5.0, 2.0));
    let solids = solids().map(|(_, mesh)| mesh);
    let mut renderer = Renderer::<f32>::new(SIZE.0, SIZE.1).unwrap();
    renderer.set_antialiased(true);
    renderer.draw_geometry(&white(solids.clone()), &camera());
    assert!(renderer.edge_marks().len() > 500);
    renderer.draw_geometry(&white(solids.into_iter().chain([wall])), &camera());
    assert_eq!(renderer.edge_marks().len(), 0);
}

/// A front face before a back face of the same mesh, a ball before a wall, a box on a floor, and a
/// crease.
#[test]
fn edges_inside_the_picture_are_mixed() {
    let colors = [Material::srgb(255, 90, 20), Material::srgb(40, 40, 200), Material::srgb(90, 160, 90)];
    let floor = Mesh::cuboid(8.0, 0.1, 6.0).moved(Vec3::new(0.0, -0.1, 0.0));
    let [(_, sphere), _, (_, cuboid), ..] = solids();
    let mut scene = Scene::new();
    scene.set_ambient(Rgb::new(0.2, 0.2, 0.2)).unwrap();
    for (mesh, color) in [sphere.moved(Vec3::new(-0.4, 1.0, 0.0)), cuboid, floor].into_iter().zip(colors) {
        scene.add(mesh, color).unwrap();
    }
    let light = Example::BareSpot.setup().unwrap().fixtures_at(0.0).unwrap();
    let draw = |antialiased| {
        let mut renderer = Renderer::<f32>::new(SIZE.0, SIZE.1).unwrap();
        renderer.set_antialiased(antialiased);
        renderer.draw_geometry(&scene, &camera());
        renderer.draw_light(&light).unwrap();
        renderer.encode().to_vec()
    };
    let (plain, smooth) = (draw(false), draw(true));
    let at = |pixels: &[u8], x: usize, y: usize| pixels[4 * (y * SIZE.0 + x) + 1];
    let is_mixed = |x, y| at(&plain, x, y) != at(&smooth, x, y);
    let (mut steps, mut mixed) = (0, 0);
    for (x, y) in (1..SIZE.1 - 1).flat_map(|y| (1..SIZE.0 - 1).map(move |x| (x, y))) {
        let around = [(x, y), (x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)].map(|(x, y)| at(&plain, x, y));
        let (least, most) = (*around.iter().min().unwrap(), *around.iter().max().unwrap());
        assert!(
            (least..=most).contains(&at(&smooth, x, y)),
            "{x} {y}, expected at(&smooth, x, y) in least..=most"
        );
        // Of the two pixels at a step, one has more than half of its area on its own side.
        for (right, below) in [(x + 1, y), (x, y + 1)] {
            if at(&plain, x, y).abs_diff(at(&plain, right, below)) > 24 {
                steps += 1;
                mixed += usize::from(is_mixed(x, y) || is_mixed(right, below));
            }
        }
    }
    assert!(steps > 300 && mixed * 20 > steps * 19, "{mixed} of {steps} steps are mixed");
}

/// Every way to a state of the scene gives the same picture as a new renderer.
#[test]
fn a_picture_does_not_depend_on_the_pictures_before_it() {
    let setup = Example::Turntable.setup().unwrap();
    let mut renderer = Renderer::<f32>::new(SIZE.0, SIZE.1).unwrap();
    let mut camera = setup.camera;
    for step in 0..12 {
        // In most steps only lights move; in some, only the camera, only the display, or nothing.
        let lights = setup.fixtures_at((step / 2) as f32 * 0.4).unwrap();
        let lights: Vec<Fixture> = lights.into_iter().take(2).collect();
        let display = if step % 5 == 4 { Output::Rgb888.dithered() } else { Display::default() };
        let antialiased = step != 7;
        camera.orbit(if step % 3 == 2 { 0.05 } else { 0.0 }, 0.0);
        let draw = |renderer: &mut Renderer<f32>| {
            renderer.set_antialiased(antialiased);
            renderer.set_display(display);
            renderer.draw_geometry(&setup.scene, &camera);
        };
        draw(&mut renderer);
        renderer.draw_light(&lights).unwrap();
        let mut new = Renderer::<f32>::new(SIZE.0, SIZE.1).unwrap();
        draw(&mut new);
        new.draw_everything(&lights).unwrap();
        assert!(renderer.encode() == new.encode(), "step {step}");
        assert_eq!(new.edge_marks().len() > 0, antialiased);
    }
}

#[test]
fn marks_from_elsewhere_do_no_harm() {
    let mut edges = Edges::new();
    edges.take([0, u64::MAX, 1 << 32 | 128, 5 << 32 | 2 << 16 | 128, 5 << 32 | 3 << 16 | 400]);
    for (width, length) in [(0, 0), (1, 3), (3, 24), (usize::MAX, 24), (2, 40)] {
        let mut picture: Vec<u8> = (0..length).map(|byte| (6 * byte) as u8).collect();
        let before = picture.clone();
        edges.mix(Display::default(), width, &mut picture);
        edges.restore(&mut picture);
        assert_eq!(picture, before, "{width} {length}");
    }
}
