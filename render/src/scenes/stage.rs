//! A stage: boards, a cyclorama, curtains, and a still life of solids of revolution in the light of
//! three spotlights.

use crate::{
    Camera, Material, Mesh, Outline, Scene,
    scenes::solids::{QUARTER, capsule, column, cone, sphere, torus, vase},
};
use core::f32::consts::{FRAC_PI_2, TAU};
use luminaire::{Angle, Cone, Error, Rgb, SpotLight, Vec3, falloff::SoftOrHard};

/// Width and depth of the boards in metres; the back of the stage is at negative z.
const DECK: (f32, f32) = (7.2, 5.4);
const BOARDS: usize = 24;

/// The colours of the boards, in sRGB.
const WOOD: [(u8, u8, u8); 5] =
    [(150, 114, 84), (138, 103, 75), (160, 123, 91), (129, 97, 72), (145, 108, 78)];

/// Builds the scene. Lengths are in metres, y points up, and the audience is at positive z. All
/// objects stand on the floor y = 0.
pub fn scene() -> Result<Scene, Error> {
    let mut scene = Scene::new();
    scene.set_ambient(Rgb::new(0.014, 0.016, 0.022))?;
    // Objects are added from front to back, so that the depth test rejects the hidden triangles.
    for (mesh, material) in actors() {
        scene.add(mesh, material)?;
    }
    for board in 0..BOARDS {
        let (red, green, blue) = WOOD[(board * 7 + board / 5) % WOOD.len()];
        scene.add(plank(board), Material::srgb(red, green, blue))?;
    }
    for (mesh, material) in house() {
        scene.add(mesh, material)?;
    }
    Ok(scene)
}

/// Returns the camera: in the stalls, a little above the boards.
pub fn camera() -> Camera {
    Camera::new(Vec3::new(0.0, 0.86, 0.0), 7.4, -0.14, 0.2, 0.5)
}

/// Returns the key light, the fill light and the back light, in this order.
///
/// The key light is a profile spot of 26 degrees with a hard edge, warm, from the front left. The
/// fill light is a Fresnel with a soft edge, cooler and weaker, from the front right. The back
/// light is a PAR with a soft edge, from behind and above.
///
/// # Errors
/// Never: the values are constants.
pub fn lights() -> Result<[SpotLight<SoftOrHard>; 3], Error> {
    let key = Cone::from_field(SoftOrHard::Hard, Angle::degrees(26.0))?;
    let fill = Cone::from_field(SoftOrHard::Soft, Angle::degrees(50.0))?;
    let back = Cone::from_field(SoftOrHard::Soft, Angle::degrees(44.0))?;
    Ok([
        aimed(Vec3::new(-4.0, 4.6, 5.6), Vec3::new(-0.2, 0.65, -0.2), key)?
            .with_color(Rgb::new(1.0, 0.82, 0.6))?
            .with_intensity(95.0)?,
        aimed(Vec3::new(4.4, 3.2, 4.4), Vec3::new(0.1, 1.0, -1.2), fill)?
            .with_color(Rgb::new(0.42, 0.62, 1.0))?
            .with_intensity(26.0)?,
        aimed(Vec3::new(1.5, 4.4, -3.0), Vec3::new(-0.1, 0.4, 0.3), back)?
            .with_color(Rgb::new(0.9, 0.88, 1.0))?
            .with_intensity(75.0)?,
    ])
}

/// Creates a spotlight at a position that points at a target.
fn aimed(
    position: Vec3<f32>,
    target: Vec3<f32>,
    cone: Cone<SoftOrHard>,
) -> Result<SpotLight<SoftOrHard>, Error> {
    SpotLight::new(position, target.zip(position, |t, p| t - p), cone)
}

/// Creates the back wall of the stage (the cyclorama), the ground under the floorboards, and the
/// curtains.
fn house() -> [(Mesh, Material); 4] {
    let (width, depth) = DECK;
    let cyclorama =
        Outline::start(3.4, 5.5).line_to(3.4, 0.8).arc(2.2, 0.8, -FRAC_PI_2, QUARTER).line_to(-4.5, -0.4);
    let cyclorama = Mesh::extrude(&cyclorama, 16.0, 1)
        .turned(Vec3::new(0.0, 1.0, 0.0), FRAC_PI_2)
        .moved(Vec3::new(-8.0, 0.0, 0.0));
    let deck = Mesh::cuboid(width, 0.38, depth).moved(Vec3::new(0.0, -0.39, 0.0));
    let velvet = Material::srgb(122, 32, 38);
    [
        (cyclorama, Material::srgb(176, 172, 168)),
        (deck, Material::srgb(58, 46, 40)),
        (curtain().moved(Vec3::new(-4.6, -0.4, -1.2)), velvet),
        (curtain().moved(Vec3::new(2.8, -0.4, -1.2)), velvet),
    ]
}

/// Creates a board that runs from the back of the deck to the front of the deck.
fn plank(number: usize) -> Mesh {
    let (width, depth) = DECK;
    let left = width * (number as f32 / BOARDS as f32 - 0.5);
    let right = width * ((number + 1) as f32 / BOARDS as f32 - 0.5);
    let top = Outline::start(right, 0.0).line_to(left, 0.0);
    Mesh::extrude(&top, depth, 6).moved(Vec3::new(0.0, 0.0, -depth / 2.0))
}

/// Creates a velvet curtain in folds, 1.8 metres wide.
fn curtain() -> Mesh {
    const FOLDS: usize = 7;
    const LINES: usize = 16 * FOLDS;
    let wave = |line: usize| {
        let along = line as f32 / LINES as f32;
        let fold = glam::Vec2::from_angle(TAU * FOLDS as f32 * along).y;
        (1.8 * along, 0.1 * fold)
    };
    let folds = (1..=LINES).map(wave).fold(Outline::start(0.0, 0.0), |outline, (x, y)| outline.line_to(x, y));
    Mesh::extrude(&folds, 5.8, 1).turned(Vec3::new(1.0, 0.0, 0.0), -FRAC_PI_2)
}

/// Creates the still life.
fn actors() -> [(Mesh, Material); 9] {
    let plinth = |x, z, height, width| Mesh::cuboid(width, height, width).moved(Vec3::new(x, 0.0, z));
    let up = Vec3::new(0.0, 1.0, 0.0);
    let lying = capsule(0.2, 0.75).turned(Vec3::new(0.0, 0.0, 1.0), FRAC_PI_2).turned(up, 0.55);
    let plaster = Material::srgb(206, 200, 190);
    [
        (sphere(0.56).moved(Vec3::new(-0.52, 0.0, 0.3)), Material::srgb(196, 84, 58)),
        (torus(0.4, 0.14).moved(Vec3::new(0.62, 0.0, 1.05)), Material::srgb(214, 160, 62)),
        (cone(0.44, 1.4).moved(Vec3::new(0.42, 0.0, -0.55)), Material::srgb(226, 216, 196)),
        (plinth(1.62, -0.5, 0.72, 0.72).turned(up, 0.0), plaster),
        (vase().moved(Vec3::new(1.62, 0.72, -0.5)), Material::srgb(44, 126, 128)),
        (column().moved(Vec3::new(-1.66, 0.0, -0.7)), plaster),
        (sphere(0.2).moved(Vec3::new(-1.66, 1.56, -0.7)), Material::srgb(206, 168, 92)),
        (lying.moved(Vec3::new(-1.42, 0.2, 1.15)), Material::srgb(96, 74, 128)),
        (sphere(0.16).moved(Vec3::new(1.5, 0.0, 0.75)), Material::srgb(60, 92, 150)),
    ]
}
