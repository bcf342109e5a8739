#[allow(unused_imports, reason = "not every light names a type of each module")]
use luminaire::{attenuation::*, codegen::*, falloff::*, light::*, *};

// The light cubic, written by luminaire-export 0.1.0.
// A spotlight: falloff cubic, full angles in degrees: beam 18.61, field 37.93, outer 40.00.
// Lengths have the unit of the scene; light is linear, and 1 is full scale.
//
// With this build.rs, and luminaire among the build-dependencies, the constant in the program is
// const CUBIC: luminaire::light::CompiledSpotLight<Fx16, Cubic, FilamentRange> =
//     include!(concat!(env!("OUT_DIR"), "/cubic.rs"));
pub fn cubic() -> Result<SpotLight<Cubic, FilamentRange>, Error> {
    let cone = Cone::from_outer(Cubic::from_bits([1067450368, 1080033280]), Angle::degrees(40.0))?.with_inner(Angle::degrees(7.0))?;
    SpotLight::new([1.0, 2.0, 3.0], [0.0, -0.8944272, 0.4472136], cone)?
        .with_attenuation(FilamentRange::new(InverseSquare, Some(9.0))?)
        .with_color(Rgb::new(1.0, 0.5, 0.25))?
        .with_intensity(16.0)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    std::fs::write(
        std::path::Path::new(&std::env::var("OUT_DIR")?).join("cubic.rs"),
        luminaire::codegen::as_source(&cubic()?.compile::<Fx16>()?).to_string(),
    )?;
    Ok(())
}
