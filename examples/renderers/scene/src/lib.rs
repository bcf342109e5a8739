//! A ball on a floor under two spotlights, which each renderer draws, and the check of its picture.

mod check;
mod glue;
mod mesh;
mod view;

use luminaire::{
    AmbientLight, Angle, Cone, Error, Material, Rgb, Scalar, SpotLight,
    falloff::Soft,
    light::{CompiledMaterial, CompiledSpotLight},
};

pub use check::{Agreement, Picture, check};
pub use glue::glue;
pub use mesh::{Mesh, ball, floor};
pub use view::{EYE, Object, Site, ray, seen, to_clip};

/// The pixels of a row.
pub const WIDTH: usize = 320;
/// The rows of the picture.
pub const HEIGHT: usize = 240;
/// The centre of the ball.
pub const CENTER: [f32; 3] = [0.0, 1.0, 0.0];
/// The radius of the ball, which lies on the floor.
pub const RADIUS: f32 = 1.0;

/// A warm spotlight from the left and a cool one from the right, both with a soft edge.
///
/// # Errors
/// None: the lights are valid in every format.
pub fn lights<S: Scalar>() -> Result<[CompiledSpotLight<S, Soft>; 2], Error> {
    let cone = Cone::soft(Angle::degrees(46.0))?;
    let warm = SpotLight::new([-2.6, 3.2, 2.6], [2.2, -2.9, -2.2], cone)?.with_intensity(20.0)?;
    let cool = SpotLight::new([2.8, 2.6, -0.6], [-2.5, -2.2, 0.7], cone)?.with_intensity(14.0)?;
    Ok([
        warm.with_color(Rgb::new(1.0, 0.65, 0.3))?.compile()?,
        cool.with_color(Rgb::new(0.3, 0.55, 1.0))?.compile()?,
    ])
}

/// The material of ball and floor: matte and white.
///
/// # Errors
/// None: the material is valid.
pub fn white<S: Scalar>() -> Result<CompiledMaterial<S>, Error> {
    Ok(Material::new(Rgb::new(1.0, 1.0, 1.0))?.compile())
}

/// Ambient light that leaves nothing quite black.
///
/// # Errors
/// None: the light is valid.
pub fn ambient<S: Scalar>() -> Result<Rgb<S::Irradiance>, Error> {
    Ok(AmbientLight::new(Rgb::new(0.7, 0.8, 1.0))?.with_intensity(0.02)?.compile::<S>())
}
