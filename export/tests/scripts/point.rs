#[allow(unused_imports, reason = "not every light names a type of each module")]
use luminaire::{attenuation::*, codegen::*, falloff::*, light::*, *};

// The light point, written by luminaire-export 0.1.0.
// Lengths have the unit of the scene; light is linear, and 1 is full scale.
//
// With this build.rs, and luminaire among the build-dependencies, the constant in the program is
// const POINT: luminaire::light::CompiledPointLight<Fx16, SmoothRange> =
//     include!(concat!(env!("OUT_DIR"), "/point.rs"));
pub fn point() -> Result<PointLight<SmoothRange>, Error> {
    PointLight::new([1.0, 2.0, 3.0])?
        .with_attenuation(SmoothRange::new(5.0)?)
        .with_color(Rgb::new(1.0, 1.0, 1.0))?
        .with_intensity(1.0)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    std::fs::write(
        std::path::Path::new(&std::env::var("OUT_DIR")?).join("point.rs"),
        luminaire::codegen::as_source(&point()?.compile::<Fx16>()?).to_string(),
    )?;
    Ok(())
}
