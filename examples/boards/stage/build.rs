//! Compiles the light of the stage, and for each material its pixels by the irradiance.

#[path = "src/measures.rs"]
#[allow(dead_code, reason = "the shapes are the program's part")]
mod measures;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

use luminaire::{
    Angle, Cone, Fx16, Rgb, SpotLight,
    codegen::{Source, as_source},
    display::Rgb565Ramp,
    falloff::Soft,
};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src/measures.rs");
    let cone = Cone::from_field(Soft, Angle::degrees(measures::FIELD))?;
    let key = SpotLight::new(measures::LIGHT, measures::AXIS, cone)?.with_intensity(measures::INTENSITY)?;
    write("key.rs", &key.compile_quick::<Fx16>()?)?;
    let [color, ambient] = [measures::COLOR, measures::AMBIENT].map(Rgb::from);
    let mut text = String::from("[");
    for diffuse in measures::MATERIALS.map(Rgb::from) {
        let [base, reflected] = [ambient, color].map(|light| light.zip(diffuse, |a, b| a * b));
        text += &format!("{},", as_source(&Rgb565Ramp::new(base, reflected)?));
    }
    Ok(fs::write(out("ramps.rs")?, text + "]")?)
}

fn write(name: &str, value: &impl Source) -> Result<(), Box<dyn Error>> {
    Ok(fs::write(out(name)?, as_source(value).to_string())?)
}

fn out(name: &str) -> Result<PathBuf, Box<dyn Error>> {
    Ok(Path::new(&env::var("OUT_DIR")?).join(name))
}
