//! The demo's turntable as JSON: what three.js needs to draw the same picture.

use anyhow::{Result, bail};
use luminaire::dynamic::AnyLight;
use luminaire_render::scenes::{Setup, turntable};
use serde_json::{Value, json};

/// Number of frames that are timed, and of those before them, in which three.js compiles its shaders.
pub(super) const FRAMES: u32 = 25;
const WARM_UP: u32 = 8;

/// Scene time between frames in seconds, and yaw of a turning camera between frames in radians, as
/// in the demo's own measurement.
const STEP: f32 = 1.0 / 30.0;
const TURN: f32 = 0.004;

/// Width and height of the picture in pixels.
const SIZE: [u32; 2] = [960, 540];

/// The turntable under `spots` spotlights, with shadow maps of `shadows` x `shadows` texels, or
/// without any if `shadows` is 0.
pub(super) fn of(spots: usize, shadows: u16) -> Result<Value> {
    let setup = turntable(spots)?;
    let frames =
        (0..WARM_UP + FRAMES).map(|number| frame(&setup, number as f32)).collect::<Result<Vec<_>>>()?;
    let lights = setup.fixtures.iter().map(|fixture| spot(fixture.light())).collect::<Result<Vec<_>>>()?;
    Ok(json!({
        "size": SIZE,
        "fieldOfView": setup.camera.field_of_view(),
        "ambient": <[f32; 3]>::from(setup.scene.ambient()),
        "meshes": meshes(&setup),
        "spots": lights,
        "shadows": shadows,
        "warmUp": WARM_UP,
        "frames": frames,
    }))
}

fn meshes(setup: &Setup) -> Vec<Value> {
    let meshes = setup.scene.meshes().map(|(mesh, material)| {
        let columns = |of: usize| -> Vec<f32> {
            mesh.corners().flatten().flat_map(|corner| <[f32; 3]>::from(corner[of])).collect()
        };
        json!({
            "albedo": <[f32; 3]>::from(material.albedo()),
            "specular": <[f32; 3]>::from(material.specular()),
            "shininess": material.shininess(),
            "positions": columns(0),
            "normals": columns(1),
        })
    });
    meshes.collect()
}

fn spot(light: &AnyLight) -> Result<Value> {
    let AnyLight::Spot(spot) = light else { bail!("the turntable has another light than spotlights") };
    Ok(json!({
        "color": <[f32; 3]>::from(spot.color()),
        "intensity": spot.intensity(),
        "halfAngle": spot.cone().outer().to_radians() / 2.0,
    }))
}

/// The lights and the turning camera of a frame.
fn frame(setup: &Setup, number: f32) -> Result<Value> {
    let mut camera = setup.camera;
    camera.orbit(TURN * number, 0.0);
    let (mut positions, mut axes) = (Vec::new(), Vec::new());
    for fixture in setup.fixtures_at(STEP * number)? {
        let AnyLight::Spot(spot) = fixture.light() else { continue };
        positions.push(<[f32; 3]>::from(spot.position()));
        axes.push(<[f32; 3]>::from(spot.axis()));
    }
    let camera =
        json!({ "eye": <[f32; 3]>::from(camera.eye()), "target": <[f32; 3]>::from(camera.target()) });
    Ok(json!({ "positions": positions, "axes": axes, "camera": camera }))
}
