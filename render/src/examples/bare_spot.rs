//! One soft spotlight from the left on a vase, a floor and a wall; all else is dark.

use super::{
    Fixture, Setup,
    room::{aimed, floor, wall},
};
use crate::{Camera, Material, Scene, solids::vase};
use luminaire::{Angle, Cone, Error, Rgb, Soft, Vec3};

pub(super) fn setup() -> Result<Setup, Error> {
    let mut scene = Scene::new();
    scene.add(vase(), Material::srgb(188, 92, 64));
    scene.add(floor(14.0, 10.0), Material::srgb(168, 158, 146));
    scene.add(wall(14.0, 6.0, -1.3), Material::srgb(186, 180, 170));
    let camera = Camera::new(Vec3::new(0.1, 0.72, 0.0), 5.2, 0.0, 0.14, 0.46);
    let cone = Cone::from_field(Soft, Angle::degrees(34.0))?;
    let spot = aimed(Vec3::new(-2.3, 3.0, 2.7), Vec3::new(0.1, 0.5, -0.2), cone)?
        .with_color(Rgb::new(1.0, 0.86, 0.68))?
        .with_intensity(22.0)?;
    Ok(Setup::new(scene, camera, [Fixture::new("Fresnel", spot)].into()))
}
