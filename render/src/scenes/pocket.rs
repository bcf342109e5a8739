//! A still life of a few triangles for a display of 160 x 120 pixels.

use super::{
    MovingLight, Setup,
    room::{aimed, floor, wall},
};
use crate::{Camera, Material, Mesh, Outline, Scene};
use core::f32::consts::PI;
use luminaire::{Angle, Cone, Error, Rgb, Vec3, falloff::Soft};

pub(super) fn setup() -> Result<Setup, Error> {
    let mut scene = Scene::new();
    let ball = Mesh::lathe(&Outline::start(0.0, 0.0).arc(0.0, 0.42, PI, 8), 14);
    scene.add(ball.moved(Vec3::new(0.34, 0.0, 0.28)), Material::srgb(208, 92, 60))?;
    let cube = Mesh::cuboid(0.62, 0.62, 0.62).turned(Vec3::new(0.0, 1.0, 0.0), 0.5);
    scene.add(cube.moved(Vec3::new(-0.5, 0.0, -0.2)), Material::srgb(92, 132, 180))?;
    scene.add(floor(8.0, 8.0), Material::srgb(176, 168, 154))?;
    scene.add(wall(8.0, 5.0, -1.0), Material::srgb(84, 88, 100))?;
    let camera = Camera::new(Vec3::new(0.0, 0.46, 0.0), 3.3, 0.1, 0.26, 0.52);
    let cone = Cone::from_field(Soft, Angle::degrees(42.0))?;
    let spot = aimed(Vec3::new(-1.9, 3.0, 2.2), Vec3::new(0.0, 0.3, -0.1), cone)?
        .with_color(Rgb::new(1.0, 0.9, 0.76))?
        .with_intensity(48.0)?;
    Ok(Setup::new(scene, camera, [MovingLight::new("downlight", spot)].into()))
}
