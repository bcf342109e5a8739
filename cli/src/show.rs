//! The lights of the example scene `show`.

use luminaire::dynamic::AnyLight;
use luminaire_pick::{Light, Refusal, Scene};
use luminaire_render::scenes::Example;

/// The distance of the nearest surface from a moving head on the truss, in metres. The nearest
/// surfaces are the columns, 1.6 high and 1.7 in front of the truss; the moving heads are at a
/// height of 4.
const FROM_TRUSS: f32 = 2.9;
/// The distance of the nearest surface, a column, from a moving head at the front of the theatre.
const FROM_FRONT: f32 = 4.5;
/// The distance of the farthest surface, in metres.
const FARTHEST: f32 = 14.0;

/// Returns the lights of the show at second 0.
pub(crate) fn lights() -> Result<Scene, Refusal> {
    let setup = Example::Show.setup()?;
    let fixtures = setup.fixtures_at(0.0)?;
    let names = setup.fixtures.iter().map(|fixture| fixture.name);
    let lights = fixtures.iter().zip(names).map(|(fixture, name)| light(name, fixture.light()));
    Ok(Scene { lights: lights.collect() })
}

fn light(name: &str, light: &AnyLight) -> Light {
    let is_on_truss = matches!(light, AnyLight::Spot(spot) if spot.position().z < 0.0);
    Light { near: if is_on_truss { FROM_TRUSS } else { FROM_FRONT }, far: FARTHEST, ..Light::of(name, light) }
}
