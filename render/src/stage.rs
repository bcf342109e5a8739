//! A stage.
use crate::*;
use luminaire::*;
/// scene
pub fn scene() -> Scene {
    let mut s = Scene::new();
    s.set_ambient(Rgb::new(0.02, 0.02, 0.025));
    s.add(Mesh::cuboid(8.0, 0.1, 8.0).moved(Vec3::new(0.0, -0.1, 0.0)), Material::srgb(180, 160, 140));
    let ball = Outline::start(0.0, 0.0).arc(0.0, 0.5, core::f32::consts::PI, 32);
    s.add(Mesh::lathe(&ball, 64), Material::srgb(200, 80, 60));
    s
}
/// camera
pub fn camera() -> Camera {
    Camera::new(Vec3::new(0.0, 0.8, 0.0), 7.0, 0.0, 0.2, 0.6)
}
/// lights
pub fn lights() -> Result<[Spot; 3], Error> {
    let key = Cone::from_field(Edge::Hard, Angle::degrees(26.0))?;
    let spot = Spot::new(Vec3::new(-3.0, 4.0, 4.0), Vec3::new(3.0, -3.6, -4.0), key)?.with_intensity(40.0)?;
    Ok([spot; 3])
}
