//! A tree of LEDs under four coloured spotlights that go up and down.

use super::{MovingLight, Setup, fixture::Sweep, room::floor, solids::cone};
use crate::{Camera, Material, Mesh, Scene, Strip};
use alloc::vec::Vec;
use core::f32::consts::TAU;
use glam::{Vec2, Vec3};
use luminaire::{Cone, Error, HalfAngle, Rgb, SpotLight, attenuation::NoAttenuation, falloff::Soft};

const LEDS: usize = 500;
/// The limit of the current in milliamperes.
pub const LIMIT: u32 = 8_000;
/// The height of the tree and the radius of its foot, in metres.
pub const HEIGHT: f32 = 2.0;
const RADIUS: f32 = 0.6;
/// The radius of an LED in metres.
const LED: f32 = 0.019;

/// The colours of the spotlights.
const COLORS: [Rgb<f32>; 4] =
    [Rgb::new(1.0, 0.1, 0.0), Rgb::new(0.0, 0.3, 1.0), Rgb::new(1.0, 0.6, 0.1), Rgb::new(0.5, 0.0, 1.0)];

/// Builds the scene of [`Example::Tree`](super::Example::Tree): 500 LEDs on a spiral around a cone.
pub(super) fn setup() -> Result<Setup, Error> {
    // Inside the spiral, so that the LEDs behind it are hidden.
    let trunk = cone(0.93 * RADIUS, 0.96 * HEIGHT);
    build(Strip::new((0..LEDS).map(place), LIMIT), Some(trunk))
}

/// Builds the scene of [`Example::Tree`](super::Example::Tree) with other LEDs, and without what they hang on. The
/// spotlights light LEDs that stand on the floor, in the middle, and are [`HEIGHT`] high.
///
/// # Errors
/// A place that no mesh can have.
pub fn with_leds(strip: Strip) -> Result<Setup, Error> {
    build(strip, None)
}

fn build(strip: Strip, trunk: Option<Mesh>) -> Result<Setup, Error> {
    let mut scene = Scene::new();
    scene.add(floor(40.0, 40.0), Material::srgb(128, 128, 136))?;
    if let Some(trunk) = trunk {
        scene.add(trunk, Material::srgb(40, 66, 52))?;
    }
    scene.add_strip(strip, LED)?;
    scene.set_ambient(Rgb::new(0.02, 0.022, 0.03))?;
    let camera = Camera::new(luminaire::Vec3::new(0.0, 0.9, 0.0), 5.4, 0.0, 0.12, 0.46);
    let fixtures = COLORS.iter().enumerate().map(|(number, color)| spot(number, *color));
    Ok(Setup::new(scene, camera, fixtures.collect::<Result<Vec<_>, _>>()?))
}

/// Returns the position of an LED in metres: on a spiral of 20 turns around a cone.
fn place(led: usize) -> luminaire::Vec3<f32> {
    let part = led as f32 / LEDS as f32;
    let around = RADIUS * (1.0 - part) * Vec2::from_angle(20.0 * TAU * part);
    luminaire::Vec3::new(around.x, HEIGHT * part, around.y)
}

/// Creates a spotlight that is as bright at every distance.
fn spot(number: usize, color: Rgb<f32>) -> Result<MovingLight, Error> {
    let start = number as f32 / COLORS.len() as f32;
    let around: Vec2 = 3.0 * Vec2::from_angle(TAU * (start + 0.125));
    let position = Vec3::new(around.x, 1.0, around.y);
    // The axis always meets the tree, as the page tells where it does.
    let center = Vec3::new(0.0, 0.85, 0.0);
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(10.0))?;
    let spot =
        SpotLight::new(luminaire::Vec3::from(position), luminaire::Vec3::from(center - position), cone)?;
    let spot = spot.with_attenuation(NoAttenuation).with_color(color)?;
    let sweep = Sweep { center, radii: [0.05, 0.65, 0.05], period: 8.0 + number as f32, start };
    Ok(MovingLight::new("moving head", spot).sweeping(sweep))
}
