//! The spotlight of embedded-3dgfx and the kernel's, with the same soft edge, as functions of a point.
//!
//! `cargo xtask renderers` prints their errors against f64 and the instructions that they take.
#![cfg_attr(target_os = "none", no_std)]

use embedded_3dgfx::pipeline::shade::lights::SpotLight;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor as _};
use luminaire::{
    Cone, Error, Fx16, HalfAngle, Length, Rgb, Scalar, Vec3,
    display::{self, clip},
    falloff::Soft,
    light::CompiledSpotLight,
};
use luminaire_kernels::scene::{AXIS, POSITION};
use nalgebra::{Point3, Vector3};

/// A range in which the attenuation of embedded-3dgfx, `1 - d^2 / range^2`, is 1 in f32.
const FAR: f32 = 1e6;

/// Returns the spotlight of embedded-3dgfx with an outer half angle in degrees. With an inner angle of
/// 0 its falloff is the square of `(cos - cos outer) / (1 - cos outer)`: the soft edge.
pub fn theirs(half_degrees: f32) -> SpotLight {
    let [position, axis] = [POSITION, AXIS].map(<[f32; 3]>::from);
    SpotLight::new(
        Point3::from(position),
        Vector3::from(axis),
        Rgb565::WHITE,
        FAR,
        0.0,
        half_degrees.to_radians(),
    )
}

/// Returns the cone of both spotlights.
///
/// # Errors
/// A half angle outside of 0 to 90 degrees.
pub fn cone(half_degrees: f32) -> Result<Cone<Soft>, Error> {
    Cone::from_outer(Soft, HalfAngle::degrees(half_degrees))
}

/// Returns the kernel's spotlight in the same place, with the same cone.
///
/// # Errors
/// A half angle that the format refuses.
pub fn ours<S: Scalar>(half_degrees: f32) -> Result<CompiledSpotLight<S, Soft>, Error> {
    luminaire::SpotLight::new(POSITION, AXIS, cone(half_degrees)?)?.with_intensity(BRIGHT)?.compile()
}

/// The intensity, which lights a surface at distance 4 to full scale.
const BRIGHT: f32 = 16.0;

/// The cone's factor as a linear pixel, rounded to nearest, in 16-bit integers.
#[inline]
pub fn cone16(light: &CompiledSpotLight<Fx16, Soft>, point: Vec3<Length>) -> Rgb565 {
    let bits = i32::from(light.falloff_at(point).to_bits());
    let part = |most: i32| ((bits * most + (1 << 13)) >> 14) as u8;
    Rgb565::new(part(31), part(63), part(31))
}

/// The cone's factor as a linear pixel, rounded to nearest, in f32.
#[inline]
pub fn cone32(light: &CompiledSpotLight<f32, Soft>, point: Vec3<f32>) -> Rgb565 {
    let falloff = light.falloff_at(point);
    let part = |most: f32| (falloff * most + 0.5) as u8;
    Rgb565::new(part(31.0), part(63.0), part(31.0))
}

/// The pixel that a display shows: the cone, Lambert's cosine, the inverse square, the light's colour and
/// sRGB.
#[inline]
pub fn pixel<S: Scalar>(
    light: &CompiledSpotLight<S, Soft>,
    point: Vec3<S::Length>,
    normal: Vec3<S>,
) -> Rgb565 {
    let light = Rgb::lit::<S>(light.irradiance(point, normal), light.color());
    display::Rgb565::from_linear(clip::<S>(light)).into()
}
