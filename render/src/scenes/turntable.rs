//! Four solids on a floor in front of a wall, under moving spotlights. All surfaces have
//! highlights.

use super::{
    MovingLight, Setup,
    fixture::Sweep,
    room::{aimed, floor, wall},
};
use crate::{
    Camera, Material, Mesh, Scene,
    scenes::solids::{capsule, sphere, torus, vase},
};
use alloc::vec::Vec;
use core::f32::consts::{FRAC_PI_2, TAU};
use glam::{Vec2, Vec3};
use luminaire::{Angle, Cone, Error, HalfAngle, Rgb, falloff::Soft};

/// Angle in radians between consecutive spotlights around the centre: the golden angle, which
/// spreads any number of spotlights evenly.
const GOLDEN_ANGLE: f32 = 2.399_963;

/// Sum of the intensities of all spotlights, for any number of spotlights.
const INTENSITY: f32 = 260.0;

/// Builds the scene of [`Example::Turntable`](super::Example::Turntable) under `spots` spotlights,
/// at least 1.
///
/// Each spotlight has a half angle of 15 degrees. The sum of the intensities is the same for every
/// number of spotlights. The camera swings from side to side.
///
/// # Errors
/// Never: the values are constants.
pub fn turntable(spots: usize) -> Result<Setup, Error> {
    let count = spots.max(1);
    let camera = Camera::new(luminaire::Vec3::new(0.0, 0.62, 0.0), 6.2, 0.0, 0.24, 0.44);
    let fixtures = (0..count).map(|number| fixture(number, count)).collect::<Result<Vec<_>, _>>()?;
    Ok(Setup { swing: 0.5, ..Setup::new(scene()?, camera, fixtures) })
}

fn scene() -> Result<Scene, Error> {
    let gloss = |red, green, blue, strength, shininess| {
        Material::srgb(red, green, blue)
            .with_highlight(Rgb::new(1.0, 1.0, 1.0).map(|c: f32| c * strength), shininess)
    };
    let up = luminaire::Vec3::new(0.0, 1.0, 0.0);
    let lying = capsule(0.24, 0.7).turned(luminaire::Vec3::new(0.0, 0.0, 1.0), FRAC_PI_2).turned(up, 0.5);
    let mut scene = Scene::new();
    scene.set_ambient(Rgb::new(0.02, 0.021, 0.026))?;
    let mut place =
        |mesh: Mesh, x, y, z, material| scene.add(mesh.moved(luminaire::Vec3::new(x, y, z)), material);
    place(sphere(0.52), -0.75, 0.0, 0.1, gloss(178, 60, 48, 0.5, 96)?)?;
    place(torus(0.42, 0.15), 0.62, 0.0, 0.78, gloss(206, 152, 60, 0.45, 48)?)?;
    place(vase(), 0.42, 0.0, -0.5, gloss(44, 122, 128, 0.5, 128)?)?;
    place(lying, -0.7, 0.24, 1.05, gloss(92, 82, 152, 0.4, 64)?)?;
    place(floor(14.0, 12.0), 0.0, 0.0, 0.0, gloss(122, 118, 114, 0.12, 40)?)?;
    place(wall(14.0, 6.0, -1.9), 0.0, 0.0, 0.0, gloss(168, 172, 182, 0.05, 16)?)?;
    Ok(scene)
}

/// Creates a spotlight on a ring above the scene. The spotlight points at a target that moves along
/// an ellipse, a different ellipse for each spotlight.
fn fixture(number: usize, count: usize) -> Result<MovingLight, Error> {
    let part = (number as f32 + 0.5) / count as f32;
    let around = Vec2::from_angle(GOLDEN_ANGLE * number as f32);
    // The ellipses lie in front of the wall, and more ellipses are near the camera than near the
    // wall.
    let position = Vec3::new(3.4 * around.x, 3.5 + 0.8 * part, 1.9 + 2.3 * around.y);
    let center = (0.4 + 1.5 * part) * Vec2::from_angle(GOLDEN_ANGLE * (number + 2) as f32);
    let center = Vec3::new(center.x, 0.4, -0.3 + center.y);
    let cone = Cone::from_outer(Soft, Angle::from(HalfAngle::degrees(15.0)))?;
    let spot = aimed(position.into(), center.into(), cone)?
        .with_color(gel(number))?
        .with_intensity(INTENSITY / count as f32)?;
    let sweep = Sweep { center, radii: [0.9, 0.0, 0.5], period: 5.0 + 4.0 * part, start: part };
    Ok(MovingLight::new("moving head", spot).sweeping(sweep))
}

/// Returns the colour of a spotlight: pale, and different from the colours of neighbouring
/// spotlights.
fn gel(number: usize) -> Rgb<f32> {
    let hue = Vec2::from_angle(TAU * 0.38 * number as f32);
    Rgb::new(0.72 + 0.28 * hue.x, 0.7 + 0.18 * hue.y, 0.72 - 0.28 * hue.x)
}
