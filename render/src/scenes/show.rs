//! A dark theatre: moving heads on a truss send coloured beams across a stage. Two other moving
//! heads project patterns on the wall behind the stage.

use super::{
    MovingLight, Setup,
    fixture::Sweep,
    room::{aimed, floor, wall},
};
use crate::{
    Camera, Material, Mesh, Scene,
    scenes::{
        gobos,
        solids::{column, sphere},
    },
};
use alloc::vec::Vec;
use luminaire::{
    Angle, Cone, Error, Rgb, Vec3,
    falloff::{Soft, SoftOrHard},
    haze::Haze,
    projector::Gobo,
};

/// The height and the z coordinate of the truss, in metres.
const TRUSS: (f32, f32) = (4.3, -1.6);

/// The colours of the moving heads on the truss, from left to right.
const GELS: [Rgb<f32>; 8] = [
    Rgb::new(1.0, 0.05, 0.25),
    Rgb::new(0.08, 0.3, 1.0),
    Rgb::new(1.0, 0.42, 0.05),
    Rgb::new(0.05, 0.75, 0.9),
    Rgb::new(0.7, 0.1, 1.0),
    Rgb::new(1.0, 0.62, 0.15),
    Rgb::new(0.08, 0.22, 1.0),
    Rgb::new(1.0, 0.06, 0.45),
];

/// The patterns on the wall: `BREAKUP` of the left moving head, `STAR` of the right moving head. A
/// texel of 64 covers about three pixels of the demo, which the straight edges of a star would show.
const BREAKUP: [u8; 64 * 64] = gobos::breakup();
const STAR: [u8; 128 * 128] = gobos::star();

pub(super) fn setup() -> Result<Setup, Error> {
    let camera = Camera::new(Vec3::new(0.0, 1.75, 0.0), 11.4, 0.0, 0.2, 0.5);
    let mut fixtures = Vec::new();
    for (number, gel) in GELS.into_iter().enumerate() {
        fixtures.push(beam(number, gel)?);
    }
    fixtures.push(pattern(-1.0, Rgb::new(0.3, 0.45, 1.0), Gobo::of(&BREAKUP))?);
    fixtures.push(pattern(1.0, Rgb::new(1.0, 0.35, 0.5), Gobo::of(&STAR))?);
    let wash = aimed(
        Vec3::new(-3.4, 3.6, 5.2),
        Vec3::new(0.0, 0.9, 0.0),
        Cone::from_field(Soft, Angle::degrees(36.0))?,
    )?
    .with_color(Rgb::new(0.5, 0.28, 1.0))?
    .with_intensity(12.0)?;
    fixtures.push(MovingLight::new("moving head (wash)", wash));
    let mut scene = scene()?;
    scene.set_haze(Some(Haze::new(0.05)?));
    Ok(Setup::new(scene, camera, fixtures))
}

fn scene() -> Result<Scene, Error> {
    let mut scene = Scene::new();
    let black = Material::srgb(74, 74, 80);
    let cube = |width, height, depth, x, y, z| Mesh::cuboid(width, height, depth).moved(Vec3::new(x, y, z));
    scene.add(sphere(0.6).moved(Vec3::new(0.0, 0.4, 0.0)), Material::srgb(224, 220, 214))?;
    scene.add(cube(2.6, 0.4, 1.8, 0.0, 0.0, 0.0), black)?;
    for x in [-2.5, 2.5] {
        scene.add(column().moved(Vec3::new(x, 0.0, 0.2)), Material::srgb(214, 210, 204))?;
    }
    for bar in [0.0, 0.3] {
        scene.add(cube(11.0, 0.05, 0.05, 0.0, TRUSS.0 + bar, TRUSS.1), black)?;
    }
    for number in 0..GELS.len() {
        scene.add(cube(0.22, 0.3, 0.22, place(number), TRUSS.0 - 0.32, TRUSS.1), black)?;
    }
    scene.add(floor(24.0, 20.0), Material::srgb(150, 148, 150))?;
    scene.add(wall(24.0, 9.0, -3.6), Material::srgb(150, 152, 160))?;
    Ok(scene)
}

/// Returns the x coordinate of a moving head on the truss, in metres.
fn place(number: usize) -> f32 {
    1.2 * (number as f32 - 3.5)
}

/// Creates a moving head with a narrow beam that sweeps over the stage. Hard and soft edges
/// alternate along the truss.
fn beam(number: usize, gel: Rgb<f32>) -> Result<MovingLight, Error> {
    let edge = if number % 2 == 0 { SoftOrHard::Hard } else { SoftOrHard::Soft };
    let cone = Cone::from_field(edge, Angle::degrees(14.0))?;
    let x = place(number);
    let center = glam::Vec3::new(-0.4 * x, 0.0, 1.0);
    let spot = aimed(Vec3::new(x, TRUSS.0 - 0.34, TRUSS.1), center.into(), cone)?
        .with_color(gel)?
        .with_intensity(60.0)?;
    let start = number as f32 / GELS.len() as f32;
    let sweep = Sweep { center, radii: [1.7, 0.0, 1.1], period: 9.0, start };
    Ok(MovingLight::new("moving head (beam)", spot).sweeping(sweep))
}

/// Creates a moving head at the front of the theatre that projects a rotating pattern on the back
/// wall.
fn pattern(side: f32, gel: Rgb<f32>, gobo: Gobo<'static>) -> Result<MovingLight, Error> {
    let cone = Cone::from_field(SoftOrHard::Hard, Angle::degrees(21.0))?;
    let center = glam::Vec3::new(2.3 * side, 2.3, -3.6);
    let spot =
        aimed(Vec3::new(4.2 * side, 3.4, 4.6), center.into(), cone)?.with_color(gel)?.with_intensity(64.0)?;
    let sweep = Sweep { center, radii: [0.5, 0.0, 0.0], period: 14.0, start: 0.25 * side };
    Ok(MovingLight::new("moving head (profile)", spot).with_gobo(gobo, 12.0 * side).sweeping(sweep))
}
