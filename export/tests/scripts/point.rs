// The light point, written by luminaire-export 0.1.0.
// Lengths have the unit of the scene; light is linear, and 1 is full scale.

// build.rs, with luminaire among the build-dependencies. The constant in the program is
// const POINT: luminaire::light::CompiledPointLight<Fx16, SmoothRange> =
//     include!(concat!(env!("OUT_DIR"), "/point.rs"));

#[allow(unused_imports, reason = "not every light names a type of each module")]
use luminaire::{attenuation::*, codegen::*, falloff::*, *};

pub fn point() -> Result<PointLight<SmoothRange>, Error> {
    PointLight::new([1.0, 2.0, 3.0])?
        .with_attenuation(SmoothRange::new(5.0)?)
        .with_color(Rgb::new(1.0, 1.0, 1.0))?
        .with_intensity(1.0)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let light = point()?.compile::<Fx16>()?;
    let file = std::path::Path::new(&std::env::var("OUT_DIR")?).join("point.rs");
    Ok(std::fs::write(file, as_source(&light).to_string())?)
}
