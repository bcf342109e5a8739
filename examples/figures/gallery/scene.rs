//! One scene under three models with the same field angle, as in the paper's figures 4, 5 and 6.

use super::{
    picture::{self, Picture},
    warn::Warn,
};
use luminaire::{Angle, Cone, Rgb, SpotLight, Vec3, falloff::SoftOrHard};
use luminaire_render::{Camera, Material, Mesh, Outline, Scene};
use std::{
    error::Error,
    f32::consts::{PI, TAU},
};

/// The field angle of all three models, in degrees, which is that of the paper's figure 7.
pub(crate) const FIELD: f32 = 15.0;

const SIZE: (usize, usize) = (720, 450);
const AMBIENT: Rgb<f32> = Rgb::new(0.010, 0.012, 0.016);

/// The scene under Warn's model, the soft edge and the hard edge, in this order.
pub(crate) fn pictures() -> Result<[Picture; 3], Box<dyn Error>> {
    let mut renderer = picture::renderer(SIZE.0, SIZE.1)?;
    renderer.draw_geometry(&scene()?, &camera());

    let warn = Warn::from_field(Angle::degrees(FIELD));
    let place = spot(SoftOrHard::Soft)?;
    let irradiance = |point, normal| warn.irradiance(&place, point, normal) as f32;
    let warn = Picture::develop(&renderer, picture::lit(&renderer, AMBIENT, irradiance));

    let mut under = |edge| -> Result<Picture, Box<dyn Error>> {
        renderer.draw_light(&[spot(edge)?])?;
        Ok(Picture::develop(&renderer, |x, y| renderer.linear(x, y).unwrap_or_default()))
    };
    Ok([warn, under(SoftOrHard::Soft)?, under(SoftOrHard::Hard)?])
}

/// The spotlight, above on the left. Its irradiance at the target is 1.5 times full scale, because
/// no surface there is white and faces the light.
fn spot(edge: SoftOrHard) -> Result<SpotLight<SoftOrHard>, luminaire::Error> {
    let (position, target) = (Vec3::new(-3.2, 6.4, 4.6), Vec3::new(0.0, 0.2, 0.0));
    let axis = target.zip(position, |t, p| t - p);
    let cone = Cone::from_field(edge, Angle::degrees(FIELD))?;
    SpotLight::new(position, axis, cone)?.with_intensity(1.5 * axis.dot(axis))
}

fn camera() -> Camera {
    Camera::new(Vec3::new(0.1, 0.2, 0.0), 6.0, 0.0, 0.56, 0.46)
}

/// A sphere, a cone and a ring on a floor.
fn scene() -> Result<Scene, luminaire::Error> {
    let floor = Mesh::extrude(&Outline::start(6.0, 0.0).line_to(-6.0, 0.0), 12.0, 1);
    let sphere = Mesh::lathe(&Outline::start(0.0, 0.0).arc(0.0, 0.34, PI, 48), 96);
    let cone = Mesh::lathe(&Outline::start(0.0, 0.0).line_to(0.3, 0.0).line_to(0.0, 0.9), 96);
    let ring = Mesh::lathe(&Outline::start(0.26, 0.0).arc(0.26, 0.09, TAU, 48), 96);
    let mut scene = Scene::new();
    scene.set_ambient(AMBIENT)?;
    scene.add(sphere.moved(Vec3::new(-0.42, 0.0, -0.1)), Material::srgb(204, 92, 62))?;
    scene.add(cone.moved(Vec3::new(0.42, 0.0, -0.3)), Material::srgb(226, 216, 196))?;
    scene.add(ring.moved(Vec3::new(0.14, 0.0, 0.52)), Material::srgb(214, 160, 62))?;
    scene.add(floor.moved(Vec3::new(0.0, 0.0, -6.0)), Material::srgb(196, 178, 156))?;
    Ok(scene)
}
