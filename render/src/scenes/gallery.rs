//! A gallery: pictures on three walls and sculptures between the walls. Two spotlights light each
//! picture and each sculpture, and together these spotlights have every falloff and attenuation.
//! The gallery also has pendants, a follow spot and a skylight. Two of the sculptures have
//! highlights.

mod hall;
mod lights;

use super::{MovingLight, Setup, fixture::Sweep};
use crate::{Camera, Scene};
use alloc::vec::Vec;
use luminaire::{
    DirectionalLight, Error, PointLight, Rgb, Vec3,
    attenuation::{FilamentRange, InverseSquare},
};

pub(super) fn setup() -> Result<Setup, Error> {
    let mut scene = Scene::new();
    scene.set_ambient(Rgb::new(0.02, 0.02, 0.021))?;
    hall::sculptures(&mut scene)?;
    hall::pictures(&mut scene)?;
    hall::room(&mut scene)?;
    let camera = Camera::new(Vec3::new(0.0, 1.5, -1.0), 7.7, 0.0, 0.07, 0.56);
    Ok(Setup::new(scene, camera, fixtures()?))
}

fn fixtures() -> Result<Vec<MovingLight>, Error> {
    let mut fixtures = Vec::new();
    for &(place, side) in &hall::PICTURES {
        for offset in [-0.8, 0.8] {
            let position = side.before_wall(place, offset);
            fixtures.push(lights::track_spot(fixtures.len(), position, side.on_wall(place), 0.42)?);
        }
    }
    for &(x, z) in &hall::SCULPTURES {
        for (dx, dz) in [(-1.5, 1.7), (1.6, 1.2)] {
            let position = Vec3::new(x + dx, 4.2, z + dz);
            fixtures.push(lights::track_spot(fixtures.len(), position, Vec3::new(x, 1.2, z), 0.55)?);
        }
    }
    // The follow spot is the only moving light: it follows a visitor through the hall.
    let follow = lights::follow_spot(Vec3::new(0.0, 5.0, 3.2), Vec3::new(0.0, 0.0, 0.9))?;
    let center = glam::Vec3::new(0.0, 0.0, 0.9);
    fixtures.push(follow.sweeping(Sweep { center, radii: [2.6, 0.0, 0.5], period: 16.0, start: 0.1 }));
    for (x, z) in hall::PENDANTS {
        let pendant = PointLight::new(Vec3::new(x, 2.9, z))?
            .with_color(Rgb::new(1.0, 0.7, 0.4))?
            .with_intensity(0.9)?
            .with_attenuation(FilamentRange::new(InverseSquare, Some(2.8))?);
        fixtures.push(MovingLight::new("pendant", pendant));
    }
    let skylight = DirectionalLight::new(Vec3::new(0.25, -1.0, -0.35))?
        .with_color(Rgb::new(0.62, 0.8, 1.0))?
        .with_intensity(0.07)?;
    fixtures.push(MovingLight::new("skylight", skylight));
    Ok(fixtures)
}
