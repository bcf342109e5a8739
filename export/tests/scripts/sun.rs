// The light sun, written by luminaire-export 0.1.0.
// Lengths have the unit of the scene; light is linear, and 1 is full scale.

// build.rs, with luminaire among the build-dependencies. The constant in the program is
// const SUN: luminaire::light::CompiledDirectionalLight<Fx16> =
//     include!(concat!(env!("OUT_DIR"), "/sun.rs"));

#[allow(unused_imports, reason = "not every light names a type of each module")]
use luminaire::{attenuation::*, codegen::*, falloff::*, *};

pub fn sun() -> Result<DirectionalLight, Error> {
    DirectionalLight::new([0.0, -0.8944272, 0.4472136])?
        .with_color(Rgb::new(1.0, 1.0, 1.0))?
        .with_specular_color(Rgb::new(0.5, 0.5, 1.0))?
        .with_intensity(1.0)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let light = sun()?.compile::<Fx16>();
    let file = std::path::Path::new(&std::env::var("OUT_DIR")?).join("sun.rs");
    Ok(std::fs::write(file, as_source(&light).to_string())?)
}
