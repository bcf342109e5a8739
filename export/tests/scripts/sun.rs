#[allow(unused_imports, reason = "not every light names a type of each module")]
use luminaire::{attenuation::*, codegen::*, falloff::*, light::*, *};

// The light sun, written by luminaire-export 0.1.0.
// Lengths have the unit of the scene; light is linear, and 1 is full scale.
//
// With this build.rs, and luminaire among the build-dependencies, the constant in the program is
// const SUN: luminaire::light::CompiledDirectionalLight<Fx16> =
//     include!(concat!(env!("OUT_DIR"), "/sun.rs"));
pub fn sun() -> Result<DirectionalLight, Error> {
    DirectionalLight::new([0.0, -0.8944272, 0.4472136])?
        .with_color(Rgb::new(1.0, 1.0, 1.0))?
        .with_specular_color(Rgb::new(0.5, 0.5, 1.0))?
        .with_intensity(1.0)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    std::fs::write(
        std::path::Path::new(&std::env::var("OUT_DIR")?).join("sun.rs"),
        luminaire::codegen::as_source(&sun()?.compile::<Fx16>()).to_string(),
    )?;
    Ok(())
}
