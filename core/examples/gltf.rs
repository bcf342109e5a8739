//! A spotlight of glTF's `KHR_lights_punctual`, and what the import changes.

use luminaire::{Vec3, import::Gltf};

fn main() -> Result<(), luminaire::Error> {
    // "type": "spot", "intensity": 40, "range": 12,
    // "spot": { "innerConeAngle": 0.2, "outerConeAngle": 0.4 }: half angles in radians, candela.
    let spot = Gltf { inner_cone_angle: 0.2, outer_cone_angle: 0.4, range: Some(12.0), intensity: 40.0 };
    // A node's light shines along its local -z.
    let imported = spot.import(Vec3::new(0.0, 3.0, 0.0), Vec3::new(0.0, -1.0, 0.0))?;
    println!("largest difference from the original: {:?}", imported.difference);

    let light = imported.light.compile::<f32>()?;
    for x in [0.0, 0.5, 1.0, 1.5] {
        println!(
            "{x} m off the axis: {:.3}",
            light.irradiance(Vec3::new(x, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0))
        );
    }
    Ok(())
}
