//! A dark house: moving heads on a truss send coloured beams across a stage.

use super::{
    Fixture, Setup,
    fixture::Sweep,
    room::{aimed, floor, wall},
};
use crate::{
    Camera, Material, Mesh, Scene,
    solids::{column, sphere},
};
use alloc::vec::Vec;
use glam::Vec2;
use luminaire::{Angle, Cone, Edge, Error, Rgb, Vec3};

/// How high the truss hangs, and where, in metres.
const TRUSS: (f32, f32) = (4.6, -1.4);

/// The heads on the truss, from left to right: the colour of the gel.
const GELS: [Rgb<f32>; 8] = [
    Rgb::new(1.0, 0.06, 0.3),
    Rgb::new(0.1, 0.35, 1.0),
    Rgb::new(1.0, 0.45, 0.05),
    Rgb::new(0.05, 0.8, 0.9),
    Rgb::new(0.75, 0.1, 1.0),
    Rgb::new(1.0, 0.7, 0.2),
    Rgb::new(0.1, 0.25, 1.0),
    Rgb::new(1.0, 0.08, 0.5),
];

pub(super) fn setup() -> Result<Setup, Error> {
    let camera = Camera::new(Vec3::new(0.0, 1.75, 0.0), 11.0, 0.0, 0.08, 0.46);
    let mut fixtures = Vec::new();
    for (number, gel) in GELS.into_iter().enumerate() {
        fixtures.push(beam(number, gel)?);
    }
    for side in [-1.0, 1.0] {
        fixtures.push(wash(side)?);
    }
    Ok(Setup::new(scene(), camera, fixtures))
}

fn scene() -> Scene {
    let mut scene = Scene::new();
    let black = Material::srgb(64, 64, 68);
    let cube = |width, height, depth, x, y, z| Mesh::cuboid(width, height, depth).moved(Vec3::new(x, y, z));
    scene.add(sphere(0.6).moved(Vec3::new(0.0, 0.5, 0.0)), Material::srgb(214, 210, 204));
    scene.add(cube(2.4, 0.5, 1.6, 0.0, 0.0, 0.0), black);
    for x in [-2.6, 2.6] {
        scene.add(column().moved(Vec3::new(x, 0.0, -0.4)), Material::srgb(200, 196, 190));
    }
    for bar in [0.0, 0.32] {
        scene.add(cube(11.0, 0.05, 0.05, 0.0, TRUSS.0 + bar, TRUSS.1), black);
    }
    for number in 0..GELS.len() {
        scene.add(cube(0.22, 0.3, 0.22, place(number), TRUSS.0 - 0.32, TRUSS.1), black);
    }
    scene.add(floor(24.0, 16.0), Material::srgb(118, 116, 118));
    scene.add(wall(24.0, 9.0, -3.6), Material::srgb(120, 122, 130));
    scene
}

/// Where on the truss a head hangs.
fn place(number: usize) -> f32 {
    1.25 * (number as f32 - 3.5)
}

/// A moving head with a narrow beam that sweeps over the stage.
fn beam(number: usize, gel: Rgb<f32>) -> Result<Fixture, Error> {
    let edge = if number % 2 == 0 { Edge::Hard } else { Edge::Soft };
    let cone = Cone::from_field(edge, Angle::degrees(13.0))?;
    let x = place(number);
    let center = glam::Vec3::new(-0.55 * x, 0.0, 1.2);
    let spot = aimed(Vec3::new(x, TRUSS.0 - 0.34, TRUSS.1), center.into(), cone)?
        .with_color(gel)?
        .with_intensity(34.0)?;
    let sweep =
        Sweep { center, radii: Vec2::new(1.6, 0.9), period: 9.0, start: number as f32 / GELS.len() as f32 };
    Ok(Fixture::new("moving head (beam)", spot).sweeping(sweep))
}

/// A moving head at the front of the house that throws a pattern on the wall at the back.
fn wash(side: f32) -> Result<Fixture, Error> {
    let cone = Cone::from_field(Edge::Hard, Angle::degrees(24.0))?;
    let center = glam::Vec3::new(-1.9 * side, 2.6, -3.6);
    let spot = aimed(Vec3::new(4.6 * side, 3.4, 4.6), center.into(), cone)?
        .with_color(Rgb::new(0.4, 0.5, 1.0))?
        .with_intensity(46.0)?;
    let sweep = Sweep { center, radii: Vec2::new(0.7, 0.0), period: 14.0, start: 0.25 * (1.0 - side) };
    Ok(Fixture::new("moving head (profile)", spot).sweeping(sweep))
}
