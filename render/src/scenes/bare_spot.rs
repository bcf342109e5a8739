//! One soft spotlight from the left on a vase, a floor and a wall. There is no other light.

use super::{
    MovingLight, Setup,
    room::{aimed, floor, wall},
};
use crate::{Camera, Material, Scene, scenes::solids::vase};
use luminaire::{Angle, Cone, Error, Rgb, Vec3, falloff::Soft};

pub(super) fn setup() -> Result<Setup, Error> {
    let mut scene = Scene::new();
    scene.add(vase(), Material::srgb(150, 66, 46))?;
    scene.add(floor(14.0, 10.0), Material::srgb(176, 160, 142))?;
    scene.add(wall(14.0, 6.0, -1.0), Material::srgb(214, 208, 198))?;
    let camera = Camera::new(Vec3::new(0.12, 0.66, 0.0), 4.3, 0.0, 0.16, 0.48);
    let cone = Cone::from_field(Soft, Angle::degrees(34.0))?;
    let spot = aimed(Vec3::new(-1.9, 2.7, 3.1), Vec3::new(0.1, 0.6, -0.4), cone)?
        .with_color(Rgb::new(1.0, 0.86, 0.68))?
        .with_intensity(30.0)?;
    Ok(Setup::new(scene, camera, [MovingLight::new("Fresnel", spot)].into()))
}
